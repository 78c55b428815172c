//! Relations between bodies are learned as such: trays at any heading, stacks, and obstacles
//! that each have a size of their own.

use super::task::{Task, check};
use critreg::random::{Generator, below, uniform_in};
use std::f64::consts::{FRAC_PI_2, PI};

const TRAY: Task = Task {
    domain: "
        object tray { x: length, y: length, theta: angle, width: length, depth: length }
        parameter px in [0, 1]: length
        parameter py in [0, 1]: length
        parameter yaw in [-3.14, 3.14]: angle
        point spot = world + (px, py)
        point place = spot turned yaw
        shape tray = rectangle(tray.width, tray.depth) centred
        shape place = rectangle(0.2, 0.1) centred
    ",
    draw: slab,
    works: |numbers, theta| {
        let (sin, cos) = theta[2].sin_cos();
        let corners = [[0.1, 0.05], [-0.1, 0.05], [-0.1, -0.05], [0.1, -0.05]];
        corners.into_iter().all(|[along, across]| {
            let corner = [
                theta[0] + cos * along - sin * across,
                theta[1] + sin * along + cos * across,
            ];
            is_on_slab(numbers, corner)
        })
    },
    regions: &["inside(place, tray) >= 0"],
};

const STACK: Task = Task {
    domain: "
        object lower { x: length, y: length, theta: angle, width: length, depth: length }
        parameter px in [0, 1]: length
        parameter py in [0, 1]: length
        parameter yaw in [-3.14, 3.14]: angle
        point spot = world + (px, py)
        point place = spot turned yaw
        shape lower = rectangle(lower.width, lower.depth) centred
        shape place = rectangle(0.2, 0.1) centred
    ",
    draw: slab,
    // The centre of what is stacked is over the lower one.
    works: |numbers, theta| is_on_slab(numbers, [theta[0], theta[1]]),
    regions: &[
        "over(place, lower) >= 0",
        "over(spot, lower) >= 0",
        "inside(spot, lower) >= 0",
        "clear(spot, lower) <= 0",
    ],
};

const OBSTACLES: Task = Task {
    domain: "
        object obstacle[6] { x: length, y: length, radius: length }
        parameter px in [0, 1]: length
        parameter py in [0, 1]: length
        point hand = world + (px, py)
        shape obstacle = circle(obstacle.radius)
        shape hand = circle(0.04)
    ",
    draw: obstacles,
    works: |numbers, theta| {
        let mut present = numbers.chunks(3).filter(|member| !member[0].is_nan());
        present.all(|member| (theta[0] - member[0]).hypot(theta[1] - member[1]) >= member[2] + 0.04)
    },
    regions: &["min(clear(hand, obstacle)) >= 0"],
};

/// A rectangle anywhere near the middle.
fn slab(rng: &mut Generator, is_aligned: bool) -> Vec<f64> {
    let [x, y] = [0, 1].map(|_| uniform_in(rng, 0.3, 0.7));
    let turn = match is_aligned {
        true => [0.0, FRAC_PI_2][below(rng, 2)],
        false => uniform_in(rng, -PI, PI),
    };
    let [width, depth] = [0, 1].map(|_| uniform_in(rng, 0.3, 0.6));
    vec![x, y, turn, width, depth]
}

/// Whether a point is on the rectangle of an instance.
fn is_on_slab(numbers: &[f64], point: [f64; 2]) -> bool {
    let [x, y, turn, width, depth] = *numbers else {
        panic!("five numbers")
    };
    let (sin, cos) = turn.sin_cos();
    let [dx, dy] = [point[0] - x, point[1] - y];
    let [along, across] = [cos * dx + sin * dy, cos * dy - sin * dx];
    2.0 * along.abs() <= width && 2.0 * across.abs() <= depth
}

/// One to six obstacles; the others are absent. Aligned ones are on a grid.
fn obstacles(rng: &mut Generator, is_aligned: bool) -> Vec<f64> {
    let count = 1 + below(rng, 6);
    let mut numbers = Vec::new();
    for _ in 0..count {
        let place = [0, 1].map(|_| uniform_in(rng, 0.1, 0.9));
        let place = place.map(|at| {
            if is_aligned {
                (at * 10.0).round() / 10.0
            } else {
                at
            }
        });
        numbers.extend(place);
        numbers.push(uniform_in(rng, 0.03, 0.2));
    }
    numbers.resize(18, f64::NAN);
    numbers
}

#[test]
fn a_tray_at_any_heading_is_learned() {
    check(&TRAY, false);
}

#[test]
fn an_aligned_tray_is_learned() {
    check(&TRAY, true);
}

#[test]
fn a_stack_at_any_heading_is_learned() {
    check(&STACK, false);
}

#[test]
fn an_aligned_stack_is_learned() {
    check(&STACK, true);
}

#[test]
fn obstacles_with_sizes_of_their_own_are_learned() {
    check(&OBSTACLES, false);
}

#[test]
fn obstacles_on_a_grid_are_learned() {
    check(&OBSTACLES, true);
}
