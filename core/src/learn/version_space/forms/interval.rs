//! S of a form: the values that it has at the feasible samples.

use super::tolerance;
use crate::real::Real;
use crate::table::Blank;

/// The values of a form at the feasible samples of a step, from the least to the greatest
/// (S of the version space, Mitchell 1982).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval<R> {
    pub(super) low: R,
    pub(super) high: R,
}

impl<R: Real> Blank for Interval<R> {
    /// Of no sample.
    const BLANK: Self = Interval {
        low: R::INFINITY,
        high: R::NEG_INFINITY,
    };
}

impl<R: Real> Interval<R> {
    /// Grows to a value. Tells whether it lay outside, and whether above; what is no
    /// number does not.
    #[inline(always)]
    pub(super) fn include(&mut self, value: R) -> Option<bool> {
        if value < self.low {
            self.low = value;
            Some(false)
        } else if value > self.high {
            self.high = value;
            Some(true)
        } else {
            None
        }
    }

    /// Whether a value lies outside, on one side, by more than rounding: a form
    /// that is constant up to rounding explains nothing.
    #[inline(always)]
    pub(super) fn excludes(&self, value: R, upper: bool) -> bool {
        excludes(if upper { self.high } else { self.low }, value, upper)
    }
}

/// Whether a value lies beyond the end of S on one side, see [`Interval::excludes`].
#[inline(always)]
pub(super) fn excludes<R: Real>(end: R, value: R, upper: bool) -> bool {
    if upper {
        value - tolerance(value) > end
    } else {
        value + tolerance(value) < end
    }
}
