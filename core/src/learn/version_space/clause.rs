//! Constraints of two bounds, one of which must hold: for what no single bound can
//! say.
//!
//! Two bounds of one form exclude an interval of its values. Bounds of two forms
//! make a feasible set of two pieces: a conjunction of such constraints is a union
//! of conjunctions, with what they have in common said once.

use super::bound::Bound;
use super::chosen::{Chosen, first_of, range};
use super::forms::{Forms, Set, Side};
use super::greedy::Taste;
use super::set::{count, members};
use crate::real::Real;
use crate::table::{gather, move_last, take_out};
use heapless::Vec;

/// Samples that are tried to be excluded, each with all forms.
const PIVOTS: usize = 3;
/// First bounds for which a second one is looked for.
const BEAM: usize = 24;
/// Intervals, of different left sides, and how often other right sides of their two
/// bounds are looked for.
const STARTS: usize = 4;
const ROUNDS: usize = 2;
/// By how much the count of a constraint with two forms is reduced.
const SECOND_FORM: f64 = 0.1;
/// Most complex right sides that pairs of bounds begin with.
const LEVEL: u8 = 1;

/// The constraint of two bounds that excludes most of `left` for its length.
#[inline(never)]
pub(super) fn best_clause<R: Real>(
    forms: &Forms<'_, R>,
    left: &Set,
    step: usize,
) -> Option<Chosen<R>> {
    let feasible = &forms.feasible(step);
    let mut best = Best::default();
    let all = count(left);
    for pivot in members(left).step_by(all.div_ceil(PIVOTS).max(1)) {
        let search = Search {
            forms,
            feasible,
            left,
            pivot,
        };
        search.offer_intervals(&mut best);
        if let Some(start) = search.pair().0 {
            search.offer_polished(&start, &mut best);
        }
    }
    best.0.map(|candidate| candidate.chosen)
}

/// A constraint and what it is worth.
#[derive(Clone, Copy)]
struct Candidate<R> {
    worth: f64,
    chosen: Chosen<R>,
}

impl<R: Real> Candidate<R> {
    /// A constraint that excludes so many: worth more with simple forms, and with one.
    fn new(chosen: Chosen<R>, excluded: usize) -> Self {
        let reduction = |bound: &Bound<R>| Taste::SOBER.reduction(bound.side.level);
        let second = chosen
            .or
            .filter(|or| or.side.form != chosen.bound.side.form);
        let second = second.map_or(0.0, |or| SECOND_FORM + reduction(&or));
        Candidate {
            worth: excluded as f64 * (1.0 - 0.5 * (reduction(&chosen.bound) + second)),
            chosen,
        }
    }
}

/// The first of the constraints that are worth most.
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

/// The search for a constraint that excludes a certain sample.
struct Search<'s, 'm, R> {
    forms: &'s Forms<'m, R>,
    feasible: &'s Set,
    /// What is to be excluded.
    left: &'s Set,
    pivot: usize,
}

impl<R: Real> Search<'_, '_, R> {
    /// Offers, for some left sides, what is near the constraint without an interval of
    /// values around the pivot in which nothing works.
    #[inline(never)]
    fn offer_intervals(&self, all: &mut Best<R>) {
        let mut best: Vec<Candidate<R>, STARTS> = Vec::new();
        self.forms.for_each_side(u8::MAX, |below| {
            let Some(new) = below.upper.then(|| self.interval(below)).flatten() else {
                return;
            };
            let same = |old: &Candidate<R>| old.chosen.bound.side.left == below.left;
            if let Some(own) = best.iter().position(same) {
                if best.get(own).is_some_and(|old| old.worth >= new.worth) {
                    return;
                }
                take_out(&mut best, own);
            }
            insert_sorted(&mut best, new, |a, b| a.worth > b.worth);
        });
        for start in &best {
            self.offer_polished(start, all);
        }
    }

    fn interval(&self, below: Side) -> Option<Candidate<R>> {
        let value = |sample: usize| self.forms.value_at(&below, sample);
        let at = value(self.pivot);
        let (mut low, mut high) = (-R::INFINITY, R::INFINITY);
        for value in members(self.feasible).map(value) {
            if value < at {
                low = low.max(value);
            } else {
                high = high.min(value);
            }
        }
        if !(low.is_finite() && high.is_finite() && at < high) {
            return None;
        }
        let inside = members(self.left).map(value);
        let excluded = inside.filter(|v| low < *v && *v < high).count();
        let above = Side {
            upper: false,
            ..below
        };
        let chosen = Chosen::any_of(bound(below, low, at), bound(above, -high, -at));
        Some(Candidate::new(chosen, excluded))
    }

    /// Two bounds of simple forms, neither of which the pivot satisfies, and one of
    /// which every feasible sample does.
    fn pair(&self) -> Best<R> {
        let mut best = Best::default();
        for first in self.promising().iter().copied() {
            self.forms.for_each_side(LEVEL, |second| {
                if let Some(new) = self.candidate([first, second]) {
                    best.offer(new);
                }
            });
        }
        best
    }

    #[inline(never)]
    fn candidate(&self, sides: [Side; 2]) -> Option<Candidate<R>> {
        let [first, second] = sides;
        let value = |side: &Side, sample| self.forms.value_at(side, sample);
        let at = [value(&first, self.pivot), value(&second, self.pivot)];
        let corner = corner(self.forms, self.feasible, [&first, &second], at);
        let [inner, or] = corner.filter(|c| c.iter().all(|end| end.is_finite()))?;
        let beyond = |s: &usize| value(&first, *s) > inner && value(&second, *s) > or;
        let excluded = members(self.left).filter(beyond).count();
        let [start, or_start] = at;
        let chosen = Chosen::any_of(bound(first, inner, start), bound(second, or, or_start));
        Some(Candidate::new(chosen, excluded))
    }

    /// Tries other right sides of any level, for one bound after the other, and offers
    /// the best.
    #[inline(never)]
    fn offer_polished(&self, start: &Candidate<R>, all: &mut Best<R>) {
        let mut best = Best(Some(*start));
        let mut polished = *start;
        for _ in 0..ROUNDS {
            for_each_neighbour(self.forms, &polished.chosen, |sides| {
                if let Some(new) = self.candidate(sides) {
                    best.offer(new);
                }
            });
            polished = best.0.unwrap_or(polished);
        }
        all.offer(polished);
    }

    /// The bounds that split the feasible samples and leave most others outside.
    fn promising(&self) -> Vec<Side, BEAM> {
        let mut best: Vec<(usize, Side), BEAM> = Vec::new();
        let all = count(self.feasible);
        self.forms.for_each_side(LEVEL, |side| {
            let start = self.forms.value_at(&side, self.pivot);
            let value = |sample: usize| self.forms.value_at(&side, sample);
            let inside = members(self.feasible).filter(|s| value(*s) < start).count();
            if inside == 0 || inside == all {
                return;
            }
            let outside = members(self.left).filter(|s| value(*s) >= start).count();
            insert_sorted(&mut best, (inside * outside, side), |a, b| a.0 > b.0);
        });
        gather(best.iter().map(|(_, side)| *side))
    }
}

/// Inserts before what is worse, if there is room or the last is worse.
fn insert_sorted<T, const N: usize>(
    sorted: &mut Vec<T, N>,
    new: T,
    better: impl Fn(&T, &T) -> bool,
) {
    let place = sorted.iter().position(|other| better(&new, other));
    let place = place.unwrap_or(sorted.len());
    if sorted.is_full() && place < sorted.len() {
        sorted.pop();
    }
    if sorted.push(new).is_ok() {
        move_last(sorted, place);
    }
}

/// Calls `visit` with the sides of a constraint of two bounds, of which one has another
/// right side.
pub(super) fn for_each_neighbour<R: Real>(
    forms: &Forms<'_, R>,
    chosen: &Chosen<R>,
    mut visit: impl FnMut([Side; 2]),
) {
    let Some(or) = &chosen.or else { return };
    let (first, second) = (chosen.bound.side, or.side);
    forms.for_each_right(&first, |other| visit([other, second]));
    forms.for_each_right(&second, |other| visit([first, other]));
}

/// The constraint of two bounds that excludes `own` and nothing that works.
pub(super) fn between<R: Real>(
    forms: &Forms<'_, R>,
    step: usize,
    sides: [Side; 2],
    own: &Set,
) -> Option<Chosen<R>> {
    let [first, second] = sides;
    let ends = [first_of(forms, &first, own), first_of(forms, &second, own)];
    let corner = corner(forms, &forms.feasible(step), [&first, &second], ends);
    let [inner, or_inner] = corner.filter(|c| c.iter().all(|end| end.is_finite()))?;
    let [outer, or_outer] = ends;
    let mut chosen = Chosen::any_of(
        bound(first, inner, outer),
        bound(second, or_inner, or_outer),
    );
    for bound in chosen.bounds_mut() {
        bound.range = range(forms, &bound.side, step);
    }
    Some(chosen)
}

/// How far two bounds reach, of which each of these samples satisfies one; `None` if
/// one is beyond both ends of `at`. A sample that may satisfy either widens the one
/// that it is nearer to.
pub(super) fn corner<R: Real>(
    forms: &Forms<'_, R>,
    feasible: &Set,
    sides: [&Side; 2],
    at: [R; 2],
) -> Option<[R; 2]> {
    let [first, second] = sides;
    let [end, or_end] = at;
    let values = || {
        let value = |side: &Side, sample| forms.value_at(side, sample);
        members(feasible).map(move |sample| (value(first, sample), value(second, sample)))
    };
    let (mut inner, mut or) = (-R::INFINITY, -R::INFINITY);
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

fn bound<R: Real>(side: Side, inner: R, outer: R) -> Bound<R> {
    Bound {
        side,
        inner,
        outer,
        range: R::ONE,
        strain: R::ZERO,
    }
}
