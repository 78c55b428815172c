//! Where the forms are in their tables.

use super::{DIMENSIONS, LEVELS};
use crate::domain::Dimension;
use crate::real::Real;
use core::ops::Range;

/// Neighbours in a table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Block {
    pub(super) start: usize,
    pub(super) len: usize,
}

impl Block {
    pub(super) fn range(self) -> Range<usize> {
        self.start..self.start + self.len
    }
}

/// Forms of one left side and neighbouring right sides.
#[derive(Clone, Debug)]
pub(in crate::learn::version_space) struct Run {
    pub(in crate::learn::version_space) level: usize,
    pub(in crate::learn::version_space) left: usize,
    pub(in crate::learn::version_space) columns: Range<usize>,
    pub(in crate::learn::version_space) forms: Range<usize>,
}

impl Run {
    /// The forms before `form`, and the others.
    pub(super) fn split(self, form: usize) -> (Run, Run) {
        // Not `clamp`, which panics where a range has its ends the wrong way round.
        let tracked = form.max(self.forms.start).min(self.forms.end);
        let column = self.columns.start + (tracked - self.forms.start);
        let first = Run {
            columns: self.columns.start..column,
            forms: self.forms.start..tracked,
            ..self
        };
        let second = Run {
            columns: column..self.columns.end,
            forms: tracked..self.forms.end,
            ..self
        };
        (first, second)
    }

    /// A form of the run from one direction.
    pub(super) fn side(&self, form: usize, column: usize, upper: bool) -> Side {
        Side {
            form: form as u32,
            column: column as u16,
            left: self.left as u8,
            level: self.level as u8,
            upper,
        }
    }
}

/// A form from one direction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(in crate::learn::version_space) struct Side {
    pub(in crate::learn::version_space) form: u32,
    pub(in crate::learn::version_space) column: u16,
    pub(in crate::learn::version_space) left: u8,
    pub(in crate::learn::version_space) level: u8,
    /// Whether it bounds its form from above.
    pub(in crate::learn::version_space) upper: bool,
}

impl Side {
    /// A value of the form such that larger is further out. Its own inverse.
    pub(in crate::learn::version_space) fn outward<R: Real>(&self, value: R) -> R {
        if self.upper { value } else { -value }
    }
}

/// Where the forms are: all left sides against all right sides of a level and
/// dimension, level by level.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Layout {
    pub(super) lefts: [[Block; 2]; DIMENSIONS],
    /// Left sides that found no room.
    pub(super) lefts_left_out: [usize; DIMENSIONS],
    pub(super) columns: [[Block; DIMENSIONS]; LEVELS],
    pub(super) capacity: usize,
}

impl Layout {
    pub(super) fn runs(&self) -> impl Iterator<Item = Run> + use<> {
        let Layout {
            lefts,
            columns,
            capacity,
            ..
        } = *self;
        let blocks = columns
            .into_iter()
            .enumerate()
            .flat_map(move |(level, own)| {
                own.into_iter().zip(lefts).flat_map(move |(block, lefts)| {
                    let lefts = lefts.into_iter().flat_map(Block::range);
                    lefts.map(move |left| (level, left, block))
                })
            });
        let mut used = 0;
        blocks.filter_map(move |(level, left, block)| {
            let len = block.len.min(capacity - used);
            let start = used;
            used += len;
            (len > 0).then(|| Run {
                level,
                left,
                columns: block.start..block.start + len,
                forms: start..start + len,
            })
        })
    }

    pub(super) fn has_left(&self, dimension: Dimension) -> bool {
        let own = self.lefts.get(dimension as usize);
        own.is_some_and(|blocks| blocks.iter().any(|b| b.len > 0))
    }

    pub(super) fn wanted(&self) -> usize {
        let lefts = self.lefts.iter().zip(self.lefts_left_out);
        let lefts = lefts.map(|([a, b], left_out)| a.len + b.len + left_out);
        let columns = self.columns.iter();
        let all = columns.flat_map(|own| own.iter().zip(lefts.clone()));
        all.map(|(block, lefts)| block.len * lefts).sum()
    }
}
