//! The controllers.

use super::predicates::{cup, holds};
use super::world::{World, distance_squared, hand, handle, is_filled, pour_place, top};
use super::{
    Action, BUTTON, CUP_TYPE, Coffee, DISPENSER, HANDLE_HEIGHT, JUG_TYPE, MACHINE_TYPE,
    MAX_ANGULAR_SPEED, MAX_SPEED, POURING_TILT, ROBOT_TYPE, ROOM, TURN_LIMIT,
};
use crate::env::float32;
use crate::real::Real;
use crate::task::{Controller, ControllerId, ObjectId, State, Terminal, always};

/// `MoveToTwistJug(robot, jug)`: moves the hand to the top of the jug, from above.
pub const MOVE_TO_TWIST_JUG: ControllerId = ControllerId(0);
/// `PickJug(robot, jug)`: moves the hand to the handle, from the front, and closes it.
pub const PICK_JUG: ControllerId = ControllerId(1);
/// `PlaceJugInMachine(robot, jug, machine)`: moves the held jug into the machine.
pub const PLACE_JUG_IN_MACHINE: ControllerId = ControllerId(2);
/// `Pour(robot, jug, cup)`: moves the held jug above the cup and tilts it.
pub const POUR: ControllerId = ControllerId(3);
/// `TurnMachineOn(robot, machine)`: moves the hand to the button.
pub const TURN_MACHINE_ON: ControllerId = ControllerId(4);
/// `TwistJug(robot, jug; p)`: turns the jug to `p` times [`TURN_LIMIT`], and lets go.
pub const TWIST_JUG: ControllerId = ControllerId(5);

/// How near is near enough, of squared distances.
const NEAR: f64 = 0.1;
/// Likewise to the height of the button.
const NEAR_BUTTON_HEIGHT: f64 = 0.04;
/// How far the jug is from its rotation at most when it is turned.
const TURN_TOLERANCE: f64 = 0.1;
/// How far in front of the handle the hand goes down.
const IN_FRONT: f64 = 1.5;

pub(super) static CONTROLLERS: [Controller<Coffee>; 6] = [
    Controller {
        name: "MoveToTwistJug",
        arguments: &[ROBOT_TYPE, JUG_TYPE],
        parameters: &[],
        initiable: always,
        policy: |_, state, _, _| act(state, move_to_twist),
        terminal: Terminal::When(|_, state, _, _| holds(state, |world| world.is_twisting())),
    },
    Controller {
        name: "PickJug",
        arguments: &[ROBOT_TYPE, JUG_TYPE],
        parameters: &[],
        initiable: always,
        policy: |_, state, _, _| act(state, pick),
        terminal: Terminal::When(|_, state, _, _| holds(state, |world| world.is_jug_held())),
    },
    Controller {
        name: "PlaceJugInMachine",
        arguments: &[ROBOT_TYPE, JUG_TYPE, MACHINE_TYPE],
        parameters: &[],
        initiable: always,
        policy: |_, state, _, _| act(state, place),
        terminal: Terminal::When(|_, state, _, _| holds(state, |world| world.is_jug_in_machine())),
    },
    Controller {
        name: "Pour",
        arguments: &[ROBOT_TYPE, JUG_TYPE, CUP_TYPE],
        parameters: &[],
        initiable: |_, state, _, _| holds(state, |world| world.is_jug_held()),
        policy: |_, state, objects, _| pour(state, objects).unwrap_or_default(),
        terminal: Terminal::When(|_, state, objects, _| {
            cup(state, objects.get(2)).is_some_and(is_filled)
        }),
    },
    Controller {
        name: "TurnMachineOn",
        arguments: &[ROBOT_TYPE, MACHINE_TYPE],
        parameters: &[],
        initiable: always,
        policy: |_, state, _, _| act(state, turn_on),
        terminal: Terminal::When(|_, state, _, _| holds(state, |world| world.is_machine_on())),
    },
    Controller {
        name: "TwistJug",
        arguments: &[ROBOT_TYPE, JUG_TYPE],
        parameters: &[[-1.0, 1.0]],
        initiable: always,
        policy: |_, state, _, parameters| match parameters {
            [share] => act(state, |world| twist(world, *share)),
            _ => Action::default(),
        },
        terminal: Terminal::When(|_, state, _, _| {
            holds(state, |w| !w.is_twisting() && !w.is_jug_held())
        }),
    },
];

/// What a controller commands; nothing in the states of other environments.
fn act(state: &State, policy: impl Fn(&World<'_>) -> Action) -> Action {
    World::of(state).map_or(Action::default(), |world| policy(&world))
}

fn move_to_twist(world: &World<'_>) -> Action {
    let ([x, y, _], at) = (top(world.jug), hand(world.robot));
    let [hand_x, hand_y, _] = at;
    if distance_squared([x, y], [hand_x, hand_y]) < NEAR {
        go(at, top(world.jug))
    } else {
        go(at, [x, y, ROOM])
    }
}

fn twist(world: &World<'_>, share: f64) -> Action {
    let [_, _, rotation, ..] = *world.jug;
    let left = f64::from(float32::read(share)) * TURN_LIMIT - rotation;
    if Real::abs(left) < TURN_TOLERANCE {
        return go_up(world);
    }
    [0.0, 0.0, 0.0, 0.0, turn(left), 0.0]
}

fn pick(world: &World<'_>) -> Action {
    let (target, at) = (handle(world.jug), hand(world.robot));
    let ([x, y, height], [hand_x, hand_y, hand_z]) = (target, at);
    let front = y - IN_FRONT;
    if distance_squared(target, at) < NEAR {
        [0.0, 0.0, 0.0, 0.0, 0.0, -1.0]
    } else if hand_y < y && distance_squared([x, height], [hand_x, hand_z]) < NEAR {
        go(at, target)
    } else if distance_squared([x, front], [hand_x, hand_y]) < NEAR {
        go(at, [x, front, height])
    } else if distance_squared([ROOM], [hand_z]) < NEAR {
        go(at, [x, front, ROOM])
    } else {
        go_up(world)
    }
}

fn place(world: &World<'_>) -> Action {
    let [x, y, ..] = *world.jug;
    let [_, _, hand_z] = hand(world.robot);
    // Where the jug is if it is held.
    let jug = [x, y, hand_z - HANDLE_HEIGHT];
    let [_, _, z] = jug;
    if distance_squared(jug, DISPENSER) < NEAR {
        [0.0, 0.0, 0.0, 0.0, 0.0, 1.0]
    } else if z > 0.0 {
        go(jug, DISPENSER)
    } else {
        [0.0, 0.0, 1.0, 0.0, 0.0, 0.0]
    }
}

fn turn_on(world: &World<'_>) -> Action {
    let ([x, y, z], [_, _, height]) = (hand(world.robot), BUTTON);
    if distance_squared([height], [z]) < NEAR_BUTTON_HEIGHT {
        go([x, y, z], BUTTON)
    } else {
        go([x, y, z], [x, y, height])
    }
}

fn pour(state: &State, objects: &[ObjectId]) -> Option<Action> {
    let (world, cup) = (World::of(state)?, cup(state, objects.get(2))?);
    let [_, _, hand_z, tilt, ..] = *world.robot;
    let [jug_x, jug_y, ..] = *world.jug;
    let jug = [jug_x, jug_y, hand_z - HANDLE_HEIGHT];
    let ([_, _, z], target) = (jug, pour_place(cup));
    let [x, y, _] = target;
    if distance_squared(jug, target) < NEAR {
        return Some([0.0, 0.0, 0.0, turn(POURING_TILT - tilt), 0.0, 0.0]);
    }
    let motion = if distance_squared([x, y], [jug_x, jug_y]) < NEAR {
        go(jug, target)
    } else if distance_squared([ROOM], [hand_z]) < NEAR {
        go(jug, [x, y, z])
    } else {
        go_up(&world)
    };
    let [dx, dy, dz, ..] = motion;
    Some([dx, dy, dz, turn(-tilt), 0.0, 0.0])
}

/// One step towards the ceiling.
fn go_up(world: &World<'_>) -> Action {
    let [x, y, z] = hand(world.robot);
    go([x, y, z], [x, y, ROOM])
}

/// One step on the straight way from a place to another.
fn go(from: [f64; 3], to: [f64; 3]) -> Action {
    let [x, y, z] = from;
    let [to_x, to_y, to_z] = to;
    let length = Real::sqrt(distance_squared(from, to));
    let speed = |gap: f64| {
        let gap = if length > MAX_SPEED {
            gap * MAX_SPEED / length
        } else {
            gap
        };
        (gap / MAX_SPEED) as f32
    };
    let [dx, dy, dz] = [to_x - x, to_y - y, to_z - z].map(speed);
    [dx, dy, dz, 0.0, 0.0, 0.0]
}

/// The angular speed for an angle, as far as one step turns.
fn turn(angle: f64) -> f32 {
    let angle = Real::clamp(angle, -MAX_ANGULAR_SPEED, MAX_ANGULAR_SPEED);
    (angle / MAX_ANGULAR_SPEED) as f32
}
