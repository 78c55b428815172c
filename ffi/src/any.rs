//! The learners behind one type, so that everything else is written once.

use critreg_core::Error;
use critreg_core::learn::version_space::{self, Evidence, VersionSpace};
use critreg_core::learn::{self, Algorithm1, Answer, Learner, Observation, Problem, Query};
use critreg_core::region::Region;

/// How much a learner of some kind has room for.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Capacity {
    Algorithm1(learn::Capacity),
    VersionSpace(version_space::Capacity),
}

impl Capacity {
    /// Hypotheses of the one, forms of the other.
    pub(crate) const fn hypotheses(self) -> usize {
        match self {
            Capacity::Algorithm1(capacity) => capacity.hypotheses,
            Capacity::VersionSpace(capacity) => capacity.forms,
        }
    }

    /// The same with another number of hypotheses.
    pub(crate) const fn with_hypotheses(self, hypotheses: usize) -> Capacity {
        match self {
            Capacity::Algorithm1(mut capacity) => {
                capacity.hypotheses = hypotheses;
                Capacity::Algorithm1(capacity)
            }
            Capacity::VersionSpace(mut capacity) => {
                capacity.forms = hypotheses;
                Capacity::VersionSpace(capacity)
            }
        }
    }
}

/// A learner of some kind. It lies in the memory of a handle, which has room for
/// the larger one.
#[expect(
    clippy::large_enum_variant,
    reason = "there is no heap to put the larger one on"
)]
pub(crate) enum AnyLearner {
    Algorithm1(Algorithm1<'static, f64>),
    VersionSpace(VersionSpace<'static, f64>),
}

/// Calls a method on whichever learner it is.
macro_rules! each {
    ($any:expr, $learner:ident => $call:expr) => {
        match $any {
            AnyLearner::Algorithm1($learner) => $call,
            AnyLearner::VersionSpace($learner) => $call,
        }
    };
}

impl AnyLearner {
    /// What supports each constraint of the region, in their order; empty if the
    /// learner does not know.
    pub(crate) fn evidence(&self) -> &[Evidence] {
        match self {
            AnyLearner::Algorithm1(_) => &[],
            AnyLearner::VersionSpace(learner) => learner.evidence(),
        }
    }
}

impl Learner for AnyLearner {
    fn ask(&mut self, problem: &Problem<'_>) -> Result<Query, Error> {
        each!(self, learner => learner.ask(problem))
    }

    fn tell(&mut self, problem: &Problem<'_>, answer: Answer) -> Result<(), Error> {
        each!(self, learner => learner.tell(problem, answer))
    }

    fn is_finished(&self) -> bool {
        each!(self, learner => learner.is_finished())
    }

    fn region(&self) -> Result<&Region, Error> {
        each!(self, learner => learner.region())
    }

    fn observations(&self) -> &[Observation] {
        each!(self, learner => learner.observations())
    }

    fn room(&self) -> usize {
        each!(self, learner => learner.room())
    }

    fn fingerprint(&self) -> u32 {
        each!(self, learner => learner.fingerprint())
    }
}
