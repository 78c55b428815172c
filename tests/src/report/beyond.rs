//! Truths that the domain text cannot say, or does not: what a robot meets.

use super::scenario::Scenario;
use critreg::random::{Generator, uniform_in};

const SIZE: (usize, u32) = (16, 300);

/// A plane in which a hand is put beside something.
const PLANE: &str = "parameter px in [0, 3]: length
    parameter py in [0, 3]: length
    point hand = world + (px, py)";

/// All of them.
pub(super) fn all() -> [Scenario; 10] {
    [
        ellipse(),
        product(),
        annulus(),
        tilted(),
        unmodelled(),
        two_links(),
        friction(),
        superellipse(),
        string(),
        wavy(),
    ]
}

/// An object in a plane.
fn with_object(text: &str) -> &'static str {
    format!("object {text}\n{PLANE}").leak()
}

/// Somewhere in the middle of the plane.
fn middle(rng: &mut Generator) -> [f64; 2] {
    [uniform_in(rng, 1.0, 2.0), uniform_in(rng, 1.0, 2.0)]
}

fn off(instance: &[f64], theta: &[f64]) -> [f64; 2] {
    [theta[0] - instance[0], theta[1] - instance[1]]
}

/// A suction cup seals on an ellipse around the middle of a part.
fn ellipse() -> Scenario {
    let text = with_object("part { x: length, y: length, width: length, depth: length }");
    let draw = |rng: &mut Generator| {
        let sizes = [uniform_in(rng, 0.8, 1.6), uniform_in(rng, 0.8, 1.6)];
        [middle(rng), sizes].concat()
    };
    Scenario::of_judge("ellipse", text, SIZE, draw, |i, theta| {
        let [dx, dy] = off(i, theta);
        (dx / (0.5 * i[2])).hypot(dy / (0.5 * i[3])) <= 1.0
    })
}

/// A bolt turns by force times lever, and breaks by twice as much.
fn product() -> Scenario {
    let text = "object bolt { torque: none }
        parameter force in [0, 10]
        parameter lever in [0, 1]";
    let draw = |rng: &mut Generator| vec![uniform_in(rng, 1.0, 3.0)];
    Scenario::of_judge("product", text, SIZE, draw, |i, theta| {
        (i[0]..=2.0 * i[0]).contains(&(theta[0] * theta[1]))
    })
}

/// Neither too near to a thing nor too far from it, with 2% of the answers wrong, which the
/// learner is not told.
fn annulus() -> Scenario {
    let text = with_object("cup { x: length, y: length }");
    let draw = |rng: &mut Generator| middle(rng).to_vec();
    let scenario = Scenario::of_judge("annulus, 2% wrong", text, SIZE, draw, |i, theta| {
        let [dx, dy] = off(i, theta);
        (0.4..=0.9).contains(&dx.hypot(dy))
    });
    Scenario {
        noise: 0.02,
        ..scenario
    }
}

/// A box whose angle nobody measures.
fn tilted() -> Scenario {
    let text = with_object("box { x: length, y: length, width: length, depth: length }");
    let draw = |rng: &mut Generator| {
        let sizes = [uniform_in(rng, 1.2, 1.8), uniform_in(rng, 0.6, 1.0)];
        [middle(rng), sizes].concat()
    };
    Scenario::of_judge("tilted box", text, SIZE, draw, |i, theta| {
        let [dx, dy] = off(i, theta);
        let (sin, cos) = 0.4_f64.sin_cos();
        let (along, across) = (cos * dx + sin * dy, cos * dy - sin * dx);
        2.0 * along.abs() <= i[2] && 2.0 * across.abs() <= i[3]
    })
}

/// A base in reach of a target, but for stripes in which the arm has no solution.
fn unmodelled() -> Scenario {
    let text = "object target { x: length, y: length }
        constant shortest = 0.3: length
        constant longest = 0.8: length
        parameter bx in [-1.1, 1.1]: length
        parameter by in [-1.1, 1.1]: length
        point base = world + (bx, by)";
    let draw = |rng: &mut Generator| vec![uniform_in(rng, -0.3, 0.3), uniform_in(rng, -0.3, 0.3)];
    Scenario::of_judge("unmodelled", text, SIZE, draw, |i, theta| {
        let [dx, dy] = off(i, theta);
        let (far, towards) = (dx.hypot(dy), dy.atan2(dx));
        (0.3..=0.8).contains(&far) && (7.0 * towards + 11.0 * far).sin() > -0.985
    })
}

/// An arm of two links on a base reaches a target within the limits of its joints, of which
/// the text says its longest and its shortest reach.
fn two_links() -> Scenario {
    const UPPER: f64 = 0.7;
    const LOWER: f64 = 0.6;
    let text = "object target { x: length, y: length }
        constant longest = 1.3: length
        constant shortest = 0.1: length
        parameter bx in [-1.5, 1.5]: length
        parameter by in [-1.5, 1.5]: length
        point base = world + (bx, by)";
    let draw = |rng: &mut Generator| vec![uniform_in(rng, -0.4, 0.4), uniform_in(rng, -0.4, 0.4)];
    Scenario::of_judge("two links", text, SIZE, draw, |i, theta| {
        let [x, y] = off(theta, i);
        let cos = (x * x + y * y - UPPER * UPPER - LOWER * LOWER) / (2.0 * UPPER * LOWER);
        if cos.abs() > 1.0 {
            return false;
        }
        let elbow = cos.acos();
        [elbow, -elbow].into_iter().any(|elbow| {
            let ahead = (LOWER * elbow.sin()).atan2(UPPER + LOWER * elbow.cos());
            let turn = std::f64::consts::TAU;
            let shoulder = (y.atan2(x) - ahead + 0.5 * turn).rem_euclid(turn) - 0.5 * turn;
            shoulder.abs() <= 2.0 && (0.3..=2.4).contains(&elbow)
        })
    })
}

/// A push from above moves a block and does not tip it; friction grows softly with the force.
fn friction() -> Scenario {
    let text = "object block { mass: none, friction: none }
        parameter force in [0, 40]
        parameter tilt in [0, 1]: angle";
    let draw = |rng: &mut Generator| vec![uniform_in(rng, 0.5, 2.0), uniform_in(rng, 0.2, 0.6)];
    Scenario::of_judge("soft friction", text, SIZE, draw, |i, theta| {
        let (ahead, down) = (theta[0] * theta[1].cos(), theta[0] * theta[1].sin());
        let presses = 9.81 * i[0] + down;
        let holds = i[1] * presses * (1.0 + 0.5 * (1.0 - (-theta[0] / 10.0).exp()));
        (holds..=2.5 * holds).contains(&ahead)
    })
}

/// A place on a plate with round corners.
fn superellipse() -> Scenario {
    let text = with_object("plate { x: length, y: length, width: length, depth: length }");
    let draw = |rng: &mut Generator| {
        let sizes = [uniform_in(rng, 0.8, 1.6), uniform_in(rng, 0.8, 1.6)];
        [middle(rng), sizes].concat()
    };
    Scenario::of_judge("superellipse", text, SIZE, draw, |i, theta| {
        let [dx, dy] = off(i, theta);
        let (across, along) = (2.0 * dx / i[2], 2.0 * dy / i[3]);
        across.powi(4) + along.powi(4) <= 1.0
    })
}

/// A string around two pegs is as long as it is.
fn string() -> Scenario {
    let text = format!(
        "object left {{ x: length, y: length }}
        object right {{ x: length, y: length }}
        object string {{ length: length }}
        {PLANE}"
    );
    let draw = |rng: &mut Generator| {
        let left = [uniform_in(rng, 0.6, 1.2), uniform_in(rng, 1.0, 2.0)];
        let right = [uniform_in(rng, 1.8, 2.4), uniform_in(rng, 1.0, 2.0)];
        [&left[..], &right[..], &[uniform_in(rng, 1.8, 2.4)]].concat()
    };
    Scenario::of_judge("string", text.leak(), SIZE, draw, |i, theta| {
        let to = |x: f64, y: f64| (theta[0] - x).hypot(theta[1] - y);
        to(i[0], i[1]) + to(i[2], i[3]) <= i[4]
    })
}

/// Below an edge that was cut by hand, and not too far to the sides.
fn wavy() -> Scenario {
    let text = with_object("shelf { x: length, y: length, width: length }");
    let draw = |rng: &mut Generator| [&middle(rng)[..], &[uniform_in(rng, 1.0, 2.0)]].concat();
    Scenario::of_judge("wavy edge", text, SIZE, draw, |i, theta| {
        let [dx, dy] = off(i, theta);
        dy <= 0.1 * (9.0 * dx).sin() && 2.0 * dx.abs() <= i[2]
    })
}
