//! What an expression is evaluated to: a number, a curve along a line of
//! parameters, or a range over a box of parameters.
//!
//! One evaluator serves all three. A number answers "is this sample inside?", a
//! curve has its roots in closed form and so gives exact intervals, and a range
//! that misses zero proves that a whole box is outside.

mod curve;
mod line;
mod number;
mod range;

pub use curve::{Bend, Curve};
pub use line::Line;
pub use range::Range;

use super::node::Extreme;
use crate::real::Real;

/// What can be added, subtracted, multiplied and divided.
pub trait Arithmetic<R: Real>: Copy {
    /// A number that does not vary.
    fn constant(value: R) -> Self;
    /// A quantity of which nothing is known.
    fn unknown() -> Self;
    /// `self + other`
    fn plus(self, other: Self) -> Self;
    /// `self - other`
    fn minus(self, other: Self) -> Self;
    /// `self * other`
    fn times(self, other: Self) -> Self;
    /// `self / other`
    fn over(self, other: Self) -> Self;
    /// `self * factor`
    fn scaled(self, factor: R) -> Self {
        self.times(Self::constant(factor))
    }
    /// The same quantity, known less exactly by so much.
    fn widened(self, by: R) -> Self;
}

/// What features are computed in.
pub trait Measure<R: Real>: Arithmetic<R> {
    /// The extreme of two quantities, everywhere.
    fn extreme(self, extreme: Extreme, other: Self) -> Self;
    /// Subtracts a number, in place.
    fn lower(&mut self, by: R);
}

/// What parameters and positions are computed in.
pub trait Algebra<R: Real>: Arithmetic<R> {
    /// What features are computed in; it also holds lengths of vectors.
    type Measure: Measure<R>;
    /// The same quantity as a feature.
    fn measure(self) -> Self::Measure;
    /// The length of a vector.
    fn norm(vector: [Self; 3]) -> Self::Measure;
    /// The angle between two vectors, in `[0, pi]`; zero if one of them is zero.
    fn angle(a: [Self; 3], b: [Self; 3]) -> Self::Measure;
    /// How far it is from the nearest multiple of a number.
    fn folded(self, period: R) -> Self::Measure;
    /// The number, if it does not vary.
    fn known(self) -> Option<R>;
    /// A number and how far it is from this quantity at most; `None` if that is unknown.
    fn about(self) -> Option<(R, R)>;
    /// What follows from some vectors, as a length that changes by no more than the one of
    /// them does that changes most, and by `slack` for all else that is not known.
    fn length_of<const N: usize>(
        vectors: [[Self; 3]; N],
        slack: R,
        value: impl Fn([[R; 3]; N]) -> R,
    ) -> Self::Measure;
}

fn dot<R: Real, A: Arithmetic<R>>(a: [A; 3], b: [A; 3]) -> A {
    let ([ax, ay, az], [bx, by, bz]) = (a, b);
    ax.times(bx).plus(ay.times(by)).plus(az.times(bz))
}

fn cross<R: Real, A: Arithmetic<R>>(a: [A; 3], b: [A; 3]) -> [A; 3] {
    let ([ax, ay, az], [bx, by, bz]) = (a, b);
    [
        ay.times(bz).minus(az.times(by)),
        az.times(bx).minus(ax.times(bz)),
        ax.times(by).minus(ay.times(bx)),
    ]
}
