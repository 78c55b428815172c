//! Which sample to ask about next.
//!
//! | strategy | when | what it asks |
//! |---|---|---|
//! | [`disagree`] | the committee is not of one mind | the candidate that splits its votes most evenly (query by committee, Seung, Opper and Sompolinsky 1992) |
//! | [`bisect`] | it is, or now and then | the middle of the widest gap between the ends of a bound |
//! | [`probe`] | then, if all gaps are narrow | just inside or just outside of a bound, in an instance where nobody asked there: a bound that fits the instances by chance does not survive that |
//! | [`explore`] | now and then | far from all samples, for what nobody suspects |
//! | [`certify`] | at the end | draws from the region |
//!
//! A scene is large. What makes one is never inlined, so that one at a time is on the
//! stack, nor what is done beside it; the values of the left sides are in lent memory.
//! A query is written where it will be asked from, and a function tells whether it found
//! one: a way of eight returned queries would take as much stack as a scene.

mod bisect;
mod candidate;
mod certify;
mod disagree;
mod explore;
mod probe;

use super::bound::Bound;
use super::clause::Clause;
use super::committee::Committee;
use super::forms::{Forms, StepView, tolerance};
use super::{Step, VersionSpace};
use crate::domain::Domain;
use crate::error::Error;
use crate::learn::question::{Purpose, Trial};
use crate::learn::{Observation, Problem, Query};
use crate::random::{Generator, uniform};
use crate::real::Real;
use crate::region::Region;

/// What questions are about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Phase {
    /// It takes both a sample that works and one that does not.
    Search,
    /// What tells hypotheses apart, or looks for what nobody suspects.
    Doubt,
    /// How good a region is that is not exact.
    Judge,
    /// How good one is that is.
    Certify,
}

impl Phase {
    /// Whether the region stays what it is, as long as it is as good as it seems.
    fn is_last(self) -> bool {
        matches!(self, Phase::Judge | Phase::Certify)
    }
}

/// What is known when a query is chosen.
struct Strategy<'s, 'm, R> {
    problem: &'s Problem<'s>,
    forms: &'s Forms<'m, R>,
    region: &'s Region,
    committee: &'s Committee<'m, R>,
    observations: &'s [Observation],
    /// Whether there are some among them that were not asked.
    observed: bool,
    /// The questions that are open.
    open: &'s [Trial],
}

impl<R: Real> Strategy<'_, '_, R> {
    /// The bounds of the best hypotheses, each with its clause and what its gap is measured
    /// by: the range of its form, or where only a small part of that works, or may work, a
    /// few times the width of that part. So a slot of a thousandth is found, too.
    fn bounds(&self) -> impl Iterator<Item = (&Clause<R>, &Bound<R>, R)> {
        let clauses = self.committee.best_clauses();
        clauses.flat_map(move |(step, clause)| {
            let single = clause.or.is_none();
            clause.bounds().map(move |bound| {
                let width = match single {
                    true => StepView::new(self.forms, step).feasible_width(&bound.form),
                    false => bound.range,
                };
                let open = width + (bound.outer - bound.inner);
                let wide = open * R::from_f64(self.forms.tuning().narrow_slot);
                let least = R::from_f64(4.0) * tolerance(bound.inner);
                (clause, bound, bound.range.min(wide).max(least))
            })
        })
    }

    /// What the committee asks, if there is a reason to ask anything. `lhs` has room for
    /// the left sides at a sample.
    #[inline(never)]
    fn committee_query(
        &self,
        lhs: &mut [R],
        rng: &mut Generator,
        query: &mut Query,
    ) -> Result<bool, Error> {
        let narrows = uniform(rng) < self.forms.tuning().narrowing;
        if narrows && (self.bisect(rng, query)? || self.probe(rng, query)?) {
            return Ok(true);
        }
        if self.disagree(lhs, rng, query)? || self.bisect(rng, query)? {
            return Ok(true);
        }
        let probes = uniform(rng) < self.forms.tuning().probing;
        Ok(probes && self.probe(rng, query)?)
    }
}

impl<'m, R: Real> VersionSpace<'m, R> {
    /// Brings what is known up to date for the next questions, once after an answer, and once
    /// more if so many are open that the last phase begins. All that choosing them changes
    /// happens here, but for a selection by [`VersionSpace::queue_selection`].
    #[inline(never)]
    pub(super) fn prepare(&mut self, domain: &Domain<'_>, open: u32) -> Phase {
        let phase = self.phase(open);
        let late = open > 0 && phase.is_last();
        match self.since.prepared {
            Some(known) if !late || known.is_last() || self.since.late > 0 => return known,
            _ => {}
        }
        match late {
            true => self.since.late = open as u8,
            false => self.since.early = true,
        }
        self.reseed(Step::Prepare);
        if self.approximating || !self.committee.is_consistent() {
            // What was told meanwhile may not have been looked at.
            self.repair_best();
        }
        // What explains nothing late in a run has no time to wait for a selection bit by bit: what
        // is nearly right has to be judged yet.
        let unexplained = self.is_time_to_approximate() && !self.is_explained();
        let urgent = unexplained || phase == Phase::Judge;
        let most = match urgent {
            true => u32::MAX,
            false => self.config.tuning.work,
        };
        if unexplained && self.is_selecting() {
            // All of it is done at once, so it may as well be about all answers.
            self.restart_selection();
        }
        let selecting = self.is_selecting();
        if selecting {
            self.repair(most);
        }
        match phase {
            Phase::Search => {}
            Phase::Judge => self.prepare_to_judge(),
            Phase::Certify => self.prepare_to_certify(),
            Phase::Doubt if selecting => {}
            Phase::Doubt if self.is_time_for_last(open) => self.begin_selection(true),
            Phase::Doubt if self.is_doubtful() || self.is_time_to_approximate() => {
                self.begin_selection(false);
            }
            Phase::Doubt => {
                self.repair(most);
            }
        }
        if self.is_selecting() {
            self.go_on(domain, most);
        }
        // The last phase begins when the region is selected that it is about.
        let phase = match phase.is_last() && !self.certifying {
            true => Phase::Doubt,
            false => phase,
        };
        self.since.prepared = Some(phase);
        phase
    }

    /// Whether the last phase would begin before a selection comes to its end that begins now,
    /// if it takes one question more than the one before: there are more answers by now.
    fn is_time_for_last(&self, open: u32) -> bool {
        let soon = self
            .phase(open.saturating_add(self.selection.slices))
            .is_last();
        soon && !self.certifying && !self.selection.last
    }

    /// What the next question is about while so many are open.
    fn phase(&self, open: u32) -> Phase {
        if self.report.feasible == 0 || self.report.infeasible == 0 {
            return Phase::Search;
        }
        let left = self.calls_left().saturating_sub(open);
        let certifies = left <= self.certify_from && self.is_explained();
        match self.approximating {
            true if left <= self.judge_from() => Phase::Judge,
            false if certifies => Phase::Certify,
            _ => Phase::Doubt,
        }
    }

    /// The next question; none if there is nothing but what is open already.
    #[inline(never)]
    pub(super) fn next_query(
        &mut self,
        problem: &Problem<'_>,
    ) -> Result<Option<(Query, Purpose)>, Error> {
        let phase = self.prepare(problem.domain(), self.open());
        self.reseed(Step::Ask);
        let mut query = self.anywhere(problem);
        let purpose = match phase {
            Phase::Search => Purpose::Anywhere,
            Phase::Judge => self.judge(problem, &mut query)?,
            Phase::Certify => match self.draw(problem, &mut query)? {
                true => Purpose::Certify,
                false => Purpose::Anywhere,
            },
            Phase::Doubt => self.doubt(problem, &mut query)?,
        };
        if !self.is_asked(&query) {
            return Ok(Some((query, purpose)));
        }
        query = self.anywhere(problem);
        let new = !self.is_asked(&query);
        Ok(new.then_some((query, Purpose::Anywhere)))
    }

    /// Anywhere, in an instance that was not asked about if there is nothing else to ask about.
    #[inline(never)]
    fn anywhere(&mut self, problem: &Problem<'_>) -> Query {
        let mut rng = self.rng.clone();
        let mut query = self.strategy(problem).0.anywhere(&mut rng);
        self.rng = rng;
        if self.unasked.is_some()
            && let Some(instance) = self.unasked_instance(problem)
        {
            query.instance = instance;
        }
        query
    }

    /// What tells hypotheses apart, or looks for what nobody suspects; the query stays
    /// if there is nothing.
    #[inline(never)]
    fn doubt(&mut self, problem: &Problem<'_>, query: &mut Query) -> Result<Purpose, Error> {
        if self.approximating {
            let tuning = self.config.tuning;
            let chance = uniform(&mut self.rng);
            if chance < tuning.draws && self.draw(problem, query)? {
                return Ok(Purpose::Draw);
            }
            if chance < tuning.draws + tuning.uniform {
                return Ok(Purpose::Anywhere);
            }
        }
        // A selection in between has random numbers of its own.
        let mut rng = self.rng.clone();
        Ok(match self.choose(problem, &mut rng, query)? {
            true => Purpose::Doubt,
            false => Purpose::Anywhere,
        })
    }

    fn choose(
        &mut self,
        problem: &Problem<'_>,
        rng: &mut Generator,
        query: &mut Query,
    ) -> Result<bool, Error> {
        if self.unasked.is_some() {
            let (strategy, lhs) = self.strategy(problem);
            return strategy.disagree_in_unasked(lhs, rng, query);
        }
        if uniform(rng) >= self.config.exploring {
            let (strategy, lhs) = self.strategy(problem);
            if strategy.committee_query(lhs, rng, query)? {
                return Ok(true);
            }
            // Nothing is left to ask: is there a better hypothesis to be doubted?
            let selected = self.selection.current || self.is_selecting();
            let doubts = !selected && !self.is_late_and_unexplained();
            if doubts && self.queue_selection(problem.domain()) {
                let (strategy, lhs) = self.strategy(problem);
                if strategy.committee_query(lhs, rng, query)? {
                    return Ok(true);
                }
            }
        }
        let (strategy, lhs) = self.strategy(problem);
        strategy.explore(lhs, rng, query)
    }

    #[inline(never)]
    fn unasked_instance(&mut self, problem: &Problem<'_>) -> Option<usize> {
        let mut rng = self.rng.clone();
        let instance = self.strategy(problem).0.unasked(&mut rng).next();
        self.rng = rng;
        instance
    }

    /// What is known when a query is chosen, and room for the left sides at a sample.
    fn strategy<'s>(&'s mut self, problem: &'s Problem<'s>) -> (Strategy<'s, 'm, R>, &'s mut [R]) {
        let strategy = Strategy {
            problem,
            forms: &self.forms,
            region: &*self.region,
            committee: &self.committee,
            observations: self.observations.as_slice(),
            observed: self.report.observed > 0,
            open: self.trials.as_slice(),
        };
        (strategy, self.lhs)
    }

    pub(super) fn calls_left(&self) -> u32 {
        let told = u32::try_from(self.report.calls).unwrap_or(u32::MAX);
        let left = self.config.calls.saturating_sub(told);
        self.unasked.map_or(left, |unasked| unasked.min(left))
    }

    pub(super) fn is_out_of_calls(&self) -> bool {
        self.calls_left() == 0
    }
}
