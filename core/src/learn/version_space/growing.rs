//! Instances that arrive while learning.
//!
//! Which right sides vary, and so which forms there are, depends on the instances. Where some
//! are appended the forms are laid out anew, and what was told is taken in again: a learner
//! knows what follows from its observations and the instances that there are now, whenever
//! they arrived.

use super::selecting::Work;
use super::selection::Selection;
use super::telling::Since;
use super::{Report, VersionSpace, certifying_calls, wanted};
use crate::domain::Domain;
use crate::error::Error;
use crate::learn::Problem;
use crate::learn::problem::CHANGED;
use crate::real::Real;

impl<R: Real> VersionSpace<'_, R> {
    /// Gets to know the instances, or those that were appended.
    ///
    /// # Errors
    /// [`Error::Mismatch`] if it knows others; [`Error::CapacityExceeded`] if there is no
    /// room for so many.
    #[inline(never)]
    pub(super) fn begin(&mut self, problem: &Problem<'_>) -> Result<(), Error> {
        let begun = problem.begun();
        match self.problem {
            Some(known) if known == begun => return Ok(()),
            Some(known) if !problem.continues(known) => return Err(CHANGED),
            known => {
                let known = known.map_or(0, |known| known.count as usize);
                // Nothing fails behind this, so that a call that fails changes nothing.
                self.forms.check(problem, known)?;
            }
        }
        let (notes, told) = (self.since.notes(), self.observations.len());
        self.forget(problem.domain());
        self.forms.lay_out(problem)?;
        self.report.forms = self.forms.len();
        self.report.forms_left_out = self.forms.left_out();
        self.unasked = problem
            .domain()
            .parameters()
            .is_empty()
            .then_some(begun.count);
        self.problem = Some(begun);
        self.retake(problem, told)?;
        self.end_quiet(problem.domain());
        self.redo(problem.domain(), notes);
        Ok(())
    }

    /// Takes what was told in again, of a table that was cleared.
    pub(super) fn retake(&mut self, problem: &Problem<'_>, told: usize) -> Result<(), Error> {
        let open = self.trials.len();
        for place in 0..told {
            if let Some(saved) = self.observations.slot(place).copied() {
                self.take_again(problem, &saved, open)?;
            }
        }
        Ok(())
    }

    /// Makes everything as it was before anything was told.
    pub(super) fn forget(&mut self, domain: &Domain<'_>) {
        self.forms.forget();
        self.committee.clear();
        self.approximations.iter_mut().for_each(|own| own.clear());
        self.approximating = false;
        self.wanted = wanted(&self.config);
        self.selection = Selection::default();
        self.work = Work::default();
        self.forms.forget_work();
        self.observations.clear();
        self.trials
            .as_mut_slice()
            .iter_mut()
            .for_each(|own| own.lead = 0);
        self.since = Since::default();
        self.influence = false;
        (self.certifying, self.certify_from) = (false, certifying_calls(&self.config));
        self.region.clear(domain);
        self.evidence.clear();
        let Report {
            forms,
            forms_left_out,
            dropped,
            ..
        } = self.report;
        self.report = Report {
            forms,
            forms_left_out,
            dropped,
            observed: dropped,
            ..Report::default()
        };
    }
}
