//! The predicates, in the order of their names.

use super::world::{Cup, World, is_filled, is_pressing, is_set};
use super::{CUP_TYPE, Coffee, JUG_TYPE, MACHINE_TYPE, ROBOT_TYPE};
use crate::task::{ObjectId, Predicate, PredicateId, State};

/// `CupFilled(cup)`: there is more in the cup than is wanted.
pub const CUP_FILLED: PredicateId = PredicateId(0);
/// `HandEmpty(robot)`: the robot neither holds nor turns the jug.
pub const HAND_EMPTY: PredicateId = PredicateId(1);
/// `Holding(robot, jug)`: the robot holds the jug.
pub const HOLDING: PredicateId = PredicateId(2);
/// `JugAboveCup(jug, cup)`: the jug is held where it pours into the cup.
pub const JUG_ABOVE_CUP: PredicateId = PredicateId(3);
/// `JugFilled(jug)`: there is coffee in the jug.
pub const JUG_FILLED: PredicateId = PredicateId(4);
/// `JugInMachine(jug, machine)`: the jug stands where it is filled.
pub const JUG_IN_MACHINE: PredicateId = PredicateId(5);
/// `MachineOn(machine)`: the button was pressed.
pub const MACHINE_ON: PredicateId = PredicateId(6);
/// `NotAboveCup(robot, jug)`: the jug is above no cup.
pub const NOT_ABOVE_CUP: PredicateId = PredicateId(7);
/// `NotSameCup(cup, cup)`: these are two.
pub const NOT_SAME_CUP: PredicateId = PredicateId(8);
/// `OnTable(jug)`: the jug is neither held nor in the machine.
pub const ON_TABLE: PredicateId = PredicateId(9);
/// `PressingButton(robot, machine)`: the hand is at the button.
pub const PRESSING_BUTTON: PredicateId = PredicateId(10);
/// `RobotAboveCup(robot, cup)`: the same as [`JUG_ABOVE_CUP`], of the robot.
pub const ROBOT_ABOVE_CUP: PredicateId = PredicateId(11);
/// `Twisting(robot, jug)`: the hand is at the top of the jug.
pub const TWISTING: PredicateId = PredicateId(12);

pub(super) static PREDICATES: [Predicate<Coffee>; 13] = [
    Predicate {
        name: "CupFilled",
        arguments: &[CUP_TYPE],
        classifier: |_, state, objects| cup(state, objects.first()).is_some_and(is_filled),
    },
    Predicate {
        name: "HandEmpty",
        arguments: &[ROBOT_TYPE],
        classifier: |_, state, _| holds(state, |w| !w.is_twisting() && !w.is_jug_held()),
    },
    Predicate {
        name: "Holding",
        arguments: &[ROBOT_TYPE, JUG_TYPE],
        classifier: |_, state, _| holds(state, |world| world.is_jug_held()),
    },
    Predicate {
        name: "JugAboveCup",
        arguments: &[JUG_TYPE, CUP_TYPE],
        classifier: |_, state, objects| is_above(state, objects.get(1)),
    },
    Predicate {
        name: "JugFilled",
        arguments: &[JUG_TYPE],
        classifier: |_, state, _| {
            holds(state, |world| {
                let [_, _, _, _, filled] = *world.jug;
                is_set(filled)
            })
        },
    },
    Predicate {
        name: "JugInMachine",
        arguments: &[JUG_TYPE, MACHINE_TYPE],
        classifier: |_, state, _| holds(state, |world| world.is_jug_in_machine()),
    },
    Predicate {
        name: "MachineOn",
        arguments: &[MACHINE_TYPE],
        classifier: |_, state, _| holds(state, |world| world.is_machine_on()),
    },
    Predicate {
        name: "NotAboveCup",
        arguments: &[ROBOT_TYPE, JUG_TYPE],
        classifier: |_, state, _| {
            holds(state, |world| {
                !world.cups.iter().any(|cup| world.is_above(cup))
            })
        },
    },
    Predicate {
        name: "NotSameCup",
        arguments: &[CUP_TYPE, CUP_TYPE],
        classifier: |_, _, objects| matches!(objects, [one, other] if one != other),
    },
    Predicate {
        name: "OnTable",
        arguments: &[JUG_TYPE],
        classifier: |_, state, _| holds(state, |w| !w.is_jug_held() && !w.is_jug_in_machine()),
    },
    Predicate {
        name: "PressingButton",
        arguments: &[ROBOT_TYPE, MACHINE_TYPE],
        classifier: |_, state, _| holds(state, |world| is_pressing(world.robot)),
    },
    Predicate {
        name: "RobotAboveCup",
        arguments: &[ROBOT_TYPE, CUP_TYPE],
        classifier: |_, state, objects| is_above(state, objects.get(1)),
    },
    Predicate {
        name: "Twisting",
        arguments: &[ROBOT_TYPE, JUG_TYPE],
        classifier: |_, state, _| holds(state, |world| world.is_twisting()),
    },
];

/// Whether something holds of a state; nothing does of those of other environments.
pub(super) fn holds(state: &State, of: impl Fn(&World<'_>) -> bool) -> bool {
    World::of(state).is_some_and(|world| of(&world))
}

pub(super) fn cup<'s>(state: &'s State, cup: Option<&ObjectId>) -> Option<&'s Cup> {
    state.get(*cup?)
}

fn is_above(state: &State, object: Option<&ObjectId>) -> bool {
    let cup = cup(state, object);
    cup.is_some_and(|cup| holds(state, |world| world.is_above(cup)))
}
