//! The operators, in the order of their names.
//!
//! Parameters are drawn uniformly from the controller's space, as the
//! [`Environment`](crate::task::Environment) does where nothing else is said.

use super::{
    ABOVE_NO_BUTTON, BUTTON_TYPE, GRASPED, HAND_EMPTY, PICK_STICK, PLACE_STICK, PRESSED,
    ROBOT_ABOVE_BUTTON, ROBOT_PRESS_BUTTON, ROBOT_TYPE, STICK_ABOVE_BUTTON, STICK_PRESS_BUTTON,
    STICK_TYPE,
};
use crate::task::{LiftedAtom, Operator};

/// The robot is the first parameter of every operator.
const HAND_IS_EMPTY: LiftedAtom<'static> = LiftedAtom::new(HAND_EMPTY, &[0]);
/// The stick is the second parameter of every operator that grasps.
const STICK_IS_GRASPED: LiftedAtom<'static> = LiftedAtom::new(GRASPED, &[0, 1]);
const NOTHING_BELOW: LiftedAtom<'static> = LiftedAtom::new(ABOVE_NO_BUTTON, &[]);

pub(super) static OPERATORS: [Operator<'static>; 8] = [
    Operator {
        name: "PickStickFromButton",
        parameters: &[ROBOT_TYPE, STICK_TYPE, BUTTON_TYPE],
        preconditions: &[HAND_IS_EMPTY, LiftedAtom::new(ROBOT_ABOVE_BUTTON, &[0, 2])],
        add_effects: &[STICK_IS_GRASPED, NOTHING_BELOW],
        delete_effects: &[HAND_IS_EMPTY, LiftedAtom::new(ROBOT_ABOVE_BUTTON, &[0, 2])],
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
        parameters: &[ROBOT_TYPE, STICK_TYPE],
        preconditions: &[STICK_IS_GRASPED],
        add_effects: &[HAND_IS_EMPTY, NOTHING_BELOW],
        delete_effects: &[STICK_IS_GRASPED],
        controller: PLACE_STICK,
        controller_arguments: &[0, 1],
    },
    Operator {
        name: "PlaceStickFromNothing",
        parameters: &[ROBOT_TYPE, STICK_TYPE],
        preconditions: &[STICK_IS_GRASPED],
        add_effects: &[HAND_IS_EMPTY],
        delete_effects: &[STICK_IS_GRASPED],
        controller: PLACE_STICK,
        controller_arguments: &[0, 1],
    },
    // Parameters: robot, button, the button it comes from, stick.
    Operator {
        name: "RobotPressButtonFromButton",
        parameters: &[ROBOT_TYPE, BUTTON_TYPE, BUTTON_TYPE, STICK_TYPE],
        preconditions: &[HAND_IS_EMPTY, LiftedAtom::new(ROBOT_ABOVE_BUTTON, &[0, 2])],
        add_effects: &[
            LiftedAtom::new(PRESSED, &[1]),
            LiftedAtom::new(ROBOT_ABOVE_BUTTON, &[0, 1]),
        ],
        delete_effects: &[LiftedAtom::new(ROBOT_ABOVE_BUTTON, &[0, 2])],
        controller: ROBOT_PRESS_BUTTON,
        controller_arguments: &[0, 1, 3],
    },
    Operator {
        name: "RobotPressButtonFromNothing",
        parameters: &[ROBOT_TYPE, BUTTON_TYPE, STICK_TYPE],
        preconditions: &[HAND_IS_EMPTY, NOTHING_BELOW],
        add_effects: &[
            LiftedAtom::new(PRESSED, &[1]),
            LiftedAtom::new(ROBOT_ABOVE_BUTTON, &[0, 1]),
        ],
        delete_effects: &[NOTHING_BELOW],
        controller: ROBOT_PRESS_BUTTON,
        controller_arguments: &[0, 1, 2],
    },
    // Parameters: robot, stick, button, the button it comes from.
    Operator {
        name: "StickPressButtonFromButton",
        parameters: &[ROBOT_TYPE, STICK_TYPE, BUTTON_TYPE, BUTTON_TYPE],
        preconditions: &[
            STICK_IS_GRASPED,
            LiftedAtom::new(STICK_ABOVE_BUTTON, &[1, 3]),
        ],
        add_effects: &[
            LiftedAtom::new(STICK_ABOVE_BUTTON, &[1, 2]),
            LiftedAtom::new(PRESSED, &[2]),
        ],
        delete_effects: &[LiftedAtom::new(STICK_ABOVE_BUTTON, &[1, 3])],
        controller: STICK_PRESS_BUTTON,
        controller_arguments: &[0, 1, 2],
    },
    Operator {
        name: "StickPressButtonFromNothing",
        parameters: &[ROBOT_TYPE, STICK_TYPE, BUTTON_TYPE],
        preconditions: &[STICK_IS_GRASPED, NOTHING_BELOW],
        add_effects: &[
            LiftedAtom::new(STICK_ABOVE_BUTTON, &[1, 2]),
            LiftedAtom::new(PRESSED, &[2]),
        ],
        delete_effects: &[NOTHING_BELOW],
        controller: STICK_PRESS_BUTTON,
        controller_arguments: &[0, 1, 2],
    },
];
