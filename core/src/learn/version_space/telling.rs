//! Taking answers in, to questions and to what nobody asked.

use super::bound::Bound;
use super::certificate::Certificate;
use super::query::Phase;
use super::{Step, VersionSpace};
use crate::domain::Domain;
use crate::error::Error;
use crate::learn::{Observation, Outcome, Problem, Query};
use crate::real::Real;

/// A query and what is known of its label.
#[derive(Clone, Copy, Debug)]
pub(super) struct Trial {
    pub(super) query: Query,
    /// How many more outcomes were feasible than infeasible.
    lead: i32,
    /// The step that failed last, from one.
    failed_step: u8,
    pub(super) purpose: Purpose,
}

impl Trial {
    /// A query that nothing is known of.
    pub(super) fn new(query: Query, purpose: Purpose) -> Trial {
        Trial {
            query,
            lead: 0,
            failed_step: 1,
            purpose,
        }
    }
}

/// What a query is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Purpose {
    /// To tell hypotheses apart.
    Doubt,
    /// It is drawn from the region, to certify it.
    Certify,
    /// It is drawn from the region, to learn what is wrong with it.
    Draw,
    /// It is drawn from everything.
    Anywhere,
    /// It was not asked.
    Told,
}

/// What a learner did since the last observation. It is kept with the next one, so that a
/// learner that is resumed does it again.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Since {
    /// It was prepared for questions, of this phase.
    pub(super) prepared: Option<Phase>,
    /// It selected the best hypotheses anew after that.
    pub(super) concluded: bool,
}

const PREPARED: u8 = 1 << 3;
const CONCLUDED: u8 = 1 << 4;

impl Purpose {
    const ALL: [Purpose; 5] = [
        Purpose::Doubt,
        Purpose::Certify,
        Purpose::Draw,
        Purpose::Anywhere,
        Purpose::Told,
    ];

    /// The purpose in the notes of an observation.
    fn of_notes(notes: u8) -> Result<Purpose, Error> {
        let known = Purpose::ALL.get(usize::from(notes & !(PREPARED | CONCLUDED)));
        known
            .copied()
            .ok_or(Error::Corrupt("a saved purpose is none"))
    }
}

impl Since {
    pub(super) fn notes(self) -> u8 {
        let noted = |done, bit| if done { bit } else { 0 };
        noted(self.prepared.is_some(), PREPARED) | noted(self.concluded, CONCLUDED)
    }
}

impl<R: Real> VersionSpace<'_, R> {
    /// Takes an outcome in. Returns the trial if its label is still open.
    ///
    /// # Errors
    /// Then nothing changed.
    pub(super) fn take(
        &mut self,
        problem: &Problem<'_>,
        mut trial: Trial,
        outcome: Outcome,
    ) -> Result<Option<Trial>, Error> {
        self.check_step(outcome)?;
        let asked = trial.purpose != Purpose::Told;
        let observation = Observation {
            asked,
            notes: trial.purpose as u8 | self.since.notes(),
            ..Observation::new(&trial.query, outcome)?
        };
        self.forms.evaluate_query(problem, &trial.query, self.lhs)?;
        let settles = self.settles(trial.query.instance);
        self.observations.push(observation)?;
        // Nothing fails from here on: a call that fails changes nothing.
        self.since = Since::default();
        self.reseed(Step::Learn);
        match asked {
            true => self.report.calls += 1,
            false => self.report.observed += 1,
        }
        match outcome {
            Outcome::Feasible => trial.lead += 1,
            Outcome::FailedStep(step) => {
                trial.lead -= 1;
                trial.failed_step = step;
            }
            Outcome::Unknown => self.report.unknown += 1,
        }
        // What was not asked cannot be asked again.
        let needed = if asked { self.needed_lead } else { 1 };
        let decided = trial.lead.abs() >= needed;
        let goes_on = !decided && outcome != Outcome::Unknown;
        // A sample that is still in doubt when the calls are used up stays undecided.
        if goes_on && !(asked && self.is_out_of_calls()) {
            return Ok(Some(trial));
        }
        if asked || decided {
            let settled = self.unasked.map(|count| count.saturating_sub(1));
            self.unasked = if settles { settled } else { self.unasked };
        }
        if decided {
            self.learn(problem.domain(), &trial);
        }
        // A run that is resumed may have had more calls.
        let within = self.report.calls as u64 <= u64::from(self.config.calls);
        let last = asked && within && self.is_out_of_calls();
        if (last && !self.certifying) || (!asked && self.has_grown()) {
            self.reselect(problem.domain());
        }
        Ok(None)
    }

    /// Does what led to an observation that was taken once, and takes it again.
    pub(super) fn take_again(
        &mut self,
        problem: &Problem<'_>,
        saved: &Observation,
    ) -> Result<(), Error> {
        self.redo(problem.domain(), saved.notes);
        let trial = self.trial_of(saved)?;
        let left = self.take(problem, trial, saved.outcome)?;
        if saved.asked {
            self.pending = left;
        }
        Ok(())
    }

    /// Does what was done before a saved observation, or after the last one.
    pub(super) fn redo(&mut self, domain: &Domain<'_>, notes: u8) {
        if notes & PREPARED != 0 {
            self.prepare(domain);
        }
        if notes & CONCLUDED != 0 {
            self.select_again(domain);
        }
    }

    /// The trial that a saved observation, or a question that is open, belongs to.
    pub(super) fn trial_of(&self, saved: &Observation) -> Result<Trial, Error> {
        let query = saved.query();
        match self.pending {
            Some(pending) if saved.asked && pending.query == query => Ok(pending),
            _ => {
                let purpose = match Purpose::of_notes(saved.notes)? {
                    // With other calls it is not time for that: it was another region.
                    Purpose::Certify if !self.certifying => Purpose::Draw,
                    purpose => purpose,
                };
                Ok(Trial::new(query, purpose))
            }
        }
    }

    /// Whether an outcome in an instance settles it, where there is nothing but instances
    /// to ask about: another one did not before.
    fn settles(&self, instance: usize) -> bool {
        let open = self.pending.map(|pending| pending.query.instance);
        let mut own = self.observations.as_slice().iter();
        !own.any(|o| o.instance as usize == instance && !(o.asked && open == Some(instance)))
    }

    /// Takes a sample whose label is decided; its left sides are in `lhs`.
    fn learn(&mut self, domain: &Domain<'_>, trial: &Trial) {
        let feasible = trial.lead > 0;
        let certifies = trial.purpose == Purpose::Certify;
        self.take_in(trial);
        self.note_influence(&trial.query, feasible);
        let moved = self.repair_best();
        self.count(trial);
        if self.approximating {
            return;
        }
        let refuted = certifies || (self.certifying && moved && trial.purpose == Purpose::Told);
        match (certifies, feasible) {
            (true, true) => {}
            (_, false) if refuted => {
                // Some of the calls that are left may find out what is wrong.
                let again = f64::from(self.calls_left()) * self.config.tuning.certify_again;
                (self.certifying, self.certify_from) = (false, again as u32);
                self.rebuild_region(domain);
            }
            _ if !moved => self.count_support(domain),
            _ => self.rebuild_region(domain),
        }
    }

    /// Counts what samples that were drawn at random tell about the region.
    fn count(&mut self, trial: &Trial) {
        let feasible = trial.lead > 0;
        if trial.purpose == Purpose::Anywhere && feasible {
            let inside = self.shows(trial.query.instance);
            self.report.found += 1;
            self.report.inside += u32::from(inside);
        }
        let Certificate {
            draws,
            feasible: worked,
            ..
        } = self.report.certificate;
        // As long as everything works, the region is everything.
        let all = self.report.infeasible == 0 && trial.purpose == Purpose::Anywhere;
        let certifies = u32::from(all || trial.purpose == Purpose::Certify);
        let worked = worked + certifies * u32::from(feasible);
        let confidence = self.config.confidence;
        self.report.certificate = Certificate::new(draws + certifies, worked, confidence);
    }

    /// Whether the region has the sample in it whose left sides are in `lhs`.
    fn shows(&self, instance: usize) -> bool {
        let tuning = self.config.tuning;
        let holds = |bound: &Bound<R>| {
            self.forms.value(&bound.form, instance, self.lhs) <= bound.threshold(tuning)
        };
        let mut clauses = self.shown_clauses();
        clauses.all(|(_, clause)| clause.bounds().any(holds))
    }

    /// Tells the forms of a sample.
    #[inline(never)]
    fn take_in(&mut self, trial: &Trial) {
        let Query { instance, .. } = trial.query;
        let source = (instance, trial.purpose != Purpose::Doubt);
        if trial.lead > 0 {
            self.report.feasible += 1;
            let steps = self.capacity.steps;
            return self.forms.add(source, self.lhs, steps, None);
        }
        self.report.infeasible += 1;
        let failed = usize::from(trial.failed_step.saturating_sub(1));
        self.forms.add(source, self.lhs, failed, Some(failed));
    }

    fn note_influence(&mut self, query: &Query, feasible: bool) {
        let differs = |o: &Observation| {
            let elsewhere = o.instance as usize != query.instance;
            let apart = if self.unasked.is_some() {
                elsewhere
            } else {
                !elsewhere && o.theta != query.theta
            };
            apart && o.outcome.label() == Some(!feasible)
        };
        self.influence |= !self.influence && self.observations.as_slice().iter().any(differs);
    }

    fn check_step(&self, outcome: Outcome) -> Result<(), Error> {
        match outcome {
            Outcome::FailedStep(step) if usize::from(step) > self.capacity.steps => Err(
                Error::InvalidArgument("the learner has room for fewer steps than this one"),
            ),
            _ => Ok(()),
        }
    }
}
