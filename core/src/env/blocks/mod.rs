//! The blocks environment: to build towers in a narrow strip.
//!
//! Blocks, cubes of one size, lie on a table or on one another; lengths are metres,
//! and z points upwards. The robot picks a block that nothing lies on, and lifts it
//! straight up; it puts a held block on another one, or on the table, at a place of its
//! choice and at a distance from every block. The strip of the table within its
//! reach is narrower than this distance along x, so that only y decides; and a place
//! that is taken makes what is put there later harder to place.
//!
//! # In closed form
//!
//! With block b held, put on the table with the parameters (u, v), and y = 0.4 + 0.7 v in
//! single precision, it works if |y - c.y| > 0.09 for every block c, b itself where it was
//! lifted included. To pick and to stack works whenever the preconditions hold.
//!
//! # Source
//!
//! The environment `blocks` of the Predicators framework, to the last digit and with
//! single precision where it has it; only the task generator's stream of random numbers
//! differs. Two controllers have more objects than there, though their commands do not
//! depend on them, because what is learned is about objects: `PutOnTable` and `Stack`
//! have the held block as their second one, as `Pick` has the block to be picked. A state
//! on which the framework stops with an assertion (a half-closed gripper, a closed one
//! that holds nothing) is a [`Failure`] without a culprit.
//!
//! ```
//! use critreg::task::{Environment, try_operator};
//! use critreg::env::blocks::{BLOCK_TYPE, Blocks, ROBOT_TYPE};
//! use critreg::random::generator;
//!
//! let environment = Blocks;
//! let start = environment.task(3..=4, &mut generator(1))?.initial;
//! let [pick, put, ..] = Blocks::OPERATORS else { unreachable!() };
//! // Nothing lies on the last block.
//! let objects = [start.of_type(BLOCK_TYPE).last(), start.of_type(ROBOT_TYPE).last()];
//! let objects = objects.map(Option::unwrap);
//! let picked = try_operator(&environment, pick, &objects, &[], &start).state;
//! let [_, y, ..] = *picked.get::<7>(objects[0]).unwrap();
//! let back = [0.5, (y - 0.4) / 0.7];
//! let outcome = try_operator(&environment, put, &objects, &back, &picked);
//! assert!(!outcome.is_feasible(), "the held block itself is in the way");
//! # Ok::<(), critreg::Error>(())
//! ```

mod controllers;
mod operators;
mod predicates;
mod simulate;
mod skills;
mod tasks;
mod world;

pub use controllers::{PICK, PUT_ON_TABLE, STACK};
pub use predicates::{CLEAR, GRIPPER_OPEN, HOLDING, ON, ON_TABLE};
pub use tasks::MAX_BLOCKS;
pub use world::{Block, World};

use crate::domain::{Attribute, Dimension};
use crate::env::float32;
use crate::task::{
    Controller, Environment, Failure, Naming, ObjectId, ObjectType, Operator, OperatorId,
    Parameters, Predicate, State, TypeId,
};
use rand_core::Rng;

/// Length of a block's edges.
pub const BLOCK_SIZE: f64 = 0.045;
/// Height of the table.
pub const TABLE_HEIGHT: f64 = 0.2;
/// The strip of the table that can be reached: lowest and highest x.
pub const REACH_X: [f64; 2] = [1.325, 1.375];
/// Its lowest and highest y.
pub const REACH_Y: [f64; 2] = [0.4, 1.1];
/// The height that a picked block is lifted to.
pub const LIFT_HEIGHT: f64 = 0.7;
/// Along one axis, a block is put on the table farther than this from all others.
pub const SPACING: f64 = 2.0 * BLOCK_SIZE;
/// How far a command to pick or stack may miss its block, per axis.
pub const PICK_TOLERANCE: f64 = 1e-4;
/// How far a block may be from where it would lie exactly, per axis.
pub const ON_TOLERANCE: f64 = 0.01;

/// Type of the blocks.
pub const BLOCK_TYPE: TypeId = TypeId(0);
/// Type of the robot.
pub const ROBOT_TYPE: TypeId = TypeId(1);

/// A command: x, y and z of a place, and the fingers there: closed below one half,
/// else open.
pub type Action = [f32; 4];

/// The environment. See the [module](self).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Blocks;

impl Environment for Blocks {
    type Action = Action;

    const TYPES: &'static [ObjectType] = &TYPES;
    const PREDICATES: &'static [Predicate<Self>] = &predicates::PREDICATES;
    const CONTROLLERS: &'static [Controller<Self>] = &controllers::CONTROLLERS;
    const OPERATORS: &'static [Operator<'static>] = &operators::OPERATORS;

    fn simulate(&self, state: &mut State, action: Action) -> Result<(), Failure> {
        simulate::simulate(state, action)
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
const Z: Attribute<'static> = Attribute::new("z", Dimension::Length);

static TYPES: [ObjectType; 2] = [
    ObjectType {
        name: "block",
        attributes: &[
            X,
            Y,
            Z,
            Attribute::new("held", Dimension::Flag),
            Attribute::new("red", Dimension::None),
            Attribute::new("green", Dimension::None),
            Attribute::new("blue", Dimension::None),
        ],
        naming: Naming::Numbered("block"),
    },
    ObjectType {
        name: "robot",
        attributes: &[X, Y, Z, Attribute::new("fingers", Dimension::Flag)],
        naming: Naming::Single("robby"),
    },
];
