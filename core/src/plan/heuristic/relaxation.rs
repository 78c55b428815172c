//! The delete relaxation of a task, and what can be reached in it.

use super::super::task::AbstractTask;
use crate::error::Error;
use crate::task::{AtomSet, GroundOperator, MAX_ATOMS};

/// An atom, by its place, or [`START`].
pub(super) type Fact = u8;

/// Holds from the beginning, and is the precondition of operators without one. So
/// every operator has a precondition that is reached last.
pub(super) const START: Fact = MAX_ATOMS as Fact;
const FACTS: usize = MAX_ATOMS + 1;

/// What a heuristic notes about a ground operator.
#[derive(Clone, Copy, Debug, Default)]
pub struct Progress {
    /// Preconditions; at least one, [`START`].
    preconditions: u8,
    /// Those that are not reached yet.
    missing: u8,
    /// Zero or one.
    pub(super) cost: u8,
    /// The precondition that was reached last.
    supporter: Fact,
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
pub fn links(operators: &[GroundOperator]) -> usize {
    let of = |o: &GroundOperator| o.preconditions.len().max(1) + o.add_effects.len();
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
pub(super) struct Relaxation<'m> {
    pub(super) task: AbstractTask<'m>,
    pub(super) progress: &'m mut [Progress],
    /// The operators that need a fact.
    pub(super) needing: Links<'m>,
    /// The operators that add a fact.
    pub(super) adding: Links<'m>,
}

impl<'m> Relaxation<'m> {
    pub(super) fn new(
        task: AbstractTask<'m>,
        progress: &'m mut [Progress],
        links: &'m mut [u16],
    ) -> Result<Self, Error> {
        let count = task.operators.len();
        let progress = progress
            .get_mut(..count)
            .filter(|_| u16::try_from(count).is_ok())
            .ok_or(Error::CapacityExceeded("operators of the heuristic"))?;
        for (progress, operator) in progress.iter_mut().zip(task.operators) {
            progress.preconditions = needs(operator).count().min(MAX_ATOMS) as u8;
        }
        let (needing, links) = Links::new(links, task.operators, needs)?;
        let (adding, _) = Links::new(links, task.operators, adds)?;
        Ok(Relaxation {
            task,
            progress,
            needing,
            adding,
        })
    }

    /// h-max; `None` if the goal cannot be reached.
    pub(super) fn max(&mut self, state: AtomSet) -> Option<u32> {
        self.all_cost_one();
        self.explore(state).map(|goal| goal.cost)
    }

    pub(super) fn all_cost_one(&mut self) {
        for progress in self.progress.iter_mut() {
            progress.cost = 1;
        }
    }

    /// Reaches everything that can be reached from a state, the cheapest first,
    /// with the costs that are noted; an operator costs that and as much as its
    /// most expensive precondition. `None` if the goal is not reached. Stops early
    /// if the goal is for free.
    pub(super) fn explore(&mut self, state: AtomSet) -> Option<Reached> {
        for progress in self.progress.iter_mut() {
            progress.missing = progress.preconditions;
        }
        let mut wave = Wave {
            reached: state,
            now: state,
            next: AtomSet::EMPTY,
        };
        let mut goal = Reached {
            cost: 0,
            supporter: START,
        };
        let mut open = self.task.goal;
        self.settle(START, &mut wave);
        // Each round but the last reaches an atom.
        for cost in 0..=MAX_ATOMS as u32 {
            while let Some(place) = wave.now.pop_first() {
                self.settle(place as Fact, &mut wave);
            }
            if let Some(place) = open.intersection(wave.reached).pop_first() {
                goal = Reached {
                    cost,
                    supporter: place as Fact,
                };
            }
            open = open.difference(wave.reached);
            wave.now = wave.next.difference(wave.reached);
            let goal_is_free = cost == 0 && open.is_empty();
            if wave.now.is_empty() || goal_is_free {
                break;
            }
            wave.reached = wave.reached.union(wave.now);
            wave.next = AtomSet::EMPTY;
        }
        open.is_empty().then_some(goal)
    }

    /// Tells the operators that need a fact that it is reached; the last fact that
    /// an operator waits for makes it reach its effects.
    fn settle(&mut self, fact: Fact, wave: &mut Wave) {
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
            if progress.cost > 0 {
                wave.next = wave.next.union(effects);
            } else {
                wave.now = wave.now.union(effects.difference(wave.reached));
                wave.reached = wave.reached.union(effects);
            }
        }
    }
}

/// How far an exploration is.
struct Wave {
    /// The atoms that are reached.
    reached: AtomSet,
    /// Those of them that no operator knows of yet.
    now: AtomSet,
    /// The atoms that are reached at a cost of one more.
    next: AtomSet,
}

/// The add effects of the operator at a place.
pub(super) fn adds_of(operators: &[GroundOperator], place: u16) -> AtomSet {
    let operator = operators.get(usize::from(place));
    operator.map_or(AtomSet::EMPTY, |o| o.add_effects)
}

fn needs(operator: &GroundOperator) -> impl Iterator<Item = Fact> + use<> {
    let needs = operator.preconditions;
    let start = needs.is_empty().then_some(START);
    needs.places().map(|place| place as Fact).chain(start)
}

fn adds(operator: &GroundOperator) -> impl Iterator<Item = Fact> + use<> {
    operator.add_effects.places().map(|place| place as Fact)
}

/// For each fact some of the operators, by their places (a bipartite graph in
/// compressed rows).
#[derive(Debug)]
pub(super) struct Links<'m> {
    /// Where the operators of each fact start; one more ends the last.
    starts: [u16; FACTS + 1],
    operators: &'m mut [u16],
}

impl<'m> Links<'m> {
    /// Links each operator to its facts, and returns the memory that is left.
    fn new<F: Iterator<Item = Fact>>(
        memory: &'m mut [u16],
        operators: &[GroundOperator],
        facts: impl Fn(&GroundOperator) -> F,
    ) -> Result<(Self, &'m mut [u16]), Error> {
        const FULL: Error = Error::CapacityExceeded("links of the heuristic");
        let count = operators.iter().map(|o| facts(o).count()).sum();
        u16::try_from(count).map_err(|_| FULL)?;
        let (memory, rest) = memory.split_at_mut_checked(count).ok_or(FULL)?;
        let mut starts = [0; FACTS + 1];
        for fact in operators.iter().flat_map(&facts) {
            add(&mut starts, fact, 1);
        }
        // First where the operators of each fact end; filling them in from behind
        // leaves where they start.
        let mut sum = 0;
        for start in starts.iter_mut() {
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
        let start = self.starts.get(fact).copied().unwrap_or_default();
        let end = self.starts.get(fact + 1).copied().unwrap_or_default();
        let range = usize::from(start)..usize::from(end);
        self.operators.get(range).unwrap_or_default()
    }
}

fn add(starts: &mut [u16; FACTS + 1], fact: Fact, change: i16) -> u16 {
    let Some(start) = starts.get_mut(usize::from(fact)) else {
        return 0;
    };
    *start = start.wrapping_add_signed(change);
    *start
}
