//! Where the committee is not of one mind.

use super::Strategy;
use crate::domain::{MAX_PARAMETERS, PointSet, Scene};
use crate::error::Error;
use crate::learn::Query;
use crate::learn::version_space::bound::Bound;
use crate::learn::version_space::committee::{Branches, Votes};
use crate::random::{Generator, below};
use crate::real::Real;

impl<R: Real> Strategy<'_, '_, R> {
    /// The candidate that splits the votes most evenly, of those that are not resolved; where
    /// questions are open, the votes of those who agree about these.
    #[inline(never)]
    pub(super) fn disagree(
        &self,
        lhs: &mut [R],
        rng: &mut Generator,
        query: &mut Query,
    ) -> Result<bool, Error> {
        let (problem, tuning) = (self.problem, self.forms.tuning());
        let points = PointSet::all(problem.domain());
        let lefts = self.committee.lefts();
        let branches = self.branches(lhs)?;
        let mut most = 0;
        for _ in 0..tuning.query_instances {
            let instance = below(rng, problem.count());
            let mut scene = Scene::blank(problem.domain(), problem.instance(instance)?, points);
            scene.place_points()?;
            for candidate in 0..tuning.query_candidates {
                let theta = if candidate % 2 == 0 {
                    self.any_theta(instance, rng)
                } else {
                    self.between_samples(instance, rng)
                };
                self.forms.evaluate(&scene, &theta, lefts, lhs);
                let disagreement = branches.disagreement(self.vote(instance, lhs));
                if disagreement > most && !self.is_resolved(instance, lhs) {
                    most = disagreement;
                    *query = Query { instance, theta };
                }
            }
        }
        Ok(most > 0)
    }

    /// Of the instances that were not asked about, the one that splits the votes most
    /// evenly, then one between the ends of most bounds.
    #[inline(never)]
    pub(super) fn disagree_in_unasked(
        &self,
        lhs: &mut [R],
        rng: &mut Generator,
        query: &mut Query,
    ) -> Result<bool, Error> {
        let theta = [0.0; MAX_PARAMETERS];
        let branches = self.branches(lhs)?;
        let mut best: Option<(u32, usize)> = None;
        for instance in self.unasked(rng) {
            let own = Query { instance, theta };
            self.forms.evaluate_query(self.problem, &own, lhs)?;
            let open = self.committee.best_bounds().filter(|(_, bound)| {
                let value = self.forms.value(&bound.form, instance, lhs);
                bound.inner < value && value < bound.outer
            });
            let disagreement = branches.disagreement(self.vote(instance, lhs));
            let score = (disagreement, open.count());
            if best.is_none_or(|most| score > most) {
                (best, *query) = (Some(score), own);
            }
        }
        Ok(best.is_some())
    }

    /// How the answers to the open questions will divide the committee.
    fn branches(&self, lhs: &mut [R]) -> Result<Branches, Error> {
        let mut branches = Branches::ONE;
        for query in self.open() {
            self.forms.evaluate_query(self.problem, query, lhs)?;
            branches.split(self.vote(query.instance, lhs));
        }
        Ok(branches)
    }

    fn vote(&self, instance: usize, lhs: &[R]) -> Votes {
        let value = |bound: &Bound<R>| self.forms.value(&bound.form, instance, lhs);
        self.committee.vote(value)
    }

    /// Whether a sample lies where a bound of the best hypothesis is known as well
    /// as needed. Others put it slightly elsewhere; that is not worth a query.
    #[inline(never)]
    fn is_resolved(&self, instance: usize, lhs: &[R]) -> bool {
        let narrow = R::from_f64(self.forms.tuning().narrow);
        self.bounds().any(|(_, bound, width)| {
            let margin = width * narrow;
            let value = self.forms.value(&bound.form, instance, lhs);
            bound.outer - bound.inner <= margin
                && value >= bound.inner - margin
                && value <= bound.outer + margin
        })
    }
}
