//! Points and directions as plain arrays.

use crate::real::Real;

/// A point or a direction in the plane, `[x, y]`.
pub type Vector2<R> = [R; 2];

/// A point or a direction in space, `[x, y, z]`.
pub type Vector3<R> = [R; 3];

/// The vector from `a` to `b`.
pub(super) fn between<R: Real>([ax, ay]: Vector2<R>, [bx, by]: Vector2<R>) -> Vector2<R> {
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

pub(super) fn add<R: Real>([a, b, c]: Vector3<R>, [x, y, z]: Vector3<R>) -> Vector3<R> {
    [a + x, b + y, c + z]
}

pub(super) fn subtract<R: Real>([a, b, c]: Vector3<R>, [x, y, z]: Vector3<R>) -> Vector3<R> {
    [a - x, b - y, c - z]
}

pub(super) fn scale<R: Real>([x, y, z]: Vector3<R>, factor: R) -> Vector3<R> {
    [x * factor, y * factor, z * factor]
}

pub(super) fn dot<R: Real>([a, b, c]: Vector3<R>, [x, y, z]: Vector3<R>) -> R {
    a * x + b * y + c * z
}

pub(super) fn cross<R: Real>([a, b, c]: Vector3<R>, [x, y, z]: Vector3<R>) -> Vector3<R> {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}
