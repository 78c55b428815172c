//! The stick-button environment (thesis 6.1).
//!
//! A disc-shaped robot moves on a table, of which it can reach only the lower
//! part. Buttons lie anywhere; it presses them by hand or with the tip of a
//! stick, which it first has to pick, at a place along the stick of its choice
//! and clear of the holder that the stick lies on. Where it grasps the stick
//! decides whether the pick works, and which buttons the tip reaches later.
//!
//! The dynamics, predicates, controllers and operators are those of the
//! Predicators framework to the last digit, edge cases included; only the task
//! generator's stream of random numbers differs.
//!
//! ```
//! use critreg::task::{Environment, try_operator};
//! use critreg::env::stick_button::{StickButton, ROBOT, STICK};
//! use critreg::random::generator;
//!
//! let environment = StickButton { angles: false };
//! let task = environment.task(1..=1, &mut generator(7))?;
//! let pick = StickButton::OPERATORS.iter().find(|o| o.name == "PickStickFromNothing").unwrap();
//! let outcome = try_operator(&environment, pick, &[ROBOT, STICK], &[0.95], &task.initial);
//! assert!(!outcome.is_feasible(), "the end of the stick is out of reach");
//! # Ok::<(), critreg::Error>(())
//! ```

pub(in crate::env) mod controllers;
mod operators;
mod pick;
mod predicates;
mod press;
pub(in crate::env) mod simulate;
mod skills;
pub(in crate::env) mod tasks;
pub(in crate::env) mod world;

pub use controllers::{PICK_STICK, PLACE_STICK, ROBOT_PRESS_BUTTON, STICK_PRESS_BUTTON};
pub use pick::PICK_STICK_FROM_NOTHING;
pub use predicates::{
    ABOVE_NO_BUTTON, GRASPED, HAND_EMPTY, PRESSED, ROBOT_ABOVE_BUTTON, STICK_ABOVE_BUTTON,
};
pub use press::STICK_PRESS_BUTTON_FROM_NOTHING;
pub use tasks::{Arrangement, MAX_BUTTONS};
pub use world::World;

use crate::domain::{Attribute, Dimension};
use crate::env::float32;
use crate::task::{
    Controller, Environment, Failure, Naming, ObjectId, ObjectType, Operator, OperatorId,
    Parameters, Predicate, State, TypeId,
};
use rand_core::Rng;

/// Size of the table along x; positions start at zero.
pub const TABLE_WIDTH: f64 = 10.0;
/// Size of the table along y.
pub const TABLE_HEIGHT: f64 = 6.0;
/// Size along y of the reachable zone, in which the whole robot stays; it begins
/// at zero and is as wide as the table.
pub const ZONE_HEIGHT: f64 = 3.0;
/// Radius of the robot.
pub const ROBOT_RADIUS: f64 = 0.1;
/// Radius of a button.
pub const BUTTON_RADIUS: f64 = 0.1;
/// Width of the stick: its long side.
pub const STICK_WIDTH: f64 = 3.0;
/// Height of the stick.
pub const STICK_HEIGHT: f64 = 0.05;
/// Width of the tip: the end of the stick that presses buttons.
pub const TIP_WIDTH: f64 = 0.05;
/// Width of the holder.
pub const HOLDER_WIDTH: f64 = 0.1 * STICK_WIDTH;
/// Height of the holder.
pub const HOLDER_HEIGHT: f64 = 2.5 * STICK_HEIGHT;
/// How far the robot moves at most in one step, per axis.
pub const MAX_SPEED: f64 = 0.5;
/// How far the robot turns at most in one step, in radians.
pub const MAX_ANGULAR_SPEED: f64 = core::f64::consts::FRAC_PI_4;
/// The squared distance to its target at which a controller picks or places.
pub const TARGET_TOLERANCE: f64 = 1e-3;
/// The angle of everything while angles are off.
pub const UPRIGHT: f64 = core::f64::consts::FRAC_PI_2;

/// Type of the robot.
pub const ROBOT_TYPE: TypeId = TypeId(0);
/// Type of the stick.
pub const STICK_TYPE: TypeId = TypeId(1);
/// Type of the holder.
pub const HOLDER_TYPE: TypeId = TypeId(2);
/// Type of the buttons.
pub const BUTTON_TYPE: TypeId = TypeId(3);

/// The robot, in every state.
pub const ROBOT: ObjectId = ObjectId(0);
/// The stick, in every state.
pub const STICK: ObjectId = ObjectId(1);
/// The holder, in every state.
pub const HOLDER: ObjectId = ObjectId(2);
/// The first button; the others follow.
pub const FIRST_BUTTON: ObjectId = ObjectId(3);

/// A command for one step: speed along x, along y, turning speed, and press, each
/// in `[-1, 1]`; it presses if above zero.
pub type Action = [f32; 4];

/// The environment. See the [module](self).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StickButton {
    /// Whether robot and stick can turn, and lie at any angle in new tasks. If
    /// not (as in the thesis), all angles are [`UPRIGHT`].
    pub angles: bool,
}

impl Environment for StickButton {
    type Action = Action;

    const TYPES: &'static [ObjectType] = &TYPES;
    const PREDICATES: &'static [Predicate<Self>] = &predicates::PREDICATES;
    const CONTROLLERS: &'static [Controller<Self>] = &controllers::CONTROLLERS;
    const OPERATORS: &'static [Operator<'static>] = &operators::OPERATORS;

    fn simulate(&self, state: &mut State, action: Action) -> Result<(), Failure> {
        simulate::simulate(self.angles, state.values_mut(), action).ok_or(Failure::default())
    }

    /// Uniform, in single precision.
    fn sample<G: Rng>(
        &self,
        operator: OperatorId,
        _: &State,
        _: &[ObjectId],
        rng: &mut G,
    ) -> Parameters {
        float32::sample_uniform::<Self>(operator, rng)
    }
}

const X: Attribute<'static> = Attribute::new("x", Dimension::Length);
const Y: Attribute<'static> = Attribute::new("y", Dimension::Length);
const THETA: Attribute<'static> = Attribute::new("theta", Dimension::Angle);

static TYPES: [ObjectType; 4] = [
    ObjectType {
        name: "robot",
        attributes: &[X, Y, THETA],
        naming: Naming::Single("robby"),
    },
    ObjectType {
        name: "stick",
        attributes: &[X, Y, THETA, Attribute::new("held", Dimension::Flag)],
        naming: Naming::Single("stick"),
    },
    ObjectType {
        name: "holder",
        attributes: &[X, Y, THETA],
        naming: Naming::Single("holder"),
    },
    ObjectType {
        name: "button",
        attributes: &[X, Y, Attribute::new("pressed", Dimension::Flag)],
        naming: Naming::Numbered("button"),
    },
];
