//! Frames of reference and shapes.
//!
//! [`Frame2`] and [`Frame3`] are the homogeneous transforms of thesis section
//! 2.1; [`Circle`], [`Rectangle`] and [`Segment`] in the plane and [`Cuboid`] in
//! space are the shapes of the built-in environments, and [`Intersects`] tells
//! whether two of them meet. All are generic over [`Real`]; sine and cosine are
//! computed once, when a frame or a shape is made from an angle.

mod cuboid;
mod frame2;
mod frame3;
mod intersect;
mod rotation;
mod shape;

pub use cuboid::Cuboid;
pub use frame2::Frame2;
pub use frame3::Frame3;
pub use intersect::Intersects;
pub(crate) use rotation::Rotation;
pub use shape::{Circle, Rectangle, Segment};

use crate::real::Real;

/// A point or a direction in the plane, `[x, y]`.
pub type Vector2<R> = [R; 2];

/// A point or a direction in space, `[x, y, z]`.
pub type Vector3<R> = [R; 3];

/// The vector from `a` to `b`.
fn between<R: Real>([ax, ay]: Vector2<R>, [bx, by]: Vector2<R>) -> Vector2<R> {
    [bx - ax, by - ay]
}

/// The square of the distance of two points of the plane.
///
/// ```
/// assert_eq!(critreg::geometry::distance_squared([0.0, 1.0], [3.0, 5.0]), 25.0);
/// ```
pub fn distance_squared<R: Real>(a: Vector2<R>, b: Vector2<R>) -> R {
    let [x, y] = between(a, b);
    x * x + y * y
}

/// The distance of two points of the plane.
pub fn distance<R: Real>(a: Vector2<R>, b: Vector2<R>) -> R {
    distance_squared(a, b).sqrt()
}
