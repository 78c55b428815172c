//! A state read as what is where, and what follows from that alone.

use super::{
    BUTTON, CUP_TYPE, Coffee, DISPENSER, HANDLE_HEIGHT, HANDLE_OFFSET, JUG_HEIGHT, JUG_TYPE,
    MACHINE_TYPE, POUR_OFFSET, ROBOT_TYPE,
};
use crate::error::Error;
use crate::geometry::Frame2;
use crate::task::{Environment, State};

/// What describes a cup: x, y, capacity, how much is wanted and how much is in it.
pub type Cup = [f64; 5];
/// What describes the jug: x, y, theta, held and filled.
pub type Jug = [f64; 5];
/// What describes the robot: x, y and z of its hand, tilt and turn of its wrist, and how far
/// its fingers are open.
pub type Robot = [f64; 6];

/// Squared distances below these count as there; the framework does not square them.
const AT_BUTTON: f64 = 0.2;
const AT_DISPENSER: f64 = 1.0;
const ABOVE_CUP: f64 = 1.0;
/// Of the hand and a part of the jug.
pub(super) const AT_JUG: f64 = 0.5;

/// What is where: the numbers of a state by object.
///
/// The objects of every state are the machine, the cups, the jug and the robot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct World<'a> {
    /// Whether the machine is on.
    pub machine: &'a [f64; 1],
    /// The cups.
    pub cups: &'a [Cup],
    /// The jug.
    pub jug: &'a Jug,
    /// The robot.
    pub robot: &'a Robot,
}

impl<'a> World<'a> {
    /// Reads a state; `None` if it does not belong to this environment.
    pub fn of(state: &'a State) -> Option<Self> {
        World::read(state.values())
    }

    /// Reads the numbers of a state; `None` if they are none.
    pub(super) fn read(values: &'a [f64]) -> Option<Self> {
        let (machine, rest) = values.split_first_chunk()?;
        let (rest, robot) = rest.split_last_chunk()?;
        let (rest, jug) = rest.split_last_chunk()?;
        let (cups, []) = rest.as_chunks() else {
            return None;
        };
        Some(World {
            machine,
            cups,
            jug,
            robot,
        })
    }

    /// The state with these numbers.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] with more cups than a state can hold.
    pub fn to_state(&self) -> Result<State, Error> {
        let types = Coffee::TYPES;
        let mut state = State::new();
        state.add(types, MACHINE_TYPE, self.machine)?;
        for cup in self.cups {
            state.add(types, CUP_TYPE, cup)?;
        }
        state.add(types, JUG_TYPE, self.jug)?;
        state.add(types, ROBOT_TYPE, self.robot)?;
        Ok(state)
    }

    pub(super) fn is_machine_on(&self) -> bool {
        let [on] = *self.machine;
        is_set(on)
    }

    pub(super) fn is_jug_held(&self) -> bool {
        let [_, _, _, held, _] = *self.jug;
        is_set(held)
    }

    pub(super) fn is_jug_in_machine(&self) -> bool {
        let near = distance_squared(DISPENSER, self.jug_place()) < AT_DISPENSER;
        !self.is_jug_held() && near
    }

    /// The middle of the jug's bottom. While it is held it hangs from the hand.
    pub(super) fn jug_place(&self) -> [f64; 3] {
        let [x, y, ..] = *self.jug;
        let [_, _, hand] = hand(self.robot);
        let z = if self.is_jug_held() {
            hand - HANDLE_HEIGHT
        } else {
            0.0
        };
        [x, y, z]
    }

    /// Whether the hand is where it can turn the jug: nearer to its top than to its handle.
    pub(super) fn is_twisting(&self) -> bool {
        let from = |place| distance_squared(place, hand(self.robot));
        let (top, handle) = (from(top(self.jug)), from(handle(self.jug)));
        top <= handle && top < AT_JUG
    }

    pub(super) fn is_above(&self, cup: &Cup) -> bool {
        self.is_jug_held() && distance_squared(self.jug_place(), pour_place(cup)) < ABOVE_CUP
    }

    /// The cup that the held jug is above, by its place: the nearest one, of several the
    /// one with the first name.
    pub(super) fn cup_below(&self) -> Option<usize> {
        let distance = |cup| distance_squared(self.jug_place(), pour_place(cup));
        let cups = self.cups.iter().enumerate();
        let below = cups.filter(|(_, cup)| self.is_above(cup));
        let nearest = below.reduce(|best, next| {
            if distance(next.1) < distance(best.1) {
                next
            } else {
                best
            }
        });
        nearest.map(|(place, _)| place)
    }
}

/// A flag attribute as a truth value.
pub(super) fn is_set(flag: f64) -> bool {
    flag > 0.5
}

/// Where the robot's hand is.
pub(super) fn hand(&[x, y, z, ..]: &Robot) -> [f64; 3] {
    [x, y, z]
}

/// Whether the hand presses the button.
pub(super) fn is_pressing(robot: &Robot) -> bool {
    distance_squared(BUTTON, hand(robot)) < AT_BUTTON
}

/// Whether there is as much in a cup as is wanted.
pub(super) fn is_filled(&[_, _, _, target, current]: &Cup) -> bool {
    current > target
}

/// The handle of a jug that stands on the table: it points to the robot if that is not turned.
pub(super) fn handle(&[x, y, theta, ..]: &Jug) -> [f64; 3] {
    let [x, y] = Frame2::new([x, y], theta).apply([0.0, -HANDLE_OFFSET]);
    [x, y, HANDLE_HEIGHT]
}

/// The top of a jug that stands on the table, by which it is turned.
pub(super) fn top(&[x, y, ..]: &Jug) -> [f64; 3] {
    [x, y, JUG_HEIGHT]
}

/// Where the jug is to pour into a cup.
pub(super) fn pour_place(&[x, y, ..]: &Cup) -> [f64; 3] {
    let [along, across, up] = POUR_OFFSET;
    [x + along, y + across, up]
}

pub(super) fn distance_squared<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    let squares = a.into_iter().zip(b).map(|(a, b)| (a - b) * (a - b));
    squares.sum()
}
