//! The pieces of which a relation between two bodies is made.

use super::body::Body;
use super::vector::{Vector3, add, dot, scale, subtract};
use super::zonogon::Zonogon;
use super::zonotope::{View, Zonotope};
use crate::real::Real;
use heapless::Vec;

/// A function of `d`, the vector from the centre of a body `b` to that of a body `a`. In the
/// plane it does not depend on the z of `d`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Piece<R> {
    /// `d . normal - offset`
    Plane {
        /// A direction of length one.
        normal: Vector3<R>,
        /// What is taken off.
        offset: R,
    },
    /// `factor * |d - at| + offset`
    Length {
        /// From where the length is measured.
        at: Vector3<R>,
        /// A direction of length one, if what lies along it does not count: the length is
        /// that of the part of `d - at` across it.
        across: Option<Vector3<R>>,
        /// One or minus one.
        factor: R,
        /// What is added.
        offset: R,
    },
}

impl<R: Real> Piece<R> {
    /// Its value at `d`.
    pub fn value(&self, d: Vector3<R>) -> R {
        match *self {
            Piece::Plane { normal, offset } => dot(d, normal) - offset,
            Piece::Length {
                at,
                across,
                factor,
                offset,
            } => {
                let from = subtract(d, at);
                let from = match across {
                    Some(along) => subtract(from, scale(along, dot(from, along))),
                    None => from,
                };
                factor * dot(from, from).sqrt() + offset
            }
        }
    }

    fn plane(normal: Vector3<R>, offset: R) -> Self {
        Piece::Plane { normal, offset }
    }

    fn length(at: Vector3<R>, across: Option<Vector3<R>>) -> Self {
        Piece::Length {
            at,
            across,
            factor: R::ONE,
            offset: R::ZERO,
        }
    }

    /// Its value at `d + step`, times a factor, and something added.
    fn transformed(self, step: Vector3<R>, by: R, plus: R) -> Self {
        match self {
            Piece::Plane { normal, offset } => Piece::Plane {
                normal: scale(normal, by),
                offset: by * (offset - dot(normal, step)) - plus,
            },
            Piece::Length {
                at,
                across,
                factor,
                offset,
            } => Piece::Length {
                at: subtract(at, step),
                across,
                factor: factor * by,
                offset: offset * by + plus,
            },
        }
    }
}

/// The pieces of a relation between two bodies that do not turn: at every vector between
/// their centres the value of the relation is that of one of its pieces.
///
/// So where the value passes a threshold, a piece does. Not every piece is the value
/// somewhere, and some appear twice.
#[derive(Clone, Debug)]
pub struct Pieces<R>(Kind<R>);

#[derive(Clone, Debug)]
enum Kind<R> {
    Planes(Vec<Piece<R>, 6>),
    Distances(Distances<R>),
}

impl<R: Real> Pieces<R> {
    /// How many there are at most.
    pub fn len(&self) -> usize {
        match &self.0 {
            Kind::Planes(planes) => planes.len(),
            Kind::Distances(distances) => distances.len(),
        }
    }

    /// Whether there are none, which is never so.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// One of them. `None` if the index is too large, but for some smaller ones as well:
    /// parallel edges have no face between them.
    pub fn get(&self, index: usize) -> Option<Piece<R>> {
        match &self.0 {
            Kind::Planes(planes) => planes.get(index).copied(),
            Kind::Distances(distances) => distances.get(index),
        }
    }

    /// All of them.
    pub fn iter(&self) -> impl Iterator<Item = Piece<R>> + '_ {
        (0..self.len()).filter_map(|index| self.get(index))
    }

    /// Those of the least of some margins.
    pub(super) fn margins(slabs: impl IntoIterator<Item = Slab<R>>) -> Self {
        Pieces::planes(slabs.into_iter().flat_map(|slab| {
            let opposite = scale(slab.normal, -R::ONE);
            [slab.normal, opposite].map(|normal| Piece::plane(normal, -slab.bound))
        }))
    }

    /// That of a coordinate along a direction.
    pub(super) fn coordinate(normal: Vector3<R>) -> Self {
        Pieces::planes([Piece::plane(normal, R::ZERO)])
    }

    /// Those of the magnitude of a coordinate along a direction.
    pub(super) fn magnitude(normal: Vector3<R>) -> Self {
        let opposite = scale(normal, -R::ONE);
        Pieces::planes([normal, opposite].map(|normal| Piece::plane(normal, R::ZERO)))
    }

    fn planes(pieces: impl IntoIterator<Item = Piece<R>>) -> Self {
        let mut planes = Vec::new();
        for piece in pieces {
            // Three axes have two sides each, and there is room for six.
            let _ = planes.push(piece);
        }
        Pieces(Kind::Planes(planes))
    }

    pub(super) fn distances(distances: Distances<R>) -> Self {
        Pieces(Kind::Distances(distances))
    }
}

/// How far a coordinate along a direction of length one is from a bound, either way.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slab<R> {
    normal: Vector3<R>,
    bound: R,
}

impl<R: Real> Slab<R> {
    /// Where the centre of `a` may be for `a` to be in `b` along an axis of `b` that
    /// extends by `half`.
    pub(super) fn within(a: &Body<R>, normal: Vector3<R>, half: R) -> Self {
        let bound = half - a.extent(normal) - a.radius;
        Slab { normal, bound }
    }

    pub(super) fn margin(&self, d: Vector3<R>) -> R {
        self.bound - dot(d, self.normal).abs()
    }
}

/// The corners of a body's core, as seen from its centre.
#[derive(Clone, Debug)]
pub(super) struct Corners<R> {
    half_axes: Vec<Vector3<R>, 6>,
}

impl<R: Real> Corners<R> {
    /// The centre alone.
    pub(super) fn none() -> Self {
        Corners {
            half_axes: Vec::new(),
        }
    }

    /// Those of a body of which the first `count` axes count.
    pub(super) fn of(body: &Body<R>, count: usize) -> Self {
        Corners::between(body.sides(count).map(|(axis, half)| scale(axis, half)))
    }

    /// All sums of half axes and their opposites.
    pub(super) fn between(half_axes: impl Iterator<Item = Vector3<R>>) -> Self {
        let mut corners = Corners::none();
        for half_axis in half_axes {
            // Two bodies have no more than there is room for.
            let _ = corners.half_axes.push(half_axis);
        }
        corners
    }

    pub(super) fn len(&self) -> usize {
        1 << self.half_axes.len()
    }

    /// A bit of the index tells on which side of the centre a corner is along an axis.
    pub(super) fn get(&self, index: usize) -> Vector3<R> {
        let mut corner = [R::ZERO; 3];
        let mut bits = index;
        for half_axis in &self.half_axes {
            let sign = if bits & 1 == 0 { R::ONE } else { -R::ONE };
            corner = add(corner, scale(*half_axis, sign));
            bits >>= 1;
        }
        corner
    }
}

/// `factor * distance + offset`, where the distance is that of `d`, or of each of several
/// corners around it, from a polyhedron around the origin.
#[derive(Clone, Debug)]
pub(super) struct Distances<R> {
    pub(super) zonotope: Zonotope<R>,
    /// The polyhedron as it is seen along a direction in which nothing counts.
    pub(super) outline: Option<(View<R>, Zonogon<R>)>,
    pub(super) corners: Corners<R>,
    pub(super) factor: R,
    pub(super) offset: R,
}

impl<R: Real> Distances<R> {
    /// That of `d` from the polyhedron.
    pub(super) fn of(zonotope: Zonotope<R>, unseen: Option<Vector3<R>>) -> Self {
        let outline = unseen.map(|along| {
            let view = View::along(along);
            let outline = zonotope.outline(&view);
            (view, outline)
        });
        Distances {
            zonotope,
            outline,
            corners: Corners::none(),
            factor: R::ONE,
            offset: R::ZERO,
        }
    }

    fn len(&self) -> usize {
        self.corners.len() * self.len_per_corner()
    }

    fn get(&self, index: usize) -> Option<Piece<R>> {
        if index >= self.len() {
            return None;
        }
        let per_corner = self.len_per_corner();
        let corner = self.corners.get(index.checked_div(per_corner)?);
        let index = index.checked_rem(per_corner)?;
        let piece = match &self.outline {
            Some((view, outline)) => of_outline(view, outline, index),
            None => self.of_zonotope(index),
        };
        Some(piece?.transformed(corner, self.factor, self.offset))
    }

    fn len_per_corner(&self) -> usize {
        if let Some((_, outline)) = &self.outline {
            return 2 * outline.len() + Zonogon::<R>::corners_of(outline.len());
        }
        let count = self.zonotope.generators().len();
        2 * pairs(count) + count * self.edges_per_generator() + (1 << count)
    }

    /// How many edges there are along one generator, at most.
    fn edges_per_generator(&self) -> usize {
        let others = self.zonotope.generators().len().saturating_sub(1);
        Zonogon::<R>::corners_of(others)
    }

    /// Faces, edges, corners.
    fn of_zonotope(&self, index: usize) -> Option<Piece<R>> {
        let generators = self.zonotope.generators();
        let faces = 2 * pairs(generators.len());
        if index < faces {
            let face = self.zonotope.faces().nth(index / 2)??;
            let normal = signed(face.normal, index);
            return Some(Piece::plane(normal, face.extent));
        }
        let index = index - faces;
        let per_generator = self.edges_per_generator();
        if let Some(generator) = generators.get(index.checked_div(per_generator)?) {
            let view = View::along(generator.axis);
            let outline = self.zonotope.outline(&view);
            let corner = outline.corner(index.checked_rem(per_generator)?)?;
            return Some(Piece::length(view.lift(corner), Some(view.along)));
        }
        let index = index - per_generator * generators.len();
        let half_axes = generators.iter().map(|g| scale(g.axis, g.half));
        let corner = Corners::between(half_axes).get(index);
        Some(Piece::length(corner, None))
    }
}

/// Sides, corners.
fn of_outline<R: Real>(view: &View<R>, outline: &Zonogon<R>, index: usize) -> Option<Piece<R>> {
    if let Some((normal, extent)) = outline.side(index / 2) {
        let normal = signed(view.lift(normal), index);
        return Some(Piece::plane(normal, extent));
    }
    let corner = outline.corner(index - 2 * outline.len())?;
    Some(Piece::length(view.lift(corner), Some(view.along)))
}

/// How many pairs can be made of so many.
fn pairs(count: usize) -> usize {
    count * count.saturating_sub(1) / 2
}

/// A vector for even numbers, its opposite for odd ones.
pub(super) fn signed<R: Real>(vector: Vector3<R>, index: usize) -> Vector3<R> {
    if index.is_multiple_of(2) {
        vector
    } else {
        scale(vector, -R::ONE)
    }
}
