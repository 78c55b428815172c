//! What is known of forms: read where it is tracked, computed from the samples where it
//! is not. Both ways say the same, as S only grows.

use super::interval::excludes;
use super::layout::Run;
use super::{DirectedForm, Forms, Interval, SUM_LEVEL, SampleSet, StepView};
use crate::real::Real;
use crate::table::Blank;
use core::ops::Range;

/// Forms whose version spaces are computed together.
const TOGETHER: usize = 16;

impl<R: Real> Forms<'_, R> {
    /// Calls `visit` with every form up to a level, from both directions. A left side alone is
    /// of the lowest one.
    pub(in super::super) fn for_each(&self, level: u8, mut visit: impl FnMut(DirectedForm)) {
        for run in self.layout.runs() {
            if run.level > usize::from(level) {
                continue;
            }
            for form in run.directed(true) {
                visit(form);
                visit(form.reversed());
            }
        }
        let sums = self.sums.directed(true);
        for form in sums.filter(|form| level >= SUM_LEVEL || self.is_left_side(form)) {
            visit(form);
            visit(form.reversed());
        }
    }

    /// Calls `visit` with every form of the same left side, from the same direction.
    pub(in super::super) fn for_each_rhs(
        &self,
        form: &DirectedForm,
        mut visit: impl FnMut(DirectedForm),
    ) {
        let runs = self.layout.runs();
        for run in runs.filter(|run| run.lhs == usize::from(form.lhs)) {
            run.directed(form.upper()).for_each(&mut visit);
        }
        let sums = self.sums.directed(form.upper());
        sums.filter(|sum| sum.lhs == form.lhs).for_each(visit);
    }
}

impl<R: Real> StepView<'_, '_, R> {
    /// Calls `visit` with every form from both directions and the number of
    /// infeasible samples of `wanted` that it excludes, unless it is zero.
    pub(in super::super) fn for_each_count(
        &self,
        wanted: &SampleSet,
        visit: &mut dyn FnMut(DirectedForm, u32),
    ) {
        let words = wanted.words().iter().filter(|word| **word != 0).count();
        let forms = self.forms.len() + self.forms.sums.capacity();
        self.forms.add_work(2 * forms * words);
        for upper in [true, false] {
            for run in self.forms.layout.runs() {
                let (tracked, other) = run.split(self.forms.tracked);
                self.look_up_counts(&tracked, upper, wanted, visit);
                self.compute_counts(&other, upper, wanted, visit);
            }
            self.look_up_sums(upper, wanted, visit);
            for form in self.forms.sums.directed(upper) {
                if (form.index() as usize) < self.forms.tracked {
                    break;
                }
                let last = self.last_feasible(&form);
                let values = self.column(&form);
                let excluded = |sample: &usize| excludes(last, values.at(*sample), true);
                let count = wanted.iter().filter(excluded).count();
                if count > 0 {
                    visit(form, count as u32);
                }
            }
        }
    }

    /// [`StepView::for_each_count`] for forms whose exclusions are tracked.
    #[inline(always)]
    fn look_up_counts(
        &self,
        run: &Run,
        upper: bool,
        wanted: &SampleSet,
        visit: &mut dyn FnMut(DirectedForm, u32),
    ) {
        let mut forms = run.directed(upper);
        for first in run.forms.clone().step_by(TOGETHER) {
            let places = first..run.forms.end.min(first + TOGETHER);
            let counts = self.counts_of(&places, upper, wanted);
            for (count, form) in counts.into_iter().zip(forms.by_ref().take(places.len())) {
                if count > 0 {
                    visit(form, count);
                }
            }
        }
    }

    /// The same for sums that are tracked.
    fn look_up_sums(
        &self,
        upper: bool,
        wanted: &SampleSet,
        visit: &mut dyn FnMut(DirectedForm, u32),
    ) {
        let sums = &self.forms.sums;
        let end = self.forms.tracked.min(sums.first + sums.capacity());
        for first in (sums.first..end).step_by(TOGETHER) {
            let places = first..end.min(first + TOGETHER);
            let counts = self.counts_of(&places, upper, wanted);
            for (place, count) in places.clone().zip(counts).filter(|(_, count)| *count > 0) {
                if let Some(form) = sums.form_in(place - sums.first, upper) {
                    visit(form, count);
                }
            }
        }
    }

    /// How many of the wanted samples each of a few neighbouring forms excludes, side by side.
    #[inline(always)]
    fn counts_of(&self, forms: &Range<usize>, upper: bool, wanted: &SampleSet) -> [u32; TOGETHER] {
        let mut counts = [0; TOGETHER];
        let words = wanted.words().iter().take(self.forms.words());
        for (word, wanted) in words.enumerate().filter(|(_, wanted)| **wanted != 0) {
            let own = self.forms.exclusions.plane(word, upper, forms);
            for (count, own) in counts.iter_mut().zip(own) {
                *count += (own & wanted).count_ones();
            }
        }
        counts
    }

    /// [`StepView::for_each_count`] for forms of which nothing is tracked.
    fn compute_counts(
        &self,
        run: &Run,
        upper: bool,
        wanted: &SampleSet,
        visit: &mut dyn FnMut(DirectedForm, u32),
    ) {
        let values = &self.forms.values;
        let (start, further): (R, fn(R, R) -> R) = match upper {
            true => (R::NEG_INFINITY, R::max),
            false => (R::INFINITY, R::min),
        };
        let mut forms = run.directed(upper);
        for first in run.rhs.clone().step_by(TOGETHER) {
            let rhs = first..run.rhs.end.min(first + TOGETHER);
            let mut ends = [start; TOGETHER];
            for sample in self.feasible.iter() {
                let own = values.of_run(run.lhs, &rhs, sample);
                for (end, value) in ends.iter_mut().zip(own) {
                    *end = further(*end, value);
                }
            }
            let mut counts = [0; TOGETHER];
            for sample in wanted.iter() {
                let own = values.of_run(run.lhs, &rhs, sample);
                for ((count, end), value) in counts.iter_mut().zip(&ends).zip(own) {
                    *count += u32::from(excludes(*end, value, upper));
                }
            }
            for (count, form) in counts.into_iter().zip(forms.by_ref().take(rhs.len())) {
                if count > 0 {
                    visit(form, count);
                }
            }
        }
    }

    /// The end of S: the value farthest out at a feasible sample.
    pub(in super::super) fn last_feasible(&self, form: &DirectedForm) -> R {
        let index = form.index() as usize;
        if index >= self.forms.tracked {
            let values = self.column(form);
            let values = values.of_all(&self.feasible);
            return values.fold(R::NEG_INFINITY, R::max);
        }
        let place = self.step * self.forms.tracked + index;
        let interval = self.forms.intervals.get(place).copied();
        let interval = interval.unwrap_or(Interval::BLANK);
        if form.upper() {
            interval.high
        } else {
            -interval.low
        }
    }

    /// The infeasible samples that a form excludes.
    pub(in super::super) fn excluded(&self, form: &DirectedForm) -> SampleSet {
        let index = form.index() as usize;
        if index >= self.forms.tracked {
            let mut set = SampleSet::EMPTY;
            let end = form.outward(self.last_feasible(form));
            let values = self.column(form);
            for sample in self.infeasible.iter() {
                if excludes(end, form.outward(values.at(sample)), form.upper()) {
                    set.insert(sample);
                }
            }
            return set;
        }
        let own = self.forms.exclusions.of(index, form.upper());
        let mut set = SampleSet::of_words(own.take(self.forms.words()));
        set.intersect(&self.infeasible);
        set
    }
}
