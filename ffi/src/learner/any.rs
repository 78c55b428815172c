//! What all learners of the core have in common for C.

use crate::learner::report::critreg_report;
use critreg_core::learn::version_space::{self, Evidence};
#[cfg(feature = "algorithm1")]
use critreg_core::learn::{Algorithm1, algorithm1};
use critreg_core::learn::{Learner, VersionSpace};
use critreg_core::real::Real;

/// How much a learner of some kind has room for.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Capacity {
    #[cfg(feature = "algorithm1")]
    Algorithm1(algorithm1::Capacity),
    VersionSpace(version_space::Capacity),
}

impl Capacity {
    /// Hypotheses of the one, forms of the other.
    pub(crate) const fn forms(self) -> usize {
        match self {
            #[cfg(feature = "algorithm1")]
            Capacity::Algorithm1(capacity) => capacity.hypotheses,
            Capacity::VersionSpace(capacity) => capacity.forms,
        }
    }

    /// Steps of the sequence that is learned about; `None` if it makes no difference
    /// which one fails.
    pub(crate) const fn steps(self) -> Option<usize> {
        match self {
            #[cfg(feature = "algorithm1")]
            Capacity::Algorithm1(_) => None,
            Capacity::VersionSpace(capacity) => Some(capacity.steps),
        }
    }

    /// The same with another number of forms.
    pub(crate) const fn with_forms(mut self, forms: usize) -> Capacity {
        match &mut self {
            #[cfg(feature = "algorithm1")]
            Capacity::Algorithm1(capacity) => capacity.hypotheses = forms,
            Capacity::VersionSpace(capacity) => capacity.forms = forms,
        }
        self
    }
}

/// A learner of whichever kind and precision.
pub(crate) trait AnyLearner: Learner {
    /// How learning went so far.
    fn report(&self) -> critreg_report;

    /// What supports each constraint of the region, in their order; empty if the
    /// learner does not know.
    fn evidence(&self) -> &[Evidence];
}

#[cfg(feature = "algorithm1")]
impl<R: Real> AnyLearner for Algorithm1<'_, R> {
    fn report(&self) -> critreg_report {
        critreg_report::of_algorithm1(&Algorithm1::report(self))
    }

    fn evidence(&self) -> &[Evidence] {
        &[]
    }
}

impl<R: Real> AnyLearner for VersionSpace<'_, R> {
    fn report(&self) -> critreg_report {
        critreg_report::of_version_space(&VersionSpace::report(self))
    }

    fn evidence(&self) -> &[Evidence] {
        VersionSpace::evidence(self)
    }
}
