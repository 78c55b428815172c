//! Several regions at once: parameters that are good for an action and for those
//! that come after it.

use super::ground::Grounded;
use super::interval::IntervalSet;
use super::lifted::Region;
use super::parameters::{ParameterSet, Theta, Vector};
use super::sample::{BOXES, is_proven_empty, sample};
use crate::domain::{Domain, Parameter};
use crate::error::Error;
use crate::real::Real;
use rand_core::Rng;

/// A region and the instance to ground it in.
#[derive(Clone, Copy, Debug)]
pub struct Part<'a> {
    /// The region.
    pub region: &'a Region,
    /// Its domain.
    pub domain: &'a Domain<'a>,
    /// One number per attribute of the domain.
    pub instance: &'a [f64],
}

/// The parameters that several regions admit, each in an instance of its own: the
/// region of an action, and those in which the actions after it work.
///
/// The regions have the same parameters, in order and range. Everything else in their
/// domains may differ. Each region is grounded when it is needed, so an intersection of
/// any number of regions takes the memory of one.
///
/// ```
/// use critreg::{domain::Domain, random::generator, region::{Intersection, Part, Region}};
/// let reach = Domain::parse(
///     "object base { x: length, y: length }
///      parameter x in [0, 4]: length
///      point hand = world + (x, 0)",
/// )?;
/// let region = Region::parse(&reach, "dist(hand, base) <= 1")?;
/// let part = |instance| Part { region: &region, domain: &reach, instance };
///
/// let parts = [part(&[1.0, 0.0]), part(&[2.5, 0.0])];
/// let both = Intersection::<f64>::new(&parts)?;
/// let [x, ..] = both.sample(&mut generator(7))?;
/// assert!((1.5..=2.0).contains(&x));
///
/// let apart = [part(&[1.0, 0.0]), part(&[3.5, 0.0])];
/// assert!(Intersection::<f64>::new(&apart)?.is_proven_empty()?);
/// # Ok::<(), critreg::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Intersection<'p, R> {
    parts: &'p [Part<'p>],
    /// How many parameters the action has.
    count: usize,
    /// A bit for each parameter that a region depends on.
    relevant: u32,
    /// The corners of the box of all parameters.
    bounds: (Vector<R>, Vector<R>),
    /// The admitted values of the parameter, if there is exactly one.
    set: IntervalSet<R>,
}

impl<'p, R: Real> Intersection<'p, R> {
    /// The intersection of these regions.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] without any region, [`Error::Mismatch`] if the
    /// parameters of their actions differ in number or range, and those of
    /// [`Region::ground`].
    pub fn new(parts: &'p [Part<'p>]) -> Result<Self, Error> {
        let (first, rest) = parts
            .split_first()
            .ok_or(Error::InvalidArgument("an intersection needs a region"))?;
        let mut whole = {
            let grounded = first.ground::<R>()?;
            Intersection {
                parts,
                count: grounded.count(),
                relevant: grounded.relevant(),
                bounds: grounded.bounds(),
                set: grounded.set().clone(),
            }
        };
        rest.iter().try_for_each(|part| whole.narrow(part))?;
        Ok(whole)
    }

    fn narrow(&mut self, part: &Part<'_>) -> Result<(), Error> {
        let grounded = part.ground::<R>()?;
        if grounded.count() != self.count || grounded.bounds() != self.bounds {
            return Err(Error::Mismatch(
                "the regions of an intersection need the same parameters",
            ));
        }
        self.relevant |= grounded.relevant();
        self.set = self.set.intersection(grounded.set());
        Ok(())
    }

    /// Draws parameters that all regions admit, in the way of [`Grounded::sample`].
    ///
    /// # Errors
    /// [`Error::EmptyRegion`] if it is proven that there are none,
    /// [`Error::NoSample`] if none were found.
    pub fn sample(&self, rng: &mut (impl Rng + ?Sized)) -> Result<Theta, Error> {
        sample(self, (R::ZERO, BOXES), rng)
    }

    /// As [`Intersection::sample`], but away from the boundary, where an action may
    /// fail after all: the share `margin` in `[0, 0.5]` of every interval is left out
    /// at both of its ends; with several parameters, of every interval on some line.
    ///
    /// # Errors
    /// Those of [`Intersection::sample`], and [`Error::InvalidArgument`] for another
    /// margin.
    pub fn sample_inside(
        &self,
        margin: f64,
        rng: &mut (impl Rng + ?Sized),
    ) -> Result<Theta, Error> {
        if !(0.0..=0.5).contains(&margin) {
            return Err(Error::InvalidArgument("a margin is in [0, 0.5]"));
        }
        sample(self, (R::from_f64(margin), BOXES), rng)
    }

    /// Whether it is proven that no parameters are admitted; see
    /// [`Grounded::is_proven_empty`].
    ///
    /// # Errors
    /// Those of [`Region::ground`].
    pub fn is_proven_empty(&self) -> Result<bool, Error> {
        is_proven_empty(self)
    }

    /// Whether all regions admit these parameters; one number each.
    ///
    /// # Errors
    /// Those of [`Grounded::contains`].
    pub fn contains(&self, theta: &[f64]) -> Result<bool, Error> {
        self.all(|grounded| grounded.contains(theta))
    }

    fn all(&self, holds: impl Fn(&Grounded<'_, R>) -> Result<bool, Error>) -> Result<bool, Error> {
        for part in self.parts {
            if !holds(&part.ground()?)? {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

impl Part<'_> {
    fn ground<R: Real>(&self) -> Result<Grounded<'_, R>, Error> {
        self.region.ground(self.domain, self.instance)
    }
}

impl<R: Real> ParameterSet<R> for Intersection<'_, R> {
    fn parameters(&self) -> &[Parameter<'_>] {
        let first = self.parts.first();
        first.map_or(&[], |part| part.domain.parameters())
    }

    fn count(&self) -> usize {
        self.count
    }

    fn relevant(&self) -> u32 {
        self.relevant
    }

    fn bounds(&self) -> (Vector<R>, Vector<R>) {
        self.bounds
    }

    fn admits(&self, theta: &Vector<R>) -> Result<bool, Error> {
        let [first, ..] = theta;
        if self.count == 1 && self.set.is_exact() {
            return Ok(self.set.contains(*first));
        }
        self.all(|grounded| grounded.admits(theta))
    }

    fn set(&self) -> &IntervalSet<R> {
        &self.set
    }

    fn slice(
        &self,
        line: [&Vector<R>; 2],
        ends: [R; 2],
        set: &mut IntervalSet<R>,
    ) -> Result<(), Error> {
        let mut own = IntervalSet::default();
        for (index, part) in self.parts.iter().enumerate() {
            let grounded = part.ground()?;
            if index == 0 {
                grounded.slice(line, ends, set)?;
            } else {
                grounded.slice(line, ends, &mut own)?;
                *set = set.intersection(&own);
            }
        }
        Ok(())
    }

    fn excludes(&self, low: &Vector<R>, high: &Vector<R>) -> Result<bool, Error> {
        let may_hold = self.all(|grounded| Ok(!grounded.excludes(low, high)?))?;
        Ok(!may_hold)
    }
}
