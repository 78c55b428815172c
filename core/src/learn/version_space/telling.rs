//! Taking answers in, to questions and to what nobody asked.

use super::bound::Bound;
use super::certificate::Certificate;
use super::clause::Clause;
use super::forms::Origin;
use super::hypothesis::Hypothesis;
use super::query::Phase;
use super::{Step, VersionSpace};
use crate::domain::Domain;
use crate::error::Error;
use crate::learn::question::{KEPT, Purpose, Question, State, Trial};
use crate::learn::{Observation, Outcome, Problem, Query};
use crate::real::Real;

/// One of so many samples that nobody asked is put aside, to judge a region that is wrong about
/// some of them.
const ASIDE: u32 = 4;

/// What a learner did since the last observation. It is kept with the next one, so that a
/// learner that is resumed does it again.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Since {
    /// It is prepared for questions of this phase.
    pub(super) prepared: Option<Phase>,
    /// It was prepared for those of one before the last, or while no question was open.
    pub(super) early: bool,
    /// It began to select the best hypotheses after that, as there was nothing left to ask.
    pub(super) queued: bool,
    /// It selected them at once after that.
    pub(super) concluded: bool,
    /// It was prepared for those of a last phase then, because so many questions were open.
    pub(super) late: u8,
}

const PREPARED: u16 = 1 << 3;
const CONCLUDED: u16 = 1 << 4;
/// From this bit on, up to [`KEPT`]: how many questions were open.
const LATE: u32 = 5;
const QUEUED: u16 = 1 << 13;

impl Since {
    pub(super) fn notes(self) -> u16 {
        let noted = |done, bit| if done { bit } else { 0 };
        noted(self.early, PREPARED)
            | noted(self.queued, QUEUED)
            | noted(self.concluded, CONCLUDED)
            | u16::from(self.late) << LATE
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
            notes: trial.purpose as u16 | self.since.notes() | if self.quiet { KEPT } else { 0 },
            ..Observation::new(trial.query(), outcome)?
        };
        self.forms
            .evaluate_query(problem, trial.query(), self.lhs)?;
        let settles = self.settles(trial.query().instance);
        self.observations.push(observation)?;
        // Nothing fails from here on: a call that fails changes nothing.
        self.since = Since::default();
        self.forms.forget_work();
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
        if decided && self.quiet {
            self.take_in(&trial);
            self.note_influence(trial.query(), trial.lead > 0);
        }
        if self.quiet {
            return Ok(None);
        }
        if decided {
            self.learn(problem.domain(), &trial);
        }
        // A run that is resumed may have had more calls.
        let within = self.report.calls as u64 <= u64::from(self.config.calls);
        let last = asked && within && self.is_out_of_calls();
        if last && !self.certifying {
            self.reselect(problem.domain());
        } else if !asked && self.has_grown() {
            self.reselect_quickly(problem.domain());
        }
        Ok(None)
    }

    /// Does what led to an observation that was taken once, and takes it again. The first
    /// `kept` of the open questions stay what they are.
    pub(super) fn take_again(
        &mut self,
        problem: &Problem<'_>,
        saved: &Observation,
        kept: usize,
    ) -> Result<(), Error> {
        if saved.notes & KEPT != 0 {
            self.quiet = true;
        } else if !self.quiet {
            self.redo(problem.domain(), saved.notes);
        }
        let place = match saved.asked() {
            true => self.place_of_query(&saved.query()),
            false => None,
        };
        let known = place.and_then(|place| self.trials.as_slice().get(place));
        let purpose = match Purpose::of_notes(saved.notes)? {
            // With other calls it is not time for that: it was another region.
            Purpose::Certify if !self.certifying => Purpose::Draw,
            purpose => purpose,
        };
        let question = Question {
            id: 0,
            query: saved.query(),
        };
        let trial = known.copied().unwrap_or(Trial::new(question, purpose));
        let trial = Trial { purpose, ..trial };
        let left = self.take(problem, trial, saved.outcome)?;
        self.keep(place, left, kept)
    }

    /// Keeps what is left of a trial that was taken again.
    fn keep(
        &mut self,
        place: Option<usize>,
        left: Option<Trial>,
        kept: usize,
    ) -> Result<(), Error> {
        let known = place.and_then(|place| self.trials.as_mut_slice().get_mut(place));
        match (left, known, place) {
            (Some(left), Some(known), _) => *known = left,
            (Some(left), None, _) => self.trials.push(Trial {
                state: State::Again,
                ..left
            })?,
            // It is about the same sample as one that was decided before.
            (None, Some(known), Some(place)) if place < kept => known.lead = 0,
            (None, _, Some(place)) => self.trials.remove(place),
            (None, ..) => {}
        }
        Ok(())
    }

    /// Does what was done before a saved observation, or after the last one.
    pub(super) fn redo(&mut self, domain: &Domain<'_>, notes: u16) {
        if notes & PREPARED != 0 {
            self.prepare(domain, 0);
        }
        if notes & QUEUED != 0 {
            self.queue_selection(domain);
        }
        if notes & CONCLUDED != 0 {
            self.select_again(domain);
        }
        let late = (notes & (KEPT - 1)) >> LATE;
        if late != 0 {
            self.prepare(domain, late.into());
        }
    }

    /// Opens a question that was open when a run was saved.
    pub(super) fn restore_trial(&mut self, saved: Trial) -> Result<(), Error> {
        let again = self.place_of_query(saved.query());
        let again = again.filter(|place| {
            let known = self.trials.as_slice().get(*place);
            known.is_some_and(|known| known.state == State::Again)
        });
        let known = again.and_then(|place| self.trials.as_slice().get(place).copied());
        let known = known.unwrap_or(saved);
        if let Some(place) = again {
            self.trials.remove(place);
        }
        self.trials.push(Trial {
            lead: known.lead,
            failed_step: known.failed_step,
            ..saved
        })
    }

    /// Where the question about a sample stands.
    pub(super) fn place_of_query(&self, query: &Query) -> Option<usize> {
        let mut trials = self.trials.as_slice().iter();
        trials.position(|own| own.query() == query)
    }

    /// Whether an outcome in an instance settles it, where there is nothing but instances
    /// to ask about: another one did not before.
    fn settles(&self, instance: usize) -> bool {
        let mut trials = self.trials.as_slice().iter();
        let open = trials.any(|trial| trial.query().instance == instance);
        let mut own = self.observations.as_slice().iter();
        !own.any(|o| o.instance as usize == instance && !(o.asked() && open))
    }

    /// Takes a sample whose label is decided; its left sides are in `lhs`.
    fn learn(&mut self, domain: &Domain<'_>, trial: &Trial) {
        let feasible = trial.lead > 0;
        let certifies = trial.purpose == Purpose::Certify;
        self.take_in(trial);
        self.note_influence(trial.query(), feasible);
        // Where nobody asks and nothing explains all answers, the next selection does it.
        let told = trial.purpose == Purpose::Told;
        let waits = told && (self.approximating || !self.committee.is_consistent());
        let stays = waits || (told && self.is_settled(trial));
        let moved = !stays && self.repair_best();
        self.count(trial);
        if self.approximating {
            return;
        }
        // An answer to something else may come while the region is certified, too.
        let aside = self.certifying && moved && trial.purpose != Purpose::Anywhere;
        let refuted = certifies || aside;
        match (certifies, feasible) {
            (true, true) => {}
            (_, false) if refuted => {
                // Some of the calls that are left may find out what is wrong.
                let again = f64::from(self.calls_left()) * self.config.tuning.certify_again;
                (self.certifying, self.certify_from) = (false, again as u32);
                self.selection.last = false;
                self.outdate_draws();
                self.rebuild_region(domain);
            }
            _ if !moved => self.count_support(domain),
            _ => self.rebuild_region(domain),
        }
    }

    /// Whether the best hypotheses stay what they are with a sample more, whose left sides are in
    /// `lhs`; if so, they count it.
    fn is_settled(&mut self, trial: &Trial) -> bool {
        let feasible = trial.lead > 0;
        let failed = usize::from(trial.failed_step.saturating_sub(1));
        let instance = trial.query().instance;
        let (forms, lhs) = (&self.forms, &*self.lhs);
        let value = |bound: &Bound<R>| forms.value(&bound.form, instance, lhs);
        let beyond = |clause: &Clause<R>| clause.bounds().all(|own| value(own) >= own.outer);
        let settles = |(step, best): (usize, &Hypothesis<R>)| {
            let worked = feasible || step < failed;
            match worked {
                _ if best.is_strained() => false,
                true => best.clauses.iter().all(|clause| clause.admits(value)),
                false => step != failed || best.clauses.iter().any(beyond),
            }
        };
        if !self.committee.best().enumerate().all(settles) {
            return false;
        }
        if let (false, Some((_, (best, _)))) = (feasible, self.committee.steps_mut().nth(failed)) {
            best.count(value);
        }
        true
    }

    /// Counts what samples that were drawn at random tell about the region.
    fn count(&mut self, trial: &Trial) {
        let feasible = trial.lead > 0;
        // Nobody chose what is in a log by the region: it is as good as drawn from it or from
        // everything, with the chances of the log.
        let logged = trial.purpose == Purpose::Told && self.approximating;
        let counts = logged || (trial.purpose == Purpose::Anywhere && feasible);
        let inside = counts && self.shows(trial.query().instance);
        if counts && feasible {
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
        let drawn = trial.purpose == Purpose::Certify || (logged && inside);
        let certifies = u32::from(all || drawn);
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
        let origin = match trial.purpose {
            Purpose::Doubt => Origin::Chosen,
            // The same ones, however long the log is and whatever of it is kept.
            Purpose::Told if trial.query().checksum().is_multiple_of(ASIDE) => Origin::Aside,
            _ => Origin::Drawn,
        };
        let source = (trial.query().instance, origin);
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

    pub(super) fn check_step(&self, outcome: Outcome) -> Result<(), Error> {
        match outcome {
            Outcome::FailedStep(step) if usize::from(step) > self.capacity.steps => Err(
                Error::InvalidArgument("the learner has room for fewer steps than this one"),
            ),
            _ => Ok(()),
        }
    }
}
