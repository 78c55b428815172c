//! The predicates of both variants, in the order of their names.

use super::{CAN_TYPE, Can, cans, is_held, is_untrashed};
use crate::task::{ObjectId, Predicate, PredicateId, State};

/// `HandEmpty()`: no can is held.
pub const HAND_EMPTY: PredicateId = PredicateId(0);
/// `Holding(can)`: the can is held.
pub const HOLDING: PredicateId = PredicateId(1);
/// `Untrashed(can)`: the can has not been dumped.
pub const UNTRASHED: PredicateId = PredicateId(2);

pub(super) const fn predicates<E>() -> [Predicate<E>; 3] {
    [
        Predicate {
            name: "HandEmpty",
            arguments: &[],
            classifier: |_, state, _| cans(state).is_some_and(|cans| !cans.iter().any(is_held)),
        },
        Predicate {
            name: "Holding",
            arguments: &[CAN_TYPE],
            classifier: |_, state, objects| can(state, objects).is_some_and(is_held),
        },
        Predicate {
            name: "Untrashed",
            arguments: &[CAN_TYPE],
            classifier: |_, state, objects| can(state, objects).is_some_and(is_untrashed),
        },
    ]
}

fn can<'a>(state: &'a State, objects: &[ObjectId]) -> Option<&'a Can> {
    let [can] = objects else { return None };
    state.get(*can)
}
