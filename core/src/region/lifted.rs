//! Regions before an instance is known: constraints that speak of objects and points.

use crate::domain::{Domain, Node, PointSet, held};
use crate::error::Error;
use crate::grammar::Formula;
use crate::real::Real;
use crate::table::Blank;
use core::fmt;

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
    pub(super) formula: Formula,
    pub(super) points: PointSet,
    /// A bit for each parameter that the formula depends on.
    pub(super) relevant: u32,
    pub(super) fingerprint: u32,
}

impl Blank for Region {
    /// A region that admits everything, of a domain without text: a place for another one.
    const BLANK: Self = Region {
        formula: Formula::everything(),
        points: PointSet::EMPTY,
        relevant: 0,
        fingerprint: 0,
    };
}

impl Default for Region {
    fn default() -> Self {
        Region::BLANK
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
        self.note_dependence(domain);
    }

    /// Lets `write` make a new formula in place, from one that holds for every sample.
    pub(crate) fn rewrite(&mut self, domain: &Domain<'_>, write: impl FnOnce(&mut Formula)) {
        self.formula.clear();
        write(&mut self.formula);
        self.note_dependence(domain);
    }

    /// Copies another region into this one, in place.
    pub fn copy_from(&mut self, other: &Region) {
        self.formula.copy_from(&other.formula);
        self.points = other.points;
        self.relevant = other.relevant;
        self.fingerprint = other.fingerprint;
    }

    /// Checks that it is a region of a domain.
    ///
    /// # Errors
    /// [`Error::Mismatch`].
    pub(super) fn check_domain(&self, domain: &Domain<'_>) -> Result<(), Error> {
        match domain.fingerprint() == self.fingerprint {
            true => Ok(()),
            false => Err(Error::Mismatch("the region belongs to another domain text")),
        }
    }

    /// Notes what its formula depends on: points, parameters and the domain.
    fn note_dependence(&mut self, domain: &Domain<'_>) {
        self.points = PointSet::of(domain, self.formula.nodes());
        self.relevant = self.points.parameters(domain, self.formula.nodes());
        self.fingerprint = domain.fingerprint();
    }

    /// Reads a region from its text; for the grammar see [`Formula`].
    ///
    /// ```
    /// use critreg::{domain::Domain, region::Region};
    /// let domain = Domain::parse("parameter x in [0, 1] parameter y in [0, 1]")?;
    /// let region = Region::parse(&domain, "(x < 0.5) and (y > x or not (y <= 0.25))")?;
    /// let text = region.display(&domain).to_string();
    /// assert_eq!(text, "x < 0.5 and (y > x or not y <= 0.25)");
    /// let error = Region::parse(&domain, "x < 0.5 and z > 0").unwrap_err();
    /// assert!(error.to_string().starts_with("line 1, column 13: unknown name"));
    /// # Ok::<(), critreg::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Syntax`], [`Error::CapacityExceeded`].
    pub fn parse(domain: &Domain<'_>, text: &str) -> Result<Region, Error> {
        let mut region = Region::default();
        region.read(domain, text)?;
        Ok(region)
    }

    /// As [`Region::parse`], in place: regions are large.
    ///
    /// # Errors
    /// Those of [`Region::parse`]. After one it is no region of any use.
    pub fn read(&mut self, domain: &Domain<'_>, text: &str) -> Result<(), Error> {
        self.formula.read(domain, text)?;
        self.note_dependence(domain);
        Ok(())
    }

    /// Writes its text; reading that gives the same region.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write(&self, domain: &Domain<'_>, out: &mut dyn fmt::Write) -> fmt::Result {
        self.formula.write(domain, out)
    }

    /// Its text, to be printed.
    pub fn display<'d>(&'d self, domain: &'d Domain<'d>) -> impl fmt::Display + 'd {
        struct Text<'d>(&'d Region, &'d Domain<'d>);
        impl fmt::Display for Text<'_> {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                self.0.write(self.1, f)
            }
        }
        Text(self, domain)
    }

    /// Checks that its numbers, and those of its domain, are some of the type that is
    /// computed with.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    pub fn check_precision<R: Real>(&self, domain: &Domain<'_>) -> Result<(), Error> {
        domain.check_precision::<R>()?;
        let numbers = self.formula.nodes().iter().map(|node| match node {
            Node::Number(value) => *value,
            _ => 0.0,
        });
        held::<R>(
            numbers,
            "a number of the region is larger than any of this precision",
        )
    }

    /// Its constraints and connectives.
    pub fn formula(&self) -> &Formula {
        &self.formula
    }

    /// Whether the region depends on a number of an instance, given by its place. If not,
    /// that number may be anything.
    pub fn reads(&self, domain: &Domain<'_>, slot: u8) -> bool {
        self.points.reads(domain, self.formula.nodes(), slot)
    }
}
