//! Drawing parameters from a grounded region.

use super::Theta;
use super::ground::{Grounded, Vector, to_theta};
use super::interval::IntervalSet;
use crate::domain::MAX_PARAMETERS;
use crate::error::Error;
use crate::random::uniform;
use crate::real::Real;
use rand_core::Rng;

/// Draws from the whole box, and from one line, before another way is tried.
const REJECTIONS: usize = 32;
/// Lines through the box on which a first admitted point is looked for.
const LINES: usize = 128;
/// Steps of hit-and-run per parameter, from a first admitted point.
const STEPS_PER_PARAMETER: usize = 12;
/// How often the box may be halved to prove it empty.
const HALVINGS: u32 = 10;

impl<R: Real> Grounded<'_, R> {
    /// Draws parameters that the region admits.
    ///
    /// One parameter: uniform over the exact intervals. Several: 32 uniform draws
    /// from the box; if the region is too small for those, hit-and-run (Smith
    /// 1984) along exact slices, which tends to uniform. What comes back always
    /// satisfies [`Grounded::contains`].
    ///
    /// # Errors
    /// [`Error::EmptyRegion`] if it is proven that nothing is admitted: drop the
    /// plan skeleton, or fall back on another sampler. [`Error::NoSample`] if
    /// nothing was found but emptiness could not be proven.
    pub fn sample(&self, rng: &mut (impl Rng + ?Sized)) -> Result<Theta, Error> {
        let found = match self.parameters() {
            [] => self
                .admits(&[R::ZERO; MAX_PARAMETERS])?
                .then_some([R::ZERO; MAX_PARAMETERS]),
            [_] => {
                let set = self.intervals()?;
                if set.is_empty() {
                    return Err(Error::EmptyRegion);
                }
                let along = |t| {
                    let mut theta = [R::ZERO; MAX_PARAMETERS];
                    let [first, ..] = &mut theta;
                    *first = t;
                    theta
                };
                self.draw_from(&set, along, rng)?
            }
            _ => self.sample_several(rng)?,
        };
        match found {
            Some(theta) => Ok(to_theta(&theta)),
            None if self.is_proven_empty()? => Err(Error::EmptyRegion),
            None => Err(Error::NoSample),
        }
    }

    /// Whether it is proven that no parameters are admitted. With one parameter
    /// and constraints in closed form the answer is exact; else `false` may mean
    /// that the proof was not found.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`].
    pub fn is_proven_empty(&self) -> Result<bool, Error> {
        if self.parameters().len() == 1 {
            return Ok(self.intervals()?.is_empty());
        }
        let (low, high) = self.bounds();
        self.prove_empty(low, high, HALVINGS)
    }

    fn prove_empty(&self, low: Vector<R>, high: Vector<R>, halvings: u32) -> Result<bool, Error> {
        if self.excludes(&low, &high)? {
            return Ok(true);
        }
        // Halve each parameter in turn.
        let count = self.parameters().len();
        let Some(turn) = (halvings as usize).checked_rem(count) else {
            return Ok(false);
        };
        if halvings == 0 {
            return Ok(false);
        }
        let (mut left_high, mut right_low) = (high, low);
        let middle = left_high.iter_mut().zip(&mut right_low).nth(turn);
        if let Some((high, low)) = middle {
            let half = *low + (*high - *low) * R::from_f64(0.5);
            *high = half;
            *low = half;
        }
        Ok(self.prove_empty(low, left_high, halvings - 1)?
            && self.prove_empty(right_low, high, halvings - 1)?)
    }

    /// A uniform position of a set along a line that is truly admitted: at the
    /// ends rounding may decide otherwise, and a constraint without closed form
    /// may object.
    fn draw_from(
        &self,
        set: &IntervalSet<R>,
        along: impl Fn(R) -> Vector<R>,
        rng: &mut (impl Rng + ?Sized),
    ) -> Result<Option<Vector<R>>, Error> {
        for _ in 0..REJECTIONS {
            let Some(t) = set.quantile(R::from_f64(uniform(rng))) else {
                return Ok(None);
            };
            let theta = along(t);
            if self.admits(&theta)? {
                return Ok(Some(theta));
            }
        }
        let half = R::from_f64(0.5);
        for interval in set.intervals() {
            let theta = along(interval.low + interval.length() * half);
            if self.admits(&theta)? {
                return Ok(Some(theta));
            }
        }
        Ok(None)
    }

    fn sample_several(&self, rng: &mut (impl Rng + ?Sized)) -> Result<Option<Vector<R>>, Error> {
        for _ in 0..REJECTIONS {
            let theta = self.anywhere(rng);
            if self.admits(&theta)? {
                return Ok(Some(theta));
            }
        }
        for _ in 0..LINES {
            let through = self.anywhere(rng);
            if let Some(mut theta) = self.step(&through, rng)? {
                for _ in 0..STEPS_PER_PARAMETER * self.parameters().len() {
                    theta = self.step(&theta, rng)?.unwrap_or(theta);
                }
                return Ok(Some(theta));
            }
        }
        Ok(None)
    }

    /// Uniform in the box of all parameters.
    fn anywhere(&self, rng: &mut (impl Rng + ?Sized)) -> Vector<R> {
        let mut theta = [R::ZERO; MAX_PARAMETERS];
        for (value, p) in theta.iter_mut().zip(self.parameters()) {
            *value = R::from_f64(p.low + (p.high - p.low) * uniform(rng));
        }
        theta
    }

    /// An admitted point on a random line through a point.
    fn step(
        &self,
        through: &Vector<R>,
        rng: &mut (impl Rng + ?Sized),
    ) -> Result<Option<Vector<R>>, Error> {
        let mut direction = [R::ZERO; MAX_PARAMETERS];
        for (value, p) in direction.iter_mut().zip(self.parameters()) {
            *value = R::from_f64((p.high - p.low) * (2.0 * uniform(rng) - 1.0));
        }
        let (mut first, mut last) = (-R::INFINITY, R::INFINITY);
        let (low, high) = self.bounds();
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
        let set = self.slice(through, &direction, [first, last])?;
        let along = |t: R| {
            let mut theta = *through;
            let moved = theta.iter_mut().zip(&direction).zip(low.iter().zip(&high));
            for ((value, slope), (low, high)) in moved {
                *value = (*value + *slope * t).clamp(*low, *high);
            }
            theta
        };
        self.draw_from(&set, along, rng)
    }
}
