//! Frames and shapes: their algebra, and tests at exact boundaries.

use critreg::geometry::{Circle, Frame2, Frame3, Intersects, Rectangle, Segment};
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};

/// Rounding of a few operations on numbers up to a hundred.
const TOLERANCE: f64 = 1e-12;

fn close<const N: usize>(a: [f64; N], b: [f64; N]) -> bool {
    a.iter().zip(&b).all(|(a, b)| (a - b).abs() < TOLERANCE)
}

fn same_matrix<const N: usize>(a: [[f64; N]; N], b: [[f64; N]; N]) -> bool {
    a.iter().zip(&b).all(|(a, b)| close(*a, *b))
}

fn product<const N: usize>(a: [[f64; N]; N], b: [[f64; N]; N]) -> [[f64; N]; N] {
    a.map(|row| std::array::from_fn(|j| (0..N).map(|k| row[k] * b[k][j]).sum()))
}

fn vector<const N: usize>() -> impl Strategy<Value = [f64; N]> {
    proptest::array::uniform(-10.0..10.0)
}

fn angle() -> impl Strategy<Value = f64> {
    -PI..PI
}

fn frame2() -> impl Strategy<Value = Frame2<f64>> {
    (vector(), angle()).prop_map(|(origin, yaw)| Frame2::new(origin, yaw))
}

fn frame3() -> impl Strategy<Value = Frame3<f64>> {
    (vector(), [angle(), angle(), angle()]).prop_map(|(origin, turn)| Frame3::new(origin, turn))
}

proptest! {
    #[test]
    fn frame2_inverse_undoes(f in frame2(), p in vector()) {
        prop_assert!(close(f.to_local(f.apply(p)), p));
        prop_assert!(close(f.inverse().apply(p), f.to_local(p)));
        let identity = Frame2::<f64>::identity().matrix();
        prop_assert!(same_matrix(f.compose(&f.inverse()).matrix(), identity));
        prop_assert!(same_matrix(f.inverse().compose(&f).matrix(), identity));
    }

    #[test]
    fn frame2_composition_is_the_matrix_product(f in frame2(), g in frame2(), p in vector()) {
        let both = f.compose(&g);
        prop_assert!(same_matrix(both.matrix(), product(f.matrix(), g.matrix())));
        prop_assert!(close(both.apply(p), f.apply(g.apply(p))));
        prop_assert!(close(both.apply_direction(p), f.apply_direction(g.apply_direction(p))));
        let moved = f.shifted(g.origin());
        prop_assert!(same_matrix(moved.matrix(), f.compose(&Frame2::new(g.origin(), 0.0)).matrix()));
    }

    #[test]
    fn frame2_reads_its_pose_back(origin in vector::<2>(), yaw in angle()) {
        let f = Frame2::new(origin, yaw);
        prop_assert_eq!(f.origin(), origin);
        prop_assert!((f.yaw() - yaw).abs() < TOLERANCE);
    }

    #[test]
    fn frame3_inverse_undoes(f in frame3(), p in vector()) {
        prop_assert!(close(f.to_local(f.apply(p)), p));
        prop_assert!(close(f.inverse().apply(p), f.to_local(p)));
        let identity = Frame3::<f64>::identity().matrix();
        prop_assert!(same_matrix(f.compose(&f.inverse()).matrix(), identity));
        prop_assert!(same_matrix(f.inverse().compose(&f).matrix(), identity));
    }

    #[test]
    fn frame3_composition_is_the_matrix_product(f in frame3(), g in frame3(), p in vector()) {
        let both = f.compose(&g);
        prop_assert!(same_matrix(both.matrix(), product(f.matrix(), g.matrix())));
        prop_assert!(close(both.apply(p), f.apply(g.apply(p))));
        prop_assert!(close(both.apply_direction(p), f.apply_direction(g.apply_direction(p))));
    }

    #[test]
    fn frame3_is_yaw_of_pitch_of_roll(origin in vector(), [a, b, c] in [angle(), angle(), angle()]) {
        let turn = |angles| Frame3::new([0.0; 3], angles);
        let composed = Frame3::new(origin, [0.0; 3])
            .compose(&turn([a, 0.0, 0.0]))
            .compose(&turn([0.0, b, 0.0]))
            .compose(&turn([0.0, 0.0, c]));
        prop_assert!(same_matrix(composed.matrix(), Frame3::new(origin, [a, b, c]).matrix()));
    }

    #[test]
    fn frame3_reads_its_pose_back(
        origin in vector::<3>(),
        yaw in angle(),
        pitch in -1.57..1.57,
        roll in angle(),
    ) {
        let f = Frame3::new(origin, [yaw, pitch, roll]);
        prop_assert_eq!(f.origin(), origin);
        for (a, b) in f.yaw_pitch_roll().into_iter().zip([yaw, pitch, roll]) {
            prop_assert!((a - b).abs() < 1e-10, "{} {}", a, b);
        }
    }

    #[test]
    fn frame3_angles_rebuild_the_rotation(yaw in angle(), roll in angle(), up in any::<bool>()) {
        // Where yaw and roll turn about one axis, their split is arbitrary.
        let pitch = if up { FRAC_PI_2 } else { -FRAC_PI_2 };
        let f = Frame3::new([0.0; 3], [yaw, pitch, roll]);
        let angles = f.yaw_pitch_roll();
        prop_assert_eq!(angles[2], 0.0);
        prop_assert!(same_matrix(Frame3::new([0.0; 3], angles).matrix(), f.matrix()));
    }

    #[test]
    fn plane_and_space_agree(
        origin in vector::<2>(), inner in vector::<2>(), p in vector::<2>(),
        a in angle(), b in angle(),
    ) {
        let lift = |[x, y]: [f64; 2]| [x, y, 0.0];
        let space = |origin, yaw| Frame3::new(lift(origin), [yaw, 0.0, 0.0]);
        let plane = Frame2::new(origin, a).compose(&Frame2::new(inner, b));
        let solid = space(origin, a).compose(&space(inner, b));
        prop_assert!(close(lift(plane.apply(p)), solid.apply(lift(p))));
        prop_assert!(close(lift(plane.apply_direction(p)), solid.apply_direction(lift(p))));
        prop_assert!(close(lift(plane.to_local(p)), solid.to_local(lift(p))));
        prop_assert!(close(lift(plane.inverse().origin()), solid.inverse().origin()));
        let [yaw, pitch, roll] = solid.yaw_pitch_roll();
        prop_assert!(close([yaw, pitch, roll], [plane.yaw(), 0.0, 0.0])
            || (yaw.abs() - PI).abs() < TOLERANCE);
    }

    #[test]
    fn rectangles_contain_what_lies_between_their_corners(
        corner in vector::<2>(), theta in angle(), [s, t] in [-1.0..2.0, -1.0..2.0],
    ) {
        let shape = Rectangle::new(corner, [3.0, 0.5], theta);
        let inside = (0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t);
        prop_assert_eq!(shape.contains(shape.frame.apply([3.0 * s, 0.5 * t])), inside);
        let [a, _, c, _] = shape.vertices();
        prop_assert_eq!(a, corner);
        prop_assert!(close(shape.centre(), [0.5 * (a[0] + c[0]), 0.5 * (a[1] + c[1])]));
        let around = shape.circumscribed();
        for [x, y] in shape.vertices() {
            let distance = (x - around.centre[0]).hypot(y - around.centre[1]);
            prop_assert!((distance - around.radius).abs() < TOLERANCE);
        }
    }

    #[test]
    fn circles_meet_rectangles_within_their_radius(
        corner in vector::<2>(), theta in angle(), centre in vector::<2>(), radius in 0.1..5.0_f64,
    ) {
        let shape = Rectangle::new(corner, [3.0, 0.5], theta);
        let [x, y] = shape.frame.to_local(centre);
        let gap: f64 = (x - x.clamp(0.0, 3.0)).hypot(y - y.clamp(0.0, 0.5));
        prop_assume!((gap - radius).abs() > 1e-9);
        prop_assert_eq!(shape.intersects(&Circle { centre, radius }), gap < radius);
    }
}

#[test]
fn touching_is_meeting_only_where_said() {
    let circle = |x, radius| Circle {
        centre: [x, 0.0],
        radius,
    };
    assert!(!circle(0.0, 1.0).intersects(&circle(2.0, 1.0)));
    assert!(circle(0.0, 1.0).intersects(&circle(1.999, 1.0)));
    assert!(circle(0.0, 1.0).contains([1.0, 0.0]));

    let square = |x, y| Rectangle::new([x, y], [1.0, 1.0], 0.0_f64);
    assert!(square(0.0, 0.0).contains([1.0, 1.0]));
    assert!(
        !square(0.0, 0.0).intersects(&square(1.0, 0.0)),
        "a shared side"
    );
    assert!(
        !square(0.0, 0.0).intersects(&square(0.75, 0.0)),
        "collinear sides"
    );
    assert!(
        square(0.0, 0.0).intersects(&square(0.5, 0.0)),
        "a centre on a side"
    );
    assert!(
        square(0.0, 0.0).intersects(&circle(1.5, 0.5)),
        "a side touches"
    );
    let card = Rectangle::new([0.0, 0.0], [6.0, 8.0], 0.0);
    let beyond_corner = Circle {
        centre: [9.0, 12.0],
        radius: 5.0,
    };
    assert!(!card.intersects(&beyond_corner), "a corner touches");

    let segment = |start, end| Segment { start, end };
    let x_axis = segment([0.0, 0.0], [2.0, 0.0]);
    assert!(x_axis.intersects(&segment([1.0, -1.0], [1.0, 1.0])));
    assert!(
        !x_axis.intersects(&segment([1.0, 0.0], [1.0, 1.0])),
        "an end on the other"
    );
    assert!(
        !x_axis.intersects(&segment([1.0, 0.0], [3.0, 0.0])),
        "collinear"
    );
    assert!(
        !segment([0.0; 2], [0.0; 2]).intersects(&circle(2.0, 1.0)),
        "a point, far"
    );
}

#[test]
fn a_quarter_turn_keeps_the_rounding_of_its_cosine() {
    let [[cos, ..], ..] = Frame2::new([0.0, 0.0], FRAC_PI_2).matrix();
    assert_eq!(cos.to_bits(), FRAC_PI_2.cos().to_bits());
    assert_ne!(cos, 0.0);
}

#[test]
fn single_precision_works_too() {
    let stick = Rectangle::new([0.0_f32, 0.0], [3.0, 0.05], 1.0);
    let side = stick.frame.apply([1.5, 0.14]);
    let hand = |radius| Circle {
        centre: side,
        radius,
    };
    assert!(stick.intersects(&hand(0.1)) && !stick.intersects(&hand(0.08)));
}
