//! Drawing parameters from a grounded region, or from several at once.

use super::boxes::BoxSearch;
use super::ground::Grounded;
use super::interval::IntervalSet;
use super::lifted::Region;
use super::parameters::{ParameterSet, Theta, Vector, single};
use crate::domain::{Domain, MAX_PARAMETERS};
use crate::error::Error;
use crate::random::{Generator, uniform_real};
use crate::real::Real;
use rand_core::Rng;

/// How many draws are tried from the whole box, and from one line.
const REJECTIONS: usize = 32;
/// How many small boxes are searched for a first admitted point.
pub(super) const BOXES: usize = 64;
/// The same where another instance will do as well: what works may be no more than a point.
const FEW_BOXES: usize = 4;
/// How many lines are laid through each of them.
const LINES: usize = 8;
/// How many steps of hit-and-run follow a first admitted point, per parameter.
const STEPS_PER_PARAMETER: usize = 12;

impl Region {
    /// Draws parameters uniformly from the region in an instance.
    ///
    /// ```
    /// use critreg::{Error, domain::Domain, random::generator, region::Region};
    /// let domain = Domain::parse(
    ///     "object wall { x: length }
    ///      parameter reach in [0, 4]: length",
    /// )?;
    /// let region = Region::parse(&domain, "reach <= wall.x - 1")?;
    /// let draw = |wall: f64| region.sample::<f64>(&domain, &[wall], &mut generator(7));
    /// let [reach, ..] = draw(3.0)?;
    /// assert!((0.0..=2.0).contains(&reach));
    /// // A proof that the region admits nothing there.
    /// assert_eq!(draw(0.5), Err(Error::EmptyRegion));
    /// # Ok::<(), critreg::Error>(())
    /// ```
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
        grounded.compute()?;
        grounded.sample(rng)
    }

    /// As [`Region::sample`], but soon gives up with [`Error::NoSample`] where the region is so
    /// small that no draw is found: for those who have other instances.
    pub(crate) fn sample_soon<R: Real>(
        &self,
        domain: &Domain<'_>,
        instance: &[f64],
        rng: &mut Generator,
    ) -> Result<Theta, Error> {
        let mut grounded = Grounded::<R>::blank(self, domain, instance);
        grounded.compute()?;
        sample(&grounded, (R::ZERO, FEW_BOXES), rng)
    }

    /// Visits so many draws in one instance, fewer if there is none. Where the region is small
    /// they are places of one walk, which is how they are found at the price of a few; as
    /// [`Region::sample_soon`] it soon gives up.
    ///
    /// # Errors
    /// Those of [`Region::ground`].
    pub(crate) fn visit_draws<R: Real>(
        &self,
        domain: &Domain<'_>,
        instance: &[f64],
        count: usize,
        rng: &mut Generator,
        visit: &mut dyn FnMut(&Theta),
    ) -> Result<(), Error> {
        let mut grounded = Grounded::<R>::blank(self, domain, instance);
        grounded.compute()?;
        let mut at = None;
        for _ in 0..count {
            match draw_after(&grounded, &mut at, rng) {
                Ok(theta) => visit(&theta),
                Err(Error::EmptyRegion | Error::NoSample) => return Ok(()),
                Err(error) => return Err(error),
            }
        }
        Ok(())
    }
}

impl<R: Real> Grounded<'_, R> {
    /// Draws parameters that the region admits.
    ///
    /// One parameter: uniform over the exact intervals. Several: 32 uniform draws
    /// from the box; if the region is too small for those, hit-and-run (Smith
    /// 1984) along exact slices, which tends to uniform. What comes back always
    /// satisfies [`Grounded::contains`].
    ///
    /// # Errors
    /// [`Error::EmptyRegion`] if it is proven that no parameters are in the region here:
    /// postpone the plan skeleton, or fall back on another sampler. [`Error::NoSample`]
    /// if none were found but emptiness could not be proven.
    pub fn sample(&self, rng: &mut (impl Rng + ?Sized)) -> Result<Theta, Error> {
        sample(self, (R::ZERO, BOXES), rng)
    }

    /// Whether it is proven that no parameters are admitted. With one parameter
    /// and constraints in closed form the answer is exact; else `false` may mean
    /// that the proof was not found.
    ///
    /// # Errors
    /// Those of [`Region::ground`].
    pub fn is_proven_empty(&self) -> Result<bool, Error> {
        is_proven_empty(self)
    }
}

/// Draws parameters of a set; see [`Grounded::sample`]. The share `margin` at both
/// ends of each interval along a line is left out; where what is admitted is small it is looked
/// for in so many boxes.
pub(super) fn sample<R: Real>(
    set: &impl ParameterSet<R>,
    (margin, boxes): (R, usize),
    rng: &mut (impl Rng + ?Sized),
) -> Result<Theta, Error> {
    let found = match set.count() {
        0 | 1 if is_proven_empty(set)? => return Err(Error::EmptyRegion),
        0 => [R::ZERO; MAX_PARAMETERS],
        1 => draw_from(set, set.set(), single, margin, rng)?.ok_or(Error::NoSample)?,
        _ => sample_several(set, (margin, boxes), rng)?.ok_or(Error::NoSample)?,
    };
    Ok(in_range(set, &found))
}

/// As [`sample`], but where a walk has begun `at` some place it goes on there, and it begins where
/// there is no other way.
fn draw_after<R: Real>(
    set: &impl ParameterSet<R>,
    at: &mut Option<Vector<R>>,
    rng: &mut (impl Rng + ?Sized),
) -> Result<Theta, Error> {
    if set.count() < 2 {
        return sample(set, (R::ZERO, FEW_BOXES), rng);
    }
    let next = match at {
        Some(at) => step(set, at, R::ZERO, rng)?.unwrap_or(*at),
        None => match draw_from_box(set, rng)? {
            Some(theta) => return Ok(in_range(set, &theta)),
            None => begin_walk(set, (R::ZERO, FEW_BOXES), rng)?.ok_or(Error::NoSample)?,
        },
    };
    *at = Some(next);
    Ok(in_range(set, &next))
}

/// Parameters that were found. In single precision, an end of the range may be beyond it.
fn in_range<R: Real>(set: &impl ParameterSet<R>, found: &Vector<R>) -> Theta {
    let mut theta = [0.0; MAX_PARAMETERS];
    for ((value, found), parameter) in theta.iter_mut().zip(found).zip(set.parameters()) {
        *value = Real::clamp(found.to_f64(), parameter.low, parameter.high);
    }
    theta
}

/// Whether it is proven that a set has no parameters; see
/// [`Grounded::is_proven_empty`].
pub(super) fn is_proven_empty<R: Real>(set: &impl ParameterSet<R>) -> Result<bool, Error> {
    match set.count() {
        0 => Ok(!set.admits(&[R::ZERO; MAX_PARAMETERS])?),
        1 => Ok(set.set().is_empty()),
        _ => {
            let mut search = BoxSearch::new(0);
            Ok(search.next(set)?.is_none() && search.is_complete())
        }
    }
}

/// A uniform position of a set along a line that is truly admitted: near the
/// ends rounding may decide otherwise, and a constraint without closed form
/// may object anywhere.
fn draw_from<R: Real>(
    parameters: &impl ParameterSet<R>,
    set: &IntervalSet<R>,
    along: impl Fn(R) -> Vector<R>,
    margin: R,
    rng: &mut (impl Rng + ?Sized),
) -> Result<Option<Vector<R>>, Error> {
    for _ in 0..REJECTIONS {
        let Some(t) = set.quantile_inside(uniform_real(rng), margin) else {
            return Ok(None);
        };
        let theta = along(t);
        if parameters.admits(&theta)? {
            return Ok(Some(theta));
        }
    }
    let half = R::from_f64(0.5);
    for interval in set.intervals() {
        let theta = along(interval.low.towards(interval.high, half));
        if parameters.admits(&theta)? {
            return Ok(Some(theta));
        }
    }
    Ok(None)
}

/// Not inlined, so that its variables are not on the stack while a set is grounded.
#[inline(never)]
fn sample_several<R: Real>(
    parameters: &impl ParameterSet<R>,
    (margin, boxes): (R, usize),
    rng: &mut (impl Rng + ?Sized),
) -> Result<Option<Vector<R>>, Error> {
    if let Some(theta) = draw_from_box(parameters, rng)? {
        let inner = match margin > R::ZERO {
            true => step(parameters, &theta, margin, rng)?,
            false => None,
        };
        return Ok(inner.or(Some(theta)));
    }
    let Some(mut theta) = begin_walk(parameters, (margin, boxes), rng)? else {
        return Ok(None);
    };
    for _ in 0..STEPS_PER_PARAMETER * parameters.count() {
        theta = step(parameters, &theta, margin, rng)?.unwrap_or(theta);
    }
    Ok(Some(theta))
}

/// An admitted point among some that are uniform in the box of all parameters.
fn draw_from_box<R: Real>(
    parameters: &impl ParameterSet<R>,
    rng: &mut (impl Rng + ?Sized),
) -> Result<Option<Vector<R>>, Error> {
    let (low, high) = parameters.bounds();
    for _ in 0..REJECTIONS {
        let theta = inside(parameters.count(), &low, &high, rng);
        if parameters.admits(&theta)? {
            return Ok(Some(theta));
        }
    }
    Ok(None)
}

/// A first admitted point of a set that is too small to be hit by chance: finds small boxes that
/// may hold some of it, in random order, and lays lines through them.
#[inline(never)]
fn begin_walk<R: Real>(
    parameters: &impl ParameterSet<R>,
    (margin, boxes): (R, usize),
    rng: &mut (impl Rng + ?Sized),
) -> Result<Option<Vector<R>>, Error> {
    let mut search = BoxSearch::new(rng.next_u32());
    for _ in 0..boxes {
        let Some((low, high)) = search.next(parameters)? else {
            break;
        };
        for _ in 0..LINES {
            let through = inside(parameters.count(), &low, &high, rng);
            if let Some(theta) = step(parameters, &through, margin, rng)? {
                return Ok(Some(theta));
            }
        }
    }
    if search.found_nothing() {
        return Err(Error::EmptyRegion);
    }
    Ok(None)
}

/// Uniform in a box.
fn inside<R: Real>(
    count: usize,
    low: &Vector<R>,
    high: &Vector<R>,
    rng: &mut (impl Rng + ?Sized),
) -> Vector<R> {
    let mut theta = *low;
    for (value, high) in theta.iter_mut().zip(high).take(count) {
        *value = value.towards(*high, uniform_real(rng));
    }
    theta
}

/// An admitted point on a random line through a point.
fn step<R: Real>(
    parameters: &impl ParameterSet<R>,
    through: &Vector<R>,
    margin: R,
    rng: &mut (impl Rng + ?Sized),
) -> Result<Option<Vector<R>>, Error> {
    let mut direction = [R::ZERO; MAX_PARAMETERS];
    let (low, high) = parameters.bounds();
    let sizes = low.iter().zip(&high).take(parameters.count());
    for (value, (low, high)) in direction.iter_mut().zip(sizes) {
        *value = (*high - *low) * {
            let share: R = uniform_real(rng);
            share + share - R::ONE
        };
    }
    let (mut first, mut last) = (-R::INFINITY, R::INFINITY);
    let ranges = low.iter().zip(&high).zip(through.iter().zip(&direction));
    for ((low, high), (at, slope)) in ranges {
        if *slope != R::ZERO {
            let (a, b) = ((*low - *at) / *slope, (*high - *at) / *slope);
            first = first.max(a.min(b));
            last = last.min(a.max(b));
        }
    }
    if !(first.is_finite() && last.is_finite() && first < last) {
        return Ok(None);
    }
    let mut set = IntervalSet::default();
    parameters.slice([through, &direction], [first, last], &mut set)?;
    let along = |t: R| {
        let mut theta = *through;
        let moved = theta.iter_mut().zip(&direction).zip(low.iter().zip(&high));
        for ((value, slope), (low, high)) in moved {
            *value = (*value + *slope * t).clamp(*low, *high);
        }
        theta
    };
    draw_from(parameters, &set, along, margin, rng)
}
