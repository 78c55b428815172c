//! Parameters that are worth a look, where few of them work.

use critreg::Error;
use critreg::domain::Domain;
use critreg::learn::version_space::{Capacity, Config};
use critreg::learn::{Learner, Outcome, Problem, VersionSpace, learn_region};
use critreg::random::{generator, uniform_in};
use critreg::region::{Region, Theta};
use critreg_tests::room::VersionSpaceRoom;
use std::f64::consts::PI;

const DOMAIN: &str = "object target { x: length, y: length }
    parameter x in [0, 1]: length
    parameter y in [0, 1]: length
    point hand = world + (x, y)";
/// How far from the target the hand may be: of a two-hundredth of the space.
const REACH: f64 = 0.04;
const INSTANCES: usize = 10;
const CALLS: u32 = 100;

/// Targets anywhere, one behind the other.
fn targets(seed: u64) -> Vec<f64> {
    let mut rng = generator(seed);
    let numbers = 0..2 * INSTANCES;
    numbers.map(|_| uniform_in(&mut rng, 0.1, 0.9)).collect()
}

/// Parameters that are so far from the target at most, along x and along y.
fn near(targets: &[f64], far: f64, seed: u64) -> Vec<Theta> {
    let mut rng = generator(seed);
    let mut beside = |at: f64| at + uniform_in(&mut rng, -far, far);
    let all = targets.chunks_exact(2);
    all.map(|target| [beside(target[0]), beside(target[1]), 0.0, 0.0, 0.0, 0.0])
        .collect()
}

fn works(target: &[f64], theta: &[f64]) -> bool {
    (theta[0] - target[0]).hypot(theta[1] - target[1]) <= REACH
}

fn capacity() -> Capacity {
    Capacity {
        forms: 12_000,
        tracked: usize::MAX,
        sums: usize::MAX,
        questions: 16,
        observations: CALLS as usize,
        instances: INSTANCES,
        steps: 1,
    }
}

fn config(seed: u64) -> Config {
    Config {
        seed,
        calls: CALLS,
        slack: 0.0,
        ..Config::default()
    }
}

/// What is learned from 100 calls, and all parameters that were asked for.
fn learn(problem: &Problem<'_>, seed: u64) -> (Option<Region>, Vec<Theta>) {
    let mut room = VersionSpaceRoom::<f64>::new(capacity());
    let memory = room.lend();
    let mut learner =
        VersionSpace::new(problem.domain(), config(seed), capacity(), memory).unwrap();
    let learned = learn_region(&mut learner, problem, |_, query| {
        let target = problem.instance(query.instance)?;
        Ok::<_, Error>(Outcome::from_feasible(works(target, &query.theta)))
    });
    let region = match learned {
        Ok(region) => Some(region.clone()),
        Err(Error::NoRegion) => None,
        Err(error) => panic!("{error}"),
    };
    let asked = learner.observations().iter().map(|o| o.theta);
    (region, asked.collect())
}

/// Of parameters in new instances about as many of which work as do not, the share that
/// the region is right about.
fn agreement(domain: &Domain<'_>, region: &Region) -> f64 {
    let targets = targets(1000);
    let mut right = 0;
    for seed in 0..100 {
        let all = near(&targets, 1.25 * REACH, seed);
        for (target, theta) in targets.chunks_exact(2).zip(&all) {
            let said = region.contains::<f64>(domain, target, &theta[..2]).unwrap();
            right += u32::from(said == works(target, theta));
        }
    }
    f64::from(right) / 1000.0
}

#[test]
fn a_region_of_half_a_percent_is_found_where_something_is_proposed() {
    let domain = Domain::parse(DOMAIN).unwrap();
    assert!((0.005..0.0051).contains(&(PI * REACH * REACH)));
    let mut found = [0; 2];
    for seed in 0..20 {
        let targets = targets(seed);
        let plain = Problem::new(&domain, &targets, INSTANCES).unwrap();
        // One in five of these works.
        let proposals = near(&targets, 2.0 * REACH, seed);
        let helped = plain.with_proposals(&proposals).unwrap();
        for (place, problem) in [plain, helped].into_iter().enumerate() {
            let (region, _) = learn(&problem, seed);
            let right = region.is_some_and(|region| agreement(&domain, &region) > 0.97);
            found[place] += u32::from(right);
        }
    }
    let [alone, helped] = found;
    assert!(alone < 10 && helped >= 19, "{found:?}");
}

#[test]
fn what_is_proposed_beyond_the_parameters_is_not_asked() {
    let domain = Domain::parse(DOMAIN).unwrap();
    let targets = targets(1);
    let problem = Problem::new(&domain, &targets, INSTANCES).unwrap();
    let proposals = [[1.5, -0.5, 0.0, 0.0, 0.0, 0.0]; INSTANCES];
    let (_, asked) = learn(&problem.with_proposals(&proposals).unwrap(), 1);
    assert_eq!(asked.len(), CALLS as usize);
    for theta in asked {
        assert!(
            theta[..2].iter().all(|x| (0.0..=1.0).contains(x)),
            "{theta:?}"
        );
    }
}

#[test]
fn proposals_are_checked() {
    let domain = Domain::parse(DOMAIN).unwrap();
    let targets = targets(2);
    let problem = Problem::new(&domain, &targets, INSTANCES).unwrap();
    let proposals = near(&targets, REACH, 2);
    let longer = [&proposals[..], &proposals[..1]].concat();
    for wrong in [&[][..], &proposals[1..], &longer] {
        let refused = problem.with_proposals(wrong);
        assert!(matches!(refused, Err(Error::InvalidArgument(_))));
    }
    for wrong in [f64::NAN, f64::INFINITY] {
        let mut proposals = proposals.clone();
        proposals[INSTANCES - 1][1] = wrong;
        let refused = problem.with_proposals(&proposals);
        assert!(matches!(refused, Err(Error::NotFinite(_))));
    }
    let helped = problem.with_proposals(&proposals).unwrap();
    assert_eq!(helped.proposal(3), Some(&proposals[3]));
    assert_eq!(helped.proposal(INSTANCES), None);
    assert_eq!(problem.proposal(0), None);
}

#[test]
fn other_proposals_are_another_problem() {
    let domain = Domain::parse(DOMAIN).unwrap();
    let targets = targets(3);
    let problem = Problem::new(&domain, &targets, INSTANCES).unwrap();
    let proposals = near(&targets, REACH, 3);
    let mut prints = vec![problem.fingerprint()];
    let fingerprint =
        |proposals: &[Theta]| problem.with_proposals(proposals).unwrap().fingerprint();
    prints.push(fingerprint(&proposals));
    for (instance, parameter) in [(0, 0), (0, 1), (INSTANCES - 1, 1)] {
        let mut other = proposals.clone();
        other[instance][parameter] = 0.5;
        prints.push(fingerprint(&other));
    }
    for (place, own) in prints.iter().enumerate() {
        assert!(!prints[..place].contains(own));
    }
    // What lies behind the parameters of the action says nothing.
    let mut same = proposals.clone();
    same[0][2] = f64::NAN;
    assert_eq!(fingerprint(&same), prints[1]);

    let mut room = VersionSpaceRoom::<f64>::new(capacity());
    let memory = room.lend();
    let mut learner = VersionSpace::new(&domain, config(3), capacity(), memory).unwrap();
    let helped = problem.with_proposals(&proposals).unwrap();
    learner.ask(&helped).unwrap();
    learner.tell(&helped, Outcome::Feasible).unwrap();
    assert!(matches!(learner.ask(&problem), Err(Error::Mismatch(_))));
    assert!(learner.ask(&helped).is_ok());
}
