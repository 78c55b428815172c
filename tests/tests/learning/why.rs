//! Why there is no exact region, or none that agrees with everything.

use critreg::domain::Domain;
use critreg::learn::version_space::{Capacity, Config, Quality, Why};
use critreg::learn::{Learner, Outcome, Problem, Query};
use critreg::random::{below, generator, uniform_in};
use critreg::region::{Region, Theta};
use critreg_tests::room::VersionSpaceRoom;

const WALL: &str = "
    object wall { x: length, y: length }
    constant margin = 0.25: length
    parameter reach in [0, 4]: length
    point hand = world + (reach, 0)
";
const WALLS: [f64; 8] = [1.0, 0.0, 2.0, 0.5, 2.5, -0.5, 3.0, 0.2];

const BAR: &str = "
    object bar { x: length, y: length, theta: angle, length: length, width: length }
    object can[2] { x: length, y: length, radius: length }
    parameter s in [-0.2, 0.2]: length
    point grip = bar + (s, 0)
    shape bar = rectangle(bar.length, bar.width) centred
    shape can = circle(can.radius)
    shape grip = circle(0.02)
";

#[test]
fn answers_that_contradict_each_other_are_told_of_a_region_that_strays() {
    let domain = Domain::parse(WALL).unwrap();
    let problem = Problem::new(&domain, &WALLS, 4).unwrap();
    let mut room = VersionSpaceRoom::<f64>::new(Capacity::new(1024, 128));
    let mut learner = room.learner(&domain, Config::default()).unwrap();
    let mut rng = generator(0);
    // The sample that works and is nearest to where none does.
    let mut nearest = (f64::MIN, None);
    for _ in 0..60 {
        let mut theta = Theta::default();
        theta[0] = uniform_in(&mut rng, 0.0, 4.0);
        let instance = below(&mut rng, 4);
        let beyond = theta[0] - (WALLS[2 * instance] - 0.25);
        let query = Query { instance, theta };
        let outcome = Outcome::from_feasible(beyond <= 0.0);
        learner.observe(&problem, &query, outcome).unwrap();
        if beyond <= 0.0 && beyond > nearest.0 {
            nearest = (beyond, Some(query));
        }
    }
    learner.conclude(&problem).unwrap();
    assert_eq!(learner.why(), Why::Explained);
    let query = nearest.1.unwrap();
    let wrong = Outcome::from_feasible(false);
    learner.observe(&problem, &query, wrong).unwrap();
    learner.conclude(&problem).unwrap();
    // One of some thirty that it admits is more than an exact region may be wrong about.
    assert_eq!(learner.quality(), Quality::Approximate);
    let (asked, differing) = (1, 1);
    assert_eq!(learner.why(), Why::Contradiction { asked, differing });
}

#[test]
fn what_strays_from_the_first_guess_is_not_unexplained() {
    let domain = Domain::parse(BAR).unwrap();
    let truth = "inside(grip, bar) >= 0 and min(clear(grip, can)) >= 0";
    let truth = Region::parse(&domain, truth).unwrap();
    let mut strayed = 0;
    for seed in 0..60 {
        let mut rng = generator(seed);
        let mut numbers = Vec::new();
        for _ in 0..16 {
            numbers.extend([0.0, 0.0, uniform_in(&mut rng, -3.1, 3.1)]);
            numbers.extend([uniform_in(&mut rng, 0.2, 0.4), 0.06]);
            for _ in 0..2 {
                let mut place = || uniform_in(&mut rng, -0.2, 0.2);
                numbers.extend([place(), place(), 0.04]);
            }
        }
        let problem = Problem::new(&domain, &numbers, 16).unwrap();
        let mut room = VersionSpaceRoom::<f64>::new(Capacity::new(4096, 128));
        let config = Config {
            seed,
            ..Config::default()
        };
        let mut learner = room.learner(&domain, config).unwrap();
        // Until one instance has both kinds of answers.
        let mut known = [[false; 2]; 16];
        while known.iter().all(|own| *own != [true; 2]) {
            let query = learner.ask(&problem).unwrap();
            let instance = problem.instance(query.instance).unwrap();
            let works = truth.contains::<f64>(&domain, instance, &query.theta[..1]);
            let works = works.unwrap();
            known[query.instance][usize::from(works)] = true;
            let outcome = Outcome::from_feasible(works);
            learner.tell(&problem, outcome).unwrap();
        }
        let provisional = learner.quality() == Quality::Provisional;
        if provisional && learner.report().strays > 0 {
            strayed += 1;
            assert!(matches!(learner.why(), Why::TooFew { .. }), "seed {seed}");
        }
    }
    assert!(strayed > 0);
}
