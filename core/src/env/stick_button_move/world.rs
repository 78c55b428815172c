//! A state read as what lies on the table.

use super::{BUTTON_TYPE, HOLDER_TYPE, ROBOT_TYPE, STICK_TYPE, StickButtonMove};
use crate::env::stick_button::world::{self as table, is_set};
use crate::error::Error;
use crate::geometry::{Circle, Rectangle};
use crate::task::{Environment, State};

/// What describes the robot: x, y, theta, and fingers, which are closed up to one half.
pub type Robot = [f64; 4];
/// What describes the stick: x and y of its corner and of its tip, theta, and held.
pub type Stick = [f64; 6];

/// What lies on the table: the numbers of a state by object.
///
/// The objects of every state are the buttons, the holder, the robot and the stick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct World<'a> {
    /// Each button's x, y and pressed.
    pub buttons: &'a [[f64; 3]],
    /// The holder's x, y and theta.
    pub holder: &'a [f64; 3],
    /// The robot's x, y, theta and fingers.
    pub robot: &'a Robot,
    /// The stick's x, y, tip_x, tip_y, theta and held.
    pub stick: &'a Stick,
}

impl<'a> World<'a> {
    /// Reads a state; `None` if it does not belong to this environment.
    pub fn of(state: &'a State) -> Option<Self> {
        let (rest, stick) = state.values().split_last_chunk()?;
        let (rest, robot) = rest.split_last_chunk()?;
        let (rest, holder) = rest.split_last_chunk()?;
        let (buttons, []) = rest.as_chunks() else {
            return None;
        };
        Some(World {
            buttons,
            holder,
            robot,
            stick,
        })
    }

    /// The state with these numbers.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] with more buttons than a state can hold.
    pub fn to_state(&self) -> Result<State, Error> {
        let types = StickButtonMove::TYPES;
        let mut state = State::new();
        for button in self.buttons {
            state.add(types, BUTTON_TYPE, button)?;
        }
        state.add(types, HOLDER_TYPE, self.holder)?;
        state.add(types, ROBOT_TYPE, self.robot)?;
        state.add(types, STICK_TYPE, self.stick)?;
        Ok(state)
    }

    /// Whether the fingers are open.
    pub(super) fn is_open(&self) -> bool {
        let [_, _, _, fingers] = *self.robot;
        is_set(fingers)
    }

    /// Whether the robot holds the stick.
    pub(super) fn is_grasped(&self) -> bool {
        let [_, _, _, _, _, held] = *self.stick;
        is_set(held) && !self.is_open()
    }
}

/// The same, to change.
pub(super) struct WorldMut<'a> {
    pub(super) buttons: &'a mut [[f64; 3]],
    pub(super) holder: &'a [f64; 3],
    pub(super) robot: &'a mut Robot,
    pub(super) stick: &'a mut Stick,
}

impl<'a> WorldMut<'a> {
    pub(super) fn of(values: &'a mut [f64]) -> Option<Self> {
        let (rest, stick) = values.split_last_chunk_mut()?;
        let (rest, robot) = rest.split_last_chunk_mut()?;
        let (rest, holder) = rest.split_last_chunk_mut()?;
        let (buttons, []) = rest.as_chunks_mut() else {
            return None;
        };
        Some(WorldMut {
            buttons,
            holder,
            robot,
            stick,
        })
    }
}

/// The robot's disc.
pub(super) fn robot_shape(&[x, y, theta, _]: &Robot) -> Circle<f64> {
    table::robot_shape(&[x, y, theta])
}

/// The stick's rectangle.
pub(super) fn stick_shape(&[x, y, _, _, theta, held]: &Stick) -> Rectangle<f64> {
    table::stick_shape(&[x, y, theta, held])
}
