//! The predicates, in the order of their names.

use super::world::{World, is_on, is_on_table};
use super::{BLOCK_TYPE, Blocks, ROBOT_TYPE};
use crate::task::{ObjectId, Predicate, PredicateId, State};

/// `Clear(block)`: the block is not held, and no block lies on it.
pub const CLEAR: PredicateId = PredicateId(0);
/// `GripperOpen(robot)`: the robot can pick a block.
pub const GRIPPER_OPEN: PredicateId = PredicateId(1);
/// `Holding(block)`: the block is held.
pub const HOLDING: PredicateId = PredicateId(2);
/// `On(upper, lower)`: the upper block lies on the lower one.
pub const ON: PredicateId = PredicateId(3);
/// `OnTable(block)`: the block lies on the table.
pub const ON_TABLE: PredicateId = PredicateId(4);

pub(super) static PREDICATES: [Predicate<Blocks>; 5] = [
    Predicate {
        name: "Clear",
        arguments: &[BLOCK_TYPE],
        classifier: |_, state, objects| clear(state, objects).unwrap_or(false),
    },
    Predicate {
        name: "GripperOpen",
        arguments: &[ROBOT_TYPE],
        classifier: |_, state, _| World::of(state).and_then(|w| w.is_open()) == Some(true),
    },
    Predicate {
        name: "Holding",
        arguments: &[BLOCK_TYPE],
        classifier: |_, state, objects| holding(state, objects).unwrap_or(false),
    },
    Predicate {
        name: "On",
        arguments: &[BLOCK_TYPE, BLOCK_TYPE],
        classifier: |_, state, objects| on(state, objects).unwrap_or(false),
    },
    Predicate {
        name: "OnTable",
        arguments: &[BLOCK_TYPE],
        classifier: |_, state, objects| on_table(state, objects).unwrap_or(false),
    },
];

fn clear(state: &State, objects: &[ObjectId]) -> Option<bool> {
    let [block] = objects else { return None };
    Some(World::of(state)?.is_clear(*block, state.get(*block)?))
}

fn holding(state: &State, objects: &[ObjectId]) -> Option<bool> {
    let (held, _) = World::of(state)?.held()?;
    Some(*objects == [held])
}

fn on(state: &State, objects: &[ObjectId]) -> Option<bool> {
    let [upper, lower] = objects else {
        return None;
    };
    Some(is_on(state.get(*upper)?, state.get(*lower)?))
}

fn on_table(state: &State, objects: &[ObjectId]) -> Option<bool> {
    let [block] = objects else { return None };
    Some(is_on_table(state.get(*block)?))
}
