//! An action to learn about, and a judge of what is learned.

use critreg::Error;
use critreg::domain::Domain;
use critreg::learn::version_space::{Capacity, Config};
use critreg::learn::{Outcome, Problem, learn_region};
use critreg::random::{Generator, generator, uniform_in};
use critreg_tests::room::VersionSpaceRoom;
use critreg_tests::text;

const INSTANCES: usize = 16;
const CALLS: u32 = 120;
const SEEDS: u64 = 10;

/// What is to be learned: in which domain, from which instances, and what works.
pub(super) struct Task {
    pub domain: &'static str,
    pub draw: fn(&mut Generator, bool) -> Vec<f64>,
    pub works: fn(&[f64], &[f64]) -> bool,
    /// What says exactly that. A point over a body is one that meets it.
    pub regions: &'static [&'static str],
}

/// What is learned with a seed, as text, and its precision and recall in new instances.
fn learned(task: &Task, seed: u64, is_aligned: bool) -> (String, [f64; 2]) {
    let domain = Domain::parse(task.domain).unwrap();
    let count = domain.parameters().len();
    let mut rng = generator(1000 + seed);
    let instances: Vec<f64> = (0..INSTANCES)
        .flat_map(|_| (task.draw)(&mut rng, is_aligned))
        .collect();
    let problem = Problem::new(&domain, &instances, INSTANCES).unwrap();
    let mut room = VersionSpaceRoom::<f64>::new(Capacity {
        forms: 12_000,
        tracked: usize::MAX,
        sums: usize::MAX,
        questions: 16,
        observations: CALLS as usize,
        instances: INSTANCES,
        steps: 1,
    });
    let config = Config {
        seed,
        calls: CALLS,
        ..Config::default()
    };
    let mut learner = room.learner(&domain, config).unwrap();
    let region = learn_region(&mut learner, &problem, |_, query| {
        let works = (task.works)(problem.instance(query.instance)?, &query.theta[..count]);
        Ok::<_, Error>(Outcome::from_feasible(works))
    });
    let region = match region {
        Ok(region) => region,
        Err(error) => return (error.to_string(), [0.0; 2]),
    };
    let [mut both, mut admitted, mut working] = [0.0; 3];
    for _ in 0..20 {
        let numbers = (task.draw)(&mut rng, is_aligned);
        let grounded = region.ground::<f64>(&domain, &numbers).unwrap();
        for _ in 0..200 {
            let within = |p: &critreg::domain::Parameter<'_>| uniform_in(&mut rng, p.low, p.high);
            let theta: Vec<f64> = domain.parameters().iter().map(within).collect();
            let [inside, works] = [
                grounded.contains(&theta).unwrap(),
                (task.works)(&numbers, &theta),
            ]
            .map(|yes| f64::from(u8::from(yes)));
            both += inside * works;
            admitted += inside;
            working += works;
        }
    }
    assert!(working > 100.0, "too few parameters work to judge");
    let text = text::of_region(&domain, region);
    (text, [both / f64::max(admitted, 1.0), both / working])
}

/// The region is found word by word, and is right, with at least nine of ten seeds.
pub(super) fn check(task: &Task, is_aligned: bool) {
    let all: Vec<_> = (0..SEEDS)
        .map(|seed| learned(task, seed, is_aligned))
        .collect();
    let is_right = |[precision, recall]: [f64; 2]| precision >= 0.995 && recall >= 0.995;
    let found = all
        .iter()
        .filter(|(text, _)| task.regions.contains(&text.as_str()))
        .count();
    let right = all.iter().filter(|(_, shares)| is_right(*shares)).count();
    assert!(
        found >= 9,
        "{found} of {SEEDS} are one of {:?}: {all:#?}",
        task.regions
    );
    assert!(right >= 9, "{right} of {SEEDS} are right: {all:#?}");
    // Who says it in these words is right.
    for (text, shares) in &all {
        let said = task.regions.contains(&text.as_str());
        assert!(!said || is_right(*shares), "{shares:?}");
    }
}
