//! Draws from the region, to certify it.

use crate::error::Error;
use crate::learn::version_space::VersionSpace;
use crate::learn::{Problem, Query};
use crate::random::below;
use crate::real::Real;

impl<R: Real> VersionSpace<'_, R> {
    /// A draw from the region, after a selection if it is the first.
    pub(super) fn draw_to_certify(
        &mut self,
        problem: &Problem<'_>,
        query: &mut Query,
    ) -> Result<bool, Error> {
        if !self.certifying {
            self.certifying = true;
            self.reselect(problem.domain());
        }
        self.draw(problem, query)
    }

    /// A draw from the region in some instance, one that was not asked about if
    /// there is nothing else to ask about.
    #[inline(never)]
    fn draw(&mut self, problem: &Problem<'_>, query: &mut Query) -> Result<bool, Error> {
        for _ in 0..self.config.tuning.certify_draws {
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
