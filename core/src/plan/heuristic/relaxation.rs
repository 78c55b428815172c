//! The delete relaxation of a task, and what can be reached in it.

use super::super::task::AbstractTask;
use crate::error::Error;
use crate::task::{AtomSet, GroundOperator};

/// An atom, by its place, or [`Relaxation::START`].
pub(super) type Fact = u16;

/// Atoms that one word of a set has a bit for.
pub(super) const BITS: usize = 64;

/// What a heuristic notes about a ground operator.
#[derive(Clone, Copy, Debug, Default)]
pub struct Progress {
    /// Preconditions; at least one, [`Relaxation::START`].
    preconditions: u16,
    /// Those that are not reached yet.
    missing: u16,
    /// The precondition that was reached last.
    supporter: Fact,
    /// Whether it is in the cut that is being made.
    pub(super) is_cut: bool,
    /// What is left of its cost.
    pub(super) cost: u32,
}

impl Progress {
    /// The precondition that makes the operator as expensive as it is, if it can
    /// be reached at all.
    pub(super) fn supporter(&self) -> Option<Fact> {
        (self.missing == 0).then_some(self.supporter)
    }
}

/// How many links between atoms and operators a task has: the sum of all
/// preconditions, counting none as one, and all add effects.
pub fn links<const N: usize>(operators: &[GroundOperator<N>]) -> usize {
    let of = |o: &GroundOperator<N>| o.preconditions.len().max(1) + o.add_effects.len();
    operators.iter().map(|o| of(o) as usize).sum()
}

/// The goal in the relaxation.
pub(super) struct Reached {
    /// The cost of the goal atom that is hardest to reach: h-max.
    pub(super) cost: u32,
    /// That atom.
    pub(super) supporter: Fact,
}

/// A task without delete effects.
#[derive(Debug)]
pub(super) struct Relaxation<'m, const N: usize> {
    pub(super) task: AbstractTask<'m, N>,
    pub(super) progress: &'m mut [Progress],
    /// The operators that need a fact.
    pub(super) needing: Links<'m, N>,
    /// The operators that add a fact.
    pub(super) adding: Links<'m, N>,
    /// Whether some operator does not cost one.
    pub(super) weighted: bool,
    /// If so: what it costs to reach the atoms that are reached next, at most.
    costs: [[u32; BITS]; N],
}

impl<'m, const N: usize> Relaxation<'m, N> {
    /// Holds from the beginning, and is the precondition of operators without one. So
    /// every operator has a precondition that is reached last.
    pub(super) const START: Fact = (BITS * N) as Fact;

    pub(super) fn new(
        task: AbstractTask<'m, N>,
        progress: &'m mut [Progress],
        links: &'m mut [u16],
    ) -> Result<Self, Error> {
        let count = task.operators.len();
        let progress = progress
            .get_mut(..count)
            .filter(|_| u16::try_from(count).is_ok())
            .ok_or(Error::CapacityExceeded("operators of the heuristic"))?;
        for (progress, operator) in progress.iter_mut().zip(task.operators) {
            *progress = Progress {
                preconditions: needs(operator).count() as u16,
                ..Progress::default()
            };
        }
        let (needing, links) = Links::new(links, task.operators, needs)?;
        let (adding, _) = Links::new(links, task.operators, adds)?;
        Ok(Relaxation {
            weighted: task.operators.iter().any(|o| o.cost != 1),
            task,
            progress,
            needing,
            adding,
            costs: [[0; BITS]; N],
        })
    }

    /// h-max; `None` if the goal cannot be reached.
    pub(super) fn max(&mut self, state: AtomSet<N>) -> Option<u32> {
        self.reset_costs();
        self.explore(state).map(|goal| goal.cost)
    }

    /// Operators cost what they cost in the task.
    pub(super) fn reset_costs(&mut self) {
        if self.weighted {
            for (progress, operator) in self.progress.iter_mut().zip(self.task.operators) {
                progress.cost = operator.cost;
            }
        } else {
            // Without a look at the operators, which are spread over memory.
            for progress in self.progress.iter_mut() {
                progress.cost = 1;
            }
        }
    }

    /// Reaches everything that can be reached from a state, the cheapest first,
    /// with the costs that are noted; an operator costs that and as much as its
    /// most expensive precondition. `None` if the goal is not reached. Stops early
    /// if the goal is for free.
    pub(super) fn explore(&mut self, state: AtomSet<N>) -> Option<Reached> {
        for progress in self.progress.iter_mut() {
            progress.missing = progress.preconditions;
        }
        let mut wave = Wave {
            cost: 0,
            reached: state,
            now: state,
            next: AtomSet::EMPTY,
        };
        let mut goal = Reached {
            cost: 0,
            supporter: Self::START,
        };
        let mut open = self.task.goal;
        self.settle(Self::START, &mut wave);
        // Each round but the last reaches an atom.
        for _ in 0..=BITS * N {
            while let Some(place) = wave.now.pop_first() {
                self.settle(place as Fact, &mut wave);
            }
            if let Some(place) = open.intersection(wave.reached).pop_first() {
                goal = Reached {
                    cost: wave.cost,
                    supporter: place as Fact,
                };
            }
            open = open.difference(wave.reached);
            wave.next = wave.next.difference(wave.reached);
            let goal_is_free = wave.cost == 0 && open.is_empty();
            if wave.next.is_empty() || goal_is_free {
                break;
            }
            self.advance(&mut wave);
        }
        open.is_empty().then_some(goal)
    }

    /// Goes on to the cheapest of the atoms that are reached next.
    fn advance(&self, wave: &mut Wave<N>) {
        if self.weighted {
            let cost = |place: &u32| self.costs.as_flattened().get(*place as usize).copied();
            let least = wave.next.places().filter_map(|place| cost(&place)).min();
            wave.cost = least.unwrap_or(wave.cost);
            let cheapest = wave.next.places().filter(|place| cost(place) == least);
            wave.now = cheapest.fold(AtomSet::EMPTY, |set, place| {
                set.union(AtomSet::single(place))
            });
        } else {
            wave.cost += 1;
            wave.now = wave.next;
        }
        wave.reached = wave.reached.union(wave.now);
        wave.next = wave.next.difference(wave.now);
    }

    /// Tells the operators that need a fact that it is reached; the last fact that
    /// an operator waits for makes it reach its effects.
    fn settle(&mut self, fact: Fact, wave: &mut Wave<N>) {
        for place in self.needing.of(fact) {
            let Some(progress) = self.progress.get_mut(usize::from(*place)) else {
                continue;
            };
            progress.missing = progress.missing.saturating_sub(1);
            if progress.missing > 0 {
                continue;
            }
            progress.supporter = fact;
            let effects = adds_of(self.task.operators, *place);
            if progress.cost == 0 {
                wave.now = wave.now.union(effects.difference(wave.reached));
                wave.reached = wave.reached.union(effects);
                continue;
            }
            if self.weighted {
                let cost = wave.cost.saturating_add(progress.cost);
                let costs = self.costs.as_flattened_mut();
                lower(costs, effects.difference(wave.reached), wave.next, cost);
            }
            wave.next = wave.next.union(effects);
        }
    }
}

/// Lowers the costs of these atoms, of which those that are `known` have one.
fn lower<const N: usize>(costs: &mut [u32], atoms: AtomSet<N>, known: AtomSet<N>, cost: u32) {
    for place in atoms.places() {
        if let Some(own) = costs.get_mut(place as usize) {
            *own = if known.contains(place) {
                cost.min(*own)
            } else {
                cost
            };
        }
    }
}

/// How far an exploration is.
struct Wave<const N: usize> {
    /// What it costs to reach what is reached.
    cost: u32,
    /// The atoms that are reached.
    reached: AtomSet<N>,
    /// Those of them that no operator knows of yet.
    now: AtomSet<N>,
    /// The atoms that are reached at a higher cost.
    next: AtomSet<N>,
}

/// The add effects of the operator at a place.
pub(super) fn adds_of<const N: usize>(operators: &[GroundOperator<N>], place: u16) -> AtomSet<N> {
    let operator = operators.get(usize::from(place));
    operator.map_or(AtomSet::EMPTY, |o| o.add_effects)
}

fn needs<const N: usize>(operator: &GroundOperator<N>) -> impl Iterator<Item = Fact> + use<N> {
    let needs = operator.preconditions;
    let start = needs.is_empty().then_some(Relaxation::<N>::START);
    needs.places().map(|place| place as Fact).chain(start)
}

fn adds<const N: usize>(operator: &GroundOperator<N>) -> impl Iterator<Item = Fact> + use<N> {
    operator.add_effects.places().map(|place| place as Fact)
}

/// An entry for each atom, and two more.
type Starts<const N: usize> = [[u16; BITS + 2]; N];

/// For each fact some of the operators, by their places (a bipartite graph in
/// compressed rows).
#[derive(Debug)]
pub(super) struct Links<'m, const N: usize> {
    /// Where the operators of each fact start; one more ends the last. There is room for
    /// [`Relaxation::START`], too.
    starts: Starts<N>,
    operators: &'m mut [u16],
}

impl<'m, const N: usize> Links<'m, N> {
    /// Links each operator to its facts, and returns the memory that is left.
    fn new<F: Iterator<Item = Fact>>(
        memory: &'m mut [u16],
        operators: &[GroundOperator<N>],
        facts: impl Fn(&GroundOperator<N>) -> F,
    ) -> Result<(Self, &'m mut [u16]), Error> {
        const FULL: Error = Error::CapacityExceeded("links of the heuristic");
        let count = operators.iter().map(|o| facts(o).count()).sum();
        u16::try_from(count).map_err(|_| FULL)?;
        let (memory, rest) = memory.split_at_mut_checked(count).ok_or(FULL)?;
        let mut starts = [[0; BITS + 2]; N];
        for fact in operators.iter().flat_map(&facts) {
            add(&mut starts, fact, 1);
        }
        // First where the operators of each fact end; filling them in from behind
        // leaves where they start.
        let mut sum = 0;
        for start in starts.as_flattened_mut() {
            sum += *start;
            *start = sum;
        }
        for (place, operator) in (0..u16::MAX).zip(operators).rev() {
            for fact in facts(operator) {
                let start = add(&mut starts, fact, -1);
                if let Some(slot) = memory.get_mut(usize::from(start)) {
                    *slot = place;
                }
            }
        }
        let links = Links {
            starts,
            operators: memory,
        };
        Ok((links, rest))
    }

    /// The operators of a fact, in order.
    pub(super) fn of(&self, fact: Fact) -> &[u16] {
        let fact = usize::from(fact);
        let starts = self.starts.as_flattened();
        let start = starts.get(fact).copied().unwrap_or_default();
        let end = starts.get(fact + 1).copied().unwrap_or_default();
        let range = usize::from(start)..usize::from(end);
        self.operators.get(range).unwrap_or_default()
    }
}

fn add<const N: usize>(starts: &mut Starts<N>, fact: Fact, change: i16) -> u16 {
    let starts = starts.as_flattened_mut();
    let Some(start) = starts.get_mut(usize::from(fact)) else {
        return 0;
    };
    *start = start.wrapping_add_signed(change);
    *start
}
