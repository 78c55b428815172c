//! The scalar of the library: `f64`, `f32`, or (feature `micromath`) `Fast32`.
//!
//! Transcendental functions come from `libm` on every target, or from here, never
//! from the platform's C library: the same inputs give the same bytes on a
//! workstation and on a microcontroller. `num-traits` was not used because Cargo's feature
//! unification can silently switch it to `std`'s maths.

mod dual;
mod sine;

pub use dual::Dual;

use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// A real number the library can compute with.
///
/// ```
/// use critreg::real::Real;
/// fn hypotenuse<R: Real>(a: R, b: R) -> R { (a * a + b * b).sqrt() }
/// assert_eq!(hypotenuse(3.0_f64, 4.0), 5.0);
/// assert_eq!(hypotenuse(3.0_f32, 4.0), 5.0);
/// ```
pub trait Real:
    Copy
    + PartialEq
    + PartialOrd
    + Debug
    + Default
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + 'static
{
    /// Its name, to tell apart what was saved.
    const NAME: &'static str;
    /// How many bits it takes: in saved bytes, what is computed with.
    const BITS: u16;
    /// The additive identity.
    const ZERO: Self;
    /// The multiplicative identity.
    const ONE: Self;
    /// Positive infinity.
    const INFINITY: Self;
    /// Negative infinity.
    const NEG_INFINITY: Self;
    /// Not a number.
    const NAN: Self;
    /// The distance from one to the next larger number.
    const EPSILON: Self;
    /// The square root of that: half of the digits.
    const SQRT_EPSILON: Self;
    /// Numbers up to here have squares and products of which a few can be added.
    const LARGE: Self;

    /// The nearest value of this type.
    fn from_f64(value: f64) -> Self;
    /// A share of 2^53, which is below one unless it is rounded up to it.
    fn from_share(share: u64) -> Self;
    /// The value as `f64`, exactly.
    fn to_f64(self) -> f64;
    /// Square root; NaN for negative numbers.
    fn sqrt(self) -> Self;
    /// Sine and cosine of an angle in radians.
    fn sin_cos(self) -> (Self, Self);
    /// The angle of the vector (`x`, `self`) in radians, in `[-pi, pi]`.
    fn atan2(self, x: Self) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;
    /// The largest integer not above the value.
    fn floor(self) -> Self;
    /// Neither NaN nor infinite.
    fn is_finite(self) -> bool;

    /// Whether this type has a number near a value, or the value is none.
    fn holds(value: f64) -> bool {
        !value.is_finite() || Self::from_f64(value).is_finite()
    }

    /// The smaller of two numbers; `self` if they cannot be ordered.
    fn min(self, other: Self) -> Self {
        if other < self { other } else { self }
    }
    /// The larger of two numbers; `self` if they cannot be ordered.
    fn max(self, other: Self) -> Self {
        if other > self { other } else { self }
    }
    /// The value moved into `[low, high]`.
    fn clamp(self, low: Self, high: Self) -> Self {
        self.max(low).min(high)
    }
    /// The number at a share of the way from this one to another, also where they are farther
    /// apart than any number is large.
    fn towards(self, other: Self, share: Self) -> Self {
        let way = other - self;
        match way.is_finite() {
            true => self + way * share,
            false => self * (Self::ONE - share) + other * share,
        }
    }
    /// An angle moved by whole turns into `[-pi, pi]`.
    fn wrap_angle(self) -> Self {
        let turn = Self::from_f64(core::f64::consts::TAU);
        let half = Self::from_f64(0.5);
        self - turn * (self / turn + half).floor()
    }
}

impl Real for f64 {
    const NAME: &'static str = "f64";
    const BITS: u16 = 64;
    const ZERO: f64 = 0.0;
    const ONE: f64 = 1.0;
    const INFINITY: f64 = f64::INFINITY;
    const NEG_INFINITY: f64 = f64::NEG_INFINITY;
    const NAN: f64 = f64::NAN;
    const EPSILON: f64 = f64::EPSILON;
    const SQRT_EPSILON: f64 = 1.0 / 67_108_864.0;
    const LARGE: f64 = 1e150;

    fn from_f64(value: f64) -> f64 {
        value
    }
    fn from_share(share: u64) -> f64 {
        share as f64 * (1.0 / 9_007_199_254_740_992.0)
    }
    fn to_f64(self) -> f64 {
        self
    }
    fn sqrt(self) -> f64 {
        libm::sqrt(self)
    }
    fn sin_cos(self) -> (f64, f64) {
        libm::sincos(self)
    }
    fn atan2(self, x: f64) -> f64 {
        libm::atan2(self, x)
    }
    fn abs(self) -> f64 {
        libm::fabs(self)
    }
    fn floor(self) -> f64 {
        libm::floor(self)
    }
    fn is_finite(self) -> bool {
        f64::is_finite(self)
    }
}

impl Real for f32 {
    const NAME: &'static str = "f32";
    const BITS: u16 = 32;
    const ZERO: f32 = 0.0;
    const ONE: f32 = 1.0;
    const INFINITY: f32 = f32::INFINITY;
    const NEG_INFINITY: f32 = f32::NEG_INFINITY;
    const NAN: f32 = f32::NAN;
    const EPSILON: f32 = f32::EPSILON;
    const SQRT_EPSILON: f32 = 3.452_669_8e-4;
    const LARGE: f32 = 1e18;

    fn from_f64(value: f64) -> f32 {
        value as f32
    }
    /// The same as the nearest to that of `f64`, because a power of two is divided by.
    fn from_share(share: u64) -> f32 {
        share as f32 * (1.0 / 9_007_199_254_740_992.0)
    }
    fn to_f64(self) -> f64 {
        f64::from(self)
    }
    fn sqrt(self) -> f32 {
        libm::sqrtf(self)
    }
    fn sin_cos(self) -> (f32, f32) {
        sine::sin_cos(self)
    }
    fn atan2(self, x: f32) -> f32 {
        libm::atan2f(self, x)
    }
    fn abs(self) -> f32 {
        libm::fabsf(self)
    }
    fn floor(self) -> f32 {
        libm::floorf(self)
    }
    fn is_finite(self) -> bool {
        f32::is_finite(self)
    }
}

#[cfg(feature = "micromath")]
pub use fast::Fast32;

#[cfg(feature = "micromath")]
mod fast {
    use super::Real;
    use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};
    use micromath::F32;

    /// An `f32` whose sine, cosine and arc tangent are micromath's approximations:
    /// smaller, and good to about three digits. A type of its own, so that one program
    /// can hold both.
    #[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
    pub struct Fast32(pub f32);

    macro_rules! arithmetic {
        ($($operator:ident $method:ident),*) => {$(
            impl $operator for Fast32 {
                type Output = Fast32;
                fn $method(self, other: Fast32) -> Fast32 {
                    Fast32($operator::$method(self.0, other.0))
                }
            }
        )*};
    }
    arithmetic!(Add add, Sub sub, Mul mul, Div div);

    impl Neg for Fast32 {
        type Output = Fast32;
        fn neg(self) -> Fast32 {
            Fast32(-self.0)
        }
    }
    impl AddAssign for Fast32 {
        fn add_assign(&mut self, other: Fast32) {
            self.0 += other.0;
        }
    }
    impl SubAssign for Fast32 {
        fn sub_assign(&mut self, other: Fast32) {
            self.0 -= other.0;
        }
    }

    impl Real for Fast32 {
        const NAME: &'static str = "fast32";
        const BITS: u16 = 32;
        const ZERO: Fast32 = Fast32(0.0);
        const ONE: Fast32 = Fast32(1.0);
        const INFINITY: Fast32 = Fast32(f32::INFINITY);
        const NEG_INFINITY: Fast32 = Fast32(f32::NEG_INFINITY);
        const NAN: Fast32 = Fast32(f32::NAN);
        const EPSILON: Fast32 = Fast32(f32::EPSILON);
        const SQRT_EPSILON: Fast32 = Fast32(<f32 as Real>::SQRT_EPSILON);
        const LARGE: Fast32 = Fast32(<f32 as Real>::LARGE);

        fn from_f64(value: f64) -> Fast32 {
            Fast32(value as f32)
        }
        fn from_share(share: u64) -> Fast32 {
            Fast32(f32::from_share(share))
        }
        fn to_f64(self) -> f64 {
            f64::from(self.0)
        }
        fn sqrt(self) -> Fast32 {
            // Micromath halves the exponent, which is up to 6% off, too much for a
            // distance. Two steps of Newton's method leave 2e-6.
            let better = |root: f32| 0.5 * (root + self.0 / root);
            Fast32(better(better(F32(self.0).sqrt().0)))
        }
        fn sin_cos(self) -> (Fast32, Fast32) {
            (Fast32(F32(self.0).sin().0), Fast32(F32(self.0).cos().0))
        }
        fn atan2(self, x: Fast32) -> Fast32 {
            Fast32(F32(self.0).atan2(F32(x.0)).0)
        }
        fn abs(self) -> Fast32 {
            Fast32(libm::fabsf(self.0))
        }
        fn floor(self) -> Fast32 {
            Fast32(libm::floorf(self.0))
        }
        fn is_finite(self) -> bool {
            self.0.is_finite()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Real;
    use core::f64::consts::PI;

    #[test]
    fn the_root_of_epsilon_is_its_root() {
        assert_eq!(<f64 as Real>::SQRT_EPSILON, Real::sqrt(f64::EPSILON));
        assert_eq!(<f32 as Real>::SQRT_EPSILON, Real::sqrt(f32::EPSILON));
    }

    #[test]
    fn angles_wrap_into_half_open_turn() {
        for (angle, wrapped) in [(0.0, 0.0), (1.5 * PI, -0.5 * PI), (-1.5 * PI, 0.5 * PI)] {
            assert!((Real::wrap_angle(angle) - wrapped).abs() < 1e-12, "{angle}");
        }
        assert!(f64::NAN.wrap_angle().is_nan());
    }
}
