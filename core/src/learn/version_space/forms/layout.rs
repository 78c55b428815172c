//! Where the forms are in their tables.

use super::{DIMENSIONS, LEVELS};
use crate::domain::Dimension;
use crate::real::Real;
use core::ops::Range;

/// Neighbours in a table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Places {
    start: u16,
    len: u16,
}

impl Places {
    /// From one place in a table to another, neither of which is beyond 65 535.
    pub(super) fn between(start: usize, end: usize) -> Places {
        let small = |n| u16::try_from(n).unwrap_or(u16::MAX);
        Places {
            start: small(start),
            len: small(end.saturating_sub(start)),
        }
    }

    pub(super) fn len(self) -> usize {
        usize::from(self.len)
    }

    fn range(self) -> Range<usize> {
        let start = usize::from(self.start);
        start..start + self.len()
    }
}

/// Forms of one left side and neighbouring right sides.
#[derive(Clone, Debug)]
pub(super) struct Run {
    pub(super) level: usize,
    pub(super) lhs: usize,
    pub(super) rhs: Range<usize>,
    pub(super) forms: Range<usize>,
}

impl Run {
    /// The forms before `form`, and the others.
    pub(super) fn split(self, form: usize) -> (Run, Run) {
        // Not `clamp`, which panics where a range has its ends the wrong way round.
        let middle = form.max(self.forms.start).min(self.forms.end);
        let rhs = self.rhs.start + (middle - self.forms.start);
        let first = Run {
            rhs: self.rhs.start..rhs,
            forms: self.forms.start..middle,
            ..self
        };
        let second = Run {
            rhs: rhs..self.rhs.end,
            forms: middle..self.forms.end,
            ..self
        };
        (first, second)
    }

    /// Its forms from one direction, in their order.
    pub(super) fn directed(&self, upper: bool) -> impl Iterator<Item = DirectedForm> + use<> {
        let (lhs, level) = (self.lhs as u8, self.level as u8);
        let forms = self.forms.clone().zip(self.rhs.clone());
        forms.map(move |(index, rhs)| DirectedForm {
            rhs: rhs as u16,
            lhs,
            level,
            ..DirectedForm::new(index, upper)
        })
    }
}

/// A form from one direction: what a bound bounds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(in super::super) struct DirectedForm {
    /// Its place among the forms, twice, and one if it is bounded from above: there are many of
    /// these.
    pub(in super::super) side: u32,
    pub(super) rhs: u16,
    /// Its left side, by its place among the left sides.
    pub(in super::super) lhs: u8,
    /// How complex its right side is, see [`LEVELS`].
    pub(in super::super) level: u8,
}

impl DirectedForm {
    /// In a place among the forms, from one direction, without its sides.
    #[inline(always)]
    pub(super) fn new(index: usize, upper: bool) -> Self {
        DirectedForm {
            side: 2 * index as u32 + u32::from(upper),
            ..DirectedForm::default()
        }
    }

    /// Its place among the forms.
    #[inline(always)]
    pub(in super::super) fn index(&self) -> u32 {
        self.side / 2
    }

    /// Whether it is bounded from above.
    #[inline(always)]
    pub(in super::super) fn upper(&self) -> bool {
        self.side % 2 == 1
    }

    /// A value of the form such that larger is further out. Its own inverse.
    pub(in super::super) fn outward<R: Real>(&self, value: R) -> R {
        if self.upper() { value } else { -value }
    }

    /// The same form from the other direction.
    pub(in super::super) fn reversed(self) -> DirectedForm {
        DirectedForm {
            side: self.side ^ 1,
            ..self
        }
    }
}

/// Where the forms are: all left sides against all right sides of a level and
/// dimension, level by level.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Layout {
    /// Left sides of each dimension, those of complexity 1 and those of 2.
    pub(super) lhs: [[Places; 2]; DIMENSIONS],
    /// Left sides that found no room.
    pub(super) lhs_left_out: [u32; DIMENSIONS],
    /// Right sides of each level and dimension.
    pub(super) rhs: [[Places; DIMENSIONS]; LEVELS],
    pub(super) capacity: usize,
}

impl Layout {
    pub(super) fn runs(&self) -> Runs<'_> {
        Runs {
            layout: self,
            level: 0,
            dimension: 0,
            complexity: 0,
            lhs: 0,
            used: 0,
        }
    }

    /// Says where the left sides of a dimension and complexity are, counted from zero, and how
    /// many found no room.
    pub(super) fn set_lhs(
        &mut self,
        complexity: usize,
        dimension: Dimension,
        range: Range<usize>,
        left_out: u32,
    ) {
        let own = self.lhs.get_mut(dimension as usize);
        if let Some(places) = own.and_then(|own| own.get_mut(complexity)) {
            *places = Places::between(range.start, range.end);
        }
        if let Some(lost) = self.lhs_left_out.get_mut(dimension as usize) {
            *lost += left_out;
        }
    }

    /// How many left sides there are of a complexity, from zero, and a dimension.
    pub(super) fn lhs_count(&self, complexity: usize, dimension: Dimension) -> usize {
        let own = self.lhs.get(dimension as usize);
        own.and_then(|own| own.get(complexity))
            .map_or(0, |own| own.len())
    }

    pub(super) fn has_lhs(&self, dimension: Dimension) -> bool {
        let own = self.lhs.get(dimension as usize);
        own.is_some_and(|own| own.iter().any(|places| places.len() > 0))
    }

    /// How many forms there would be if there were room.
    pub(super) fn wanted(&self) -> usize {
        let lhs = self.lhs.iter().zip(self.lhs_left_out);
        let lhs = lhs.map(|([a, b], left_out)| a.len() + b.len() + left_out as usize);
        let pairs = self.rhs.iter().flat_map(|own| own.iter().zip(lhs.clone()));
        pairs.map(|(rhs, lhs)| rhs.len() * lhs).sum()
    }
}

/// The runs of a layout in the order of their forms. Nested iterators over copies of the
/// places would say the same with ten times the stack.
#[derive(Clone, Debug)]
pub(super) struct Runs<'l> {
    layout: &'l Layout,
    /// Where the next run is: its level, its dimension, and its left side as the
    /// complexity and the place among those.
    level: usize,
    dimension: usize,
    complexity: usize,
    lhs: usize,
    /// Forms before it.
    used: usize,
}

impl Iterator for Runs<'_> {
    type Item = Run;

    fn next(&mut self) -> Option<Run> {
        loop {
            let own = self.layout.rhs.get(self.level)?;
            let Some(rhs) = own.get(self.dimension) else {
                (self.level, self.dimension) = (self.level + 1, 0);
                continue;
            };
            let own = self.layout.lhs.get(self.dimension);
            let Some(own) = own.and_then(|own| own.get(self.complexity)) else {
                (self.dimension, self.complexity) = (self.dimension + 1, 0);
                continue;
            };
            let Some(lhs) = own.range().nth(self.lhs) else {
                (self.complexity, self.lhs) = (self.complexity + 1, 0);
                continue;
            };
            self.lhs += 1;
            let start = self.used;
            let len = rhs.len().min(self.layout.capacity - start);
            self.used += len;
            if len > 0 {
                let first = rhs.range().start;
                return Some(Run {
                    level: self.level,
                    lhs,
                    rhs: first..first + len,
                    forms: start..start + len,
                });
            }
        }
    }
}
