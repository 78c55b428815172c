//! The hypothesis table: `lhs comparison rhs` for every pair of comparable features,
//! simple pairs first (thesis 4.3, Eq. 4.1 and 4.2).
//!
//! A pair of features and its four comparisons take one byte, a bit per
//! hypothesis that is still in the set. Pairs are not stored: they follow from
//! the order of the features. All right sides of one left side, complexity and
//! dimension stand together (a run), so validating them against a sample is
//! a linear sweep over numbers and bytes that the compiler turns into vector
//! instructions.

use super::features::{Features, MAX_COMPLEXITY, feature_id};
use super::formula::Comparison;
use crate::domain::{Dimension, NodeId};
use crate::real::Real;
use core::ops::Range;

/// Most complex pairs: the sum of the complexities of the two sides.
pub const MAX_PAIR_COMPLEXITY: usize = MAX_COMPLEXITY + 2;

/// One left side against right sides that stand together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Run {
    /// Index of the left side.
    pub(crate) lhs: usize,
    /// Indices of the right sides.
    pub(crate) rhs: Range<usize>,
}

/// How much of the grammar a table holds. The unit is hypotheses, four a pair.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Enumeration {
    /// All hypotheses of the grammar up to [`MAX_PAIR_COMPLEXITY`].
    pub enumerated: u64,
    /// Those in the table at the start.
    pub kept: u64,
    /// Those that found no room; the most complex ones.
    pub left_out: u64,
}

/// A set of hypotheses, one bit for each.
#[derive(Debug)]
pub struct Hypotheses<'m> {
    pairs: &'m mut [u8],
    used: usize,
    enumeration: Enumeration,
}

/// All four comparisons of a pair.
const ALL_FOUR: u8 = 0b1111;

/// The bit of a comparison.
pub(crate) const fn bit(comparison: Comparison) -> u8 {
    match comparison {
        Comparison::Less => 0b0001,
        Comparison::LessEqual => 0b0010,
        Comparison::GreaterEqual => 0b0100,
        Comparison::Greater => 0b1000,
    }
}

/// Which comparisons hold between two numbers; none if one is NaN. In 64 bits, as
/// wide as the numbers, so that the compiler compares several at once.
#[inline(always)]
fn holding<R: Real>(lhs: R, rhs: R) -> u8 {
    let below = -i64::from(lhs <= rhs);
    let above = -i64::from(lhs >= rhs);
    // 0011 where smaller, 1100 where larger, 0110 where equal.
    ((below & 0b0011) + (above & 0b1100) - (below & above & 0b1001)) as u8
}

/// Pairs that are validated at once.
const LANES: usize = 8;

/// Removes the hypotheses of a left side that do not hold, or with `flip` those
/// that do.
#[inline]
fn prune<R: Real>(lhs: R, rhs: &[R], pairs: &mut [u8], flip: u8) {
    let (blocks, rest) = rhs.as_chunks::<LANES>();
    let (pair_blocks, pair_rest) = pairs.as_chunks_mut::<LANES>();
    for (rhs, pairs) in blocks.iter().zip(pair_blocks) {
        let holding = rhs.map(|rhs| holding(lhs, rhs));
        for (pair, holding) in pairs.iter_mut().zip(holding) {
            *pair &= holding ^ flip;
        }
    }
    for (rhs, pair) in rest.iter().zip(pair_rest) {
        *pair &= holding(lhs, *rhs) ^ flip;
    }
}

impl<'m> Hypotheses<'m> {
    /// Enumerates all pairs of the features into a borrowed table, a byte for
    /// four hypotheses, until it is full.
    pub fn enumerate<R: Real>(features: &Features<'_, R>, pairs: &'m mut [u8]) -> Self {
        let used = runs(features, pairs.len()).map(|run| run.rhs.len()).sum();
        let enumerated = 4 * enumerated_pairs(features);
        let kept = 4 * used as u64;
        let mut all = Hypotheses {
            pairs,
            used,
            enumeration: Enumeration {
                enumerated,
                kept,
                left_out: enumerated.saturating_sub(kept),
            },
        };
        all.restore();
        all
    }

    /// How many hypotheses the grammar has and the table holds.
    pub fn enumeration(&self) -> Enumeration {
        self.enumeration
    }

    /// Puts all hypotheses into the set again.
    pub(crate) fn restore(&mut self) {
        for pair in self.pairs.iter_mut().take(self.used) {
            *pair = ALL_FOUR;
        }
    }

    /// How many hypotheses are still in the set.
    pub fn remaining(&self) -> usize {
        let counts = self
            .pairs
            .iter()
            .take(self.used)
            .map(|p| p.count_ones() as usize);
        counts.sum()
    }

    /// Validates every hypothesis against the sample that `features` were
    /// evaluated at (Eq. 4.4) and removes the false ones if the sample was
    /// feasible (Eq. 4.8), the true ones if it was not (Eq. 4.9).
    pub fn update<R: Real>(&mut self, features: &Features<'_, R>, feasible: bool) {
        let flip = if feasible { 0 } else { ALL_FOUR };
        let values = features.values();
        self.for_each_run(features, |run, pairs| {
            let rhs = values.get(run.rhs.clone()).unwrap_or(&[]);
            let Some(lhs) = values.get(run.lhs) else {
                return;
            };
            prune(*lhs, rhs, pairs, flip);
        });
    }

    /// Calls `visit` with every run and its pairs, a byte each.
    pub(crate) fn for_each_run<R: Real>(
        &mut self,
        features: &Features<'_, R>,
        mut visit: impl FnMut(&Run, &mut [u8]),
    ) {
        let mut rest = self.pairs.get_mut(..self.used).unwrap_or(&mut []);
        for run in runs(features, self.used) {
            let Some((own, others)) = rest.split_at_mut_checked(run.rhs.len()) else {
                return;
            };
            visit(&run, own);
            rest = others;
        }
    }

    /// Calls `visit` with every hypothesis that is still in the set, simple ones
    /// first: its left side, comparison and right side among the features.
    pub fn for_each<R: Real>(
        &self,
        features: &Features<'_, R>,
        mut visit: impl FnMut(NodeId, Comparison, NodeId),
    ) {
        let mut pairs = self.pairs.iter();
        for run in runs(features, self.used) {
            for (rhs, pair) in run.rhs.zip(pairs.by_ref()) {
                let present = |c: &Comparison| pair & bit(*c) != 0;
                for comparison in Comparison::ALL.into_iter().filter(present) {
                    visit(feature_id(run.lhs), comparison, feature_id(rhs));
                }
            }
        }
    }
}

/// The pairs of a table as runs, in order of complexity, cut off at `capacity`.
fn runs<R: Real>(features: &Features<'_, R>, capacity: usize) -> impl Iterator<Item = Run> {
    let mut first = 0usize;
    let blocks = blocks().flat_map(|(lhs, rhs, dimension)| {
        let rhs = features.rhs(rhs, dimension);
        let lhs = features.lhs(lhs, dimension);
        lhs.map(move |lhs| (lhs, rhs.clone()))
    });
    blocks.map_while(move |(lhs, rhs)| {
        let room = capacity.saturating_sub(first);
        let count = rhs.len().min(room);
        let run = Run {
            lhs,
            rhs: rhs.start..rhs.start + count,
        };
        first += count;
        (room > 0).then_some(run)
    })
}

/// Complexity of the left side, of the right side, and dimension, in the order
/// of the table.
fn blocks() -> impl Iterator<Item = (usize, usize, Dimension)> {
    (2..=MAX_PAIR_COMPLEXITY).flat_map(|total| {
        let lhs = 1..=total.saturating_sub(1).min(2);
        lhs.flat_map(move |lhs| Dimension::ALL.map(|d| (lhs, total - lhs, d)))
    })
}

fn enumerated_pairs<R: Real>(features: &Features<'_, R>) -> u64 {
    let pairs = blocks().map(|(lhs, rhs, dimension)| {
        features.enumerated_lhs(lhs, dimension) * features.enumerated_rhs(rhs, dimension)
    });
    pairs.sum()
}

#[cfg(test)]
mod tests {
    use super::{bit, holding};
    use crate::grammar::Comparison;

    #[test]
    fn bits_agree_with_the_comparisons() {
        for (a, b) in [(1.0, 2.0), (2.0, 1.0), (1.0, 1.0), (f64::NAN, 1.0)] {
            for c in Comparison::ALL {
                assert_eq!(
                    holding(a, b) & bit(c) != 0,
                    c.holds(&a, &b),
                    "{a} {c:?} {b}"
                );
            }
        }
    }
}
