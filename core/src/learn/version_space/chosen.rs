//! Constraints that were chosen to explain something: a bound, or two of which one holds.

use super::bound::Bound;
use super::clause::corner;
use super::forms::{Forms, MAX_WORDS, Set, Side, tolerance};
use super::set::{insert, members};
use crate::real::Real;

/// A constraint: a bound, or one of two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Chosen<R> {
    pub(super) bound: Bound<R>,
    /// Holds where the first does not.
    pub(super) or: Option<Bound<R>>,
    /// How many infeasible samples it excludes.
    pub(super) support: u32,
}

impl<R: Real> Chosen<R> {
    pub(super) fn new(bound: Bound<R>) -> Self {
        Chosen {
            bound,
            or: None,
            support: 0,
        }
    }

    /// A constraint of two bounds, one of which must hold.
    pub(super) fn any_of(bound: Bound<R>, or: Bound<R>) -> Self {
        Chosen {
            or: Some(or),
            ..Chosen::new(bound)
        }
    }

    pub(super) fn bounds(&self) -> impl Iterator<Item = &Bound<R>> {
        core::iter::once(&self.bound).chain(&self.or)
    }

    pub(super) fn bounds_mut(&mut self) -> impl Iterator<Item = &mut Bound<R>> {
        core::iter::once(&mut self.bound).chain(&mut self.or)
    }

    /// Whether its bounds have other ends than those of another.
    pub(super) fn is_elsewhere(&self, other: &Self) -> bool {
        let ends = |bound: &Bound<R>| (bound.side, bound.inner, bound.outer);
        !self.bounds().map(ends).eq(other.bounds().map(ends))
    }

    /// The length of its description in bits, after that of `others`.
    pub(super) fn bits(&self, forms: &Forms<'_, R>, others: [&[Chosen<R>]; 2]) -> f64 {
        let named = |side: &Side| {
            let mut known = others.into_iter().flatten().flat_map(Chosen::bounds);
            known.any(|other| other.side.form == side.form)
        };
        let first = &self.bound;
        let bits = first.strain.to_f64() + forms.bits(&first.side, named(&first.side));
        let second = self.or.map(|or| {
            let named = or.side.form == first.side.form || named(&or.side);
            forms.bits(&or.side, named)
        });
        bits + second.unwrap_or(0.0)
    }

    /// The infeasible samples of a step that it excludes whichever threshold is true.
    pub(super) fn excluded(&self, forms: &Forms<'_, R>, step: usize) -> Set {
        let Some(or) = &self.or else {
            return forms.excluded(&self.bound.side, step);
        };
        let mut set = [0; MAX_WORDS];
        let beyond = |bound: &Bound<R>, sample: usize| {
            let value = forms.value_at(&bound.side, sample);
            value > bound.inner + tolerance(value)
        };
        for sample in members(&forms.infeasible(step)) {
            if beyond(&self.bound, sample) && beyond(or, sample) {
                insert(&mut set, sample);
            }
        }
        set
    }

    /// Takes the samples of a step in: how far the forms range, and the feasible ones.
    pub(super) fn widen(&mut self, forms: &Forms<'_, R>, step: usize) {
        for bound in self.bounds_mut() {
            bound.range = range(forms, &bound.side, step);
        }
        let Some(or) = &mut self.or else {
            self.bound.inner = forms.last_feasible(&self.bound.side, step);
            return;
        };
        let sides = [&self.bound.side, &or.side];
        let ends = [self.bound.outer, or.outer];
        let corner = corner(forms, &forms.feasible(step), sides, ends);
        [self.bound.inner, or.inner] = corner.unwrap_or([R::INFINITY; 2]);
    }

    /// Puts its bounds between the feasible samples and those that it must exclude. If it
    /// cannot, it stays as it is and says so.
    #[inline(never)]
    pub(super) fn fit(&mut self, forms: &Forms<'_, R>, step: usize, own: &Set, slack: f64) -> bool {
        if self.or.is_some() {
            for bound in self.bounds_mut() {
                bound.outer = first_of(forms, &bound.side, own);
            }
            return true;
        }
        let feasible = forms.feasible(step);
        let Bound { side, range, .. } = self.bound;
        let fitted = Bound::between(forms, side, &feasible, own, range, slack);
        self.bound = fitted.unwrap_or(self.bound);
        fitted.is_some()
    }
}

/// The least value of a form in a set.
pub(super) fn first_of<R: Real>(forms: &Forms<'_, R>, side: &Side, set: &Set) -> R {
    let values = members(set).map(|negative| forms.value_at(side, negative));
    values.fold(R::INFINITY, R::min)
}

/// How far a form ranges over the samples of a step.
pub(super) fn range<R: Real>(forms: &Forms<'_, R>, side: &Side, step: usize) -> R {
    let (feasible, infeasible) = (forms.feasible(step), forms.infeasible(step));
    let samples = members(&feasible).chain(members(&infeasible));
    let ends = samples.fold((R::INFINITY, -R::INFINITY), |(low, high), sample| {
        let value = forms.value_at(side, sample);
        if value.is_finite() {
            (low.min(value), high.max(value))
        } else {
            (low, high)
        }
    });
    ends.1 - ends.0
}
