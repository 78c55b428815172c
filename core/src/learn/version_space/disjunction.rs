//! The search for disjunctions of two bounds, for what no single bound can say.
//!
//! Two bounds of one form exclude an interval of its values. Bounds of two forms
//! make a feasible set of two pieces: a conjunction of such clauses is a union
//! of conjunctions, with what they have in common said once. And several intervals of one
//! form make as many windows, as the sides of a nut that a hand can take it by.

use super::bound::Bound;
use super::clause::Clause;
use super::forms::{DirectedForm, SampleSet, StepView};
use super::greedy::Randomisation;
use super::hypothesis::MAX_CLAUSES;
use super::tuning::Tuning;
use crate::real::Real;
use crate::table::{gather, move_last, take_out};
use heapless::Vec;

/// Room for [`Tuning::beam`].
const MAX_BEAM: usize = 24;
/// Room for [`Tuning::interval_starts`].
const MAX_STARTS: usize = 4;

/// The disjunction that excludes most of `open` for its length, with what that is worth: the
/// one that is known, or one that excludes a certain sample. There are a few of these, which
/// are counted twice: first for intervals, then for pairs. `None` if there are no more.
#[inline(never)]
pub(super) fn better_disjunction<R: Real>(
    view: &StepView<'_, '_, R>,
    open: &SampleSet,
    place: usize,
    known: Option<(f64, Clause<R>)>,
) -> Option<Option<(f64, Clause<R>)>> {
    let mut best = Best(known.map(|(worth, clause)| Candidate { worth, clause }));
    let pivots = view.forms.tuning().pivots as usize;
    let every = open.len().div_ceil(pivots.max(1)).max(1);
    let pivot = open.iter().nth(place / 2 * every)?;
    let search = Search { view, open, pivot };
    if place.is_multiple_of(2) {
        search.offer_intervals(&mut best);
    } else if let Some(start) = search.pair().0 {
        search.offer_polished(&start, &mut best);
    }
    Some(best.0.map(|Candidate { worth, clause }| (worth, clause)))
}

/// Most intervals of a form that are looked at.
const MAX_INTERVALS: usize = 24;
/// Fewer samples in an interval between others are no reason for it.
const FEWEST_INSIDE: usize = 2;

/// The bounds and excluded intervals of a single simple form that exclude most of `open`.
#[inline(never)]
pub(super) fn best_windows<R: Real>(
    view: &StepView<'_, '_, R>,
    open: &SampleSet,
) -> Vec<Clause<R>, MAX_CLAUSES> {
    let tuning = view.forms.tuning();
    let (mut best, mut most) = (Vec::new(), 0.0);
    view.forms.for_each(tuning.pair_level as u8, |form| {
        if !form.upper() {
            return;
        }
        let mut windows: Vec<(usize, Clause<R>), MAX_CLAUSES> = Vec::new();
        let mut open = *open;
        for _ in 0..MAX_INTERVALS {
            let Some(pivot) = open.iter().next() else {
                break;
            };
            let window = excluded_around(view, form, pivot, &mut open);
            if let Some(window) = window {
                insert_sorted(&mut windows, MAX_CLAUSES, window, |a, b| a.0 > b.0);
            }
        }
        let excluded: usize = windows.iter().map(|(count, _)| count).sum();
        let discount = Randomisation::GREEDY.discount(form.level, tuning);
        let worth = excluded as f64 * (1.0 - discount);
        if worth > most {
            (best, most) = (gather(windows.iter().map(|(_, clause)| *clause)), worth);
        }
    });
    best
}

/// The clause that excludes the values of a form around a sample at which nothing works, and
/// how many samples of `open` it takes out of that.
fn excluded_around<R: Real>(
    view: &StepView<'_, '_, R>,
    below: DirectedForm,
    pivot: usize,
    open: &mut SampleSet,
) -> Option<(usize, Clause<R>)> {
    let values = view.column(&below);
    let gap = Gap::around(view, below, pivot);
    let mut inside = SampleSet::EMPTY;
    inside.insert(pivot);
    for sample in open.iter().filter(|s| gap.contains(values.at(*s))) {
        inside.insert(sample);
    }
    open.subtract(&inside);
    let count = inside.len();
    let clause = match (gap.low.is_finite(), gap.high.is_finite()) {
        _ if !gap.contains(gap.at) => return None,
        (false, false) => return None,
        (true, false) => Clause::new(Bound::inside(view, below)),
        (false, true) => Clause::new(Bound::inside(view, below.reversed())),
        (true, true) if count < FEWEST_INSIDE => return None,
        (true, true) => gap.outside(),
    };
    Some((count, clause))
}

/// The values of a form around that of a certain sample, up to the next ones at which
/// something works.
struct Gap<R> {
    /// The form, bounded from above.
    below: DirectedForm,
    /// The value of the sample.
    at: R,
    /// The next value below it.
    low: R,
    /// The next value that is not below it.
    high: R,
}

impl<R: Real> Gap<R> {
    fn around(view: &StepView<'_, '_, R>, below: DirectedForm, sample: usize) -> Gap<R> {
        let values = view.column(&below);
        let at = values.at(sample);
        let (mut low, mut high) = (R::NEG_INFINITY, R::INFINITY);
        for value in values.of_all(&view.feasible) {
            if value < at {
                low = low.max(value);
            } else {
                high = high.min(value);
            }
        }
        Gap {
            below,
            at,
            low,
            high,
        }
    }

    fn contains(&self, value: R) -> bool {
        self.low < value && value < self.high
    }

    /// The clause that excludes it, where it has two ends.
    fn outside(&self) -> Clause<R> {
        Clause::any_of(
            Bound::new(self.below, self.low, self.at, R::ONE),
            Bound::new(self.below.reversed(), -self.high, -self.at, R::ONE),
        )
    }
}

/// A clause and what it is worth.
#[derive(Clone, Copy)]
struct Candidate<R> {
    worth: f64,
    clause: Clause<R>,
}

/// The first of the clauses that are worth most.
struct Best<R>(Option<Candidate<R>>);

impl<R> Default for Best<R> {
    fn default() -> Self {
        Best(None)
    }
}

impl<R: Real> Best<R> {
    fn offer(&mut self, new: Candidate<R>) {
        if self.0.as_ref().is_none_or(|best| new.worth > best.worth) {
            self.0 = Some(new);
        }
    }
}

/// The search for a clause that excludes a certain sample.
struct Search<'s, 'v, 'm, R> {
    view: &'s StepView<'v, 'm, R>,
    /// What is to be excluded.
    open: &'s SampleSet,
    /// Among that, the sample that the clause excludes in any case.
    pivot: usize,
}

impl<R: Real> Search<'_, '_, '_, R> {
    fn tuning(&self) -> &'static Tuning {
        self.view.forms.tuning()
    }

    /// A clause that excludes so many: worth more with simple forms, and with one.
    fn rate(&self, clause: Clause<R>, excluded: usize) -> Candidate<R> {
        let tuning = self.tuning();
        let discount = |bound: &Bound<R>| Randomisation::GREEDY.discount(bound.form.level, tuning);
        let first = &clause.bound;
        let second = clause.or.filter(|or| or.form.index() != first.form.index());
        let second = second.map_or(0.0, |or| tuning.discount_second + discount(&or));
        let plainness = tuning.disjunction_plainness;
        Candidate {
            worth: excluded as f64 * (1.0 - plainness * (discount(first) + second)),
            clause,
        }
    }

    /// Offers, for some left sides, what is near the clause without an interval of
    /// values around the pivot in which nothing works.
    #[inline(never)]
    fn offer_intervals(&self, all: &mut Best<R>) {
        let starts = self.tuning().interval_starts as usize;
        let mut best: Vec<Candidate<R>, MAX_STARTS> = Vec::new();
        self.view.forms.for_each(u8::MAX, |below| {
            let Some(new) = below.upper().then(|| self.interval(below)).flatten() else {
                return;
            };
            let same = |old: &Candidate<R>| old.clause.bound.form.lhs == below.lhs;
            if let Some(own) = best.iter().position(same) {
                if best.get(own).is_some_and(|old| old.worth >= new.worth) {
                    return;
                }
                take_out(&mut best, own);
            }
            insert_sorted(&mut best, starts, new, |a, b| a.worth > b.worth);
        });
        for start in &best {
            self.offer_polished(start, all);
        }
    }

    /// The clause that excludes the interval of a form around the pivot.
    fn interval(&self, below: DirectedForm) -> Option<Candidate<R>> {
        self.view.note_look();
        let gap = Gap::around(self.view, below, self.pivot);
        if !(gap.low.is_finite() && gap.high.is_finite() && gap.contains(gap.at)) {
            return None;
        }
        let values = self.view.column(&below);
        let inside = values.of_all(self.open).filter(|v| gap.contains(*v));
        Some(self.rate(gap.outside(), inside.count()))
    }

    /// Two bounds of simple forms, neither of which the pivot satisfies, and one of
    /// which every feasible sample does.
    fn pair(&self) -> Best<R> {
        let mut best = Best::default();
        for first in self.promising().iter().copied() {
            let level = self.tuning().pair_level as u8;
            self.view.forms.for_each(level, |second| {
                if let Some(new) = self.candidate([first, second]) {
                    best.offer(new);
                }
            });
        }
        best
    }

    #[inline(never)]
    fn candidate(&self, forms: [DirectedForm; 2]) -> Option<Candidate<R>> {
        let [first, second] = forms;
        let columns = [self.view.column(&first), self.view.column(&second)];
        self.view.note_look();
        let [own, other] = &columns;
        let at = [own.at(self.pivot), other.at(self.pivot)];
        let corner = self.view.corner([&first, &second], at);
        let [inner, or] = corner.filter(|c| c.iter().all(|end| end.is_finite()))?;
        let beyond = |s: &usize| own.at(*s) > inner && other.at(*s) > or;
        let excluded = self.open.iter().filter(beyond).count();
        let [start, or_start] = at;
        let clause = Clause::any_of(
            Bound::new(first, inner, start, R::ONE),
            Bound::new(second, or, or_start, R::ONE),
        );
        Some(self.rate(clause, excluded))
    }

    /// Tries other right sides of any level, for one bound after the other, and offers
    /// the best.
    #[inline(never)]
    fn offer_polished(&self, start: &Candidate<R>, all: &mut Best<R>) {
        let mut best = Best(Some(*start));
        let mut polished = *start;
        for _ in 0..self.tuning().polish_rounds {
            let forms = self.view.forms;
            polished.clause.for_each_neighbour(forms, |forms| {
                if let Some(new) = self.candidate(forms) {
                    best.offer(new);
                }
            });
            polished = best.0.unwrap_or(polished);
        }
        all.offer(polished);
    }

    /// The bounds that split the feasible samples and leave most others outside.
    fn promising(&self) -> Vec<DirectedForm, MAX_BEAM> {
        let (beam, level) = (self.tuning().beam as usize, self.tuning().pair_level as u8);
        let mut best: Vec<(usize, DirectedForm), MAX_BEAM> = Vec::new();
        let feasible = &self.view.feasible;
        let all = feasible.len();
        self.view.forms.for_each(level, |form| {
            let values = self.view.column(&form);
            let start = values.at(self.pivot);
            let inside = values.of_all(feasible).filter(|v| *v < start).count();
            if inside == 0 || inside == all {
                return;
            }
            let outside = values.of_all(self.open).filter(|v| *v >= start).count();
            insert_sorted(&mut best, beam, (inside * outside, form), |a, b| a.0 > b.0);
        });
        gather(best.iter().map(|(_, form)| *form))
    }
}

/// Inserts before what is worse, if there are fewer than `most` or the last is worse.
fn insert_sorted<T, const N: usize>(
    sorted: &mut Vec<T, N>,
    most: usize,
    new: T,
    better: impl Fn(&T, &T) -> bool,
) {
    let place = sorted.iter().position(|other| better(&new, other));
    let place = place.unwrap_or(sorted.len());
    if sorted.len() >= most.min(N) {
        if place >= sorted.len() {
            return;
        }
        sorted.pop();
    }
    if sorted.push(new).is_ok() {
        move_last(sorted, place);
    }
}
