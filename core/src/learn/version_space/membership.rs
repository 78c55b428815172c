//! What the answers prove about a sample.
//!
//! The version space of all conjunctions of bounds: a sample inside S of every form
//! is admitted by all of them. If taking it into S would leave an infeasible sample
//! that no form excludes any more, none of them admits it (Hirsh 1992). Otherwise
//! they disagree.

use super::VersionSpace;
use super::forms::{MAX_LHS, SampleSet, StepView};
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
    /// ```
    /// use critreg::domain::Domain;
    /// use critreg::learn::version_space::Membership;
    /// use critreg::learn::*;
    ///
    /// critreg::room!(struct Room: f64, Capacity::new(1024, 64));
    ///
    /// let domain = Domain::parse(
    ///     "object wall { x: length, y: length }
    ///      parameter reach in [0, 4]: length
    ///      point hand = world + (reach, 0)",
    /// )?;
    /// let problem = Problem::new(&domain, &[2.0, 0.0], 1)?;
    /// let mut room = Room::new();
    /// let config = Config { calls: 40, ..Config::default() };
    /// let mut learner = VersionSpace::new(&domain, config, Room::CAPACITY, room.lend())?;
    /// let works = |reach: f64| Outcome::from_feasible(reach <= 1.75);
    /// learn_region(&mut learner, &problem, |_, query| Ok::<_, critreg::Error>(works(query.theta[0])))?;
    /// let proven = |reach: f64| {
    ///     let query = Query { instance: 0, theta: [reach, 0.0, 0.0, 0.0, 0.0, 0.0] };
    ///     learner.membership(&problem, &query)
    /// };
    /// // Between two samples that worked, every bound admits it.
    /// assert_eq!(proven(1.0)?, Membership::Feasible);
    /// // Beyond samples that failed, no conjunction of bounds admits it for sure.
    /// assert_ne!(proven(3.9)?, Membership::Feasible);
    /// # Ok::<(), critreg::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::OutOfSequence`] before the first query; [`Error::Mismatch`] for
    /// another problem, or one with instances that the learner does not know yet;
    /// [`Error::InvalidArgument`] for an instance that is none.
    pub fn membership(&self, problem: &Problem<'_>, query: &Query) -> Result<Membership, Error> {
        if self.problem.is_none() {
            return Err(Error::OutOfSequence("ask for a sample first"));
        }
        problem.check_begun(self.problem)?;
        let mut lhs = [R::ZERO; MAX_LHS];
        self.forms.evaluate_query(problem, query, &mut lhs)?;
        let mut all = Membership::Feasible;
        for step in 0..self.capacity.steps {
            let view = StepView::new(&self.forms, step);
            match membership(&view, query.instance, &lhs) {
                Membership::Feasible => {}
                Membership::Infeasible => return Ok(Membership::Infeasible),
                Membership::Unknown => all = Membership::Unknown,
            }
        }
        Ok(all)
    }
}

/// What the answers about one step prove.
fn membership<R: Real>(view: &StepView<'_, '_, R>, instance: usize, lhs: &[R]) -> Membership {
    // What no form excludes, now and after taking the sample in.
    let (mut open, mut left) = (view.infeasible, view.infeasible);
    let mut inside = true;
    view.forms.for_each(u8::MAX, |form| {
        let value = view.forms.value(&form, instance, lhs);
        inside &= value <= view.last_feasible(&form);
        let mut excluded = view.excluded(&form);
        open.subtract(&excluded);
        let mut admitted = SampleSet::EMPTY;
        for sample in excluded.iter() {
            if view.value(&form, sample) <= value {
                admitted.insert(sample);
            }
        }
        excluded.subtract(&admitted);
        left.subtract(&excluded);
    });
    match (open.is_empty(), left.is_empty()) {
        (true, false) => Membership::Infeasible,
        (true, true) if inside => Membership::Feasible,
        _ => Membership::Unknown,
    }
}
