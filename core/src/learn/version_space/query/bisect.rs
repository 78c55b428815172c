//! In the middle of the widest gap between the ends of a bound.

use super::Strategy;
use super::candidate::between;
use crate::domain::{PointSet, Scene};
use crate::error::Error;
use crate::learn::version_space::bound::Bound;
use crate::learn::version_space::clause::Clause;
use crate::learn::version_space::forms::tolerance;
use crate::learn::{MAX_QUESTIONS, Query};
use crate::random::{Generator, below};
use crate::real::Real;
use crate::region::Theta;
use heapless::Vec;

/// How often the way to a value of a form is halved: to a slot of a millionth of the range,
/// in double precision.
const HALVINGS: usize = 36;

/// What is not known of the threshold of a bound, and its width as a share of what it is
/// measured by.
struct Gap<R> {
    from: R,
    to: R,
    share: f64,
}

impl<R: Real> Strategy<'_, '_, R> {
    /// A sample in the middle of the widest gap that is wide, or of the next one if there is no
    /// such sample.
    #[inline(never)]
    pub(super) fn bisect(&self, rng: &mut Generator, query: &mut Query) -> Result<bool, Error> {
        let mut most = f64::INFINITY;
        while let Some((gap, clause, bound)) = self.widest_gap(most) {
            if gap.share <= self.forms.tuning().narrow {
                break;
            }
            let middle = gap.from + (gap.to - gap.from) * R::from_f64(0.5);
            if self.at_value((clause, bound), middle, &|_| false, rng, query)? {
                return Ok(true);
            }
            most = gap.share;
        }
        Ok(false)
    }

    /// The widest gap below a width, its bound and the clause of that.
    fn widest_gap(&self, most: f64) -> Option<(Gap<R>, &Clause<R>, &Bound<R>)> {
        let gaps = self.bounds().map(|(clause, bound, width)| {
            let [from, to] = self.open_part((clause, bound));
            let gap = to - from;
            // What is left is rounding.
            let gap = if gap <= tolerance(bound.inner) {
                R::ZERO
            } else {
                gap
            };
            let share = (gap / width).to_f64();
            (Gap { from, to, share }, clause, bound)
        });
        let finite = gaps.filter(|(gap, ..)| gap.share.is_finite() && gap.share < most);
        finite.reduce(|widest, next| {
            if next.0.share > widest.0.share {
                next
            } else {
                widest
            }
        })
    }

    /// The widest part of a gap that no open question lies in: each that only this bound
    /// decides leaves a part on either side.
    fn open_part(&self, (clause, bound): (&Clause<R>, &Bound<R>)) -> [R; 2] {
        let mut values: Vec<R, MAX_QUESTIONS> = Vec::new();
        for query in self.open() {
            if let Some(value) = self.decided((clause, bound), query) {
                // There is room for all of them.
                let _ = values.push(value);
            }
        }
        let mut widest = [bound.inner, bound.inner];
        let mut from = bound.inner;
        while from < bound.outer {
            let next = values.iter().filter(|value| **value > from);
            let to = next.fold(bound.outer, |least, value| least.min(*value));
            if to - from > widest[1] - widest[0] {
                widest = [from, to];
            }
            from = to;
        }
        widest
    }

    /// The value of the form of a bound at a sample for which nothing else decides, if there
    /// is one.
    #[inline(never)]
    fn decided(&self, own: (&Clause<R>, &Bound<R>), query: &Query) -> Option<R> {
        let Query { instance, theta } = query;
        let values = self.problem.instance(*instance).ok()?;
        let points = PointSet::all(self.problem.domain());
        let scene = Scene::new(self.problem.domain(), values, points).ok()?;
        let value = |other: &Bound<R>| self.forms.value_in(&scene, theta, &other.form, *instance);
        self.decides(own, &value).then(|| value(own.1))
    }

    /// A sample in some instance, not one to skip, at which the form of a bound has a
    /// certain value and for which nothing else decides.
    #[inline(never)]
    pub(super) fn at_value(
        &self,
        (clause, bound): (&Clause<R>, &Bound<R>),
        value: R,
        skip: &dyn Fn(usize) -> bool,
        rng: &mut Generator,
        query: &mut Query,
    ) -> Result<bool, Error> {
        let problem = self.problem;
        let points = PointSet::all(problem.domain());
        for _ in 0..self.forms.tuning().bisect_tries {
            let instance = below(rng, problem.count());
            if skip(instance) {
                continue;
            }
            let mut scene = Scene::blank(problem.domain(), problem.instance(instance)?, points);
            scene.place_points()?;
            let beyond =
                |theta: &Theta| self.forms.value_in(&scene, theta, &bound.form, instance) > value;
            let mut inside = self.any_theta(instance, rng);
            let mut outside = self.any_theta(instance, rng);
            match (beyond(&inside), beyond(&outside)) {
                (true, false) => core::mem::swap(&mut inside, &mut outside),
                (false, true) => {}
                _ => continue,
            }
            for _ in 0..HALVINGS {
                let middle = between(&inside, &outside, 0.5);
                let end = if beyond(&middle) {
                    &mut outside
                } else {
                    &mut inside
                };
                *end = middle;
            }
            let theta = inside;
            let value =
                |other: &Bound<R>| self.forms.value_in(&scene, &theta, &other.form, instance);
            if self.decides((clause, bound), &value) {
                *query = Query { instance, theta };
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Whether a bound alone decides about a sample, at which forms have these values.
    #[inline(never)]
    fn decides(
        &self,
        (clause, bound): (&Clause<R>, &Bound<R>),
        value: &dyn Fn(&Bound<R>) -> R,
    ) -> bool {
        let mut rivals = clause.bounds().filter(|other| *other != bound);
        let others = self.committee.best_clauses().map(|(_, other)| other);
        let mut others = others.filter(|other| *other != clause);
        rivals.all(|other| value(other) >= other.outer) && others.all(|other| other.admits(value))
    }
}
