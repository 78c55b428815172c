//! What was not asked: logs and demonstrations.

use crate::shelf::{SHELF, fits, go_on, room, saved, shelves};
use critreg::Error;
use critreg::domain::Domain;
use critreg::learn::version_space::{Config, Quality, Why};
use critreg::learn::{Learner, Outcome, Problem, Query, VersionSpace, learn_region, resume};
use critreg::random::{Generator, generator, uniform_in};
use critreg::region::Theta;
use critreg_tests::pick;
use critreg_tests::room::Algorithm1Room;
use proptest::prelude::*;

const SLOT: &str = "
    object slot { x: length }
    parameter px in [0, 1]: length
";

const INSTANCES: usize = 8;

fn theta(values: &[f64]) -> Theta {
    let mut theta = Theta::default();
    theta[..values.len()].copy_from_slice(values);
    theta
}

fn anywhere(rng: &mut Generator, count: usize) -> Query {
    Query {
        instance: (uniform_in(rng, 0.0, count as f64) as usize).min(count - 1),
        theta: theta(&[uniform_in(rng, 0.0, 4.0), uniform_in(rng, 0.0, 4.0)]),
    }
}

/// Whether a slot of some width is learned to a fiftieth of that, from demonstrations in the
/// first so many instances.
fn learns_slot(seed: u64, width: f64, demonstrations: usize) -> bool {
    let domain = Domain::parse(SLOT).unwrap();
    let mut rng = generator(seed);
    let slots: Vec<f64> = (0..16).map(|_| uniform_in(&mut rng, 0.1, 0.9)).collect();
    let problem = Problem::new(&domain, &slots, 16).unwrap();
    let mut room = room(256);
    let config = Config {
        seed,
        calls: 250,
        ..Config::default()
    };
    let mut learner = VersionSpace::new(&domain, config, room.capacity, room.lend()).unwrap();
    for (instance, slot) in slots.iter().enumerate().take(demonstrations) {
        let theta = theta(&[slot + 0.2 * width]);
        let known = Query { instance, theta };
        learner
            .observe(&problem, &known, Outcome::Feasible)
            .unwrap();
    }
    let works = |query: &Query| (query.theta[0] - slots[query.instance]).abs() <= 0.5 * width;
    let learned = learn_region(&mut learner, &problem, |_, query| {
        Ok::<_, Error>(Outcome::from_feasible(works(query)))
    });
    let Ok(region) = learned else { return false };
    let admits = |share: f64| {
        let inside = |slot: &f64| {
            let theta = [slot + share * width];
            region.contains::<f64>(&domain, &[*slot], &theta).unwrap()
        };
        [0.15, 0.35, 0.85]
            .iter()
            .filter(|slot| inside(slot))
            .count()
    };
    [-0.49, 0.0, 0.49].map(admits) == [3; 3] && [-0.51, 0.51].map(admits) == [0; 2]
}

#[test]
fn a_demonstration_suffices_to_find_a_slot() {
    for (width, demonstrations) in [(1e-3, 1), (1e-4, 1), (1e-4, 2)] {
        let exact = (0..4).filter(|seed| learns_slot(*seed, width, demonstrations));
        let exact = exact.count();
        assert_eq!(exact, 4, "{width}, {demonstrations}");
    }
}

#[test]
fn a_log_determines_a_region() {
    let domain = Domain::parse(SHELF).unwrap();
    let instances = shelves(3, INSTANCES);
    let problem = Problem::new(&domain, &instances, INSTANCES).unwrap();
    let mut room = room(1000);
    let config = Config {
        calls: 0,
        ..Config::default()
    };
    let mut learner = VersionSpace::new(&domain, config, room.capacity, room.lend()).unwrap();
    let mut rng = generator(5);
    for _ in 0..1000 {
        let query = anywhere(&mut rng, INSTANCES);
        let outcome = fits(&problem, &query);
        learner.observe(&problem, &query, outcome).unwrap();
    }
    learner.conclude(&problem).unwrap();
    let report = learner.report();
    assert_eq!((report.calls, report.observed), (0, 1000));
    assert_eq!(learner.quality(), Quality::Exact);
    let region = learner.region().unwrap();
    assert_eq!(
        region.display(&domain).to_string(),
        "py - shelf.y >= 0.25 (margin) and px - cup.x <= -0.25 (-margin)"
    );
}

/// Of a log some outcomes are wrong, which nobody said; it is longer than the table.
#[test]
fn a_log_with_wrong_outcomes_determines_a_region() {
    let domain = Domain::parse(SHELF).unwrap();
    let instances = shelves(3, INSTANCES);
    let problem = Problem::new(&domain, &instances, INSTANCES).unwrap();
    let (mut first, mut second) = (room(1000), room(1000));
    let config = Config {
        calls: 0,
        ..Config::default()
    };
    let mut learner = first.learner(&domain, config).unwrap();
    let mut rng = generator(13);
    for _ in 0..3000 {
        let query = anywhere(&mut rng, INSTANCES);
        let wrong = uniform_in(&mut rng, 0.0, 1.0) < 0.02;
        let outcome = Outcome::from_feasible(fits(&problem, &query).is_feasible() != wrong);
        learner.observe(&problem, &query, outcome).unwrap();
    }
    learner.conclude(&problem).unwrap();
    assert_eq!(learner.quality(), Quality::Approximate);
    // What was put aside judges it, and some of that is wrong, too.
    let report = learner.report();
    let (lower, upper) = report.precision(config.confidence).unwrap();
    assert!(report.certificate.draws >= 50, "{report:?}");
    assert!(lower > 0.85 && upper > 0.95, "{lower} {upper}");
    let region = learner.region().unwrap();
    // It is right where no answer was ever wrong: in instances that nobody saw.
    let unseen = shelves(5, 200);
    let other = Problem::new(&domain, &unseen, 200).unwrap();
    let (mut inside, mut right, mut found, mut all) = (0, 0, 0, 0);
    for _ in 0..20_000 {
        let query = anywhere(&mut rng, 200);
        let values = other.instance(query.instance).unwrap();
        let admitted = region.contains::<f64>(&domain, values, &query.theta[..2]);
        let (admitted, works) = (admitted.unwrap(), fits(&other, &query).is_feasible());
        inside += usize::from(admitted);
        right += usize::from(admitted && works);
        all += usize::from(works);
        found += usize::from(works && admitted);
    }
    assert!(right as f64 >= 0.98 * inside as f64, "{right} of {inside}");
    assert!(found as f64 >= 0.98 * all as f64, "{found} of {all}");

    let mut again = second.learner(&domain, config).unwrap();
    resume(&mut again, &problem, &saved(&learner, &problem)).unwrap();
    assert_eq!(again.report(), learner.report());
    assert_eq!(again.region(), learner.region());
}

#[test]
fn demonstrations_alone_prove_nothing() {
    let domain = Domain::parse(SHELF).unwrap();
    let instances = shelves(3, INSTANCES);
    let problem = Problem::new(&domain, &instances, INSTANCES).unwrap();
    let mut room = room(64);
    let capacity = room.capacity;
    let mut learner = VersionSpace::new(&domain, Config::default(), capacity, room.lend()).unwrap();
    let mut rng = generator(7);
    while learner.observations().len() < 20 {
        let query = anywhere(&mut rng, INSTANCES);
        if fits(&problem, &query).is_feasible() {
            learner
                .observe(&problem, &query, Outcome::Feasible)
                .unwrap();
        }
    }
    learner.conclude(&problem).unwrap();
    assert_eq!(learner.region(), Err(Error::NoRegion));
    assert_eq!(learner.why(), Why::AllWorked);
}

#[test]
fn misuse_is_refused_and_changes_nothing() {
    let domain = Domain::parse(SHELF).unwrap();
    let instances = shelves(3, INSTANCES);
    let problem = Problem::new(&domain, &instances, INSTANCES).unwrap();
    let mut room = room(64);
    let capacity = room.capacity;
    let mut learner = VersionSpace::new(&domain, Config::default(), capacity, room.lend()).unwrap();
    let known = Query {
        instance: 1,
        theta: theta(&[1.0, 2.0]),
    };
    let nowhere = Query {
        instance: INSTANCES,
        ..known
    };
    let endless = Query {
        theta: theta(&[1.0, f64::NAN]),
        ..known
    };
    let refused = [
        (nowhere, Outcome::Feasible),
        (endless, Outcome::Feasible),
        (known, Outcome::FailedStep(2)),
        (known, Outcome::FailedStep(0)),
    ];
    for (query, outcome) in refused {
        assert!(learner.observe(&problem, &query, outcome).is_err());
    }
    let others = shelves(4, INSTANCES);
    let other = Problem::new(&domain, &others, INSTANCES).unwrap();
    let mismatched = learner.observe(&other, &known, Outcome::Feasible);
    assert!(matches!(mismatched, Err(Error::Mismatch(_))));
    assert!(learner.observations().is_empty());
    learner.observe(&problem, &known, Outcome::Unknown).unwrap();
    assert_eq!(learner.report().unknown, 1);

    // Nothing goes to make room for what is refused.
    let mut rng = generator(5);
    while learner.observations().len() < learner.room() {
        let query = anywhere(&mut rng, INSTANCES);
        let outcome = fits(&problem, &query);
        learner.observe(&problem, &query, outcome).unwrap();
    }
    for (query, outcome) in refused {
        assert!(learner.observe(&problem, &query, outcome).is_err());
        assert_eq!(learner.observations().len(), learner.room());
    }

    let domain = pick::domain();
    let instances = pick::instances(1, 1);
    let problem = Problem::new(&domain, &instances, 1).unwrap();
    let mut room = Algorithm1Room::new(4096, 16);
    let mut learner = pick::learner(&domain, 1, &mut room).unwrap();
    let known = Query {
        instance: 0,
        theta: theta(&[0.5]),
    };
    let refused = learner.observe(&problem, &known, Outcome::Feasible);
    assert!(matches!(refused, Err(Error::InvalidArgument(_))));
    assert!(learner.observations().is_empty());
}

/// Something that is done with a learner.
#[derive(Clone, Copy, Debug)]
enum Deed {
    Ask,
    Tell,
    Observe,
    Conclude,
}

fn deeds() -> impl Strategy<Value = Vec<Deed>> {
    let deed = prop_oneof![
        4 => Just(Deed::Ask),
        4 => Just(Deed::Tell),
        2 => Just(Deed::Observe),
        1 => Just(Deed::Conclude),
    ];
    prop::collection::vec(deed, 0..80)
}

/// Does it, as far as it is possible: what is asked and observed follows from the learner.
fn perform(learner: &mut VersionSpace<'_, f64>, problem: &Problem<'_>, deed: Deed) {
    match deed {
        Deed::Ask if !learner.is_finished() => {
            learner.ask(problem).unwrap();
        }
        Deed::Tell if !learner.is_finished() => {
            let query = learner.ask(problem).unwrap();
            learner.tell(problem, fits(problem, &query)).unwrap();
        }
        Deed::Observe => {
            let mut rng = generator(learner.observations().len() as u64);
            let query = anywhere(&mut rng, problem.count());
            let outcome = fits(problem, &query);
            learner.observe(problem, &query, outcome).unwrap();
        }
        Deed::Conclude => learner.conclude(problem).unwrap(),
        Deed::Ask | Deed::Tell => {}
    }
}

/// The region of a log, as text; the log goes on after the run was saved and resumed.
#[test]
fn a_log_may_be_longer_than_the_table() {
    let domain = Domain::parse(SHELF).unwrap();
    let instances = shelves(11, INSTANCES);
    let problem = Problem::new(&domain, &instances, INSTANCES).unwrap();
    let config = Config {
        calls: 30,
        ..Config::default()
    };
    let (mut first, mut second) = (room(256), room(256));
    let mut whole = first.learner(&domain, config).unwrap();
    let mut rng = generator(11);
    let mut log = |learner: &mut [&mut VersionSpace<'_, f64>], length: usize| {
        for _ in 0..length {
            let query = anywhere(&mut rng, INSTANCES);
            for learner in &mut *learner {
                let outcome = fits(&problem, &query);
                learner.observe(&problem, &query, outcome).unwrap();
            }
        }
    };
    log(&mut [&mut whole], 3000);
    let report = whole.report();
    assert_eq!(report.observed, 3000);
    assert_eq!(whole.observations().len() + report.dropped, 3000);
    let mut part = second.learner(&domain, config).unwrap();
    resume(&mut part, &problem, &saved(&whole, &problem)).unwrap();
    assert_eq!(part.report(), whole.report());

    log(&mut [&mut whole, &mut part], 500);
    go_on(&mut whole, &problem, 30);
    go_on(&mut part, &problem, 30);
    assert_eq!(part.observations(), whole.observations());
    assert_eq!(part.report(), whole.report());
    let text = whole.region().unwrap().display(&domain).to_string();
    assert_eq!(whole.quality(), Quality::Exact, "{text}");
    assert_eq!(
        text.matches("(-margin)").count() + text.matches("(margin)").count(),
        2,
        "{text}"
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn a_run_is_resumed_wherever_it_stopped(
        seed in any::<u64>(), noise in any::<bool>(), before in deeds(), after in deeds(),
    ) {
        let domain = Domain::parse(SHELF).unwrap();
        let instances = shelves(seed, INSTANCES);
        let problem = Problem::new(&domain, &instances, INSTANCES).unwrap();
        let config = Config {
            seed,
            calls: 40,
            noise: if noise { 0.05 } else { 0.0 },
            ..Config::default()
        };
        let (mut first, mut second) = (room(256), room(256));
        let capacity = first.capacity;
        let mut whole = VersionSpace::new(&domain, config, capacity, first.lend()).unwrap();
        for deed in before {
            perform(&mut whole, &problem, deed);
        }
        let bytes = saved(&whole, &problem);
        let mut part = VersionSpace::new(&domain, config, capacity, second.lend()).unwrap();
        resume(&mut part, &problem, &bytes).unwrap();
        for deed in after {
            perform(&mut whole, &problem, deed);
            perform(&mut part, &problem, deed);
        }
        prop_assert_eq!(part.observations(), whole.observations());
        prop_assert_eq!(part.region(), whole.region());
        prop_assert_eq!(part.report(), whole.report());
    }

    #[test]
    fn an_open_question_stays_open(seed in any::<u64>(), observed in 0usize..20) {
        let domain = Domain::parse(SHELF).unwrap();
        let instances = shelves(seed, INSTANCES);
        let problem = Problem::new(&domain, &instances, INSTANCES).unwrap();
        let mut room = room(256);
        let config = Config { seed, ..Config::default() };
        let capacity = room.capacity;
        let mut learner = VersionSpace::new(&domain, config, capacity, room.lend()).unwrap();
        for _ in 0..10 {
            perform(&mut learner, &problem, Deed::Tell);
        }
        let query = learner.ask(&problem).unwrap();
        for _ in 0..observed {
            perform(&mut learner, &problem, Deed::Observe);
        }
        perform(&mut learner, &problem, Deed::Conclude);
        prop_assert_eq!(learner.ask(&problem).unwrap(), query);
        learner.tell(&problem, fits(&problem, &query)).unwrap();
        let last = learner.observations().last().unwrap();
        prop_assert_eq!((last.query(), last.asked()), (query, true));
        prop_assert_eq!(learner.report().observed, observed);
        prop_assert_eq!(learner.report().calls, 11);
    }
}
