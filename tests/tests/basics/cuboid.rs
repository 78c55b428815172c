//! Boxes in space: the separating-axis test against a test of another kind, and at
//! exact boundaries.

use critreg::geometry::{Cuboid, Frame3, Intersects};
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_4, PI};

/// So much larger or smaller than it is, a box near a boundary gets another answer.
const NEAR: f64 = 1e-7;

/// Sizes from plates and sticks to cubes, places close enough that half of the pairs
/// meet.
fn cuboid() -> impl Strategy<Value = Cuboid<f64>> {
    let place = proptest::array::uniform3(-1.0..1.0);
    let size = proptest::array::uniform3(0.05..2.0);
    // Parallel edges are common in the world and never random.
    let angle = prop_oneof![Just(0.0), Just(FRAC_PI_4), -PI..PI];
    let turn = proptest::array::uniform3(angle);
    (place, size, turn).prop_map(|(place, size, turn)| Cuboid::new(place, size, turn))
}

/// The box with so much more at each side.
fn grown(cuboid: &Cuboid<f64>, by: f64) -> Cuboid<f64> {
    Cuboid {
        half: cuboid.half.map(|half| half + by),
        ..*cuboid
    }
}

/// The ends of the 12 edges of a box: they differ in one sign.
fn edges(cuboid: &Cuboid<f64>) -> Vec<[[f64; 3]; 2]> {
    let corners = cuboid.vertices();
    let pairs = (0..8).flat_map(|a| [1, 2, 4].map(|bit| (a, a | bit)));
    let edges = pairs.filter(|(a, b)| a < b);
    edges.map(|(a, b)| [corners[a], corners[b]]).collect()
}

/// Whether a straight line between two points meets a box: in the frame of the box it is
/// cut at the six sides.
fn is_hit(cuboid: &Cuboid<f64>, ends: [[f64; 3]; 2]) -> bool {
    let [start, end] = ends.map(|point| cuboid.frame.to_local(point));
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    for axis in 0..3 {
        let (at, step, half) = (start[axis], end[axis] - start[axis], cuboid.half[axis]);
        if step.abs() < 1e-14 {
            if at.abs() > half {
                return false;
            }
            continue;
        }
        let cuts = [(-half - at) / step, (half - at) / step];
        from = from.max(cuts[0].min(cuts[1]));
        to = to.min(cuts[0].max(cuts[1]));
    }
    from <= to
}

/// What two boxes have in common is a solid whose corners lie on an edge of one of them
/// and in the other: so they meet if an edge of one hits the other.
fn meet(a: &Cuboid<f64>, b: &Cuboid<f64>) -> bool {
    edges(a).into_iter().any(|edge| is_hit(b, edge))
        || edges(b).into_iter().any(|edge| is_hit(a, edge))
}

/// Whether two boxes meet; `None` if that is a matter of [`NEAR`].
fn clearly_meet(a: &Cuboid<f64>, b: &Cuboid<f64>) -> Option<bool> {
    let [less, more] = [-NEAR, NEAR].map(|by| meet(&grown(a, by), &grown(b, by)));
    (less == more).then_some(less)
}

fn assert_agree(a: &Cuboid<f64>, b: &Cuboid<f64>) -> Result<(), TestCaseError> {
    if let Some(expected) = clearly_meet(a, b) {
        prop_assert_eq!(a.intersects(b), expected);
        prop_assert_eq!(b.intersects(a), expected);
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    #[test]
    fn boxes_meet_where_an_edge_of_one_hits_the_other(a in cuboid(), b in cuboid()) {
        assert_agree(&a, &b)?;
    }

    #[test]
    fn boxes_keep_apart_edge_by_edge(
        a in cuboid(), b in cuboid(), along in 0usize..12, other in 0usize..12, gap in -0.1..0.1,
    ) {
        // The boxes are moved until the middles of two edges nearly touch: where only a
        // direction across both edges keeps the boxes apart.
        let middle = |cuboid: &Cuboid<f64>, edge: usize| {
            let [start, end] = edges(cuboid)[edge];
            [0, 1, 2].map(|i| 0.5 * (start[i] + end[i]))
        };
        let (here, there) = (middle(&a, along), middle(&b, other));
        let centre = b.frame.origin();
        let moved = [0, 1, 2].map(|i| {
            let to_edge = there[i] - centre[i];
            here[i] - to_edge * (1.0 - gap)
        });
        let [yaw, pitch, roll] = b.frame.yaw_pitch_roll();
        let b = Cuboid { frame: Frame3::new(moved, [yaw, pitch, roll]), ..b };
        assert_agree(&a, &b)?;
    }

    #[test]
    fn boxes_contain_what_lies_between_their_corners(
        a in cuboid(), weights in proptest::array::uniform8(0.0..1.0_f64), beyond in 1.001..3.0_f64,
    ) {
        let total: f64 = weights.iter().sum();
        prop_assume!(total > 0.1);
        let mixed = [0, 1, 2].map(|i| {
            let parts = a.vertices().into_iter().zip(weights);
            parts.map(|(corner, weight)| corner[i] * weight / total).sum()
        });
        prop_assert!(a.contains(mixed));
        for corner in a.vertices() {
            let outside = [0, 1, 2].map(|i| {
                let centre = a.frame.origin()[i];
                centre + beyond * (corner[i] - centre)
            });
            prop_assert!(!a.contains(outside));
        }
    }

    #[test]
    fn the_extent_is_that_of_the_corners(a in cuboid(), turn in proptest::array::uniform3(-PI..PI)) {
        let [direction, ..] = Frame3::new([0.0; 3], turn).axes();
        let shadow = |corner: [f64; 3]| (0..3).map(|i| corner[i] * direction[i]).sum::<f64>();
        let shadows = a.vertices().map(shadow);
        let low = shadows.into_iter().fold(f64::INFINITY, f64::min);
        let high = shadows.into_iter().fold(f64::NEG_INFINITY, f64::max);
        prop_assert!((a.extent(direction) - (high - low)).abs() < 1e-12);
    }
}

#[test]
fn the_cases_are_of_both_kinds() {
    use proptest::strategy::ValueTree;
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    let mut counts = [0, 0, 0];
    for _ in 0..2000 {
        let (a, b) = (cuboid(), cuboid())
            .new_tree(&mut runner)
            .unwrap()
            .current();
        counts[clearly_meet(&a, &b).map_or(2, usize::from)] += 1;
    }
    let [apart, meeting, near] = counts;
    assert!(apart > 400 && meeting > 400 && near < 20, "{counts:?}");
}

#[test]
fn touching_boxes_do_not_meet() {
    let cube = |x, y, z| Cuboid::new([x, y, z], [1.0, 1.0, 1.0], [0.0_f64; 3]);
    let unit = cube(0.0, 0.0, 0.0);
    assert!(!unit.intersects(&cube(1.0, 0.25, 0.0)), "a shared side");
    assert!(!unit.intersects(&cube(1.0, 1.0, 0.0)), "a shared edge");
    assert!(!unit.intersects(&cube(1.0, 1.0, 1.0)), "a shared corner");
    assert!(unit.intersects(&cube(0.875, 0.875, 0.875)));
    assert!(unit.intersects(&unit));
    assert!(unit.contains([0.5, -0.5, 0.5]) && !unit.contains([0.5, -0.5, 0.625]));

    let inside = Cuboid::new([0.0; 3], [0.25; 3], [1.0, 0.5, 0.25]);
    assert!(unit.intersects(&inside) && inside.intersects(&unit));
}

#[test]
fn crossed_sticks_are_kept_apart_by_no_side() {
    // Two sticks on their edges, one across the other: the shadows on all six axes
    // overlap, and only across both does a gap show.
    let stick =
        |z: f64, yaw: f64| Cuboid::new([0.0, 0.0, z], [4.0, 1.0, 1.0], [yaw, 0.0, FRAC_PI_4]);
    let low = stick(0.0, 0.0);
    let high = |gap: f64| stick(2.0_f64.sqrt() + gap, 1.0);
    assert!(!low.intersects(&high(1e-6)));
    assert!(low.intersects(&high(-1e-6)));
    let nearly_along = |gap: f64| stick(2.0_f64.sqrt() + gap, 1e-9);
    assert!(
        !low.intersects(&nearly_along(1e-6)),
        "edges parallel but for rounding"
    );
    assert!(low.intersects(&nearly_along(-1e-6)));
}

#[test]
fn single_precision_works_too() {
    let stick = |z: f32, yaw: f32| {
        Cuboid::new(
            [0.0, 0.0, z],
            [4.0, 1.0, 1.0],
            [yaw, 0.0, std::f32::consts::FRAC_PI_4],
        )
    };
    let low = stick(0.0, 0.0);
    for yaw in [0.0, 1e-4, 1.0] {
        assert!(!low.intersects(&stick(1.416, yaw)), "{yaw}");
        assert!(low.intersects(&stick(1.412, yaw)), "{yaw}");
    }
}
