//! The operators, in the order of their names.

use super::{
    ABOVE_NO_BUTTON, BUTTON_TYPE, GRASPED, HAND_EMPTY, HOLDER_TYPE, PICK_STICK, PLACE_STICK,
    PRESSED, ROBOT_ABOVE_BUTTON, ROBOT_MOVE_TO_BUTTON, ROBOT_PRESS_BUTTON, ROBOT_TYPE,
    STICK_ABOVE_BUTTON, STICK_MOVE_TO_BUTTON, STICK_PRESS_BUTTON, STICK_TYPE,
};
use crate::task::{LiftedAtom, Operator};

/// The robot is the first parameter of every operator, and the stick the second one where
/// there is one.
const HAND_IS_EMPTY: LiftedAtom<'static> = LiftedAtom::new(HAND_EMPTY, &[0]);
const STICK_IS_GRASPED: LiftedAtom<'static> = LiftedAtom::new(GRASPED, &[0, 1]);
const NOTHING_BELOW: LiftedAtom<'static> = LiftedAtom::new(ABOVE_NO_BUTTON, &[]);

/// The robot or the stick above the button that is this parameter.
const fn robot_above(variables: &'static [u8; 2]) -> LiftedAtom<'static> {
    LiftedAtom::new(ROBOT_ABOVE_BUTTON, variables)
}
const fn stick_above(variables: &'static [u8; 2]) -> LiftedAtom<'static> {
    LiftedAtom::new(STICK_ABOVE_BUTTON, variables)
}

pub(super) static OPERATORS: [Operator<'static>; 10] = [
    Operator {
        name: "PickStickFromButton",
        parameters: &[ROBOT_TYPE, STICK_TYPE, BUTTON_TYPE],
        preconditions: &[HAND_IS_EMPTY, robot_above(&[0, 2])],
        add_effects: &[STICK_IS_GRASPED, NOTHING_BELOW],
        delete_effects: &[HAND_IS_EMPTY, robot_above(&[0, 2])],
        controller: PICK_STICK,
        controller_arguments: &[0, 1],
    },
    Operator {
        name: "PickStickFromNothing",
        parameters: &[ROBOT_TYPE, STICK_TYPE],
        preconditions: &[HAND_IS_EMPTY, NOTHING_BELOW],
        add_effects: &[STICK_IS_GRASPED],
        delete_effects: &[HAND_IS_EMPTY],
        controller: PICK_STICK,
        controller_arguments: &[0, 1],
    },
    Operator {
        name: "PlaceStickFromButton",
        parameters: &[ROBOT_TYPE, STICK_TYPE, HOLDER_TYPE, BUTTON_TYPE],
        preconditions: &[stick_above(&[1, 3]), STICK_IS_GRASPED],
        add_effects: &[HAND_IS_EMPTY],
        delete_effects: &[STICK_IS_GRASPED, stick_above(&[1, 3])],
        controller: PLACE_STICK,
        controller_arguments: &[0, 1, 2],
    },
    Operator {
        name: "PlaceStickFromNothing",
        parameters: &[ROBOT_TYPE, STICK_TYPE, HOLDER_TYPE],
        preconditions: &[STICK_IS_GRASPED, NOTHING_BELOW],
        add_effects: &[HAND_IS_EMPTY],
        delete_effects: &[STICK_IS_GRASPED],
        controller: PLACE_STICK,
        controller_arguments: &[0, 1, 2],
    },
    // Parameters: robot, the button it comes from, the button it goes to.
    Operator {
        name: "RobotMoveToButtonFromButton",
        parameters: &[ROBOT_TYPE, BUTTON_TYPE, BUTTON_TYPE],
        preconditions: &[robot_above(&[0, 1]), HAND_IS_EMPTY],
        add_effects: &[robot_above(&[0, 2])],
        delete_effects: &[robot_above(&[0, 1])],
        controller: ROBOT_MOVE_TO_BUTTON,
        controller_arguments: &[0, 2],
    },
    Operator {
        name: "RobotMoveToButtonFromNothing",
        parameters: &[ROBOT_TYPE, BUTTON_TYPE],
        preconditions: &[NOTHING_BELOW, HAND_IS_EMPTY],
        add_effects: &[robot_above(&[0, 1])],
        delete_effects: &[NOTHING_BELOW],
        controller: ROBOT_MOVE_TO_BUTTON,
        controller_arguments: &[0, 1],
    },
    Operator {
        name: "RobotPressButton",
        parameters: &[ROBOT_TYPE, BUTTON_TYPE],
        preconditions: &[HAND_IS_EMPTY, robot_above(&[0, 1])],
        add_effects: &[LiftedAtom::new(PRESSED, &[1])],
        delete_effects: &[],
        controller: ROBOT_PRESS_BUTTON,
        controller_arguments: &[0, 1],
    },
    // Parameters: robot, stick, the button it goes to, the button it comes from.
    Operator {
        name: "StickMoveToButtonFromButton",
        parameters: &[ROBOT_TYPE, STICK_TYPE, BUTTON_TYPE, BUTTON_TYPE],
        preconditions: &[STICK_IS_GRASPED, stick_above(&[1, 3])],
        add_effects: &[stick_above(&[1, 2])],
        delete_effects: &[stick_above(&[1, 3])],
        controller: STICK_MOVE_TO_BUTTON,
        controller_arguments: &[0, 2, 1],
    },
    // It does not delete that nothing is below.
    Operator {
        name: "StickMoveToButtonFromNothing",
        parameters: &[ROBOT_TYPE, STICK_TYPE, BUTTON_TYPE],
        preconditions: &[STICK_IS_GRASPED, NOTHING_BELOW],
        add_effects: &[stick_above(&[1, 2])],
        delete_effects: &[],
        controller: STICK_MOVE_TO_BUTTON,
        controller_arguments: &[0, 2, 1],
    },
    Operator {
        name: "StickPressButton",
        parameters: &[ROBOT_TYPE, STICK_TYPE, BUTTON_TYPE],
        preconditions: &[STICK_IS_GRASPED, stick_above(&[1, 2])],
        add_effects: &[LiftedAtom::new(PRESSED, &[2])],
        delete_effects: &[],
        controller: STICK_PRESS_BUTTON,
        controller_arguments: &[0, 1, 2],
    },
];
