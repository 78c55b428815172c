//! The operators, in the order of their names.

use super::{
    BLOCK_TYPE, CLEAR, GRIPPER_OPEN, HOLDING, ON, ON_TABLE, PICK, PUT_ON_TABLE, ROBOT_TYPE, STACK,
};
use crate::task::{LiftedAtom, Operator};

/// The block that moves is the first parameter of every operator.
const CLEAR_ABOVE: LiftedAtom<'static> = LiftedAtom::new(CLEAR, &[0]);
const HELD: LiftedAtom<'static> = LiftedAtom::new(HOLDING, &[0]);
const ON_THE_TABLE: LiftedAtom<'static> = LiftedAtom::new(ON_TABLE, &[0]);
/// The other block is the second parameter where there is one.
const ON_THE_OTHER: LiftedAtom<'static> = LiftedAtom::new(ON, &[0, 1]);
const OTHER_CLEAR_ABOVE: LiftedAtom<'static> = LiftedAtom::new(CLEAR, &[1]);
/// The robot is the last parameter.
const OPEN: LiftedAtom<'static> = LiftedAtom::new(GRIPPER_OPEN, &[1]);
const OPEN_BESIDE_TWO: LiftedAtom<'static> = LiftedAtom::new(GRIPPER_OPEN, &[2]);

pub(super) static OPERATORS: [Operator<'static>; 4] = [
    Operator {
        name: "PickFromTable",
        parameters: &[BLOCK_TYPE, ROBOT_TYPE],
        preconditions: &[ON_THE_TABLE, CLEAR_ABOVE, OPEN],
        add_effects: &[HELD],
        delete_effects: &[ON_THE_TABLE, CLEAR_ABOVE, OPEN],
        controller: PICK,
        controller_arguments: &[1, 0],
    },
    Operator {
        name: "PutOnTable",
        parameters: &[BLOCK_TYPE, ROBOT_TYPE],
        preconditions: &[HELD],
        add_effects: &[ON_THE_TABLE, CLEAR_ABOVE, OPEN],
        delete_effects: &[HELD],
        controller: PUT_ON_TABLE,
        controller_arguments: &[1, 0],
    },
    Operator {
        name: "Stack",
        parameters: &[BLOCK_TYPE, BLOCK_TYPE, ROBOT_TYPE],
        preconditions: &[HELD, OTHER_CLEAR_ABOVE],
        add_effects: &[ON_THE_OTHER, CLEAR_ABOVE, OPEN_BESIDE_TWO],
        delete_effects: &[HELD, OTHER_CLEAR_ABOVE],
        controller: STACK,
        controller_arguments: &[2, 0, 1],
    },
    Operator {
        name: "Unstack",
        parameters: &[BLOCK_TYPE, BLOCK_TYPE, ROBOT_TYPE],
        preconditions: &[ON_THE_OTHER, CLEAR_ABOVE, OPEN_BESIDE_TWO],
        add_effects: &[HELD, OTHER_CLEAR_ABOVE],
        delete_effects: &[ON_THE_OTHER, CLEAR_ABOVE, OPEN_BESIDE_TWO],
        controller: PICK,
        controller_arguments: &[2, 0],
    },
];
