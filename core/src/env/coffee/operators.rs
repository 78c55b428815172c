//! The operators, in the order of their names.

use super::{
    CUP_FILLED, CUP_TYPE, HAND_EMPTY, HOLDING, JUG_ABOVE_CUP, JUG_FILLED, JUG_IN_MACHINE, JUG_TYPE,
    MACHINE_ON, MACHINE_TYPE, MOVE_TO_TWIST_JUG, NOT_ABOVE_CUP, NOT_SAME_CUP, ON_TABLE, PICK_JUG,
    PLACE_JUG_IN_MACHINE, POUR, PRESSING_BUTTON, ROBOT_ABOVE_CUP, ROBOT_TYPE, TURN_MACHINE_ON,
    TWIST_JUG, TWISTING,
};
use crate::task::{LiftedAtom, Operator};

/// The robot is the first parameter of every operator and the jug the second one.
const JUG_HELD: LiftedAtom<'static> = LiftedAtom::new(HOLDING, &[0, 1]);
const EMPTY: LiftedAtom<'static> = LiftedAtom::new(HAND_EMPTY, &[0]);
const AT_THE_TOP: LiftedAtom<'static> = LiftedAtom::new(TWISTING, &[0, 1]);
const ABOVE_NO_CUP: LiftedAtom<'static> = LiftedAtom::new(NOT_ABOVE_CUP, &[0, 1]);
const COFFEE_IN_JUG: LiftedAtom<'static> = LiftedAtom::new(JUG_FILLED, &[1]);
const ON_THE_TABLE: LiftedAtom<'static> = LiftedAtom::new(ON_TABLE, &[1]);
/// The machine is the third one where there is one.
const IN_THE_MACHINE: LiftedAtom<'static> = LiftedAtom::new(JUG_IN_MACHINE, &[1, 2]);
const AT_THE_BUTTON: LiftedAtom<'static> = LiftedAtom::new(PRESSING_BUTTON, &[0, 2]);
/// And so is the cup that is poured into; the fourth one is that before.
const JUG_ABOVE: LiftedAtom<'static> = LiftedAtom::new(JUG_ABOVE_CUP, &[1, 2]);
const ROBOT_ABOVE: LiftedAtom<'static> = LiftedAtom::new(ROBOT_ABOVE_CUP, &[0, 2]);
const CUP_FULL: LiftedAtom<'static> = LiftedAtom::new(CUP_FILLED, &[2]);
const JUG_ABOVE_OTHER: LiftedAtom<'static> = LiftedAtom::new(JUG_ABOVE_CUP, &[1, 3]);
const ROBOT_ABOVE_OTHER: LiftedAtom<'static> = LiftedAtom::new(ROBOT_ABOVE_CUP, &[0, 3]);

pub(super) static OPERATORS: [Operator<'static>; 8] = [
    Operator {
        name: "MoveToTwistJug",
        parameters: &[ROBOT_TYPE, JUG_TYPE],
        preconditions: &[ON_THE_TABLE, EMPTY],
        add_effects: &[AT_THE_TOP],
        delete_effects: &[EMPTY],
        controller: MOVE_TO_TWIST_JUG,
        controller_arguments: &[0, 1],
    },
    Operator {
        name: "PickJugFromMachine",
        parameters: &[ROBOT_TYPE, JUG_TYPE, MACHINE_TYPE],
        preconditions: &[EMPTY, IN_THE_MACHINE, AT_THE_BUTTON],
        add_effects: &[JUG_HELD],
        delete_effects: &[EMPTY, IN_THE_MACHINE, AT_THE_BUTTON],
        controller: PICK_JUG,
        controller_arguments: &[0, 1],
    },
    Operator {
        name: "PickJugFromTable",
        parameters: &[ROBOT_TYPE, JUG_TYPE],
        preconditions: &[ON_THE_TABLE, EMPTY],
        add_effects: &[JUG_HELD],
        delete_effects: &[ON_THE_TABLE, EMPTY],
        controller: PICK_JUG,
        controller_arguments: &[0, 1],
    },
    Operator {
        name: "PlaceJugInMachine",
        parameters: &[ROBOT_TYPE, JUG_TYPE, MACHINE_TYPE],
        preconditions: &[JUG_HELD],
        add_effects: &[EMPTY, IN_THE_MACHINE],
        delete_effects: &[JUG_HELD],
        controller: PLACE_JUG_IN_MACHINE,
        controller_arguments: &[0, 1, 2],
    },
    Operator {
        name: "PourFromNowhere",
        parameters: &[ROBOT_TYPE, JUG_TYPE, CUP_TYPE],
        preconditions: &[JUG_HELD, COFFEE_IN_JUG, ABOVE_NO_CUP],
        add_effects: &[JUG_ABOVE, ROBOT_ABOVE, CUP_FULL],
        delete_effects: &[ABOVE_NO_CUP],
        controller: POUR,
        controller_arguments: &[0, 1, 2],
    },
    Operator {
        name: "PourFromOtherCup",
        parameters: &[ROBOT_TYPE, JUG_TYPE, CUP_TYPE, CUP_TYPE],
        preconditions: &[
            JUG_HELD,
            COFFEE_IN_JUG,
            JUG_ABOVE_OTHER,
            ROBOT_ABOVE_OTHER,
            LiftedAtom::new(NOT_SAME_CUP, &[2, 3]),
        ],
        add_effects: &[JUG_ABOVE, ROBOT_ABOVE, CUP_FULL],
        delete_effects: &[JUG_ABOVE_OTHER, ROBOT_ABOVE_OTHER],
        controller: POUR,
        controller_arguments: &[0, 1, 2],
    },
    Operator {
        name: "TurnMachineOn",
        parameters: &[ROBOT_TYPE, JUG_TYPE, MACHINE_TYPE],
        preconditions: &[EMPTY, IN_THE_MACHINE],
        add_effects: &[
            COFFEE_IN_JUG,
            LiftedAtom::new(MACHINE_ON, &[2]),
            AT_THE_BUTTON,
        ],
        delete_effects: &[],
        controller: TURN_MACHINE_ON,
        controller_arguments: &[0, 2],
    },
    Operator {
        name: "TwistJug",
        parameters: &[ROBOT_TYPE, JUG_TYPE],
        preconditions: &[ON_THE_TABLE, AT_THE_TOP],
        add_effects: &[EMPTY],
        delete_effects: &[AT_THE_TOP],
        controller: TWIST_JUG,
        controller_arguments: &[0, 1],
    },
];
