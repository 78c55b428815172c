//! Dual numbers: whatever is computed with them is differentiated on the way.

use super::Real;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// A value and its derivative by one variable (forward differentiation, Wengert 1964).
///
/// They are ordered as if the variable had grown by next to nothing: by value, then by
/// slope. So a computation that compares takes the branch beyond the variable, and at a
/// kink the derivative is the one for a growing variable. A square root of zero and the
/// angle of no vector count as constant.
///
/// ```
/// use critreg::real::{Dual, Real};
/// let x = Dual { value: 3.0, slope: 1.0 };
/// assert_eq!((x * x).sqrt() * x, Dual { value: 9.0, slope: 6.0 });
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Dual<R> {
    /// The value.
    pub value: R,
    /// Its derivative.
    pub slope: R,
}

impl<R: Real> Dual<R> {
    /// What does not depend on the variable.
    pub const fn constant(value: R) -> Self {
        let slope = R::ZERO;
        Dual { value, slope }
    }

    /// The quotient of a slope, or zero where nothing is divided by.
    fn ratio(slope: R, by: R) -> R {
        match by == R::ZERO {
            true => R::ZERO,
            false => slope / by,
        }
    }
}

impl<R: Real> Add for Dual<R> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Dual {
            value: self.value + other.value,
            slope: self.slope + other.slope,
        }
    }
}

impl<R: Real> Sub for Dual<R> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Dual {
            value: self.value - other.value,
            slope: self.slope - other.slope,
        }
    }
}

impl<R: Real> Mul for Dual<R> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Dual {
            value: self.value * other.value,
            slope: self.slope * other.value + self.value * other.slope,
        }
    }
}

impl<R: Real> Div for Dual<R> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let slope = (self.slope - value * other.slope) / other.value;
        Dual { value, slope }
    }
}

impl<R: Real> Neg for Dual<R> {
    type Output = Self;
    fn neg(self) -> Self {
        Dual {
            value: -self.value,
            slope: -self.slope,
        }
    }
}

impl<R: Real> AddAssign for Dual<R> {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<R: Real> SubAssign for Dual<R> {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl<R: Real> Real for Dual<R> {
    const NAME: &'static str = "dual";
    const BITS: u16 = R::BITS;
    const ZERO: Self = Dual::constant(R::ZERO);
    const ONE: Self = Dual::constant(R::ONE);
    const INFINITY: Self = Dual::constant(R::INFINITY);
    const NEG_INFINITY: Self = Dual::constant(R::NEG_INFINITY);
    const NAN: Self = Dual::constant(R::NAN);
    const EPSILON: Self = Dual::constant(R::EPSILON);
    const SQRT_EPSILON: Self = Dual::constant(R::SQRT_EPSILON);
    const LARGE: Self = Dual::constant(R::LARGE);

    fn from_f64(value: f64) -> Self {
        Dual::constant(R::from_f64(value))
    }
    fn from_share(share: u64) -> Self {
        Dual::constant(R::from_share(share))
    }
    /// The value alone.
    fn to_f64(self) -> f64 {
        self.value.to_f64()
    }
    fn sqrt(self) -> Self {
        let value = self.value.sqrt();
        let slope = Dual::ratio(self.slope, value + value);
        Dual { value, slope }
    }
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        let of = |value: R, derivative: R| Dual {
            value,
            slope: derivative * self.slope,
        };
        (of(sin, cos), of(cos, -sin))
    }
    fn atan2(self, x: Self) -> Self {
        let square = self.value * self.value + x.value * x.value;
        let turned = x.value * self.slope - self.value * x.slope;
        Dual {
            value: self.value.atan2(x.value),
            slope: Dual::ratio(turned, square),
        }
    }
    fn abs(self) -> Self {
        if self < Self::ZERO { -self } else { self }
    }
    fn floor(self) -> Self {
        Dual::constant(self.value.floor())
    }
    fn is_finite(self) -> bool {
        self.value.is_finite() && self.slope.is_finite()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_are_what_differences_tend_to() {
        let functions: [fn(Dual<f64>) -> Dual<f64>; 7] = [
            |x| x * x - x / (x + Dual::ONE),
            |x| (x * x + Dual::ONE).sqrt(),
            |x| x.sin_cos().0 * x.sin_cos().1,
            |x| x.atan2(x * x),
            |x| (x - Dual::constant(5.0)).abs(),
            |x| x.max(x * x).min(Dual::constant(9.0)),
            |x| x - x.floor(),
        ];
        for (index, function) in functions.iter().enumerate() {
            for value in [0.3, 1.7, 2.6] {
                let at = |value: f64| function(Dual::constant(value)).value;
                let difference = (at(value + 1e-6) - at(value - 1e-6)) / 2e-6;
                let slope = function(Dual { value, slope: 1.0 }).slope;
                assert!((slope - difference).abs() < 1e-8, "{index} at {value}");
            }
        }
    }

    #[test]
    fn at_a_kink_the_variable_grows() {
        let zero = |slope| Dual { value: 0.0, slope };
        assert_eq!(zero(-2.0).abs(), zero(2.0));
        assert_eq!(zero(3.0).max(Dual::ZERO), zero(3.0));
        assert_eq!(zero(3.0).min(Dual::ZERO), Dual::ZERO);
        assert_eq!(zero(1.0).sqrt(), Dual::ZERO);
        assert_eq!(zero(1.0).atan2(Dual::ZERO), Dual::ZERO);
    }
}
