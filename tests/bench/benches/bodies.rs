//! How long a relation between two bodies takes: `cargo bench -p critreg-bench --bench bodies`.

use criterion::{Criterion, criterion_group, criterion_main};
use critreg::geometry::Dimensions::{Plane, Space};
use critreg::geometry::{Axis, Body, Dimensions, Frame3, Relation, lipschitz, off, sight};
use std::hint::black_box;

/// What is near a body at the origin, so that some pairs overlap and some do not.
const PLACES: [[f64; 3]; 4] = [
    [0.2, 0.1, 0.1],
    [1.1, 0.3, 0.2],
    [0.9, 0.8, 0.7],
    [-3.0, 1.0, 0.4],
];

/// A body of one of the shapes that the benchmarks are named after.
fn body(shape: &str, turn: [f64; 3]) -> Body<f64> {
    let (half_sizes, radius) = match shape {
        "ball" => ([0.0; 3], 0.3),
        "capsule" => ([0.5, 0.0, 0.0], 0.1),
        "rectangle" => ([0.6, 0.4, 0.0], 0.0),
        "rounded rectangle" => ([0.6, 0.4, 0.0], 0.1),
        _ => ([0.6, 0.4, 0.3], 0.0),
    };
    let axes = Frame3::new([0.0; 3], turn).axes();
    Body::new([0.0; 3], axes, half_sizes, radius)
}

/// The pair of a name such as `ball box`, at each of the places.
fn pairs(shapes: [&str; 2], dimensions: Dimensions) -> [[Body<f64>; 2]; 4] {
    let tilt = match dimensions {
        Plane => [0.0; 2],
        Space => [0.4, -1.1],
    };
    PLACES.map(|centre| {
        let a = body(shapes[0], [0.3, tilt[0], tilt[1]]);
        [Body { centre, ..a }, body(shapes[1], [1.2, 0.0, tilt[0]])]
    })
}

/// One evaluation, on the average of the places.
fn measure(
    c: &mut Criterion,
    name: &str,
    shapes: [&str; 2],
    relation: Relation,
    dimensions: Dimensions,
) {
    let pairs = pairs(shapes, dimensions);
    let mut next = pairs.iter().cycle();
    c.bench_function(&format!("body/{name} {} {}", shapes[0], shapes[1]), |b| {
        b.iter(|| {
            next.next()
                .map(|[a, b]| relation.value(black_box(a), black_box(b), black_box(dimensions)))
        });
    });
}

fn in_the_plane(c: &mut Criterion) {
    for shapes in [
        ["rectangle", "rectangle"],
        ["rounded rectangle", "rounded rectangle"],
        ["capsule", "rectangle"],
        ["ball", "rectangle"],
        ["ball", "ball"],
    ] {
        measure(c, "clear", shapes, Relation::Clear, Plane);
    }
    let rectangles = ["rectangle", "rectangle"];
    measure(c, "inside", rectangles, Relation::Inside, Plane);
    measure(c, "inside", ["rectangle", "ball"], Relation::Inside, Plane);
    measure(
        c,
        "inside_x",
        rectangles,
        Relation::InsideAlong(Axis::X),
        Plane,
    );
    measure(c, "over", rectangles, Relation::Over, Plane);
    measure(c, "corner", rectangles, Relation::Corner, Plane);
    measure(c, "x", rectangles, Relation::Coordinate(Axis::X), Plane);
}

fn in_space(c: &mut Criterion) {
    for shapes in [
        ["box", "box"],
        ["capsule", "box"],
        ["capsule", "capsule"],
        ["ball", "box"],
    ] {
        measure(c, "clear in space", shapes, Relation::Clear, Space);
    }
    measure(
        c,
        "inside in space",
        ["box", "box"],
        Relation::Inside,
        Space,
    );
    measure(
        c,
        "corner in space",
        ["box", "box"],
        Relation::Corner,
        Space,
    );
}

fn others(c: &mut Criterion) {
    let [pair, ..] = pairs(["rectangle", "rectangle"], Plane);
    let [a, b] = &pair;
    c.bench_function("body/sight rectangle", |bench| {
        let [start, end] = [[-1.0, -1.0, 0.0], [2.0, 0.9, 0.0]];
        bench.iter(|| sight(black_box(start), end, 0.0, black_box(b), Plane));
    });
    c.bench_function("body/off", |bench| {
        bench.iter(|| off(black_box(a), black_box(b), Plane));
    });
    c.bench_function("body/lipschitz", |bench| {
        bench.iter(|| lipschitz(black_box(0.1), black_box(0.2), a.reach(black_box([0.0; 3]))));
    });
    c.bench_function("body/make rectangle", |bench| {
        bench.iter(|| Body::new(black_box([0.0; 3]), a.axes, black_box([0.6, 0.4, 0.0]), 0.0));
    });
    c.bench_function("body/pieces of clear rectangle rectangle", |bench| {
        bench.iter(|| {
            let pieces = Relation::Clear.pieces(black_box(a), black_box(b), Plane);
            pieces
                .iter()
                .map(|piece| piece.value([0.3, 0.2, 0.0]))
                .sum::<f64>()
        });
    });
}

criterion_group!(benches, in_the_plane, in_space, others);
criterion_main!(benches);
