//! Branch and bound: which small boxes of parameters may hold some of a region.

use super::parameters::{ParameterSet, Vector};
use crate::error::Error;
use crate::real::Real;

/// How often the box of all parameters is halved, counting all parameters.
const MAX_DEPTH: u32 = 18;
/// How many boxes are examined.
const MAX_BOXES: u32 = 4096;

/// The lowest and the highest corner of a box.
pub(super) type Corners<R> = (Vector<R>, Vector<R>);

/// A depth-first search through halves of halves of the box of all parameters. It leaves
/// out boxes that are proven to hold nothing of a region. The path to a box is a bit per
/// halving, so the search needs no stack.
pub(super) struct BoxSearch {
    path: u32,
    depth: u32,
    /// Which half comes first, a bit per depth.
    order: u32,
    boxes: u32,
    found: bool,
    complete: bool,
}

impl BoxSearch {
    /// A search that visits halves in the order of the bits of `order`.
    pub(super) fn new(order: u32) -> Self {
        BoxSearch {
            path: 0,
            depth: 0,
            order,
            boxes: 0,
            found: false,
            complete: false,
        }
    }

    /// Whether every box was looked at.
    pub(super) fn is_complete(&self) -> bool {
        self.complete
    }

    /// Whether every box was looked at and none could hold anything.
    pub(super) fn found_nothing(&self) -> bool {
        self.complete && !self.found
    }

    /// The next smallest box, as its corners, that may hold some of the region.
    pub(super) fn next<R: Real>(
        &mut self,
        region: &impl ParameterSet<R>,
    ) -> Result<Option<Corners<R>>, Error> {
        while !self.complete && self.boxes < MAX_BOXES {
            self.boxes += 1;
            let (low, high) = self.corners(region);
            if region.excludes(&low, &high)? {
                self.pass();
            } else if self.depth < MAX_DEPTH && region.relevant().count_ones() > 0 {
                self.path <<= 1;
                self.depth += 1;
            } else {
                self.found = true;
                self.pass();
                return Ok(Some((low, high)));
            }
        }
        Ok(None)
    }

    /// Moves on to the next box that is not inside this one.
    fn pass(&mut self) {
        while self.depth > 0 && self.path & 1 == 1 {
            self.path >>= 1;
            self.depth -= 1;
        }
        self.complete = self.depth == 0;
        self.path |= 1;
    }

    /// The box at the end of the path: the relevant parameters are halved in turn.
    fn corners<R: Real>(&self, region: &impl ParameterSet<R>) -> Corners<R> {
        let (mut low, mut high) = region.bounds();
        let relevant = region.relevant();
        let mut left = relevant;
        for level in 0..self.depth {
            if left == 0 {
                left = relevant;
            }
            let parameter = left.trailing_zeros() as usize;
            left &= left.wrapping_sub(1);
            let shift = self.depth - 1 - level;
            let upper = ((self.path >> shift) ^ (self.order >> level)) & 1 == 1;
            if let (Some(low), Some(high)) = (low.get_mut(parameter), high.get_mut(parameter)) {
                let middle = low.towards(*high, R::from_f64(0.5));
                *(if upper { low } else { high }) = middle;
            }
        }
        (low, high)
    }
}
