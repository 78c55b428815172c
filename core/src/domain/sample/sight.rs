//! A straight line between two points of a sample, and a body that it may meet.

use super::body_pair::{BodyPair, across_edge, curve};
use crate::domain::algebra::{Algebra, Arithmetic, Bend, Curve, Line};
use crate::geometry::{self, Body, Dimensions, Relation, Swing, SwingPiece};
use crate::real::Real;

/// How wide a line is, and a body, with its centre in the origin.
pub(super) struct Sight<R> {
    pub(super) radius: R,
    pub(super) body: Body<R>,
    pub(super) dimensions: Dimensions,
}

/// How the line moves, as seen from the body.
enum Motion<R> {
    /// As a whole: its middle does.
    Common(BodyPair<R>, [Line<R>; 3]),
    /// About one of its ends; the other one moves.
    Swing(Swing<R>, [R; 3], [Line<R>; 3]),
}

impl<R: Real> Sight<R> {
    /// Whether the body, or the ball that is swept, is not there.
    pub(super) fn is_absent(&self) -> bool {
        self.body.is_absent() || Body::ball([R::ZERO; 3], self.radius).is_absent()
    }

    /// How clear of the body the line with these ends is.
    pub(super) fn value(&self, [start, end]: [[R; 3]; 2]) -> R {
        geometry::sight(start, end, self.radius, &self.body, self.dimensions)
    }

    /// How many pieces there are, one of which is the clearance wherever the ends are.
    pub(super) fn piece_count(&self, ends: [[Line<R>; 3]; 2]) -> usize {
        match self.motion(ends) {
            Some(Motion::Common(pair, _)) => pair.piece_count(),
            Some(Motion::Swing(swing, ..)) => swing.len(),
            None => 1,
        }
    }

    /// One of the pieces. Where both ends move, each in its own way, the only one is unknown.
    pub(super) fn piece(&self, index: usize, ends: [[Line<R>; 3]; 2]) -> Option<Curve<R>> {
        let (swing, pivot, end) = match self.motion(ends) {
            Some(Motion::Common(pair, middle)) => return pair.piece(index, middle),
            Some(Motion::Swing(swing, pivot, end)) => (swing, pivot, end),
            None => return Some(Curve::unknown()),
        };
        let vector = minus(end, pivot.map(Line::constant));
        let bent = |vector, bend, offset| Curve {
            line: Line::constant(offset),
            factor: R::ONE,
            vector,
            bend,
        };
        Some(match swing.get(index)? {
            SwingPiece::End(piece) => curve(piece, end),
            SwingPiece::Edge {
                along,
                normal,
                offset,
            } => bent(across_edge(vector, along), Bend::Cosine(normal), offset),
            SwingPiece::Corner { to, offset } => bent(vector, Bend::Sine(to), offset),
        })
    }

    fn motion(&self, [start, end]: [[Line<R>; 3]; 2]) -> Option<Motion<R>> {
        if let Some(span) = known(minus(end, start)) {
            let half = R::from_f64(0.5);
            let middle = minus(start, span.map(|step| Line::constant(-(step * half))));
            let pair = BodyPair {
                relation: Relation::Clear,
                first: Body::segment([R::ZERO; 3], span, self.radius),
                second: self.body,
                dimensions: self.dimensions,
            };
            return Some(Motion::Common(pair, middle));
        }
        let (pivot, end) = match (known(start), known(end)) {
            (Some(start), _) => (start, end),
            (None, Some(end)) => (end, start),
            (None, None) => return None,
        };
        let swing = Swing::new(pivot, self.radius, &self.body, self.dimensions);
        Some(Motion::Swing(swing, pivot, end))
    }
}

/// Where a point is that does not move.
fn known<R: Real>([x, y, z]: [Line<R>; 3]) -> Option<[R; 3]> {
    Some([x.known()?, y.known()?, z.known()?])
}

fn minus<R: Real>([x, y, z]: [Line<R>; 3], [a, b, c]: [Line<R>; 3]) -> [Line<R>; 3] {
    [x.minus(a), y.minus(b), z.minus(c)]
}
