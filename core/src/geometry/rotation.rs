//! Rotations of space, in as few numbers as they need.

use super::vector::{Vector3, dot};
use crate::real::Real;

/// A rotation. Most are about the z axis, or none at all.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Rotation<R> {
    /// Nothing is turned.
    None,
    /// About the z axis: the cosine and the sine.
    Planar([R; 2]),
    /// About any axis: the matrix, by rows.
    Tilted([Vector3<R>; 3]),
}

impl<R: Real> Rotation<R> {
    /// `Rz(yaw) Ry(pitch) Rx(roll)` (thesis Eq 2.10).
    pub(crate) fn new([yaw, pitch, roll]: [R; 3]) -> Self {
        if pitch == R::ZERO && roll == R::ZERO {
            return Rotation::planar(yaw);
        }
        let (sa, ca) = yaw.sin_cos();
        let (sb, cb) = pitch.sin_cos();
        let (sc, cc) = roll.sin_cos();
        Rotation::Tilted([
            [ca * cb, ca * sb * sc - sa * cc, ca * sb * cc + sa * sc],
            [sa * cb, sa * sb * sc + ca * cc, sa * sb * cc - ca * sc],
            [-sb, cb * sc, cb * cc],
        ])
    }

    /// About the z axis by an angle in radians.
    pub(crate) fn planar(yaw: R) -> Self {
        let (sin, cos) = yaw.sin_cos();
        Rotation::Planar([cos, sin])
    }

    /// Its matrix, by rows.
    pub(crate) fn rows(&self) -> [Vector3<R>; 3] {
        let (o, i) = (R::ZERO, R::ONE);
        match *self {
            Rotation::None => [[i, o, o], [o, i, o], [o, o, i]],
            Rotation::Planar([cos, sin]) => [[cos, -sin, o], [sin, cos, o], [o, o, i]],
            Rotation::Tilted(rows) => rows,
        }
    }

    /// Where it turns the x axis to.
    pub(crate) fn heading(&self) -> Vector3<R> {
        match *self {
            Rotation::None => [R::ONE, R::ZERO, R::ZERO],
            Rotation::Planar([cos, sin]) => [cos, sin, R::ZERO],
            Rotation::Tilted(rows) => rows.map(|[x, ..]| x),
        }
    }

    /// The product of the two matrices: `inner` is turned first.
    pub(crate) fn compose(&self, inner: &Self) -> Self {
        match (*self, *inner) {
            (outer, Rotation::None) => outer,
            (Rotation::None, inner) => inner,
            (Rotation::Planar([ca, sa]), Rotation::Planar([cb, sb])) => {
                Rotation::Planar([ca * cb - sa * sb, sa * cb + ca * sb])
            }
            _ => Rotation::Tilted(product(&self.rows(), &inner.rows())),
        }
    }
}

/// The product of two matrices, by rows.
pub(super) fn product<R: Real>(a: &[Vector3<R>; 3], b: &[Vector3<R>; 3]) -> [Vector3<R>; 3] {
    let columns = transpose(b);
    a.map(|row| columns.map(|column| dot(row, column)))
}

pub(super) fn transpose<R: Copy>(rows: &[Vector3<R>; 3]) -> [Vector3<R>; 3] {
    let [[a, b, c], [d, e, f], [g, h, i]] = *rows;
    [[a, d, g], [b, e, h], [c, f, i]]
}
