//! The learners behind one type, so that everything else is written once.

use crate::boundary::precision::Precision;
#[cfg(feature = "f32")]
use crate::boundary::precision::Single;
use critreg_core::Error;
use critreg_core::learn::version_space::{self, Evidence, VersionSpace};
#[cfg(feature = "algorithm1")]
use critreg_core::learn::{Algorithm1, algorithm1};
use critreg_core::learn::{Learner, Observation, Outcome, Problem, Query};
use critreg_core::real::Real;
use critreg_core::region::Region;

/// How much a learner of some kind has room for.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Capacity {
    #[cfg(feature = "algorithm1")]
    Algorithm1(algorithm1::Capacity),
    VersionSpace(version_space::Capacity),
}

impl Capacity {
    /// Hypotheses of the one, forms of the other.
    pub(crate) const fn hypotheses(self) -> usize {
        match self {
            #[cfg(feature = "algorithm1")]
            Capacity::Algorithm1(capacity) => capacity.hypotheses,
            Capacity::VersionSpace(capacity) => capacity.forms,
        }
    }

    /// The same with another number of hypotheses.
    pub(crate) const fn with_hypotheses(self, hypotheses: usize) -> Capacity {
        match self {
            #[cfg(feature = "algorithm1")]
            Capacity::Algorithm1(mut capacity) => {
                capacity.hypotheses = hypotheses;
                #[cfg(feature = "algorithm1")]
                Capacity::Algorithm1(capacity)
            }
            Capacity::VersionSpace(mut capacity) => {
                capacity.forms = hypotheses;
                Capacity::VersionSpace(capacity)
            }
        }
    }
}

/// A learner of some kind, a part of the caller's memory.
pub(crate) enum Kind<R: 'static> {
    #[cfg(feature = "algorithm1")]
    Algorithm1(&'static mut Algorithm1<'static, R>),
    VersionSpace(&'static mut VersionSpace<'static, R>),
}

impl<R: Real> Kind<R> {
    /// The learner, whichever it is.
    fn any(&self) -> &dyn Learner {
        match self {
            #[cfg(feature = "algorithm1")]
            Kind::Algorithm1(learner) => &**learner,
            Kind::VersionSpace(learner) => &**learner,
        }
    }

    fn any_mut(&mut self) -> &mut dyn Learner {
        match self {
            #[cfg(feature = "algorithm1")]
            Kind::Algorithm1(learner) => &mut **learner,
            Kind::VersionSpace(learner) => &mut **learner,
        }
    }

    /// How learning went so far.
    fn report(&self) -> Report {
        match self {
            #[cfg(feature = "algorithm1")]
            Kind::Algorithm1(learner) => Report::Algorithm1(learner.report()),
            Kind::VersionSpace(learner) => Report::VersionSpace(learner.report()),
        }
    }

    fn evidence(&self) -> &[Evidence] {
        match self {
            #[cfg(feature = "algorithm1")]
            Kind::Algorithm1(_) => &[],
            Kind::VersionSpace(learner) => learner.evidence(),
        }
    }
}

/// How learning went with a learner of some kind.
pub(crate) enum Report {
    #[cfg(feature = "algorithm1")]
    Algorithm1(algorithm1::Report),
    VersionSpace(version_space::Report),
}

/// A learner of some kind and precision.
pub(crate) enum AnyLearner {
    #[cfg(feature = "f32")]
    Single(Kind<Single>),
    #[cfg(feature = "f64")]
    Double(Kind<f64>),
}

/// Calls a method on a learner of whichever precision.
macro_rules! each {
    ($any:expr, $kind:ident => $call:expr) => {
        match $any {
            #[cfg(feature = "f32")]
            AnyLearner::Single($kind) => $call,
            #[cfg(feature = "f64")]
            AnyLearner::Double($kind) => $call,
        }
    };
}

impl AnyLearner {
    fn any(&self) -> &dyn Learner {
        each!(self, kind => kind.any())
    }

    fn any_mut(&mut self) -> &mut dyn Learner {
        each!(self, kind => kind.any_mut())
    }

    /// What supports each constraint of the region, in their order; empty if the
    /// learner does not know.
    pub(crate) fn evidence(&self) -> &[Evidence] {
        each!(self, kind => kind.evidence())
    }

    /// How learning went so far.
    pub(crate) fn report(&self) -> Report {
        each!(self, kind => kind.report())
    }

    /// What it computes with.
    pub(crate) fn precision(&self) -> Precision {
        match self {
            #[cfg(feature = "f32")]
            AnyLearner::Single(_) => Precision::Single,
            #[cfg(feature = "f64")]
            AnyLearner::Double(_) => Precision::Double,
        }
    }
}

impl Learner for AnyLearner {
    fn ask(&mut self, problem: &Problem<'_>) -> Result<Query, Error> {
        self.any_mut().ask(problem)
    }

    fn tell(&mut self, problem: &Problem<'_>, answer: Outcome) -> Result<(), Error> {
        self.any_mut().tell(problem, answer)
    }

    fn is_finished(&self) -> bool {
        self.any().is_finished()
    }

    fn region(&self) -> Result<&Region, Error> {
        self.any().region()
    }

    fn observations(&self) -> &[Observation] {
        self.any().observations()
    }

    fn room(&self) -> usize {
        self.any().room()
    }

    fn fingerprint(&self) -> u32 {
        self.any().fingerprint()
    }
}
