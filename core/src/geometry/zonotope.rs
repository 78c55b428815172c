//! Zonotopes: what is left of two bodies in space when one is shrunk to a point.

use super::body::{Body, level_normal};
use super::vector::{Vector2, Vector3, cross, dot, scale, subtract};
use super::zonogon::Zonogon;
use crate::real::Real;
use heapless::Vec;

/// Two directions count as parallel, and one as lying in a plane, if the sine of the angle
/// between them is below so many rounding errors.
const PARALLEL: f64 = 32.0;

/// A polyhedron around the origin: the sums of its *generators*, each times a number from
/// -1 to 1. The zonotope of two bodies is the difference of their cores, moved to the origin.
#[derive(Clone, Debug)]
pub(super) struct Zonotope<R> {
    generators: Vec<Generator<R>, 6>,
}

/// A generator: its direction, of length one, and its length.
#[derive(Clone, Copy, Debug)]
pub(super) struct Generator<R> {
    pub(super) axis: Vector3<R>,
    pub(super) half: R,
}

/// One of two equal and opposite faces; its normal points outwards and has length one.
#[derive(Clone, Copy)]
pub(super) struct Face<R> {
    pub(super) normal: Vector3<R>,
    /// How far the face lies from the origin.
    pub(super) extent: R,
    /// The direction of one of its edges.
    edge: Vector3<R>,
}

impl<R: Real> Zonotope<R> {
    /// That of bodies of which the first `count` axes count.
    pub(super) fn of<'a>(bodies: impl IntoIterator<Item = &'a Body<R>>, count: usize) -> Self {
        let mut generators = Vec::new();
        for body in bodies {
            for (axis, half) in body.sides(count) {
                // Two bodies have no more than there is room for.
                let _ = generators.push(Generator { axis, half });
            }
        }
        Zonotope { generators }
    }

    pub(super) fn generators(&self) -> &[Generator<R>] {
        &self.generators
    }

    /// The face along two generators, one of two; `None` if they are parallel. Faces in one
    /// plane are one face, which then stands for each pair of its generators.
    fn face(&self, one: &Generator<R>, other: &Generator<R>) -> Option<Face<R>> {
        let across = cross(one.axis, other.axis);
        // Among nearly parallel directions rounding can leave a part along one of them.
        let across = subtract(across, scale(one.axis, dot(across, one.axis)));
        let squared = dot(across, across);
        let parallel = R::from_f64(PARALLEL) * R::EPSILON;
        if !(squared > parallel * parallel) {
            return None;
        }
        let normal = scale(across, R::ONE / squared.sqrt());
        let extent = self.generators.iter().fold(R::ZERO, |sum, generator| {
            sum + dot(generator.axis, normal).abs() * generator.half
        });
        Some(Face {
            normal,
            extent,
            edge: one.axis,
        })
    }

    /// The face along each pair of generators, one of two; `None` for parallel ones.
    pub(super) fn faces(&self) -> impl Iterator<Item = Option<Face<R>>> + '_ {
        let pairs = self.generators.iter().enumerate().flat_map(|(count, one)| {
            let earlier = self.generators.iter().take(count);
            earlier.map(move |other| (one, other))
        });
        pairs.map(|(one, other)| self.face(one, other))
    }

    /// The distance of a point from the polyhedron; below zero, how deep it lies inside.
    pub(super) fn signed_distance(&self, point: Vector3<R>) -> R {
        let mut highest: Option<(R, Face<R>)> = None;
        for face in self.faces().flatten() {
            let height = face.height(point);
            if highest.is_none_or(|(most, _)| height > most) {
                highest = Some((height, face));
            }
        }
        let Some((height, face)) = highest else {
            return self.distance_from_line(point);
        };
        let rounding = self.rounding(point);
        if height < -rounding {
            return height;
        }
        // No point of the polyhedron is nearer than the highest face is below.
        let mut nearest = self.distance_from_face(&face, point);
        if nearest <= height.max(R::ZERO) + rounding {
            return nearest;
        }
        // The nearest point lies on a face that is seen from the point.
        for face in self.faces().flatten() {
            let height = face.height(point);
            if -rounding <= height && height < nearest {
                nearest = nearest.min(self.distance_from_face(&face, point));
            }
        }
        nearest
    }

    /// The distance from a point to a face or the opposite one, whichever is on its side.
    fn distance_from_face(&self, face: &Face<R>, point: Vector3<R>) -> R {
        let in_plane = R::from_f64(PARALLEL) * R::EPSILON;
        let view = View::with_right(face.normal, face.edge);
        let point = if dot(point, face.normal) < R::ZERO {
            scale(point, -R::ONE)
        } else {
            point
        };
        let mut outline = Zonogon::new();
        let mut beside = point;
        for generator in &self.generators {
            let rise = dot(generator.axis, face.normal);
            let half = generator.half;
            if rise.abs() <= in_plane {
                outline.add(view.project(scale(generator.axis, half)));
            } else {
                let half = if rise < R::ZERO { -half } else { half };
                beside = subtract(beside, scale(generator.axis, half));
            }
        }
        let height = face.height(point).max(R::ZERO);
        let aside = outline.signed_distance(view.project(beside)).max(R::ZERO);
        (height * height + aside * aside).sqrt()
    }

    /// The distance from a point, if all generators are along one line.
    fn distance_from_line(&self, point: Vector3<R>) -> R {
        let Some(first) = self.generators.first() else {
            return dot(point, point).sqrt();
        };
        let halves = self.generators.iter().map(|generator| generator.half);
        let half = halves.fold(R::ZERO, |sum, half| sum + half);
        let foot = dot(point, first.axis).clamp(-half, half);
        let offset = subtract(point, scale(first.axis, foot));
        dot(offset, offset).sqrt()
    }

    /// What the coordinates of a point relative to the polyhedron may be off by rounding.
    fn rounding(&self, [x, y, z]: Vector3<R>) -> R {
        let halves = self.generators.iter().map(|generator| generator.half);
        let size = halves.fold(x.abs() + y.abs() + z.abs(), |sum, half| sum + half);
        R::from_f64(8.0) * R::EPSILON * size
    }

    /// How it looks along a direction of length one. Generators along it are not seen.
    pub(super) fn outline(&self, view: &View<R>) -> Zonogon<R> {
        let end_on = R::from_f64(PARALLEL) * R::EPSILON;
        let mut outline = Zonogon::new();
        for generator in &self.generators {
            let [x, y] = view.project(generator.axis);
            if x * x + y * y > end_on * end_on {
                outline.add([x * generator.half, y * generator.half]);
            }
        }
        outline
    }
}

impl<R: Real> Face<R> {
    /// How far beyond this face, or the opposite one, a point lies.
    fn height(&self, point: Vector3<R>) -> R {
        dot(point, self.normal).abs() - self.extent
    }
}

/// A direction to look along, and what is right and up there: unit vectors at right angles.
#[derive(Clone, Debug)]
pub(super) struct View<R> {
    pub(super) along: Vector3<R>,
    right: Vector3<R>,
    up: Vector3<R>,
}

impl<R: Real> View<R> {
    pub(super) fn along(along: Vector3<R>) -> Self {
        View::with_right(along, level_normal(along))
    }

    fn with_right(along: Vector3<R>, right: Vector3<R>) -> Self {
        let up = cross(along, right);
        View { along, right, up }
    }

    pub(super) fn project(&self, vector: Vector3<R>) -> Vector2<R> {
        [dot(vector, self.right), dot(vector, self.up)]
    }

    /// The vector across the view that is seen as this one.
    pub(super) fn lift(&self, [x, y]: Vector2<R>) -> Vector3<R> {
        let ([a, b, c], [d, e, f]) = (self.right, self.up);
        [a * x + d * y, b * x + e * y, c * x + f * y]
    }
}
