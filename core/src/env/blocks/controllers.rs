//! The controllers. Each is one command.

use super::world::centre;
use super::{Action, BLOCK_SIZE, BLOCK_TYPE, Blocks, REACH_X, REACH_Y, ROBOT_TYPE, TABLE_HEIGHT};
use crate::env::float32;
use crate::real::Real;
use crate::task::{Controller, ControllerId, ObjectId, State, Terminal};

/// `Pick(robot, block)`: closes the fingers at the block.
pub const PICK: ControllerId = ControllerId(0);
/// `PutOnTable(robot, block; u, v)`: opens the fingers on the table, at `u` times the
/// reach along x and `v` times the reach along y. The block is the held one.
pub const PUT_ON_TABLE: ControllerId = ControllerId(1);
/// `Stack(robot, block, other)`: opens the fingers above the other block. The first
/// block is the held one.
pub const STACK: ControllerId = ControllerId(2);

const CLOSED: f32 = 0.0;
const OPEN: f32 = 1.0;
/// The highest place that can be commanded.
const TOP: f64 = 10.0;

pub(super) static CONTROLLERS: [Controller<Blocks>; 3] = [
    Controller {
        name: "Pick",
        arguments: &[ROBOT_TYPE, BLOCK_TYPE],
        parameters: &[],
        initiable: |_, state, objects, _| pick(state, objects).is_some(),
        policy: |_, state, objects, _| pick(state, objects).unwrap_or_default(),
        terminal: Terminal::FirstAction,
    },
    Controller {
        name: "PutOnTable",
        arguments: &[ROBOT_TYPE, BLOCK_TYPE],
        parameters: &[[0.0, 1.0]; 2],
        initiable: |_, _, _, parameters| put_on_table(parameters).is_some(),
        policy: |_, _, _, parameters| put_on_table(parameters).unwrap_or_default(),
        terminal: Terminal::FirstAction,
    },
    Controller {
        name: "Stack",
        arguments: &[ROBOT_TYPE, BLOCK_TYPE, BLOCK_TYPE],
        parameters: &[],
        initiable: |_, state, objects, _| stack(state, objects).is_some(),
        policy: |_, state, objects, _| stack(state, objects).unwrap_or_default(),
        terminal: Terminal::FirstAction,
    },
];

fn pick(state: &State, objects: &[ObjectId]) -> Option<Action> {
    let [_, block] = objects else { return None };
    Some(command(centre(state.get(*block)?), CLOSED))
}

fn put_on_table(parameters: &[f64]) -> Option<Action> {
    let [u, v] = parameters else { return None };
    let along =
        |[low, high]: [f64; 2], part: f64| low + (high - low) * f64::from(float32::read(part));
    let z = TABLE_HEIGHT + 0.5 * BLOCK_SIZE;
    Some(command([along(REACH_X, *u), along(REACH_Y, *v), z], OPEN))
}

fn stack(state: &State, objects: &[ObjectId]) -> Option<Action> {
    let [_, _, other] = objects else { return None };
    let [x, y, z] = centre(state.get(*other)?);
    Some(command([x, y, z + BLOCK_SIZE], OPEN))
}

/// The command to do this there, or at the nearest place within reach.
fn command([x, y, z]: [f64; 3], fingers: f32) -> Action {
    let limit = |number: f64, [low, high]: [f64; 2]| Real::clamp(number, low, high) as f32;
    [
        limit(x, REACH_X),
        limit(y, REACH_Y),
        limit(z, [0.0, TOP]),
        fingers,
    ]
}
