//! The operators: grasping, and the two ways to get rid of a can.

use super::{CAN_TYPE, HAND_EMPTY, HOLDING, UNTRASHED, controllers};
use crate::task::{LiftedAtom, Operator};

/// The can is the only parameter of every operator.
const HELD: LiftedAtom<'static> = LiftedAtom::new(HOLDING, &[0]);
const ON_TABLE_OR_HELD: LiftedAtom<'static> = LiftedAtom::new(UNTRASHED, &[0]);
const NOTHING_HELD: LiftedAtom<'static> = LiftedAtom::new(HAND_EMPTY, &[]);

pub(super) const DUMP: Operator<'static> = Operator {
    name: "Dump",
    parameters: &[CAN_TYPE],
    preconditions: &[HELD],
    add_effects: &[NOTHING_HELD],
    delete_effects: &[HELD, ON_TABLE_OR_HELD],
    controller: controllers::DUMP,
    controller_arguments: &[0],
};

pub(super) const GRASP: Operator<'static> = Operator {
    name: "Grasp",
    parameters: &[CAN_TYPE],
    preconditions: &[NOTHING_HELD, ON_TABLE_OR_HELD],
    add_effects: &[HELD],
    delete_effects: &[NOTHING_HELD],
    controller: controllers::GRASP,
    controller_arguments: &[0],
};

pub(super) const PLACE: Operator<'static> = Operator {
    name: "Place",
    parameters: &[CAN_TYPE],
    preconditions: &[HELD, ON_TABLE_OR_HELD],
    add_effects: &[NOTHING_HELD],
    delete_effects: &[HELD],
    controller: controllers::PLACE,
    controller_arguments: &[0],
};
