//! Zonogons: what is left of two plane bodies when one is shrunk to a point.

use super::body::{Body, Dimensions};
use super::vector::Vector2;
use crate::real::Real;
use heapless::Vec;

/// A polygon around the origin: the sums of its *generators*, each times a number from -1
/// to 1.
///
/// The difference of two rectangles (the points of one minus those of the other) is a
/// zonogon whose generators are the half axes of both, so the distance of the rectangles
/// is that of one point from one polygon.
#[derive(Clone, Debug)]
pub(super) struct Zonogon<R> {
    generators: Vec<Generator<R>, 6>,
}

#[derive(Clone, Copy, Debug)]
struct Generator<R> {
    /// Its direction, of length one.
    axis: Vector2<R>,
    /// Its length.
    half: R,
}

/// One of the two equal and opposite sides along a generator.
#[derive(Clone, Copy)]
pub(super) struct Side<R> {
    /// Along the side, counter-clockwise around the polygon.
    along: Vector2<R>,
    /// Half the length of the side.
    half: R,
    middle: Vector2<R>,
}

impl<R: Real> Zonogon<R> {
    pub(super) fn new() -> Self {
        Zonogon {
            generators: Vec::new(),
        }
    }

    /// That of two bodies: the difference of their cores, moved to the origin.
    pub(super) fn of(bodies: [&Body<R>; 2]) -> Self {
        let mut zonogon = Zonogon::new();
        for body in bodies {
            for ([x, y, _], half) in body.sides(Dimensions::Plane.count()) {
                zonogon.add([x, y], half);
            }
        }
        zonogon
    }

    /// With one generator more, along a direction of length one. A seventh is ignored,
    /// because two bodies have six.
    pub(super) fn add(&mut self, axis: Vector2<R>, half: R) {
        let _ = self.generators.push(Generator { axis, half });
    }

    /// How many generators it has, and so how many sides in pairs.
    pub(super) fn len(&self) -> usize {
        self.generators.len()
    }

    /// The normal of a side along a generator, one of two, and how far the side lies from
    /// the origin.
    pub(super) fn side(&self, index: usize) -> Option<(Vector2<R>, R)> {
        let [x, y] = self.generators.get(index)?.axis;
        Some(([y, -x], self.extent([y, -x])))
    }

    /// How many corners so many generators make.
    pub(super) fn corners_of(generators: usize) -> usize {
        (2 * generators).max(1)
    }

    /// A corner, by an index below [`Self::corners_of`].
    pub(super) fn corner(&self, index: usize) -> Option<Vector2<R>> {
        if self.generators.is_empty() && index == 0 {
            return Some([R::ZERO; 2]);
        }
        let axis = self.generators.get(index / 2)?.axis;
        let side = self.side_along(axis);
        let ([mx, my], [x, y]) = (side.middle, side.along);
        let (x, y) = (mx + x * side.half, my + y * side.half);
        Some(if index.is_multiple_of(2) {
            [x, y]
        } else {
            [-x, -y]
        })
    }

    /// How far it reaches from the origin along a direction of length one.
    fn extent(&self, [x, y]: Vector2<R>) -> R {
        self.generators.iter().fold(R::ZERO, |sum, generator| {
            let [gx, gy] = generator.axis;
            sum + (gx * x + gy * y).abs() * generator.half
        })
    }

    /// The side along a direction. Sides along parallel generators are one side, which then
    /// stands for each of them.
    ///
    /// Rounding cannot turn the sign of a difference of two products, only make it zero. So
    /// generators that are parallel but for rounding are in one order from all sides.
    fn side_along(&self, [x, y]: Vector2<R>) -> Side<R> {
        let mut side = Side {
            along: [x, y],
            half: R::ZERO,
            middle: [R::ZERO; 2],
        };
        for &Generator { axis, half } in &self.generators {
            let [gx, gy] = axis;
            let outwards = gx * y - gy * x;
            if outwards == R::ZERO {
                side.half += half;
            } else {
                let half = if outwards < R::ZERO { -half } else { half };
                let [mx, my] = side.middle;
                side.middle = [mx + gx * half, my + gy * half];
            }
        }
        side
    }

    /// The distance of a point from the polygon; below zero, how deep it lies inside.
    pub(super) fn signed_distance(&self, [x, y]: Vector2<R>) -> R {
        let mut highest = R::NEG_INFINITY;
        let mut nearest = R::INFINITY;
        for generator in &self.generators {
            let [ax, ay] = generator.axis;
            let height = (x * ay - y * ax).abs() - self.extent([ay, -ax]);
            highest = highest.max(height);
            // The nearest point lies on a side that is seen from the point.
            if height > R::ZERO {
                let side = self.side_along(generator.axis);
                nearest = nearest.min(side.distance_squared([x, y]));
            }
        }
        if highest > R::ZERO {
            nearest.sqrt()
        } else if highest < -self.rounding([x, y]) {
            highest
        } else {
            self.distance_from_outline([x, y])
        }
    }

    /// The distance from a point to the outline.
    ///
    /// It is the distance from the polygon where that has no inside, but is a segment or a
    /// point, and where a point lies on the outline but for rounding.
    fn distance_from_outline(&self, [x, y]: Vector2<R>) -> R {
        if self.generators.is_empty() {
            return (x * x + y * y).sqrt();
        }
        let sides = self.generators.iter().map(|g| self.side_along(g.axis));
        let squares = sides.map(|side| side.distance_squared([x, y]));
        squares.fold(R::INFINITY, R::min).sqrt()
    }

    /// What the coordinates of a point relative to the polygon may be off by rounding.
    fn rounding(&self, [x, y]: Vector2<R>) -> R {
        let sizes = self.generators.iter().map(|generator| generator.half);
        let size = sizes.fold(x.abs() + y.abs(), |sum, half| sum + half);
        R::from_f64(8.0) * R::EPSILON * size
    }
}

impl<R: Real> Side<R> {
    /// The square of the distance of a point from this side or the opposite one, whichever
    /// is on its side of the origin.
    fn distance_squared(&self, [x, y]: Vector2<R>) -> R {
        let ([ax, ay], [mx, my]) = (self.along, self.middle);
        let [x, y] = if x * ay < y * ax { [-x, -y] } else { [x, y] };
        let [x, y] = [x - mx, y - my];
        let foot = (x * ax + y * ay).clamp(-self.half, self.half);
        let [x, y] = [x - foot * ax, y - foot * ay];
        x * x + y * y
    }
}
