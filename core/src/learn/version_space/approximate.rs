//! The best region where nothing explains all answers: the largest that is nearly right.
//!
//! Where the truth lies outside of the grammar, or some answers are wrong, a hypothesis may
//! be wrong about samples on either side of its bounds. It pays for each (robust minimum
//! description length), more for one that it admits wrongly than for one that it misses:
//! by how much more is the *caution*. Of hypotheses of different caution the largest is
//! taken whose share of feasible samples is what the caller asks for.

use super::bound::Bound;
use super::clause::Clause;
use super::forms::{DirectedForm, SUM_LEVEL, SampleSet, StepView, tolerance};
use super::hypothesis::{Hypothesis, MAX_CLAUSES};
use crate::real::Real;
use crate::table::{move_last, take_out};
use heapless::Vec;

/// By how much more a sample counts that is admitted wrongly than one that is missed.
const CAUTIONS: [f64; 5] = [1.0, 2.0, 4.0, 8.0, 19.0];
/// Most feasible samples that one bound may miss, of few and of very many.
const MISSED: [usize; 2] = [16, 64];
/// So many samples that work, and so many that do not, tell which forms are worth a closer look.
const ENOUGH: usize = 256;
/// Forms that are offered for each clause.
const OF_EACH: usize = 64;
/// Forms that clauses are chosen from, after all have been looked at for each.
const POOL: usize = OF_EACH * MAX_CLAUSES;
/// How often each clause is chosen anew.
const ROUNDS: usize = 2;

/// What a hypothesis makes of the samples.
#[derive(Clone, Copy, Debug, Default)]
struct Fit {
    /// Feasible samples that it admits.
    feasible: f64,
    /// Infeasible ones.
    infeasible: f64,
    /// Samples that it is wrong about.
    wrong: u32,
}

impl Fit {
    /// The share of what it admits that works, by the rule of succession (Laplace).
    fn precision(&self) -> f64 {
        (self.feasible + 1.0) / (self.feasible + self.infeasible + 2.0)
    }
}

/// A bound that is worth adding.
#[derive(Clone, Copy)]
struct Cut<R> {
    form: DirectedForm,
    threshold: R,
    gain: f64,
}

/// What it is worth to be right about samples.
#[derive(Clone, Copy)]
struct Worth {
    /// By how much more one counts that is admitted wrongly than one that is missed.
    caution: f64,
    /// The bits of one that is missed.
    each: f64,
}

impl<R: Real> Hypothesis<R> {
    /// Makes it the largest whose share of feasible samples is `wanted`, or as much of that
    /// as there is. Samples that were not drawn at random, but lie near a boundary, count
    /// less.
    #[inline(never)]
    pub(super) fn approximate(&mut self, view: &StepView<'_, '_, R>, wanted: f64) {
        let pool = self.pool(view);
        let mut best: Option<(Fit, Hypothesis<R>)> = None;
        for caution in CAUTIONS {
            self.grow(view, &pool, caution);
            let fit = self.fit(view);
            let better = best.as_ref().is_none_or(|(old, _)| {
                match (fit.precision() >= wanted, old.precision() >= wanted) {
                    (true, true) => fit.feasible > old.feasible,
                    (new, old_fits) if new != old_fits => new,
                    _ => fit.precision() > old.precision(),
                }
            });
            if better {
                best = Some((fit, self.clone()));
            }
            if fit.precision() >= wanted {
                // With more caution it would be smaller.
                break;
            }
        }
        if let Some((fit, hypothesis)) = best {
            self.copy_from(&hypothesis);
            self.consistent = fit.wrong == 0;
        }
    }

    /// What it costs in bits: its description, and what it is wrong about.
    pub(super) fn robust_length(&self, view: &StepView<'_, '_, R>) -> f64 {
        let wrong = f64::from(self.fit(view).wrong);
        self.length(view.forms) + view.forms.tuning().wrong * wrong
    }

    /// The forms that clauses are chosen from: those that pay most at first, and those that pay
    /// most beside what was chosen of them. Variants of the clause that explains most would
    /// leave no place for any other.
    #[inline(never)]
    fn pool(&mut self, view: &StepView<'_, '_, R>) -> Vec<DirectedForm, POOL> {
        let mut pool = Vec::new();
        self.clear();
        while !self.clauses.is_full() {
            let (feasible, infeasible) = self.admitted(view);
            let each = feasible.len().max(infeasible.len()).div_ceil(ENOUGH);
            let left = [&feasible.every(each), &infeasible.every(each)];
            offer(view, left, each, &mut pool);
            if !self.add(view, &pool, 1.0) {
                break;
            }
        }
        pool
    }

    /// Adds one bound after the other as long as that pays, then chooses each anew.
    fn grow(&mut self, view: &StepView<'_, '_, R>, pool: &[DirectedForm], caution: f64) {
        self.clear();
        while !self.clauses.is_full() && self.add(view, pool, caution) {}
        for _ in 0..ROUNDS {
            for index in 0..MAX_CLAUSES {
                if take_out(&mut self.clauses, index).is_some() && self.add(view, pool, caution) {
                    move_last(&mut self.clauses, index);
                }
            }
        }
        for clause in &mut self.clauses {
            clause.bound.range = view.range(&clause.bound.form);
        }
    }

    /// Adds the bound that pays most; `false` if none pays.
    fn add(&mut self, view: &StepView<'_, '_, R>, pool: &[DirectedForm], caution: f64) -> bool {
        let (feasible, infeasible) = self.admitted(view);
        let worth = Worth {
            caution,
            each: view.forms.tuning().wrong,
        };
        let mut best: Option<Cut<R>> = None;
        for form in pool {
            let clauses = &self.clauses;
            let mut known = clauses.iter().flat_map(Clause::bounds);
            let named = known.any(|bound| bound.form.index() == form.index());
            let length = view.forms.bound_length(form, named);
            if let Some(cut) = cut(view, form, [&feasible, &infeasible], (worth, length))
                && best.is_none_or(|best| cut.gain > best.gain)
            {
                best = Some(cut);
            }
        }
        let Some(best) = best else { return false };
        let beyond = infeasible
            .iter()
            .map(|sample| view.value(&best.form, sample));
        let beyond = beyond.filter(|value| *value > best.threshold + tolerance(*value));
        let outer = beyond.fold(R::INFINITY, R::min);
        let bound = Bound::new(best.form, best.threshold, outer, R::ONE);
        self.clauses.push(Clause::new(bound)).is_ok()
    }

    /// The feasible and the infeasible samples that it admits.
    fn admitted(&self, view: &StepView<'_, '_, R>) -> (SampleSet, SampleSet) {
        let (mut feasible, mut infeasible) = (view.feasible, view.infeasible);
        for set in [&mut feasible, &mut infeasible] {
            let all = *set;
            for sample in all.iter() {
                let holds = |bound: &Bound<R>| {
                    let value = view.value(&bound.form, sample);
                    value <= bound.inner + tolerance(value)
                };
                let mut clauses = self.clauses.iter();
                if !clauses.all(|clause| clause.bounds().any(holds)) {
                    set.remove(sample);
                }
            }
        }
        (feasible, infeasible)
    }

    fn fit(&self, view: &StepView<'_, '_, R>) -> Fit {
        let (feasible, infeasible) = self.admitted(view);
        let missed = view.feasible.len() - feasible.len();
        Fit {
            feasible: view.forms.weigh(feasible.iter()),
            infeasible: view.forms.weigh(infeasible.iter()),
            wrong: (missed + infeasible.len()) as u32,
        }
    }
}

/// Puts the forms into the pool whose bounds pay most where only these samples are left, each of
/// which stands for so many; best ones first.
#[inline(never)]
fn offer<R: Real>(
    view: &StepView<'_, '_, R>,
    left: [&SampleSet; 2],
    each: usize,
    pool: &mut Vec<DirectedForm, POOL>,
) {
    let worth = Worth {
        caution: 1.0,
        each: view.forms.tuning().wrong * each as f64,
    };
    let mut best: Vec<(f32, DirectedForm), OF_EACH> = Vec::new();
    view.forms.for_each(SUM_LEVEL, |form| {
        let length = view.forms.bound_length(&form, false);
        let Some(cut) = cut(view, &form, left, (worth, length)) else {
            return;
        };
        let gain = cut.gain as f32;
        if best.is_full() {
            if best.last().is_some_and(|(least, _)| gain <= *least) {
                return;
            }
            best.pop();
        }
        let place = best.partition_point(|(other, _)| *other >= gain);
        if best.push((gain, form)).is_ok() {
            move_last(&mut best, place);
        }
    });
    for (_, form) in &best {
        if !pool.contains(form) {
            // There is room for those of each clause.
            let _ = pool.push(*form);
        }
    }
}

/// Where a bound of a form pays most; `None` if it does not anywhere.
fn cut<R: Real>(
    view: &StepView<'_, '_, R>,
    form: &DirectedForm,
    [feasible, infeasible]: [&SampleSet; 2],
    (worth, length): (Worth, f64),
) -> Option<Cut<R>> {
    // The values farthest out, from the outermost in: beyond each lie as many samples as
    // stand before it.
    let [few, many] = MISSED;
    let missed = (feasible.len() / few).max(few).min(many);
    let mut ends: Vec<R, { MISSED[1] + 1 }> = Vec::new();
    let values = view.column(form);
    for value in values.of_all(feasible) {
        if ends.len() > missed {
            if ends.last().is_none_or(|last| value <= *last) {
                continue;
            }
            ends.pop();
        }
        if ends.push(value).is_ok() {
            sink_last(&mut ends);
        }
    }
    let mut counts = [0u32; MISSED[1] + 1];
    for value in values.of_all(infeasible) {
        let value = value - tolerance(value);
        if ends.last().is_none_or(|last| value <= *last) {
            continue;
        }
        let place = ends.partition_point(|end| *end >= value);
        if let Some(count) = counts.get_mut(place) {
            *count += 1;
        }
    }
    let (mut excluded, mut best) = (0, None::<Cut<R>>);
    for (missed, (end, count)) in ends.iter().zip(counts).enumerate() {
        excluded += count;
        let samples = worth.caution * f64::from(excluded) - missed as f64;
        let gain = worth.each * samples - length;
        // A distance of a group without members is infinite, which is no threshold.
        if end.is_finite() && gain > best.map_or(0.0, |best| best.gain) {
            best = Some(Cut {
                form: *form,
                threshold: *end,
                gain,
            });
        }
    }
    best
}

/// Moves the last value before those that are less, where the others are in order.
fn sink_last<R: Real>(values: &mut [R]) {
    let mut behind = values.iter_mut().rev();
    let Some(mut last) = behind.next() else {
        return;
    };
    for other in behind {
        if *other >= *last {
            return;
        }
        core::mem::swap(other, last);
        last = other;
    }
}
