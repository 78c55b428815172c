//! Frames of space (thesis 2.1, Eq 2.6 to 2.11).

use super::rotation::{Rotation, product, transpose};
use super::vector::{Vector3, add, dot};
use crate::real::Real;

/// A frame of reference in space: where its origin lies in the parent frame, and
/// how it is turned there.
///
/// The rotation is given by yaw, pitch and roll, the angles about the z, y and x
/// axes, and is `Rz(yaw) Ry(pitch) Rx(roll)` (Eq 2.10): as seen from the parent
/// frame the roll comes first. As a transform the frame rotates, then translates.
///
/// ```
/// use critreg::geometry::Frame3;
/// let shelf = Frame3::new([1.0, 0.0, 2.0], [0.0, 0.0, 0.0]);
/// assert_eq!(shelf.apply([0.5, 0.25, 0.0]), [1.5, 0.25, 2.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame3<R> {
    origin: Vector3<R>,
    /// By rows.
    rotation: [[R; 3]; 3],
}

impl<R: Real> Frame3<R> {
    /// The frame at `origin`, turned by `[yaw, pitch, roll]` radians.
    pub fn new(origin: Vector3<R>, angles: [R; 3]) -> Self {
        Frame3 {
            origin,
            rotation: Rotation::new(angles).rows(),
        }
    }

    /// The parent frame itself.
    pub fn identity() -> Self {
        Frame3 {
            origin: [R::ZERO; 3],
            rotation: Rotation::None.rows(),
        }
    }

    /// Its origin in the parent frame.
    pub fn origin(&self) -> Vector3<R> {
        self.origin
    }

    /// Its rotation matrix, by rows (Eq 2.10).
    pub fn rotation(&self) -> [[R; 3]; 3] {
        self.rotation
    }

    /// Its x, y and z axis in the parent frame: the columns of the rotation.
    pub fn axes(&self) -> [Vector3<R>; 3] {
        transpose(&self.rotation)
    }

    /// Its `[yaw, pitch, roll]` in the parent frame; pitch in `[-pi/2, pi/2]`,
    /// the others in `[-pi, pi]`.
    ///
    /// At a pitch of `pi/2` or `-pi/2` only the sum or difference of yaw and roll
    /// is defined; there the roll is reported as zero.
    pub fn yaw_pitch_roll(&self) -> [R; 3] {
        let [[r11, r12, _], [r21, r22, _], [r31, r32, r33]] = self.rotation;
        let cos_pitch = (r32 * r32 + r33 * r33).sqrt();
        let pitch = (-r31).atan2(cos_pitch);
        // Below this the entries left are rounding errors of a zero.
        if cos_pitch < R::from_f64(8.0) * R::EPSILON {
            return [(-r12).atan2(r22), pitch, R::ZERO];
        }
        [r21.atan2(r11), pitch, r32.atan2(r33)]
    }

    /// A point of this frame in the parent frame.
    pub fn apply(&self, point: Vector3<R>) -> Vector3<R> {
        add(self.origin, self.apply_direction(point))
    }

    /// A direction of this frame in the parent frame: rotated only.
    pub fn apply_direction(&self, direction: Vector3<R>) -> Vector3<R> {
        self.rotation.map(|row| dot(row, direction))
    }

    /// A point of the parent frame in this frame: the inverse of [`Self::apply`].
    pub fn to_local(&self, point: Vector3<R>) -> Vector3<R> {
        let offset = add(point, self.origin.map(|x| -x));
        transpose(&self.rotation).map(|row| dot(row, offset))
    }

    /// This frame with its origin at `point`, a point of its own.
    pub fn shifted(&self, point: Vector3<R>) -> Self {
        Frame3 {
            origin: self.apply(point),
            rotation: self.rotation,
        }
    }

    /// The frame that lies in this one as `inner` lies in its parent; the product
    /// of the two matrices.
    pub fn compose(&self, inner: &Self) -> Self {
        Frame3 {
            origin: self.apply(inner.origin),
            rotation: product(&self.rotation, &inner.rotation),
        }
    }

    /// The parent frame as seen from this one.
    pub fn inverse(&self) -> Self {
        Frame3 {
            origin: self.to_local([R::ZERO; 3]),
            rotation: transpose(&self.rotation),
        }
    }

    /// The homogeneous transformation matrix, by rows (Eq 2.11).
    pub fn matrix(&self) -> [[R; 4]; 4] {
        let [x, y, z] = self.origin;
        let [[a, b, c], [d, e, f], [g, h, i]] = self.rotation;
        let (o, one) = (R::ZERO, R::ONE);
        [[a, b, c, x], [d, e, f, y], [g, h, i, z], [o, o, o, one]]
    }
}
