//! What the version-space learner promises.

use critreg::Error;
use critreg::domain::Domain;
use critreg::learn::version_space::{Capacity, Config, Evidence, Quality, Why};
use critreg::learn::{
    Learner, OBSERVATIONS_FULL, Observation, Outcome, Problem, Query, VersionSpace, learn_region,
    resume, save, saved_len,
};
use critreg::random::{generator, uniform, uniform_in};
use critreg::region::Region;
use critreg_tests::room::VersionSpaceRoom;
use critreg_tests::{report, text};
use proptest::prelude::*;

/// Two parameters, so that the region is no interval.
const TABLE: &str = "
    object cup  { x: length, y: length }
    object lamp { x: length, y: length }
    constant margin = 0.25: length
    constant table.width = 4.0: length
    parameter px in [0, 4]: length
    parameter py in [0, 4]: length
    point hand = world + (px, py)
";

const CALLS: u32 = 80;

fn room(calls: u32, instances: usize, steps: usize) -> VersionSpaceRoom {
    VersionSpaceRoom::new(Capacity {
        forms: 4000,
        tracked: usize::MAX,
        sums: usize::MAX,
        questions: 16,
        observations: calls as usize,
        instances,
        steps,
    })
}

fn config(seed: u64) -> Config {
    Config {
        seed,
        calls: CALLS,
        ..Config::default()
    }
}

fn table_instances(seed: u64, count: usize) -> Vec<f64> {
    let mut rng = generator(seed);
    (0..4 * count)
        .map(|_| 0.5 + 3.0 * uniform(&mut rng))
        .collect()
}

/// Clear of the cup, and left of the lamp.
fn is_clear(instance: &[f64], query: &Query) -> bool {
    let [cup_x, cup_y, lamp_x, ..] = *instance else {
        panic!("four numbers")
    };
    let [x, y, ..] = query.theta;
    (x - cup_x).hypot(y - cup_y) >= 0.75 && x <= lamp_x - 0.25
}

fn admits(region: &Region, problem: &Problem<'_>, o: &Observation) -> bool {
    let domain = problem.domain();
    let instance = problem.instance(o.instance as usize).unwrap();
    let used = domain.parameters().len();
    region
        .contains::<f64>(domain, instance, &o.theta[..used])
        .unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn without_slack_the_region_agrees_with_every_answer(seed in any::<u64>(), limit in 0.1..3.9) {
        let domain = Domain::parse(TABLE).unwrap();
        let instances = table_instances(seed, 4);
        let problem = Problem::new(&domain, &instances, 4).unwrap();
        let mut room = room(CALLS, 4, 1);
        let capacity = room.capacity;
        let config = Config { slack: 0.0, ..config(seed) };
        let mut learner = VersionSpace::new(&domain, config, capacity, room.lend()).unwrap();
        while !learner.is_finished() {
            let query = learner.ask(&problem).unwrap();
            let instance = problem.instance(query.instance).unwrap();
            let works = is_clear(instance, &query) && query.theta[1] <= limit;
            learner.tell(&problem, Outcome::from_feasible(works)).unwrap();
            if learner.quality() == Quality::Exact {
                let region = learner.region().unwrap();
                for o in learner.observations() {
                    let expected = o.outcome.is_feasible();
                    prop_assert_eq!(admits(region, &problem, o), expected, "{:?}", o);
                }
            }
        }
    }

    #[test]
    fn equal_seeds_ask_the_same_and_a_resumed_learner_goes_on(
        seed in any::<u64>(), stop in 0u32..CALLS,
    ) {
        let domain = Domain::parse(TABLE).unwrap();
        let instances = table_instances(seed, 3);
        let problem = Problem::new(&domain, &instances, 3).unwrap();
        let try_one = |learner: &mut VersionSpace<'_, f64>| {
            let query = learner.ask(&problem).unwrap();
            let works = is_clear(problem.instance(query.instance).unwrap(), &query);
            learner.tell(&problem, Outcome::from_feasible(works)).unwrap();
        };
        let (mut first, mut second) = (room(CALLS, 3, 1), room(CALLS, 3, 1));
        let capacity = first.capacity;
        let mut whole =
            VersionSpace::new(&domain, config(seed), capacity, first.lend()).unwrap();
        for _ in 0..stop {
            try_one(&mut whole);
        }
        let mut bytes = vec![0; saved_len(&whole, &problem)];
        save(&whole, &problem, &mut bytes).unwrap();
        while !whole.is_finished() {
            try_one(&mut whole);
        }
        let mut part = VersionSpace::new(&domain, config(seed), capacity, second.lend()).unwrap();
        resume(&mut part, &problem, &bytes).unwrap();
        while !part.is_finished() {
            try_one(&mut part);
        }
        prop_assert_eq!(part.observations(), whole.observations());
        prop_assert_eq!(part.region(), whole.region());
        prop_assert_eq!(part.report(), whole.report());
    }

    #[test]
    fn answers_by_chance_give_no_region(seed in any::<u64>(), share in 0.3..0.7) {
        let scenario = report::pick();
        let instances = scenario.draw(seed, 4);
        let problem = Problem::new(&scenario.domain, &instances, 4).unwrap();
        let mut room = room(100, 4, 1);
        let capacity = room.capacity;
        let config = Config { calls: 100, ..config(seed) };
        let mut learner =
            VersionSpace::new(&scenario.domain, config, capacity, room.lend()).unwrap();
        let mut rng = generator(seed ^ 1);
        let learned = learn_region(&mut learner, &problem, |_, _| {
            Ok::<_, Error>(Outcome::from_feasible(uniform(&mut rng) < share))
        });
        prop_assert_eq!(learned, Err(Error::NoRegion));
    }

    #[test]
    fn what_always_works_is_everything(seed in any::<u64>()) {
        let scenario = report::pick();
        let instances = scenario.draw(seed, 4);
        let problem = Problem::new(&scenario.domain, &instances, 4).unwrap();
        let mut room = room(60, 4, 1);
        let capacity = room.capacity;
        let config = Config { calls: 60, ..config(seed) };
        let mut learner =
            VersionSpace::new(&scenario.domain, config, capacity, room.lend()).unwrap();
        let learned = learn_region(&mut learner, &problem, |_, _| {
            Ok::<_, Error>(Outcome::Feasible)
        });
        prop_assert!(learned.unwrap().formula().constraints().is_empty());
        prop_assert_eq!(learner.why(), Why::AllWorked);
        let certificate = learner.report().certificate;
        prop_assert_eq!((certificate.draws, certificate.feasible), (60, 60));
    }

    #[test]
    fn a_parameter_without_influence_gives_no_region(seed in any::<u64>()) {
        let scenario = report::pick();
        let instances = scenario.draw(seed, 4);
        let problem = Problem::new(&scenario.domain, &instances, 4).unwrap();
        for works in [|_: &Query| false, |q: &Query| q.instance.is_multiple_of(2)] {
            let mut room = room(60, 4, 1);
            let capacity = room.capacity;
            let config = Config { calls: 60, ..config(seed) };
            let mut learner =
                VersionSpace::new(&scenario.domain, config, capacity, room.lend()).unwrap();
            let learned = learn_region(&mut learner, &problem, |_, query| {
                Ok::<_, Error>(Outcome::from_feasible(works(query)))
            });
            prop_assert_eq!(learned, Err(Error::NoRegion));
        }
    }
}

#[test]
fn several_parameters_are_learned_exactly() {
    let domain = Domain::parse(TABLE).unwrap();
    let instances = table_instances(5, 8);
    let problem = Problem::new(&domain, &instances, 8).unwrap();
    let mut room = room(150, 8, 1);
    let capacity = room.capacity;
    let config = Config {
        calls: 150,
        ..config(5)
    };
    let mut learner = VersionSpace::<f64>::new(&domain, config, capacity, room.lend()).unwrap();
    learn_region(&mut learner, &problem, |_, query| {
        let instance = problem.instance(query.instance)?;
        Ok::<_, Error>(Outcome::from_feasible(is_clear(instance, query)))
    })
    .unwrap();
    let learned = text::of_region(&domain, learner.region().unwrap());
    assert!(learned.contains("x - lamp.x <= -0.25 "), "{learned}");
    assert!(learned.contains("dist(hand, cup) >= 0.75 "), "{learned}");
    assert_eq!(learner.evidence().len(), 2);
    for evidence in learner.evidence() {
        assert!(evidence.support > 1, "{evidence:?}");
        assert_ne!(evidence.feasible, evidence.infeasible);
    }
    let certificate = learner.report().certificate;
    assert_eq!(certificate.draws, certificate.feasible);
    assert!(certificate.lower_bound > 0.7, "{certificate:?}");
}

#[test]
fn the_failed_step_makes_a_chain() {
    let scenario = report::chain();
    let instances = scenario.draw(1, scenario.instances);
    let problem = Problem::new(&scenario.domain, &instances, scenario.instances).unwrap();
    let mut room = room(scenario.calls, scenario.instances, 2);
    let capacity = room.capacity;
    let config = Config {
        calls: scenario.calls,
        ..config(1)
    };
    let mut learner =
        VersionSpace::<f64>::new(&scenario.domain, config, capacity, room.lend()).unwrap();
    learn_region(&mut learner, &problem, |_, query| {
        let instance = problem.instance(query.instance)?;
        Ok::<_, Error>(scenario.judge(instance, &query.theta[..1]))
    })
    .unwrap();
    let steps: Vec<u32> = learner.evidence().iter().map(|e| e.step).collect();
    assert!(steps.contains(&1) && steps.contains(&2), "{steps:?}");
}

#[test]
fn misuse_is_refused_and_changes_nothing() {
    let domain = Domain::parse(TABLE).unwrap();
    let instances = table_instances(1, 2);
    let problem = Problem::new(&domain, &instances, 2).unwrap();
    let mut small = room(CALLS, 1, 1);
    let capacity = small.capacity;
    let mut learner = VersionSpace::<f64>::new(&domain, config(1), capacity, small.lend()).unwrap();
    let asked = learner.ask(&problem);
    assert_eq!(asked, Err(Error::CapacityExceeded("problem instances")));
    let mut room = room(CALLS, 2, 1);
    let capacity = room.capacity;
    let bad = Config {
        noise: 0.5,
        ..config(1)
    };
    assert!(VersionSpace::<f64>::new(&domain, bad, capacity, room.lend()).is_err());
    let mut learner = VersionSpace::<f64>::new(&domain, config(1), capacity, room.lend()).unwrap();
    let told = learner.tell(&problem, Outcome::Feasible);
    assert!(matches!(told, Err(Error::OutOfSequence(_))));
    let query = learner.ask(&problem).unwrap();
    for step in [0, 2] {
        assert!(learner.tell(&problem, Outcome::FailedStep(step)).is_err());
    }
    assert_eq!(learner.ask(&problem).unwrap(), query);
    assert_eq!(learner.region(), Err(Error::NoRegion));
    assert!(learner.observations().is_empty());
}

#[test]
fn the_table_of_bytes_is_right() {
    let capacity = Capacity {
        forms: 4096,
        tracked: usize::MAX,
        sums: usize::MAX,
        questions: 16,
        observations: 256,
        instances: 4,
        steps: 1,
    };
    assert_eq!(
        capacity.intervals() * size_of::<critreg::learn::version_space::Interval<f64>>(),
        16 * (4096 + 256)
    );
    assert_eq!(capacity.exclusions() * 8, 16 * (4096 + 256) * 256 / 64);
    assert_eq!(capacity.rhs_values() * 8, (4096 + 512 + 2 * 8 * 48) * 4);
    let hypotheses =
        size_of::<critreg::learn::version_space::Hypothesis<f64>>() * capacity.hypotheses();
    assert!(hypotheses <= 5328, "{hypotheses}");
    assert_eq!(size_of::<Observation>(), 56);
}

/// What a learner finds with so many forms tracked: its questions, region and evidence.
fn learn_tracking(
    scenario: &report::Scenario,
    tracked: usize,
) -> (Vec<Observation>, String, Vec<Evidence>) {
    let instances = scenario.draw(5, scenario.instances);
    let problem = Problem::new(&scenario.domain, &instances, scenario.instances).unwrap();
    let mut room = VersionSpaceRoom::<f64>::new(Capacity {
        forms: 1024,
        tracked,
        sums: usize::MAX,
        questions: 16,
        observations: scenario.calls as usize,
        instances: scenario.instances,
        steps: scenario.steps,
    });
    let config = Config {
        seed: 3,
        calls: scenario.calls,
        ..Config::default()
    };
    let capacity = room.capacity;
    let domain = &scenario.domain;
    let mut learner = VersionSpace::<f64>::new(domain, config, capacity, room.lend()).unwrap();
    let region = learn_region(&mut learner, &problem, |_, query| {
        let theta = &query.theta[..domain.parameters().len()];
        Ok::<_, Error>(scenario.judge(problem.instance(query.instance)?, theta))
    });
    let text = text::of_region(domain, region.unwrap());
    (
        learner.observations().to_vec(),
        text,
        learner.evidence().to_vec(),
    )
}

#[test]
fn what_is_not_tracked_is_computed() {
    for scenario in [report::pick(), report::chain(), report::interval()] {
        let all = learn_tracking(&scenario, usize::MAX);
        for tracked in [0, 333] {
            let some = learn_tracking(&scenario, tracked);
            assert_eq!(some, all, "{} with {tracked} tracked", scenario.name);
        }
    }
}

/// A hand that works over the middle of a tray or clear of its rim, and near a lamp.
const TRAY: &str = "
    object tray { x: length, width: length }
    object lamp { x: length }
    parameter p in [0, 4]: length
    point hand      = world + (p, 0)
    point tray.mid  = world + (tray.x, 0)
    point tray.core = tray.mid + (0.25 * tray.width, 0)
    point tray.free = tray.mid + (1.5 * tray.width, 0)
    point lamp.foot = world + (lamp.x, 0)
";

#[test]
fn the_pieces_of_a_union_have_boundaries_of_their_own() {
    let domain = Domain::parse(TRAY).unwrap();
    let mut rng = generator(7);
    let draw = |_| {
        let numbers = [
            uniform_in(&mut rng, 1.0, 3.0),
            uniform_in(&mut rng, 0.3, 0.8),
        ];
        [
            numbers[0],
            numbers[1],
            numbers[0] + uniform_in(&mut rng, -1.0, 1.0),
        ]
    };
    let instances: Vec<f64> = (0..12).flat_map(draw).collect();
    let problem = Problem::new(&domain, &instances, 12).unwrap();
    let works = |instance: &[f64], p: f64| {
        let off = (p - instance[0]).abs();
        let clear = off <= 0.25 * instance[1] || off >= 1.5 * instance[1];
        clear && (p - instance[2]).abs() <= 1.0
    };
    for seed in 0..4 {
        let mut room = room(150, 12, 1);
        let config = Config {
            calls: 150,
            ..config(seed)
        };
        let capacity = room.capacity;
        let mut learner = VersionSpace::<f64>::new(&domain, config, capacity, room.lend()).unwrap();
        let region = learn_region(&mut learner, &problem, |_, query| {
            let instance = problem.instance(query.instance)?;
            Ok::<_, Error>(Outcome::from_feasible(works(instance, query.theta[0])))
        });
        let learned = text::of_region(&domain, region.unwrap());
        for piece in [
            "dist(hand, tray.mid) - dist(tray.core, tray.mid) <= 0",
            "dist(hand, tray.mid) - dist(tray.free, tray.mid) >= 0",
        ] {
            assert!(learned.contains(piece), "{seed}: {learned}");
        }
    }
}

/// Every third trial has no answer. Nothing is learned from it, the rest is learned as
/// always, and the run is saved with it.
#[test]
fn an_unknown_outcome_teaches_nothing() {
    let domain = Domain::parse(TABLE).unwrap();
    let instances = table_instances(5, 8);
    let problem = Problem::new(&domain, &instances, 8).unwrap();
    let config = Config {
        calls: 150,
        ..config(5)
    };
    let mut room = room(150, 8, 1);
    let capacity = room.capacity;
    let mut learner = VersionSpace::<f64>::new(&domain, config, capacity, room.lend()).unwrap();
    let mut before = None;
    for call in 0..150 {
        let query = learner.ask(&problem).unwrap();
        assert_ne!(
            Some(query),
            before,
            "what has no answer is not asked again at once"
        );
        let outcome = if call % 3 == 2 {
            Outcome::Unknown
        } else {
            Outcome::from_feasible(is_clear(problem.instance(query.instance).unwrap(), &query))
        };
        before = Some(query);
        let known = learner.report();
        let region = learner.region().ok().cloned();
        learner.tell(&problem, outcome).unwrap();
        if outcome == Outcome::Unknown {
            let report = learner.report();
            assert_eq!(report.unknown, known.unknown + 1);
            assert_eq!(report.feasible, known.feasible);
            assert_eq!(report.infeasible, known.infeasible);
            // The last call ends with a selection of its own.
            assert!(call == 149 || learner.region().ok() == region.as_ref());
        }
    }
    assert_eq!(learner.report().unknown, 50);
    let region = text::of_region(&domain, learner.region().unwrap());
    for o in learner.observations() {
        let works = is_clear(
            problem.instance(o.instance as usize).unwrap(),
            &Query {
                instance: o.instance as usize,
                theta: o.theta,
            },
        );
        let admitted = admits(learner.region().unwrap(), &problem, o);
        assert!(
            o.outcome == Outcome::Unknown || admitted == works,
            "{region}"
        );
    }
    let mut bytes = vec![0; saved_len(&learner, &problem)];
    save(&learner, &problem, &mut bytes).unwrap();
    let mut other = self::room(150, 8, 1);
    let mut resumed = VersionSpace::<f64>::new(&domain, config, capacity, other.lend()).unwrap();
    resume(&mut resumed, &problem, &bytes).unwrap();
    assert_eq!(text::of_region(&domain, resumed.region().unwrap()), region);
    assert_eq!(resumed.observations(), learner.observations());
}

/// There is room for fewer observations than calls: the call that finds none changes
/// nothing, and the question still waits.
#[test]
fn a_full_log_changes_nothing() {
    let domain = Domain::parse(TABLE).unwrap();
    let instances = table_instances(6, 4);
    let problem = Problem::new(&domain, &instances, 4).unwrap();
    let mut room = room(40, 4, 1);
    let capacity = room.capacity;
    let mut learner = VersionSpace::<f64>::new(&domain, config(6), capacity, room.lend()).unwrap();
    for _ in 0..40 {
        let query = learner.ask(&problem).unwrap();
        let works = is_clear(problem.instance(query.instance).unwrap(), &query);
        learner
            .tell(&problem, Outcome::from_feasible(works))
            .unwrap();
    }
    let query = learner.ask(&problem).unwrap();
    let report = learner.report();
    let region = text::of_region(&domain, learner.region().unwrap());
    for outcome in [Outcome::Feasible, Outcome::FailedStep(1), Outcome::Unknown] {
        let told = learner.tell(&problem, outcome);
        assert_eq!(told, Err(OBSERVATIONS_FULL));
        assert_eq!(learner.ask(&problem).unwrap(), query);
        assert_eq!(learner.report(), report);
        assert_eq!(text::of_region(&domain, learner.region().unwrap()), region);
    }
}
