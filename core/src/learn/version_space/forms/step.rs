//! The forms as they look at the samples of one step.

use super::{Column, DirectedForm, Forms, SampleSet};
use crate::real::Real;

/// How many looks at what is tracked take as long as one at what it takes to name a form.
const LENGTH: usize = 16;

/// The forms, and the feasible and infeasible samples of one step of a sequence of actions:
/// what a hypothesis about that step is made of.
pub(in super::super) struct StepView<'v, 'm, R> {
    pub(in super::super) forms: &'v Forms<'m, R>,
    pub(super) step: usize,
    pub(in super::super) feasible: SampleSet,
    pub(in super::super) infeasible: SampleSet,
}

impl<'v, 'm, R: Real> StepView<'v, 'm, R> {
    /// Of a step, counted from zero.
    pub(in super::super) fn new(forms: &'v Forms<'m, R>, step: usize) -> Self {
        StepView {
            forms,
            step,
            feasible: forms.sample_set(step, true),
            infeasible: forms.sample_set(step, false),
        }
    }

    /// The same without some samples.
    pub(in super::super) fn without(mut self, samples: &SampleSet) -> Self {
        self.feasible.subtract(samples);
        self.infeasible.subtract(samples);
        self
    }

    /// The value of a form at a sample, outwards.
    pub(in super::super) fn value(&self, form: &DirectedForm, sample: usize) -> R {
        self.forms.value_at(form, sample)
    }

    /// Counts that the length of a form was looked at.
    pub(in super::super) fn note_length(&self) {
        self.forms.add_work(LENGTH);
    }

    /// Counts that so many values of a form were looked at: each takes as long as a look at what
    /// is tracked.
    pub(in super::super) fn note_values(&self, count: usize) {
        self.forms.add_work(count);
    }

    /// Counts that the values of a form at all samples were looked at.
    pub(in super::super) fn note_look(&self) {
        self.note_values(self.feasible.len() + self.infeasible.len());
    }

    /// The values of a form at the samples, outwards.
    #[inline(always)]
    pub(in super::super) fn column(&self, form: &DirectedForm) -> Column<'v, R> {
        self.forms.column(form)
    }

    /// The least value of a form in a set.
    pub(in super::super) fn first_of(&self, form: &DirectedForm, set: &SampleSet) -> R {
        let column = self.column(form);
        column.of_all(set).fold(R::INFINITY, R::min)
    }

    /// How far a form ranges over the feasible samples.
    pub(in super::super) fn feasible_width(&self, form: &DirectedForm) -> R {
        self.last_feasible(form) + self.last_feasible(&form.reversed())
    }

    /// How far a form ranges over the samples.
    pub(in super::super) fn range(&self, form: &DirectedForm) -> R {
        let column = self.column(form);
        let (mut low, mut high) = (R::INFINITY, R::NEG_INFINITY);
        for set in [&self.feasible, &self.infeasible] {
            for value in column.of_all(set).filter(|value| value.is_finite()) {
                (low, high) = (low.min(value), high.max(value));
            }
        }
        high - low
    }

    /// How far two bounds reach, of which each feasible sample satisfies one; `None` if
    /// one is beyond both ends of `at`. A sample that may satisfy either extends the one
    /// that it is nearer to.
    pub(in super::super) fn corner(&self, forms: [&DirectedForm; 2], at: [R; 2]) -> Option<[R; 2]> {
        let [first, second] = forms;
        let [end, or_end] = at;
        let columns = (self.column(first), self.column(second));
        let values = || {
            let own = |sample| (columns.0.at(sample), columns.1.at(sample));
            self.feasible.iter().map(own)
        };
        let (mut inner, mut or) = (R::NEG_INFINITY, R::NEG_INFINITY);
        for (value, other) in values() {
            match (value < end, other < or_end) {
                (false, false) => return None,
                (true, false) => inner = inner.max(value),
                (false, true) => or = or.max(other),
                (true, true) => {}
            }
        }
        for (value, other) in values() {
            if value > inner && other > or {
                let way = (value - inner) / (end - inner);
                let other_way = (other - or) / (or_end - or);
                if way <= other_way || !other_way.is_finite() {
                    inner = value;
                } else {
                    or = other;
                }
            }
        }
        Some([inner, or])
    }
}

impl<R: Real> Forms<'_, R> {
    /// How much work was done since the last answer.
    pub(in super::super) fn work(&self) -> u32 {
        self.work.get()
    }

    /// Counts work: looks at a form and 64 samples, or what takes as long. It is the same
    /// whatever is tracked.
    #[inline(always)]
    pub(super) fn add_work(&self, looks: usize) {
        let looks = u32::try_from(looks).unwrap_or(u32::MAX);
        let work = self.work.get().saturating_add(looks);
        // It never reaches what stands for any amount.
        self.work.set(work.min(u32::MAX - 1));
    }

    /// An answer comes: work is counted anew.
    pub(in super::super) fn forget_work(&self) {
        self.work.set(0);
    }
}
