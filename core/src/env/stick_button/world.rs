//! A state read as what lies on the table.

use super::{
    BUTTON_RADIUS, BUTTON_TYPE, HOLDER_HEIGHT, HOLDER_TYPE, HOLDER_WIDTH, ROBOT_RADIUS, ROBOT_TYPE,
    STICK_HEIGHT, STICK_TYPE, STICK_WIDTH, StickButton, TIP_WIDTH,
};
use crate::error::Error;
use crate::geometry::{Circle, Rectangle};
use crate::task::{Environment, State};

/// What lies on the table: the numbers of a state by object.
///
/// The objects of every state are the robot, the stick, the holder and then the
/// buttons.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct World<'a> {
    /// The robot's x, y and theta.
    pub robot: &'a [f64; 3],
    /// The stick's x, y, theta and held.
    pub stick: &'a [f64; 4],
    /// The holder's x, y and theta.
    pub holder: &'a [f64; 3],
    /// Each button's x, y and pressed.
    pub buttons: &'a [[f64; 3]],
}

impl<'a> World<'a> {
    /// Reads a state; `None` if it does not belong to this environment.
    pub fn of(state: &'a State) -> Option<Self> {
        World::read(state.values())
    }

    /// Reads the numbers of a state; `None` if they are none.
    pub fn read(values: &'a [f64]) -> Option<Self> {
        let (robot, rest) = values.split_first_chunk()?;
        let (stick, rest) = rest.split_first_chunk()?;
        let (holder, rest) = rest.split_first_chunk()?;
        let (buttons, []) = rest.as_chunks() else {
            return None;
        };
        Some(World {
            robot,
            stick,
            holder,
            buttons,
        })
    }

    /// The state with these numbers.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] with more buttons than a state can hold.
    pub fn to_state(&self) -> Result<State, Error> {
        let mut state = State::new();
        self.add_to(&mut state)?;
        Ok(state)
    }

    /// Adds all objects to a state that has none.
    pub(super) fn add_to(&self, state: &mut State) -> Result<(), Error> {
        let types = StickButton::TYPES;
        state.add(types, ROBOT_TYPE, self.robot)?;
        state.add(types, STICK_TYPE, self.stick)?;
        state.add(types, HOLDER_TYPE, self.holder)?;
        for button in self.buttons {
            state.add(types, BUTTON_TYPE, button)?;
        }
        Ok(())
    }

    /// The numbers of its state, in their order.
    pub fn values(&self) -> impl Iterator<Item = f64> {
        let World {
            robot,
            stick,
            holder,
            buttons,
        } = *self;
        let fixed = robot.iter().chain(stick).chain(holder);
        fixed.chain(buttons.as_flattened()).copied()
    }
}

/// The same, to change.
pub(super) struct WorldMut<'a> {
    pub(super) robot: &'a mut [f64; 3],
    pub(super) stick: &'a mut [f64; 4],
    pub(super) holder: &'a [f64; 3],
    pub(super) buttons: &'a mut [[f64; 3]],
}

impl<'a> WorldMut<'a> {
    pub(super) fn of(values: &'a mut [f64]) -> Option<Self> {
        let (robot, rest) = values.split_first_chunk_mut()?;
        let (stick, rest) = rest.split_first_chunk_mut()?;
        let (holder, rest) = rest.split_first_chunk_mut()?;
        let (buttons, []) = rest.as_chunks_mut() else {
            return None;
        };
        Some(WorldMut {
            robot,
            stick,
            holder,
            buttons,
        })
    }
}

/// A flag attribute as a truth value.
pub(in crate::env) fn is_set(flag: f64) -> bool {
    flag > 0.5
}

/// The robot's disc.
pub(in crate::env) fn robot_shape(&[x, y, _]: &[f64; 3]) -> Circle<f64> {
    Circle {
        centre: [x, y],
        radius: ROBOT_RADIUS,
    }
}

/// A button's disc.
pub(in crate::env) fn button_shape(&[x, y, _]: &[f64; 3]) -> Circle<f64> {
    Circle {
        centre: [x, y],
        radius: BUTTON_RADIUS,
    }
}

/// The stick's rectangle.
pub(in crate::env) fn stick_shape(&[x, y, theta, _]: &[f64; 4]) -> Rectangle<f64> {
    Rectangle::new([x, y], [STICK_WIDTH, STICK_HEIGHT], theta)
}

/// The tip of a stick.
pub(in crate::env) fn tip_shape(stick: &Rectangle<f64>) -> Rectangle<f64> {
    Rectangle {
        frame: stick.frame.shifted([STICK_WIDTH - TIP_WIDTH, 0.0]),
        width: TIP_WIDTH,
        height: STICK_HEIGHT,
    }
}

/// The holder's rectangle.
pub(in crate::env) fn holder_shape(&[x, y, theta]: &[f64; 3]) -> Rectangle<f64> {
    Rectangle::new([x, y], [HOLDER_WIDTH, HOLDER_HEIGHT], theta)
}
