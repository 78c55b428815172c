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

/// How far a bolt is turned in. Its pitch is a length, and no angle.
const SCREW: Task = Task {
    domain: "
        object bolt { pitch: length, hold: length }
        object hole { depth: length }
        parameter turns in [0, 20]
    ",
    draw: |rng, _| {
        let ends = [(0.5, 1.75), (3.0, 8.0), (9.0, 20.0)];
        ends.map(|(low, high)| uniform_in(rng, low, high)).to_vec()
    },
    works: |numbers, theta| (numbers[1]..=numbers[2]).contains(&(theta[0] * numbers[0])),
    regions: &[
        "turns*bolt.pitch - bolt.hold >= 0 and turns*bolt.pitch - hole.depth <= 0",
        "turns*bolt.pitch - hole.depth <= 0 and turns*bolt.pitch - bolt.hold >= 0",
    ],
};

/// How much rope a drum winds in: an angle times a length.
const WINCH: Task = Task {
    domain: "
        object drum { radius: length }
        object rope { length: length, least: length }
        parameter turn in [0, 25]: angle
    ",
    draw: |rng, _| {
        let ends = [(0.05, 0.2), (1.2, 3.0), (0.2, 0.8)];
        ends.map(|(low, high)| uniform_in(rng, low, high)).to_vec()
    },
    works: |numbers, theta| (numbers[2]..=numbers[1]).contains(&(theta[0] * numbers[0])),
    regions: &[
        "turn*drum.radius - rope.length <= 0 and turn*drum.radius - rope.least >= 0",
        "turn*drum.radius - rope.least >= 0 and turn*drum.radius - rope.length <= 0",
    ],
};

/// How high a bin is filled with what a bag holds: there is no word for a volume.
const FILL: Task = Task {
    domain: "
        object bin { width: length, depth: length, height: length }
        object bag { volume: none }
        parameter level in [0, 0.6]: length
    ",
    draw: |rng, _| {
        let ends = [(0.3, 0.6), (0.2, 0.5), (0.3, 0.6), (0.01, 0.08)];
        ends.map(|(low, high)| uniform_in(rng, low, high)).to_vec()
    },
    works: |numbers, theta| {
        theta[0] * numbers[0] * numbers[1] <= numbers[3] && theta[0] <= numbers[2]
    },
    regions: &[
        "level*(bin.width*bin.depth) - bag.volume <= 0 and level - bin.height <= 0",
        "level - bin.height <= 0 and level*(bin.width*bin.depth) - bag.volume <= 0",
    ],
};

#[test]
fn a_law_is_found() {
    check(&PAYLOAD, false);
}

#[test]
fn a_pitch_that_is_a_length_is_a_size() {
    check(&SCREW, false);
}

#[test]
fn an_arc_is_compared_with_lengths() {
    check(&WINCH, false);
}

#[test]
fn a_volume_is_compared_with_a_plain_number() {
    check(&FILL, false);
}

#[test]
fn a_law_of_the_text_is_compared_with_what_the_scene_has() {
    check(&SLIDE, false);
}
