//! Where the features of each complexity and dimension are in the table.

use super::features::feature_id;
use crate::domain::Dimension;
use core::ops::Range;

const DIMENSIONS: usize = Dimension::ALL.len();

/// Features of one complexity and dimension, which stand together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Block {
    start: u16,
    pub(super) kept: u16,
    /// How many features the grammar has, with those that found no room.
    pub(super) enumerated: u32,
}

impl Block {
    /// An empty block behind this many features.
    pub(super) fn behind(features: usize) -> Block {
        Block {
            start: feature_id(features).0,
            ..Block::default()
        }
    }

    pub(super) fn range(&self) -> Range<usize> {
        let start = usize::from(self.start);
        start..start + usize::from(self.kept)
    }
}

/// Blocks of each complexity, from 1, and dimension.
pub(super) type Blocks<const COMPLEXITIES: usize> = [[Block; DIMENSIONS]; COMPLEXITIES];

pub(super) fn block_at(
    blocks: &[[Block; DIMENSIONS]],
    complexity: usize,
    dimension: Dimension,
) -> Block {
    let row = complexity.checked_sub(1).and_then(|c| blocks.get(c));
    let block = row.and_then(|row| row.get(dimension as usize));
    block.copied().unwrap_or_default()
}

pub(super) fn set_block(
    blocks: &mut [[Block; DIMENSIONS]],
    complexity: usize,
    dimension: Dimension,
    block: Block,
) {
    let row = complexity.checked_sub(1).and_then(|c| blocks.get_mut(c));
    if let Some(slot) = row.and_then(|row| row.get_mut(dimension as usize)) {
        *slot = block;
    }
}
