//! The predicates, in the order of their names. They mean what those of
//! [`stick_button`](super::super::stick_button) do.

use super::world::{World, robot_shape, stick_shape};
use super::{BUTTON_TYPE, ROBOT_TYPE, STICK_TYPE, StickButtonMove};
use crate::env::stick_button::world::{button_shape, is_set};
use crate::geometry::Intersects;
use crate::task::{ObjectId, Predicate, PredicateId, State};

/// `AboveNoButton()`: neither the robot nor the stick lies over any button.
pub const ABOVE_NO_BUTTON: PredicateId = PredicateId(0);
/// `Grasped(robot, stick)`: the robot holds the stick.
pub const GRASPED: PredicateId = PredicateId(1);
/// `HandEmpty(robot)`: the robot's fingers are open.
pub const HAND_EMPTY: PredicateId = PredicateId(2);
/// `Pressed(button)`: the button has been pressed.
pub const PRESSED: PredicateId = PredicateId(3);
/// `RobotAboveButton(robot, button)`: the robot lies over the button.
pub const ROBOT_ABOVE_BUTTON: PredicateId = PredicateId(4);
/// `StickAboveButton(stick, button)`: the stick, at any place, lies over the button.
pub const STICK_ABOVE_BUTTON: PredicateId = PredicateId(5);

pub(super) static PREDICATES: [Predicate<StickButtonMove>; 6] = [
    Predicate {
        name: "AboveNoButton",
        arguments: &[],
        classifier: |_, state, _| above_no_button(state).unwrap_or(false),
    },
    Predicate {
        name: "Grasped",
        arguments: &[ROBOT_TYPE, STICK_TYPE],
        classifier: |_, state, _| is_grasped(state),
    },
    Predicate {
        name: "HandEmpty",
        arguments: &[ROBOT_TYPE],
        classifier: |_, state, _| World::of(state).is_some_and(|world| world.is_open()),
    },
    Predicate {
        name: "Pressed",
        arguments: &[BUTTON_TYPE],
        classifier: |_, state, objects| pressed(state, objects.first()),
    },
    Predicate {
        name: "RobotAboveButton",
        arguments: &[ROBOT_TYPE, BUTTON_TYPE],
        classifier: |_, state, objects| robot_above_button(state, objects.get(1)),
    },
    Predicate {
        name: "StickAboveButton",
        arguments: &[STICK_TYPE, BUTTON_TYPE],
        classifier: |_, state, objects| stick_above_button(state, objects.get(1)),
    },
];

pub(super) fn is_grasped(state: &State) -> bool {
    World::of(state).is_some_and(|world| world.is_grasped())
}

pub(super) fn button<'s>(state: &'s State, button: Option<&ObjectId>) -> Option<&'s [f64; 3]> {
    state.get(*button?)
}

pub(super) fn pressed(state: &State, object: Option<&ObjectId>) -> bool {
    button(state, object).is_some_and(|[_, _, pressed]| is_set(*pressed))
}

pub(super) fn robot_above_button(state: &State, object: Option<&ObjectId>) -> bool {
    let both = World::of(state).zip(button(state, object));
    both.is_some_and(|(world, button)| robot_shape(world.robot).intersects(&button_shape(button)))
}

pub(super) fn stick_above_button(state: &State, object: Option<&ObjectId>) -> bool {
    let both = World::of(state).zip(button(state, object));
    both.is_some_and(|(world, button)| stick_shape(world.stick).intersects(&button_shape(button)))
}

fn above_no_button(state: &State) -> Option<bool> {
    let world = World::of(state)?;
    let (robot, stick) = (robot_shape(world.robot), stick_shape(world.stick));
    let mut buttons = world.buttons.iter().map(button_shape);
    Some(!buttons.any(|button| robot.intersects(&button) || stick.intersects(&button)))
}
