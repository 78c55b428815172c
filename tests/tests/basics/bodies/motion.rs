//! The Lipschitz bound: no motion changes a value by more.

use super::*;
use critreg::geometry::{Frame3, lipschitz};
use critreg::random::generator;

/// A body after a turn about a point and a step.
fn turned(body: &Body<f64>, about: Vector, turn: &Frame3<f64>, step: Vector) -> Body<f64> {
    let offset = turn.apply_direction(subtract(body.centre, about));
    Body {
        centre: add(add(about, offset), step),
        axes: body.axes.map(|axis| turn.apply_direction(axis)),
        ..*body
    }
}

/// The angle of a rotation about whatever axis it has.
fn angle(turn: &Frame3<f64>) -> f64 {
    let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = turn.rotation();
    let across = norm([zy - yz, xz - zx, yx - xy]);
    across.atan2(xx + yy + zz - 1.0)
}

#[test]
fn no_motion_changes_a_value_by_more_than_the_bound() {
    let mut rng = generator(21);
    let mut most_used = 0.0_f64;
    for dimensions in [Dimensions::Plane, Dimensions::Space] {
        for shapes in pairs(dimensions) {
            for relation in RELATIONS {
                let [a, b] = pair(&mut rng, shapes, dimensions);
                let before = relation.value(&a, &b, dimensions);
                for moves_a in [true, false] {
                    let about = add(a.centre, vector(&mut rng, 0.3));
                    for _ in 0..8 {
                        let size = uniform_in(&mut rng, 0.0, 0.3);
                        let step = vector(&mut rng, size);
                        let share = uniform_in(&mut rng, 0.0, 1.0).powi(2);
                        let turn = scale(turn(&mut rng, dimensions), share);
                        let turn = Frame3::new([0.0; 3], turn);
                        let after = match moves_a {
                            true => relation.value(&turned(&a, about, &turn, step), &b, dimensions),
                            false => {
                                relation.value(&a, &turned(&b, about, &turn, step), dimensions)
                            }
                        };
                        let bound = lipschitz(norm(step), angle(&turn), a.reach(about));
                        let change = (after - before).abs();
                        assert!(
                            change <= bound + 1e-12,
                            "{relation:?} {change} {bound} {a:?} {b:?}"
                        );
                        most_used = most_used.max(change / bound);
                    }
                }
            }
        }
    }
    assert!(most_used > 0.9, "{most_used}");
}

#[test]
fn half_a_turn_is_the_most() {
    assert_eq!(lipschitz(0.5, 0.0, 3.0), 0.5);
    assert!((lipschitz(0.5, PI, 3.0) - 6.5_f64).abs() < 1e-12);
    assert_eq!(lipschitz(0.5, 9.0, 3.0), lipschitz(0.5, PI, 3.0));
}

#[test]
fn reach_is_the_distance_of_the_farthest_corner() {
    let mut rng = generator(22);
    for shape in SPACE {
        for _ in 0..50 {
            let turn = turn(&mut rng, Dimensions::Space);
            let body = body(&mut rng, shape, axes(turn));
            let from = vector(&mut rng, 1.0);
            let distances = corners(body.centre, &half_axes(&body));
            let distances = distances.iter().map(|corner| norm(subtract(*corner, from)));
            let farthest = distances.fold(0.0, f64::max);
            assert!((body.reach(from) - farthest).abs() < 1e-12);
        }
    }
}
