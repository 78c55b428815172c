//! What is at a boundary: nothing in size, parallel, touching, absent, coarse numbers.

use super::*;
use critreg::geometry::sight;
use critreg::random::generator;
use critreg::real::Real;

const UPRIGHT: [Vector; 3] = Body::<f64>::UPRIGHT;

fn clear(a: &Body<f64>, b: &Body<f64>, dimensions: Dimensions) -> f64 {
    Relation::Clear.value(a, b, dimensions)
}

#[test]
fn segments_on_one_line_are_as_far_apart_as_their_ends() {
    for dimensions in [Dimensions::Plane, Dimensions::Space] {
        for heading in [0.0, 0.3, FRAC_PI_2, 2.0] {
            let segment = |from: f64, to: f64, radius| {
                let at = |x: f64| [x * f64::cos(heading), x * f64::sin(heading), 0.0];
                Body::segment(at(from), at(to), radius)
            };
            let (one, next) = (segment(0.0, 1.0, 0.0), segment(1.25, 3.0, 0.0));
            let value = clear(&one, &next, dimensions);
            assert!((value - 0.25).abs() < 1e-12, "{value}");
            let value = clear(&one, &segment(3.0, 1.25, 0.1), dimensions);
            assert!((value - 0.15).abs() < 1e-12, "{value}");
            let overlapping = clear(&one, &segment(0.5, 2.0, 0.0), dimensions);
            assert!(overlapping.abs() < 1e-12, "no depth: {overlapping}");
            let capsules = clear(&one, &segment(0.5, 2.0, 0.1), dimensions);
            assert!((capsules + 0.1).abs() < 1e-12, "{capsules}");
        }
    }
}

#[test]
fn parallel_capsules_in_space_are_as_far_apart_as_their_lines() {
    let mut rng = generator(31);
    for noise in [0.0, 1e-17, 1e-15, 1e-12, 1e-9, 1e-7] {
        for _ in 0..200 {
            let [along, aside, _] = axes(turn(&mut rng, Dimensions::Space));
            let capsule = |middle: Vector, along: Vector| {
                let [start, end] = [-0.5, 0.5].map(|t| add(middle, scale(along, t)));
                Body::segment(start, end, 0.01)
            };
            let one = capsule([0.0; 3], along);
            for (shift, expected) in [(0.0, 0.28), (0.6, 0.28), (1.4, 0.3_f64.hypot(0.4) - 0.02)] {
                let middle = add(scale(aside, 0.3), scale(along, shift));
                let tilted = add(along, vector(&mut rng, noise));
                let value = clear(&one, &capsule(middle, tilted), Dimensions::Space);
                assert!(
                    (value - expected).abs() < 1e-10 + 2.0 * noise,
                    "{value} {expected}"
                );
            }
        }
    }
}

#[test]
fn plates_that_cross_touch_where_no_corner_is() {
    // Two flat boxes one upon the other as a cross, or turned by an eighth so that they meet
    // in an octagon: no corner of one is above or below the other.
    let plate = |half_sizes, z: f64, yaw: f64| {
        Body::new([0.0, 0.0, z], axes([yaw, 0.0, 0.0]), half_sizes, 0.0)
    };
    let low = plate([2.0, 0.5, 0.1], 0.0, 0.3);
    for gap in [0.3, 1e-6, 0.0, -1e-6] {
        for (half_sizes, yaw) in [([2.0, 0.5, 0.1], FRAC_PI_2), ([2.0, 0.4, 0.1], 0.8)] {
            let value = clear(
                &plate(half_sizes, 0.2 + gap, 0.3 + yaw),
                &low,
                Dimensions::Space,
            );
            assert!((value - gap).abs() < 1e-12, "{value} {gap}");
        }
    }
    let square = |z: f64, yaw: f64| plate([1.0, 1.0, 0.0], z, yaw);
    for height in [0.4, 0.0] {
        let value = clear(
            &square(height, 0.9),
            &square(0.0, 0.9 + PI / 4.0),
            Dimensions::Space,
        );
        assert!((value - height).abs() < 1e-12, "{value}");
    }
    // Beside each other in one plane.
    let beside = moved(&square(0.0, 0.9), scale(axes([0.9, 0.0, 0.0])[0], 2.5));
    let value = clear(&beside, &square(0.0, 0.9), Dimensions::Space);
    assert!((value - 0.5).abs() < 1e-12, "{value}");
}

#[test]
fn crossed_sticks_touch_at_their_edges() {
    // Both lie on an edge, one nearly along the other: only across both edges is it seen how
    // near they are.
    let stick = |z: f64, yaw: f64| {
        let turn = axes([yaw, 0.0, PI / 4.0]);
        Body::new([0.0, 0.0, z], turn, [2.0, 0.5, 0.5], 0.0)
    };
    for yaw in [1.0, 1e-2, 1e-4, 1e-5, 1e-6] {
        for gap in [0.1, 1e-6] {
            let above = stick(2.0_f64.sqrt() + gap, yaw);
            let value = clear(&above, &stick(0.0, 0.0), Dimensions::Space);
            assert!((value - gap).abs() < 1e-12, "{value} {gap} {yaw}");
        }
    }
}

#[test]
fn touching_bodies_are_at_no_distance() {
    let square = |x: f64, y: f64| Body::new([x, y, 0.0], UPRIGHT, [0.5, 0.5, 0.5], 0.0);
    for dimensions in [Dimensions::Plane, Dimensions::Space] {
        for (x, y) in [(1.0, 0.0), (1.0, 0.25), (1.0, 1.0)] {
            assert_eq!(clear(&square(x, y), &square(0.0, 0.0), dimensions), 0.0);
        }
        let disc = Body::ball([1.5, 0.25, 0.0], 1.0);
        assert_eq!(clear(&disc, &square(0.0, 0.0), dimensions), 0.0);
        let small = Body::new([0.25, 0.0, 0.0], UPRIGHT, [0.25, 0.5, 0.5], 0.0);
        assert_eq!(
            Relation::Inside.value(&small, &square(0.0, 0.0), dimensions),
            0.0
        );
    }
}

#[test]
fn a_tiny_size_changes_a_value_by_no_more_than_that() {
    let mut rng = generator(32);
    for dimensions in [Dimensions::Plane, Dimensions::Space] {
        for shapes in pairs(dimensions) {
            for tiny in [1e-300, 1e-160, 1e-20, 1e-16, 1e-13, 1e-10] {
                let [a, b] = pair(&mut rng, shapes, dimensions);
                let thick = |body: &Body<f64>| Body {
                    half_sizes: body.half_sizes.map(|half| half.max(tiny)),
                    ..*body
                };
                let (value, near) = (
                    clear(&a, &b, dimensions),
                    clear(&thick(&a), &thick(&b), dimensions),
                );
                assert!(
                    (value - near).abs() < 1e-11 + 4.0 * tiny,
                    "{tiny} {value} {near} {a:?} {b:?}"
                );
            }
        }
    }
}

#[test]
fn absent_bodies_have_no_value() {
    let there = Body::new([0.0; 3], UPRIGHT, [1.0, 0.5, 0.25], 0.1);
    let new = |half_sizes, radius| Body::new([0.0; 3], UPRIGHT, half_sizes, radius);
    let absent = [
        new([-0.1, 1.0, 1.0], 0.0),
        new([1.0, 1.0, -1e-9], 0.0),
        new([1.0, 1.0, 1.0], -0.1),
        new([f64::NAN, 1.0, 1.0], 0.0),
        new([1.0, 1.0, 1.0], f64::NAN),
        new([f64::INFINITY, 1.0, 1.0], 0.0),
        Body::new([0.0; 3], [[f64::NAN; 3]; 3], [1.0; 3], 0.0),
        Body::ball([f64::NAN, 0.0, 0.0], 1.0),
        Body::point([0.0, f64::INFINITY, 0.0]),
        Body::segment([0.0; 3], [f64::NAN; 3], 0.0),
        Body::absent(),
    ];
    assert!(!there.is_absent());
    for body in absent {
        assert!(body.is_absent(), "{body:?}");
        for dimensions in [Dimensions::Plane, Dimensions::Space] {
            for relation in RELATIONS {
                for [a, b] in [[&body, &there], [&there, &body], [&body, &body]] {
                    assert!(
                        relation.value(a, b, dimensions).is_nan(),
                        "{relation:?} {a:?} {b:?}"
                    );
                    assert!(relation.pieces(a, b, dimensions).len() < 5000);
                }
            }
            assert!(sight([0.0; 3], [1.0; 3], 0.0, &body, dimensions).is_nan());
        }
    }
    assert!(sight([0.0; 3], [f64::NAN; 3], 0.0, &there, Dimensions::Space).is_nan());
}

#[test]
fn in_the_plane_z_does_not_count() {
    let mut rng = generator(33);
    for shapes in pairs(Dimensions::Plane) {
        let [a, b] = pair(&mut rng, shapes, Dimensions::Plane);
        let lifted = moved(&a, [0.0, 0.0, 7.0]);
        for relation in RELATIONS {
            let value = relation.value(&a, &b, Dimensions::Plane);
            assert_eq!(relation.value(&lifted, &b, Dimensions::Plane), value);
        }
    }
}

#[test]
fn a_segment_without_length_is_a_ball() {
    let other = Body::new([1.0, 0.5, 0.0], axes([0.4, 0.0, 0.0]), [0.3, 0.2, 0.1], 0.0);
    for dimensions in [Dimensions::Plane, Dimensions::Space] {
        let segment = Body::segment([0.1; 3], [0.1; 3], 0.2);
        let ball = Body::ball([0.1; 3], 0.2);
        let [value, expected] = [segment, ball].map(|body| clear(&body, &other, dimensions));
        assert_eq!(value, expected);
    }
    let along = Body::segment([1.0, 1.0, 0.0], [1.0, 3.0, 0.0], 0.0);
    assert_eq!(along.centre, [1.0, 2.0, 0.0]);
    assert_eq!(along.axes[0], [0.0, 1.0, 0.0]);
    let [x, y, z] = Body::segment([0.0; 3], [1.0, 2.0, -2.0], 0.0).axes;
    assert!(dot(x, y).abs() < 1e-15 && dot(y, z).abs() < 1e-15 && dot(z, x).abs() < 1e-15);
    assert!((norm(y) - 1.0).abs() < 1e-15 && (norm(z) - 1.0).abs() < 1e-15);
}

fn single(body: &Body<f64>) -> Body<f32> {
    let narrow = |vector: Vector| vector.map(|x| x as f32);
    Body::new(
        narrow(body.centre),
        body.axes.map(narrow),
        narrow(body.half_sizes),
        body.radius as f32,
    )
}

#[test]
fn single_precision_works_too() {
    let mut rng = generator(34);
    for dimensions in [Dimensions::Plane, Dimensions::Space] {
        for shapes in pairs(dimensions) {
            for _ in 0..50 {
                let [a, b] = pair(&mut rng, shapes, dimensions);
                let (coarse_a, coarse_b) = (single(&a), single(&b));
                for relation in RELATIONS {
                    let exact = relation.value(&a, &b, dimensions);
                    let coarse = relation.value(&coarse_a, &coarse_b, dimensions);
                    assert!(
                        (coarse.to_f64() - exact).abs() < 1e-5,
                        "{relation:?} {coarse} {exact} {a:?} {b:?}"
                    );
                    let d = subtract(a.centre, b.centre).map(|x| x as f32);
                    let pieces = relation.pieces(&coarse_a, &coarse_b, dimensions);
                    let differences = pieces.iter().map(|piece| (piece.value(d) - coarse).abs());
                    assert!(differences.fold(f32::INFINITY, f32::min) < 1e-5);
                }
            }
        }
    }
}
