//! The next question: look around, tell explanations apart, or certify.

use super::question::{Choice, anywhere};
use super::{Pending, VersionSpace};
use crate::error::Error;
use crate::learn::{Learner, Problem, Query};
use crate::random::{Generator, below, uniform};
use crate::real::Real;

/// Instances in which a draw from the region is tried.
const DRAWS: usize = 8;

impl<'m, R: Real> VersionSpace<'m, R> {
    /// Chooses what is pending.
    #[inline(never)]
    pub(super) fn next_query(&mut self, problem: &Problem<'_>) -> Result<(), Error> {
        if self.is_finished() {
            return Err(Error::OutOfSequence(
                "learning is finished: ask for the region",
            ));
        }
        let mut query = anywhere(problem, &mut self.rng);
        if self.unasked.is_some()
            && let Some(instance) = self.unasked_instance(problem)
        {
            query.instance = instance;
        }
        let mut certifying = false;
        if self.report.feasible > 0 && self.report.infeasible > 0 {
            certifying = self.calls_left() <= self.certify_from && self.is_explained();
            if certifying {
                certifying = self.draw_to_certify(problem, &mut query)?;
            } else {
                self.question(problem, &mut query)?;
            }
        }
        self.pending = Some(Pending {
            query,
            lead: 0,
            failed_step: 1,
            certifying,
        });
        Ok(())
    }

    /// What tells explanations apart, or looks for what nobody suspects; the query stays
    /// if there is nothing.
    #[inline(never)]
    fn question(&mut self, problem: &Problem<'_>, query: &mut Query) -> Result<(), Error> {
        if self.is_doubtful() {
            self.elect(problem.domain());
        } else {
            self.mend();
        }
        // An election in between has lots of its own.
        let mut rng = self.rng.clone();
        self.choose(problem, &mut rng, query)?;
        self.rng = rng;
        Ok(())
    }

    fn choose(
        &mut self,
        problem: &Problem<'_>,
        rng: &mut Generator,
        query: &mut Query,
    ) -> Result<bool, Error> {
        if self.unasked.is_some() {
            let (choice, lefts) = self.choice();
            return choice.best_unasked(problem, lefts, rng, query);
        }
        if uniform(rng) >= self.config.exploring {
            let (choice, lefts) = self.choice();
            if choice.best(problem, lefts, rng, query)? {
                return Ok(true);
            }
            if !self.elected {
                // Nothing is left to ask: is there a better explanation to be doubted?
                self.elect(problem.domain());
                let (choice, lefts) = self.choice();
                if choice.best(problem, lefts, rng, query)? {
                    return Ok(true);
                }
            }
        }
        let (choice, lefts) = self.choice();
        choice.farthest(problem, lefts, rng, query)
    }

    #[inline(never)]
    fn unasked_instance(&mut self, problem: &Problem<'_>) -> Option<usize> {
        let mut rng = self.rng.clone();
        let instance = self.choice().0.unasked(problem, &mut rng);
        self.rng = rng;
        instance
    }

    /// What is known when a question is chosen, and room for the left sides at a sample.
    fn choice(&mut self) -> (Choice<'_, 'm, R>, &mut [R]) {
        let choice = Choice {
            forms: &self.forms,
            covers: self.covers,
            observations: self.observations.as_slice(),
        };
        (choice, self.lefts)
    }

    pub(super) fn calls_left(&self) -> u32 {
        let told = u32::try_from(self.observations.len()).unwrap_or(u32::MAX);
        let left = self.config.calls.saturating_sub(told);
        self.unasked.map_or(left, |unasked| unasked.min(left))
    }

    /// A draw from the region, after an election if it is the first.
    fn draw_to_certify(&mut self, problem: &Problem<'_>, query: &mut Query) -> Result<bool, Error> {
        if !self.certifying {
            self.certifying = true;
            self.elect(problem.domain());
        }
        self.draw(problem, query)
    }

    /// A draw from the region in some instance, one that was not asked about if
    /// there is nothing else to ask about.
    #[inline(never)]
    fn draw(&mut self, problem: &Problem<'_>, query: &mut Query) -> Result<bool, Error> {
        for _ in 0..DRAWS {
            let mut instance = below(&mut self.rng, problem.count());
            if self.unasked.is_some() {
                match self.unasked_instance(problem) {
                    Some(unasked) => instance = unasked,
                    None => return Ok(false),
                }
            }
            let values = problem.instance(instance)?;
            let region = &self.region;
            match region.sample::<R>(problem.domain(), values, &mut self.rng) {
                Ok(theta) => {
                    *query = Query { instance, theta };
                    return Ok(true);
                }
                Err(Error::EmptyRegion | Error::NoSample) => {}
                Err(error) => return Err(error),
            }
        }
        Ok(false)
    }
}
