//! The sound learner: every explanation of the answers, and queries that tell
//! them apart.
//!
//! *Forms.* A form is a difference `lhs - rhs` of a feature of the sample and
//! a feature of the instance, or nothing. A bound limits a form from one
//! side. The thresholds that agree with the answers are an interval [S, G): S is
//! the extreme value over the feasible samples, G that of the first infeasible
//! sample that the bound has to exclude (Mitchell 1982).
//!
//! *Soundness.* A feasible sample satisfies every constraint, so it extends S of
//! every form; a form that excludes nothing is harmless. An infeasible sample
//! only says that some constraint fails, so it deletes nothing: it is kept, and
//! every hypothesis must exclude it. S of every form and the list of infeasible
//! samples are the whole version space (Hirsh, Mishra and Pitt 1997; Hirsh 1992).
//!
//! *Hypotheses* are conjunctions of the fewest and simplest clauses that exclude all
//! infeasible samples, by greedy set cover (Haussler 1988; the set covering machine of
//! Marchand and Shawe-Taylor 2002). A committee of them, chosen with some chance, votes
//! on candidates, and where the vote is split is asked (query by committee,
//! Seung, Opper and Sompolinsky 1992); where all agree, in the widest gap between
//! S and G. Some queries look anywhere, for a gap that nobody suspects.
//!
//! *Which hypothesis is best* is a matter of length in bits: that of its clauses,
//! and that of what strays from them (minimum description length, Rissanen 1978). When
//! it becomes longer, or when nothing is left to ask, one is selected anew among
//! hypotheses that are improved clause by clause.
//!
//! *Soft boundaries.* Some actions work a little beyond a boundary, or fail a little
//! before it. Where [`Config::slack`] allows, an instance may have a boundary of its
//! own, for a price that grows with how far it lies off. Without slack, or without such
//! instances, the region agrees with every answer.
//!
//! *More than bounds.* Where no bound excludes an infeasible sample, or only many do, a
//! clause may be a disjunction of two bounds: an excluded interval of one
//! form, or a feasible set of two pieces.
//!
//! *Names.* If the simplest constant expression of the grammar in [S, G) is the
//! only one of its kind, it is the threshold: measurements then end in exact
//! values.
//!
//! *Chains.* An outcome says which step of a sequence of actions failed. A sample
//! is feasible for every step before, infeasible for that one, and says nothing
//! about later ones. Each step has S and hypotheses of its own; the region is
//! the conjunction.
//!
//! *Wrong answers.* With a configured rate of noise a sample is asked again until
//! one outcome leads by so much that doubt is negligible (sequential test, Wald
//! 1945): noise costs calls, not soundness.
//!
//! *Certificate.* The last queries are uniform draws from the region. As long as
//! they work the region is not touched; one that fails changes it, and counting
//! begins anew. So the draws are independent of the region that they certify
//! (Clopper and Pearson 1934).
//!
//! *Actions without parameters* are sampled by their instances, each once: the region
//! tells in which states they work.
//!
//! *Honesty.* There is no region if an infeasible sample is excluded by nothing, if the
//! hypothesis is not much shorter than the answers that it explains, or if no instance
//! has both feasible and infeasible samples: then the parameters were not shown to
//! matter.
//!
//! | file | what is in it |
//! |---|---|
//! | `forms/` | forms: their values, S, and which infeasible samples each excludes |
//! | `bound`, `clause`, `hypothesis` | what a region is made of; `disjunction`, `greedy` and `improve` look for it |
//! | `committee` | the hypotheses that are known, and their votes |
//! | `selection` | repairing and selecting hypotheses |
//! | `describe`, `name` | clauses in words of the domain |
//! | `query/` | which sample to ask about, a file for each strategy |
//! | `tuning` | all numbers that decide what is learned |

mod approximate;
mod bound;
mod certificate;
mod clause;
mod committee;
mod config;
mod describe;
mod disjunction;
mod forms;
mod greedy;
mod hypothesis;
mod improve;
mod membership;
mod memory;
mod name;
mod quality;
mod query;
mod report;
mod selection;
mod tuning;

pub use certificate::Certificate;
pub use config::Config;
pub use forms::{End, Failure, Interval, Left, Sample, Sum};
pub use hypothesis::Hypothesis;
pub use membership::Membership;
pub use memory::{Capacity, MAX_OBSERVATIONS, MAX_SUMS, Memory};
pub use quality::{Quality, Why};
pub use report::{Evidence, Report};
pub use tuning::Tuning;

use super::log::Observation;
use super::problem::Problem;
use super::{Learner, Outcome, Query};
use crate::domain::Domain;
use crate::error::Error;
use crate::random::{Generator, generator};
use crate::real::Real;
use crate::region::Region;
use crate::table::Table;
use crate::wire::CHECKSUM;
use committee::Committee;
use forms::Forms;
use selection::Selection;

/// A query and what is known of its label.
#[derive(Clone, Copy, Debug)]
struct Pending {
    query: Query,
    /// How many more outcomes were feasible than infeasible.
    lead: i32,
    /// The step that failed last, from one.
    failed_step: u8,
    purpose: Purpose,
}

/// What a query is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Purpose {
    /// To tell hypotheses apart.
    Doubt,
    /// It is drawn from the region, to certify it.
    Certify,
    /// It is drawn from the region, to learn what is wrong with it.
    Draw,
    /// It is drawn from everything.
    Anywhere,
}

/// The sound learner. See the [module](self).
#[derive(Debug)]
pub struct VersionSpace<'m, R> {
    config: Config,
    capacity: Capacity,
    forms: Forms<'m, R>,
    /// Room for the left sides at a sample.
    lhs: &'m mut [R],
    committee: Committee<'m, R>,
    /// For each step, the hypothesis that explains most answers.
    approximations: &'m mut [Hypothesis<R>],
    /// Whether the region is made of those.
    approximating: bool,
    /// Which share of it must work.
    wanted: f64,
    selection: Selection,
    observations: Table<'m, Observation>,
    rng: Generator,
    pending: Option<Pending>,
    problem: Option<u32>,
    /// Instances that were not asked about, if there is nothing else to ask about.
    unasked: Option<u32>,
    /// How far one outcome must lead.
    needed_lead: i32,
    /// Whether some instance has feasible and infeasible samples.
    influence: bool,
    certifying: bool,
    /// When so many calls are left, certifying begins.
    certify_from: u32,
    region: &'m mut Region,
    /// What supports the constraints of the region.
    evidence: Table<'m, Evidence>,
    report: Report,
}

impl<'m, R: Real> VersionSpace<'m, R> {
    /// A learner about the parameters of `domain`, with the room of `capacity`.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] if a table of `memory` is shorter than
    /// `capacity` needs, or for a configuration out of range;
    /// [`Error::CapacityExceeded`] if there is no room for any feature.
    pub fn new(
        domain: &Domain<'_>,
        config: Config,
        capacity: Capacity,
        memory: Memory<'m, R>,
    ) -> Result<Self, Error> {
        let mut learner = VersionSpace::blank(config, capacity, memory)?;
        learner.enumerate(domain)?;
        Ok(learner)
    }

    /// As [`VersionSpace::new`], without a domain: to be completed by
    /// [`VersionSpace::enumerate`] where it will stay. On a small machine, less is on the
    /// stack at a time.
    ///
    /// # Errors
    /// Those of [`VersionSpace::new`].
    pub fn blank(config: Config, capacity: Capacity, memory: Memory<'m, R>) -> Result<Self, Error> {
        config.check()?;
        capacity.check()?;
        let mut memory = memory.cut(capacity)?;
        let forms = Forms::new(config.tuning, capacity, &mut memory);
        let [region, ..] = memory.region else {
            return Err(Error::InvalidArgument("a learner needs room for a region"));
        };
        Ok(VersionSpace {
            observations: Table::new(memory.observations, "observations"),
            rng: generator(config.seed),
            needed_lead: needed_lead(config.noise, config.tuning.beyond_doubt),
            certify_from: config.certifying,
            approximations: memory.approximations,
            approximating: false,
            wanted: wanted(&config),
            config,
            capacity,
            forms,
            lhs: memory.lhs,
            committee: Committee::new(memory.hypotheses),
            selection: Selection::default(),
            pending: None,
            problem: None,
            unasked: None,
            influence: false,
            certifying: false,
            region,
            evidence: Table::new(memory.evidence, "constraints of a region"),
            report: Report::default(),
        })
    }

    /// Makes a learner from [`VersionSpace::blank`] one about the parameters of `domain`,
    /// whose features it enumerates.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] if there is no room for any feature.
    pub fn enumerate(&mut self, domain: &Domain<'_>) -> Result<(), Error> {
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
        self.evidence.as_slice()
    }

    fn is_explained(&self) -> bool {
        self.report.feasible > 0
            && self.committee.best_clauses().next().is_some()
            && self.influence
            && self.committee.is_consistent()
            && self.is_significant()
    }

    /// Gets to know the instances, at the first query.
    #[inline(never)]
    fn begin(&mut self, problem: &Problem<'_>) -> Result<(), Error> {
        self.forms.lay_out(problem)?;
        self.report.forms = self.forms.len();
        self.report.forms_left_out = self.forms.left_out();
        self.problem = Some(problem.fingerprint());
        let count = u32::try_from(problem.count()).unwrap_or(u32::MAX);
        self.unasked = problem.domain().parameters().is_empty().then_some(count);
        Ok(())
    }

    /// Takes a sample whose label is decided; its left sides are in `lhs`.
    fn learn(&mut self, domain: &Domain<'_>, pending: &Pending) {
        let feasible = pending.lead > 0;
        let certifies = pending.purpose == Purpose::Certify;
        self.take_in(pending);
        self.note_influence(&pending.query, feasible);
        let moved = self.repair_best();
        self.count(pending);
        if self.approximating {
            return;
        }
        match (certifies, feasible) {
            (true, true) => {}
            (false, _) if !moved => self.count_support(domain),
            (true, false) => {
                // Some of the calls that are left may find out what is wrong.
                let again = f64::from(self.calls_left()) * self.config.tuning.certify_again;
                (self.certifying, self.certify_from) = (false, again as u32);
                self.rebuild_region(domain);
            }
            (false, _) => self.rebuild_region(domain),
        }
    }

    /// Counts what samples that were drawn at random tell about the region.
    fn count(&mut self, pending: &Pending) {
        let feasible = pending.lead > 0;
        if pending.purpose == Purpose::Anywhere && feasible {
            let inside = self.shows(pending.query.instance);
            self.report.found += 1;
            self.report.inside += u32::from(inside);
        }
        let Certificate {
            draws,
            feasible: worked,
            ..
        } = self.report.certificate;
        // As long as everything works, the region is everything.
        let all = self.report.infeasible == 0 && pending.purpose == Purpose::Anywhere;
        let certifies = u32::from(all || pending.purpose == Purpose::Certify);
        let worked = worked + certifies * u32::from(feasible);
        let confidence = self.config.confidence;
        self.report.certificate = Certificate::new(draws + certifies, worked, confidence);
    }

    /// Whether the region has the sample in it whose left sides are in `lhs`.
    fn shows(&self, instance: usize) -> bool {
        let tuning = self.config.tuning;
        let holds = |bound: &bound::Bound<R>| {
            self.forms.value(&bound.form, instance, self.lhs) <= bound.threshold(tuning)
        };
        let mut clauses = self.shown_clauses();
        clauses.all(|(_, clause)| clause.bounds().any(holds))
    }

    /// Tells the forms of a sample.
    #[inline(never)]
    fn take_in(&mut self, pending: &Pending) {
        let Query { instance, .. } = pending.query;
        let source = (instance, pending.purpose != Purpose::Doubt);
        if pending.lead > 0 {
            self.report.feasible += 1;
            let steps = self.capacity.steps;
            return self.forms.add(source, self.lhs, steps, None);
        }
        self.report.infeasible += 1;
        let failed = usize::from(pending.failed_step.saturating_sub(1));
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

/// Which share of the samples that a region admits must be feasible where it is chosen by
/// them, so that it is likely to be what is wanted where it is not.
fn wanted(config: &Config) -> f64 {
    let wanted = config.precision_wanted;
    wanted + config.tuning.optimism * (1.0 - wanted)
}

/// How far one outcome must lead, so that it is more likely than its opposite by a factor.
fn needed_lead(noise: f64, factor: f64) -> i32 {
    let ratio = (1.0 - noise) / noise;
    let mut likelihood = ratio;
    let mut lead = 1;
    while likelihood < factor && lead < 32 {
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
            .evaluate_query(problem, &pending.query, self.lhs)?;
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
            self.reselect(problem.domain());
        }
        Ok(())
    }

    fn is_finished(&self) -> bool {
        self.calls_left() == 0
    }

    fn region(&self) -> Result<&Region, Error> {
        match self.quality() {
            Quality::Exact | Quality::Approximate => Ok(self.region),
            Quality::None | Quality::Provisional => Err(Error::NoRegion),
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
            sums: _,
        } = self.capacity;
        let sums = self.capacity.sums() as u64;
        for number in [self.config.seed, forms as u64, steps as u64, sums] {
            digest.update(&number.to_le_bytes());
        }
        for number in [self.config.calls, self.config.certifying] {
            digest.update(&number.to_le_bytes());
        }
        for number in [
            self.config.precision_wanted,
            self.config.exploring,
            self.config.noise,
            self.config.slack,
            self.config.confidence,
        ] {
            digest.update(&number.to_bits().to_le_bytes());
        }
        self.config.tuning.digest(&mut |bytes| digest.update(bytes));
        digest.finalize()
    }
}
