//! The controllers. Each moves straight to its target, at most one step size per
//! axis at a time, and then presses.

use super::predicates::{is_held, pressed};
use super::world::{button_shape, robot_shape, stick_shape, tip_shape};
use super::{
    Action, BUTTON_TYPE, HOLDER, HOLDER_HEIGHT, MAX_ANGULAR_SPEED, MAX_SPEED, ROBOT_TYPE,
    STICK_HEIGHT, STICK_TYPE, STICK_WIDTH, StickButton, TARGET_TOLERANCE, UPRIGHT,
};
use crate::env::float32;
use crate::geometry::{Intersects, Rectangle, distance_squared};
use crate::real::Real;
use crate::task::{Controller, ControllerId, ObjectId, State, Terminal, always};

/// `PickStick(robot, stick; mu)`: goes to the point at `mu` times the width along
/// the stick, half its height across, and grasps it.
pub const PICK_STICK: ControllerId = ControllerId(0);
/// `PlaceStick(robot, stick; o)`: goes to half the holder's height left of the
/// holder's corner and `o` times half the stick's width above it, and lets go.
pub const PLACE_STICK: ControllerId = ControllerId(1);
/// `RobotPressButton(robot, button, stick)`: goes to the button and presses it.
pub const ROBOT_PRESS_BUTTON: ControllerId = ControllerId(2);
/// `StickPressButton(robot, stick, button)`: turns the held stick upright, moves
/// its tip to the button and presses it.
pub const STICK_PRESS_BUTTON: ControllerId = ControllerId(3);

pub(super) static CONTROLLERS: [Controller<StickButton>; 4] = [
    Controller {
        name: "PickStick",
        arguments: &[ROBOT_TYPE, STICK_TYPE],
        parameters: &[[0.0, 1.0]],
        initiable: always,
        policy: |_, state, objects, parameters| {
            pick_stick(state, objects, parameters).unwrap_or(REST)
        },
        terminal: Terminal::When(|_, state, _, _| is_held(state) == Some(true)),
    },
    Controller {
        name: "PlaceStick",
        arguments: &[ROBOT_TYPE, STICK_TYPE],
        parameters: &[[-1.0, 1.0]],
        initiable: always,
        policy: |_, state, objects, parameters| {
            place_stick(state, objects, parameters).unwrap_or(REST)
        },
        terminal: Terminal::When(|_, state, _, _| is_held(state) == Some(false)),
    },
    Controller {
        name: "RobotPressButton",
        arguments: &[ROBOT_TYPE, BUTTON_TYPE, STICK_TYPE],
        parameters: &[],
        initiable: always,
        policy: |_, state, objects, _| robot_press_button(state, objects).unwrap_or(REST),
        terminal: Terminal::When(|_, state, objects, _| is_pressed(state, objects.get(1))),
    },
    Controller {
        name: "StickPressButton",
        arguments: &[ROBOT_TYPE, STICK_TYPE, BUTTON_TYPE],
        parameters: &[],
        initiable: always,
        policy: |_, state, objects, _| stick_press_button(state, objects).unwrap_or(REST),
        terminal: Terminal::When(|_, state, objects, _| is_pressed(state, objects.get(2))),
    },
];

/// What a controller commands for objects that are not in the state: nothing, so
/// that its run ends as stuck.
const REST: Action = [0.0, 0.0, 0.0, -1.0];
const PRESS: Action = [0.0, 0.0, 0.0, 1.0];

fn is_pressed(state: &State, button: Option<&ObjectId>) -> bool {
    button.is_some_and(|button| pressed(state, &[*button]) == Some(true))
}

fn pick_stick(state: &State, objects: &[ObjectId], parameters: &[f64]) -> Option<Action> {
    let ([robot, stick], [mu]) = (objects, parameters) else {
        return None;
    };
    let target = grasp(&stick_shape(state.get(*stick)?), *mu);
    Some(press_at(state.get(*robot)?, target))
}

fn place_stick(state: &State, objects: &[ObjectId], parameters: &[f64]) -> Option<Action> {
    let ([robot, _], [offset]) = (objects, parameters) else {
        return None;
    };
    let target = release(state.get(HOLDER)?, *offset);
    Some(press_at(state.get(*robot)?, target))
}

fn robot_press_button(state: &State, objects: &[ObjectId]) -> Option<Action> {
    let [robot, button, _] = objects else {
        return None;
    };
    let button = button_shape(state.get(*button)?);
    let robot = robot_shape(state.get(*robot)?);
    Some(if robot.intersects(&button) {
        PRESS
    } else {
        go(robot.centre, button.centre)
    })
}

fn stick_press_button(state: &State, objects: &[ObjectId]) -> Option<Action> {
    let [_, stick, button] = objects else {
        return None;
    };
    let button = button_shape(state.get(*button)?);
    let stick = state.get(*stick)?;
    let [_, _, theta, _] = *stick;
    let tip = tip_shape(&stick_shape(stick));
    let to_upright = UPRIGHT - theta;
    Some(if tip.intersects(&button) {
        PRESS
    } else if Real::abs(to_upright) < 1e-3 {
        // The corner of the tip, not its centre, goes to the button.
        go(tip.frame.origin(), button.centre)
    } else {
        let turn = Real::clamp(to_upright, -MAX_ANGULAR_SPEED, MAX_ANGULAR_SPEED);
        [0.0, 0.0, (turn / MAX_ANGULAR_SPEED) as f32, -1.0]
    })
}

/// Goes to the target, and presses when close enough to it.
fn press_at(&[x, y, _]: &[f64; 3], target: [f64; 2]) -> Action {
    if distance_squared([x, y], target) < TARGET_TOLERANCE {
        PRESS
    } else {
        go([x, y], target)
    }
}

/// One step towards a target.
fn go(from: [f64; 2], to: [f64; 2]) -> Action {
    let [dx, dy] = speeds(from, to);
    [dx, dy, 0.0, -1.0]
}

/// The speeds of one step towards a target, each axis for itself.
pub(in crate::env) fn speeds([x, y]: [f64; 2], [target_x, target_y]: [f64; 2]) -> [f32; 2] {
    let speed = |gap: f64| (Real::clamp(gap, -MAX_SPEED, MAX_SPEED) / MAX_SPEED) as f32;
    [speed(target_x - x), speed(target_y - y)]
}

/// Where the hand goes to grasp the stick at this share of its width.
pub(in crate::env) fn grasp(stick: &Rectangle<f64>, share: f64) -> [f64; 2] {
    let along = STICK_WIDTH * f64::from(float32::read(share));
    stick.frame.apply([along, STICK_HEIGHT / 2.0])
}

/// Where the hand goes to let go of the stick, for this parameter.
pub(in crate::env) fn release(&[x, y, _]: &[f64; 3], offset: f64) -> [f64; 2] {
    let offset = f64::from(float32::read(offset));
    [x - HOLDER_HEIGHT / 2.0, y + offset * (STICK_WIDTH / 2.0)]
}
