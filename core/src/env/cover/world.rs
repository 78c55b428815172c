//! What lies on the table, and what a click does to it.

use super::{BLOCK_TYPE, NOT_HELD, ROBOT_TYPE, TARGET_TYPE};
use crate::real::Real;
use crate::task::{Failure, ObjectId, State};
use core::ops::RangeInclusive;

/// A block of a state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block {
    /// The object.
    pub object: ObjectId,
    /// Its width.
    pub width: f64,
    /// Where its centre is, or was before it was picked.
    pub pose: f64,
    /// How far right of the pose it is held, or [`NOT_HELD`].
    pub grasp: f64,
}

/// A target of a state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Target {
    /// The object.
    pub object: ObjectId,
    /// Its width.
    pub width: f64,
    /// Where its centre is.
    pub pose: f64,
}

impl Block {
    /// Reads a block; `None` if the object is none.
    pub fn read(state: &State, object: ObjectId) -> Option<Self> {
        let [_, _, width, pose, grasp, ..] = *state.attributes(object)? else {
            return None;
        };
        Some(Block {
            object,
            width,
            pose,
            grasp,
        })
    }

    /// Whether the robot holds it.
    pub fn is_held(&self) -> bool {
        self.grasp != NOT_HELD
    }

    /// From its left to its right end.
    pub fn extent(&self) -> RangeInclusive<f64> {
        around(self.pose, self.width / 2.0)
    }

    /// Whether it lies over all of the target.
    pub fn covers(&self, target: &Target) -> bool {
        let (own, other) = (self.extent(), target.extent());
        own.start() <= other.start() && own.end() >= other.end() && !self.is_held()
    }
}

impl Target {
    /// Reads a target; `None` if the object is none.
    pub fn read(state: &State, object: ObjectId) -> Option<Self> {
        let &[_, _, width, pose] = state.get(object)?;
        Some(Target {
            object,
            width,
            pose,
        })
    }

    /// From its left to its right end.
    pub fn extent(&self) -> RangeInclusive<f64> {
        around(self.pose, self.width / 2.0)
    }
}

/// The blocks of a state.
pub fn blocks(state: &State) -> impl Iterator<Item = Block> {
    let objects = state.of_type(BLOCK_TYPE);
    objects.filter_map(|object| Block::read(state, object))
}

/// The targets of a state.
pub fn targets(state: &State) -> impl Iterator<Item = Target> {
    let objects = state.of_type(TARGET_TYPE);
    objects.filter_map(|object| Target::read(state, object))
}

/// All that is not farther away than `reach`.
pub(super) fn around(pose: f64, reach: f64) -> RangeInclusive<f64> {
    pose - reach..=pose + reach
}

/// What the environments differ in when the robot clicks.
pub(super) struct Rules {
    /// Whether the hand reaches a point.
    pub(super) reaches: fn(&State, f64) -> bool,
    /// Whether a block can be put down by a click at a point, if it meets no other.
    pub(super) supports: fn(&State, f64) -> bool,
}

impl Rules {
    /// The transition: picks the block at a point, or puts the held one down there. A
    /// click does nothing if it is out of reach, if the empty hand has no block below
    /// it, or if the held block cannot be put down there.
    ///
    /// # Errors
    /// [`Failure`] if two blocks lie at the point, which never happens, or there is no
    /// robot.
    pub(super) fn click(&self, state: &mut State, click: f64) -> Result<(), Failure> {
        if !(self.reaches)(state, click) {
            return Ok(());
        }
        if let Some(block) = self.moved(state, click)? {
            write(state, &block, click).ok_or(Failure::default())?;
        }
        Ok(())
    }

    /// The block that a click within reach picks or puts down, as it is afterwards.
    fn moved(&self, state: &State, click: f64) -> Result<Option<Block>, Failure> {
        let held = blocks(state).find(Block::is_held);
        let is_below = |block: &Block| !block.is_held() && block.extent().contains(&click);
        let mut below = blocks(state).filter(is_below);
        match (held, below.next(), below.next()) {
            (_, _, Some(_)) => Err(Failure::default()),
            (None, Some(block), _) => Ok(Some(Block {
                grasp: click - block.pose,
                ..block
            })),
            (Some(block), None, _) => Ok(self.put(state, block, click)),
            _ => Ok(None),
        }
    }

    /// The held block as it is when put down; `None` if it cannot be.
    fn put(&self, state: &State, held: Block, click: f64) -> Option<Block> {
        let pose = click - held.grasp;
        let meets = |other: Block| {
            let reach = (held.width + other.width) * 0.5;
            other.object != held.object && Real::abs(other.pose - pose) <= reach
        };
        let is_free = !blocks(state).any(meets) && (self.supports)(state, click);
        is_free.then_some(Block {
            pose,
            grasp: NOT_HELD,
            ..held
        })
    }
}

fn write(state: &mut State, block: &Block, hand: f64) -> Option<()> {
    let robot = state.of_type(ROBOT_TYPE).next()?;
    *state.attributes_mut(robot)?.first_mut()? = hand;
    let [_, _, _, pose, grasp, ..] = state.attributes_mut(block.object)? else {
        return None;
    };
    (*pose, *grasp) = (block.pose, block.grasp);
    Some(())
}
