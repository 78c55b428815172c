//! Straight lines: parameters and positions along a line of parameters.

use super::Arithmetic;
use crate::real::Real;

/// `at + slope * t` for a position `t` on a line through the parameter space.
/// A slope that is not a number marks an unknown quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line<R> {
    /// Value at `t = 0`.
    pub at: R,
    /// Change with `t`.
    pub slope: R,
}

impl<R: Real> Line<R> {
    /// The value at `t`.
    pub fn value(&self, t: R) -> R {
        self.at + self.slope * t
    }
}

impl<R: Real> Arithmetic<R> for Line<R> {
    fn constant(value: R) -> Self {
        Line {
            at: value,
            slope: R::ZERO,
        }
    }
    fn unknown() -> Self {
        Line {
            at: R::unknown(),
            slope: R::unknown(),
        }
    }
    fn plus(self, other: Self) -> Self {
        Line {
            at: self.at + other.at,
            slope: self.slope + other.slope,
        }
    }
    fn minus(self, other: Self) -> Self {
        Line {
            at: self.at - other.at,
            slope: self.slope - other.slope,
        }
    }
    fn times(self, other: Self) -> Self {
        if other.slope == R::ZERO {
            self.scaled(other.at)
        } else if self.slope == R::ZERO {
            other.scaled(self.at)
        } else {
            Self::unknown()
        }
    }
    fn over(self, other: Self) -> Self {
        if other.slope == R::ZERO {
            Line {
                at: self.at / other.at,
                slope: self.slope / other.at,
            }
        } else {
            Self::unknown()
        }
    }
    fn scaled(self, factor: R) -> Self {
        Line {
            at: self.at * factor,
            slope: self.slope * factor,
        }
    }
    fn widened(self, _: R) -> Self {
        self
    }
}
