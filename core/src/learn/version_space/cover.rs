//! Explanations: few simple forms that together exclude every infeasible sample.
//!
//! Fewest is set cover, for which the greedy choice is the best known (Chvatal
//! 1979; Haussler 1988 for conjunctions, and Marchand and Shawe-Taylor's set
//! covering machine). Which of several explanations is best is a matter of length:
//! that of its constraints and of what strays from them, in bits (minimum
//! description length, Rissanen 1978).

use super::bound::Bound;
use super::chosen::{Chosen, range};
use super::clause::{best_clause, between, for_each_neighbour};
use super::forms::{Forms, MAX_WORDS, Set};
use super::greedy::{Taste, best_side};
use super::set::{count, insert, is_empty, members, remove, unite};
use crate::random::Generator;
use crate::real::Real;
use crate::table::{move_last, take_out};
use heapless::Vec;
use rand_core::Rng;

/// Most steps of a sequence of actions.
pub(super) const MAX_STEPS: usize = 4;
/// Most constraints for one step.
pub(super) const MAX_COVER: usize = 6;
/// Explanations of one step that vote.
pub(super) const MEMBERS: usize = 8;
/// Share of what a form excludes that its replacement excludes at least.
const MOST: f64 = 0.6;
/// By how many bits an explanation must be shorter to replace another.
const SHORTER: f64 = 1e-6;

/// Which infeasible samples of a step constraints exclude together.
struct Overlap {
    /// At least one does.
    once: Set,
    /// More than one does.
    twice: Set,
    /// None does.
    open: Set,
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
    /// Makes it the explanation of nothing.
    pub(super) fn clear(&mut self) {
        self.chosen.clear();
        self.complete = true;
    }

    /// Makes it the same as another, where it lies.
    pub(super) fn copy_from(&mut self, other: &Self) {
        self.chosen.clear();
        // There is room: both have the same capacity.
        let _ = self.chosen.extend_from_slice(&other.chosen);
        self.complete = other.complete;
    }

    /// Makes it a cover by greedy choice of bounds.
    pub(super) fn choose(
        &mut self,
        forms: &Forms<'_, R>,
        step: usize,
        taste: Taste,
        slack: f64,
        rng: &mut Generator,
    ) {
        self.clear();
        self.extend(forms, step, taste, slack, rng);
    }

    /// As [`Cover::choose`], with a constraint of two bounds behind the first `simple`
    /// ones.
    #[inline(never)]
    pub(super) fn choose_with_clause(
        &mut self,
        forms: &Forms<'_, R>,
        step: usize,
        simple: usize,
        rng: &mut Generator,
    ) {
        self.choose(forms, step, Taste::SOBER, 0.0, rng);
        self.chosen.truncate(simple);
        let left = self.overlap(forms, step).open;
        if let Some(clause) = best_clause(forms, &left, step) {
            let _ = self.chosen.push(clause);
        }
        self.extend(forms, step, Taste::SOBER, 0.0, rng);
    }

    /// Adds constraints until everything is excluded.
    #[inline(never)]
    fn extend(
        &mut self,
        forms: &Forms<'_, R>,
        step: usize,
        taste: Taste,
        slack: f64,
        rng: &mut Generator,
    ) {
        let mut left = self.overlap(forms, step).open;
        while !is_empty(&left) && !self.chosen.is_full() {
            let Some(side) = best_side(forms, &left, step, taste, rng.next_u32()) else {
                break;
            };
            let chosen = Chosen::new(Bound::inside(forms, side, step));
            remove(&mut left, &chosen.excluded(forms, step));
            let _ = self.chosen.push(chosen);
        }
        self.drop_redundant(forms, step);
        self.measure(forms, step, slack);
    }

    fn drop_redundant(&mut self, forms: &Forms<'_, R>, step: usize) {
        let all = self.excluded(forms, step);
        for index in (0..self.chosen.len()).rev() {
            let Some(chosen) = take_out(&mut self.chosen, index) else {
                continue;
            };
            if self.excluded(forms, step) != all && self.chosen.push(chosen).is_ok() {
                move_last(&mut self.chosen, index);
            }
        }
    }

    /// What its constraints exclude whichever thresholds are true.
    fn excluded(&self, forms: &Forms<'_, R>, step: usize) -> Set {
        self.overlap(forms, step).once
    }

    /// What one constraint excludes at least, and what more than one does.
    fn overlap(&self, forms: &Forms<'_, R>, step: usize) -> Overlap {
        let (mut once, mut twice): (Set, Set) = ([0; MAX_WORDS], [0; MAX_WORDS]);
        for chosen in &self.chosen {
            let own = chosen.excluded(forms, step);
            for ((own, once), twice) in own.iter().zip(&mut once).zip(&mut twice) {
                *twice |= *once & own;
                *once |= own;
            }
        }
        let mut open = forms.infeasible(step);
        remove(&mut open, &once);
        Overlap { once, twice, open }
    }

    /// The infeasible samples that only this constraint can exclude: those that only
    /// it does, and those that none does but that are nearest to it.
    fn alone(
        &self,
        forms: &Forms<'_, R>,
        step: usize,
        (index, chosen): (usize, &Chosen<R>),
        overlap: &Overlap,
    ) -> Set {
        let mut alone = chosen.excluded(forms, step);
        remove(&mut alone, &overlap.twice);
        for sample in members(&overlap.open) {
            if self.nearest(forms, sample) == Some(index) {
                insert(&mut alone, sample);
            }
        }
        alone
    }

    /// The constraint that comes nearest to excluding a sample.
    fn nearest(&self, forms: &Forms<'_, R>, sample: usize) -> Option<usize> {
        let simple = self
            .chosen
            .iter()
            .enumerate()
            .filter(|(_, c)| c.or.is_none());
        let depths = simple.map(|(index, chosen)| {
            let bound = &chosen.bound;
            let value = forms.value_at(&bound.side, sample);
            ((value - bound.inner) / bound.range, index)
        });
        let finite = depths.filter(|(depth, _)| depth.is_finite());
        let best = finite.reduce(|best, next| if next.0 > best.0 { next } else { best });
        best.map(|(_, index)| index)
    }

    /// Brings the bounds up to date and finds out whether it still explains
    /// everything. The outer end of a bound is at the first infeasible sample that
    /// no other constraint excludes.
    #[inline(never)]
    pub(super) fn measure(&mut self, forms: &Forms<'_, R>, step: usize, slack: f64) {
        for chosen in &mut self.chosen {
            chosen.widen(forms, step);
        }
        let overlap = self.overlap(forms, step);
        self.complete = true;
        // What none excludes belongs to the nearest, found before any bound is moved.
        let mut nearest: [Set; MAX_COVER] = [[0; MAX_WORDS]; MAX_COVER];
        for sample in members(&overlap.open) {
            let index = self.nearest(forms, sample);
            match index.and_then(|index| nearest.get_mut(index)) {
                Some(own) => insert(own, sample),
                None => self.complete = false,
            }
        }
        for (chosen, own) in self.chosen.iter_mut().zip(&mut nearest) {
            let mut alone = chosen.excluded(forms, step);
            chosen.support = count(&alone) as u32;
            remove(&mut alone, &overlap.twice);
            unite(own, &alone);
            self.complete &= chosen.fit(forms, step, own, slack);
        }
        for sample in members(&overlap.twice) {
            self.own(forms, sample);
        }
    }

    /// Makes sure that one constraint excludes a sample for every threshold between
    /// its bounds: that for which it lies farthest out.
    fn own(&mut self, forms: &Forms<'_, R>, sample: usize) {
        let mut farthest: Option<(R, &mut Chosen<R>)> = None;
        for chosen in &mut self.chosen {
            let mut depth = R::INFINITY;
            let mut outside = true;
            for bound in chosen.bounds() {
                let value = forms.value_at(&bound.side, sample);
                outside &= value >= bound.outer;
                depth = depth.min((value - bound.inner) / bound.range);
            }
            if outside {
                return;
            }
            if farthest.as_ref().is_none_or(|(most, _)| depth > *most) {
                farthest = Some((depth, chosen));
            }
        }
        let Some((_, chosen)) = farthest else { return };
        for bound in chosen.bounds_mut() {
            bound.outer = bound.outer.min(forms.value_at(&bound.side, sample));
        }
    }

    /// Looks for a shorter explanation nearby: replaces constraints by better ones,
    /// and leaves out those that others nearly make superfluous. `details` is the
    /// length of a constraint beyond [`Chosen::bits`].
    pub(super) fn refine(
        &mut self,
        forms: &Forms<'_, R>,
        step: usize,
        slack: f64,
        details: &dyn Fn(&Chosen<R>) -> f64,
    ) {
        for _ in 0..MAX_COVER {
            let improved = self.improve(forms, step, slack, details);
            let shortened = self.shorten(forms, step, slack, details);
            if !improved && !shortened {
                return;
            }
        }
    }

    fn improve(
        &mut self,
        forms: &Forms<'_, R>,
        step: usize,
        slack: f64,
        details: &dyn Fn(&Chosen<R>) -> f64,
    ) -> bool {
        let mut improved = false;
        for index in 0..self.chosen.len() {
            let better = self.better(forms, step, slack, index, details);
            if let (Some(better), Some(slot)) = (better, self.chosen.get_mut(index)) {
                improved = true;
                *slot = better;
            }
        }
        if improved {
            self.measure(forms, step, slack);
        }
        improved
    }

    /// The best constraint for the place of one, if that is not the best.
    #[inline(never)]
    fn better(
        &self,
        forms: &Forms<'_, R>,
        step: usize,
        slack: f64,
        index: usize,
        details: &dyn Fn(&Chosen<R>) -> f64,
    ) -> Option<Chosen<R>> {
        let (before, rest) = self.chosen.split_at_checked(index)?;
        let (old, behind) = rest.split_first()?;
        let others = [before, behind];
        let alone = self.alone(forms, step, (index, old), &self.overlap(forms, step));
        let needed = (MOST * count(&alone) as f64) as u32;
        let (mut best, mut least) = (*old, old.bits(forms, others) + details(old) - SHORTER);
        forms.for_each_count(step, &alone, &mut |side, count| {
            let mut new = Chosen::new(Bound::inside(forms, side, step));
            let shortest = new.bits(forms, others) - forms.bits_of_threshold();
            if count < needed || shortest >= least {
                return;
            }
            new.bound.range = range(forms, &side, step);
            if new.fit(forms, step, &alone, slack) {
                let mut bits = new.bits(forms, others);
                if bits - forms.bits_of_threshold() < least {
                    bits += details(&new);
                    if bits < least {
                        (best, least) = (new, bits);
                    }
                }
            }
        });
        for_each_neighbour(forms, old, |sides| {
            if let Some(new) = between(forms, step, sides, &alone) {
                let bits = new.bits(forms, others) + details(&new);
                if bits < least {
                    (best, least) = (new, bits);
                }
            }
        });
        (best != *old).then_some(best)
    }

    #[inline(never)]
    fn shorten(
        &mut self,
        forms: &Forms<'_, R>,
        step: usize,
        slack: f64,
        details: &dyn Fn(&Chosen<R>) -> f64,
    ) -> bool {
        let length =
            |cover: &Self| cover.bits(forms) + cover.chosen.iter().map(details).sum::<f64>();
        let mut other = Cover::default();
        let mut shortened = false;
        for index in (0..self.chosen.len()).rev() {
            other.copy_from(self);
            take_out(&mut other.chosen, index);
            other.measure(forms, step, slack);
            if other.complete && length(&other) < length(self) - SHORTER {
                self.copy_from(&other);
                shortened = true;
            }
        }
        shortened
    }

    /// The length of its description in bits.
    pub(super) fn bits(&self, forms: &Forms<'_, R>) -> f64 {
        let lengths = self.chosen.iter().enumerate().map(|(index, chosen)| {
            let before = self.chosen.get(..index).unwrap_or(&[]);
            chosen.bits(forms, [before, &[]])
        });
        lengths.sum()
    }

    /// How many samples it is wrong about.
    pub(super) fn strays(&self, forms: &Forms<'_, R>, step: usize) -> usize {
        let holds =
            |bound: &Bound<R>, sample: usize| forms.value_at(&bound.side, sample) <= bound.middle();
        let admits = |sample: &usize| {
            let mut constraints = self.chosen.iter();
            constraints.all(|c| c.bounds().any(|b| holds(b, *sample)))
        };
        let admitted = members(&forms.infeasible(step)).filter(admits).count();
        let refused = members(&forms.feasible(step))
            .filter(|s| !admits(s))
            .count();
        admitted + refused
    }

    /// The width of all gaps together.
    pub(super) fn looseness(&self) -> R {
        let bounds = self.chosen.iter().flat_map(Chosen::bounds);
        bounds.fold(R::ZERO, |sum, bound| sum + (bound.outer - bound.inner))
    }
}
