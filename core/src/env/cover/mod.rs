//! The cover environments: blocks on a line, to be put over targets.
//!
//! Two blocks and two targets lie on the table, a line from zero to one. All that a
//! robot can do is click at a point of it: with an empty hand it picks the block
//! there, at the very point, and with a block in its hand it puts this down such
//! that the point of the grasp comes to lie there. Where a block was grasped decides
//! where it can be put, for the hand does not reach all points, and which it does
//! is what makes the family:
//!
//! | environment | an empty hand reaches | a hand with a block reaches | operators beyond pick and place |
//! |---|---|---|---|
//! | [`Cover`] | the blocks, and of each target the fifth about its centre | the same, but puts down over a target only | |
//! | [`CoverRegrasp`] | what is far from all targets, and of each target the middle third | the same | put on the table, to grasp again |
//! | [`RegionalBumpyCover`] | the targets and the blocks, but not the middle third of a bumpy block in the bumpy region | everything | put into the bumpy region; pick from it and from a target |
//!
//! The dynamics, predicates and operators are those of the Predicators framework's
//! environments of these names to the last bit, edge cases included; samplers and task
//! generators draw from the same distributions, with another stream of random numbers.
//! All numbers are double precision except for clicks, which are rounded to single
//! precision.
//!
//! # A state
//!
//! The objects are `block0`, `block1`, `robby`, `target0` and `target1`, in this
//! order ([`BLOCKS`], [`ROBOT`], [`TARGETS`]). A block has a width, a pose, which is
//! that of its centre, and a grasp: how far right of the pose it is held, or
//! [`NOT_HELD`]. While it is held its pose stays what it was, and it is moved when
//! it is put down. The robot has the pose of its hand on the line, and two numbers
//! that never change. All lengths are in parts of the table.
//!
//! # Which clicks work
//!
//! `p` is the click, `g` the grasp, `q = p - g` where the centre of the held block
//! comes to lie, `w` a width; a block or target stands for its pose.
//!
//! - Pick `b`: the hand reaches `p`, and `|p - b| <= w_b / 2`.
//! - Put `b`: the hand reaches `p`, and for all other blocks `o`
//!   `|p - o| > w_o / 2` and `|q - o| > (w_b + w_o) / 2`.
//! - It covers the target `t` if also `|q - t| <= (w_b - w_t) / 2`.
//!
//! With the reach of the hand these make what is to be learned: in [`Cover`] a pick
//! at `g` can be followed by a place only if `|g| <= (w_b - w_t) / 2 + w_t / 10`,
//! unless some block lends its reach; in [`CoverRegrasp`] there is also an outer
//! branch, in which the hand is beyond the target; and in [`RegionalBumpyCover`] a
//! block beside the target may leave room for a place off its centre only.
//!
//! # Operators and controllers
//!
//! The framework has one option without objects for all operators of [`Cover`] and
//! [`CoverRegrasp`]. Here every operator has a controller of its own, of the same
//! name and with the operator's objects, because what is learned is about them. All
//! of them click once, at their parameter. A click that does nothing is an action
//! nonetheless.
//!
//! ```
//! use critreg::task::{Environment, try_operator};
//! use critreg::env::cover::{BLOCKS, RegionalBumpyCover};
//! use critreg::random::generator;
//!
//! let environment = RegionalBumpyCover;
//! let task = environment.task(0, &mut generator(7))?;
//! let pick = RegionalBumpyCover::OPERATORS.iter().find(|o| o.name == "PickFromSmooth").unwrap();
//! let [_, block] = BLOCKS;
//! let [_, _, _, pose, ..] = *task.initial.attributes(block).unwrap() else { panic!() };
//! let try_at = |click| try_operator(&environment, pick, &[block], &[click], &task.initial);
//! assert!(try_at(pose).is_feasible());
//! assert!(!try_at(pose + 0.04).is_feasible(), "half the width is 0.035");
//! # Ok::<(), critreg::Error>(())
//! ```

mod bumpy;
mod controllers;
mod family;
mod plain;
mod predicates;
mod regrasp;
mod skills;
mod tasks;
mod world;

pub use bumpy::{BUMPY_REGION, RegionalBumpyCover};
pub use family::Family;
pub use plain::Cover;
pub use regrasp::CoverRegrasp;
pub use world::{Block, Target, blocks, targets};

use crate::domain::{Attribute, Dimension};
use crate::task::{Naming, ObjectId, ObjectType, TypeId};

/// Widths of the blocks.
pub const BLOCK_WIDTHS: [f64; 2] = [0.1, 0.07];
/// Widths of the targets.
pub const TARGET_WIDTHS: [f64; 2] = [0.05, 0.03];
/// The grasp of a block that is not held, exactly.
pub const NOT_HELD: f64 = -1.0;

/// Type of the blocks.
pub const BLOCK_TYPE: TypeId = TypeId(0);
/// Type of the robot.
pub const ROBOT_TYPE: TypeId = TypeId(1);
/// Type of the targets.
pub const TARGET_TYPE: TypeId = TypeId(2);

/// The blocks, in every state.
pub const BLOCKS: [ObjectId; 2] = [ObjectId(0), ObjectId(1)];
/// The robot, in every state.
pub const ROBOT: ObjectId = ObjectId(2);
/// The targets, in every state.
pub const TARGETS: [ObjectId; 2] = [ObjectId(3), ObjectId(4)];

/// Where to click.
pub type Action = f32;

const IS_BLOCK: Attribute<'static> = Attribute::new("is_block", Dimension::Flag);
const IS_TARGET: Attribute<'static> = Attribute::new("is_target", Dimension::Flag);
const WIDTH: Attribute<'static> = Attribute::new("width", Dimension::Length);
const POSE: Attribute<'static> = Attribute::new("pose", Dimension::Length);
const GRASP: Attribute<'static> = Attribute::new("grasp", Dimension::Length);
const HAND: Attribute<'static> = Attribute::new("hand", Dimension::Length);
const POSE_X: Attribute<'static> = Attribute::new("pose_x", Dimension::Length);
const POSE_Z: Attribute<'static> = Attribute::new("pose_z", Dimension::Length);
const BUMPY: Attribute<'static> = Attribute::new("bumpy", Dimension::None);

/// The types, with these attributes of the blocks.
const fn types(block: &'static [Attribute<'static>]) -> [ObjectType; 3] {
    [
        ObjectType {
            name: "block",
            attributes: block,
            naming: Naming::Numbered("block"),
        },
        ObjectType {
            name: "robot",
            attributes: &[HAND, POSE_X, POSE_Z],
            naming: Naming::Single("robby"),
        },
        ObjectType {
            name: "target",
            attributes: &[IS_BLOCK, IS_TARGET, WIDTH, POSE],
            naming: Naming::Numbered("target"),
        },
    ]
}

static TYPES: [ObjectType; 3] = types(&[IS_BLOCK, IS_TARGET, WIDTH, POSE, GRASP]);
static TYPES_WITH_BUMPS: [ObjectType; 3] = types(&[IS_BLOCK, IS_TARGET, WIDTH, POSE, GRASP, BUMPY]);
