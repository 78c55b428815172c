//! Counterexamples teach what a learner has missed.

use critreg::learn::{Learner, Problem, Query, challenge};
use critreg::region::{ProofConfig, Region, Verdict};
use critreg_tests::report::{Scenario, Truth, chain};
use critreg_tests::room::VersionSpaceRoom;

/// What an engineer knows of the chain: the hand stays in its zone, and from there the tip
/// reaches the button.
const SPECIFICATION: &str = "grasp.y + robot.radius <= zone.top
    and dist_y(grasp, stick.tip) - button.y >= robot.radius - zone.top";

/// A lower and an upper end for each number of an instance: those of many random ones.
fn ranges(scenario: &Scenario) -> Vec<[f64; 2]> {
    let length = scenario.domain.instance_len();
    let drawn = scenario.draw(99, 1000);
    let mut ranges = vec![[f64::INFINITY, f64::NEG_INFINITY]; length];
    for instance in drawn.chunks_exact(length) {
        for ([low, high], number) in ranges.iter_mut().zip(instance) {
            (*low, *high) = (low.min(*number), high.max(*number));
        }
    }
    ranges
}

#[test]
fn a_bound_that_was_missed_is_found_by_counterexamples() {
    // Its ten instances and two hundred calls leave this seed with a bound on mu where one on
    // the button belongs.
    const SEED: u64 = 504;
    const MORE: usize = 20;
    let scenario = chain();
    let domain = &scenario.domain;
    let mut instances = scenario.draw(SEED, scenario.instances);
    let mut count = scenario.instances;
    let mut capacity = scenario.capacity();
    capacity.observations += MORE;
    capacity.instances += MORE;
    let mut room = VersionSpaceRoom::<f64>::new(capacity);
    let mut learner = room.learner(domain, scenario.config(SEED)).unwrap();
    let problem = Problem::new(domain, &instances, count).unwrap();
    while !learner.is_finished() {
        let query = learner.ask(&problem).unwrap();
        let instance = problem.instance(query.instance).unwrap();
        let outcome = scenario.judge(instance, &query.theta[..1]);
        learner.tell(&problem, outcome).unwrap();
    }
    let truth = Truth::new(&scenario, SEED);
    let score = truth.full_score(domain, learner.region().unwrap());
    assert!(!score.is_exact(), "{score:?}: this seed misses nothing");

    let specification = Region::parse(domain, SPECIFICATION).unwrap();
    let ranges = ranges(&scenario);
    let mut instance = vec![0.0; domain.instance_len()];
    let verdict = loop {
        let config = ProofConfig::default();
        let answer = challenge(
            &learner,
            domain,
            &specification,
            &ranges,
            config,
            &mut instance,
        );
        let Verdict::Refuted { theta } = answer.unwrap().verdict else {
            break answer.unwrap().verdict;
        };
        assert!(count < scenario.instances + MORE, "too many challenges");
        let outcome = scenario.judge(&instance, &theta[..1]);
        assert!(
            !outcome.is_feasible(),
            "the specification asks for too much"
        );
        instances.extend(&instance);
        count += 1;
        let problem = Problem::new(domain, &instances, count).unwrap();
        let query = Query {
            instance: count - 1,
            theta,
        };
        learner.observe(&problem, &query, outcome).unwrap();
        learner.conclude(&problem).unwrap();
    };
    let region = learner.region().unwrap();
    println!("{} {}", count - scenario.instances, region.display(domain));
    assert_eq!(verdict, Verdict::Proven);
    let score = truth.full_score(domain, region);
    assert!(score.is_exact(), "{score:?}");
}
