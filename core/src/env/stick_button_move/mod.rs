//! The stick-button environment with motions of their own: to move above a button and to
//! press it are two operators, by hand and with the stick.
//!
//! Table, stick and holder are those of [`stick_button`](super::stick_button), but for a
//! table that is only 6 wide, angles that never change, and a command to pick or place that
//! is another one than to press. Motions end as soon as they can, which makes a difference:
//! the stick stops where any of it lies over the button, and then its tip may not.
//!
//! # In closed form
//!
//! A motion changes both coordinates by at most half a unit in each step. A step that would
//! take the hand out of its zone is not taken, and ends it in vain.
//!
//! - To pick at `mu` works if the hand stays in its zone at the grasp, y + 3 mu <= 2.9, and
//!   clear of the holder there.
//! - The hand moves above a button if that is in the zone. To press it then works if the
//!   button is met by the rectangle of a *stick* with its corner at the robot, an oddity of
//!   the framework: not if the hand stopped above the button, or too far beside it.
//! - The stick moves above a button if the hand stays in its zone until the stick meets it,
//!   and can press it then if that is the tip: so if the button is higher than the tip, or
//!   the way to it is longer along x than down.
//!
//! # Source
//!
//! The environment `stick_button_move` of the Predicators framework, within 1e-9, as sine
//! and cosine may differ in their last digit, and with single precision where it has it; only
//! the task generator's stream of random numbers differs.
//!
//! ```
//! use critreg::task::{Environment, try_operator};
//! use critreg::env::stick_button_move::{ROBOT_TYPE, STICK_TYPE, StickButtonMove};
//! use critreg::random::generator;
//!
//! let environment = StickButtonMove;
//! let start = environment.task(1..=1, &mut generator(7))?.initial;
//! let pick = StickButtonMove::OPERATORS.iter().find(|o| o.name == "PickStickFromNothing");
//! let objects = [ROBOT_TYPE, STICK_TYPE].map(|kind| start.of_type(kind).next().unwrap());
//! let outcome = try_operator(&environment, pick.unwrap(), &objects, &[0.95], &start);
//! assert!(!outcome.is_feasible(), "the end of the stick is out of reach");
//! # Ok::<(), critreg::Error>(())
//! ```

mod controllers;
mod operators;
mod predicates;
mod simulate;
mod skills;
mod tasks;
mod world;

pub use controllers::{
    PICK_STICK, PLACE_STICK, ROBOT_MOVE_TO_BUTTON, ROBOT_PRESS_BUTTON, STICK_MOVE_TO_BUTTON,
    STICK_PRESS_BUTTON,
};
pub use predicates::{
    ABOVE_NO_BUTTON, GRASPED, HAND_EMPTY, PRESSED, ROBOT_ABOVE_BUTTON, STICK_ABOVE_BUTTON,
};
pub use world::{Robot, Stick, World};

use crate::domain::{Attribute, Dimension};
use crate::env::float32;
use crate::task::{
    Controller, Environment, Failure, Naming, ObjectId, ObjectType, Operator, OperatorId,
    Parameters, Predicate, State, TypeId,
};
use rand_core::Rng;

/// Size of the table along x; all other sizes are those of
/// [`stick_button`](super::stick_button).
pub const TABLE_WIDTH: f64 = 6.0;

/// Type of the buttons.
pub const BUTTON_TYPE: TypeId = TypeId(0);
/// Type of the holder.
pub const HOLDER_TYPE: TypeId = TypeId(1);
/// Type of the robot.
pub const ROBOT_TYPE: TypeId = TypeId(2);
/// Type of the stick.
pub const STICK_TYPE: TypeId = TypeId(3);

/// A command for one step: speed along x and along y, turning speed, which does nothing,
/// press, and pick or place, each in `[-1, 1]`; the last two do something if above zero.
pub type Action = [f32; 5];

/// The environment. See the [module](self).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StickButtonMove;

impl Environment for StickButtonMove {
    type Action = Action;

    const MAX_CONTROLLER_STEPS: u32 = 1000;

    const TYPES: &'static [ObjectType] = &TYPES;
    const PREDICATES: &'static [Predicate<Self>] = &predicates::PREDICATES;
    const CONTROLLERS: &'static [Controller<Self>] = &controllers::CONTROLLERS;
    const OPERATORS: &'static [Operator<'static>] = &operators::OPERATORS;

    fn simulate(&self, state: &mut State, action: Action) -> Result<(), Failure> {
        simulate::simulate(state.values_mut(), action).ok_or(Failure::default())
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
        name: "button",
        attributes: &[X, Y, Attribute::new("pressed", Dimension::Flag)],
        naming: Naming::Numbered("button"),
    },
    ObjectType {
        name: "holder",
        attributes: &[X, Y, THETA],
        naming: Naming::Single("holder"),
    },
    ObjectType {
        name: "robot",
        attributes: &[X, Y, THETA, Attribute::new("fingers", Dimension::None)],
        naming: Naming::Single("robby"),
    },
    ObjectType {
        name: "stick",
        attributes: &[
            X,
            Y,
            Attribute::new("tip_x", Dimension::Length),
            Attribute::new("tip_y", Dimension::Length),
            THETA,
            Attribute::new("held", Dimension::Flag),
        ],
        naming: Naming::Single("stick"),
    },
];
