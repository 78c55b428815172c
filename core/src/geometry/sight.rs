//! The straight line between two points, as wide as a ball, and a body that it may meet.

use super::body::{Body, Dimensions};
use super::pieces::{Corners, Piece, Pieces, signed};
use super::relation::{Relation, counted};
use super::vector::{Vector3, cross, dot, scale, subtract};
use super::zonogon::Zonogon;
use super::zonotope::{View, Zonotope};
use crate::real::Real;

/// The clearance between the straight line from `start` to `end`, as wide as a ball of a
/// radius, and a body: of a line of sight, or of a straight motion. Its pieces while the
/// whole line moves are those of [`Relation::Clear`] for [`Body::segment`]; those while one
/// end moves are in [`Swing`].
pub fn sight<R: Real>(
    start: Vector3<R>,
    end: Vector3<R>,
    radius: R,
    body: &Body<R>,
    dimensions: Dimensions,
) -> R {
    let [start, end] = [start, end].map(|point| counted(point, dimensions));
    let line = Body::segment(start, end, radius);
    Relation::Clear.value(&line, body, dimensions)
}

/// What a [`sight`] is made of while one end of the line stands and the other one moves: at
/// every place of that end, its value is that of one of the pieces, or one that a piece of the
/// moving end has where the other end stands, and so does not vary.
#[derive(Clone, Debug)]
pub struct Swing<R> {
    /// The end that stands, as seen from the centre of the body.
    pivot: Vector3<R>,
    zonotope: Zonotope<R>,
    dimensions: Dimensions,
    /// The pieces of the end that moves.
    ends: Pieces<R>,
    /// What the radii take off.
    offset: R,
}

/// A function of where the end that moves is, as seen from the centre of the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SwingPiece<R> {
    /// The end itself is nearest.
    End(Piece<R>),
    /// An edge of the body is nearest to the line, or a corner in the plane:
    /// `v . normal / |v| + offset`, where `v` is the part across `along` of the vector from
    /// the pivot to the end.
    Edge {
        /// The direction of the edge, of length one, and at a right angle to the normal.
        along: Vector3<R>,
        /// Across the vector from the pivot to the edge, and as long.
        normal: Vector3<R>,
        /// What is added.
        offset: R,
    },
    /// A corner of the body is nearest to the line: `|v x to| / |v| + offset`, where `v` is
    /// the vector from the pivot to the end.
    Corner {
        /// The vector from the pivot to the corner.
        to: Vector3<R>,
        /// What is added.
        offset: R,
    },
}

impl<R: Real> Swing<R> {
    /// The pieces for a line about `pivot`, which is seen from the centre of the body, as
    /// wide as a ball of a radius.
    pub fn new(pivot: Vector3<R>, radius: R, body: &Body<R>, dimensions: Dimensions) -> Self {
        let end = Body::ball(pivot, radius);
        Swing {
            pivot: counted(pivot, dimensions),
            zonotope: Zonotope::of([body], dimensions.count()),
            dimensions,
            ends: Relation::Clear.pieces(&end, body, dimensions),
            offset: -(radius + body.radius),
        }
    }

    /// How many there are at most.
    pub fn len(&self) -> usize {
        self.ends.len() + self.edges() + self.corners()
    }

    /// Whether there are none, which is never so.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// One of them. `None` if the index is too large, but for some smaller ones as well.
    pub fn get(&self, index: usize) -> Option<SwingPiece<R>> {
        let Some(index) = index.checked_sub(self.ends.len()) else {
            return self.ends.get(index).map(SwingPiece::End);
        };
        match index.checked_sub(self.edges()) {
            None => self.edge(index),
            Some(corner) if corner < self.corners() => Some(self.corner(corner)),
            Some(_) => None,
        }
    }

    /// All of them.
    pub fn iter(&self) -> impl Iterator<Item = SwingPiece<R>> + '_ {
        (0..self.len()).filter_map(|index| self.get(index))
    }

    fn generators(&self) -> usize {
        self.zonotope.generators().len()
    }

    /// Those of all edges, each of which is seen end on from one side; in the plane that is
    /// from above.
    fn edges(&self) -> usize {
        let views = match self.dimensions {
            Dimensions::Plane => 1,
            Dimensions::Space => self.generators(),
        };
        views * self.edges_per_view()
    }

    /// Those of corners that no edge stands for.
    fn corners(&self) -> usize {
        match self.dimensions {
            Dimensions::Plane => 0,
            Dimensions::Space => 1 << self.generators(),
        }
    }

    /// An edge is passed on one side or the other.
    fn edges_per_view(&self) -> usize {
        let seen = match self.dimensions {
            Dimensions::Plane => self.generators(),
            Dimensions::Space => self.generators().saturating_sub(1),
        };
        2 * Zonogon::<R>::corners_of(seen)
    }

    fn edge(&self, index: usize) -> Option<SwingPiece<R>> {
        let per_view = self.edges_per_view();
        let along = match self.dimensions {
            Dimensions::Plane => [R::ZERO, R::ZERO, R::ONE],
            Dimensions::Space => {
                let view = index.checked_div(per_view)?;
                self.zonotope.generators().get(view)?.axis
            }
        };
        let view = View::along(along);
        let index = index.checked_rem(per_view)?;
        let corner = self.zonotope.outline(&view).corner(index / 2)?;
        let pivot = view.lift(view.project(self.pivot));
        let to = subtract(view.lift(corner), pivot);
        Some(SwingPiece::Edge {
            along,
            normal: signed(cross(along, to), index),
            offset: self.offset,
        })
    }

    fn corner(&self, index: usize) -> SwingPiece<R> {
        let generators = self.zonotope.generators().iter();
        let corners = Corners::between(generators.map(|g| scale(g.axis, g.half)));
        SwingPiece::Corner {
            to: subtract(corners.get(index), self.pivot),
            offset: self.offset,
        }
    }
}

impl<R: Real> SwingPiece<R> {
    /// Its value where the end that moves is at `end`, and the other one at `pivot`.
    pub fn value(&self, pivot: Vector3<R>, end: Vector3<R>) -> R {
        let v = subtract(end, pivot);
        let length = |v: Vector3<R>| dot(v, v).sqrt();
        match *self {
            SwingPiece::End(piece) => piece.value(end),
            SwingPiece::Edge {
                along,
                normal,
                offset,
            } => {
                let across = subtract(v, scale(along, dot(v, along)));
                dot(v, normal) / length(across) + offset
            }
            SwingPiece::Corner { to, offset } => length(cross(v, to)) / length(v) + offset,
        }
    }
}
