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

use super::log::Observation;
use super::problem::Problem;
use super::{Answer, Learner, Query};
use crate::domain::{CHECKSUM, Dependence, Domain, MAX_PARAMETERS, Node, PointSet, Scene};
use crate::error::Error;
use crate::grammar::{
    Comparison, Enumeration, Features, Formula, Hypotheses, Run, bit, feature_id,
};
use crate::random::{Generator, below, generator, uniform_in};
use crate::real::Real;
use crate::region::{Region, Theta};
use crate::table::Table;

/// How many hypotheses and observations a learner has room for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Capacity {
    /// Hypotheses, rounded down to a multiple of four.
    pub hypotheses: usize,
    /// Observations: samples that can be told.
    pub observations: usize,
}

impl Capacity {
    /// Room for features: enough for the pairs of any usual domain.
    pub const fn features(self) -> usize {
        let wanted = 128 + self.hypotheses / 32;
        if wanted < 60_000 { wanted } else { 60_000 }
    }

    /// Room for left sides.
    pub const fn lefts(self) -> usize {
        self.features() / 4
    }

    /// Bytes of the hypothesis table.
    pub const fn pairs(self) -> usize {
        self.hypotheses / 4
    }
}

/// The tables of a learner, lent by the caller. Each must have at least the
/// length that [`Capacity`] tells; what is longer is not used.
#[derive(Debug)]
pub struct Memory<'m, R> {
    /// [`Capacity::features`] terms.
    pub features: &'m mut [Node],
    /// [`Capacity::features`] numbers.
    pub values: &'m mut [R],
    /// [`Capacity::pairs`] bytes.
    pub pairs: &'m mut [u8],
    /// [`Capacity::lefts`] bounds.
    pub bounds: &'m mut [Bounds<R>],
    /// [`Capacity::observations`] observations.
    pub observations: &'m mut [Observation],
}

/// What decides the questions of [`Algorithm1`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Config {
    /// Seed of all random choices.
    pub seed: u64,
    /// Iterations K of the active loop.
    pub iterations: u32,
    /// The manual sample z-, expected to fail; left out if `None`.
    pub negative: Option<Theta>,
    /// The manual sample z+, expected to work; left out if `None`.
    pub positive: Option<Theta>,
}

impl Default for Config {
    /// The thesis's K = 100, no manual samples.
    fn default() -> Self {
        Config {
            seed: 0,
            iterations: 100,
            negative: None,
            positive: None,
        }
    }
}

/// How learning went so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Report {
    /// Hypotheses of the grammar, and how many the table holds.
    pub enumeration: Enumeration,
    /// Hypotheses left after z- was told.
    pub after_negative: Option<usize>,
    /// Hypotheses left after z+ was told.
    pub after_positive: Option<usize>,
    /// Hypotheses left now.
    pub remaining: usize,
    /// Samples told.
    pub calls: usize,
    /// Samples told that were feasible.
    pub feasible: usize,
    /// Bounds that found no room in the region.
    pub constraints_left_out: usize,
}

/// The tightest numeric bound on a left side from one direction, and the
/// hypothesis it came from.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Bound<R> {
    value: R,
    comparison: Comparison,
    right: u16,
}

/// The bounds on a left side: `[from above, from below]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds<R> {
    recorded: [Option<Bound<R>>; 2],
    candidate: [Option<Bound<R>>; 2],
}

impl<R> Default for Bounds<R> {
    fn default() -> Self {
        Bounds {
            recorded: [None, None],
            candidate: [None, None],
        }
    }
}

impl<R: Real> Bound<R> {
    /// Dominance (Eq. 4.12) between bounds from one direction.
    fn dominates(&self, other: &Bound<R>) -> bool {
        let tighter = if self.comparison.is_upper() {
            self.value < other.value
        } else {
            self.value > other.value
        };
        let stricter = !self.comparison.admits_equal() && other.comparison.admits_equal();
        tighter || (self.value == other.value && stricter)
    }

    fn is_from(&self, other: &Bound<R>) -> bool {
        self.right == other.right && self.comparison == other.comparison
    }
}

fn direction(comparison: Comparison) -> usize {
    usize::from(!comparison.is_upper())
}

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
/// use critreg::domain::{Domain, Node};
/// use critreg::learn::*;
/// # fn main() -> Result<(), critreg::Error> {
/// let domain = Domain::parse(
///     "object wall { x: length, y: length }
///      parameter reach in [0, 4]: length
///      point hand = world + (reach, 0)",
/// )?;
/// let problem = Problem::new(&domain, &[2.0, 0.0, 3.0, 0.0], 2)?;
/// let capacity = Capacity { hypotheses: 1024, observations: 64 };
/// let (mut nodes, mut values) = ([Node::Number(0.0); 160], [0.0; 160]);
/// let (mut pairs, mut bounds) = ([0; 256], [Bounds::default(); 40]);
/// let mut observations = [Observation::default(); 64];
/// let memory = Memory {
///     features: &mut nodes,
///     values: &mut values,
///     pairs: &mut pairs,
///     bounds: &mut bounds,
///     observations: &mut observations,
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
///     Ok::<_, critreg::Error>(Answer::from_feasible(query.theta[0] < wall))
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
    bounds: &'m mut [Bounds<R>],
    observations: Table<'m, Observation>,
    rng: Generator,
    phase: Phase,
    pending: Option<Query>,
    problem: Option<u32>,
    points: PointSet,
    region: Region,
    report: Report,
}

impl<'m, R: Real> Algorithm1<'m, R> {
    /// A learner about the parameters of `domain`, with the room of `capacity`.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] if a table of `memory` is shorter than
    /// `capacity` needs, [`Error::NotFinite`] or [`Error::InvalidArgument`] for a
    /// manual sample outside of the parameters' ranges.
    pub fn new(
        domain: &Domain<'_>,
        config: Config,
        capacity: Capacity,
        memory: Memory<'m, R>,
    ) -> Result<Self, Error> {
        let short = || Error::InvalidArgument("the learner needs more memory for this capacity");
        let nodes = memory.features.get_mut(..capacity.features());
        let values = memory.values.get_mut(..capacity.features());
        let features =
            Features::enumerate(domain, nodes.ok_or_else(short)?, values.ok_or_else(short)?)?;
        let pairs = memory.pairs.get_mut(..capacity.pairs());
        let hypotheses = Hypotheses::enumerate(&features, pairs.ok_or_else(short)?);
        let bounds = memory.bounds.get_mut(..capacity.lefts());
        let bounds = bounds.ok_or_else(short)?;
        bounds.fill(Bounds::default());
        let observations = memory.observations.get_mut(..capacity.observations);
        let observations = Table::new(observations.ok_or_else(short)?, "observations");
        for sample in [config.negative, config.positive].iter().flatten() {
            check_sample(domain, sample)?;
        }
        let remaining = hypotheses.remaining();
        let mut learner = Algorithm1 {
            report: Report {
                enumeration: hypotheses.enumeration(),
                remaining,
                ..Report::default()
            },
            config,
            features,
            hypotheses,
            bounds,
            observations,
            rng: generator(config.seed),
            phase: Phase::Negative,
            pending: None,
            problem: None,
            points: PointSet::all(domain),
            region: Region::new(domain, Formula::everything()),
        };
        learner.skip_absent();
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
            .evaluate(&scene, &query.theta.map(R::from_f64))
    }

    /// Brings the bounds up to date with the hypotheses that are left.
    fn settle_bounds(&mut self, feasible: bool) {
        for bounds in self.bounds.iter_mut() {
            bounds.candidate = [None, None];
        }
        let values = self.features.values();
        let bounds = &mut *self.bounds;
        self.hypotheses.for_each_run(&self.features, |run, pairs| {
            for_each_bound(run, pairs, values, |bound, _| {
                let side = side_of(bounds, run.left, bound.comparison, |b| &mut b.candidate);
                if let Some(best) = side
                    && best.as_ref().is_none_or(|best| bound.dominates(best))
                {
                    *best = Some(bound);
                }
            });
        });
        for bounds in self.bounds.iter_mut() {
            let sides = bounds.recorded.iter_mut().zip(bounds.candidate);
            for (recorded, candidate) in sides {
                *recorded = match (candidate, *recorded) {
                    (Some(new), Some(old)) if old.is_from(&new) && !new.dominates(&old) => {
                        Some(old)
                    }
                    (Some(new), _) if feasible => Some(new),
                    (Some(_), old) => old,
                    (None, _) => None,
                };
            }
        }
        if feasible {
            self.remove_dominated();
        }
    }

    fn remove_dominated(&mut self) {
        let values = self.features.values();
        let bounds = &mut *self.bounds;
        self.hypotheses.for_each_run(&self.features, |run, pairs| {
            for_each_bound(run, pairs, values, |bound, pair| {
                let side = side_of(bounds, run.left, bound.comparison, |b| &mut b.recorded);
                let best = side.and_then(|best| *best);
                if !best.is_some_and(|best| best.is_from(&bound)) {
                    *pair &= !bit(bound.comparison);
                }
            });
        });
    }

    /// The region of all bounds, simple left sides first.
    fn rebuild_region(&mut self, domain: &Domain<'_>) {
        let mut formula = Formula::everything();
        let mut left_out = 0;
        let nodes = self.features.nodes();
        for (left, bounds) in self.bounds.iter().enumerate() {
            for bound in bounds.recorded.iter().flatten() {
                let right = feature_id(usize::from(bound.right));
                let literal = matches!(nodes.get(usize::from(right.0)), Some(Node::Number(_)));
                let constant = domain.dependence(nodes, right) == Dependence::Constant;
                let added = formula.and(
                    nodes,
                    feature_id(left),
                    bound.comparison,
                    bound.value.to_f64(),
                    (constant && !literal).then_some(right),
                );
                left_out += usize::from(added.is_err());
            }
        }
        self.report.constraints_left_out = left_out;
        self.region = Region::new(domain, formula);
    }

    fn advance(&mut self, feasible: bool) {
        let remaining = self.hypotheses.remaining();
        self.report.remaining = remaining;
        self.report.calls += 1;
        self.report.feasible += usize::from(feasible);
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
        let begun = *self.problem.get_or_insert(problem.fingerprint());
        if begun != problem.fingerprint() {
            return Err(Error::Mismatch(
                "the domain or the instances changed while learning",
            ));
        }
        if let Some(pending) = self.pending {
            return Ok(pending);
        }
        let query = self.next_query(problem)?;
        self.pending = Some(query);
        Ok(query)
    }

    fn tell(&mut self, problem: &Problem<'_>, answer: Answer) -> Result<(), Error> {
        let Some(query) = self.pending else {
            return Err(Error::OutOfSequence("ask for a sample before telling"));
        };
        if self.problem != Some(problem.fingerprint()) {
            return Err(Error::Mismatch(
                "the domain or the instances changed while learning",
            ));
        }
        self.evaluate(problem, &query)?;
        self.observations.push(Observation::new(&query, answer)?)?;
        self.pending = None;
        let feasible = answer.is_feasible();
        self.hypotheses.update(&self.features, feasible);
        self.settle_bounds(feasible);
        self.rebuild_region(problem.domain());
        self.advance(feasible);
        Ok(())
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

    fn fingerprint(&self) -> u32 {
        let mut digest = CHECKSUM.digest();
        digest.update(b"algorithm1");
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

/// Calls `visit` with every hypothesis of a run as the bound it sets at the
/// present values, and its pair.
fn for_each_bound<R: Real>(
    run: &Run,
    pairs: &mut [u8],
    values: &[R],
    mut visit: impl FnMut(Bound<R>, &mut u8),
) {
    let rights = run.rights.clone().zip(values.iter().skip(run.rights.start));
    for ((right, value), pair) in rights.zip(pairs) {
        if *pair == 0 {
            continue;
        }
        for comparison in Comparison::ALL {
            if *pair & bit(comparison) != 0 {
                let bound = Bound {
                    value: *value,
                    comparison,
                    right: feature_id(right).0,
                };
                visit(bound, pair);
            }
        }
    }
}

fn side_of<R>(
    bounds: &mut [Bounds<R>],
    left: usize,
    comparison: Comparison,
    sides: fn(&mut Bounds<R>) -> &mut [Option<Bound<R>>; 2],
) -> Option<&mut Option<Bound<R>>> {
    sides(bounds.get_mut(left)?).get_mut(direction(comparison))
}

fn check_sample(domain: &Domain<'_>, sample: &Theta) -> Result<(), Error> {
    let used = sample.get(..domain.parameters().len()).unwrap_or(&[]);
    domain.check_parameters(used)?;
    let inside =
        |(value, p): (&f64, &crate::domain::Parameter<'_>)| p.low <= *value && *value <= p.high;
    if used.iter().zip(domain.parameters()).all(inside) {
        Ok(())
    } else {
        Err(Error::InvalidArgument(
            "a manual sample is outside of the ranges of the parameters",
        ))
    }
}
