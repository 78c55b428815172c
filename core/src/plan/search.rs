//! The search for plan skeletons.

use super::config::Config;
use super::guide::{Advice, Guide};
use super::heuristic::{Estimate, Estimator, HeuristicMemory};
use super::metrics::Metrics;
use super::open::{OpenList, Waiting};
use super::skeleton::{MAX_SKELETON, Skeleton};
use super::task::AbstractTask;
use super::visited::{Visit, Visited};
use crate::error::Error;
use crate::table::Table;
use crate::task::{AtomSet, GroundOperator};
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
    length: u8,
    /// If it is the first of its abstract state to be extended: how many were, up to 254.
    /// 255 if the sequence cannot work.
    extended: u8,
}

impl<const N: usize> SearchNode<N> {
    const DEAD: u8 = u8::MAX;
}

/// Bits of a lot that are not drawn.
const HEIGHT_BITS: u32 = 11;

const _: () = assert!(MAX_SKELETON <= u8::MAX as usize);

/// The memory of a [`Search`]. It bounds the search: lend less for a smaller budget.
#[derive(Debug)]
pub struct SearchMemory<'m, const N: usize = 2> {
    /// For the heuristic.
    pub heuristic: HeuristicMemory<'m, N>,
    /// One for each sequence of operators that is created.
    pub nodes: &'m mut [SearchNode<N>],
    /// One for each sequence that waits; as many as there are nodes always suffice.
    pub open: &'m mut [Waiting],
    /// One for each abstract state that is recognised, and some more; none if
    /// [`Config::skeletons_per_state`] is no bound.
    pub visited: &'m mut [u32],
}

/// A* over sequences of operators.
///
/// The sequences are a tree: two that lead to the same abstract state are two plan
/// skeletons, of which perhaps only one can be refined. How many of them are extended at
/// first is bounded, see [`Config::skeletons_per_state`]. Priority is what the operators
/// cost so far (their number, unless a PDDL text says otherwise) and the estimate; ties are
/// broken by lot; where a state is extended once, first by the estimate.
///
/// If there was advice and patience ends, the search begins anew without it, as if
/// there had been none.
#[derive(Debug)]
pub struct Search<'m, T, const N: usize = 2> {
    task: AbstractTask<'m, N>,
    estimator: Estimator<'m, N>,
    nodes: Table<'m, SearchNode<N>>,
    open: OpenList<'m>,
    visited: Visited<'m>,
    /// How many sequences to one abstract state are extended.
    bound: u32,
    /// The node of the skeleton that was found last.
    last: u32,
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
            visited: Visited::new(memory.visited),
            bound: config.skeletons_per_state,
            last: 0,
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
        self.bound = self.config.skeletons_per_state;
        if self.bound < u32::MAX {
            self.visited.clear();
        }
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
            if !self.follow(node)? {
                metrics.dead += 1;
                continue;
            }
            if !self.is_kept(guide, metrics) {
                continue;
            }
            if self.task.reached(node.state).is_some() {
                self.last = waiting.node;
                return Ok(Some(self.skeleton()));
            }
            if usize::from(node.length) >= self.config.max_length.min(MAX_SKELETON) {
                metrics.cut_off += 1;
                continue;
            }
            if !self.is_wanted(waiting.node, node) {
                metrics.repeated += 1;
                self.open.push(waiting.aside())?;
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

    /// Takes the first that waits. If patience is at its end, or nothing is left, that is
    /// the empty sequence again.
    fn pop(&mut self, metrics: &mut Metrics<'_>) -> Result<Option<Waiting>, Error> {
        if metrics.is_patience_spent(&self.config) {
            self.begin_without_advice(metrics)?;
        }
        let first = self.open.pop();
        if first.is_some_and(|first| !first.is_aside()) {
            return Ok(first);
        }
        if metrics.is_advised() {
            match first {
                // Advice is about the way to a state: another way there may pass.
                Some(aside) => {
                    self.open.push(aside)?;
                    self.widen();
                }
                None => self.begin_without_advice(metrics)?,
            }
            return Ok(self.open.pop());
        }
        self.raise(first, metrics)
    }

    /// Whether all that is left is set aside. If no skeleton was found by now there is
    /// none: what can be reached from an abstract state does not depend on the way there,
    /// unless the way is too long. Otherwise another way may be refined, so the bound rises.
    fn raise(
        &mut self,
        aside: Option<Waiting>,
        metrics: &Metrics<'_>,
    ) -> Result<Option<Waiting>, Error> {
        let Some(aside) = aside else {
            return Ok(None);
        };
        self.open.push(aside)?;
        if metrics.spent().skeletons == 0 && metrics.cut_off == 0 {
            return Ok(None);
        }
        self.widen();
        Ok(self.open.pop())
    }

    /// Extends twice as many sequences to each abstract state as before. A skeleton that
    /// could not be refined is a reason to: another way there may leave something else
    /// behind.
    pub fn widen(&mut self) {
        if self.bound < u32::MAX {
            self.bound = self.bound.saturating_mul(2);
            self.open.rejoin();
        }
    }

    /// Whether to extend the sequence at hand: if not enough others to the same abstract
    /// state were, or if it costs less than the first of them.
    fn is_wanted(&mut self, place: u32, node: SearchNode<N>) -> bool {
        if self.bound >= SearchNode::<N>::DEAD.into() {
            return true;
        }
        let nodes = self.nodes.as_mut_slice();
        let same = |other: u32| {
            let other = nodes.get(other as usize);
            other.is_some_and(|other| other.state == node.state)
        };
        let first = match self.visited.find(node.state.hash(), same) {
            Visit::Full => return true,
            Visit::New(slot) => {
                *slot = place.saturating_add(1);
                place
            }
            Visit::Known(slot) => {
                let first = slot.saturating_sub(1);
                let extended = nodes.get(first as usize).map_or(0, |first| first.extended);
                let cheaper = cost_to(self.task.operators, nodes, place)
                    < cost_to(self.task.operators, nodes, first);
                let is_dead = extended == SearchNode::<N>::DEAD;
                if cheaper || is_dead {
                    *slot = place.saturating_add(1);
                    if let Some(own) = nodes.get_mut(place as usize) {
                        own.extended = if is_dead { 0 } else { extended };
                    }
                    place
                } else if u32::from(extended) >= self.bound {
                    return false;
                } else {
                    first
                }
            }
        };
        if let Some(first) = nodes.get_mut(first as usize) {
            first.extended = first
                .extended
                .saturating_add(1)
                .min(SearchNode::<N>::DEAD - 1);
        }
        true
    }

    fn begin_without_advice(&mut self, metrics: &mut Metrics<'_>) -> Result<(), Error> {
        metrics.end_advice();
        self.begin(metrics)
    }

    fn node(&self, place: u32) -> Option<SearchNode<N>> {
        self.nodes.as_slice().get(place as usize).copied()
    }

    /// Makes the sequence of a node the one at hand. Whether no part of it is dead.
    fn follow(&mut self, mut node: SearchNode<N>) -> Result<bool, Error> {
        self.path.clear();
        let mut alive = true;
        while node.length > 0 {
            alive &= node.extended != SearchNode::<N>::DEAD;
            let pushed = self.path.push(node.operator);
            pushed.map_err(|_| Error::CapacityExceeded("operators of a plan skeleton"))?;
            node = self.node(node.parent).unwrap_or_default();
        }
        self.path.reverse();
        Ok(alive)
    }

    /// Notes that the first so many operators of a skeleton, the one that was found last,
    /// cannot work: so nothing that begins with them can. Without a bound of sequences to
    /// an abstract state nothing is noted, so that the search stays as it was recorded.
    pub fn bury(&mut self, length: usize) {
        if self.config.skeletons_per_state == u32::MAX {
            return;
        }
        let mut place = self.last;
        while let Some(node) = self.nodes.as_mut_slice().get_mut(place as usize) {
            if usize::from(node.length) <= length {
                node.extended = SearchNode::<N>::DEAD;
                return;
            }
            place = node.parent;
        }
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
                extended: 0,
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
        let lot = self.lots.next_u64() >> HEIGHT_BITS;
        let Estimate::Cost(cost) = self.estimator.estimate(node.state) else {
            return Ok(());
        };
        let place = u32::try_from(self.nodes.len());
        self.nodes.push(node)?;
        let place = place.map_err(|_| Error::CapacityExceeded("nodes of the search"))?;
        // In a graph, what is nearer to the goal comes first.
        let height = match self.config.skeletons_per_state {
            1 => u64::from(cost.min((1 << HEIGHT_BITS) - 1)) << (u64::BITS - HEIGHT_BITS),
            _ => 0,
        };
        let waiting = Waiting::new(spent.saturating_add(cost), height | lot, place);
        self.open.push(waiting)
    }
}

/// What the sequence of a node costs.
fn cost_to<const N: usize>(
    operators: &[GroundOperator<N>],
    nodes: &[SearchNode<N>],
    place: u32,
) -> u32 {
    let mut cost = 0u32;
    let mut node = nodes.get(place as usize);
    while let Some(SearchNode {
        length: 1..,
        operator,
        parent,
        ..
    }) = node
    {
        let own = operators.get(usize::from(*operator));
        cost = cost.saturating_add(own.map_or(0, |own| own.cost));
        node = nodes.get(*parent as usize);
    }
    cost
}
