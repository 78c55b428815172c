//! Action-feasibility regions: which parameters of an action work in an instance.
//!
//! A [`Region`] is lifted: its constraints speak of objects and points, not of
//! numbers. [`Region::ground`] puts an instance in; the [`Grounded`] region is a
//! set of parameters. With one parameter it is a set of intervals in closed form,
//! because every constraint of the grammar is a piecewise linear function or the
//! root of a quadratic one along a line of parameters; with several, any line
//! through it is. Sampling is uniform, see [`Grounded::sample`]. An [`Intersection`]
//! is what several regions admit at once.

mod boxes;
mod bytes;
mod gaps;
mod ground;
mod intersection;
mod interval;
mod parameters;
mod sample;
mod slice;

pub use bytes::SavedRegion;
pub use ground::Grounded;
pub use intersection::{Intersection, Part};
pub use interval::{Interval, IntervalSet, MAX_INTERVALS};

use crate::domain::{Domain, MAX_PARAMETERS, PointSet};
use crate::error::Error;
use crate::grammar::Formula;
use crate::real::Real;
use core::fmt;
use rand_core::Rng;

/// Values of the parameters of an action, in order of declaration. Entries
/// behind the last parameter are zero.
pub type Theta = [f64; MAX_PARAMETERS];

/// The parameters with which an action is expected to work, as readable
/// constraints over a domain (thesis Eq. 4.13).
///
/// ```
/// use critreg::{domain::Domain, random::generator, region::Region};
/// let domain = Domain::parse(
///     "object stick { x: length, y: length, theta: angle }
///      constant stick.width = 3.0: length
///      parameter mu in [0, 1]
///      point grasp = stick + (mu * stick.width, 0)",
/// )?;
/// let region = Region::parse(&domain, "grasp.y <= 2.9")?;
/// let instance = [2.0, 1.4, core::f64::consts::FRAC_PI_2];
/// let grounded = region.ground::<f64>(&domain, &instance)?;
/// let set = grounded.intervals()?;
/// assert!((set.length() - 0.5).abs() < 1e-12);
/// let [mu, ..] = grounded.sample(&mut generator(7))?;
/// assert!(mu <= 0.5);
/// # Ok::<(), critreg::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Region {
    formula: Formula,
    points: PointSet,
    /// A bit for each parameter that the formula depends on.
    relevant: u32,
    fingerprint: u32,
}

impl Default for Region {
    /// A place for a region: it admits everything, and belongs to a domain without text.
    fn default() -> Self {
        Region {
            formula: Formula::everything(),
            points: PointSet::default(),
            relevant: 0,
            fingerprint: 0,
        }
    }
}

impl Region {
    /// The region of the samples for which `formula` holds.
    pub fn new(domain: &Domain<'_>, formula: Formula) -> Region {
        let points = PointSet::of(domain, formula.nodes());
        Region {
            points,
            relevant: points.parameters(domain, formula.nodes()),
            fingerprint: domain.fingerprint(),
            formula,
        }
    }

    /// Makes it a region of this domain that admits everything.
    pub(crate) fn clear(&mut self, domain: &Domain<'_>) {
        self.formula.clear();
        self.settle(domain);
    }

    /// Replaces its formula where it lies by what `write` makes of one that holds for
    /// every sample.
    pub(crate) fn rewrite(&mut self, domain: &Domain<'_>, write: impl FnOnce(&mut Formula)) {
        self.formula.clear();
        write(&mut self.formula);
        self.settle(domain);
    }

    /// Makes it the same as another, where it lies.
    pub fn copy_from(&mut self, other: &Region) {
        self.formula.copy_from(&other.formula);
        self.points = other.points;
        self.relevant = other.relevant;
        self.fingerprint = other.fingerprint;
    }

    /// Finds out what its formula speaks about.
    fn settle(&mut self, domain: &Domain<'_>) {
        self.points = PointSet::of(domain, self.formula.nodes());
        self.relevant = self.points.parameters(domain, self.formula.nodes());
        self.fingerprint = domain.fingerprint();
    }

    /// Reads a region from its text; for the grammar see [`Formula`].
    ///
    /// # Errors
    /// [`Error::Syntax`], [`Error::CapacityExceeded`].
    pub fn parse(domain: &Domain<'_>, text: &str) -> Result<Region, Error> {
        Ok(Region::new(domain, Formula::parse(domain, text)?))
    }

    /// Writes its text; reading that gives the same region.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write(&self, domain: &Domain<'_>, out: &mut dyn fmt::Write) -> fmt::Result {
        self.formula.write(domain, out)
    }

    /// Its constraints and connectives.
    pub fn formula(&self) -> &Formula {
        &self.formula
    }

    /// Whether a number of an instance, by its place, counts for the region. If not, it
    /// may be anything.
    pub fn reads(&self, domain: &Domain<'_>, slot: u8) -> bool {
        self.points.reads(domain, self.formula.nodes(), slot)
    }

    /// The region in a problem instance: one number per attribute.
    ///
    /// # Errors
    /// [`Error::Mismatch`] for another domain than the region was made for, and
    /// those of [`Domain::check_instance`].
    pub fn ground<'a, R: Real>(
        &'a self,
        domain: &'a Domain<'a>,
        instance: &'a [f64],
    ) -> Result<Grounded<'a, R>, Error> {
        Grounded::new(self, domain, instance)
    }

    /// Whether an action with these parameters is expected to work.
    ///
    /// # Errors
    /// Those of [`Region::ground`] and [`Grounded::contains`].
    pub fn contains<R: Real>(
        &self,
        domain: &Domain<'_>,
        instance: &[f64],
        theta: &[f64],
    ) -> Result<bool, Error> {
        let mut grounded = Grounded::<R>::blank(self, domain, instance);
        grounded.settle()?;
        grounded.contains(theta)
    }

    /// Draws parameters uniformly from the region in an instance.
    ///
    /// # Errors
    /// Those of [`Region::ground`] and [`Grounded::sample`].
    pub fn sample<R: Real>(
        &self,
        domain: &Domain<'_>,
        instance: &[f64],
        rng: &mut (impl Rng + ?Sized),
    ) -> Result<Theta, Error> {
        let mut grounded = Grounded::<R>::blank(self, domain, instance);
        grounded.settle()?;
        grounded.sample(rng)
    }
}
