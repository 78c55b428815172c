//! Heuristics: how many operators it takes at least, or about, to the goal.
//!
//! All are computed in the delete relaxation, in which what holds once holds
//! forever. Operators cost one each, unless a PDDL text says otherwise.

mod additive;
mod cache;
mod landmark;
mod relaxation;

pub use cache::Cached;
pub use relaxation::{Progress, links};

use super::task::AbstractTask;
use crate::error::Error;
use crate::task::AtomSet;
use cache::Cache;
use relaxation::Relaxation;

/// Which estimate of the cost to the goal guides the search.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Heuristic {
    /// LM-cut: the number of disjoint sets of operators of each of which every
    /// plan has one (Helmert and Domshlak 2009). Never too high, and never below
    /// [`Heuristic::Max`].
    #[default]
    LandmarkCut,
    /// h-max: the cost of the goal atom that is hardest to reach (Bonet and
    /// Geffner 2001). Never too high.
    Max,
    /// h-add: the sum of the costs of all goal atoms (Bonet and Geffner 2001). May
    /// be too high, so that longer sequences can come before shorter ones.
    Additive,
    /// Zero: breadth first. Sees no dead end.
    Blind,
}

/// A cost to the goal: operators, unless a PDDL text says what they cost.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Estimate {
    /// This many.
    Cost(u32),
    /// The goal cannot be reached, not even if nothing were ever deleted.
    Unreachable,
}

/// The memory of an [`Estimator`].
#[derive(Debug)]
pub struct HeuristicMemory<'m, const N: usize = 2> {
    /// One for each ground operator.
    pub operators: &'m mut [Progress],
    /// As many as [`links`] says.
    pub links: &'m mut [u16],
    /// Estimates to remember, any number: each spares another computation for an
    /// abstract state that is met again. None is right for [`Heuristic::Blind`].
    pub cache: &'m mut [Cached<N>],
}

/// A heuristic of one task.
#[derive(Debug)]
pub struct Estimator<'m, const N: usize = 2> {
    heuristic: Heuristic,
    relaxation: Relaxation<'m, N>,
    cache: Cache<'m, N>,
}

impl<'m, const N: usize> Estimator<'m, N> {
    /// Prepares a heuristic for a task.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] if operators or links are fewer than the task
    /// needs, or the task has more than 65 535 of them.
    pub fn new(
        heuristic: Heuristic,
        task: AbstractTask<'m, N>,
        memory: HeuristicMemory<'m, N>,
    ) -> Result<Self, Error> {
        Ok(Estimator {
            heuristic,
            relaxation: Relaxation::new(task, memory.operators, memory.links)?,
            cache: Cache::new(memory.cache),
        })
    }

    /// The estimate for an abstract state.
    pub fn estimate(&mut self, state: AtomSet<N>) -> Estimate {
        if let Some(estimate) = self.cache.get(state) {
            return estimate;
        }
        let cost = match self.heuristic {
            Heuristic::LandmarkCut => self.relaxation.landmark_cut(state),
            Heuristic::Max => self.relaxation.max(state),
            Heuristic::Additive => self.relaxation.additive(state),
            Heuristic::Blind => Some(0),
        };
        let estimate = cost.map_or(Estimate::Unreachable, Estimate::Cost);
        self.cache.put(state, estimate);
        estimate
    }
}
