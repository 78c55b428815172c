//! In the middle of the widest gap between the ends of a bound.

use super::Strategy;
use super::candidate::between;
use crate::domain::{PointSet, Scene};
use crate::error::Error;
use crate::learn::Query;
use crate::learn::version_space::bound::Bound;
use crate::learn::version_space::clause::Clause;
use crate::learn::version_space::forms::tolerance;
use crate::random::{Generator, below};
use crate::real::Real;
use crate::region::Theta;

/// How often the way to a value of a form is halved: to a slot of a millionth of the range,
/// in double precision.
const HALVINGS: usize = 36;

impl<R: Real> Strategy<'_, '_, R> {
    /// A sample in the middle of the widest gap that is wide, or of the next one if there is no
    /// such sample.
    #[inline(never)]
    pub(super) fn bisect(&self, rng: &mut Generator, query: &mut Query) -> Result<bool, Error> {
        let mut most = f64::INFINITY;
        while let Some((share, clause, bound)) = self.widest_gap(most) {
            if share <= self.forms.tuning().narrow {
                break;
            }
            let middle = bound.inner + (bound.outer - bound.inner) * R::from_f64(0.5);
            if self.at_value((clause, bound), middle, &|_| false, rng, query)? {
                return Ok(true);
            }
            most = share;
        }
        Ok(false)
    }

    /// The bound with the widest gap below a width, as a share of what it is measured by, and
    /// its clause.
    fn widest_gap(&self, most: f64) -> Option<(f64, &Clause<R>, &Bound<R>)> {
        let shares = self.bounds().map(|(clause, bound, width)| {
            let gap = bound.outer - bound.inner;
            // What is left is rounding.
            let gap = if gap <= tolerance(bound.inner) {
                R::ZERO
            } else {
                gap
            };
            ((gap / width).to_f64(), clause, bound)
        });
        let finite = shares.filter(|(share, ..)| share.is_finite() && *share < most);
        finite.reduce(|widest, next| if next.0 > widest.0 { next } else { widest })
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
