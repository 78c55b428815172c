//! Which infeasible samples each of the first forms excludes, from both directions.

use super::{Interval, SampleSet};
use crate::real::Real;
use core::ops::Range;

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

    /// Forgets what a form excludes.
    pub(super) fn forget(&mut self, form: usize) {
        let own = self.words.get_mut(form..).unwrap_or(&mut []);
        for word in own.iter_mut().step_by(self.tracked.max(1)) {
            *word = 0;
        }
    }

    /// Notes on which sides a form excludes a sample.
    pub(super) fn note(&mut self, form: usize, sample: usize, excludes: impl Fn(bool) -> bool) {
        for upper in [false, true] {
            let start = (2 * (sample / 64) + usize::from(upper)) * self.tracked;
            if let Some(word) = self.words.get_mut(start + form).filter(|_| excludes(upper)) {
                *word |= 1 << (sample % 64);
            }
        }
    }

    /// A word of neighbouring forms from one direction.
    #[inline(always)]
    pub(super) fn plane(&self, word: usize, upper: bool, forms: &Range<usize>) -> &[u64] {
        let start = (2 * word + usize::from(upper)) * self.tracked;
        let own = self.words.get(start + forms.start..start + forms.end);
        own.unwrap_or(&[])
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
