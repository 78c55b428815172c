//! Clauses: the constraints of a hypothesis. A bound, or two of which one must hold.

use super::bound::Bound;
use super::forms::{DirectedForm, Forms, SampleSet, StepView, tolerance};
use crate::real::Real;

/// A constraint: a bound, or a disjunction of two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Clause<R> {
    pub(super) bound: Bound<R>,
    /// Holds where the first does not.
    pub(super) or: Option<Bound<R>>,
    /// How many infeasible samples it excludes.
    pub(super) support: u32,
}

impl<R: Real> Clause<R> {
    pub(super) fn new(bound: Bound<R>) -> Self {
        Clause {
            bound,
            or: None,
            support: 0,
        }
    }

    /// A disjunction of two bounds.
    pub(super) fn any_of(bound: Bound<R>, or: Bound<R>) -> Self {
        Clause {
            or: Some(or),
            ..Clause::new(bound)
        }
    }

    /// The disjunction of bounds of these forms that excludes `own` and nothing that works.
    pub(super) fn between(
        view: &StepView<'_, '_, R>,
        forms: [DirectedForm; 2],
        own: &SampleSet,
    ) -> Option<Self> {
        let [first, second] = forms;
        view.note_values(2 * (own.len() + view.feasible.len()));
        let ends = [view.first_of(&first, own), view.first_of(&second, own)];
        let corner = view.corner([&first, &second], ends);
        let [inner, or_inner] = corner.filter(|c| c.iter().all(|end| end.is_finite()))?;
        let [outer, or_outer] = ends;
        let bound = |form, inner, outer| Bound::new(form, inner, outer, view.range(&form));
        Some(Clause::any_of(
            bound(first, inner, outer),
            bound(second, or_inner, or_outer),
        ))
    }

    pub(super) fn bounds(&self) -> impl Iterator<Item = &Bound<R>> {
        core::iter::once(&self.bound).chain(&self.or)
    }

    pub(super) fn bounds_mut(&mut self) -> impl Iterator<Item = &mut Bound<R>> {
        core::iter::once(&mut self.bound).chain(&mut self.or)
    }

    /// The bounds that say something, of which one must hold: none if one of them admits
    /// everything, and not those that admit nothing beside another one. An answer that came
    /// since it was fitted can leave a disjunction with such bounds.
    pub(super) fn said(&self) -> impl Iterator<Item = &Bound<R>> {
        let mut ends = self.bounds().map(|bound| bound.inner);
        let everything = ends.any(|inner| inner == R::INFINITY);
        let mut ends = self.bounds().map(|bound| bound.inner);
        let finite = ends.any(|inner| inner.is_finite());
        let says = move |bound: &&Bound<R>| !everything && (bound.inner.is_finite() || !finite);
        self.bounds().filter(says)
    }

    /// Whether its bounds have other ends than those of another.
    pub(super) fn is_elsewhere(&self, other: &Self) -> bool {
        let ends = |bound: &Bound<R>| (bound.form, bound.inner, bound.outer);
        !self.bounds().map(ends).eq(other.bounds().map(ends))
    }

    /// Whether it admits a sample, at which its forms have these values, for all
    /// thresholds between its ends.
    pub(super) fn admits(&self, value: impl Fn(&Bound<R>) -> R) -> bool {
        self.bounds().any(|bound| value(bound) <= bound.inner)
    }

    /// The length of its description in bits, after that of `others`; without names for its
    /// thresholds.
    pub(super) fn length(&self, forms: &Forms<'_, R>, others: [&[Clause<R>]; 2]) -> f64 {
        let named = |form: &DirectedForm| {
            let mut known = others.into_iter().flatten().flat_map(Clause::bounds);
            known.any(|other| other.form.index() == form.index())
        };
        let first = &self.bound;
        let length = first.strain.to_f64() + forms.bound_length(&first.form, named(&first.form));
        let second = self.or.map(|or| {
            let named = or.form.index() == first.form.index() || named(&or.form);
            forms.bound_length(&or.form, named)
        });
        length + second.unwrap_or(0.0)
    }

    /// The infeasible samples that it excludes whichever threshold is true.
    pub(super) fn excluded(&self, view: &StepView<'_, '_, R>) -> SampleSet {
        let Some(or) = &self.or else {
            return view.excluded(&self.bound.form);
        };
        let mut set = SampleSet::EMPTY;
        let beyond = |bound: &Bound<R>, sample: usize| {
            let value = view.value(&bound.form, sample);
            value > bound.inner + tolerance(value)
        };
        for sample in view.infeasible.iter() {
            if beyond(&self.bound, sample) && beyond(or, sample) {
                set.insert(sample);
            }
        }
        set
    }

    /// Brings up to date how far its forms range, and S.
    pub(super) fn generalise(&mut self, view: &StepView<'_, '_, R>) {
        for bound in self.bounds_mut() {
            bound.range = view.range(&bound.form);
        }
        let Some(or) = &mut self.or else {
            self.bound.inner = view.last_feasible(&self.bound.form);
            return;
        };
        let forms = [&self.bound.form, &or.form];
        let corner = view.corner(forms, [self.bound.outer, or.outer]);
        [self.bound.inner, or.inner] = corner.unwrap_or([R::INFINITY; 2]);
    }

    /// Puts its bounds between the feasible samples and those that it must exclude. If it
    /// cannot, or not with a strain of less than `most` bits, it stays as it is and says so.
    #[inline(never)]
    pub(super) fn fit(
        &mut self,
        view: &StepView<'_, '_, R>,
        own: &SampleSet,
        [slack, most]: [f64; 2],
    ) -> bool {
        if self.or.is_some() {
            for bound in self.bounds_mut() {
                bound.outer = view.first_of(&bound.form, own);
            }
            return true;
        }
        let Bound { form, range, .. } = self.bound;
        view.note_values(own.len());
        let fitted = Bound::between(view, form, own, range, [slack, most]);
        self.bound = fitted.unwrap_or(self.bound);
        fitted.is_some()
    }

    /// Calls `visit` with the forms of a disjunction, of which one has another right side.
    pub(super) fn for_each_neighbour(
        &self,
        forms: &Forms<'_, R>,
        mut visit: impl FnMut([DirectedForm; 2]),
    ) {
        let Some(or) = &self.or else { return };
        let (first, second) = (self.bound.form, or.form);
        forms.for_each_rhs(&first, |other| visit([other, second]));
        forms.for_each_rhs(&second, |other| visit([first, other]));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::vec::Vec;

    #[test]
    fn bounds_that_admit_everything_or_nothing_are_not_said() {
        const ALL: f64 = f64::INFINITY;
        const NOTHING: f64 = f64::NEG_INFINITY;
        let bound = |inner| Bound::new(DirectedForm::default(), inner, ALL, 1.0);
        let either = |a, b| Clause::any_of(bound(a), bound(b));
        let said = |clause: Clause<f64>| -> Vec<f64> { clause.said().map(|b| b.inner).collect() };
        for (clause, expected) in [
            (Clause::new(bound(1.0)), &[1.0][..]),
            (Clause::new(bound(ALL)), &[]),
            (Clause::new(bound(NOTHING)), &[NOTHING]),
            (either(1.0, 2.0), &[1.0, 2.0]),
            (either(1.0, ALL), &[]),
            (either(ALL, ALL), &[]),
            (either(ALL, NOTHING), &[]),
            (either(NOTHING, 2.0), &[2.0]),
        ] {
            assert_eq!(said(clause), expected, "{clause:?}");
        }
    }
}
