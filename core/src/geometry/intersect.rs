//! Whether two shapes meet.
//!
//! Those of plane shapes are the tests of the Predicators framework, with its choices
//! at the boundary: circles and crossing sides must overlap (strict), while points on a
//! rim or a side count as inside (closed). Each of them begins with the circles
//! around the shapes, which decides most pairs without a look at any side.

use super::shape::{Circle, Rectangle, Segment};
use super::vector::{Vector2, between, distance, distance_squared};
use crate::real::Real;

/// How far, in length units, the foot of a perpendicular may miss a segment by
/// rounding and still count as on it.
const ON_SEGMENT_TOLERANCE: f64 = 1e-6;

/// Whether two shapes meet.
///
/// ```
/// use critreg::geometry::{Circle, Intersects, Rectangle};
/// let hand = Circle { centre: [1.0, 1.0], radius: 0.1 };
/// let stick = Rectangle::new([0.0, 1.05], [3.0, 0.05], 0.0);
/// assert!(stick.intersects(&hand));
/// ```
pub trait Intersects<Other> {
    /// Whether the two shapes meet; see each implementation for touching shapes.
    fn intersects(&self, other: &Other) -> bool;
}

impl<R: Real> Intersects<Circle<R>> for Circle<R> {
    /// Touching circles do not meet.
    fn intersects(&self, other: &Circle<R>) -> bool {
        let reach = self.radius + other.radius;
        distance_squared(self.centre, other.centre) < reach * reach
    }
}

impl<R: Real> Intersects<Circle<R>> for Segment<R> {
    /// A segment that touches the circle meets it.
    fn intersects(&self, circle: &Circle<R>) -> bool {
        if circle.contains(self.start) || circle.contains(self.end) {
            return true;
        }
        let foot = self.foot(circle.centre);
        circle.contains(foot) && {
            let length = distance(self.start, self.end);
            let detour = distance(self.start, foot) + distance(foot, self.end) - length;
            // The second bound matters only for scalars coarser than the tolerance.
            let rounding = R::from_f64(8.0) * R::EPSILON * length;
            detour.abs() < R::from_f64(ON_SEGMENT_TOLERANCE).max(rounding)
        }
    }
}

impl<R: Real> Intersects<Segment<R>> for Segment<R> {
    /// Only segments that cross properly meet: touching or collinear ones do not.
    fn intersects(&self, other: &Segment<R>) -> bool {
        separates(self, other) && separates(other, self)
    }
}

impl<R: Real> Intersects<Circle<R>> for Rectangle<R> {
    /// A circle that touches a side from outside meets the rectangle, unless it
    /// only touches the circle around the rectangle (at a corner).
    fn intersects(&self, circle: &Circle<R>) -> bool {
        self.circumscribed().intersects(circle)
            && (self.contains(circle.centre)
                || self.sides().iter().any(|side| side.intersects(circle)))
    }
}

impl<R: Real> Intersects<Rectangle<R>> for Circle<R> {
    /// As the circle meets the rectangle.
    fn intersects(&self, rectangle: &Rectangle<R>) -> bool {
        rectangle.intersects(self)
    }
}

impl<R: Real> Intersects<Rectangle<R>> for Rectangle<R> {
    /// Rectangles meet if sides cross properly or the centre of one lies in the
    /// other. So a shared side, or an overlap along collinear sides that holds
    /// neither centre, does not count.
    fn intersects(&self, other: &Rectangle<R>) -> bool {
        let (around, around_other) = (self.circumscribed(), other.circumscribed());
        if !around.intersects(&around_other) {
            return false;
        }
        let others = other.sides();
        let crosses = |side: &Segment<R>| others.iter().any(|s| side.intersects(s));
        self.sides().iter().any(crosses)
            || self.contains(around_other.centre)
            || other.contains(around.centre)
    }
}

/// Whether the ends of `segment` lie strictly on different sides of the line
/// through `line`.
fn separates<R: Real>(line: &Segment<R>, segment: &Segment<R>) -> bool {
    let start = turn(line, segment.start);
    let end = turn(line, segment.end);
    (start < R::ZERO && R::ZERO < end) || (end < R::ZERO && R::ZERO < start)
}

/// Positive if `point` lies to the left of the line, negative to the right.
fn turn<R: Real>(line: &Segment<R>, point: Vector2<R>) -> R {
    let [dx, dy] = between(line.start, line.end);
    let [px, py] = between(line.start, point);
    dx * py - dy * px
}
