//! The controllers. Each is one command, which the can does not influence.

use super::{Action, CAN_TYPE};
use crate::env::float32;
use crate::task::{Controller, ControllerId, Environment, Terminal, always};

/// `Grasp(can; start x, start y, end x, end y)`: one approach, to grasp.
pub const GRASP: ControllerId = ControllerId(0);
/// `Dump(can)` of [`ClutteredTable`](super::ClutteredTable): lets go of the held can
/// above the trash.
pub const DUMP: ControllerId = ControllerId(1);
/// `Place(can; start x, start y, end x, end y)` of
/// [`ClutteredTablePlace`](super::ClutteredTablePlace): one approach, at whose end the
/// held can is placed.
pub const PLACE: ControllerId = ControllerId(1);

/// The command to dump.
pub(super) const DUMP_COMMAND: Action = [0.0; 4];

pub(super) const fn dump<E: Environment<Action = Action>>() -> Controller<E> {
    Controller {
        name: "Dump",
        arguments: &[CAN_TYPE],
        parameters: &[],
        initiable: always,
        policy: |_, _, _, _| DUMP_COMMAND,
        terminal: Terminal::FirstAction,
    }
}

/// A controller whose parameters are its command.
pub(super) const fn approach<E: Environment<Action = Action>>(name: &'static str) -> Controller<E> {
    Controller {
        name,
        arguments: &[CAN_TYPE],
        parameters: &[[0.0, 1.0]; 4],
        initiable: |_, _, _, parameters| parameters.len() == 4,
        policy: |_, _, _, parameters| match *parameters {
            [start_x, start_y, end_x, end_y] => [start_x, start_y, end_x, end_y].map(float32::read),
            _ => Action::default(),
        },
        terminal: Terminal::FirstAction,
    }
}
