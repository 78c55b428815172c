//! Relations between two bodies: how far apart they are, how far one is inside of the
//! other.

use super::body::{Body, Dimensions};
use super::pieces::{Corners, Distances, Pieces, Slab};
use super::vector::{Vector3, add, cross, dot, scale, subtract};
use super::zonogon::Zonogon;
use super::zonotope::Zonotope;
use crate::real::Real;

/// One of the axes of a body's own frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Axis {
    /// The first one.
    X,
    /// The second one.
    Y,
    /// The third one. In the plane it does not count.
    Z,
}

impl Axis {
    fn of<T: Copy>(self, [x, y, z]: [T; 3]) -> T {
        match self {
            Axis::X => x,
            Axis::Y => y,
            Axis::Z => z,
        }
    }
}

/// What can be said of a body `a` relative to a body `b`, as a length.
///
/// All but the last two are positive where what they say holds with room to spare. The value
/// is NaN if a body is absent. *Corners* are those of the core: where `a` is rounded, a
/// corner stands for the ball around it.
///
/// ```
/// use critreg::geometry::{Body, Dimensions::Space, Relation};
/// let table = Body::new([0.0, 0.0, -0.5], Body::UPRIGHT, [1.0, 0.5, 0.5], 0.0);
/// let ball = Body::ball([1.03, 0.2, 0.14], 0.1);
/// assert!((Relation::Over.value(&ball, &table, Space) + 0.03_f64).abs() < 1e-12);
/// let clear = Relation::Clear.value(&ball, &table, Space);
/// assert!((clear - 0.03_f64.hypot(0.14) + 0.1).abs() < 1e-12);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// How far apart they are; below zero, how far one must move until they only touch.
    Clear,
    /// How much room there is around `a` in `b`; below zero, how far `a` sticks out.
    ///
    /// If `b` is not rounded, it is the least of the room along its axes, and a size of zero
    /// sets no limit: inside of a plate is what is within its outline. If `b` is rounded or
    /// a point, it is the least depth of a corner of `a` in `b`.
    Inside,
    /// How much room there is around `a` in `b` along one axis of `b`.
    InsideAlong(Axis),
    /// How far the centre of `a` is inside of what the x and y axis of `b` span, whatever
    /// its z there: the margin of support.
    Over,
    /// How far the nearest corner of `a` is from `b`; above zero, no corner of `a` is in `b`.
    Corner,
    /// A coordinate of the centre of `a` in the frame of `b`.
    Coordinate(Axis),
    /// The magnitude of that coordinate.
    Magnitude(Axis),
}

/// How many axes of a body span what can stand on it.
const FOOTPRINT: usize = 2;

impl Relation {
    /// The value for two bodies. Distances are Euclidean; the depth of two bodies in each
    /// other is that along the separating axis where it is least (Gottschalk, Lin and
    /// Manocha 1996).
    pub fn value<R: Real>(self, a: &Body<R>, b: &Body<R>, dimensions: Dimensions) -> R {
        let d = difference(a, b, dimensions);
        let [x, y, z] = d;
        // Infinities, too: they would end in the difference of two of them.
        if !(x + y + z).is_finite() {
            return R::NAN;
        }
        let count = dimensions.count();
        match self {
            Relation::Clear => distance(a, b, d, dimensions) - (a.radius + b.radius),
            Relation::Inside => room(a, b, d, count),
            Relation::InsideAlong(axis) => room_along(a, b, axis, dimensions).margin(d),
            Relation::Over => room(&Body::point(a.centre), b, d, FOOTPRINT),
            Relation::Corner => nearest_corner(a, b, d, count) - (a.radius + b.radius),
            Relation::Coordinate(axis) => dot(d, direction(b, axis, dimensions)),
            Relation::Magnitude(axis) => dot(d, direction(b, axis, dimensions)).abs(),
        }
    }

    /// The pieces that the value is made of while neither body turns: functions of the
    /// vector from the centre of `b` to the centre of `a`.
    pub fn pieces<R: Real>(self, a: &Body<R>, b: &Body<R>, dimensions: Dimensions) -> Pieces<R> {
        let count = dimensions.count();
        let unseen = match dimensions {
            Dimensions::Plane => Some([R::ZERO, R::ZERO, R::ONE]),
            Dimensions::Space => None,
        };
        match self {
            Relation::Clear => Pieces::distances(Distances {
                offset: -(a.radius + b.radius),
                ..Distances::of(Zonotope::of([a, b], count), unseen)
            }),
            Relation::Inside => room_pieces(a, b, count, unseen),
            Relation::InsideAlong(axis) => Pieces::margins([room_along(a, b, axis, dimensions)]),
            Relation::Over => {
                let unseen = unseen.or(Some(Axis::Z.of(b.axes)));
                room_pieces(&Body::point(a.centre), b, FOOTPRINT, unseen)
            }
            Relation::Corner => Pieces::distances(Distances {
                corners: Corners::of(a, count),
                offset: -(a.radius + b.radius),
                ..Distances::of(Zonotope::of([b], count), unseen)
            }),
            Relation::Coordinate(axis) => Pieces::coordinate(direction(b, axis, dimensions)),
            Relation::Magnitude(axis) => Pieces::magnitude(direction(b, axis, dimensions)),
        }
    }
}

/// By how much the direction from the centre of `b` to that of `a` is off the x axis of `b`:
/// an angle in `[0, pi]`, zero if the centres are one point.
///
/// It has no pieces (along a line it equals `k` where `(d . x)^2 = cos(k)^2 |d|^2`), and
/// [`lipschitz`] does not bound it: near the centre of `b` it changes at once.
pub fn off<R: Real>(a: &Body<R>, b: &Body<R>, dimensions: Dimensions) -> R {
    let d = difference(a, b, dimensions);
    let x_axis = Axis::X.of(b.axes);
    let aside = cross(d, x_axis);
    dot(aside, aside).sqrt().atan2(dot(d, x_axis))
}

/// How much the value of any [`Relation`], or a [`sight`](super::sight), can change when one of two
/// bodies moves by at most `moved` and turns by at most `turned` radians (from zero), about
/// a point from which no corner of `a` is farther than `reach` (see [`Body::reach`]).
///
/// Where `b` turns, it is still the corners of `a` that count, as seen from what `b` turns
/// about, because `a` turns about it as seen from `b`. Of several motions, one after the
/// other, the bounds are added.
pub fn lipschitz<R: Real>(moved: R, turned: R, reach: R) -> R {
    let half = R::from_f64(0.5);
    let most = R::from_f64(core::f64::consts::PI);
    let (sin, _) = (turned.min(most) * half).sin_cos();
    moved + (reach + reach) * sin
}

/// A vector; in the plane without its z.
pub(super) fn counted<R: Real>([x, y, z]: Vector3<R>, dimensions: Dimensions) -> Vector3<R> {
    match dimensions {
        Dimensions::Plane => [x, y, R::ZERO],
        Dimensions::Space => [x, y, z],
    }
}

/// An axis of a body.
fn direction<R: Real>(body: &Body<R>, axis: Axis, dimensions: Dimensions) -> Vector3<R> {
    counted(axis.of(body.axes), dimensions)
}

/// The vector from the centre of `b` to that of `a`.
fn difference<R: Real>(a: &Body<R>, b: &Body<R>, dimensions: Dimensions) -> Vector3<R> {
    counted(subtract(a.centre, b.centre), dimensions)
}

/// The distance of two cores whose centres differ by `d`; below zero, how deep they are in
/// each other.
fn distance<R: Real>(a: &Body<R>, b: &Body<R>, d: Vector3<R>, dimensions: Dimensions) -> R {
    let count = dimensions.count();
    if a.sides(count).next().is_none() {
        return b.distance_from_core(b.local(d), count);
    }
    if b.sides(count).next().is_none() {
        return a.distance_from_core(a.local(d), count);
    }
    match dimensions {
        Dimensions::Plane => {
            let [x, y, _] = d;
            Zonogon::of([a, b]).signed_distance([x, y])
        }
        Dimensions::Space => {
            let distance = Zonotope::of([a, b], count).distance_unless_from_edge(d);
            // Of two bodies that are nearest at an edge of one of them, one is so at a corner.
            distance.unwrap_or_else(|| {
                let opposite = subtract([R::ZERO; 3], d);
                let nearest = nearest_corner(a, b, d, count);
                nearest.min(nearest_corner(b, a, opposite, count))
            })
        }
    }
}

/// [`Relation::Inside`] with the first `count` axes of `b`.
fn room<R: Real>(a: &Body<R>, b: &Body<R>, d: Vector3<R>, count: usize) -> R {
    if has_corners(b, count) {
        let rooms = slabs(a, b, count).map(|slab| slab.margin(d));
        return rooms.fold(R::INFINITY, R::min);
    }
    let farthest = fold_corners(a, b, d, count, R::NEG_INFINITY, R::max);
    b.radius - a.radius - farthest
}

fn room_pieces<R: Real>(
    a: &Body<R>,
    b: &Body<R>,
    count: usize,
    unseen: Option<Vector3<R>>,
) -> Pieces<R> {
    if has_corners(b, count) {
        return Pieces::margins(slabs(a, b, count));
    }
    Pieces::distances(Distances {
        corners: Corners::of(a, count),
        factor: -R::ONE,
        offset: b.radius - a.radius,
        ..Distances::of(Zonotope::of([b], count), unseen)
    })
}

/// Whether a body has a size, but no rounding.
fn has_corners<R: Real>(body: &Body<R>, count: usize) -> bool {
    body.radius == R::ZERO && body.sides(count).next().is_some()
}

/// The room of `a` in `b` along each of the first `count` axes along which `b` has a size.
fn slabs<R: Real>(a: &Body<R>, b: &Body<R>, count: usize) -> impl Iterator<Item = Slab<R>> {
    let sides = b.sides(count);
    sides.map(|(axis, half)| Slab::within(a, axis, half))
}

/// [`Relation::InsideAlong`].
fn room_along<R: Real>(a: &Body<R>, b: &Body<R>, axis: Axis, dimensions: Dimensions) -> Slab<R> {
    let half = axis.of(b.half_sizes) + b.radius;
    Slab::within(a, direction(b, axis, dimensions), half)
}

/// How far the nearest corner of `a` is from the core of `b`; below zero, how deep the
/// deepest is in it.
fn nearest_corner<R: Real>(a: &Body<R>, b: &Body<R>, d: Vector3<R>, count: usize) -> R {
    fold_corners(a, b, d, count, R::INFINITY, R::min)
}

/// The least or the greatest of how far the corners of `a` are from the core of `b`.
fn fold_corners<R: Real>(
    a: &Body<R>,
    b: &Body<R>,
    d: Vector3<R>,
    count: usize,
    start: R,
    choose: impl Fn(R, R) -> R,
) -> R {
    let centre = b.local(d);
    let half_axes = a
        .sides(count)
        .map(|(axis, half)| scale(b.local(axis), half));
    let corners = Corners::between(half_axes);
    (0..corners.len()).fold(start, |chosen, index| {
        let corner = add(centre, corners.get(index));
        choose(chosen, b.distance_from_core(corner, count))
    })
}
