//! A state read as what lies where.

use super::{BLOCK_SIZE, BLOCK_TYPE, Blocks, ON_TOLERANCE, ROBOT_TYPE, SPACING, TABLE_HEIGHT};
use crate::error::Error;
use crate::real::Real;
use crate::task::{Environment, ObjectId, State};

/// What describes a block: x, y and z of its centre, held, and its colour's red, green
/// and blue.
pub type Block = [f64; 7];

/// What lies where: the numbers of a state by object.
///
/// The objects of every state are the blocks and then the robot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct World<'a> {
    /// The blocks.
    pub blocks: &'a [Block],
    /// The robot's x, y, z, which never change, and fingers: 1 if open, 0 if closed.
    pub robot: &'a [f64; 4],
}

impl<'a> World<'a> {
    /// Reads a state; `None` if it does not belong to this environment.
    pub fn of(state: &'a State) -> Option<Self> {
        let (blocks, robot) = state.values().split_last_chunk()?;
        let (blocks, []) = blocks.as_chunks() else {
            return None;
        };
        Some(World { blocks, robot })
    }

    /// The state with these numbers.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] with more blocks than a state can hold.
    pub fn to_state(&self) -> Result<State, Error> {
        let types = Blocks::TYPES;
        let mut state = State::new();
        for block in self.blocks {
            state.add(types, BLOCK_TYPE, block)?;
        }
        state.add(types, ROBOT_TYPE, self.robot)?;
        Ok(state)
    }

    /// The blocks with what they are called in the state.
    pub(super) fn named_blocks(&self) -> impl Iterator<Item = (ObjectId, &'a Block)> {
        (0..).map(ObjectId).zip(self.blocks)
    }

    /// Whether the gripper is open; `None` if it is neither open nor closed.
    pub(super) fn is_open(&self) -> Option<bool> {
        let [_, _, _, fingers] = *self.robot;
        (fingers == 0.0 || fingers == 1.0).then_some(fingers == 1.0)
    }

    /// The block that is held.
    pub(super) fn held(&self) -> Option<(ObjectId, &'a Block)> {
        self.named_blocks().find(|(_, block)| is_held(block))
    }

    /// Whether a block is not held and no block lies on it.
    pub(super) fn is_clear(&self, id: ObjectId, block: &Block) -> bool {
        let holding = self.held().is_some_and(|(held, _)| held == id);
        !holding && !self.blocks.iter().any(|other| is_on(other, block))
    }
}

/// A block's centre.
pub(super) fn centre(&[x, y, z, ..]: &Block) -> [f64; 3] {
    [x, y, z]
}

/// Whether the upper block lies on the lower one.
pub(super) fn is_on(upper: &Block, lower: &Block) -> bool {
    let [x, y, z] = centre(lower);
    let exact = [x, y, z + BLOCK_SIZE];
    !is_held(upper) && !is_held(lower) && are_close(centre(upper), exact, ON_TOLERANCE)
}

/// Whether a block lies on the table.
pub(super) fn is_on_table(block: &Block) -> bool {
    let exact = TABLE_HEIGHT + BLOCK_SIZE * 0.5;
    let [_, _, z] = centre(block);
    !is_held(block) && exact - ON_TOLERANCE < z && z < exact + ON_TOLERANCE
}

/// Whether a block may be put on the table there: it keeps its distance from all others
/// along x, or from all others along y.
pub(super) fn is_free([x, y]: [f64; 2], others: impl Iterator<Item = [f64; 2]> + Clone) -> bool {
    let apart = |a, b| Real::abs(a - b) > SPACING;
    others.clone().all(|[other, _]| apart(x, other))
        || others.clone().all(|[_, other]| apart(y, other))
}

fn is_held([_, _, _, held, ..]: &Block) -> bool {
    *held >= 0.5
}

/// Whether two places agree along every axis: up to the tolerance, and a little more
/// the farther `b` is from the origin, as NumPy compares.
pub(super) fn are_close<const N: usize>(a: [f64; N], b: [f64; N], tolerance: f64) -> bool {
    let close = |(a, b)| Real::abs(a - b) <= tolerance + 1e-5 * Real::abs(b);
    a.into_iter().zip(b).all(close)
}
