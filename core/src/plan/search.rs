//! The search for plan skeletons.

use super::config::Config;
use super::guide::{Advice, Guide};
use super::heuristic::{Estimate, Estimator, HeuristicMemory};
use super::metrics::Metrics;
use super::open::{OpenList, Waiting};
use super::skeleton::{MAX_SKELETON, Skeleton};
use super::task::AbstractTask;
use crate::error::Error;
use crate::table::Table;
use crate::task::AtomSet;
use heapless::Vec;
use rand_core::Rng;

/// A sequence of operators: that of another node, and one more.
#[derive(Clone, Copy, Debug, Default)]
pub struct SearchNode<const N: usize = 2> {
    /// What holds after the sequence.
    state: AtomSet<N>,
    /// The node it extends.
    parent: u32,
    /// The place of its last operator among those of the task.
    operator: u16,
    /// Its length; the root, alone, has none.
    length: u16,
}

/// The memory of a [`Search`]. It bounds the search: lend less for a smaller budget.
#[derive(Debug)]
pub struct SearchMemory<'m, const N: usize = 2> {
    /// For the heuristic.
    pub heuristic: HeuristicMemory<'m, N>,
    /// One for each sequence of operators that is created.
    pub nodes: &'m mut [SearchNode<N>],
    /// One for each sequence that waits; as many as there are nodes always suffice.
    pub open: &'m mut [Waiting],
}

/// A* over sequences of operators.
///
/// The sequences are a tree: two that lead to the same abstract state are two plan
/// skeletons, of which perhaps only one can be refined. Priority is what the operators
/// cost so far (their number, unless a PDDL text says otherwise) and the estimate; ties are
/// broken by lot.
///
/// If there was advice and patience ends, the search begins anew without it, as if
/// there had been none.
#[derive(Debug)]
pub struct Search<'m, T, const N: usize = 2> {
    task: AbstractTask<'m, N>,
    estimator: Estimator<'m, N>,
    nodes: Table<'m, SearchNode<N>>,
    open: OpenList<'m>,
    lots: T,
    /// The lots as they were in the beginning.
    all_lots: T,
    /// The sequence at hand, as the places of its operators.
    path: Vec<u16, MAX_SKELETON>,
    config: Config,
}

impl<'m, T: Rng + Clone, const N: usize> Search<'m, T, N> {
    /// A search that begins with the empty sequence. `lots` breaks ties, by one
    /// draw for each node.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] if there is no room for the task or the first
    /// node.
    pub fn new(
        task: AbstractTask<'m, N>,
        config: &Config,
        lots: T,
        memory: SearchMemory<'m, N>,
        metrics: &mut Metrics<'_>,
    ) -> Result<Self, Error> {
        let mut search = Search {
            task,
            estimator: Estimator::new(config.heuristic, task, memory.heuristic)?,
            nodes: Table::new(memory.nodes, "nodes of the search"),
            open: OpenList::new(memory.open),
            all_lots: lots.clone(),
            lots,
            path: Vec::new(),
            config: *config,
        };
        search.begin(metrics)?;
        Ok(search)
    }

    /// Begins with the empty sequence.
    fn begin(&mut self, metrics: &mut Metrics<'_>) -> Result<(), Error> {
        self.nodes.clear();
        self.open.clear();
        self.lots = self.all_lots.clone();
        let root = SearchNode {
            state: self.task.initial,
            ..SearchNode::default()
        };
        self.create(root, 0, metrics)
    }

    /// The task.
    pub fn task(&self) -> AbstractTask<'m, N> {
        self.task
    }

    /// The next sequence of operators that reaches the goal; in the order of their
    /// costs if the heuristic is never too high, apart from a new beginning.
    /// `None` if there is no other up to [`Config::max_length`].
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] if the memory is full, without advice. The search
    /// stays as it was before the node that found no room.
    pub fn next_skeleton<G: Guide<N>>(
        &mut self,
        guide: &mut G,
        metrics: &mut Metrics<'_>,
    ) -> Result<Option<Skeleton<'_, N>>, Error> {
        while let Some(waiting) = self.pop(metrics)? {
            let Some(node) = self.node(waiting.node) else {
                break;
            };
            self.follow(node)?;
            if !self.is_kept(guide, metrics) {
                continue;
            }
            if self.task.reached(node.state).is_some() {
                return Ok(Some(self.skeleton()));
            }
            if usize::from(node.length) >= self.config.max_length.min(MAX_SKELETON) {
                metrics.cut_off += 1;
                continue;
            }
            match self.check_room(node) {
                Ok(()) => self.expand(waiting.node, node, metrics)?,
                Err(_) if metrics.is_advised() => self.begin_without_advice(metrics)?,
                Err(error) => {
                    self.open.push(waiting)?;
                    return Err(error);
                }
            }
        }
        Ok(None)
    }

    /// Takes the first that waits. If patience is at its end, or nothing else is left,
    /// that is the empty sequence again.
    fn pop(&mut self, metrics: &mut Metrics<'_>) -> Result<Option<Waiting>, Error> {
        if metrics.is_patience_spent(&self.config) {
            self.begin_without_advice(metrics)?;
        }
        let first = self.open.pop();
        if first.is_some() || !metrics.is_advised() {
            return Ok(first);
        }
        self.begin_without_advice(metrics)?;
        Ok(self.open.pop())
    }

    fn begin_without_advice(&mut self, metrics: &mut Metrics<'_>) -> Result<(), Error> {
        metrics.end_advice();
        self.begin(metrics)
    }

    fn node(&self, place: u32) -> Option<SearchNode<N>> {
        self.nodes.as_slice().get(place as usize).copied()
    }

    /// Makes the sequence of a node the one at hand.
    fn follow(&mut self, mut node: SearchNode<N>) -> Result<(), Error> {
        self.path.clear();
        while node.length > 0 {
            let pushed = self.path.push(node.operator);
            pushed.map_err(|_| Error::CapacityExceeded("operators of a plan skeleton"))?;
            node = self.node(node.parent).unwrap_or_default();
        }
        self.path.reverse();
        Ok(())
    }

    /// The sequence at hand.
    fn skeleton(&self) -> Skeleton<'_, N> {
        Skeleton::new(self.task.operators, &self.path)
    }

    /// Whether to go on with the sequence at hand.
    fn is_kept<G: Guide<N>>(&mut self, guide: &mut G, metrics: &mut Metrics<'_>) -> bool {
        if self.path.is_empty() {
            return true;
        }
        let (count, reason) = match guide.judge(self.skeleton()) {
            Advice::Postpone(reason) if metrics.advised.is_none() => {
                (&mut metrics.postponed, reason)
            }
            Advice::Keep | Advice::Postpone(_) => return true,
            Advice::Prune(reason) => (&mut metrics.pruned, reason),
        };
        *count += 1;
        metrics.blame(reason);
        false
    }

    /// Whether all children of a node find room.
    fn check_room(&self, node: SearchNode<N>) -> Result<(), Error> {
        let children = self.task.applicable(node.state).count();
        if self.nodes.capacity().saturating_sub(self.nodes.len()) < children {
            Err(Error::CapacityExceeded("nodes of the search"))
        } else if self.open.room() < children {
            Err(Error::CapacityExceeded("open list of the search"))
        } else {
            Ok(())
        }
    }

    fn expand(
        &mut self,
        parent: u32,
        node: SearchNode<N>,
        metrics: &mut Metrics<'_>,
    ) -> Result<(), Error> {
        metrics.nodes_expanded += 1;
        let costs = self.skeleton().iter().map(|operator| operator.cost);
        let before = costs.fold(0, u32::saturating_add);
        for (operator, ground) in self.task.applicable(node.state) {
            let child = SearchNode {
                state: ground.apply(node.state),
                parent,
                operator,
                length: node.length.saturating_add(1),
            };
            self.create(child, before.saturating_add(ground.cost), metrics)?;
        }
        Ok(())
    }

    /// Lets a node wait, the operators of which cost so much, unless it is a dead end.
    fn create(
        &mut self,
        node: SearchNode<N>,
        spent: u32,
        metrics: &mut Metrics<'_>,
    ) -> Result<(), Error> {
        metrics.nodes_created += 1;
        let lot = self.lots.next_u64() >> 11;
        let Estimate::Cost(cost) = self.estimator.estimate(node.state) else {
            return Ok(());
        };
        let place = u32::try_from(self.nodes.len());
        self.nodes.push(node)?;
        self.open.push(Waiting {
            priority: spent.saturating_add(cost),
            lot,
            node: place.map_err(|_| Error::CapacityExceeded("nodes of the search"))?,
        })
    }
}
