//! What the answers prove about a sample.
//!
//! The version space of all conjunctions of bounds: a sample inside S of every form
//! is admitted by all of them. If taking it into S would leave an infeasible sample
//! that no form excludes any more, none of them admits it (Hirsh 1992). Otherwise
//! they disagree.

use super::VersionSpace;
use super::forms::{MAX_LEFTS, MAX_WORDS};
use super::set::{insert, is_empty, members, remove};
use crate::error::Error;
use crate::learn::{Problem, Query};
use crate::real::Real;

/// What is known about a sample, if the truth is a conjunction of bounds of the forms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Membership {
    /// It works: every conjunction that agrees with the answers admits it.
    Feasible,
    /// It does not: none of them admits it.
    Infeasible,
    /// They disagree, or none agrees with the answers.
    Unknown,
}

impl<R: Real> VersionSpace<'_, R> {
    /// What the answers so far prove about a sample, whatever the region is. It looks
    /// at all forms and infeasible samples.
    ///
    /// # Errors
    /// [`Error::OutOfSequence`] before the first question; [`Error::Mismatch`] for
    /// another problem; [`Error::InvalidArgument`] for an instance that is none.
    pub fn membership(&self, problem: &Problem<'_>, query: &Query) -> Result<Membership, Error> {
        if self.problem.is_none() {
            return Err(Error::OutOfSequence("ask for a sample first"));
        }
        problem.check_begun(self.problem)?;
        let mut lefts = [R::ZERO; MAX_LEFTS];
        self.forms.evaluate_query(problem, query, &mut lefts)?;
        let mut all = Membership::Feasible;
        for step in 0..self.capacity.steps {
            match self.membership_of_step(query.instance, &lefts, step) {
                Membership::Feasible => {}
                Membership::Infeasible => return Ok(Membership::Infeasible),
                Membership::Unknown => all = Membership::Unknown,
            }
        }
        Ok(all)
    }

    fn membership_of_step(&self, instance: usize, lefts: &[R], step: usize) -> Membership {
        let forms = &self.forms;
        let infeasible = forms.infeasible(step);
        // What is excluded by some form, now and after taking the sample in.
        let (mut open, mut left) = (infeasible, infeasible);
        let mut inside = true;
        forms.for_each_side(u8::MAX, |side| {
            let value = forms.value(&side, instance, lefts);
            inside &= value <= forms.last_feasible(&side, step);
            let mut excluded = forms.excluded(&side, step);
            remove(&mut open, &excluded);
            let mut admitted = [0; MAX_WORDS];
            for sample in members(&excluded) {
                if forms.value_at(&side, sample) <= value {
                    insert(&mut admitted, sample);
                }
            }
            remove(&mut excluded, &admitted);
            remove(&mut left, &excluded);
        });
        match (is_empty(&open), is_empty(&left)) {
            (true, false) => Membership::Infeasible,
            (true, true) if inside => Membership::Feasible,
            _ => Membership::Unknown,
        }
    }
}
