//! The controllers. Each commands a single action.

use super::{Action, BOX_TYPE, ROBOT_TYPE, SHELF_TYPE, Shelf};
use crate::task::{Controller, ControllerId, Terminal, always};
use core::f64::consts::FRAC_PI_2;

/// `Pick(robot, box; pitch, yaw)`: grasps the box.
pub const PICK: ControllerId = ControllerId(0);
/// `Place(robot, box, shelf; x, y)`: places the box in the shelf.
pub const PLACE: ControllerId = ControllerId(1);

pub(super) static CONTROLLERS: [Controller<Shelf>; 2] = [
    Controller {
        name: "Pick",
        arguments: &[ROBOT_TYPE, BOX_TYPE],
        parameters: &[[0.0, FRAC_PI_2], [-1.2, 1.2]],
        initiable: always,
        policy: |_, _, _, parameters| match *parameters {
            [pitch, yaw] => Action::Pick { pitch, yaw },
            _ => Action::Rest,
        },
        terminal: Terminal::FirstAction,
    },
    Controller {
        name: "Place",
        arguments: &[ROBOT_TYPE, BOX_TYPE, SHELF_TYPE],
        parameters: &[[0.0, 0.3], [-0.3, 0.3]],
        initiable: always,
        policy: |_, _, _, parameters| match *parameters {
            [x, y] => Action::Place { x, y },
            _ => Action::Rest,
        },
        terminal: Terminal::FirstAction,
    },
];
