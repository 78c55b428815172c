//! Branch and bound over boxes of instances and parameters, depth first.

use super::outward::range;
use super::proof::{Found, Proof};
use super::tape::Corners;
use crate::domain::Range;
use crate::error::Error;
use heapless::Vec;

/// How many boxes are open at once at most.
const MAX_OPEN: usize = 96;
/// How many ranges of variables can be narrowed on the way to a box.
const MAX_TRAIL: usize = 512;

/// A narrowing from which less is left than this share of a range is noted.
const WORTHWHILE: f64 = 0.9;

/// What stopped a proof that is neither complete nor refuted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// As many boxes were examined as the budget allows; allow more.
    Boxes,
    /// A box was halved as often as there is room for: the region and the end of what is
    /// specified touch there in a way that halving does not tell apart.
    Halvings,
}

/// What a search ends with.
pub(super) struct Outcome {
    pub(super) is_refuted: bool,
    pub(super) boxes: u32,
    /// The share of the volume that is open.
    pub(super) open: f64,
    pub(super) limit: Option<Limit>,
}

/// A half that has not been looked at.
struct Half {
    /// How long the trail was.
    trail: usize,
    variable: usize,
    range: Range<f64>,
    share: f64,
}

/// A box, and what was before it was narrowed.
struct Search {
    corners: Corners,
    trail: Vec<(usize, Range<f64>), MAX_TRAIL>,
    halves: Vec<Half, MAX_OPEN>,
    /// The share of the volume that the box has.
    share: f64,
}

impl Search {
    /// Replaces the range of a variable; `None` if there is no room to undo it.
    fn set(&mut self, variable: usize, to: Range<f64>) -> Option<()> {
        let own = self.corners.get_mut(variable)?;
        self.trail.push((variable, *own)).ok()?;
        *own = to;
        Some(())
    }

    /// Takes over what a box was narrowed to.
    fn narrow(&mut self, to: &Corners) {
        for (variable, to) in to.iter().enumerate() {
            let Some(own) = self.corners.get(variable).copied() else {
                break;
            };
            let (before, after) = (own.high - own.low, to.high - to.low);
            if after < WORTHWHILE * before && self.set(variable, *to).is_some() {
                self.share *= after / before;
            }
        }
    }

    /// Halves the box and stays in one half; `None` if there is no room for the other one.
    fn halve(&mut self, variable: usize, upper_first: bool) -> Option<()> {
        let own = self.corners.get(variable).copied()?;
        let middle = own.low + 0.5 * (own.high - own.low);
        let (lower, upper) = (range(own.low, middle), range(middle, own.high));
        let (first, second) = match upper_first {
            true => (upper, lower),
            false => (lower, upper),
        };
        self.share *= 0.5;
        let half = Half {
            trail: self.trail.len(),
            variable,
            range: second,
            share: self.share,
        };
        self.set(variable, first)?;
        self.halves.push(half).ok()
    }

    /// Goes to the half that was opened last; `None` if there is none.
    fn back(&mut self) -> Option<()> {
        let half = self.halves.pop()?;
        while self.trail.len() > half.trail {
            let (variable, before) = self.trail.pop()?;
            if let Some(own) = self.corners.get_mut(variable) {
                *own = before;
            }
        }
        self.share = half.share;
        // There is room: the first half of it was undone.
        self.set(half.variable, half.range)
    }
}

/// Looks for a sample that refutes a proof, or shows that there is none.
///
/// # Errors
/// Those of [`Proof::examine`].
#[inline(never)]
pub(super) fn search(
    proof: &mut Proof<'_>,
    corners: &Corners,
    budget: u32,
) -> Result<Outcome, Error> {
    let mut search = Search {
        corners: corners.clone(),
        trail: Vec::new(),
        halves: Vec::new(),
        share: 1.0,
    };
    let mut outcome = Outcome {
        is_refuted: false,
        boxes: 0,
        open: 0.0,
        limit: None,
    };
    loop {
        if outcome.boxes == budget {
            let pending = search
                .halves
                .iter()
                .fold(search.share, |sum, half| sum + half.share);
            outcome.open += pending;
            outcome.limit = Some(Limit::Boxes);
            return Ok(outcome);
        }
        outcome.boxes += 1;
        let mut box_corners = search.corners.clone();
        let found = proof.examine(&mut box_corners)?;
        search.narrow(&box_corners);
        match found {
            Found::Nothing => {}
            Found::Counterexample => {
                outcome.is_refuted = true;
                return Ok(outcome);
            }
            Found::Open(variable) => {
                let halved = match variable {
                    Some(variable) => {
                        let upper = proof.prefers_upper(&search.corners, variable);
                        search.halve(variable, upper)
                    }
                    None => None,
                };
                if halved.is_some() {
                    continue;
                }
                outcome.open += search.share;
                outcome.limit = Some(Limit::Halvings);
            }
        }
        if search.back().is_none() {
            return Ok(outcome);
        }
    }
}
