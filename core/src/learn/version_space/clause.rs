//! Constraints of two bounds, one of which must hold: for what no single bound can
//! say.
//!
//! Two bounds of one form exclude an interval of its values. Bounds of two forms
//! make a feasible set of two pieces: a conjunction of such constraints is a union
//! of conjunctions, with what they have in common said once.

use super::bound::Bound;
use super::cover::{Chosen, first_of};
use super::forms::{Forms, MAX_WORDS, Set, Side};
use super::set::{count, insert, members};
use crate::real::Real;
use heapless::Vec;

/// Samples that are tried to be excluded, each with all forms.
const PIVOTS: usize = 3;
/// First bounds for which a second one is looked for.
const BEAM: usize = 24;
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

/// How much is excluded per bit.
fn worth<R: Real>(forms: &Forms<'_, R>, chosen: &Chosen<R>, excluded: usize) -> f64 {
    excluded as f64 / chosen.bits(forms, &[])
}

/// The widest interval of values of a form around a sample in which nothing works.
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
        let inside = members(left).map(value).filter(|v| low < *v && *v < high);
        let excluded = inside.count();
        let above = Side {
            upper: false,
            ..below
        };
        let mut chosen = Chosen::new(bound(below, low, at));
        chosen.or = Some(bound(above, -high, -at));
        let worth = worth(forms, &chosen, excluded);
        if best.as_ref().is_none_or(|(most, _)| worth > *most) {
            best = Some((worth, chosen));
        }
    });
    let (worth, mut chosen) = best?;
    let mut own = [0; MAX_WORDS];
    let (low, high) = (chosen.bound.inner, -chosen.or?.inner);
    for sample in members(left) {
        let value = forms.value_at(&chosen.bound.side, sample);
        if low < value && value < high {
            insert(&mut own, sample);
        }
    }
    close(forms, &mut chosen, &own);
    Some((worth, chosen))
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
    let mut best: Option<(f64, Chosen<R>, Set)> = None;
    for first in promising(forms, left, &feasible, pivot) {
        let start = forms.value_at(&first, pivot);
        let mut inner = -R::INFINITY;
        let mut others = [0; MAX_WORDS];
        for sample in members(&feasible) {
            let value = forms.value_at(&first, sample);
            if value < start {
                inner = inner.max(value);
            } else {
                insert(&mut others, sample);
            }
        }
        let mut beyond = [0; MAX_WORDS];
        let outside = members(left).filter(|s| forms.value_at(&first, *s) > inner);
        outside.for_each(|sample| insert(&mut beyond, sample));
        forms.for_each_side(LEVEL, |second| {
            let value = |sample: usize| forms.value_at(&second, sample);
            let at = value(pivot);
            let mut last = -R::INFINITY;
            for value in members(&others).map(value) {
                if value >= at {
                    return;
                }
                last = last.max(value);
            }
            if !last.is_finite() {
                return;
            }
            let mut chosen = Chosen::new(bound(first, inner, start));
            chosen.or = Some(bound(second, last, at));
            let excluded = members(&beyond).map(value).filter(|v| *v > last).count();
            let worth = worth(forms, &chosen, excluded);
            if best.as_ref().is_none_or(|(most, ..)| worth > *most) {
                best = Some((worth, chosen, beyond));
            }
        });
    }
    let (worth, mut chosen, mut own) = best?;
    let or = chosen.or?;
    for sample in members(&own.clone()) {
        if forms.value_at(&or.side, sample) <= or.inner
            && let Some(word) = own.get_mut(sample / 64)
        {
            *word &= !(1 << (sample % 64));
        }
    }
    close(forms, &mut chosen, &own);
    Some((worth, chosen))
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
        if place <= best.len() {
            let _ = best.insert(place, (score, side));
        }
    });
    best.into_iter().map(|(_, side)| side).collect()
}

fn bound<R: Real>(side: Side, inner: R, outer: R) -> Bound<R> {
    Bound {
        side,
        inner,
        outer,
        range: R::ONE,
        strain: 0.0,
    }
}

/// Moves the outer ends to the first samples that must be excluded.
fn close<R: Real>(forms: &Forms<'_, R>, chosen: &mut Chosen<R>, own: &Set) {
    for bound in core::iter::once(&mut chosen.bound).chain(&mut chosen.or) {
        bound.outer = first_of(forms, &bound.side, own);
    }
}
