//! Two bodies of a sample and a relation between them.

use crate::domain::algebra::{Algebra, Arithmetic, Curve, Line};
use crate::geometry::{Body, Dimensions, Piece, Relation};
use crate::real::Real;

/// Two bodies, the centre of the second one in the origin, and how they are related.
pub(super) struct BodyPair<R> {
    pub(super) relation: Relation,
    pub(super) first: Body<R>,
    pub(super) second: Body<R>,
    pub(super) dimensions: Dimensions,
}

impl<R: Real> BodyPair<R> {
    /// Whether one of them is not there: a size of it is below zero.
    pub(super) fn is_absent(&self) -> bool {
        self.first.is_absent() || self.second.is_absent()
    }

    /// The relation where the first one's centre is this far from the second one's.
    pub(super) fn value(&self, difference: [R; 3]) -> R {
        let mut first = self.first;
        first.centre = difference;
        self.relation.value(&first, &self.second, self.dimensions)
    }

    /// How many pieces there are, one of which is the relation wherever the centres are.
    pub(super) fn piece_count(&self) -> usize {
        let (first, second) = (&self.first, &self.second);
        self.relation.pieces(first, second, self.dimensions).len()
    }

    /// One of the pieces, along a line of differences of the centres.
    pub(super) fn piece(&self, index: usize, difference: [Line<R>; 3]) -> Option<Curve<R>> {
        let (first, second) = (&self.first, &self.second);
        let pieces = self.relation.pieces(first, second, self.dimensions);
        Some(curve(pieces.get(index)?, difference))
    }
}

/// A piece along a line of vectors.
pub(super) fn curve<R: Real>(piece: Piece<R>, difference: [Line<R>; 3]) -> Curve<R> {
    match piece {
        Piece::Plane { normal, offset } => along(difference, normal)
            .minus(Line::constant(offset))
            .measure(),
        Piece::Length {
            at,
            across,
            factor,
            offset,
        } => {
            let [x, y, z] = difference;
            let [at_x, at_y, at_z] = at.map(Line::constant);
            let mut vector = [x.minus(at_x), y.minus(at_y), z.minus(at_z)];
            if let Some(edge) = across {
                vector = across_edge(vector, edge);
            }
            let length = Line::norm(vector).scaled(factor);
            length.plus(Curve::constant(offset))
        }
    }
}

/// How far vectors go along a direction of length one.
fn along<R: Real>([x, y, z]: [Line<R>; 3], [a, b, c]: [R; 3]) -> Line<R> {
    x.scaled(a).plus(y.scaled(b)).plus(z.scaled(c))
}

/// What is left of vectors without their part along a direction of length one.
pub(super) fn across_edge<R: Real>(mut vector: [Line<R>; 3], edge: [R; 3]) -> [Line<R>; 3] {
    let part = along(vector, edge);
    for (own, entry) in vector.iter_mut().zip(edge) {
        *own = own.minus(part.scaled(entry));
    }
    vector
}
