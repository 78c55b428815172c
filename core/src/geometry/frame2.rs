//! Frames of the plane (thesis 2.1, Eq 2.1 to 2.5).

use super::vector::{Vector2, between};
use crate::real::Real;

/// A frame of reference in the plane: where its origin lies in the parent frame,
/// and by which angle it is turned there, counter-clockwise.
///
/// As a transform it first rotates, then translates (Eq 2.4), and so takes
/// coordinates in this frame to coordinates in the parent frame.
///
/// ```
/// use critreg::geometry::Frame2;
/// let stick = Frame2::new([2.0, 1.0], 0.0);
/// assert_eq!(stick.apply([1.5, 0.0]), [3.5, 1.0]);
/// assert_eq!(stick.to_local([3.5, 1.0]), [1.5, 0.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame2<R> {
    origin: Vector2<R>,
    cos: R,
    sin: R,
}

impl<R: Real> Frame2<R> {
    /// The frame at `origin`, turned by `yaw` radians.
    pub fn new(origin: Vector2<R>, yaw: R) -> Self {
        let (sin, cos) = yaw.sin_cos();
        Frame2 { origin, cos, sin }
    }

    /// The parent frame itself.
    pub fn identity() -> Self {
        Frame2 {
            origin: [R::ZERO; 2],
            cos: R::ONE,
            sin: R::ZERO,
        }
    }

    /// Its origin in the parent frame.
    pub fn origin(&self) -> Vector2<R> {
        self.origin
    }

    /// Its angle in the parent frame, in `[-pi, pi]`.
    pub fn yaw(&self) -> R {
        self.sin.atan2(self.cos)
    }

    /// A point of this frame in the parent frame (Eq 2.4).
    pub fn apply(&self, [x, y]: Vector2<R>) -> Vector2<R> {
        let [ox, oy] = self.origin;
        [
            ox + x * self.cos - y * self.sin,
            oy + x * self.sin + y * self.cos,
        ]
    }

    /// A direction of this frame in the parent frame: rotated only (Eq 2.3).
    pub fn apply_direction(&self, [x, y]: Vector2<R>) -> Vector2<R> {
        [x * self.cos - y * self.sin, x * self.sin + y * self.cos]
    }

    /// A point of the parent frame in this frame: the inverse of [`Self::apply`].
    pub fn to_local(&self, point: Vector2<R>) -> Vector2<R> {
        let [x, y] = between(self.origin, point);
        [x * self.cos + y * self.sin, y * self.cos - x * self.sin]
    }

    /// The frame of the same rotation whose origin is the point `origin` of this
    /// frame.
    pub fn shifted(&self, origin: Vector2<R>) -> Self {
        Frame2 {
            origin: self.apply(origin),
            ..*self
        }
    }

    /// The frame that lies in this one as `inner` lies in its parent; the product
    /// of the two matrices.
    pub fn compose(&self, inner: &Self) -> Self {
        Frame2 {
            origin: self.apply(inner.origin),
            cos: self.cos * inner.cos - self.sin * inner.sin,
            sin: self.sin * inner.cos + self.cos * inner.sin,
        }
    }

    /// The parent frame as seen from this one.
    pub fn inverse(&self) -> Self {
        Frame2 {
            origin: self.to_local([R::ZERO; 2]),
            cos: self.cos,
            sin: -self.sin,
        }
    }

    /// The homogeneous transformation matrix, by rows (Eq 2.5).
    pub fn matrix(&self) -> [[R; 3]; 3] {
        let [x, y] = self.origin;
        [
            [self.cos, -self.sin, x],
            [self.sin, self.cos, y],
            [R::ZERO, R::ZERO, R::ONE],
        ]
    }
}
