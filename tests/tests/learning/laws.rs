//! Laws of physics are learned as products and quotients, and at once where the text has them.

use super::task::{Task, check};
use critreg::random::uniform_in;

/// What must not be too heavy that far out. Its threshold is measured.
const PAYLOAD: Task = Task {
    domain: "
        object base { x: length, y: length }
        object load { mass: none }
        parameter px in [-1, 1]: length
        parameter py in [0, 1]: length
        point hand = world + (px, py)
        constant most = 1.25: length
    ",
    draw: |rng, _| {
        let ends = [(-0.3, 0.3), (0.0, 0.2), (0.5, 5.0)];
        ends.map(|(low, high)| uniform_in(rng, low, high)).to_vec()
    },
    works: |numbers, theta| {
        (theta[0] - numbers[0]).hypot(theta[1] - numbers[1]) * numbers[2] <= 1.25
    },
    regions: &["dist(hand, base)*load.mass <= 1.25 (most)"],
};

/// How far something slides that is pushed with a speed.
const SLIDE: Task = Task {
    domain: "
        object ground { friction: none }
        object goal { near: length, far: length }
        parameter v in [0.1, 3]
        feature slide = v*v / (2*9.81*ground.friction): length
    ",
    draw: |rng, _| {
        let near = uniform_in(rng, 0.1, 0.5);
        vec![
            uniform_in(rng, 0.2, 0.6),
            near,
            near + uniform_in(rng, 0.1, 0.4),
        ]
    },
    works: |numbers, theta| {
        let slide = theta[0].powi(2) / (2.0 * 9.81 * numbers[0]);
        (numbers[1]..=numbers[2]).contains(&slide)
    },
    regions: &[
        "slide - goal.near >= 0 and slide - goal.far <= 0",
        "slide - goal.far <= 0 and slide - goal.near >= 0",
    ],
};

#[test]
fn a_law_is_found() {
    check(&PAYLOAD, false);
}

#[test]
fn a_law_of_the_text_is_compared_with_what_the_scene_has() {
    check(&SLIDE, false);
}
