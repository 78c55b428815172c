//! Which infeasible samples each of the first forms excludes, from both directions.

use super::{Interval, SampleSet};
use crate::real::Real;

/// Bitmaps: for 64 samples after another, a word for each form bounded from below, then
/// one for each form bounded from above. So neighbouring forms lie side by side.
#[derive(Debug)]
pub(super) struct Exclusions<'m> {
    words: &'m mut [u64],
    /// How many forms it tells about.
    tracked: usize,
}

impl<'m> Exclusions<'m> {
    pub(super) fn new(words: &'m mut [u64], tracked: usize) -> Self {
        Exclusions { words, tracked }
    }

    /// The words of one form from one direction.
    #[inline(always)]
    pub(super) fn of(&self, form: usize, upper: bool) -> impl Iterator<Item = &u64> {
        let start = usize::from(upper) * self.tracked + form;
        let words = self.words.get(start..).unwrap_or(&[]);
        words.iter().step_by((2 * self.tracked).max(1))
    }

    /// A word of each form, bounded from below and from above.
    pub(super) fn planes_mut(&mut self, word: usize) -> Option<(&mut [u64], &mut [u64])> {
        let start = 2 * word * self.tracked;
        let planes = self.words.get_mut(start..start + 2 * self.tracked)?;
        planes.split_at_mut_checked(self.tracked)
    }

    /// Makes room for the next 64 samples, of which no form excludes any yet.
    pub(super) fn clear(&mut self, word: usize) {
        if let Some((below, above)) = self.planes_mut(word) {
            below.fill(0);
            above.fill(0);
        }
    }

    /// Takes out which of `infeasible`, the first `words` words of it, a form no longer
    /// excludes on a side on which S grew.
    #[inline(always)]
    pub(super) fn admit<R: Real>(
        &mut self,
        form: usize,
        interval: &Interval<R>,
        upper: bool,
        (infeasible, words): (&SampleSet, usize),
        value: impl Fn(usize) -> R,
    ) {
        let start = usize::from(upper) * self.tracked + form;
        let own = self.words.get_mut(start..).unwrap_or(&mut []);
        let own = own.iter_mut().step_by((2 * self.tracked).max(1));
        for (word, (slot, mask)) in own.zip(infeasible.words()).take(words).enumerate() {
            let mut open = *mask & *slot;
            while open != 0 {
                let bit = open & open.wrapping_neg();
                open ^= bit;
                let sample = 64 * word + bit.trailing_zeros() as usize;
                if !interval.excludes(value(sample), upper) {
                    *slot &= !bit;
                }
            }
        }
    }
}
