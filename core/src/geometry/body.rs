//! Bodies: things with sizes.

use super::vector::{Vector3, add, cross, dot, scale, subtract};
use crate::real::Real;

/// Whether things lie in the plane or in space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimensions {
    /// In the plane: z does not count. Axes x and y of every body lie in the plane.
    Plane,
    /// In space.
    Space,
}

impl Dimensions {
    /// How many axes count.
    pub(super) fn count(self) -> usize {
        match self {
            Dimensions::Plane => 2,
            Dimensions::Space => 3,
        }
    }
}

/// A convex body: a box, of which any size may be zero, rounded by a radius. So it is also
/// a point, a ball, a segment, a capsule, a rectangle or a rounded one.
///
/// In other words it is the Minkowski sum of its *core*, which is the box, and a ball.
/// Sizes are in the length unit of the domain. A body with a size below zero, or one that
/// is no number, is absent, and whatever is computed of an absent body is NaN. The
/// constructors see to that, so a body is made by one of them.
///
/// ```
/// use critreg::geometry::{Body, Dimensions, Relation};
/// let tray = Body::new([2.0, 1.0, 0.0], Body::UPRIGHT, [0.4, 0.3, 0.0], 0.0);
/// let cup = Body::ball([2.25, 1.0, 0.0], 0.1);
/// let margin = Relation::Inside.value(&cup, &tray, Dimensions::Plane);
/// assert!((margin - 0.05_f64).abs() < 1e-12);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body<R> {
    /// Its centre.
    pub centre: Vector3<R>,
    /// The directions of its own x, y and z axis: of length one, and at right angles to each
    /// other.
    pub axes: [Vector3<R>; 3],
    /// Half the size of its core along each axis.
    pub half_sizes: [R; 3],
    /// By how much the core is rounded.
    pub radius: R,
}

impl<R: Real> Body<R> {
    /// The axes of a body that is not turned.
    pub const UPRIGHT: [Vector3<R>; 3] = [
        [R::ONE, R::ZERO, R::ZERO],
        [R::ZERO, R::ONE, R::ZERO],
        [R::ZERO, R::ZERO, R::ONE],
    ];

    /// The body around `centre` whose core extends by `half_sizes` in both directions of
    /// each of the `axes`, which are unit vectors at right angles; rounded by `radius`.
    pub fn new(centre: Vector3<R>, axes: [Vector3<R>; 3], half_sizes: [R; 3], radius: R) -> Self {
        let is_size = |size: &R| size.is_finite() && *size >= R::ZERO;
        let is_turned = axes.iter().flatten().all(|number| number.is_finite());
        if !(is_turned && is_size(&radius) && half_sizes.iter().all(is_size)) {
            return Body::absent();
        }
        Body {
            centre,
            axes,
            half_sizes,
            radius,
        }
    }

    /// A body that is not there.
    pub fn absent() -> Self {
        Body {
            centre: [R::NAN; 3],
            axes: Self::UPRIGHT,
            half_sizes: [R::ZERO; 3],
            radius: R::NAN,
        }
    }

    /// A body without any size.
    pub fn point(centre: Vector3<R>) -> Self {
        Body::ball(centre, R::ZERO)
    }

    /// The ball, or the disc, around `centre`.
    pub fn ball(centre: Vector3<R>, radius: R) -> Self {
        Body::new(centre, Self::UPRIGHT, [R::ZERO; 3], radius)
    }

    /// The capsule from `start` to `end`, with radius zero a segment; its x axis points to
    /// the end. If both are in the plane, so is its y axis.
    pub fn segment(start: Vector3<R>, end: Vector3<R>, radius: R) -> Self {
        let half = scale(subtract(end, start), R::from_f64(0.5));
        let length = dot(half, half).sqrt();
        let (axes, length) = if length > R::ZERO {
            let [x, y, z] = scale(half, R::ONE / length);
            let y_axis = level_normal([x, y, z]);
            ([[x, y, z], y_axis, cross([x, y, z], y_axis)], length)
        } else {
            (Self::UPRIGHT, length)
        };
        let half_sizes = [length, R::ZERO, R::ZERO];
        Body::new(add(start, half), axes, half_sizes, radius)
    }

    /// Whether it is absent.
    pub fn is_absent(&self) -> bool {
        let [x, y, z] = self.centre;
        !(x + y + z + self.radius).is_finite()
    }

    /// The vectors from its centre to the sides of its core, one along each axis.
    pub fn half_axes(&self) -> [Vector3<R>; 3] {
        let ([x, y, z], [a, b, c]) = (self.axes, self.half_sizes);
        [scale(x, a), scale(y, b), scale(z, c)]
    }

    /// The farthest that a corner of its core lies from a point; the radius does not count.
    pub fn reach(&self, from: Vector3<R>) -> R {
        let offset = subtract(self.centre, from);
        let sides = self.axes.iter().zip(self.half_sizes);
        let squared = sides.fold(R::ZERO, |sum, (axis, half)| {
            let farthest = dot(offset, *axis).abs() + half;
            sum + farthest * farthest
        });
        squared.sqrt()
    }

    /// How far its core reaches from its centre along a direction of length one.
    pub(super) fn extent(&self, direction: Vector3<R>) -> R {
        let sides = self.axes.iter().zip(self.half_sizes);
        sides.fold(R::ZERO, |sum, (axis, half)| {
            sum + dot(*axis, direction).abs() * half
        })
    }

    /// The directions in which its core has a size, each with half of that size, among the
    /// first `count` axes. A size whose square is zero counts as none.
    pub(super) fn sides(&self, count: usize) -> impl Iterator<Item = (Vector3<R>, R)> + '_ {
        let sides = self.axes.iter().zip(&self.half_sizes).take(count);
        sides
            .map(|(axis, half)| (*axis, *half))
            .filter(|(_, half)| *half * *half > R::ZERO)
    }

    /// A vector in its own frame.
    pub(super) fn local(&self, vector: Vector3<R>) -> Vector3<R> {
        self.axes.map(|axis| dot(vector, axis))
    }

    /// The distance from its core to what lies at `offset` from its centre, as seen in its
    /// own frame; below zero, how deep that lies in the core. Only the first `count` axes
    /// count.
    pub(super) fn distance_from_core(&self, offset: Vector3<R>, count: usize) -> R {
        let mut squared = R::ZERO;
        let mut farthest = R::NEG_INFINITY;
        for (along, half) in offset.iter().zip(self.half_sizes).take(count) {
            let beyond = along.abs() - half;
            farthest = farthest.max(beyond);
            if beyond > R::ZERO {
                squared += beyond * beyond;
            }
        }
        if squared > R::ZERO {
            squared.sqrt()
        } else {
            farthest
        }
    }
}

/// A direction of length one across another and level (without a z).
pub(super) fn level_normal<R: Real>([x, y, _]: Vector3<R>) -> Vector3<R> {
    let length = (x * x + y * y).sqrt();
    if length > R::ZERO {
        [-(y / length), x / length, R::ZERO]
    } else {
        [R::ZERO, R::ONE, R::ZERO]
    }
}
