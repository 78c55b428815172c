//! Explanations: few simple forms that together exclude every infeasible sample.
//!
//! Fewest is set cover, for which the greedy choice is the best known (Chvatal
//! 1979; Haussler 1988 for conjunctions, and Marchand and Shawe-Taylor's set
//! covering machine). Simple forms are preferred to slightly better ones, and
//! chance tells the members of a committee apart.

use super::forms::{Forms, MAX_WORDS, Set, Side};
use super::greedy::{Taste, best_side};
use crate::random::Generator;
use crate::real::Real;
use heapless::Vec;
use rand_core::Rng;

/// Most steps of a sequence of actions.
pub(super) const MAX_STEPS: usize = 4;
/// Most constraints for one step.
pub(super) const MAX_COVER: usize = 6;
/// Explanations of one step that vote.
pub(super) const MEMBERS: usize = 8;
/// What a right side costs, in constraints: two constraints without one are simpler
/// than one that compares two distances.
const PRICE: [f64; 4] = [0.0, 0.5, 1.1, 1.2];
/// How close to a bound an infeasible sample needs no explanation, as a share of
/// what the form ranges over.
const SOFT: f64 = 0.05;
/// As that, per feasible sample that is ignored.
pub(super) const PRICE_OF_IGNORING: f64 = 0.06;

/// A form with its bounds, outwards: feasible up to `inner`, infeasible from
/// `outer`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Chosen<R> {
    pub(super) side: Side,
    pub(super) inner: R,
    pub(super) outer: R,
    /// How many infeasible samples it excludes.
    pub(super) support: u32,
    /// How many feasible samples lie beyond the outer bound.
    pub(super) ignored: u32,
    /// How far the form ranges over the samples.
    pub(super) range: R,
}

impl<R: Real> Chosen<R> {
    /// What it costs: being one, its right side, and the feasible samples that it
    /// ignores.
    pub(super) fn price(&self) -> f64 {
        1.0 + at_level(PRICE, self.side.level) + PRICE_OF_IGNORING * f64::from(self.ignored)
    }

    /// Finds the inner bound below the outer one, and moves both where samples just
    /// inside are excused: to where fewest samples are on the wrong side.
    fn settle(&mut self, forms: &Forms<'_, R>, step: usize) {
        (self.inner, self.ignored) = last_inside(forms, &self.side, step, self.outer);
        let excused = forms.excused(step);
        if is_empty(&excused) {
            return;
        }
        let zone = self.inner - self.range * R::from_f64(SOFT);
        let (end, form) = (self.outer, self.side);
        let values = || members(&excused).map(|sample| forms.value_at(&form, sample));
        let inside = |outer: R| values().filter(|v| zone < *v && *v < outer).count() as u32;
        let mut least = self.ignored + inside(end);
        for outer in values().filter(|v| zone < *v && *v < end) {
            let (inner, ignored) = last_inside(forms, &form, step, outer);
            let wrong = ignored + inside(outer);
            if wrong < least || (wrong == least && outer < self.outer) {
                least = wrong;
                (self.inner, self.outer, self.ignored) = (inner, outer, ignored);
            }
        }
    }

    /// A position between the two bounds: zero at the inner, one at the outer.
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

/// An explanation of one step's infeasible samples.
#[derive(Clone, Debug)]
pub struct Cover<R> {
    pub(super) chosen: Vec<Chosen<R>, MAX_COVER>,
    /// Whether it excludes all of them.
    pub(super) complete: bool,
}

impl<R> Default for Cover<R> {
    /// The explanation of nothing.
    fn default() -> Self {
        Cover {
            chosen: Vec::new(),
            complete: true,
        }
    }
}

impl<R: Real> Cover<R> {
    /// Whether it still explains everything.
    pub(super) fn holds(&self, forms: &Forms<'_, R>, wanted: &Set) -> bool {
        let mut left = *wanted;
        for chosen in &self.chosen {
            remove(&mut left, &forms.excluded(&chosen.side));
        }
        is_empty(&left)
    }

    /// A cover by greedy choice.
    pub(super) fn greedy(
        forms: &Forms<'_, R>,
        step: usize,
        taste: Taste,
        rng: &mut Generator,
    ) -> Cover<R> {
        let wanted = forms.infeasible(step);
        let mut left = wanted;
        let mut cover = Cover {
            chosen: Vec::new(),
            complete: false,
        };
        while !is_empty(&left) && !cover.chosen.is_full() {
            let Some(side) = best_side(forms, &left, step, taste, rng.next_u32()) else {
                break;
            };
            remove(&mut left, &forms.excluded(&side));
            let _ = cover.chosen.push(Chosen {
                side,
                inner: R::ZERO,
                outer: R::ZERO,
                support: 0,
                ignored: 0,
                range: R::ZERO,
            });
        }
        cover.complete = is_empty(&left);
        cover.drop_redundant(forms, &wanted);
        cover.measure(forms, step);
        cover
    }

    fn drop_redundant(&mut self, forms: &Forms<'_, R>, wanted: &Set) {
        if !self.complete {
            return;
        }
        for index in 0..self.chosen.len() {
            let mut left = *wanted;
            for (other, chosen) in self.chosen.iter().enumerate() {
                if other != index {
                    remove(&mut left, &forms.excluded(&chosen.side));
                }
            }
            if is_empty(&left) {
                let mut at = 0;
                self.chosen.retain(|_| {
                    at += 1;
                    at - 1 != index
                });
                return self.drop_redundant(forms, wanted);
            }
        }
    }

    /// The infeasible samples that more than one form excludes.
    fn shared(&self, forms: &Forms<'_, R>) -> Set {
        let (mut once, mut twice): (Set, Set) = ([0; MAX_WORDS], [0; MAX_WORDS]);
        for chosen in &self.chosen {
            let own = forms.excluded(&chosen.side);
            for ((own, once), twice) in own.iter().zip(&mut once).zip(&mut twice) {
                *twice |= *once & own;
                *once |= own;
            }
        }
        twice
    }

    /// The infeasible samples of a step that only this form excludes.
    fn alone(&self, forms: &Forms<'_, R>, step: usize, side: &Side) -> Set {
        let mut alone = forms.excluded(side);
        intersect(&mut alone, &forms.infeasible(step));
        remove(&mut alone, &self.shared(forms));
        alone
    }

    /// Infeasible samples so few and so close to the bounds of other constraints
    /// that a constraint of their own is not worth it.
    pub(super) fn excusable(&self, forms: &Forms<'_, R>, step: usize, most: usize) -> Option<Set> {
        let sets = self
            .chosen
            .iter()
            .map(|c| (c, self.alone(forms, step, &c.side)));
        let mut few = sets.filter(|(_, set)| (1..=most).contains(&members(set).count()));
        few.find_map(|(chosen, set)| {
            let near = |sample: usize| {
                let mut others = self.chosen.iter().filter(|c| c.side != chosen.side);
                others.any(|c| {
                    let inside = c.inner - forms.value_at(&c.side, sample);
                    inside <= c.range * R::from_f64(SOFT)
                })
            };
            members(&set).all(near).then_some(set)
        })
    }

    /// Replaces forms by better ones that exclude the same, as `price` says.
    pub(super) fn improve(
        &mut self,
        forms: &Forms<'_, R>,
        step: usize,
        price: impl Fn(&Chosen<R>) -> f64,
    ) {
        for index in 0..self.chosen.len() {
            let Some(old) = self.chosen.get(index).copied() else {
                return;
            };
            let alone = self.alone(forms, step, &old.side);
            let needed = members(&alone).count();
            let (mut best, mut least) = (old, price(&old));
            forms.for_each_count(&alone, |side, count| {
                if (count as usize) < needed {
                    return;
                }
                let mut new = Chosen { side, ..old };
                new.outer = first_outside(forms, &side, &alone);
                (new.inner, new.ignored) = last_inside(forms, &side, step, new.outer);
                new.range = range(forms, &side, step);
                let cost = price(&new);
                if cost < least - 1e-9 {
                    (best, least) = (new, cost);
                }
            });
            if let Some(slot) = self.chosen.get_mut(index) {
                *slot = best;
            }
        }
        self.measure(forms, step);
    }

    /// Brings the bounds up to date. The outer one is at the first infeasible
    /// sample that no other form excludes.
    pub(super) fn measure(&mut self, forms: &Forms<'_, R>, step: usize) {
        let wanted = forms.infeasible(step);
        let twice = self.shared(forms);
        for chosen in &mut self.chosen {
            let mut own = forms.excluded(&chosen.side);
            intersect(&mut own, &wanted);
            let mut alone = own;
            remove(&mut alone, &twice);
            chosen.support = members(&own).count() as u32;
            chosen.outer = first_outside(forms, &chosen.side, &alone);
            chosen.range = range(forms, &chosen.side, step);
            chosen.settle(forms, step);
        }
        let mut shared = wanted;
        intersect(&mut shared, &twice);
        for sample in members(&shared) {
            self.own(forms, step, sample);
        }
    }

    /// Makes sure that one form excludes a sample for every threshold between its
    /// bounds: that for which it lies farthest out.
    fn own(&mut self, forms: &Forms<'_, R>, step: usize, sample: usize) {
        let mut farthest: Option<(R, &mut Chosen<R>)> = None;
        for chosen in &mut self.chosen {
            let value = forms.value_at(&chosen.side, sample);
            if value >= chosen.outer {
                return;
            }
            let depth = (value - chosen.inner) / chosen.range;
            if farthest.as_ref().is_none_or(|(most, _)| depth > *most) {
                farthest = Some((depth, chosen));
            }
        }
        if let Some((_, chosen)) = farthest {
            chosen.outer = forms.value_at(&chosen.side, sample);
            chosen.settle(forms, step);
        }
    }

    /// How complicated it is.
    pub(super) fn price(&self) -> f64 {
        self.chosen.iter().map(Chosen::price).sum()
    }

    /// The width of all gaps together.
    pub(super) fn looseness(&self) -> R {
        let gaps = self.chosen.iter().map(|c| c.outer - c.inner);
        gaps.fold(R::ZERO, |sum, gap| sum + gap)
    }
}

pub(super) fn at_level(list: [f64; 4], level: u8) -> f64 {
    list.get(usize::from(level)).copied().unwrap_or(0.0)
}

pub(super) fn first_outside<R: Real>(forms: &Forms<'_, R>, side: &Side, set: &Set) -> R {
    let values = members(set).map(|negative| forms.value_at(side, negative));
    values.fold(R::INFINITY, |least, value| least.min(value))
}

/// The largest value at a feasible sample below `outer`, and how many such samples
/// are not below it.
pub(super) fn last_inside<R: Real>(
    forms: &Forms<'_, R>,
    side: &Side,
    step: usize,
    outer: R,
) -> (R, u32) {
    let feasible = forms.feasible(step);
    let values = members(&feasible).map(|sample| forms.value_at(side, sample));
    values.fold((-R::INFINITY, 0), |(inner, ignored), value| {
        if value < outer {
            (inner.max(value), ignored)
        } else {
            (inner, ignored + 1)
        }
    })
}

fn range<R: Real>(forms: &Forms<'_, R>, side: &Side, step: usize) -> R {
    let (feasible, infeasible) = (forms.feasible(step), forms.infeasible(step));
    let samples = members(&feasible).chain(members(&infeasible));
    let ends = samples.fold((R::INFINITY, -R::INFINITY), |(low, high), sample| {
        let value = forms.value_at(side, sample);
        (low.min(value), high.max(value))
    });
    ends.1 - ends.0
}

pub(super) fn is_empty(set: &Set) -> bool {
    set.iter().all(|word| *word == 0)
}

pub(super) fn remove(from: &mut Set, what: &Set) {
    for (word, other) in from.iter_mut().zip(what) {
        *word &= !other;
    }
}

pub(super) fn intersect(set: &mut Set, with: &Set) {
    for (word, other) in set.iter_mut().zip(with) {
        *word &= other;
    }
}

/// The members of a set, ascending.
pub(super) fn members(set: &Set) -> impl Iterator<Item = usize> + '_ {
    set.iter().enumerate().flat_map(|(index, word)| {
        let mut left = *word;
        core::iter::from_fn(move || {
            let next = left.trailing_zeros();
            left &= left.wrapping_sub(1);
            (next < u64::BITS).then_some(64 * index + next as usize)
        })
    })
}
