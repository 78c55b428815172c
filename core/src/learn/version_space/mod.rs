//! The sound learner: every explanation of the answers, and questions that tell
//! them apart.
//!
//! *Forms.* A form is a difference `left - right` of a feature of the sample and
//! a feature of the instance, or nothing. A constraint bounds a form from one
//! side. The thresholds that agree with the answers are an interval [S, G): S is
//! the extreme value over the feasible samples, G that of the first infeasible
//! sample that the constraint has to exclude (Mitchell 1982).
//!
//! *Soundness.* A feasible sample satisfies every constraint, so it widens S of
//! every form; a form that excludes nothing is harmless. An infeasible sample
//! only says that some constraint fails, so it deletes nothing: it is kept, and
//! every explanation must exclude it. S of every form and the list of infeasible
//! samples are the whole version space (Hirsh, Mishra and Pitt 1997; Hirsh 1992).
//!
//! *Explanations* are the fewest and simplest forms that exclude all infeasible
//! samples, by greedy set cover (Haussler 1988; the set covering machine of
//! Marchand and Shawe-Taylor 2002). A committee of them, blurred by chance, votes
//! on candidates, and where the vote is split is asked (query by committee,
//! Seung, Opper and Sompolinsky 1992); where all agree, in the widest gap between
//! S and G. Some questions look anywhere, for a gap that nobody suspects.
//!
//! *Which explanation is best* is a matter of length in bits: that of its constraints,
//! and that of what strays from them (minimum description length, Rissanen 1978). When
//! it becomes longer, or when nothing is left to ask, there is an election among
//! explanations that are improved constraint by constraint.
//!
//! *Soft boundaries.* Some actions work a little beyond a boundary, or fail a little
//! before it. Where [`Config::slack`] allows, an instance may have a boundary of its
//! own, for a price that grows with how far it lies off. Without slack, or without such
//! instances, the region agrees with every answer.
//!
//! *More than bounds.* Where no bound excludes an infeasible sample, or only many do, a
//! constraint may have two bounds, one of which must hold: an excluded interval of one
//! form, or a feasible set of two pieces.
//!
//! *Names.* If the simplest constant expression of the grammar in [S, G) is the
//! only one of its kind, it is the threshold: measurements then end in exact
//! values.
//!
//! *Chains.* An answer says which step of a sequence of actions failed. A sample
//! is feasible for every step before, infeasible for that one, and says nothing
//! about later ones. Each step has S and explanations of its own; the region is
//! the conjunction.
//!
//! *Wrong answers.* With a configured rate of noise a sample is asked again until
//! one answer leads by so much that doubt is negligible (sequential test, Wald
//! 1945): noise costs answers, not soundness.
//!
//! *Certificate.* The last questions are uniform draws from the region. As long as
//! they work the region is not touched; one that fails changes it, and counting
//! begins anew. So the draws are independent of the region that they certify
//! (Clopper and Pearson 1934).
//!
//! *Actions without parameters* are sampled by their instances, each once: the region
//! tells in which states they work.
//!
//! *Honesty.* There is no region if an infeasible sample is excluded by nothing, if the
//! explanation is not much shorter than the answers that it explains, or if no instance
//! has both feasible and infeasible samples: then the parameters were not shown to
//! matter.

mod ask;
mod bound;
mod certificate;
mod chosen;
mod clause;
mod config;
mod cover;
mod deliberate;
mod explain;
mod forms;
mod greedy;
mod membership;
mod name;
mod question;
mod set;

pub use certificate::Certificate;
pub use config::{Capacity, Config, Evidence, MAX_OBSERVATIONS, Memory, Report};
pub use cover::Cover;
pub use forms::{Sample, Span};
pub use membership::Membership;

use super::log::Observation;
use super::problem::Problem;
use super::{Learner, Outcome, Query, cut};
use crate::domain::Domain;
use crate::error::Error;
use crate::random::{Generator, generator};
use crate::real::Real;
use crate::region::Region;
use crate::table::Table;
use crate::wire::CHECKSUM;
use cover::MEMBERS;
use forms::{Forms, Storage};

/// By how much more likely an answer must be than its opposite.
const BEYOND_DOUBT: f64 = 10_000.0;
/// Explanations that compete to be the final one.
const CANDIDATES: usize = 16;

/// A question and what is known of its answer.
#[derive(Clone, Copy, Debug)]
struct Pending {
    query: Query,
    /// How many more answers said feasible than infeasible.
    lead: i32,
    /// The step that failed last, from one.
    failed_step: u8,
    /// Whether it is drawn from the region, to certify it.
    certifying: bool,
}

/// The sound learner. See the [module](self).
#[derive(Debug)]
pub struct VersionSpace<'m, R> {
    config: Config,
    capacity: Capacity,
    forms: Forms<'m, R>,
    /// Room for the left sides at a sample.
    lefts: &'m mut [R],
    /// Explanations, the best of each step first.
    covers: &'m mut [Cover<R>],
    observations: Table<'m, Observation>,
    rng: Generator,
    pending: Option<Pending>,
    problem: Option<u32>,
    /// Instances that were not asked about, if there is nothing else to ask about.
    unasked: Option<u32>,
    /// How far one answer must lead.
    needed_lead: i32,
    /// Whether some instance has feasible and infeasible samples.
    influence: bool,
    certifying: bool,
    /// When so many answers are left, certifying begins.
    certify_from: u32,
    /// Whether the best explanations won an election and still hold.
    elected: bool,
    /// How long the best explanations were at the last election, in bits.
    standing: f64,
    /// How many samples there were then.
    electors: usize,
    region: &'m mut Region,
    support: Table<'m, Evidence>,
    report: Report,
}

impl<'m, R: Real> VersionSpace<'m, R> {
    /// A learner about the parameters of `domain`, with the room of `capacity`.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] if a table of `memory` is shorter than
    /// `capacity` needs, or for a configuration out of range.
    pub fn new(
        domain: &Domain<'_>,
        config: Config,
        capacity: Capacity,
        memory: Memory<'m, R>,
    ) -> Result<Self, Error> {
        let mut learner = VersionSpace::blank(config, capacity, memory)?;
        learner.settle(domain)?;
        Ok(learner)
    }

    /// As [`VersionSpace::new`], without a domain: to be completed by
    /// [`VersionSpace::settle`] where it will stay. On a small machine, less is on the
    /// stack at a time.
    ///
    /// # Errors
    /// Those of [`VersionSpace::new`].
    pub fn blank(config: Config, capacity: Capacity, memory: Memory<'m, R>) -> Result<Self, Error> {
        config.check()?;
        capacity.check()?;
        let Memory {
            features,
            columns,
            instances,
            spans,
            bits,
            rows,
            lefts,
            sets,
            covers,
            samples,
            observations,
            support,
            region,
        } = memory;
        let covers = cut(covers, capacity.covers())?;
        covers.iter_mut().for_each(Cover::clear);
        let forms = Forms::new(Storage {
            features: cut(features, capacity.features())?,
            columns: cut(columns, capacity.features())?,
            instances: cut(instances, capacity.instance_values())?,
            spans: cut(spans, capacity.spans())?,
            bits: cut(bits, capacity.bits())?,
            rows: cut(rows, capacity.rows())?,
            sets: cut(sets, capacity.sets())?,
            samples: cut(samples, capacity.observations)?,
            forms: capacity.forms,
            tracked: capacity.tracked(),
            lefts: capacity.lefts(),
        });
        Ok(VersionSpace {
            observations: Table::new(cut(observations, capacity.observations)?, "observations"),
            rng: generator(config.seed),
            needed_lead: needed_lead(config.noise),
            certify_from: config.certifying,
            config,
            capacity,
            forms,
            lefts: cut(lefts, capacity.lefts())?,
            covers,
            pending: None,
            problem: None,
            unasked: None,
            influence: false,
            certifying: false,
            elected: false,
            standing: 0.0,
            electors: 0,
            region,
            support: Table::new(cut(support, capacity.support())?, "constraints of a region"),
            report: Report::default(),
        })
    }

    /// Makes a learner from [`VersionSpace::blank`] one about the parameters of `domain`.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] if there is no room for any feature.
    pub fn settle(&mut self, domain: &Domain<'_>) -> Result<(), Error> {
        self.region.clear(domain);
        self.forms.enumerate(domain)
    }

    /// The configuration it was made with.
    pub fn config(&self) -> &Config {
        &self.config
    }

    /// How learning went so far.
    pub fn report(&self) -> Report {
        self.report
    }

    /// What supports each constraint of the region, in their order.
    pub fn evidence(&self) -> &[Evidence] {
        self.support.as_slice()
    }

    fn constraints(&self) -> usize {
        let best = self.covers.iter().step_by(MEMBERS);
        best.map(|cover| cover.chosen.len()).sum()
    }

    fn is_explained(&self) -> bool {
        let constraints = self.constraints();
        self.report.feasible > 0
            && constraints > 0
            && self.influence
            && self
                .covers
                .iter()
                .step_by(MEMBERS)
                .all(|cover| cover.complete)
            && self.is_significant()
    }

    /// Gets to know the instances, at the first question.
    #[inline(never)]
    fn begin(&mut self, problem: &Problem<'_>) -> Result<(), Error> {
        self.forms.settle(problem)?;
        self.report.forms = self.forms.len();
        self.report.forms_left_out = self.forms.left_out();
        self.problem = Some(problem.fingerprint());
        let count = u32::try_from(problem.count()).unwrap_or(u32::MAX);
        self.unasked = problem.domain().parameters().is_empty().then_some(count);
        Ok(())
    }

    /// Takes a sample whose answer is beyond doubt; its left sides are in `lefts`.
    fn learn(&mut self, domain: &Domain<'_>, pending: &Pending) {
        let feasible = pending.lead > 0;
        self.take_in(pending);
        self.note_influence(&pending.query, feasible);
        let moved = self.mend_best();
        let Certificate {
            mut draws,
            feasible: mut worked,
            ..
        } = self.report.certificate;
        if pending.certifying {
            draws += 1;
            worked += u32::from(feasible);
        }
        self.report.certificate = Certificate::new(draws, worked, self.config.confidence);
        match (pending.certifying, feasible) {
            (true, true) => {}
            (false, _) if !moved => self.count_support(domain),
            (true, false) => {
                // Half of the answers that are left may find out what is wrong.
                (self.certifying, self.certify_from) = (false, self.calls_left() / 2);
                self.rebuild_region(domain);
            }
            (false, _) => self.rebuild_region(domain),
        }
    }

    /// Tells the forms of a sample.
    #[inline(never)]
    fn take_in(&mut self, pending: &Pending) {
        let Query { instance, .. } = pending.query;
        if pending.lead > 0 {
            self.report.feasible += 1;
            let steps = self.capacity.steps;
            return self.forms.add(instance, self.lefts, steps, None);
        }
        self.report.infeasible += 1;
        let failed = usize::from(pending.failed_step.saturating_sub(1));
        self.forms.add(instance, self.lefts, failed, Some(failed));
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

/// How far one answer must lead to be beyond doubt.
fn needed_lead(noise: f64) -> i32 {
    let ratio = (1.0 - noise) / noise;
    let mut likelihood = ratio;
    let mut lead = 1;
    while likelihood < BEYOND_DOUBT && lead < 32 {
        likelihood *= ratio;
        lead += 1;
    }
    lead
}

impl<R: Real> Learner for VersionSpace<'_, R> {
    fn ask(&mut self, problem: &Problem<'_>) -> Result<Query, Error> {
        if self.problem.is_none() {
            self.begin(problem)?;
        }
        problem.check_begun(self.problem)?;
        if self.pending.is_none() {
            let before = (self.rng.clone(), self.certifying);
            let chosen = self.next_query(problem);
            if chosen.is_err() {
                (self.rng, self.certifying) = before;
            }
            chosen?;
        }
        let pending = self.pending.as_ref().map(|pending| pending.query);
        pending.ok_or(Error::OutOfSequence("there is nothing to ask"))
    }

    fn tell(&mut self, problem: &Problem<'_>, outcome: Outcome) -> Result<(), Error> {
        let Some(mut pending) = self.pending else {
            return Err(Error::OutOfSequence("ask for a sample before telling"));
        };
        problem.check_begun(self.problem)?;
        self.check_step(outcome)?;
        let observation = Observation::new(&pending.query, outcome)?;
        self.forms
            .evaluate_query(problem, &pending.query, self.lefts)?;
        self.observations.push(observation)?;
        // Nothing fails from here on: a call that fails changes nothing.
        self.report.calls += 1;
        match outcome {
            Outcome::Feasible => pending.lead += 1,
            Outcome::FailedStep(step) => {
                pending.lead -= 1;
                pending.failed_step = step;
            }
            Outcome::Unknown => self.report.unknown += 1,
        }
        let decided = pending.lead.abs() >= self.needed_lead;
        if !decided && outcome != Outcome::Unknown {
            self.pending = Some(pending);
            return Ok(());
        }
        self.pending = None;
        self.unasked = self.unasked.map(|count| count.saturating_sub(1));
        if decided {
            self.learn(problem.domain(), &pending);
        }
        if self.is_finished() && !self.certifying {
            self.elect(problem.domain());
        }
        Ok(())
    }

    fn is_finished(&self) -> bool {
        self.calls_left() == 0
    }

    fn region(&self) -> Result<&Region, Error> {
        if self.is_explained() {
            Ok(self.region)
        } else {
            Err(Error::NoRegion)
        }
    }

    fn observations(&self) -> &[Observation] {
        self.observations.as_slice()
    }

    fn room(&self) -> usize {
        self.observations.capacity()
    }

    fn fingerprint(&self) -> u32 {
        let mut digest = CHECKSUM.digest();
        digest.update(b"version_space");
        digest.update(R::NAME.as_bytes());
        let Capacity {
            forms,
            tracked: _,
            observations: _,
            instances: _,
            steps,
        } = self.capacity;
        for number in [self.config.seed, forms as u64, steps as u64] {
            digest.update(&number.to_le_bytes());
        }
        for number in [self.config.calls, self.config.certifying] {
            digest.update(&number.to_le_bytes());
        }
        for number in [
            self.config.exploring,
            self.config.noise,
            self.config.slack,
            self.config.confidence,
        ] {
            digest.update(&number.to_bits().to_le_bytes());
        }
        digest.finalize()
    }
}
