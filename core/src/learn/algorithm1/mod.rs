//! Algorithm 1 of the thesis (4.3): hypotheses that are pruned by samples.
//!
//! Hypotheses `left op right` are enumerated, simple ones first, up to a
//! capacity. Two manual samples, z- and z+, are tried in the first instance; then
//! K samples are drawn from the region that the hypotheses define. A feasible
//! sample removes the hypotheses that are false at it (Eq. 4.8), an infeasible
//! one those that are true (Eq. 4.9).
//!
//! It is the baseline, and it is fragile: if an action needs several conditions
//! at once, an infeasible sample only says that *some* condition fails, but Eq.
//! 4.9 removes every condition that holds. As samples are drawn where all
//! hypotheses hold, one infeasible sample in the active loop usually empties the
//! set.
//!
//! Where the thesis can be read in several ways, this is the reading:
//!
//! - *Sample and instance* (lines 15 and 16): the instance is selected first,
//!   uniformly, and the sample is drawn from the region in that instance; a bound
//!   on a feature of the sample means nothing without an instance.
//! - *The sets of an iteration* (line 17 empties only `H_True`): both sets are
//!   made anew in each iteration.
//! - *The manual samples* are simulated like any other, and the outcome counts,
//!   not the expectation: a z+ that fails is treated by Eq. 4.9.
//! - *Numeric right sides* (5.2): hypotheses stay symbolic and are validated
//!   symbolically. At every feasible sample each survivor's right side is
//!   evaluated, and the tightest value so far is its numeric bound. The region is
//!   made of these bounds; before the first feasible sample it is everything.
//! - *Dominance* (Eq. 4.11 and 4.12), after every feasible sample: of all
//!   survivors that bound the same left side from the same direction only the
//!   tightest is kept, the smallest upper or the largest lower bound; `<` is
//!   tighter than `<=`, and among equals the simplest is kept.
//! - *The empty region*: if no parameters in the selected instance satisfy the
//!   bounds, the sample is drawn from the whole parameter space. If no hypothesis
//!   is left, nothing can be learned any more, and learning ends without a region.
//! - *Redundant hypotheses* are part of the result, as in the thesis. More than
//!   [`MAX_CONSTRAINTS`](crate::grammar::MAX_CONSTRAINTS) are cut off at the
//!   complex end, and the report says how many.

mod bounds;
mod config;

pub use bounds::Bounds;
pub use config::{Capacity, Config, Memory, Report};

use super::log::{Notes, Observation};
use super::problem::{Begun, Problem};
use super::question::{Purpose, Question, State, Trial};
use super::{Learner, OBSERVATIONS, Outcome, Query};
use crate::domain::{Dependence, Domain, MAX_PARAMETERS, Node, Parameter, PointSet, Scene};
use crate::error::Error;
use crate::grammar::{Features, Formula, Hypotheses, Inequality};
use crate::random::{Generator, below, generator, uniform_in};
use crate::real::Real;
use crate::region::{Region, Theta};
use crate::table::Table;
use crate::wire::CHECKSUM;
use bounds::BoundTable;

/// Where learning stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Phase {
    Negative,
    Positive,
    Active(u32),
    Finished,
}

/// The thesis's learner.
///
/// ```
/// use critreg::domain::Domain;
/// use critreg::learn::algorithm1::{Bounds, Capacity, Config, Memory};
/// use critreg::learn::{Algorithm1, Observation, Outcome, Problem, learn_region};
/// use critreg::{domain::Node, table::Blank};
/// # fn main() -> Result<(), critreg::Error> {
/// let domain = Domain::parse(
///     "object wall { x: length, y: length }
///      parameter reach in [0, 4]: length
///      point hand = world + (reach, 0)",
/// )?;
/// let problem = Problem::new(&domain, &[2.0, 0.0, 3.0, 0.0], 2)?;
/// let capacity = Capacity { hypotheses: 1024, observations: 64 };
/// let memory = Memory {
///     features: &mut [Node::BLANK; 160],
///     values: &mut [0.0; 160],
///     pairs: &mut [0; 256],
///     bounds: &mut [Bounds::BLANK; 40],
///     observations: &mut [Observation::BLANK; 64],
/// };
/// let theta = |reach| [reach, 0.0, 0.0, 0.0, 0.0, 0.0];
/// let config = Config {
///     iterations: 20,
///     negative: Some(theta(3.5)),
///     positive: Some(theta(0.5)),
///     ..Config::default()
/// };
/// let mut learner = Algorithm1::<f64>::new(&domain, config, capacity, memory)?;
/// // The hand must stay before the wall.
/// let region = learn_region(&mut learner, &problem, |_, query| {
///     let wall = problem.instance(query.instance)?[0];
///     Ok::<_, critreg::Error>(Outcome::from_feasible(query.theta[0] < wall))
/// })?;
/// assert!(!region.formula().constraints().is_empty());
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct Algorithm1<'m, R> {
    config: Config,
    features: Features<'m, R>,
    hypotheses: Hypotheses<'m>,
    bounds: BoundTable<'m, R>,
    observations: Table<'m, Observation>,
    rng: Generator,
    phase: Phase,
    pending: Option<Trial>,
    serial: u32,
    problem: Option<Begun>,
    points: PointSet,
    region: Region,
    report: Report,
}

impl<'m, R: Real> Algorithm1<'m, R> {
    /// A learner about the parameters of `domain`, with the room of `capacity`.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] if a table of `memory` is shorter than
    /// `capacity` needs or the domain has no parameter, [`Error::NotFinite`] or
    /// [`Error::InvalidArgument`] for a manual sample outside of the parameters'
    /// ranges.
    pub fn new(
        domain: &Domain<'_>,
        config: Config,
        capacity: Capacity,
        memory: Memory<'m, R>,
    ) -> Result<Self, Error> {
        if domain.parameters().is_empty() {
            return Err(Error::InvalidArgument(
                "Algorithm 1 learns about parameters, and the domain declares none",
            ));
        }
        domain.check_precision::<R>()?;
        let memory = memory.cut(capacity)?;
        let features = Features::enumerate(domain, memory.features, memory.values)?;
        let hypotheses = Hypotheses::enumerate(&features, memory.pairs);
        let bounds = BoundTable::new(memory.bounds);
        let observations = Table::new(memory.observations, OBSERVATIONS);
        for sample in [config.negative, config.positive].iter().flatten() {
            check_sample(domain, sample)?;
        }
        let mut learner = Algorithm1 {
            report: Report::default(),
            config,
            features,
            hypotheses,
            bounds,
            observations,
            rng: generator(config.seed),
            phase: Phase::Negative,
            pending: None,
            serial: 0,
            problem: None,
            points: PointSet::all(domain),
            region: Region::new(domain, Formula::everything()),
        };
        learner.restart(domain);
        Ok(learner)
    }

    /// The configuration it was made with.
    pub fn config(&self) -> &Config {
        &self.config
    }

    /// How learning went so far.
    pub fn report(&self) -> Report {
        self.report
    }

    /// Its features and their values at the last sample told.
    pub fn features(&self) -> &Features<'m, R> {
        &self.features
    }

    /// The hypotheses that are left.
    pub fn hypotheses(&self) -> &Hypotheses<'m> {
        &self.hypotheses
    }

    /// Passes by manual samples that are not configured, and ends the loop.
    fn skip_absent(&mut self) {
        if self.phase == Phase::Negative && self.config.negative.is_none() {
            self.phase = Phase::Positive;
        }
        if self.phase == Phase::Positive && self.config.positive.is_none() {
            self.phase = Phase::Active(0);
        }
        if self.phase == Phase::Active(self.config.iterations) || self.report.remaining == 0 {
            self.phase = Phase::Finished;
        }
    }

    fn next_query(&mut self, problem: &Problem<'_>) -> Result<Query, Error> {
        let manual = match self.phase {
            Phase::Negative => self.config.negative,
            Phase::Positive => self.config.positive,
            Phase::Active(_) => None,
            Phase::Finished => {
                return Err(Error::OutOfSequence(
                    "learning is finished: ask for the region",
                ));
            }
        };
        if let Some(theta) = manual {
            return Ok(Query { instance: 0, theta });
        }
        let instance = below(&mut self.rng, problem.count());
        let values = problem.instance(instance)?;
        let drawn = self
            .region
            .sample::<R>(problem.domain(), values, &mut self.rng);
        let theta = match drawn {
            Ok(theta) => theta,
            Err(Error::EmptyRegion | Error::NoSample) => self.anywhere(problem.domain()),
            Err(error) => return Err(error),
        };
        Ok(Query { instance, theta })
    }

    fn pending_with(&mut self, id: u64) -> Result<&mut Trial, Error> {
        let pending = self.pending.as_mut().filter(|own| own.question.id == id);
        pending.ok_or(Error::OutOfSequence(
            "no question with this id waits for an answer",
        ))
    }

    fn anywhere(&mut self, domain: &Domain<'_>) -> Theta {
        let mut theta = [0.0; MAX_PARAMETERS];
        for (value, p) in theta.iter_mut().zip(domain.parameters()) {
            *value = uniform_in(&mut self.rng, p.low, p.high);
        }
        theta
    }

    fn evaluate(&mut self, problem: &Problem<'_>, query: &Query) -> Result<(), Error> {
        let instance = problem.instance(query.instance)?;
        let scene = Scene::new(problem.domain(), instance, self.points)?;
        self.features
            .evaluate(&scene, &query.theta.map(R::from_f64));
        Ok(())
    }

    /// The region of all bounds, simple left sides first.
    fn rebuild_region(&mut self, domain: &Domain<'_>) {
        let mut formula = Formula::everything();
        let mut left_out = 0;
        let nodes = self.features.nodes();
        for (lhs, bound) in self.bounds.iter() {
            let term = nodes.get(usize::from(bound.rhs.0));
            let literal = matches!(term, Some(Node::Number(_)));
            let constant = domain.dependence(nodes, bound.rhs) == Dependence::Constant;
            let inequality = Inequality {
                lhs,
                comparison: bound.comparison,
                bound: bound.value.to_f64(),
                name: (constant && !literal).then_some(bound.rhs),
            };
            let added = formula.and(nodes, &[inequality]);
            left_out += usize::from(added.is_err());
        }
        self.report.constraints_left_out = left_out;
        self.region = Region::new(domain, formula);
    }

    fn advance(&mut self) {
        let remaining = self.hypotheses.remaining();
        self.report.remaining = remaining;
        self.report.calls += 1;
        self.phase = match self.phase {
            Phase::Negative => {
                self.report.after_negative = Some(remaining);
                Phase::Positive
            }
            Phase::Positive => {
                self.report.after_positive = Some(remaining);
                Phase::Active(0)
            }
            Phase::Active(done) => Phase::Active(done.saturating_add(1)),
            Phase::Finished => Phase::Finished,
        };
        self.skip_absent();
    }
}

impl<R: Real> Learner for Algorithm1<'_, R> {
    fn ask(&mut self, problem: &Problem<'_>) -> Result<Query, Error> {
        if self.problem.is_none() {
            problem.check_precision::<R>()?;
        }
        self.problem.get_or_insert(problem.begun());
        problem.check_begun(self.problem)?;
        if let Some(pending) = &mut self.pending {
            pending.state = State::Open;
            return Ok(*pending.query());
        }
        let query = self.next_query(problem)?;
        self.serial = self.serial.wrapping_add(1);
        let question = Question::new(self.serial, query);
        self.pending = Some(Trial::new(question, Purpose::Doubt));
        Ok(query)
    }

    fn ask_more(&mut self, problem: &Problem<'_>) -> Result<Option<Question>, Error> {
        // Each question follows from the answer to the one before.
        if self.is_finished() || self.pending.as_ref().is_some_and(Trial::is_open) {
            return Ok(None);
        }
        self.ask(problem)?;
        Ok(self.pending.as_ref().map(|pending| pending.question))
    }

    fn tell_id(&mut self, problem: &Problem<'_>, id: u64, outcome: Outcome) -> Result<(), Error> {
        self.pending_with(id)?;
        self.tell(problem, outcome)
    }

    fn forget(&mut self, id: u64) -> Result<(), Error> {
        self.pending_with(id)?.state = State::Again;
        Ok(())
    }

    fn tell(&mut self, problem: &Problem<'_>, outcome: Outcome) -> Result<(), Error> {
        let Some(pending) = &self.pending else {
            return Err(Error::OutOfSequence("ask for a sample before telling"));
        };
        let query = *pending.query();
        problem.check_begun(self.problem)?;
        self.evaluate(problem, &query)?;
        self.observations.push(Observation::new(&query, outcome)?)?;
        self.pending = None;
        match outcome.label() {
            None => self.report.unknown += 1,
            Some(feasible) => {
                self.hypotheses.update(&self.features, feasible);
                self.bounds
                    .tighten(&mut self.hypotheses, &self.features, feasible);
                self.rebuild_region(problem.domain());
                self.report.feasible += usize::from(feasible);
            }
        }
        self.advance();
        Ok(())
    }

    fn observe(&mut self, _: &Problem<'_>, _: &Query, _: Outcome) -> Result<(), Error> {
        Err(Error::InvalidArgument(
            "Algorithm 1 learns from the samples that it asks for only",
        ))
    }

    fn conclude(&mut self, _: &Problem<'_>) -> Result<(), Error> {
        Ok(())
    }

    fn trials(&self) -> &[Trial] {
        self.pending.as_slice()
    }

    fn notes(&self) -> Notes {
        Notes {
            asked: self.serial,
            ..Notes::default()
        }
    }

    fn replay(&mut self, problem: &Problem<'_>, saved: &Observation) -> Result<(), Error> {
        if self.ask(problem)? != saved.query() {
            return Err(OTHER_SAMPLES);
        }
        self.tell(problem, saved.outcome)
    }

    fn reopen(&mut self, _: &Problem<'_>, notes: Notes) -> Result<(), Error> {
        self.serial = notes.asked;
        Ok(())
    }

    fn restore(&mut self, problem: &Problem<'_>, saved: Trial) -> Result<(), Error> {
        // It was counted when it was asked.
        let serial = self.serial;
        if self.ask(problem)? != *saved.query() {
            return Err(OTHER_SAMPLES);
        }
        (self.pending, self.serial) = (Some(saved), serial);
        Ok(())
    }

    fn restart(&mut self, domain: &Domain<'_>) {
        self.hypotheses.restore();
        self.bounds.clear();
        self.observations.clear();
        self.rng = generator(self.config.seed);
        self.phase = Phase::Negative;
        (self.pending, self.problem, self.serial) = (None, None, 0);
        self.region.clear(domain);
        self.report = Report {
            enumeration: self.hypotheses.enumeration(),
            remaining: self.hypotheses.remaining(),
            ..Report::default()
        };
        self.skip_absent();
    }

    fn is_finished(&self) -> bool {
        self.phase == Phase::Finished
    }

    fn region(&self) -> Result<&Region, Error> {
        if self.region.formula().constraints().is_empty() {
            return Err(Error::NoRegion);
        }
        Ok(&self.region)
    }

    fn observations(&self) -> &[Observation] {
        self.observations.as_slice()
    }

    fn room(&self) -> usize {
        self.observations.capacity()
    }

    fn fingerprint(&self) -> u32 {
        let mut digest = CHECKSUM.digest();
        digest.update(b"algorithm1");
        digest.update(R::NAME.as_bytes());
        digest.update(&self.config.seed.to_le_bytes());
        digest.update(&self.config.iterations.to_le_bytes());
        digest.update(&self.report.enumeration.kept.to_le_bytes());
        for sample in [self.config.negative, self.config.positive] {
            digest.update(&[u8::from(sample.is_some())]);
            for value in sample.iter().flatten() {
                digest.update(&value.to_bits().to_le_bytes());
            }
        }
        digest.finalize()
    }
}

const OTHER_SAMPLES: Error = Error::Mismatch("the saved samples are not those of this learner");

fn check_sample(domain: &Domain<'_>, sample: &Theta) -> Result<(), Error> {
    let used = sample.get(..domain.parameters().len()).unwrap_or(&[]);
    domain.check_parameters(used)?;
    let inside = |(value, p): (&f64, &Parameter<'_>)| p.low <= *value && *value <= p.high;
    if used.iter().zip(domain.parameters()).all(inside) {
        Ok(())
    } else {
        Err(Error::InvalidArgument(
            "a manual sample is outside of the ranges of the parameters",
        ))
    }
}
