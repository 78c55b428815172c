//! Values: in the plane the distance from the hull of all differences of corners; in space
//! the least distance that a slow search finds, and separating directions that prove it.

use super::*;
use critreg::geometry::{off, sight};
use critreg::random::generator;

/// Rounding of some dozens of operations on numbers near one.
const TOLERANCE: f64 = 1e-9;

/// The hull of points of the plane, counter-clockwise (Andrew's monotone chain).
fn hull(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    points.sort_by(|a, b| a.partial_cmp(b).unwrap());
    points.dedup();
    let turns_left = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| {
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0.0
    };
    let chain = |points: &mut dyn Iterator<Item = [f64; 2]>| {
        let mut chain: Vec<[f64; 2]> = Vec::new();
        for point in points {
            while let [.., a, b] = chain[..] {
                if turns_left(a, b, point) {
                    break;
                }
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop();
        chain
    };
    let lower = chain(&mut points.iter().copied());
    let upper = chain(&mut points.iter().rev().copied());
    let hull = [lower, upper].concat();
    if hull.is_empty() { points } else { hull }
}

/// The distance of a point from a hull, below zero inside.
fn distance_from_hull(hull: &[[f64; 2]], point: [f64; 2]) -> f64 {
    let mut nearest = f64::INFINITY;
    let mut inside = true;
    for (i, &[ax, ay]) in hull.iter().enumerate() {
        let [bx, by] = hull[(i + 1) % hull.len()];
        let ([ex, ey], [px, py]) = ([bx - ax, by - ay], [point[0] - ax, point[1] - ay]);
        let squared = ex * ex + ey * ey;
        let part = if squared > 0.0 {
            ((px * ex + py * ey) / squared).clamp(0.0, 1.0)
        } else {
            0.0
        };
        nearest = nearest.min((px - part * ex).hypot(py - part * ey));
        inside &= squared > 0.0 && ex * py - ey * px >= 0.0;
    }
    if inside { -nearest } else { nearest }
}

/// What is left of two bodies when one is shrunk to a point.
fn generators(a: &Body<f64>, b: &Body<f64>) -> Vec<Vector> {
    [half_axes(a), half_axes(b)].concat()
}

#[test]
fn in_the_plane_clearance_is_the_distance_from_the_hull_of_differences() {
    let mut rng = generator(1);
    let mut counts = [0; 2];
    for shapes in pairs(Dimensions::Plane) {
        for _ in 0..400 {
            let [a, b] = pair(&mut rng, shapes, Dimensions::Plane);
            let differences = corners([0.0; 3], &generators(&a, &b));
            let hull = hull(differences.iter().map(|[x, y, _]| [*x, *y]).collect());
            let [x, y, _] = subtract(a.centre, b.centre);
            let core = distance_from_hull(&hull, [x, y]);
            let expected = core - a.radius - b.radius;
            for [a, b] in [[&a, &b], [&b, &a]] {
                let value = Relation::Clear.value(a, b, Dimensions::Plane);
                assert!(
                    (value - expected).abs() < TOLERANCE,
                    "{value} {expected} {a:?} {b:?}"
                );
            }
            counts[usize::from(core < 0.0)] += 1;
        }
    }
    assert!(counts.iter().all(|count| *count > 1000), "{counts:?}");
}

/// How far a direction keeps a point from a zonotope: no more than their distance, or no
/// more than minus the depth.
fn separation(generators: &[Vector], point: Vector, direction: Vector) -> f64 {
    let direction = scale(direction, 1.0 / norm(direction));
    let reach: f64 = generators.iter().map(|g| dot(*g, direction).abs()).sum();
    dot(point, direction) - reach
}

/// The vector from the nearest point of a zonotope, by descent along one generator after
/// the other until the direction of that vector proves that no point is nearer.
fn descend(generators: &[Vector], point: Vector) -> Vector {
    let mut parts = vec![0.0; generators.len()];
    let mut rest = point;
    for _ in 0..100_000 {
        for (part, generator) in parts.iter_mut().zip(generators) {
            let step = dot(rest, *generator) / dot(*generator, *generator);
            let to = (*part + step).clamp(-1.0, 1.0);
            rest = subtract(rest, scale(*generator, to - *part));
            *part = to;
        }
        let distance = norm(rest);
        if distance < 1e-10 || separation(generators, point, rest) > distance - 1e-10 {
            break;
        }
    }
    rest
}

/// The direction in which a value grows fastest as a body moves.
fn slope(value: impl Fn(Vector) -> f64) -> Vector {
    const STEP: f64 = 1e-6;
    [0, 1, 2].map(|i| {
        let mut step = [0.0; 3];
        step[i] = STEP;
        value(step) - value(scale(step, -1.0))
    })
}

#[test]
fn in_space_clearance_is_the_distance_that_descent_finds() {
    let mut rng = generator(2);
    let (mut apart, mut deep, mut unsure) = (0, 0, 0);
    for shapes in pairs(Dimensions::Space) {
        for _ in 0..100 {
            let [a, b] = pair(&mut rng, shapes, Dimensions::Space);
            let generators = generators(&a, &b);
            let point = subtract(a.centre, b.centre);
            let value = Relation::Clear.value(&a, &b, Dimensions::Space);
            let back = Relation::Clear.value(&b, &a, Dimensions::Space);
            assert!((value - back).abs() < TOLERANCE);
            let core = value + a.radius + b.radius;
            let rest = descend(&generators, point);
            if norm(rest) > 1e-7 {
                let least = separation(&generators, point, rest);
                let most = norm(rest);
                assert!(core <= most + TOLERANCE, "{core} {most} {a:?} {b:?}");
                assert!(core >= least - TOLERANCE, "{core} {least} {a:?} {b:?}");
                unsure += usize::from(most - least > 1e-7);
                apart += 1;
                continue;
            }
            // They overlap, and no direction separates them sooner than the one found.
            assert!(core < TOLERANCE);
            for _ in 0..200 {
                let other = separation(&generators, point, vector(&mut rng, 1.0));
                assert!(other < core + TOLERANCE, "{other} {core} {a:?} {b:?}");
            }
            if core < -1e-5 {
                let at = |step| Relation::Clear.value(&moved(&a, step), &b, Dimensions::Space);
                let steepest = separation(&generators, point, slope(at));
                assert!(
                    (steepest - core).abs() < 1e-4,
                    "{steepest} {core} {a:?} {b:?}"
                );
                deep += 1;
            }
        }
    }
    assert!(apart > 5000 && deep > 400, "{apart} {deep}");
    assert!(100 * unsure < apart, "descent has not ended: {unsure}");
}

/// The distance of a point from the core of a body, below zero inside.
fn distance_from_core(body: &Body<f64>, point: Vector, axes: &[usize]) -> f64 {
    let offset = subtract(point, body.centre);
    let beyond = |i: &usize| dot(offset, body.axes[*i]).abs() - body.half_sizes[*i];
    let outside = axes
        .iter()
        .map(beyond)
        .map(|x| x.max(0.0).powi(2))
        .sum::<f64>();
    let deepest = axes.iter().map(beyond).fold(f64::NEG_INFINITY, f64::max);
    if outside > 0.0 {
        outside.sqrt()
    } else {
        deepest
    }
}

/// The room of some points in a body, of which only some axes count.
fn room(points: &[Vector], body: &Body<f64>, axes: &[usize]) -> f64 {
    let sized = axes.iter().filter(|i| body.half_sizes[**i] > 0.0);
    let sized: Vec<usize> = sized.copied().collect();
    let rooms = points.iter().map(|point| {
        if body.radius > 0.0 || sized.is_empty() {
            return body.radius - distance_from_core(body, *point, axes);
        }
        let along = |i: &usize| {
            body.half_sizes[*i] - dot(subtract(*point, body.centre), body.axes[*i]).abs()
        };
        sized.iter().map(along).fold(f64::INFINITY, f64::min)
    });
    rooms.fold(f64::INFINITY, f64::min)
}

#[test]
fn the_other_relations_are_those_of_corners() {
    let mut rng = generator(3);
    for dimensions in [Dimensions::Plane, Dimensions::Space] {
        let all: &[usize] = match dimensions {
            Dimensions::Plane => &[0, 1],
            Dimensions::Space => &[0, 1, 2],
        };
        for shapes in pairs(dimensions) {
            for _ in 0..100 {
                let [a, mut b] = pair(&mut rng, shapes, dimensions);
                if dimensions == Dimensions::Plane {
                    b.centre[2] = a.centre[2];
                }
                let points = corners(a.centre, &half_axes(&a));
                let (x, y) = (Axis::X, Axis::Y);
                let along = |i: usize| {
                    let grown = b.half_sizes[i] + b.radius - a.radius;
                    let room = |p: &Vector| grown - dot(subtract(*p, b.centre), b.axes[i]).abs();
                    points.iter().map(room).fold(f64::INFINITY, f64::min)
                };
                let nearest = points.iter().map(|p| distance_from_core(&b, *p, all));
                let nearest = nearest.fold(f64::INFINITY, f64::min);
                let coordinate = dot(subtract(a.centre, b.centre), b.axes[1]);
                let expected = [
                    (Relation::Inside, room(&points, &b, all) - a.radius),
                    (Relation::InsideAlong(x), along(0)),
                    (Relation::InsideAlong(y), along(1)),
                    (Relation::Over, room(&[a.centre], &b, &[0, 1])),
                    (Relation::Corner, nearest - a.radius - b.radius),
                    (Relation::Coordinate(y), coordinate),
                    (Relation::Magnitude(y), coordinate.abs()),
                ];
                for (relation, expected) in expected {
                    let value = relation.value(&a, &b, dimensions);
                    assert!(
                        (value - expected).abs() < TOLERANCE,
                        "{relation:?} {value} {expected} {a:?} {b:?}"
                    );
                }
            }
        }
    }
}

/// A point on the rounding of a corner of a body.
fn extreme_point(rng: &mut Generator, body: &Body<f64>) -> Vector {
    let corners = corners(body.centre, &half_axes(body));
    let corner = corners[below(rng, corners.len())];
    let aside = vector(rng, 1.0);
    add(corner, scale(aside, body.radius / norm(aside)))
}

#[test]
fn what_is_inside_has_all_its_points_inside() {
    let mut rng = generator(4);
    let mut counts = [0; 2];
    let solid = [PLANE[1], PLANE[3], PLANE[6], SPACE[9], SPACE[10]];
    for (b, a) in solid.into_iter().flat_map(|b| SPACE.map(|a| (b, a))) {
        for _ in 0..40 {
            let [a, b] = pair(&mut rng, [a, b], Dimensions::Space);
            let a = Body {
                centre: add(b.centre, scale(a.centre, 0.2)),
                half_sizes: a.half_sizes.map(|half| 0.2 * half),
                radius: 0.2 * a.radius,
                ..a
            };
            let value = Relation::Inside.value(&a, &b, Dimensions::Space);
            let points = (0..2000).map(|_| extreme_point(&mut rng, &a));
            let depths = points.map(|p| b.radius - distance_from_core(&b, p, &[0, 1, 2]));
            let least = depths.fold(f64::INFINITY, f64::min);
            // Random points miss the worst one by a little.
            if value > 0.0 {
                assert!(least > 0.0, "{value} {least} {a:?} {b:?}");
            } else if value < -0.01 {
                assert!(least < 0.0, "{value} {least} {a:?} {b:?}");
            }
            counts[usize::from(value > 0.0)] += 1;
        }
    }
    assert!(counts.iter().all(|count| *count > 200), "{counts:?}");
}

#[test]
fn a_sight_is_the_distance_of_the_nearest_point_on_the_line() {
    let mut rng = generator(5);
    for dimensions in [Dimensions::Plane, Dimensions::Space] {
        for shape in shapes(dimensions) {
            for _ in 0..50 {
                let turn = turn(&mut rng, dimensions);
                let c = body(&mut rng, *shape, axes(turn));
                let [start, end] = [vector(&mut rng, 1.0), vector(&mut rng, 1.0)];
                let value = sight(start, end, 0.05, &c, dimensions);
                let along = |share: f64| {
                    let point = add(scale(start, 1.0 - share), scale(end, share));
                    Relation::Clear.value(&Body::ball(point, 0.05), &c, dimensions)
                };
                // Distance is convex along the line, so thirds close in on the least.
                let (mut low, mut high) = (0.0, 1.0);
                for _ in 0..100 {
                    let third = (high - low) / 3.0;
                    match along(low + third) < along(high - third) {
                        true => high -= third,
                        false => low += third,
                    }
                }
                let least = along(low);
                let rounding = c.radius + 0.05;
                if least + rounding > 1e-6 {
                    assert!((value - least).abs() < 1e-7, "{value} {least} {c:?}");
                } else {
                    assert!(value <= least + 1e-7, "{value} {least} {c:?}");
                }
            }
        }
    }
}

#[test]
fn off_is_the_angle_from_the_x_axis() {
    let camera = |turn| Body::new([1.0, 2.0, 0.5], axes(turn), [0.0; 3], 0.0);
    let looking_up = camera([0.0, -FRAC_PI_2, 0.0]);
    let above = Body::point([1.0, 2.0, 3.0]);
    assert!(off(&above, &looking_up, Dimensions::Space) < 1e-12);
    let turned = camera([FRAC_PI_2, 0.0, 0.0]);
    let point = Body::point([2.0, 3.0, 9.0]);
    assert!((off(&point, &turned, Dimensions::Plane) - PI / 4.0).abs() < 1e-12);
    let behind = Body::point([1.0, -5.0, 0.5]);
    assert!((off(&behind, &turned, Dimensions::Space) - PI).abs() < 1e-12);
    assert_eq!(off(&turned, &turned, Dimensions::Space), 0.0);
    assert!(off(&Body::absent(), &turned, Dimensions::Plane).is_nan());
}
