//! What planning takes with learned regions, in stick-button and in all environments:
//! `report -- <table|domains|an environment> [--seeds N]`.
//!
//! How often the learners find the true region:
//! `report -- <what> [--seeds N] [--calls N] [--instances N]`.

use critreg::Error;
use critreg::domain::Domain;
use critreg::learn::{Algorithm1, Learner, Outcome, Problem};
use critreg::random::{generator, uniform};
use critreg::region::Region;
use critreg_tests::report::{self, Run, Scenario, Statistics, Truth};
use critreg_tests::room::{Algorithm1Room, VersionSpaceRoom};
use critreg_tests::{pick, text};
use std::process::ExitCode;
use std::sync::atomic::{AtomicUsize, Ordering};

const USAGE: &str = "usage: report <table|domains|an environment> [--seeds N]\n       report \
     <pick|chain|angles|synthetic|noise|interval|union|state|groups> \
     [--seeds N] [--calls N] [--instances N] [--first N] [--list yes]";

/// The learners that are compared.
const LEARNERS: [&str; 2] = ["algorithm1", "version_space"];

struct Options {
    scenario: Scenario,
    seeds: usize,
    first: u64,
    list: bool,
}

fn main() -> ExitCode {
    if let Some(seeds) = seeds_of("table", 10) {
        report::table(seeds);
        return ExitCode::SUCCESS;
    }
    if let Some(seeds) = seeds_of("domains", 3) {
        report::domains(&report::DOMAINS, seeds);
        return ExitCode::SUCCESS;
    }
    for name in report::DOMAINS {
        if let Some(seeds) = seeds_of(name, 3) {
            report::domains(&[name], seeds);
            return ExitCode::SUCCESS;
        }
    }
    match options() {
        Some(options) => {
            run_all(&options);
            ExitCode::SUCCESS
        }
        None => {
            eprintln!("{USAGE}");
            ExitCode::FAILURE
        }
    }
}

/// The seeds of a report about planning, if it is asked for.
fn seeds_of(name: &str, default: u64) -> Option<u64> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match arguments[..] {
        [own] if own == name => Some(default),
        [own, "--seeds", seeds] if own == name => seeds.parse().ok(),
        _ => None,
    }
}

fn options() -> Option<Options> {
    let mut arguments = std::env::args().skip(1);
    let scenario = match arguments.next()?.as_str() {
        "pick" => report::pick(),
        "chain" => report::chain(),
        "angles" => report::angles(),
        "noise" => report::noise(),
        "synthetic" => report::synthetic(0),
        "interval" => report::interval(),
        "union" => report::union(),
        "state" => report::state(),
        "groups" => report::groups(),
        _ => return None,
    };
    let mut options = Options {
        scenario,
        seeds: 200,
        first: 0,
        list: false,
    };
    while let Some(flag) = arguments.next() {
        let value = arguments.next()?;
        match flag.as_str() {
            "--seeds" => options.seeds = value.parse().ok()?,
            "--calls" => options.scenario.calls = value.parse().ok()?,
            "--instances" => options.scenario.instances = value.parse().ok()?,
            "--first" => options.first = value.parse().ok()?,
            "--list" => options.list = value == "yes",
            _ => return None,
        }
    }
    Some(options)
}

fn run_all(options: &Options) {
    let next = AtomicUsize::new(0);
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let mut all: Vec<(usize, [Run; 2])> = std::thread::scope(|scope| {
        let work = || {
            let mut done = Vec::new();
            loop {
                let index = next.fetch_add(1, Ordering::Relaxed);
                if index >= options.seeds {
                    return done;
                }
                if index > 0 && index.is_multiple_of(100) {
                    eprintln!("{} of {} seeds", index, options.seeds);
                }
                done.push((
                    index,
                    run_seed(&options.scenario, options.first + index as u64),
                ));
            }
        };
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        let done = workers.into_iter().map(|w| w.join().expect("a worker"));
        done.flatten().collect()
    });
    all.sort_by_key(|(index, _)| *index);
    for (place, learner) in LEARNERS.into_iter().enumerate() {
        let runs: Vec<Run> = all.iter().map(|(_, runs)| runs[place].clone()).collect();
        if options.list {
            for (index, run) in runs.iter().enumerate().filter(|(_, r)| !r.score.is_exact()) {
                let seed = options.first + index as u64;
                eprintln!("{learner} {seed} {run:?}");
                if options.scenario.name == "synthetic" {
                    eprintln!("truth {seed} {:?}", report::synthetic(seed).truth);
                }
            }
        }
        println!("report: {}", options.scenario.name);
        let statistics = Statistics {
            learner,
            instances: options.scenario.instances,
            calls: options.scenario.calls,
            runs: &runs,
        };
        statistics.print();
    }
}

fn run_seed(scenario: &Scenario, seed: u64) -> [Run; 2] {
    // A synthetic problem is another one for every seed.
    let fresh = (scenario.name == "synthetic").then(|| report::synthetic(seed));
    let scenario = fresh.as_ref().unwrap_or(scenario);
    let truth = Truth::new(scenario, seed);
    let instances = scenario.draw(seed, scenario.instances);
    let domain = &scenario.domain;
    let problem = Problem::new(domain, &instances, scenario.instances).expect("valid instances");
    let mut room = Algorithm1Room::new(20_000, scenario.calls as usize + 2);
    let (capacity, mut config) = (room.capacity, pick::config(seed));
    config.iterations = scenario.calls.saturating_sub(2);
    let baseline = match Algorithm1::new(domain, config, capacity, room.lend()) {
        Ok(learner) => run(learner, scenario, &problem, &truth, seed),
        // It knows only actions with parameters.
        Err(_) => Run::default(),
    };
    let mut room = VersionSpaceRoom::<f64>::new(scenario.capacity());
    let learner = room.learner(domain, scenario.config(seed));
    let learner = learner.expect("enough room");
    [baseline, run(learner, scenario, &problem, &truth, seed)]
}

fn run<L: Learner>(
    mut learner: L,
    scenario: &Scenario,
    problem: &Problem<'_>,
    truth: &Truth,
    seed: u64,
) -> Run {
    let domain = problem.domain();
    let used = domain.parameters().len();
    let mut flips = generator(seed ^ 0xF11B);
    // The regions on the way, each with the number of answers it took.
    let mut regions: Vec<(u32, Option<Region>)> = Vec::new();
    for calls in 1.. {
        if learner.is_finished() {
            break;
        }
        let query = learner.ask(problem).expect("not finished");
        let instance = problem.instance(query.instance).expect("an instance");
        let mut answer = scenario.judge(instance, &query.theta[..used]);
        if uniform(&mut flips) < scenario.noise {
            answer = Outcome::from_feasible(!answer.is_feasible());
        }
        learner.tell(problem, answer).expect("room for the answer");
        let region = match learner.region() {
            Ok(region) => Some(region.clone()),
            Err(Error::NoRegion) => None,
            Err(error) => panic!("{error}"),
        };
        if regions.last().is_none_or(|(_, last)| *last != region) {
            regions.push((calls, region));
        }
    }
    let last = regions.last().and_then(|(_, region)| region.clone());
    let Some(last) = last else {
        return Run::default();
    };
    let score = truth.full_score(domain, &last);
    Run {
        region: Some(text::of_region(domain, &last)),
        score,
        calls_to_exact: calls_to_exact(domain, truth, &regions).filter(|_| score.is_exact()),
    }
}

/// After how many answers all regions were exact, judged in fewer instances.
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
