//! Far from all samples, for what nobody suspects.

use super::Strategy;
use crate::domain::{PointSet, Scene};
use crate::error::Error;
use crate::learn::version_space::bound::Bound;
use crate::learn::{Observation, Query};
use crate::random::{Generator, below};
use crate::real::Real;
use crate::region::Theta;
use rand_core::Rng;

impl<R: Real> Strategy<'_, '_, R> {
    /// The candidate farthest from all samples. Every other time it is a draw from the region,
    /// because a gap in it does most harm, or only candidates count that one of several clauses
    /// of the best hypothesis refuses, because there a second piece of a union would be.
    #[inline(never)]
    pub(super) fn explore(
        &self,
        lhs: &mut [R],
        rng: &mut Generator,
        query: &mut Query,
    ) -> Result<bool, Error> {
        let mut odd = || rng.next_u32() & 1 == 1;
        let wanted = if !odd() {
            None
        } else if self.committee.best_clauses().nth(1).is_some() && !odd() {
            Some(1)
        } else {
            Some(0)
        };
        if wanted == Some(0) && self.farthest_draw(rng, query)? {
            return Ok(true);
        }
        self.farthest(wanted, lhs, rng, query)
    }

    /// Of some draws from the region, the one farthest from all samples of its instance. Of
    /// candidates from everywhere hardly one is inside of a region that is a hundredth of it, and
    /// none in its second piece.
    #[inline(never)]
    fn farthest_draw(&self, rng: &mut Generator, query: &mut Query) -> Result<bool, Error> {
        let (problem, tuning) = (self.problem, self.forms.tuning());
        let mut most: Option<f64> = None;
        for _ in 0..tuning.query_instances {
            let instance = below(rng, problem.count());
            let values = problem.instance(instance)?;
            let mut visit = |theta: &Theta| {
                let own = Query {
                    instance,
                    theta: *theta,
                };
                let distance = self.distance(&own);
                if most.is_none_or(|most| distance > most) {
                    (most, *query) = (Some(distance), own);
                }
            };
            let (domain, count) = (problem.domain(), tuning.query_candidates as usize);
            self.region
                .visit_draws::<R>(domain, values, count, rng, &mut visit)?;
        }
        Ok(most.is_some())
    }

    /// Of some candidates that are refused by so many clauses of the best
    /// hypothesis, or by any number, the one farthest from all samples of its instance.
    #[inline(never)]
    fn farthest(
        &self,
        wanted: Option<usize>,
        lhs: &mut [R],
        rng: &mut Generator,
        query: &mut Query,
    ) -> Result<bool, Error> {
        let (problem, tuning) = (self.problem, self.forms.tuning());
        let points = PointSet::all(problem.domain());
        let lefts = self.committee.lefts();
        let mut most: Option<f64> = None;
        for _ in 0..tuning.query_instances {
            let instance = below(rng, problem.count());
            let mut scene = Scene::blank(problem.domain(), problem.instance(instance)?, points);
            scene.place_points()?;
            for _ in 0..tuning.query_candidates {
                let theta = self.any_theta(instance, rng);
                self.forms.evaluate(&scene, &theta, lefts, lhs);
                if wanted.is_some_and(|wanted| self.refusing(instance, lhs) != wanted) {
                    continue;
                }
                let own = Query { instance, theta };
                let distance = self.distance(&own);
                if most.is_none_or(|most| distance > most) {
                    (most, *query) = (Some(distance), own);
                }
            }
        }
        Ok(most.is_some())
    }

    /// How many clauses of the best hypothesis refuse a sample.
    #[inline(never)]
    fn refusing(&self, instance: usize, lhs: &[R]) -> usize {
        let value = |bound: &Bound<R>| self.forms.value(&bound.form, instance, lhs);
        let clauses = self.committee.best_clauses();
        clauses.filter(|(_, clause)| !clause.admits(value)).count()
    }

    /// The squared distance to the nearest sample of the instance, told or asked, in units of the
    /// ranges of the parameters.
    #[inline(never)]
    fn distance(&self, query: &Query) -> f64 {
        let told = self.observations.iter().map(Observation::query);
        let known = told.chain(self.open().copied());
        let own = known.filter(|own| own.instance == query.instance);
        let apart = own.map(|own| {
            let pairs = own.theta.iter().zip(&query.theta);
            let pairs = pairs.zip(self.problem.domain().parameters());
            let squares = pairs.map(|((a, b), p)| {
                let share = (a - b).abs() / (p.high - p.low);
                // Ends of a range meet: otherwise the farthest would mostly be a corner.
                let share = share.min(1.0 - share);
                share * share
            });
            squares.filter(|s| s.is_finite()).sum::<f64>()
        });
        apart.fold(f64::INFINITY, f64::min)
    }
}
