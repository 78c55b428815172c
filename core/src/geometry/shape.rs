//! Shapes of the plane.

use super::frame2::Frame2;
use super::vector::{Vector2, between, distance_squared};
use crate::real::Real;

/// A disc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle<R> {
    /// Its centre.
    pub centre: Vector2<R>,
    /// Its radius.
    pub radius: R,
}

impl<R: Real> Circle<R> {
    /// Whether the point lies in the disc or on its rim.
    pub fn contains(&self, point: Vector2<R>) -> bool {
        distance_squared(self.centre, point) <= self.radius * self.radius
    }
}

/// A straight line between two points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment<R> {
    /// One end.
    pub start: Vector2<R>,
    /// The other end.
    pub end: Vector2<R>,
}

impl<R: Real> Segment<R> {
    /// The foot of the perpendicular from `point` on the line through the
    /// segment, which may lie beyond its ends. NaN if both ends are one point.
    pub fn foot(&self, point: Vector2<R>) -> Vector2<R> {
        let [x, y] = self.start;
        let [dx, dy] = between(self.start, self.end);
        let [px, py] = between(self.start, point);
        let along = (px * dx + py * dy) / (dx * dx + dy * dy);
        [x + dx * along, y + dy * along]
    }
}

/// A rectangle that extends from one of its corners along the two axes of a
/// frame: the width along x, the height along y.
///
/// It holds the sine and cosine of its angle, not the angle, so that no test
/// computes them again.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rectangle<R> {
    /// The corner and the directions of the sides.
    pub frame: Frame2<R>,
    /// Length of the sides along the frame's x axis.
    pub width: R,
    /// Length of the sides along the frame's y axis.
    pub height: R,
}

impl<R: Real> Rectangle<R> {
    /// The rectangle of size `[width, height]` with this `corner`, about which it
    /// is turned by `theta` radians counter-clockwise.
    pub fn new(corner: Vector2<R>, [width, height]: [R; 2], theta: R) -> Self {
        Rectangle {
            frame: Frame2::new(corner, theta),
            width,
            height,
        }
    }

    /// The point where its diagonals meet.
    pub fn centre(&self) -> Vector2<R> {
        let half = R::from_f64(0.5);
        self.frame.apply([self.width * half, self.height * half])
    }

    /// Its corners: the one at the frame's origin first, then around by way of
    /// the end of the height.
    pub fn vertices(&self) -> [Vector2<R>; 4] {
        let (o, w, h) = (R::ZERO, self.width, self.height);
        [[o, o], [o, h], [w, h], [w, o]].map(|corner| self.frame.apply(corner))
    }

    /// Its sides, in the order of [`Self::vertices`].
    pub fn sides(&self) -> [Segment<R>; 4] {
        let [a, b, c, d] = self.vertices();
        [[a, b], [b, c], [c, d], [d, a]].map(|[start, end]| Segment { start, end })
    }

    /// The smallest circle around it.
    pub fn circumscribed(&self) -> Circle<R> {
        let diagonal = (self.width * self.width + self.height * self.height).sqrt();
        Circle {
            centre: self.centre(),
            radius: diagonal * R::from_f64(0.5),
        }
    }

    /// Whether the point lies in it or on a side.
    pub fn contains(&self, point: Vector2<R>) -> bool {
        let [x, y] = self.frame.to_local(point);
        R::ZERO <= x && x <= self.width && R::ZERO <= y && y <= self.height
    }
}
