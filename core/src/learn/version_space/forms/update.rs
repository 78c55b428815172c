//! Taking samples in: S grows, and what each form excludes follows.

use super::{DirectedForm, Forms, Interval, Origin, tolerance};
use crate::real::Real;
use crate::table::Blank;

/// Neighbouring forms that are looked at together: in most blocks nothing changes.
const TOGETHER: usize = 16;

/// All bits or none: a choice without a branch, so that forms are compared side by
/// side.
#[inline(always)]
fn mask(chosen: bool) -> u64 {
    u64::from(chosen).wrapping_neg()
}

/// Whether the value of some form of a block is not in S. Without branches, so that
/// forms are compared side by side.
#[inline(always)]
fn any_outside<R: Real>(lhs: R, rhs: &[R], intervals: &[Interval<R>]) -> bool {
    let pairs = rhs.iter().zip(intervals);
    pairs.fold(false, |any, (rhs, interval)| {
        let value = lhs - *rhs;
        any | (value < interval.low) | (value > interval.high)
    })
}

impl<R: Real> Forms<'_, R> {
    /// Takes a sample in, at which the steps before `worked` worked, and that one failed
    /// unless `failed` is `None`. Its left sides are in `lhs`.
    pub(in super::super) fn add(
        &mut self,
        (instance, origin): (usize, Origin),
        lhs: &[R],
        worked: usize,
        failed: Option<usize>,
    ) {
        let sample = self.samples();
        self.values.push(instance, origin, lhs);
        self.threshold_length = libm::log2((self.samples() + 1) as f64);
        if sample.is_multiple_of(64) {
            self.exclusions.clear(sample / 64);
        }
        for step in 0..worked {
            self.enter(step, true, sample);
            self.generalise(instance, lhs, step);
        }
        if let Some(step) = failed {
            self.enter(step, false, sample);
            self.note_excluding(instance, lhs, step, sample);
        }
    }

    /// Extends S of every form that is tracked to a feasible sample. A form whose S grew
    /// may exclude less.
    fn generalise(&mut self, instance: usize, lhs: &[R], step: usize) {
        let tracked = self.tracked;
        let infeasible = self.sample_set(step, false);
        let words = self.words();
        let values = &self.values;
        let all_rhs = values.rhs_in(instance);
        let intervals = self.intervals.get_mut(step * tracked..).unwrap_or(&mut []);
        for (run, _) in self.layout.runs().map(|run| run.split(tracked)) {
            let own = lhs.get(run.lhs).copied().unwrap_or(R::NAN);
            let intervals = intervals.get_mut(run.forms.clone()).unwrap_or(&mut []);
            let rhs = all_rhs.get(run.rhs.clone()).unwrap_or(&[]);
            let blocks = intervals.chunks_mut(TOGETHER).zip(rhs.chunks(TOGETHER));
            for (block, (intervals, rhs)) in blocks.enumerate() {
                if !any_outside(own, rhs, intervals) {
                    continue;
                }
                for (within, (interval, rhs)) in intervals.iter_mut().zip(rhs).enumerate() {
                    let place = TOGETHER * block + within;
                    let value_at = |sample| values.at(run.lhs, run.rhs.start + place, sample);
                    let form = run.forms.start + place;
                    // The first sample lies outside on both sides.
                    while let Some(upper) = interval.include(own - *rhs) {
                        let open = (&infeasible, words);
                        self.exclusions.admit(form, interval, upper, open, value_at);
                    }
                }
            }
        }
        self.generalise_sums(instance, lhs, step);
    }

    /// The same for sums.
    fn generalise_sums(&mut self, instance: usize, lhs: &[R], step: usize) {
        let infeasible = self.sample_set(step, false);
        let words = self.words();
        let (values, sums) = (&self.values, &self.sums);
        let intervals = self
            .intervals
            .get_mut(step * self.tracked..self.tracked * (step + 1));
        let own = intervals.and_then(|own| own.get_mut(sums.first..));
        for (slot, interval) in own.unwrap_or(&mut []).iter_mut().enumerate() {
            let Some(form) = sums.form_in(slot, true) else {
                continue;
            };
            let rhs = |instance| sums.value(slot, instance).unwrap_or(R::NAN);
            let left = usize::from(form.lhs);
            let value = lhs.get(left).copied().unwrap_or(R::NAN) - rhs(instance);
            let value_at = |sample| {
                let lhs = values.lhs_at(left, sample).unwrap_or(R::NAN);
                lhs - rhs(values.instance_of(sample))
            };
            while let Some(upper) = interval.include(value) {
                let (form, open) = (form.index() as usize, (&infeasible, words));
                self.exclusions.admit(form, interval, upper, open, value_at);
            }
        }
    }

    /// Evaluates sums that were found, and tells them of the samples if they are tracked.
    pub(super) fn evaluate_new_sums(&mut self) {
        for slot in 0..self.sums.capacity() {
            if let Some(form) = self.sums.form_in(slot, true)
                && self.sums.is_new(slot)
            {
                self.sums.evaluate(slot, &self.values);
                if (form.index() as usize) < self.tracked {
                    self.track(&form);
                }
            }
        }
    }

    /// Finds S of a form in all steps, and what it excludes.
    fn track(&mut self, form: &DirectedForm) {
        let (tracked, index) = (self.tracked.max(1), form.index() as usize);
        self.exclusions.forget(index);
        for step in 0..self.intervals.len() / tracked {
            let mut interval = Interval::<R>::BLANK;
            for value in self.column(form).of_all(&self.sample_set(step, true)) {
                interval.low = interval.low.min(value);
                interval.high = interval.high.max(value);
            }
            for sample in self.sample_set(step, false).iter() {
                let value = self.value_at(form, sample);
                self.exclusions
                    .note(index, sample, |upper| interval.excludes(value, upper));
            }
            if let Some(own) = self.intervals.get_mut(step * tracked + index) {
                *own = interval;
            }
        }
    }

    /// Notes which of the forms that are tracked exclude an infeasible sample.
    fn note_excluding(&mut self, instance: usize, lhs: &[R], step: usize, sample: usize) {
        let tracked = self.tracked;
        let bit = 1u64 << (sample % 64);
        let all_rhs = self.values.rhs_in(instance);
        let intervals = self.intervals.get(step * tracked..).unwrap_or(&[]);
        let Some((below, above)) = self.exclusions.planes_mut(sample / 64) else {
            return;
        };
        for (run, _) in self.layout.runs().map(|run| run.split(tracked)) {
            let own = lhs.get(run.lhs).copied().unwrap_or(R::NAN);
            let intervals = intervals.get(run.forms.clone()).unwrap_or(&[]);
            let rhs = all_rhs.get(run.rhs.clone()).unwrap_or(&[]);
            let below = below.get_mut(run.forms.clone()).unwrap_or(&mut []);
            let above = above.get_mut(run.forms.clone()).unwrap_or(&mut []);
            let sides = below.iter_mut().zip(above);
            for ((interval, rhs), (below, above)) in intervals.iter().zip(rhs).zip(sides) {
                let value = own - *rhs;
                let rounding = tolerance(value);
                *below |= bit & mask(value + rounding < interval.low);
                *above |= bit & mask(value - rounding > interval.high);
            }
        }
        let sums = intervals.get(self.sums.first..tracked).unwrap_or(&[]);
        for (slot, interval) in sums.iter().enumerate() {
            let Some(form) = self.sums.form_in(slot, true) else {
                continue;
            };
            let own = lhs.get(usize::from(form.lhs)).copied().unwrap_or(R::NAN);
            let value = own - self.sums.value(slot, instance).unwrap_or(R::NAN);
            let note = |upper| interval.excludes(value, upper);
            self.exclusions.note(form.index() as usize, sample, note);
        }
    }
}
