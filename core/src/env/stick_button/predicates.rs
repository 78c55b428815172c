//! The predicates, in the order of their names.

use super::world::{World, button_shape, is_set, robot_shape, stick_shape};
use super::{BUTTON_TYPE, ROBOT_TYPE, STICK_TYPE, StickButton};
use crate::geometry::Intersects;
use crate::task::{ObjectId, Predicate, PredicateId, State};

/// `AboveNoButton()`: neither the robot nor the stick lies over any button.
pub const ABOVE_NO_BUTTON: PredicateId = PredicateId(0);
/// `Grasped(robot, stick)`: the robot holds the stick.
pub const GRASPED: PredicateId = PredicateId(1);
/// `HandEmpty(robot)`: the robot does not hold the stick.
pub const HAND_EMPTY: PredicateId = PredicateId(2);
/// `Pressed(button)`: the button has been pressed.
pub const PRESSED: PredicateId = PredicateId(3);
/// `RobotAboveButton(robot, button)`: the robot lies over the button.
pub const ROBOT_ABOVE_BUTTON: PredicateId = PredicateId(4);
/// `StickAboveButton(stick, button)`: the stick, at any place, lies over the
/// button.
pub const STICK_ABOVE_BUTTON: PredicateId = PredicateId(5);

pub(super) static PREDICATES: [Predicate<StickButton>; 6] = [
    Predicate {
        name: "AboveNoButton",
        arguments: &[],
        classifier: |_, state, _| above_no_button(state).unwrap_or(false),
    },
    Predicate {
        name: "Grasped",
        arguments: &[ROBOT_TYPE, STICK_TYPE],
        classifier: |_, state, _| is_held(state) == Some(true),
    },
    Predicate {
        name: "HandEmpty",
        arguments: &[ROBOT_TYPE],
        classifier: |_, state, _| is_held(state) == Some(false),
    },
    Predicate {
        name: "Pressed",
        arguments: &[BUTTON_TYPE],
        classifier: |_, state, objects| pressed(state, objects).unwrap_or(false),
    },
    Predicate {
        name: "RobotAboveButton",
        arguments: &[ROBOT_TYPE, BUTTON_TYPE],
        classifier: |_, state, objects| robot_above_button(state, objects).unwrap_or(false),
    },
    Predicate {
        name: "StickAboveButton",
        arguments: &[STICK_TYPE, BUTTON_TYPE],
        classifier: |_, state, objects| stick_above_button(state, objects).unwrap_or(false),
    },
];

/// Whether the robot holds the stick; `None` if this is no state with a stick.
pub(super) fn is_held(state: &State) -> Option<bool> {
    let [_, _, _, held] = World::of(state)?.stick;
    Some(is_set(*held))
}

pub(super) fn pressed(state: &State, objects: &[ObjectId]) -> Option<bool> {
    let [button] = objects else { return None };
    let [_, _, pressed] = state.get(*button)?;
    Some(is_set(*pressed))
}

fn robot_above_button(state: &State, objects: &[ObjectId]) -> Option<bool> {
    let [robot, button] = objects else {
        return None;
    };
    let button = button_shape(state.get(*button)?);
    Some(robot_shape(state.get(*robot)?).intersects(&button))
}

fn stick_above_button(state: &State, objects: &[ObjectId]) -> Option<bool> {
    let [stick, button] = objects else {
        return None;
    };
    let button = button_shape(state.get(*button)?);
    Some(stick_shape(state.get(*stick)?).intersects(&button))
}

fn above_no_button(state: &State) -> Option<bool> {
    let world = World::of(state)?;
    let (robot, stick) = (robot_shape(world.robot), stick_shape(world.stick));
    let mut buttons = world.buttons.iter().map(button_shape);
    Some(!buttons.any(|button| robot.intersects(&button) || stick.intersects(&button)))
}
