//! Constraints of two bounds, one of which must hold: for what no single bound can
//! say.
//!
//! Two bounds of one form exclude an interval of its values. Bounds of two forms
//! make a feasible set of two pieces: a conjunction of such constraints is a union
//! of conjunctions, with what they have in common said once.

use super::bound::Bound;
use super::cover::Chosen;
use super::forms::{Forms, Set, Side};
use super::greedy::Taste;
use super::set::{count, members};
use crate::real::Real;
use crate::table::{gather, move_last};
use heapless::Vec;

/// Samples that are tried to be excluded, each with all forms.
const PIVOTS: usize = 3;
/// First bounds for which a second one is looked for.
const BEAM: usize = 24;
/// By how much the count of a constraint with two forms is reduced.
const SECOND_FORM: f64 = 0.1;
/// Most complex right sides of two bounds of different forms.
const LEVEL: u8 = 1;

/// The constraint of two bounds that excludes most of `left` for its length.
pub(super) fn best_clause<R: Real>(
    forms: &Forms<'_, R>,
    left: &Set,
    step: usize,
) -> Option<Chosen<R>> {
    let mut best: Option<(f64, Chosen<R>)> = None;
    let all = count(left);
    for pivot in members(left).step_by(all.div_ceil(PIVOTS).max(1)) {
        let around = interval_around(forms, left, step, pivot);
        let found = around
            .into_iter()
            .chain(pair_against(forms, left, step, pivot));
        for (worth, chosen) in found {
            if best.as_ref().is_none_or(|(most, _)| worth > *most) {
                best = Some((worth, chosen));
            }
        }
    }
    best.map(|(_, chosen)| chosen)
}

/// How much is excluded, with a preference for simple forms, and for one of them.
fn worth<R: Real>(chosen: &Chosen<R>, excluded: usize) -> f64 {
    let reduction = |bound: &Bound<R>| Taste::SOBER.reduction(bound.side.level);
    let second = chosen
        .or
        .filter(|or| or.side.form != chosen.bound.side.form);
    let second = second.map_or(0.0, |or| SECOND_FORM + reduction(&or));
    excluded as f64 * (1.0 - 0.5 * (reduction(&chosen.bound) + second))
}

/// The constraint without an interval of values of a form around a sample, in which
/// nothing works.
fn interval_around<R: Real>(
    forms: &Forms<'_, R>,
    left: &Set,
    step: usize,
    pivot: usize,
) -> Option<(f64, Chosen<R>)> {
    let feasible = forms.feasible(step);
    let mut best: Option<(f64, Chosen<R>)> = None;
    forms.for_each_side(u8::MAX, |below| {
        if !below.upper {
            return;
        }
        let value = |sample: usize| forms.value_at(&below, sample);
        let at = value(pivot);
        let (mut low, mut high) = (-R::INFINITY, R::INFINITY);
        for value in members(&feasible).map(value) {
            if value < at {
                low = low.max(value);
            } else {
                high = high.min(value);
            }
        }
        if !(low.is_finite() && high.is_finite() && at < high) {
            return;
        }
        let inside = members(left).map(value);
        let excluded = inside.filter(|v| low < *v && *v < high).count();
        let above = Side {
            upper: false,
            ..below
        };
        let chosen = Chosen::any_of(bound(below, low, at), bound(above, -high, -at));
        let worth = worth(&chosen, excluded);
        if best.as_ref().is_none_or(|(most, _)| worth > *most) {
            best = Some((worth, chosen));
        }
    });
    best
}

/// Two bounds of different forms, neither of which a sample satisfies, and one of
/// which every feasible sample does.
fn pair_against<R: Real>(
    forms: &Forms<'_, R>,
    left: &Set,
    step: usize,
    pivot: usize,
) -> Option<(f64, Chosen<R>)> {
    let feasible = forms.feasible(step);
    let mut best: Option<(f64, Chosen<R>)> = None;
    for first in promising(forms, left, &feasible, pivot).iter().copied() {
        forms.for_each_side(LEVEL, |second| {
            let value = |side: &Side, sample| forms.value_at(side, sample);
            let at = [value(&first, pivot), value(&second, pivot)];
            let corner = corner(forms, &feasible, [&first, &second], at);
            let Some([inner, or]) = corner.filter(|c| c.iter().all(|end| end.is_finite())) else {
                return;
            };
            let beyond = |s: &usize| value(&first, *s) > inner && value(&second, *s) > or;
            let excluded = members(left).filter(beyond).count();
            let [start, or_start] = at;
            let chosen = Chosen::any_of(bound(first, inner, start), bound(second, or, or_start));
            let worth = worth(&chosen, excluded);
            if best.as_ref().is_none_or(|(most, _)| worth > *most) {
                best = Some((worth, chosen));
            }
        });
    }
    best
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

/// The bounds that split the feasible samples and leave most others outside.
fn promising<R: Real>(
    forms: &Forms<'_, R>,
    left: &Set,
    feasible: &Set,
    pivot: usize,
) -> Vec<Side, BEAM> {
    let mut best: Vec<(usize, Side), BEAM> = Vec::new();
    let all = count(feasible);
    forms.for_each_side(LEVEL, |side| {
        let start = forms.value_at(&side, pivot);
        let value = |sample: usize| forms.value_at(&side, sample);
        let inside = members(feasible).filter(|s| value(*s) < start).count();
        if inside == 0 || inside == all {
            return;
        }
        let outside = members(left).filter(|s| value(*s) >= start).count();
        let score = inside * outside;
        let place = best.iter().position(|(other, _)| score > *other);
        let place = place.unwrap_or(best.len());
        if best.is_full() && place < best.len() {
            best.pop();
        }
        if best.push((score, side)).is_ok() {
            move_last(&mut best, place);
        }
    });
    gather(best.iter().map(|(_, side)| *side))
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
