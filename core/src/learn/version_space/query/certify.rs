//! Draws from the region, to certify it.

use crate::error::Error;
use crate::learn::question::Purpose;
use crate::learn::version_space::VersionSpace;
use crate::learn::{Problem, Query};
use crate::random::below;
use crate::real::Real;

/// One of so many draws is from everything where a region is judged.
const JUDGED: usize = 4;

impl<R: Real> VersionSpace<'_, R> {
    /// Selects the region that draws are to certify, before the first.
    pub(super) fn prepare_to_certify(&mut self) {
        if self.certifying {
            return;
        }
        match core::mem::take(&mut self.selection.last) {
            // It was selected in time.
            true => self.certifying = true,
            false => self.select_for_last(),
        }
    }

    /// When so many calls are left, a region that is not exact is judged.
    pub(in super::super) fn judge_from(&self) -> u32 {
        let share = self.config.tuning.judging * f64::from(self.config.calls);
        (share as u32).max(self.config.certifying)
    }

    /// Selects the region that is judged, and another one if it turns out not to be as good
    /// as wanted.
    pub(super) fn prepare_to_judge(&mut self) {
        if self.is_selecting() {
            return self.select_for_last();
        }
        let upper = self.report.precision_at_most(self.config.confidence);
        let refuted = upper.is_some_and(|upper| upper < self.config.precision_wanted);
        if refuted {
            self.wanted += 0.5 * (1.0 - self.wanted);
        }
        match self.certifying {
            true if refuted => self.approximate_again(),
            true => {}
            // It was selected in time.
            false if core::mem::take(&mut self.selection.last) => self.certifying = true,
            false => self.select_for_last(),
        }
    }

    /// A draw from a region that is not exact, or now and then from everything: they tell how
    /// good it is.
    pub(super) fn judge(
        &mut self,
        problem: &Problem<'_>,
        query: &mut Query,
    ) -> Result<Purpose, Error> {
        let asked = self.observations.len() + self.open() as usize;
        let everywhere = asked.is_multiple_of(JUDGED);
        match !everywhere && self.draw(problem, query)? {
            true => Ok(Purpose::Certify),
            false => Ok(Purpose::Anywhere),
        }
    }

    /// A draw from the region in some instance, one that was not asked about if
    /// there is nothing else to ask about.
    #[inline(never)]
    pub(super) fn draw(&mut self, problem: &Problem<'_>, query: &mut Query) -> Result<bool, Error> {
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
            match region.sample_soon::<R>(problem.domain(), values, &mut self.rng) {
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
