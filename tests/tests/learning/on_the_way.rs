//! What a learner says before it knows all: every region on the way is one that can be read,
//! and kept.

use critreg::domain::{Domain, Parameter};
use critreg::learn::version_space::{Capacity, Config};
use critreg::learn::{Learner, Outcome, Problem};
use critreg::random::{generator, uniform_in};
use critreg::region::{Region, SavedRegion};
use critreg_tests::room::VersionSpaceRoom;
use critreg_tests::text;

/// An action, and when it works.
struct Action {
    domain: &'static str,
    ends: &'static [(f64, f64)],
    works: fn(&[f64], &[f64]) -> bool,
}

/// A slope that is no diagonal: that cannot be said.
const ROOF: Action = Action {
    domain: "
        object house { x: length, y: length, ridge: length }
        parameter px in [-3, 3]: length
        parameter py in [0, 4]: length
        point drone = world + (px, py)
    ",
    ends: &[(-1.0, 1.0), (0.0, 1.0), (0.5, 2.0)],
    works: |i, t| t[1] - i[1] + 0.6 * (t[0] - i[0]) >= i[2],
};

/// A volume, for which there is no word.
const FILL: Action = Action {
    domain: "
        object bin { width: length, depth: length, height: length }
        object bag { volume: none }
        parameter level in [0, 0.6]: length
    ",
    ends: &[(0.3, 0.6), (0.2, 0.5), (0.3, 0.6), (0.01, 0.08)],
    works: |i, t| t[0] * i[0] * i[1] <= i[3] && t[0] <= i[2],
};

/// Learns, and reads each region again, from its text and from saved bytes.
fn check(action: &Action, capacity: Capacity, seed: u64) {
    let calls = capacity.observations as u32 - 2;
    const INSTANCES: usize = 16;
    let domain = Domain::parse(action.domain).unwrap();
    let mut rng = generator(seed);
    let ends = || std::iter::repeat_n(action.ends, INSTANCES).flatten();
    let numbers: Vec<f64> = ends()
        .map(|(low, high)| uniform_in(&mut rng, *low, *high))
        .collect();
    let problem = Problem::new(&domain, &numbers, INSTANCES).unwrap();
    let mut room = VersionSpaceRoom::<f64>::new(capacity);
    let config = Config {
        seed,
        calls,
        ..Config::default()
    };
    let mut learner = room.learner(&domain, config).unwrap();
    let count = domain.parameters().len();
    let mut bytes = vec![0; 8_000];
    while !learner.is_finished() {
        let query = learner.ask(&problem).unwrap();
        let instance = problem.instance(query.instance).unwrap();
        let works = (action.works)(instance, &query.theta[..count]);
        learner
            .tell(&problem, Outcome::from_feasible(works))
            .unwrap();
        let Ok(region) = learner.best_region() else {
            continue;
        };
        let said = text::of_region(&domain, region);
        assert!(!said.contains("e308"), "seed {seed}: {said}");
        assert_ne!(said, "true", "seed {seed}");
        assert_eq!(
            learner.evidence().len(),
            region.formula().constraints().len(),
            "{said}"
        );
        let read = Region::parse(&domain, &said).expect(&said);
        assert_eq!(text::of_region(&domain, &read), said);
        let length = region.save::<f64>(&domain, &mut bytes).unwrap();
        let saved = SavedRegion::read(&bytes[..length]).unwrap();
        assert_eq!(saved.region_text, said);
        // It is the same in every place.
        let within = |p: &Parameter<'_>| uniform_in(&mut rng, p.low, p.high);
        let theta: Vec<f64> = domain.parameters().iter().map(within).collect();
        assert_eq!(
            region.contains::<f64>(&domain, instance, &theta),
            read.contains::<f64>(&domain, instance, &theta)
        );
    }
}

#[test]
fn every_region_on_the_way_can_be_read() {
    let plain = Capacity::new(4_096, 302);
    // A disjunction lies between answers that it cannot take in.
    check(&ROOF, plain, 10);
    let with_sums = Capacity {
        sums: usize::MAX,
        ..Capacity::new(4_096, 62)
    };
    (0..4).for_each(|seed| check(&FILL, with_sums, seed));
}
