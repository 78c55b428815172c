//! Where the forms are in their tables.

use super::{DIMENSIONS, LEVELS};
use crate::domain::Dimension;
use crate::real::Real;
use core::ops::Range;

/// Neighbours in a table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Block {
    start: u16,
    len: u16,
}

impl Block {
    /// From one place in a table to another, neither of which is beyond 65 535.
    pub(super) fn between(start: usize, end: usize) -> Block {
        let small = |n| u16::try_from(n).unwrap_or(u16::MAX);
        Block {
            start: small(start),
            len: small(end.saturating_sub(start)),
        }
    }

    pub(super) fn len(self) -> usize {
        usize::from(self.len)
    }

    pub(super) fn range(self) -> Range<usize> {
        let start = usize::from(self.start);
        start..start + self.len()
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
    pub(super) lefts_left_out: [u32; DIMENSIONS],
    pub(super) columns: [[Block; DIMENSIONS]; LEVELS],
    pub(super) capacity: usize,
}

impl Layout {
    pub(super) fn runs(&self) -> Runs<'_> {
        Runs {
            layout: self,
            level: 0,
            dimension: 0,
            block: 0,
            left: 0,
            used: 0,
        }
    }

    pub(super) fn has_left(&self, dimension: Dimension) -> bool {
        let own = self.lefts.get(dimension as usize);
        own.is_some_and(|blocks| blocks.iter().any(|b| b.len() > 0))
    }

    pub(super) fn wanted(&self) -> usize {
        let lefts = self.lefts.iter().zip(self.lefts_left_out);
        let lefts = lefts.map(|([a, b], left_out)| a.len() + b.len() + left_out as usize);
        let columns = self.columns.iter();
        let all = columns.flat_map(|own| own.iter().zip(lefts.clone()));
        all.map(|(block, lefts)| block.len() * lefts).sum()
    }
}

/// The runs of a layout in the order of their forms. Nested iterators over copies of the
/// blocks would say the same with ten times the stack.
#[derive(Clone, Debug)]
pub(super) struct Runs<'l> {
    layout: &'l Layout,
    /// Where the next run is: its level, its dimension, and its left side as the block
    /// and the place in it.
    level: usize,
    dimension: usize,
    block: usize,
    left: usize,
    /// Forms before it.
    used: usize,
}

impl Iterator for Runs<'_> {
    type Item = Run;

    fn next(&mut self) -> Option<Run> {
        loop {
            let own = self.layout.columns.get(self.level)?;
            let Some(columns) = own.get(self.dimension) else {
                (self.level, self.dimension) = (self.level + 1, 0);
                continue;
            };
            let lefts = self.layout.lefts.get(self.dimension);
            let Some(lefts) = lefts.and_then(|blocks| blocks.get(self.block)) else {
                (self.dimension, self.block) = (self.dimension + 1, 0);
                continue;
            };
            let Some(left) = lefts.range().nth(self.left) else {
                (self.block, self.left) = (self.block + 1, 0);
                continue;
            };
            self.left += 1;
            let start = self.used;
            let len = columns.len().min(self.layout.capacity - start);
            self.used += len;
            if len > 0 {
                let first = columns.range().start;
                return Some(Run {
                    level: self.level,
                    left,
                    columns: first..first + len,
                    forms: start..start + len,
                });
            }
        }
    }
}
