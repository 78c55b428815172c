//! Answers of which a share is wrong: when learning ends, and what is certified.

use critreg::Error;
use critreg::domain::Domain;
use critreg::learn::version_space::{Capacity, Config, Report};
use critreg::learn::{Learner, Outcome, Problem, Query};
use critreg::random::{generator, uniform, uniform_in};
use critreg_tests::room::VersionSpaceRoom;

const WALLS: &str = "
    object wall { x: length, y: length }
    constant margin = 0.25: length
    parameter reach in [0, 4]: length
    point hand = world + (reach, 0)
";

/// Learns to stop before a wall, with so many wrong answers, until learning is finished; and
/// which share of the region works, if there is one.
fn learn(seed: u64, noise: f64, calls: u32) -> (Report, Option<f64>) {
    let domain = Domain::parse(WALLS).unwrap();
    let mut rng = generator(seed + 1000);
    let instances: Vec<f64> = (0..8).map(|_| uniform_in(&mut rng, 1.0, 3.0)).collect();
    let problem = Problem::new(&domain, &instances, 4).unwrap();
    let config = Config {
        seed,
        calls,
        noise,
        ..Config::default()
    };
    let mut room = VersionSpaceRoom::<f64>::new(Capacity::new(512, calls as usize));
    let mut learner = room.learner(&domain, config).unwrap();
    let works = |query: &Query| query.theta[0] <= instances[2 * query.instance] - 0.25;
    while !learner.is_finished() {
        let query = learner.ask(&problem).unwrap();
        let told = works(&query) != (uniform(&mut rng) < noise);
        learner
            .tell(&problem, Outcome::from_feasible(told))
            .unwrap();
    }
    // It is finished: nothing is asked any more, and nothing is told.
    let asked = learner.ask(&problem);
    assert!(
        matches!(asked, Err(Error::OutOfSequence(_))),
        "seed {seed}: {asked:?}"
    );
    let told = learner.tell(&problem, Outcome::Feasible);
    assert!(
        matches!(told, Err(Error::OutOfSequence(_))),
        "seed {seed}: {told:?}"
    );
    let report = learner.report();
    assert_eq!(report.calls, calls as usize);
    let share = learner.region().ok().map(|region| {
        let inside = (0..400).map(|index| {
            let instance = index % 4;
            let values = problem.instance(instance).unwrap();
            let theta = region.sample::<f64>(&domain, values, &mut rng).unwrap();
            works(&Query { instance, theta })
        });
        inside.filter(|works| *works).count() as f64 / 400.0
    });
    (report, share)
}

#[test]
fn nothing_is_asked_when_learning_is_finished() {
    for seed in 0..30 {
        for (noise, calls) in [(0.0, 40), (0.02, 97), (0.1, 151), (0.2, 203)] {
            learn(seed, noise, calls);
        }
    }
}

/// A draw takes several answers where some are wrong; what counts are the draws.
#[test]
fn the_certificate_counts_samples() {
    let (mut bounds, mut shares, mut regions) = (0.0, 0.0, 0.0);
    for seed in 0..20 {
        let (report, share) = learn(seed, 0.1, 400);
        let certificate = report.certificate;
        assert!(certificate.draws <= 10 + 1, "{certificate:?}");
        if let Some(share) = share {
            regions += 1.0;
            shares += share;
            bounds += certificate.lower_bound;
        }
    }
    assert!(regions >= 18.0, "{regions}");
    let (bound, share) = (bounds / regions, shares / regions);
    assert!(share > 0.97 && bound > 0.6, "bound {bound} at {share}");
}
