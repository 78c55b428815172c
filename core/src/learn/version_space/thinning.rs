//! Logs that are longer than the table of observations.
//!
//! When the table is full, what nobody asked is thinned: near the bounds of the region
//! everything is kept, elsewhere every second sample. What the learner knows follows from what
//! is kept, as if nothing else had been told; a log of any length leaves a sample of itself in
//! which as many outcomes are wrong as in the whole.

use super::bound::Bound;
use super::forms::SampleSet;
use super::{Step, VersionSpace};
use crate::domain::Domain;
use crate::error::Error;
use crate::learn::{OBSERVATIONS_FULL, Problem};
use crate::real::Real;

/// With fewer samples that nobody asked there is no use in thinning.
const FEWEST: usize = 16;

/// Samples are near a bound within this share of what its form ranges over.
const NEAR: f64 = 0.01;

impl<R: Real> VersionSpace<'_, R> {
    /// Checks that there is room for one more observation beside the answers that wait, or
    /// will be.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] if there is none.
    pub(super) fn check_room(&self) -> Result<(), Error> {
        let taken = self.observations.len() + self.waiting();
        let room = self.observations.capacity();
        match taken < room || taken < room + self.gain() {
            true => Ok(()),
            false => Err(OBSERVATIONS_FULL),
        }
    }

    /// How many observations thinning drops at least: a quarter of what was not asked.
    fn gain(&self) -> usize {
        match self.unasked {
            None if self.not_asked() >= FEWEST => self.not_asked() / 4,
            _ => 0,
        }
    }

    fn not_asked(&self) -> usize {
        let observations = self.observations.as_slice().iter();
        observations.filter(|own| !own.asked()).count()
    }

    /// Thins what nobody asked if the table is full.
    ///
    /// # Errors
    /// Those of [`VersionSpace::check_room`]; then nothing changed.
    pub(super) fn make_room(&mut self, problem: &Problem<'_>) -> Result<(), Error> {
        if self.observations.len() < self.observations.capacity() {
            return Ok(());
        }
        let gain = self.gain();
        if gain == 0 {
            return Err(OBSERVATIONS_FULL);
        }
        let mut dropped = SampleSet::EMPTY;
        self.choose_what_goes(problem, gain, &mut dropped)?;
        let told = self.observations.len();
        self.observations.keep(|place| !dropped.contains(place));
        let kept = self.observations.len();
        self.report.dropped += told - kept;
        self.forget(problem.domain());
        self.quiet = true;
        self.retake(problem, kept)?;
        self.end_quiet(problem.domain());
        Ok(())
    }

    /// What is far from all bounds, every second one; and of the rest, too, if that is not
    /// enough.
    #[inline(never)]
    fn choose_what_goes(
        &mut self,
        problem: &Problem<'_>,
        enough: usize,
        dropped: &mut SampleSet,
    ) -> Result<(), Error> {
        let told = self.observations.len();
        let (mut far, mut near, mut gone) = ([0usize; 2], 0usize, 0usize);
        for place in 0..told {
            let Some(own) = self.observations.slot(place).copied() else {
                continue;
            };
            if own.asked() {
                continue;
            }
            let query = own.query();
            self.forms.evaluate_query(problem, &query, self.lhs)?;
            if self.is_near_a_bound(query.instance) {
                continue;
            }
            let [infeasible, feasible] = &mut far;
            let count = match own.outcome.is_feasible() {
                true => feasible,
                false => infeasible,
            };
            *count += 1;
            if count.is_multiple_of(2) {
                dropped.insert(place);
                gone += 1;
            }
        }
        for place in 0..told {
            let own = self.observations.slot(place);
            if gone < enough && own.is_some_and(|own| !own.asked()) && !dropped.contains(place) {
                near += 1;
                if near.is_multiple_of(2) {
                    dropped.insert(place);
                    gone += 1;
                }
            }
        }
        Ok(())
    }

    /// Whether the sample whose left sides are in `lhs` is near a bound of the region.
    fn is_near_a_bound(&self, instance: usize) -> bool {
        let near = |bound: &Bound<R>| {
            let margin = bound.range * R::from_f64(NEAR);
            let value = self.forms.value(&bound.form, instance, self.lhs);
            bound.inner - margin <= value && value <= bound.outer + margin
        };
        let mut clauses = self.shown_clauses();
        clauses.any(|(_, clause)| clause.bounds().any(near))
    }

    /// Selects hypotheses by what was taken in without a look for them.
    pub(super) fn end_quiet(&mut self, domain: &Domain<'_>) {
        if core::mem::take(&mut self.quiet) {
            self.reseed(Step::Conclude);
            self.reselect_quickly(domain);
            // It follows from what is kept.
            self.since = Default::default();
        }
    }
}
