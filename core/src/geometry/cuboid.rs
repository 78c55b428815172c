//! Boxes in space, and whether two of them meet.

use super::frame3::Frame3;
use super::intersect::Intersects;
use super::vector::{Vector3, add, cross, dot};
use crate::real::Real;

/// A box in space: it extends from the origin of a frame by half its size in both
/// directions of each axis. Also called an oriented bounding box.
///
/// ```
/// use critreg::geometry::{Cuboid, Intersects};
/// let table = Cuboid::new([0.0, 0.0, -0.5], [2.0, 2.0, 1.0], [0.0; 3]);
/// let card = |z: f64| Cuboid::new([0.0, 0.0, z], [0.5, 0.25, 0.0], [0.0, 0.5, 0.0]);
/// assert!(card(0.1).intersects(&table));
/// assert!(!card(0.13).intersects(&table));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cuboid<R> {
    /// Its centre and the directions of its edges.
    pub frame: Frame3<R>,
    /// Half its size along each axis of the frame.
    pub half: [R; 3],
}

impl<R: Real> Cuboid<R> {
    /// The box of this `size` around `centre`, about which it is turned by
    /// `[yaw, pitch, roll]` radians.
    pub fn new(centre: Vector3<R>, size: [R; 3], turn: [R; 3]) -> Self {
        Cuboid::within(Frame3::new(centre, turn), size)
    }

    /// The box of this `size` around the origin of a frame and along its axes.
    pub fn within(frame: Frame3<R>, size: [R; 3]) -> Self {
        let half = R::from_f64(0.5);
        Cuboid {
            frame,
            half: size.map(|length| length * half),
        }
    }

    /// Its corners: first those at the lower end of the frame's x axis, of these
    /// first those at the lower end of y, and so for z.
    pub fn vertices(&self) -> [Vector3<R>; 8] {
        let [x, y, z] = self.half;
        let corners = [
            [-x, -y, -z],
            [-x, -y, z],
            [-x, y, -z],
            [-x, y, z],
            [x, -y, -z],
            [x, -y, z],
            [x, y, -z],
            [x, y, z],
        ];
        corners.map(|corner| self.frame.apply(corner))
    }

    /// Whether the point lies in it or on a side.
    pub fn contains(&self, point: Vector3<R>) -> bool {
        let local = self.frame.to_local(point);
        local.iter().zip(self.half).all(|(x, half)| x.abs() <= half)
    }

    /// How far it extends along a direction, given as a vector of length one: the
    /// length of its shadow on a line.
    pub fn extent(&self, direction: Vector3<R>) -> R {
        let radius = self.radius(direction);
        radius + radius
    }

    /// How far it reaches from its centre along a direction, times the length of
    /// the direction.
    fn radius(&self, direction: Vector3<R>) -> R {
        dot(
            self.frame.axes().map(|axis| dot(axis, direction).abs()),
            self.half,
        )
    }
}

impl<R: Real> Intersects<Cuboid<R>> for Cuboid<R> {
    /// Boxes must overlap: those that only touch do not meet.
    ///
    /// This is the separating-axis test (Gottschalk, Lin and Manocha 1996): two
    /// boxes keep apart if their shadows on one of 15 lines do, namely along the
    /// three axes of either box and across each pair of an axis of one and an axis
    /// of the other. A pair of parallel axes has no direction across, and none is
    /// needed; axes within the square root of the rounding error count as parallel,
    /// so an overlap is exact up to that part of the size.
    fn intersects(&self, other: &Cuboid<R>) -> bool {
        let offset = add(other.frame.origin(), self.frame.origin().map(|x| -x));
        let keeps_apart =
            |axis: Vector3<R>| dot(offset, axis).abs() >= self.radius(axis) + other.radius(axis);
        let (own, others) = (self.frame.axes(), other.frame.axes());
        let across = || own.into_iter().flat_map(|a| others.map(|b| cross(a, b)));
        let mut across = across().filter(|axis| dot(*axis, *axis) > R::EPSILON);
        !own.into_iter().chain(others).any(keeps_apart) && !across.any(keeps_apart)
    }
}
