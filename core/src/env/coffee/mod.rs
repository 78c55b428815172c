//! The coffee environment: to make coffee and pour it into cups.
//!
//! A robot hand moves in a room, a cube of 10 by 10 by 10. It turns a jug by its top, takes
//! it by its handle, puts it into a coffee machine, presses the button of the machine, takes
//! the jug again and tilts it above the cups until each holds enough. The handle can be
//! taken only if it points towards the robot, so a jug that is turned away has to be
//! turned first; that turn is the only choice that there is.
//!
//! # In closed form
//!
//! With r the jug's rotation, taking it from the table works if |r| < pi/3. Turning it with
//! the parameter p turns towards 2 pi/3 p, in steps of at most pi/4 of the wrist, until less
//! than 0.1 is left; it works unless the wrist comes to its end, which takes a turn of more
//! than pi. So after a turn the jug can be taken if |p| < 1/2, but for what is left: what
//! remains behind whole steps, if it is less than 0.1.
//!
//! Nothing else can fail in the order that the operators allow, but for two things that
//! their preconditions do not see: a cup that is full cannot be filled again, and right after
//! pouring the jug cannot be put into the machine, as nothing tilts it back.
//!
//! # Source
//!
//! The environment `coffee` of the Predicators framework, within 1e-9, as sine and cosine
//! may differ in their last digit, and with single precision where it has it; only the task
//! generator's stream of random numbers differs. The framework compares squared distances
//! with tolerances that are not squared, and so does this.
//!
//! ```
//! use critreg::task::{Environment, try_operator};
//! use critreg::env::coffee::{Coffee, JUG_TYPE, ROBOT_TYPE};
//! use critreg::random::generator;
//!
//! let environment = Coffee;
//! let start = environment.task(2..=3, &mut generator(1))?.initial;
//! let objects = [ROBOT_TYPE, JUG_TYPE].map(|kind| start.of_type(kind).next().unwrap());
//! let [_, jug] = objects;
//! let pick = Coffee::OPERATORS.iter().find(|o| o.name == "PickJugFromTable").unwrap();
//! for (rotation, works) in [(1.0, true), (1.1, false)] {
//!     let mut start = start.clone();
//!     start.attributes_mut(jug).unwrap()[2] = rotation;
//!     let outcome = try_operator(&environment, pick, &objects, &[], &start);
//!     assert_eq!(outcome.is_feasible(), works);
//! }
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
    MOVE_TO_TWIST_JUG, PICK_JUG, PLACE_JUG_IN_MACHINE, POUR, TURN_MACHINE_ON, TWIST_JUG,
};
pub use predicates::{
    CUP_FILLED, HAND_EMPTY, HOLDING, JUG_ABOVE_CUP, JUG_FILLED, JUG_IN_MACHINE, MACHINE_ON,
    NOT_ABOVE_CUP, NOT_SAME_CUP, ON_TABLE, PRESSING_BUTTON, ROBOT_ABOVE_CUP, TWISTING,
};
pub use tasks::MAX_CUPS;
pub use world::{Cup, Jug, Robot, World};

use crate::domain::{Attribute, Dimension};
use crate::env::float32;
use crate::task::{
    Controller, Environment, Failure, Naming, ObjectId, ObjectType, Operator, OperatorId,
    Parameters, Predicate, State, TypeId,
};
use core::f64::consts::{FRAC_PI_3, FRAC_PI_4, PI};
use rand_core::Rng;

/// The room is a cube of this size; positions start at zero.
pub const ROOM: f64 = 10.0;
/// How far the hand moves at most in one step.
pub const MAX_SPEED: f64 = 2.5;
/// How far the wrist turns and tilts at most in one step, in radians.
pub const MAX_ANGULAR_SPEED: f64 = FRAC_PI_4;
/// The tilt of the wrist at which the jug pours, which is the largest one.
pub const POURING_TILT: f64 = FRAC_PI_4;
/// The wrist turns from minus this to this.
pub const WRIST_LIMIT: f64 = PI;
/// How far the fingers are open when closed.
pub const CLOSED: f64 = 0.1;
/// How far they are open when open.
pub const OPEN: f64 = 0.4;
/// Where the button of the machine is.
pub const BUTTON: [f64; 3] = [9.0, 7.5, 3.0];
/// Where the jug stands to be filled.
pub const DISPENSER: [f64; 3] = [9.0, 7.5 - 1.1 * JUG_RADIUS, 0.0];
/// Radius of the jug.
pub const JUG_RADIUS: f64 = 0.4;
/// Height of the jug, at which it is turned.
pub const JUG_HEIGHT: f64 = 1.5;
/// How far the handle is from the middle of the jug.
pub const HANDLE_OFFSET: f64 = 1.05 * JUG_RADIUS;
/// How high the handle is above the bottom of the jug.
pub const HANDLE_HEIGHT: f64 = 0.75 * JUG_HEIGHT;
/// From the cup to where the jug pours into it.
pub const POUR_OFFSET: [f64; 3] = [1.5 * (0.6 + 1.0) * JUG_RADIUS, CUP_RADIUS, 2.0625];
/// Radius of a cup.
pub const CUP_RADIUS: f64 = 0.6 * JUG_RADIUS;
/// How much is poured in one step.
pub const POURED: f64 = 0.15;
/// The jug can be grasped if it is turned less than this.
pub const GRASP_LIMIT: f64 = FRAC_PI_3;
/// New jugs are turned at most so far, and so far they are turned at most.
pub const TURN_LIMIT: f64 = 2.0 * FRAC_PI_3;

/// Type of the coffee machine.
pub const MACHINE_TYPE: TypeId = TypeId(0);
/// Type of the cups.
pub const CUP_TYPE: TypeId = TypeId(1);
/// Type of the jug.
pub const JUG_TYPE: TypeId = TypeId(2);
/// Type of the robot.
pub const ROBOT_TYPE: TypeId = TypeId(3);

/// A command for one step: speed along x, y and z, tilting and turning speed of the
/// wrist, and speed of the fingers, each in `[-1, 1]`.
pub type Action = [f32; 6];

/// The environment. See the [module](self).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Coffee;

impl Environment for Coffee {
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

static TYPES: [ObjectType; 4] = [
    ObjectType {
        name: "machine",
        attributes: &[Attribute::new("on", Dimension::Flag)],
        naming: Naming::Single("coffee_machine"),
    },
    ObjectType {
        name: "cup",
        attributes: &[
            X,
            Y,
            Attribute::new("capacity", Dimension::None),
            Attribute::new("wanted", Dimension::None),
            Attribute::new("content", Dimension::None),
        ],
        naming: Naming::Numbered("cup"),
    },
    ObjectType {
        name: "jug",
        attributes: &[
            X,
            Y,
            Attribute::new("theta", Dimension::Angle),
            Attribute::new("held", Dimension::Flag),
            Attribute::new("filled", Dimension::Flag),
        ],
        naming: Naming::Single("juggy"),
    },
    ObjectType {
        name: "robot",
        attributes: &[
            X,
            Y,
            Attribute::new("z", Dimension::Length),
            Attribute::new("tilt", Dimension::Angle),
            Attribute::new("wrist", Dimension::Angle),
            Attribute::new("fingers", Dimension::Length),
        ],
        naming: Naming::Single("robby"),
    },
];
