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
//! *Sums.* Where it takes less to say, a form has a sum of scaled sizes on the right, or a
//! left side that is derived from several features or depends on the scene alone.
//!
//! *Nearly right.* Where nothing agrees with all answers, the region is the largest whose
//! precision is what is wanted, and [`Quality`] says so.
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
//! *Honesty.* There is no exact region if an infeasible sample is excluded by nothing, if the
//! hypothesis is not much shorter than the answers that it explains, or if no instance
//! has both feasible and infeasible samples: then the parameters were not shown to
//! matter.
//!
//! | file | what is in it |
//! |---|---|
//! | `forms/` | forms: their values, S, and which infeasible samples each excludes |
//! | `bound`, `clause`, `hypothesis` | what a region is made of; `disjunction`, `greedy` and `improve` look for it |
//! | `approximate`, `quality` | the best region where none is exact, and what a region is worth |
//! | `committee` | the hypotheses that are known, and their votes |
//! | `selecting`, `selection` | selecting hypotheses bit by bit; repairing them, and what comes of a selection |
//! | `describe`, `name` | clauses in words of the domain |
//! | `choosing` | instances of a source that are learned from |
//! | `open`, `telling`, `growing`, `thinning` | questions that are open; taking answers in; instances that arrive; logs that are longer than the table |
//! | `query/` | which sample to ask about, a file for each strategy |
//! | `tuning` | all numbers that decide what is learned |

mod approximate;
mod bound;
mod certificate;
mod choosing;
mod clause;
mod committee;
mod config;
mod describe;
mod disjunction;
mod forms;
mod greedy;
mod growing;
mod hypothesis;
mod improve;
mod membership;
mod memory;
mod name;
mod open;
mod quality;
mod query;
mod report;
mod selecting;
mod selection;
mod telling;
mod thinning;
mod tuning;

pub use certificate::Certificate;
pub use config::Config;
pub use forms::{End, Failure, Interval, Left, LeftOut, Sample, Sum};
pub use hypothesis::Hypothesis;
pub use membership::Membership;
pub use memory::{Capacity, MAX_OBSERVATIONS, MAX_SUMS, Memory};
pub use quality::{Quality, Why};
pub use report::{Evidence, Report};
pub use tuning::Tuning;

use super::log::{Notes, Observation};
use super::problem::{Begun, Problem};
use super::question::{KEPT, Purpose, Question, Trial};
use super::{Learner, OBSERVATIONS, Outcome, Query};
use crate::domain::{Domain, MAX_PARAMETERS};
use crate::error::Error;
use crate::random::{Generator, generator, mixed};
use crate::real::Real;
use crate::region::Region;
use crate::table::Table;
use crate::wire::CHECKSUM;
use committee::Committee;
use forms::Forms;
use selecting::Work;
use selection::Selection;
use telling::Since;

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
    /// The selection that is under way, and the hypothesis that it is about.
    work: Work,
    draft: &'m mut Hypothesis<R>,
    observations: Table<'m, Observation>,
    rng: Generator,
    /// The questions that are open, in the order in which they were asked.
    trials: Table<'m, Trial>,
    /// How many were asked.
    serial: u32,
    since: Since,
    /// Samples are taken in without a look for hypotheses.
    quiet: bool,
    problem: Option<Begun>,
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
        let ([region, ..], Some((draft, hypotheses))) =
            (memory.region, memory.hypotheses.split_last_mut())
        else {
            return Err(Error::InvalidArgument("a learner needs room for a region"));
        };
        Ok(VersionSpace {
            draft,
            work: Work::default(),
            observations: Table::new(memory.observations, OBSERVATIONS),
            rng: generator(config.seed),
            needed_lead: needed_lead(config.noise, config.tuning.beyond_doubt),
            certify_from: certifying_calls(&config),
            approximations: memory.approximations,
            approximating: false,
            wanted: wanted(&config),
            config,
            capacity,
            forms,
            lhs: memory.lhs,
            committee: Committee::new(hypotheses),
            selection: Selection::default(),
            trials: Table::new(memory.trials, "open questions"),
            serial: 0,
            since: Since::default(),
            quiet: false,
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
            && !self.is_strayed()
    }

    /// Whether so many samples stray from the best hypotheses that these do not explain them.
    fn is_strayed(&self) -> bool {
        let most = self.config.tuning.strays * self.forms.samples() as f64;
        self.committee.is_strained() && self.count_wrong(self.committee.best()) as f64 > most
    }

    /// Starts the random numbers of a step anew. They follow from what was told, not from
    /// what was asked, so that a run is resumed without asking again.
    fn reseed(&mut self, step: Step) {
        let told = self.observations.len() as u64;
        let mut seed = mixed(self.config.seed, 8 * told + step as u64);
        if let (Step::Ask, open @ 1..) = (step, self.open()) {
            seed = mixed(seed, open.into());
        }
        self.rng = generator(seed);
    }
}

/// What random numbers are for, of each length of the log.
#[derive(Clone, Copy)]
enum Step {
    Learn,
    Prepare,
    Conclude,
    Ask,
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

/// How many calls, the last ones, it takes to decide as many draws as are to certify the
/// region, which with wrong answers are several for each; but no more than a share of all that
/// are needed to learn, unless that was told.
fn certifying_calls(config: &Config) -> u32 {
    let lead = f64::from(needed_lead(config.noise, config.tuning.beyond_doubt));
    let each = lead / (1.0 - 2.0 * config.noise);
    let calls = libm::ceil(f64::from(config.certifying) * each);
    let most = config.tuning.judging * f64::from(config.calls);
    (calls.min(most) as u32).max(config.certifying)
}

impl<R: Real> Learner for VersionSpace<'_, R> {
    fn ask(&mut self, problem: &Problem<'_>) -> Result<Query, Error> {
        self.begin(problem)?;
        self.take_answers(problem, true)?;
        if let Some(open) = self.first_open() {
            return Ok(*open.query());
        }
        match self.ask_another(problem)? {
            Some(question) => Ok(question.query),
            None if self.is_out_of_calls() => Err(Error::OutOfSequence(
                "learning is finished: ask for the region",
            )),
            None => Err(Error::OutOfSequence("there is nothing to ask")),
        }
    }

    fn tell(&mut self, problem: &Problem<'_>, outcome: Outcome) -> Result<(), Error> {
        let Some(open) = self.first_open() else {
            return Err(Error::OutOfSequence("ask for a sample before telling"));
        };
        let id = open.question.id;
        self.answer(problem, id, outcome)
    }

    fn ask_more(&mut self, problem: &Problem<'_>) -> Result<Option<Question>, Error> {
        self.ask_another(problem)
    }

    fn tell_id(&mut self, problem: &Problem<'_>, id: u64, outcome: Outcome) -> Result<(), Error> {
        self.answer(problem, id, outcome)
    }

    fn forget(&mut self, id: u64) -> Result<(), Error> {
        self.give_up(id)
    }

    fn observe(
        &mut self,
        problem: &Problem<'_>,
        query: &Query,
        outcome: Outcome,
    ) -> Result<(), Error> {
        self.begin(problem)?;
        let mut own = Query {
            theta: [0.0; MAX_PARAMETERS],
            ..*query
        };
        let parameters = problem.domain().parameters();
        for ((to, from), _) in own.theta.iter_mut().zip(&query.theta).zip(parameters) {
            *to = *from;
        }
        let used = own.theta.get(..parameters.len()).unwrap_or_default();
        // All that can be wrong with it is found out before others make room for it.
        problem.domain().check_parameters(used)?;
        problem.instance(own.instance)?;
        self.check_step(outcome)?;
        Observation::new(&own, outcome)?;
        self.check_room()?;
        self.make_room(problem)?;
        // It has no number: nobody waits for an answer.
        let question = Question { id: 0, query: own };
        let trial = Trial::new(question, Purpose::Told);
        self.take(problem, trial, outcome)?;
        Ok(())
    }

    fn conclude(&mut self, problem: &Problem<'_>) -> Result<(), Error> {
        self.begin(problem)?;
        self.take_answers(problem, true)?;
        if !self.is_finished() {
            self.prepare(problem.domain(), self.open());
        }
        // Where draws are on their way, the region stays what they are drawn from; and one that
        // was judged by what was told since is not exchanged for one that nobody judged.
        let judged =
            self.approximating && self.certifying && self.quality() == Quality::Approximate;
        let stays = self.since.late > 0 || judged;
        if !stays && !self.selection.is_of(self.forms.samples()) {
            self.select_again(problem.domain());
        }
        Ok(())
    }

    fn trials(&self) -> &[Trial] {
        self.trials.as_slice()
    }

    fn notes(&self) -> Notes {
        Notes {
            since: self.since.notes(),
            asked: self.serial,
            dropped: self.report.dropped,
        }
    }

    fn replay(&mut self, problem: &Problem<'_>, saved: &Observation) -> Result<(), Error> {
        self.begin(problem)?;
        if saved.notes & KEPT == 0 {
            self.end_quiet(problem.domain());
        }
        self.make_room(problem)?;
        self.serial = self.serial.wrapping_add(u32::from(saved.asked()));
        self.take_again(problem, saved, 0)
    }

    fn reopen(&mut self, problem: &Problem<'_>, notes: Notes) -> Result<(), Error> {
        if self.quiet || notes.since != 0 {
            self.begin(problem)?;
            self.end_quiet(problem.domain());
            self.redo(problem.domain(), notes.since);
        }
        self.serial = notes.asked;
        self.report.observed += notes.dropped - self.report.dropped.min(notes.dropped);
        self.report.dropped = notes.dropped;
        Ok(())
    }

    fn restore(&mut self, problem: &Problem<'_>, saved: Trial) -> Result<(), Error> {
        self.begin(problem)?;
        problem.instance(saved.query().instance)?;
        self.restore_trial(saved)
    }

    fn restart(&mut self, domain: &Domain<'_>) {
        self.trials.clear();
        self.report.dropped = 0;
        self.forget(domain);
        (self.serial, self.quiet) = (0, false);
        (self.problem, self.unasked) = (None, None);
    }

    fn is_finished(&self) -> bool {
        self.is_out_of_calls()
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
            questions: _,
        } = self.capacity;
        let sums = self.capacity.sums() as u64;
        for number in [self.config.seed, forms as u64, steps as u64, sums] {
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
