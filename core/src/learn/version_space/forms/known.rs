//! What is known of forms and samples: S, and the value of a form at a sample.

use super::{Sample, Set, tolerance};
use crate::real::Real;
use core::ops::Range;

/// The values of a form at the feasible samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span<R> {
    pub(super) low: R,
    pub(super) high: R,
}

impl<R: Real> Default for Span<R> {
    fn default() -> Self {
        Span {
            low: R::INFINITY,
            high: -R::INFINITY,
        }
    }
}

impl<R: Real> Span<R> {
    /// Widens to a value. Tells whether it lay outside, and whether above; what is no
    /// number does not.
    #[inline(always)]
    pub(super) fn take_in(&mut self, value: R) -> Option<bool> {
        if value < self.low {
            self.low = value;
            Some(false)
        } else if value > self.high {
            self.high = value;
            Some(true)
        } else {
            None
        }
    }

    /// Whether a value lies outside, on one side, by more than rounding: a form
    /// that is constant up to rounding explains nothing.
    #[inline(always)]
    pub(super) fn excludes(&self, value: R, upper: bool) -> bool {
        excludes(if upper { self.high } else { self.low }, value, upper)
    }
}

/// Whether a value lies beyond the end of S on one side, see [`Span::excludes`].
#[inline(always)]
pub(super) fn excludes<R: Real>(end: R, value: R, upper: bool) -> bool {
    if upper {
        value - tolerance(value) > end
    } else {
        value + tolerance(value) < end
    }
}

/// What the value of a form at a sample follows from.
#[derive(Clone, Copy)]
pub(super) struct Known<'k, R> {
    pub(super) instances: &'k [R],
    pub(super) width: usize,
    pub(super) rows: &'k [R],
    pub(super) left_count: usize,
    pub(super) samples: &'k [Sample],
}

impl<R: Real> Known<'_, R> {
    pub(super) fn rights(&self, instance: usize) -> &[R] {
        let row = self.instances.chunks_exact(self.width.max(1)).nth(instance);
        row.unwrap_or(&[])
    }

    pub(super) fn value(&self, left: usize, column: usize, sample: usize) -> R {
        let instance = self.samples.get(sample).map_or(0, |s| s.instance as usize);
        let left = self.rows.get(sample * self.left_count + left);
        let right = self.instances.get(instance * self.width + column);
        match (left, right) {
            (Some(left), Some(right)) => *left - *right,
            _ => R::NAN,
        }
    }

    /// The values of forms with one left side and neighbouring right sides.
    #[inline(always)]
    pub(super) fn values(
        &self,
        left: usize,
        columns: &Range<usize>,
        sample: usize,
    ) -> impl Iterator<Item = R> {
        let instance = self.samples.get(sample).map_or(0, |s| s.instance as usize);
        let left = self.rows.get(sample * self.left_count + left).copied();
        let left = left.unwrap_or(R::NAN);
        let rights = self.rights(instance).get(columns.clone()).unwrap_or(&[]);
        rights.iter().map(move |right| left - *right)
    }

    /// Brings up to date which infeasible samples of a step a form excludes on a side
    /// on which S grew.
    #[expect(clippy::too_many_arguments)]
    #[inline(always)]
    pub(super) fn settle_bits(
        &self,
        bits: &mut [u64],
        tracked: usize,
        words: usize,
        form: usize,
        left: usize,
        column: usize,
        span: &Span<R>,
        upper: bool,
        infeasible: &Set,
    ) {
        let start = usize::from(upper) * tracked + form;
        let planes = bits.get_mut(start..).unwrap_or(&mut []);
        let slots = planes.iter_mut().step_by((2 * tracked).max(1));
        for (word, (slot, mask)) in slots.zip(infeasible).take(words).enumerate() {
            let mut open = *mask & *slot;
            while open != 0 {
                let bit = open & open.wrapping_neg();
                open ^= bit;
                let sample = 64 * word + bit.trailing_zeros() as usize;
                if !span.excludes(self.value(left, column, sample), upper) {
                    *slot &= !bit;
                }
            }
        }
    }
}
