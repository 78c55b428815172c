//! The controllers. Motions go straight to their target, at most one step size per axis at
//! a time.

use super::predicates::{button, is_grasped, pressed, robot_above_button, stick_above_button};
use super::world::{World, robot_shape, stick_shape};
use super::{Action, BUTTON_TYPE, HOLDER_TYPE, ROBOT_TYPE, STICK_TYPE, StickButtonMove};
use crate::env::stick_button::TARGET_TOLERANCE;
use crate::env::stick_button::controllers::{grasp, release, speeds};
use crate::env::stick_button::world::{self as table, button_shape, tip_shape};
use crate::geometry::{Intersects, distance_squared};
use crate::task::{Controller, ControllerId, ObjectId, State, Terminal, always};

/// `PickStick(robot, stick; mu)`: goes to the point at `mu` times the width along the
/// stick, half its height across, and grasps it.
pub const PICK_STICK: ControllerId = ControllerId(0);
/// `PlaceStick(robot, stick, holder; o)`: goes to half the holder's height left of the
/// holder's corner and `o` times half the stick's width above it, and lets go.
pub const PLACE_STICK: ControllerId = ControllerId(1);
/// `RobotMoveToButton(robot, button)`: moves the hand to the button, until it is above it.
pub const ROBOT_MOVE_TO_BUTTON: ControllerId = ControllerId(2);
/// `RobotPressButton(robot, button)`: presses the button by hand.
pub const ROBOT_PRESS_BUTTON: ControllerId = ControllerId(3);
/// `StickMoveToButton(robot, button, stick)`: moves the tip of the held stick to the button,
/// until the stick, at any place, is above it.
pub const STICK_MOVE_TO_BUTTON: ControllerId = ControllerId(4);
/// `StickPressButton(robot, stick, button)`: presses the button with the tip.
pub const STICK_PRESS_BUTTON: ControllerId = ControllerId(5);

pub(super) static CONTROLLERS: [Controller<StickButtonMove>; 6] = [
    Controller {
        name: "PickStick",
        arguments: &[ROBOT_TYPE, STICK_TYPE],
        parameters: &[[0.0, 1.0]],
        initiable: always,
        policy: |_, state, _, parameters| match (World::of(state), parameters) {
            (Some(world), [share]) => act_at(&world, grasp(&stick_shape(world.stick), *share)),
            _ => REST,
        },
        terminal: Terminal::When(|_, state, _, _| is_grasped(state)),
    },
    Controller {
        name: "PlaceStick",
        arguments: &[ROBOT_TYPE, STICK_TYPE, HOLDER_TYPE],
        parameters: &[[-1.0, 1.0]],
        initiable: always,
        policy: |_, state, _, parameters| match (World::of(state), parameters) {
            (Some(world), [offset]) => act_at(&world, release(world.holder, *offset)),
            _ => REST,
        },
        terminal: Terminal::When(|_, state, _, _| !is_grasped(state)),
    },
    Controller {
        name: "RobotMoveToButton",
        arguments: &[ROBOT_TYPE, BUTTON_TYPE],
        parameters: &[],
        initiable: always,
        policy: |_, state, objects, _| robot_move(state, objects).unwrap_or(REST),
        terminal: Terminal::When(|_, state, objects, _| robot_above_button(state, objects.get(1))),
    },
    Controller {
        name: "RobotPressButton",
        arguments: &[ROBOT_TYPE, BUTTON_TYPE],
        parameters: &[],
        initiable: always,
        policy: |_, state, objects, _| robot_press(state, objects).unwrap_or(REST),
        terminal: Terminal::When(|_, state, objects, _| pressed(state, objects.get(1))),
    },
    Controller {
        name: "StickMoveToButton",
        arguments: &[ROBOT_TYPE, BUTTON_TYPE, STICK_TYPE],
        parameters: &[],
        initiable: always,
        policy: |_, state, objects, _| stick_move(state, objects).unwrap_or(REST),
        terminal: Terminal::When(|_, state, objects, _| stick_above_button(state, objects.get(1))),
    },
    Controller {
        name: "StickPressButton",
        arguments: &[ROBOT_TYPE, STICK_TYPE, BUTTON_TYPE],
        parameters: &[],
        initiable: always,
        policy: |_, state, objects, _| stick_press(state, objects).unwrap_or(REST),
        terminal: Terminal::When(|_, state, objects, _| pressed(state, objects.get(2))),
    },
];

/// Nothing, so that a run ends as stuck.
const REST: Action = [0.0, 0.0, 0.0, -1.0, -1.0];
const PRESS: Action = [0.0, 0.0, 0.0, 1.0, -1.0];
const PICK_OR_PLACE: Action = [0.0, 0.0, 0.0, -1.0, 1.0];

fn robot_move(state: &State, objects: &[ObjectId]) -> Option<Action> {
    let (world, button) = (World::of(state)?, button(state, objects.get(1))?);
    Some(go(
        robot_shape(world.robot).centre,
        button_shape(button).centre,
    ))
}

/// Presses where a stick with its corner at the robot would be above the button: the
/// framework takes the robot, whose type it does not know, for one.
fn robot_press(state: &State, objects: &[ObjectId]) -> Option<Action> {
    let (world, button) = (World::of(state)?, button(state, objects.get(1))?);
    let shape = table::stick_shape(world.robot);
    Some(press_if(shape.intersects(&button_shape(button))))
}

fn stick_move(state: &State, objects: &[ObjectId]) -> Option<Action> {
    let (world, button) = (World::of(state)?, button(state, objects.get(1))?);
    let tip = tip_shape(&stick_shape(world.stick));
    // The corner of the tip, not its centre, goes to the button.
    Some(go(tip.frame.origin(), button_shape(button).centre))
}

fn stick_press(state: &State, objects: &[ObjectId]) -> Option<Action> {
    let (world, button) = (World::of(state)?, button(state, objects.get(2))?);
    let tip = tip_shape(&stick_shape(world.stick));
    Some(press_if(tip.intersects(&button_shape(button))))
}

fn press_if(is_above: bool) -> Action {
    if is_above { PRESS } else { REST }
}

/// Goes to the target, and picks or places when close enough to it.
fn act_at(world: &World<'_>, target: [f64; 2]) -> Action {
    let at = robot_shape(world.robot).centre;
    if distance_squared(at, target) < TARGET_TOLERANCE {
        PICK_OR_PLACE
    } else {
        go(at, target)
    }
}

/// One step towards a target.
fn go(from: [f64; 2], to: [f64; 2]) -> Action {
    let [dx, dy] = speeds(from, to);
    [dx, dy, 0.0, -1.0, -1.0]
}
