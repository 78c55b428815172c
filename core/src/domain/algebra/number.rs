//! Numbers: what a term is at one sample.

use super::{Algebra, Arithmetic, Measure, cross, dot};
use crate::domain::node::Extreme;
use crate::real::Real;

impl<R: Real> Arithmetic<R> for R {
    fn constant(value: R) -> R {
        value
    }
    fn unknown() -> R {
        R::NAN
    }
    fn plus(self, other: R) -> R {
        self + other
    }
    fn minus(self, other: R) -> R {
        self - other
    }
    fn times(self, other: R) -> R {
        self * other
    }
    fn over(self, other: R) -> R {
        self / other
    }
    fn widened(self, _: R) -> R {
        self
    }
}

impl<R: Real> Measure<R> for R {
    fn extreme(self, extreme: Extreme, other: R) -> R {
        extreme.of(self, other)
    }
    fn lower(&mut self, by: R) {
        *self -= by;
    }
}

impl<R: Real> Algebra<R> for R {
    type Measure = R;
    fn measure(self) -> R {
        self
    }
    fn norm([x, y, z]: [R; 3]) -> R {
        // One component: exact, and no square root. It is the common case.
        if y == R::ZERO && z == R::ZERO {
            return x.abs();
        }
        let squares = x * x + y * y + z * z;
        if squares.is_finite() {
            return squares.sqrt();
        }
        // The squares are too large for a number; the length need not be.
        let largest = x.abs().max(y.abs()).max(z.abs());
        let [x, y, z] = [x / largest, y / largest, z / largest];
        largest * (x * x + y * y + z * z).sqrt()
    }
    /// Well conditioned for every angle: the arc tangent of the lengths of the cross
    /// and the dot product.
    fn angle(a: [R; 3], b: [R; 3]) -> R {
        R::norm(cross(a, b)).atan2(dot(a, b))
    }
    fn folded(self, period: R) -> R {
        let half = R::from_f64(0.5);
        (self - period * (self / period + half).floor()).abs()
    }
    fn known(self) -> Option<R> {
        Some(self)
    }
    fn about(self) -> Option<(R, R)> {
        Some((self, R::ZERO))
    }
    fn length_of<const N: usize>(
        vectors: [[R; 3]; N],
        _: R,
        value: impl Fn([[R; 3]; N]) -> R,
    ) -> R {
        value(vectors)
    }
}
