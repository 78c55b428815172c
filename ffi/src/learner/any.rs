//! What all learners of the core have in common for C.

#[cfg(feature = "algorithm1")]
use crate::boundary::status::Failure;
use crate::boundary::status::Fallible;
use crate::learner::quality::number;
use crate::learner::report::critreg_report;
#[cfg(feature = "algorithm1")]
use crate::region::quality::CRITREG_NO_QUALITY;
use critreg_core::Error;
use critreg_core::domain::Domain;
use critreg_core::learn::version_space::{self, Evidence, LeftOut, Why};
#[cfg(feature = "algorithm1")]
use critreg_core::learn::{Algorithm1, algorithm1};
use critreg_core::learn::{Learner, VersionSpace};
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

    /// The best region there is, of whatever quality.
    fn best_region(&self) -> Result<&Region, Error>;

    /// Its quality, as a number of the header.
    fn quality(&self) -> u32;

    /// Why there is no region, or none that is exact.
    fn why(&self) -> Why;

    /// What could be compared and is not, because it found no room.
    fn left_out(&self, domain: &Domain<'_>) -> Option<LeftOut>;

    /// What supports each constraint of the region, in their order; empty if the
    /// learner does not know.
    fn evidence(&self) -> &[Evidence];

    /// Chooses instances of a source, see [`VersionSpace::choose_instances`].
    fn choose_instances(
        &mut self,
        domain: &Domain<'_>,
        offered: usize,
        make: &mut dyn FnMut(usize, &mut [f64]) -> Fallible,
        chosen: &mut [f64],
    ) -> Fallible<usize>;
}

#[cfg(feature = "algorithm1")]
impl<R: Real> AnyLearner for Algorithm1<'_, R> {
    fn report(&self) -> critreg_report {
        critreg_report::of_algorithm1(&Algorithm1::report(self))
    }

    fn best_region(&self) -> Result<&Region, Error> {
        self.region()
    }

    fn quality(&self) -> u32 {
        CRITREG_NO_QUALITY
    }

    fn why(&self) -> Why {
        match self.region() {
            Ok(_) => Why::Explained,
            // It does not know more.
            Err(_) => Why::Unexplained {
                samples: self.observations().len() as u32,
                examples: [None; 3],
            },
        }
    }

    fn left_out(&self, _: &Domain<'_>) -> Option<LeftOut> {
        // It counts hypotheses instead.
        None
    }

    fn evidence(&self) -> &[Evidence] {
        &[]
    }

    fn choose_instances(
        &mut self,
        _domain: &Domain<'_>,
        _offered: usize,
        _make: &mut dyn FnMut(usize, &mut [f64]) -> Fallible,
        _chosen: &mut [f64],
    ) -> Fallible<usize> {
        Err(Failure::invalid(
            "this learner does not choose instances: use CRITREG_VERSION_SPACE",
        ))
    }
}

impl<R: Real> AnyLearner for VersionSpace<'_, R> {
    fn report(&self) -> critreg_report {
        critreg_report::of_version_space(self)
    }

    fn best_region(&self) -> Result<&Region, Error> {
        VersionSpace::best_region(self)
    }

    fn quality(&self) -> u32 {
        number(VersionSpace::quality(self))
    }

    fn why(&self) -> Why {
        VersionSpace::why(self)
    }

    fn left_out(&self, domain: &Domain<'_>) -> Option<LeftOut> {
        VersionSpace::left_out(self, domain)
    }

    fn evidence(&self) -> &[Evidence] {
        VersionSpace::evidence(self)
    }

    fn choose_instances(
        &mut self,
        domain: &Domain<'_>,
        offered: usize,
        make: &mut dyn FnMut(usize, &mut [f64]) -> Fallible,
        chosen: &mut [f64],
    ) -> Fallible<usize> {
        VersionSpace::choose_instances(self, domain, offered, make, chosen)
    }
}
