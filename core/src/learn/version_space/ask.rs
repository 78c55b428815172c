//! The next question: look around, tell explanations apart, or certify.

use super::question::{Choice, anywhere};
use super::{Pending, VersionSpace};
use crate::error::Error;
use crate::learn::{Learner, Problem, Query};
use crate::random::{below, uniform};
use crate::real::Real;

/// Instances in which a draw from the region is tried.
const DRAWS: usize = 8;

impl<'m, R: Real> VersionSpace<'m, R> {
    #[inline(never)]
    pub(super) fn next_query(&mut self, problem: &Problem<'_>) -> Result<Pending, Error> {
        if self.is_finished() {
            return Err(Error::OutOfSequence(
                "learning is finished: ask for the region",
            ));
        }
        let mut pending = Pending {
            query: anywhere(problem, &mut self.rng),
            lead: 0,
            failed_step: 0,
            certifying: false,
        };
        if self.unasked.is_some()
            && let Some(instance) = self.unasked_instance(problem)
        {
            pending.query.instance = instance;
        }
        if self.report.feasible == 0 || self.report.infeasible == 0 {
            return Ok(pending);
        }
        if self.calls_left() <= self.certify_from && self.is_explained() {
            if !self.certifying {
                self.certifying = true;
                self.elect(problem.domain())?;
            }
            if let Some(query) = self.draw(problem)? {
                pending.query = query;
                pending.certifying = true;
            }
            return Ok(pending);
        }
        if self.is_doubtful() {
            self.elect(problem.domain())?;
        } else {
            self.mend();
        }
        if let Some(query) = self.question(problem)? {
            pending.query = query;
        }
        Ok(pending)
    }

    /// What tells explanations apart, or looks for what nobody suspects.
    #[inline(never)]
    fn question(&mut self, problem: &Problem<'_>) -> Result<Option<Query>, Error> {
        let mut rng = self.rng.clone();
        if self.unasked.is_some() {
            let chosen = self.choice().best_unasked(problem, &mut rng)?;
            self.rng = rng;
            return Ok(chosen);
        }
        let exploring = uniform(&mut rng) < self.config.exploring;
        let mut chosen = None;
        if !exploring {
            chosen = self.choice().best(problem, &mut rng)?;
        }
        if !exploring && chosen.is_none() && !self.elected {
            // Nothing is left to ask: is there a better explanation to be doubted?
            self.elect(problem.domain())?;
            chosen = self.choice().best(problem, &mut rng)?;
        }
        if chosen.is_none() {
            chosen = self.choice().farthest(problem, &mut rng)?;
        }
        self.rng = rng;
        Ok(chosen)
    }

    fn unasked_instance(&mut self, problem: &Problem<'_>) -> Option<usize> {
        let mut rng = self.rng.clone();
        let instance = self.choice().unasked(problem, &mut rng);
        self.rng = rng;
        instance
    }

    fn choice(&self) -> Choice<'_, 'm, R> {
        Choice {
            forms: &self.forms,
            covers: self.covers,
            observations: self.observations.as_slice(),
        }
    }

    pub(super) fn calls_left(&self) -> u32 {
        let told = u32::try_from(self.observations.len()).unwrap_or(u32::MAX);
        let left = self.config.calls.saturating_sub(told);
        self.unasked.map_or(left, |unasked| unasked.min(left))
    }

    /// A draw from the region in some instance, one that was not asked about if
    /// there is nothing else to ask about.
    #[inline(never)]
    fn draw(&mut self, problem: &Problem<'_>) -> Result<Option<Query>, Error> {
        for _ in 0..DRAWS {
            let mut instance = below(&mut self.rng, problem.count());
            if self.unasked.is_some() {
                match self.unasked_instance(problem) {
                    Some(unasked) => instance = unasked,
                    None => return Ok(None),
                }
            }
            let values = problem.instance(instance)?;
            let region = &self.region;
            match region.sample::<R>(problem.domain(), values, &mut self.rng) {
                Ok(theta) => return Ok(Some(Query { instance, theta })),
                Err(Error::EmptyRegion | Error::NoSample) => {}
                Err(error) => return Err(error),
            }
        }
        Ok(None)
    }
}
