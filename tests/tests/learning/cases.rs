//! The scene decides which of two bounds holds.

use super::task::{Task, check};
use critreg::random::uniform_in;

/// How far a cup is tilted on the way: hardly if it is full, more if it is not.
const CUP: Task = Task {
    domain: "
        object cup { full: flag, height: length }
        constant hardly = 0.25: angle
        constant more = 1.1: angle
        parameter tilt in [0, 1.5]: angle
    ",
    draw: |rng, _| {
        let is_full = uniform_in(rng, 0.0, 1.0) < 0.5;
        vec![f64::from(u8::from(is_full)), uniform_in(rng, 0.05, 0.2)]
    },
    works: |numbers, theta| theta[0] <= if numbers[0] > 0.5 { 0.25 } else { 1.1 },
    regions: &[
        "(cup.full <= 0 or tilt <= 0.25 (hardly)) and tilt <= 1.1 (more)",
        "(tilt <= 0.25 (hardly) or cup.full <= 0) and tilt <= 1.1 (more)",
        "tilt <= 1.1 (more) and (cup.full <= 0 or tilt <= 0.25 (hardly))",
        "tilt <= 1.1 (more) and (tilt <= 0.25 (hardly) or cup.full <= 0)",
    ],
};

#[test]
fn a_flag_of_the_scene_decides_which_bound_holds() {
    check(&CUP, false);
}
