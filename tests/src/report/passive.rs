//! Learning from a log that somebody else recorded, without a question.

use super::judge::Truth;
use super::runs::{draw_theta, for_seeds};
use super::scenario::{Scenario, pick};
use crate::room::VersionSpaceRoom;
use crate::text;
use critreg::learn::version_space::{Capacity, Config, Quality};
use critreg::learn::{Learner, Outcome, Problem, Query};
use critreg::random::{below, generator, uniform};
use std::time::Instant;

/// What came of a log.
struct Told {
    quality: Quality,
    exact: bool,
    precision: f64,
    seconds: f64,
    dropped: usize,
    region: String,
}

/// Prints what uniform picks of some length teach, of which a share has the wrong outcome.
pub fn print(seeds: usize, first: u64, log: usize, noise: f64) {
    let scenario = pick();
    let all = for_seeds(seeds, 10, |index| {
        observe(&scenario, first + index as u64, log, noise)
    });
    let count = |is: &dyn Fn(&Told) -> bool| all.iter().filter(|own| is(own)).count();
    let mean = |of: &dyn Fn(&Told) -> f64| all.iter().map(of).sum::<f64>() / seeds as f64;
    println!("report: passive");
    println!("log: {log}\nnoise: {noise}\nseeds: {seeds}");
    println!("exact: {}", count(&|own| own.exact));
    println!(
        "called_exact: {}",
        count(&|own| own.quality == Quality::Exact)
    );
    let called = |own: &Told| own.quality == Quality::Approximate;
    println!("called_approximate: {}", count(&called));
    println!(
        "no_region: {}",
        count(&|own| own.quality < Quality::Approximate)
    );
    let found = |own: &&Told| own.quality >= Quality::Approximate;
    let precisions = all.iter().filter(found).map(|own| own.precision);
    let least = precisions.fold(1.0, f64::min);
    println!("precision_min: {least:.4}");
    println!("dropped_mean: {:.0}", mean(&|own| own.dropped as f64));
    println!("seconds_mean: {:.3}", mean(&|own| own.seconds));
    println!(
        "first_region: {}",
        all.first().map_or("", |own| &own.region)
    );
}

fn observe(scenario: &Scenario, seed: u64, log: usize, noise: f64) -> Told {
    const INSTANCES: usize = 16;
    let truth = Truth::new(scenario, seed);
    let instances = scenario.draw(seed, INSTANCES);
    let domain = &scenario.domain;
    let problem = Problem::new(domain, &instances, INSTANCES).expect("valid instances");
    let capacity = Capacity {
        instances: INSTANCES,
        ..Capacity::new(4096, 2048)
    };
    let mut room = VersionSpaceRoom::<f64>::new(capacity);
    let config = Config {
        seed,
        calls: 0,
        ..Config::default()
    };
    let mut learner = room.learner(domain, config).expect("enough room");
    let mut rng = generator(seed ^ 0x1064_0000);
    let started = Instant::now();
    for _ in 0..log {
        let theta = draw_theta(domain, &mut rng);
        let instance = below(&mut rng, INSTANCES);
        let numbers = problem.instance(instance).expect("an instance");
        let works = scenario.judge(numbers, &theta[..domain.parameters().len()]);
        let wrong = uniform(&mut rng) < noise;
        let outcome = Outcome::from_feasible(works.is_feasible() != wrong);
        let query = Query { instance, theta };
        learner.observe(&problem, &query, outcome).expect("room");
    }
    learner.conclude(&problem).expect("it began");
    let seconds = started.elapsed().as_secs_f64();
    let score = learner
        .best_region()
        .map(|region| truth.full_score(domain, region))
        .unwrap_or_default();
    Told {
        quality: learner.quality(),
        exact: learner.region().is_ok() && score.is_exact(),
        precision: score.precision,
        seconds,
        dropped: learner.report().dropped,
        region: learner
            .best_region()
            .map_or_else(|_| "none".into(), |region| text::of_region(domain, region)),
    }
}
