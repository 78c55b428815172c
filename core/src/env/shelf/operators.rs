//! The operators, in the order of their names.
//!
//! Parameters are drawn uniformly from the controller's space, as the
//! [`Environment`](crate::task::Environment) does where nothing else is said.

use super::{
    BOX_TYPE, HAND_EMPTY, HOLDING, IN_SHELF, ON_TABLE, PICK, PLACE, ROBOT_TYPE, SHELF_TYPE,
};
use crate::task::{LiftedAtom, Operator};

// Robot and box are the first parameters of both operators.
const HAND_IS_EMPTY: LiftedAtom<'static> = LiftedAtom::new(HAND_EMPTY, &[0]);
const BOX_IS_HELD: LiftedAtom<'static> = LiftedAtom::new(HOLDING, &[0, 1]);
const BOX_IS_ON_TABLE: LiftedAtom<'static> = LiftedAtom::new(ON_TABLE, &[1]);

pub(super) static OPERATORS: [Operator<'static>; 2] = [
    Operator {
        name: "Pick",
        parameters: &[ROBOT_TYPE, BOX_TYPE],
        preconditions: &[HAND_IS_EMPTY, BOX_IS_ON_TABLE],
        add_effects: &[BOX_IS_HELD],
        delete_effects: &[HAND_IS_EMPTY, BOX_IS_ON_TABLE],
        controller: PICK,
        controller_arguments: &[0, 1],
    },
    Operator {
        name: "Place",
        parameters: &[ROBOT_TYPE, BOX_TYPE, SHELF_TYPE],
        preconditions: &[BOX_IS_HELD],
        add_effects: &[HAND_IS_EMPTY, LiftedAtom::new(IN_SHELF, &[1, 2])],
        delete_effects: &[BOX_IS_HELD],
        controller: PLACE,
        controller_arguments: &[0, 1, 2],
    },
];
