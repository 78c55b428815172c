//! Zonogons: what is left of two plane bodies when one is shrunk to a point.

use super::body::{Body, Dimensions};
use super::vector::Vector2;
use crate::real::Real;
use heapless::Vec;

/// Two directions count as parallel if the tangent of the angle between them is below so
/// many rounding errors.
const PARALLEL: f64 = 32.0;

/// A polygon around the origin: the sums of its *generators*, each times a number from -1
/// to 1.
///
/// The difference of two rectangles (the points of one minus those of the other) is a
/// zonogon whose generators are the half axes of both, so the distance of the rectangles
/// is that of one point from one polygon.
#[derive(Clone, Debug)]
pub(super) struct Zonogon<R> {
    generators: Vec<Vector2<R>, 6>,
}

/// One of the two equal and opposite sides along a generator.
pub(super) struct Side<R> {
    /// From the middle of the side to its end, counter-clockwise around the polygon.
    pub(super) half: Vector2<R>,
    /// The middle of the side.
    pub(super) middle: Vector2<R>,
    /// Across the side and outwards; of length one.
    pub(super) normal: Vector2<R>,
    /// How far the side lies from the origin.
    pub(super) extent: R,
}

impl<R: Real> Zonogon<R> {
    pub(super) fn new() -> Self {
        Zonogon {
            generators: Vec::new(),
        }
    }

    /// That of two bodies in the plane: the difference of their cores, moved to the origin.
    pub(super) fn of(bodies: [&Body<R>; 2]) -> Self {
        let mut zonogon = Zonogon::new();
        for body in bodies {
            for ([x, y, _], half) in body.sides(Dimensions::Plane.count()) {
                zonogon.add([x * half, y * half]);
            }
        }
        zonogon
    }

    /// With one generator more; a seventh is ignored, because two bodies have six.
    pub(super) fn add(&mut self, generator: Vector2<R>) {
        let _ = self.generators.push(generator);
    }

    /// How many generators it has, and so how many sides in pairs.
    pub(super) fn len(&self) -> usize {
        self.generators.len()
    }

    /// The side along a generator, one of two. Sides along parallel generators are one side,
    /// which then stands for each of them.
    pub(super) fn side(&self, index: usize) -> Option<Side<R>> {
        let along = self.generators.get(index)?;
        Some(self.side_along(*along))
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
        let side = self.side(index / 2)?;
        let ([mx, my], [hx, hy]) = (side.middle, side.half);
        let (x, y) = (mx + hx, my + hy);
        Some(if index.is_multiple_of(2) {
            [x, y]
        } else {
            [-x, -y]
        })
    }

    fn side_along(&self, [x, y]: Vector2<R>) -> Side<R> {
        let length = (x * x + y * y).sqrt();
        let [x, y] = [x / length, y / length];
        let parallel = R::from_f64(PARALLEL) * R::EPSILON;
        let mut side = Side {
            half: [R::ZERO; 2],
            middle: [R::ZERO; 2],
            normal: [y, -x],
            extent: R::ZERO,
        };
        for &[gx, gy] in &self.generators {
            let outwards = gx * y - gy * x;
            let onwards = gx * x + gy * y;
            if outwards.abs() <= parallel * onwards.abs() {
                add_signed(&mut side.half, [gx, gy], onwards);
            } else {
                side.extent += outwards.abs();
                add_signed(&mut side.middle, [gx, gy], outwards);
            }
        }
        side
    }

    /// The distance of a point from the polygon; below zero, how deep it lies inside.
    pub(super) fn signed_distance(&self, point: Vector2<R>) -> R {
        let mut highest = R::NEG_INFINITY;
        let mut nearest = R::INFINITY;
        for along in &self.generators {
            let side = self.side_along(*along);
            let height = side.height(point);
            highest = highest.max(height);
            // The nearest point lies on a side that is seen from the point.
            if height > R::ZERO {
                nearest = nearest.min(side.distance_squared(point));
            }
        }
        if highest > R::ZERO {
            nearest.sqrt()
        } else if highest < -self.rounding(point) {
            highest
        } else {
            self.distance_from_outline(point)
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
        let sides = self.generators.iter().map(|along| self.side_along(*along));
        sides
            .fold(R::INFINITY, |nearest, side| {
                nearest.min(side.distance_squared([x, y]))
            })
            .sqrt()
    }

    /// What the coordinates of a point relative to the polygon may be off by rounding.
    fn rounding(&self, [x, y]: Vector2<R>) -> R {
        let sizes = self.generators.iter();
        let size = sizes.fold(x.abs() + y.abs(), |sum, [x, y]| sum + x.abs() + y.abs());
        R::from_f64(8.0) * R::EPSILON * size
    }
}

impl<R: Real> Side<R> {
    /// How far beyond this side, or the opposite one, a point lies.
    fn height(&self, [x, y]: Vector2<R>) -> R {
        let [nx, ny] = self.normal;
        (x * nx + y * ny).abs() - self.extent
    }

    /// The square of the distance of a point from this side or the opposite one, whichever
    /// is on its side of the origin.
    fn distance_squared(&self, [x, y]: Vector2<R>) -> R {
        let ([nx, ny], [hx, hy], [mx, my]) = (self.normal, self.half, self.middle);
        let [x, y] = if x * nx + y * ny < R::ZERO {
            [-x, -y]
        } else {
            [x, y]
        };
        let [x, y] = [x - mx, y - my];
        let part = ((x * hx + y * hy) / (hx * hx + hy * hy)).clamp(-R::ONE, R::ONE);
        let [x, y] = [x - part * hx, y - part * hy];
        x * x + y * y
    }
}

/// Adds a vector or its opposite, by the sign of a number.
fn add_signed<R: Real>([x, y]: &mut Vector2<R>, [dx, dy]: Vector2<R>, sign: R) {
    if sign < R::ZERO {
        *x -= dx;
        *y -= dy;
    } else {
        *x += dx;
        *y += dy;
    }
}
