//! One bound of a form: where it lies between the samples it tells apart, and how
//! far single instances stray from it.
//!
//! An action may work a little beyond a boundary in one instance and fail a little
//! before it in another, for example because it moves in steps: every instance has
//! its own boundary, close to that of the constraint. So not the samples on the
//! wrong side count, of which there are as many as were asked there, but the
//! instances and how far they stray.

use super::forms::{DirectedForm, Forms, SampleSet, StepView, tolerance};
use super::tuning::Tuning;
use crate::real::Real;
use heapless::Vec;

/// Most instances that stray from one bound.
const MAX_STRAYS: usize = 16;

/// A form with the ends of its threshold, outwards: feasible up to `inner`, the end of S,
/// infeasible from `outer`, the beginning of G.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bound<R> {
    pub(super) form: DirectedForm,
    pub(super) inner: R,
    pub(super) outer: R,
    /// How far the form ranges over the samples.
    pub(super) range: R,
    /// What the samples on the wrong side cost, in bits.
    pub(super) strain: R,
}

/// Whether a value is known to lie beyond an end: what is no number is not.
fn is_beyond<R: Real>(value: R, end: R) -> bool {
    value > end
}

/// An instance with samples on the wrong side.
struct Stray<R> {
    instance: usize,
    by: R,
    samples: u32,
}

impl<R: Real> Bound<R> {
    /// A bound that nothing strays from.
    pub(super) fn new(form: DirectedForm, inner: R, outer: R, range: R) -> Self {
        Bound {
            form,
            inner,
            outer,
            range,
            strain: R::ZERO,
        }
    }

    /// A form of which only S is known.
    pub(super) fn inside(view: &StepView<'_, '_, R>, form: DirectedForm) -> Self {
        Bound::new(form, view.last_feasible(&form), R::INFINITY, R::ZERO)
    }

    /// The bound that has the feasible samples on the one side and `outside` on the other,
    /// with as little strain as possible. `None` if some instance would stray by more
    /// than `slack` of the form's range, or the strain would not be less than `most`.
    pub(super) fn between(
        view: &StepView<'_, '_, R>,
        form: DirectedForm,
        outside: &SampleSet,
        range: R,
        [slack, most]: [f64; 2],
    ) -> Option<Self> {
        let values = view.column(&form);
        let last = view.last_feasible(&form);
        let first = view.first_of(&form, outside);
        let mut bound = Bound::new(form, last, first, range);
        if first > last + tolerance(last) {
            return Some(bound);
        }
        let zone = range * R::from_f64(slack);
        if last - first >= zone + zone {
            return None;
        }
        // Only samples between the ends of both sides can stray, and what is no number.
        let (mut inside, mut below) = (SampleSet::EMPTY, R::NEG_INFINITY);
        for sample in view.feasible.iter() {
            let value = values.at(sample);
            if value < first {
                below = below.max(value);
            } else {
                inside.insert(sample);
            }
        }
        let farthest = first + zone + zone;
        let mut near = SampleSet::EMPTY;
        for sample in outside.iter() {
            if !is_beyond(values.at(sample), farthest) {
                near.insert(sample);
            }
        }
        let near_count = near.len();
        view.note_values(view.feasible.len() + outside.len());
        view.note_values((inside.len() + near_count) * near_count);
        let mut best: Option<Self> = None;
        let mut most = R::from_f64(most);
        for outer in values.of_all(&near).filter(|end| *end <= farthest) {
            let own = values.of_all(&inside).filter(|value| *value < outer);
            bound.inner = own.fold(below, R::max);
            bound.outer = outer;
            let open = bound.inner.is_finite() && outer - bound.inner > tolerance(last);
            let ends = [zone, most];
            if open && bound.measure_strain(view, [&inside, &near], ends) && bound.strain < most {
                (best, most) = (Some(bound), bound.strain);
            }
        }
        best
    }

    /// What samples cost that stray, of feasible and other ones that may. `false` if some
    /// instance strays too far, or all of them together cost too much.
    fn measure_strain(
        &mut self,
        view: &StepView<'_, '_, R>,
        [inside, outside]: [&SampleSet; 2],
        [zone, most]: [R; 2],
    ) -> bool {
        let forms = view.forms;
        let tuning = forms.tuning();
        let mut strays: Vec<Stray<R>, MAX_STRAYS> = Vec::new();
        let threshold = self.threshold(tuning);
        // What they cost at least.
        let mut least = R::ZERO;
        let cost = |by: R| R::from_f64(self.cost_of_way(by, tuning));
        let mut note = |sample: usize, by: R| {
            if by <= R::ZERO {
                return true;
            }
            let instance = forms.instance_of(sample);
            if let Some(stray) = strays.iter_mut().find(|s| s.instance == instance) {
                let by_most = stray.by.max(by);
                least += cost(by_most) - cost(stray.by);
                stray.by = by_most;
                stray.samples += 1;
                return by <= zone && !is_beyond(least, most);
            }
            least += cost(by);
            let stray = Stray {
                instance,
                by,
                samples: 1,
            };
            strays.push(stray).is_ok() && by <= zone && !is_beyond(least, most)
        };
        let values = view.column(&self.form);
        let value = |sample: usize| values.at(sample);
        let fits = inside.iter().all(|s| note(s, value(s) - threshold))
            && outside.iter().all(|s| note(s, threshold - value(s)));
        if !fits {
            return false;
        }
        let ends_in = |instance: usize| {
            let own = |set: &SampleSet, worst: R, further: fn(R, R) -> R| {
                let own = set.iter().filter(|s| forms.instance_of(*s) == instance);
                own.map(value).fold(worst, further)
            };
            let last = own(inside, R::NEG_INFINITY, R::max);
            (last, own(outside, R::INFINITY, R::min))
        };
        let costs = strays.iter().map(|stray| {
            let (last, first) = ends_in(stray.instance);
            self.cost_of(stray, last < first, forms)
        });
        self.strain = R::from_f64(costs.sum());
        true
    }

    /// What an instance that strays costs, in bits; it may have a boundary of its own.
    fn cost_of(&self, stray: &Stray<R>, own_boundary: bool, forms: &Forms<'_, R>) -> f64 {
        let tuning = forms.tuning();
        let mixed = if own_boundary {
            0.0
        } else {
            tuning.stray_sample
        };
        self.cost_of_way(stray.by, tuning) + mixed * f64::from(stray.samples)
    }

    /// What an instance costs at least that strays so far.
    fn cost_of_way(&self, by: R, tuning: &Tuning) -> f64 {
        tuning.stray + tuning.stray_distance * (by / self.range).to_f64()
    }

    /// Where the bound is drawn.
    pub(super) fn threshold(&self, tuning: &Tuning) -> R {
        let gap = self.outer - self.inner;
        if gap.is_finite() {
            self.inner + gap * R::from_f64(tuning.threshold_share)
        } else {
            self.inner
        }
    }

    /// A position between the two ends: zero at the inner, one at the outer.
    pub(super) fn position(&self, value: R) -> R {
        if value <= self.inner {
            return R::ZERO;
        }
        if !self.outer.is_finite() {
            return R::ONE;
        }
        (value - self.inner) / (self.outer - self.inner)
    }
}
