//! Taking samples in: S widens, and the sets of excluded samples follow.

use super::{Forms, Known, Sample, Span, tolerance};
use crate::real::Real;

/// Neighbouring forms that are looked at together: in most blocks nothing changes.
const BLOCK: usize = 16;

/// All bits or none: a choice without a branch, so that forms are compared side by
/// side.
#[inline(always)]
fn mask(chosen: bool) -> u64 {
    u64::from(chosen).wrapping_neg()
}

/// Whether the value of some form of a block is not in S. Without branches, so that
/// forms are compared side by side.
#[inline(always)]
fn any_outside<R: Real>(left: R, rights: &[R], spans: &[Span<R>]) -> bool {
    let pairs = rights.iter().zip(spans);
    pairs.fold(false, |any, (right, span)| {
        let value = left - *right;
        any | (value < span.low) | (value > span.high)
    })
}

impl<R: Real> Forms<'_, R> {
    /// Takes a sample at which the steps before `worked` worked, and that one
    /// failed unless it is `None`.
    pub(in crate::learn::version_space) fn add(
        &mut self,
        instance: usize,
        lefts: &[R],
        worked: usize,
        failed: Option<usize>,
    ) {
        let index = self.samples.len();
        let (word, bit) = (index / 64, 1u64 << (index % 64));
        // There is room: as much as for observations, of which each decides one at most.
        let _ = self.samples.push(Sample {
            instance: instance as u32,
        });
        let row = self
            .rows
            .chunks_exact_mut(self.left_count.max(1))
            .nth(index);
        for (slot, value) in row.unwrap_or(&mut []).iter_mut().zip(lefts) {
            *slot = *value;
        }
        if bit == 1 {
            let start = 2 * word * self.tracked;
            let planes = self.bits.get_mut(start..start + 2 * self.tracked);
            planes.unwrap_or(&mut []).fill(0);
        }
        for step in 0..worked {
            self.enter(step, true, index);
            self.widen(instance, lefts, step);
        }
        if let Some(step) = failed {
            self.enter(step, false, index);
            self.note_excluded(instance, lefts, step, word, bit);
        }
    }

    /// Widens S of every form that is tracked by a feasible sample. Forms that were widened may
    /// exclude less.
    fn widen(&mut self, instance: usize, lefts: &[R], step: usize) {
        let tracked = self.tracked;
        let infeasible = self.infeasible(step);
        let words = self.words();
        let known = Known {
            instances: self.instances,
            width: self.width,
            rows: self.rows,
            left_count: self.left_count,
            samples: self.samples.as_slice(),
        };
        let rights = known.rights(instance);
        let spans = self.spans.get_mut(step * tracked..).unwrap_or(&mut []);
        for (run, _) in self.layout.runs().map(|run| run.split(tracked)) {
            let left = lefts.get(run.left).copied().unwrap_or(R::NAN);
            let spans = spans.get_mut(run.forms.clone()).unwrap_or(&mut []);
            let rights = rights.get(run.columns.clone()).unwrap_or(&[]);
            let blocks = spans.chunks_mut(BLOCK).zip(rights.chunks(BLOCK));
            for (at, (spans, rights)) in blocks.enumerate() {
                if !any_outside(left, rights, spans) {
                    continue;
                }
                for (within, (span, right)) in spans.iter_mut().zip(rights).enumerate() {
                    let value = left - *right;
                    let at = BLOCK * at + within;
                    let (form, column) = (run.forms.start + at, run.columns.start + at);
                    // The first sample widens both sides.
                    while let Some(upper) = span.take_in(value) {
                        known.settle_bits(
                            self.bits,
                            tracked,
                            words,
                            form,
                            run.left,
                            column,
                            span,
                            upper,
                            &infeasible,
                        );
                    }
                }
            }
        }
    }

    /// Notes which of the forms that are tracked exclude an infeasible sample.
    fn note_excluded(&mut self, instance: usize, lefts: &[R], step: usize, word: usize, bit: u64) {
        let tracked = self.tracked;
        let rights = self.instances.chunks_exact(self.width.max(1)).nth(instance);
        let rights = rights.unwrap_or(&[]);
        let spans = self.spans.get(step * tracked..).unwrap_or(&[]);
        let planes = self.bits.get_mut(2 * word * tracked..).unwrap_or(&mut []);
        let Some((below, above)) = planes.split_at_mut_checked(tracked) else {
            return;
        };
        for (run, _) in self.layout.runs().map(|run| run.split(tracked)) {
            let left = lefts.get(run.left).copied().unwrap_or(R::NAN);
            let spans = spans.get(run.forms.clone()).unwrap_or(&[]);
            let rights = rights.get(run.columns.clone()).unwrap_or(&[]);
            let below = below.get_mut(run.forms.clone()).unwrap_or(&mut []);
            let above = above.get_mut(run.forms.clone()).unwrap_or(&mut []);
            let sides = below.iter_mut().zip(above);
            for ((span, right), (below, above)) in spans.iter().zip(rights).zip(sides) {
                let value = left - *right;
                let rounding = tolerance(value);
                *below |= bit & mask(value + rounding < span.low);
                *above |= bit & mask(value - rounding > span.high);
            }
        }
    }
}
