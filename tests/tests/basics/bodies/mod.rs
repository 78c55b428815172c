//! Bodies and the relations between them, against computations of another kind.

mod degenerate;
mod motion;
mod pieces;
mod swing;
mod values;

use critreg::geometry::{Axis, Body, Dimensions, Frame3, Relation};
use critreg::random::{Generator, below, uniform_in};
use std::f64::consts::{FRAC_PI_2, PI};

type Vector = [f64; 3];

const RELATIONS: [Relation; 13] = [
    Relation::Clear,
    Relation::Inside,
    Relation::InsideAlong(Axis::X),
    Relation::InsideAlong(Axis::Y),
    Relation::InsideAlong(Axis::Z),
    Relation::Over,
    Relation::Corner,
    Relation::Coordinate(Axis::X),
    Relation::Coordinate(Axis::Y),
    Relation::Coordinate(Axis::Z),
    Relation::Magnitude(Axis::X),
    Relation::Magnitude(Axis::Y),
    Relation::Magnitude(Axis::Z),
];

/// Which half sizes are not zero, and whether it is rounded.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Shape([bool; 3], bool);

const fn shape(sizes: [u8; 3], rounded: bool) -> Shape {
    Shape([sizes[0] > 0, sizes[1] > 0, sizes[2] > 0], rounded)
}

/// Points, balls, segments, capsules (one of them along y), rectangles and rounded ones;
/// in space they are plates.
const PLANE: [Shape; 7] = [
    shape([0, 0, 0], false),
    shape([0, 0, 0], true),
    shape([1, 0, 0], false),
    shape([1, 0, 0], true),
    shape([0, 1, 0], true),
    shape([1, 1, 0], false),
    shape([1, 1, 0], true),
];

/// Those, upright capsules and plates, and boxes.
const SPACE: [Shape; 11] = [
    PLANE[0],
    PLANE[1],
    PLANE[2],
    PLANE[3],
    PLANE[4],
    PLANE[5],
    PLANE[6],
    shape([0, 0, 1], true),
    shape([1, 0, 1], false),
    shape([1, 1, 1], false),
    shape([1, 1, 1], true),
];

fn shapes(dimensions: Dimensions) -> &'static [Shape] {
    match dimensions {
        Dimensions::Plane => &PLANE,
        Dimensions::Space => &SPACE,
    }
}

/// Every pair of shapes.
fn pairs(dimensions: Dimensions) -> impl Iterator<Item = [Shape; 2]> {
    let shapes = shapes(dimensions);
    shapes.iter().flat_map(|a| shapes.iter().map(|b| [*a, *b]))
}

fn vector(rng: &mut Generator, size: f64) -> Vector {
    [0; 3].map(|_| uniform_in(rng, -size, size))
}

fn turn(rng: &mut Generator, dimensions: Dimensions) -> Vector {
    match dimensions {
        Dimensions::Plane => [uniform_in(rng, -PI, PI), 0.0, 0.0],
        Dimensions::Space => vector(rng, PI),
    }
}

fn axes(turn: Vector) -> [Vector; 3] {
    Frame3::new([0.0; 3], turn).axes()
}

/// A body of a shape somewhere near the origin.
fn body(rng: &mut Generator, Shape(sized, rounded): Shape, axes: [Vector; 3]) -> Body<f64> {
    let size = |rng: &mut Generator, is: bool| if is { uniform_in(rng, 0.02, 0.5) } else { 0.0 };
    let half_sizes = sized.map(|is| size(rng, is));
    let radius = size(rng, rounded);
    Body::new(vector(rng, 0.7), axes, half_sizes, radius)
}

/// Two bodies. Of seven pairs one is not turned, two are turned alike up to quarter turns and
/// rounding, one shares an axis, and one is nearly turned alike.
fn pair(rng: &mut Generator, [a, b]: [Shape; 2], dimensions: Dimensions) -> [Body<f64>; 2] {
    let own = turn(rng, dimensions);
    let nearly = 0.1_f64.powf(uniform_in(rng, 2.0, 12.0));
    let quarter = FRAC_PI_2 * below(rng, 4) as f64;
    let turns = match below(rng, 7) {
        0 => [[0.0; 3], [quarter, 0.0, 0.0]],
        1 => [own, [own[0] + quarter, own[1], own[2]]],
        2 => [own, [own[0], own[1], own[2] + quarter]],
        3 => [own, [own[0] + 0.7, own[1], own[2]]],
        4 => [own, add(own, scale(turn(rng, dimensions), nearly))],
        _ => [own, turn(rng, dimensions)],
    };
    if dimensions == Dimensions::Plane {
        let [own, other] = turns.map(|[yaw, ..]| axes([yaw, 0.0, 0.0]));
        return [body(rng, a, own), body(rng, b, other)];
    }
    let [own, other] = turns.map(axes);
    [body(rng, a, own), body(rng, b, other)]
}

fn add(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|i| a[i] + b[i])
}

fn subtract(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|i| a[i] - b[i])
}

fn scale(a: Vector, factor: f64) -> Vector {
    a.map(|x| x * factor)
}

fn dot(a: Vector, b: Vector) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

fn norm(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// The half axes of a body that are not zero.
fn half_axes(body: &Body<f64>) -> Vec<Vector> {
    let sides = body.axes.iter().zip(body.half_sizes);
    let sized = sides.filter(|(_, half)| *half > 0.0);
    sized.map(|(axis, half)| scale(*axis, half)).collect()
}

/// A point and all sums of it and half axes or their opposites.
fn corners(centre: Vector, half_axes: &[Vector]) -> Vec<Vector> {
    half_axes.iter().fold(vec![centre], |corners, half| {
        let both = |corner: &Vector| [add(*corner, *half), subtract(*corner, *half)];
        corners.iter().flat_map(both).collect()
    })
}

/// A body somewhere else.
fn moved(body: &Body<f64>, step: Vector) -> Body<f64> {
    Body {
        centre: add(body.centre, step),
        ..*body
    }
}
