//! Many samples at once, in one instance.

use super::ground::Grounded;
use super::interval::Interval;
use super::parameters::{ParameterSet, Theta};
use crate::domain::Parameter;
use crate::error::Error;
use crate::real::Real;
use rand_core::Rng;

/// How many samples are looked at side by side: few enough to stay in the fastest memory.
const BLOCK: usize = 256;

impl<R: Real> Grounded<'_, R> {
    /// Whether the region admits each of many samples, whose parameters stand one behind
    /// the other; `inside` receives 1 or 0 for each. The answers are those of
    /// [`Grounded::contains`].
    ///
    /// # Errors
    /// Those of [`Grounded::contains`]; [`Error::InvalidArgument`] if `thetas` has not one
    /// number per sample and parameter. What `inside` holds is undefined then.
    pub fn contains_many(&self, thetas: &[f64], inside: &mut [u8]) -> Result<(), Error> {
        let parameters = self.parameters();
        if thetas.len() != inside.len().saturating_mul(parameters.len()) {
            return Err(Error::InvalidArgument(
                "many samples need one number per sample and parameter",
            ));
        }
        match (parameters, self.exact_set()) {
            ([], _) => inside.fill(u8::from(self.contains(&[])?)),
            ([parameter], Some(intervals)) => {
                for (values, inside) in thetas.chunks(BLOCK).zip(inside.chunks_mut(BLOCK)) {
                    if !values.iter().all(|value| value.is_finite()) {
                        return Err(Error::NotFinite("a parameter"));
                    }
                    note_members(intervals, parameter, values, inside);
                }
            }
            (all, _) => {
                for (theta, inside) in thetas.chunks(all.len()).zip(inside) {
                    *inside = u8::from(self.contains(theta)?);
                }
            }
        }
        Ok(())
    }

    /// Draws as many samples as there are places, and tells `write` each with its number:
    /// what as many calls of [`Grounded::sample`] draw.
    ///
    /// # Errors
    /// Those of [`Grounded::sample`], at the first draw that has none.
    pub fn sample_many(
        &self,
        count: usize,
        rng: &mut (impl Rng + ?Sized),
        mut write: impl FnMut(usize, &Theta),
    ) -> Result<(), Error> {
        for index in 0..count {
            write(index, &self.sample(rng)?);
        }
        Ok(())
    }
}

/// Which values of the only parameter are in one of the intervals. There is no branch that
/// depends on a value, so a compiler takes several of them at once.
fn note_members<R: Real>(
    intervals: &[Interval<R>],
    parameter: &Parameter<'_>,
    values: &[f64],
    inside: &mut [u8],
) {
    inside.fill(0);
    for Interval {
        low,
        high,
        low_closed,
        high_closed,
    } in intervals
    {
        for (inside, value) in inside.iter_mut().zip(values) {
            let t = R::from_f64(*value);
            let above = (t > *low) | ((t == *low) & *low_closed);
            let below = (t < *high) | ((t == *high) & *high_closed);
            *inside |= u8::from(above & below);
        }
    }
    // In single precision, an end of an interval may be beyond the range.
    for (inside, value) in inside.iter_mut().zip(values) {
        *inside &= u8::from((parameter.low <= *value) & (*value <= parameter.high));
    }
}
