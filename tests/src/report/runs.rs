//! Learners that run on scenarios, and what comes of it.

use super::judge::Truth;
use super::scenario::Scenario;
use super::statistics::Run;
use super::synthetic;
use crate::room::{Algorithm1Room, VersionSpaceRoom};
use crate::{pick, text};
use critreg::Error;
use critreg::domain::Domain;
use critreg::learn::version_space::{Capacity, Config};
use critreg::learn::{Algorithm1, Learner, Outcome, Problem, Query, VersionSpace};
use critreg::random::{Generator, generator, uniform, uniform_in};
use critreg::region::{Region, Theta};
use std::sync::atomic::{AtomicUsize, Ordering};

/// The learners that are compared.
pub const LEARNERS: [&str; 2] = ["algorithm1", "version_space"];

/// What `run` makes of each seed, in the order of the seeds, on all cores; with the progress
/// on stderr after every so many.
pub fn for_seeds<T: Send>(seeds: usize, every: usize, run: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let next = AtomicUsize::new(0);
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let mut all: Vec<(usize, T)> = std::thread::scope(|scope| {
        let work = || {
            let mut done = Vec::new();
            loop {
                let index = next.fetch_add(1, Ordering::Relaxed);
                if index >= seeds {
                    return done;
                }
                if index > 0 && index.is_multiple_of(every) {
                    eprintln!("{index} of {seeds} seeds");
                }
                done.push((index, run(index)));
            }
        };
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        let done = workers.into_iter().map(|w| w.join().expect("a worker"));
        done.flatten().collect()
    });
    all.sort_by_key(|(index, _)| *index);
    all.into_iter().map(|(_, own)| own).collect()
}

/// A problem with a seed: the same one for every seed, except for synthetic ones.
pub(super) fn with_seed<T>(scenario: &Scenario, seed: u64, run: impl FnOnce(&Scenario) -> T) -> T {
    match scenario.name {
        "synthetic" => run(&synthetic(seed)),
        _ => run(scenario),
    }
}

/// Both learners on one seed.
pub fn run_seed(scenario: &Scenario, seed: u64) -> [Run; 2] {
    with_seed(scenario, seed, |scenario| {
        let truth = Truth::new(scenario, seed);
        let instances = scenario.draw(seed, scenario.instances);
        let domain = &scenario.domain;
        let problem =
            Problem::new(domain, &instances, scenario.instances).expect("valid instances");
        let mut room = Algorithm1Room::new(20_000, scenario.calls as usize + 2);
        let (capacity, mut config) = (room.capacity, pick::config(seed));
        config.iterations = scenario.calls.saturating_sub(2);
        let baseline = match Algorithm1::new(domain, config, capacity, room.lend()) {
            Ok(mut learner) => run(&mut learner, scenario, &problem, &truth, seed),
            // It knows only actions with parameters.
            Err(_) => Run::default(),
        };
        [baseline, run_default(scenario, &truth, seed)]
    })
}

/// What `run` makes of the default learner with a configuration, in the instances of a seed.
pub(super) fn with_learner<T>(
    scenario: &Scenario,
    seed: u64,
    config: Config,
    run: impl FnOnce(&mut VersionSpace<'_, f64>, &Problem<'_>) -> T,
) -> T {
    let instances = scenario.draw(seed, scenario.instances);
    let domain = &scenario.domain;
    let problem = Problem::new(domain, &instances, scenario.instances).expect("valid instances");
    let mut room = VersionSpaceRoom::<f64>::new(Capacity {
        observations: config.calls as usize,
        ..scenario.capacity()
    });
    let mut learner = room.learner(domain, config).expect("enough room");
    run(&mut learner, &problem)
}

/// The default learner on one seed of a problem.
pub(super) fn run_default(scenario: &Scenario, truth: &Truth, seed: u64) -> Run {
    let config = scenario.config(seed);
    with_learner(scenario, seed, config, |learner, problem| {
        let run = run(learner, scenario, problem, truth, seed);
        Run {
            quality: learner.quality(),
            ..run
        }
    })
}

/// Whether the region that the default learner ends with is exact.
pub(super) fn is_exact(scenario: &Scenario, truth: &Truth, seed: u64, config: Config) -> bool {
    with_learner(scenario, seed, config, |learner, problem| {
        is_exact_in(learner, scenario, truth, seed, problem)
    })
}

/// Whether the region that a learner ends with is exact, if it learns in these instances.
pub(super) fn is_exact_in<L: Learner>(
    learner: &mut L,
    scenario: &Scenario,
    truth: &Truth,
    seed: u64,
    problem: &Problem<'_>,
) -> bool {
    ask_and_tell(learner, scenario, problem, seed, |_, _| ());
    let region = learner.region();
    region.is_ok_and(|region| truth.full_score(problem.domain(), region).is_exact())
}

/// Asks and tells until the learner is finished. `seen` sees it after every call.
pub(super) fn ask_and_tell<L: Learner>(
    learner: &mut L,
    scenario: &Scenario,
    problem: &Problem<'_>,
    seed: u64,
    mut seen: impl FnMut(u32, &L),
) {
    let mut answers = Answers::new(scenario, seed);
    for calls in 1.. {
        if learner.is_finished() {
            break;
        }
        let query = learner.ask(problem).expect("not finished");
        let outcome = answers.to(problem, &query);
        learner.tell(problem, outcome).expect("room for it");
        seen(calls, learner);
    }
}

/// Uniform parameters.
pub(super) fn draw_theta(domain: &Domain<'_>, rng: &mut Generator) -> Theta {
    let mut theta = Theta::default();
    for (value, own) in theta.iter_mut().zip(domain.parameters()) {
        *value = uniform_in(rng, own.low, own.high);
    }
    theta
}

/// The answers of a scenario, of which a share is flipped.
pub(super) struct Answers<'s> {
    scenario: &'s Scenario,
    flips: Generator,
}

impl Answers<'_> {
    /// Those of a seed.
    pub(super) fn new(scenario: &Scenario, seed: u64) -> Answers<'_> {
        Answers {
            scenario,
            flips: generator(seed ^ 0xF11B),
        }
    }

    /// What comes of a sample.
    pub(super) fn to(&mut self, problem: &Problem<'_>, query: &Query) -> Outcome {
        let instance = problem.instance(query.instance).expect("an instance");
        let used = problem.domain().parameters().len();
        let outcome = self.scenario.judge(instance, &query.theta[..used]);
        match uniform(&mut self.flips) < self.scenario.noise {
            true => Outcome::from_feasible(!outcome.is_feasible()),
            false => outcome,
        }
    }
}

fn run<L: Learner>(
    learner: &mut L,
    scenario: &Scenario,
    problem: &Problem<'_>,
    truth: &Truth,
    seed: u64,
) -> Run {
    let mut course = Course::default();
    ask_and_tell(learner, scenario, problem, seed, |calls, learner| {
        course.note(calls, learner);
    });
    course.judged(problem.domain(), truth)
}

/// The regions of a learner on the way, each with the number of calls it took.
#[derive(Default)]
pub(super) struct Course(Vec<(u32, Option<Region>)>);

impl Course {
    /// Notes the region that there is after so many calls.
    pub(super) fn note(&mut self, calls: u32, learner: &(impl Learner + ?Sized)) {
        let region = match learner.region() {
            Ok(region) => Some(region.clone()),
            Err(Error::NoRegion) => None,
            Err(error) => panic!("{error}"),
        };
        if self.0.last().is_none_or(|(_, last)| *last != region) {
            self.0.push((calls, region));
        }
    }

    /// What came of it.
    pub(super) fn judged(&self, domain: &Domain<'_>, truth: &Truth) -> Run {
        let last = self.0.last().and_then(|(_, region)| region.clone());
        let Some(last) = last else {
            return Run::default();
        };
        let score = truth.full_score(domain, &last);
        let calls_to_exact = calls_to_exact(domain, truth, &self.0);
        Run {
            region: Some(text::of_region(domain, &last)),
            score,
            calls_to_exact: calls_to_exact.filter(|_| score.is_exact()),
            ..Run::default()
        }
    }
}

/// After how many calls all regions were exact, judged in fewer instances.
fn calls_to_exact(
    domain: &Domain<'_>,
    truth: &Truth,
    regions: &[(u32, Option<Region>)],
) -> Option<u32> {
    const TASKS: usize = 25;
    let exact = |region: &Option<Region>| {
        let region = region.as_ref();
        region.is_some_and(|region| truth.score(domain, region, TASKS).is_exact())
    };
    let backwards = regions.iter().rev().take_while(|(_, region)| exact(region));
    backwards.last().map(|(calls, _)| *calls)
}
