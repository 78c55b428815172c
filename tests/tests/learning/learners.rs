//! Algorithm 1 against a plain set of hypotheses, and what all learners promise.

use critreg::Error;
use critreg::domain::{Domain, Node, NodeId, PointSet, Sample, Scene};
use critreg::grammar::{Comparison, Features, Hypotheses};
use critreg::learn::algorithm1::Config;
use critreg::learn::{
    Algorithm1, Learner, OBSERVATIONS_FULL, Outcome, Problem, Query, resume, save, saved_len,
};
use critreg_tests::room::Algorithm1Room;
use critreg_tests::{arm, pick};
use proptest::prelude::*;
use std::collections::BTreeMap;

/// A domain so small that nothing overflows.
const REACH: &str = "
    object wall { x: length, y: length }
    constant margin = 0.25: length
    parameter reach in [0, 4]: length
    point hand = world + (reach, 0.5)
";

/// A hypothesis: left side, comparison, right side.
type Hypothesis = (u16, Comparison, u16);

/// Algorithm 1 as prose: sets of hypotheses, one by one.
struct Oracle {
    nodes: Vec<Node>,
    remaining: Vec<Hypothesis>,
    /// The numeric bound of each remaining hypothesis, once one was recorded.
    bounds: BTreeMap<(u16, bool), (f64, Hypothesis)>,
}

impl Oracle {
    fn new(learner: &Algorithm1<'_, f64>) -> Oracle {
        let mut remaining = Vec::new();
        let features = learner.features();
        learner
            .hypotheses()
            .for_each(features, |l, c, r| remaining.push((l.0, c, r.0)));
        Oracle {
            nodes: features.nodes().to_vec(),
            remaining,
            bounds: BTreeMap::new(),
        }
    }

    fn tell(&mut self, problem: &Problem<'_>, query: &Query, feasible: bool) {
        let domain = problem.domain();
        let instance = problem.instance(query.instance).unwrap();
        let scene: Scene<'_, f64> = Scene::new(domain, instance, PointSet::all(domain)).unwrap();
        let sample: Sample<'_, '_, f64, f64> = scene.sample(&query.theta);
        // Every hypothesis on its own, by walking its terms.
        let value = |id: u16| sample.measure(&self.nodes, NodeId(id));
        let holds = |(l, c, r): &Hypothesis| c.holds(&value(*l), &value(*r));
        // Eq. 4.8 and 4.9.
        let mut remaining = self.remaining.clone();
        remaining.retain(|h| holds(h) == feasible);
        if feasible {
            let mut best: BTreeMap<(u16, bool), (f64, Hypothesis)> = BTreeMap::new();
            for h @ (left, comparison, right) in &remaining {
                let key = (*left, comparison.is_upper());
                let tighter = |a: f64, b: f64| if comparison.is_upper() { a < b } else { a > b };
                let mut bound = value(*right);
                if let Some((old, from)) = self.bounds.get(&key)
                    && from == h
                    && !tighter(bound, *old)
                {
                    bound = *old;
                }
                let strict = |c: Comparison| !c.admits_equal();
                let better = match best.get(&key) {
                    None => true,
                    Some((other, (_, c, _))) => {
                        tighter(bound, *other)
                            || (bound == *other && strict(*comparison) && !strict(*c))
                    }
                };
                if better {
                    best.insert(key, (bound, *h));
                }
            }
            remaining.retain(|h| best.values().any(|(_, kept)| kept == h));
            self.bounds = best;
        } else {
            self.bounds.retain(|_, (_, h)| remaining.contains(h));
        }
        self.remaining = remaining;
    }

    fn region_bounds(&self) -> Vec<f64> {
        let mut bounds: Vec<f64> = self.bounds.values().map(|(bound, _)| *bound).collect();
        bounds.sort_by(f64::total_cmp);
        bounds
    }
}

fn region_bounds(learner: &Algorithm1<'_, f64>) -> Vec<f64> {
    let Ok(region) = learner.region() else {
        return Vec::new();
    };
    let formula = region.formula();
    let number = |id: NodeId| match formula.nodes()[usize::from(id.0)] {
        Node::Number(value) => value,
        other => panic!("a bound that is no number: {other:?}"),
    };
    let bounds = formula.constraints().iter().map(|c| number(c.rhs));
    let mut bounds: Vec<f64> = bounds.collect();
    bounds.sort_by(f64::total_cmp);
    bounds
}

fn region_text(learner: &impl Learner, domain: &Domain<'_>) -> String {
    let mut text = String::new();
    match learner.region() {
        Ok(region) => region.write(domain, &mut text).unwrap(),
        Err(error) => text = error.to_string(),
    }
    text
}

/// Runs the learner beside the oracle; `answer` is the simulator.
fn agree(
    domain: &Domain<'_>,
    instances: &[f64],
    count: usize,
    config: Config,
    hypotheses: usize,
    answer: impl Fn(&Problem<'_>, &Query) -> bool,
) {
    let problem = Problem::new(domain, instances, count).unwrap();
    let mut room = Algorithm1Room::new(hypotheses, 256);
    let capacity = room.capacity;
    let mut learner = Algorithm1::new(domain, config, capacity, room.lend()).unwrap();
    let mut oracle = Oracle::new(&learner);
    while !learner.is_finished() {
        let query = learner.ask(&problem).unwrap();
        assert_eq!(learner.ask(&problem).unwrap(), query, "asking twice");
        let feasible = answer(&problem, &query);
        learner
            .tell(&problem, Outcome::from_feasible(feasible))
            .unwrap();
        oracle.tell(&problem, &query, feasible);
        let mut remaining = Vec::new();
        learner
            .hypotheses()
            .for_each(learner.features(), |l, c, r| remaining.push((l.0, c, r.0)));
        assert_eq!(remaining, oracle.remaining);
        assert_eq!(learner.report().remaining, remaining.len());
        assert_eq!(region_bounds(&learner), oracle.region_bounds());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn algorithm1_agrees_with_a_plain_set(seed in any::<u64>(), manual in any::<bool>()) {
        let instances = pick::instances(seed, 3);
        let mut config = pick::config(seed);
        config.iterations = 30;
        if !manual {
            (config.negative, config.positive) = (None, None);
        }
        agree(&pick::domain(), &instances, 3, config, 2000, |problem, query| {
            let instance = problem.instance(query.instance).unwrap();
            pick::ENVIRONMENT.try_pick(instance, &query.theta).unwrap().is_feasible()
        });
    }

    #[test]
    fn algorithm1_agrees_with_a_plain_set_on_any_answers(
        seed in any::<u64>(), answers in prop::collection::vec(any::<bool>(), 40),
    ) {
        let domain = Domain::parse(REACH).unwrap();
        let config = Config { seed, iterations: 40, ..Config::default() };
        let next = std::cell::Cell::new(0);
        agree(&domain, &[1.0, 0.0, 2.0, 1.0, 3.0, 0.5], 3, config, 8192, |_, _| {
            next.set(next.get() + 1);
            answers[next.get() - 1]
        });
    }

    #[test]
    fn enumeration_never_exceeds_its_room_and_reports_the_rest(pairs in 0usize..3000) {
        let domain = pick::domain();
        let mut room = Algorithm1Room::new(4 * pairs, 0);
        let capacity = room.capacity;
        let memory = room.lend();
        let features: Features<'_, f64> =
            Features::enumerate(&domain, memory.features, memory.values).unwrap();
        prop_assert!(features.len() <= capacity.features());
        let hypotheses = Hypotheses::enumerate(&features, memory.pairs);
        let counts = hypotheses.enumeration();
        let mut listed = 0;
        hypotheses.for_each(&features, |_, _, _| listed += 1);
        prop_assert_eq!(listed, counts.kept);
        prop_assert!(counts.kept <= 4 * pairs as u64);
        prop_assert_eq!(counts.kept + counts.left_out, counts.enumerated);
    }

    #[test]
    fn a_resumed_learner_goes_on_as_if_never_stopped(seed in 0u64..1000, stop in 0usize..40) {
        let domain = pick::domain();
        let instances = pick::instances(seed, 4);
        let problem = Problem::new(&domain, &instances, 4).unwrap();
        let (mut first, mut second) = (Algorithm1Room::new(4096, 128), Algorithm1Room::new(4096, 128));
        let mut whole = pick::learner(&domain, seed, &mut first).unwrap();
        let try_one = |learner: &mut Algorithm1<'_, f64>| {
            let query = learner.ask(&problem).unwrap();
            let instance = problem.instance(query.instance).unwrap();
            let answer = pick::ENVIRONMENT.try_pick(instance, &query.theta).unwrap();
            learner.tell(&problem, answer).unwrap();
        };
        let mut bytes = Vec::new();
        let mut told = 0;
        while !whole.is_finished() {
            if told == stop {
                bytes = vec![0; saved_len(&whole, &problem)];
                prop_assert_eq!(save(&whole, &problem, &mut bytes).unwrap(), bytes.len());
            }
            try_one(&mut whole);
            told += 1;
        }
        prop_assume!(!bytes.is_empty());
        let mut part = pick::learner(&domain, seed, &mut second).unwrap();
        resume(&mut part, &problem, &bytes).unwrap();
        while !part.is_finished() {
            try_one(&mut part);
        }
        prop_assert_eq!(part.observations(), whole.observations());
        prop_assert_eq!(region_text(&part, &domain), region_text(&whole, &domain));
        prop_assert_eq!(part.report(), whole.report());
        let bytes = |learner: &Algorithm1<'_, f64>| {
            let mut bytes = vec![0; saved_len(learner, &problem)];
            save(learner, &problem, &mut bytes).unwrap();
            bytes
        };
        prop_assert_eq!(bytes(&part), bytes(&whole));
    }
}

/// Every hypothesis of a domain as text, from a table in which nothing overflows.
fn all_hypotheses(domain: &Domain<'_>) -> Vec<String> {
    let mut room = Algorithm1Room::new(8_000_000, 0);
    let memory = room.lend();
    let features: Features<'_, f64> =
        Features::enumerate(domain, memory.features, memory.values).unwrap();
    let hypotheses = Hypotheses::enumerate(&features, memory.pairs);
    let counts = hypotheses.enumeration();
    assert_eq!((counts.left_out, counts.kept), (0, counts.enumerated));
    let write = |id| {
        let mut text = String::new();
        domain
            .write_expression(&mut text, features.nodes(), id)
            .unwrap();
        text
    };
    let sides: Vec<String> = (0..features.len() as u16)
        .map(|i| write(NodeId(i)))
        .collect();
    let side = |id: NodeId| &sides[usize::from(id.0)];
    let mut texts = Vec::new();
    hypotheses.for_each(&features, |l, c, r| {
        texts.push(format!("{} {} {}", side(l), c.symbol(), side(r)));
    });
    assert_eq!(texts.len() as u64, counts.kept);
    texts
}

#[test]
fn enumeration_is_complete_where_nothing_overflows() {
    for (domain, examples) in [
        (
            Domain::parse(REACH).unwrap(),
            [
                "reach < margin",
                "hand.x >= wall.x - margin",
                "dist(hand, wall) < 0.5*margin",
            ],
        ),
        (
            pick::domain(),
            [
                "mu <= 0.5",
                "grasp.y <= zone.top - robot.radius",
                "dist(grasp, holder.centre) > robot.radius + 0.5*holder.width",
            ],
        ),
        (
            arm::domain(),
            [
                "q <= box.theta",
                "angle(elbow, box) > 0.5*box.theta",
                "dist(hand, base) <= reach",
            ],
        ),
    ] {
        let texts = all_hypotheses(&domain);
        let distinct: std::collections::BTreeSet<_> = texts.iter().collect();
        assert_eq!(
            distinct.len(),
            texts.len(),
            "every hypothesis is another one"
        );
        for text in examples {
            assert!(distinct.contains(&text.to_string()), "{text}");
        }
    }
    // Simple ones come first.
    let first = all_hypotheses(&Domain::parse(REACH).unwrap()).swap_remove(0);
    assert_eq!(first, "reach < margin");
}

#[test]
fn room_that_is_not_needed_changes_nothing() {
    let domain = Domain::parse(REACH).unwrap();
    let instances = [1.0, 0.0, 2.0, 1.0, 3.0, 0.5];
    let problem = Problem::new(&domain, &instances, 3).unwrap();
    let run = |hypotheses, observations| {
        let mut room = Algorithm1Room::new(hypotheses, observations);
        let capacity = room.capacity;
        let config = Config {
            seed: 3,
            ..Config::default()
        };
        let mut learner = Algorithm1::new(&domain, config, capacity, room.lend()).unwrap();
        assert_eq!(learner.report().enumeration.left_out, 0);
        while !learner.is_finished() {
            let query = learner.ask(&problem).unwrap();
            let wall = problem.instance(query.instance).unwrap()[0];
            let answer = Outcome::from_feasible(query.theta[0] < wall - 0.25);
            learner.tell(&problem, answer).unwrap();
        }
        (
            learner.observations().to_vec(),
            region_text(&learner, &domain),
        )
    };
    assert_eq!(run(16_384, 128), run(200_000, 5000));
}

#[test]
fn a_full_log_is_an_answer() {
    let domain = pick::domain();
    let instances = pick::instances(1, 1);
    let problem = Problem::new(&domain, &instances, 1).unwrap();
    let mut room = Algorithm1Room::new(4096, 2);
    let mut learner = pick::learner(&domain, 1, &mut room).unwrap();
    for _ in 0..2 {
        learner.ask(&problem).unwrap();
        learner.tell(&problem, Outcome::Feasible).unwrap();
    }
    let before = region_text(&learner, &domain);
    let query = learner.ask(&problem).unwrap();
    let told = learner.tell(&problem, Outcome::FailedStep(1));
    assert_eq!(told, Err(OBSERVATIONS_FULL));
    assert_eq!(region_text(&learner, &domain), before);
    assert_eq!(learner.ask(&problem).unwrap(), query);
}

#[test]
fn misuse_is_refused_and_changes_nothing() {
    let domain = pick::domain();
    let instances = pick::instances(1, 2);
    let problem = Problem::new(&domain, &instances, 2).unwrap();
    let mut room = Algorithm1Room::new(4096, 16);
    let mut learner = pick::learner(&domain, 1, &mut room).unwrap();
    let told = learner.tell(&problem, Outcome::Feasible);
    assert!(matches!(told, Err(Error::OutOfSequence(_))));
    let query = learner.ask(&problem).unwrap();
    assert!(learner.tell(&problem, Outcome::FailedStep(0)).is_err());
    let others = pick::instances(2, 2);
    let other = Problem::new(&domain, &others, 2).unwrap();
    assert!(matches!(learner.ask(&other), Err(Error::Mismatch(_))));
    assert!(matches!(
        learner.tell(&other, Outcome::Feasible),
        Err(Error::Mismatch(_))
    ));
    assert_eq!(learner.ask(&problem).unwrap(), query);
    assert!(Problem::new(&domain, &instances[1..], 2).is_err());
    assert!(Problem::new(&domain, &[f64::NAN; 13], 1).is_err());
    assert!(Problem::new(&domain, &[], 0).is_err());
}

#[test]
fn saved_runs_are_checked() {
    let domain = pick::domain();
    let instances = pick::instances(1, 1);
    let problem = Problem::new(&domain, &instances, 1).unwrap();
    let mut room = Algorithm1Room::new(4096, 16);
    let mut learner = pick::learner(&domain, 1, &mut room).unwrap();
    learner.ask(&problem).unwrap();
    learner.tell(&problem, Outcome::FailedStep(1)).unwrap();
    let mut bytes = vec![0; saved_len(&learner, &problem)];
    save(&learner, &problem, &mut bytes).unwrap();
    assert!(matches!(
        resume(&mut learner, &problem, &bytes),
        Err(Error::OutOfSequence(_))
    ));
    let mut room = Algorithm1Room::new(4096, 16);
    let mut other_seed = pick::learner(&domain, 2, &mut room).unwrap();
    assert!(matches!(
        resume(&mut other_seed, &problem, &bytes),
        Err(Error::Mismatch(_))
    ));
    let mut room = Algorithm1Room::new(4096, 16);
    let mut fresh = pick::learner(&domain, 1, &mut room).unwrap();
    for at in 0..bytes.len() {
        let mut damaged = bytes.clone();
        damaged[at] ^= 0x10;
        assert!(
            matches!(
                resume(&mut fresh, &problem, &damaged),
                Err(Error::Corrupt(_))
            ),
            "{at}"
        );
    }
    assert!(fresh.observations().is_empty());
    resume(&mut fresh, &problem, &bytes).unwrap();
    assert_eq!(fresh.observations().len(), 1);
}

/// The outcome in saved bytes and in C, and nothing else.
#[test]
fn outcomes_have_codes() {
    let all = [Outcome::Feasible, Outcome::Unknown];
    let failed = (1..=u8::MAX).map(Outcome::FailedStep);
    for outcome in all.into_iter().chain(failed) {
        assert_eq!(Outcome::from_code(outcome.code()), Ok(outcome));
    }
    for none in [0, 3, -256, i32::MIN, i32::MAX] {
        let refused = Outcome::from_code(none);
        assert!(matches!(refused, Err(Error::InvalidArgument(_))), "{none}");
    }
}

/// The baseline, too, learns nothing from a trial without an answer, and goes on.
#[test]
fn an_unknown_outcome_prunes_nothing() {
    let domain = pick::domain();
    let instances = pick::instances(1, 1);
    let problem = Problem::new(&domain, &instances, 1).unwrap();
    let mut room = Algorithm1Room::new(4096, 16);
    let mut learner = pick::learner(&domain, 1, &mut room).unwrap();
    learner.ask(&problem).unwrap();
    let before = learner.report();
    learner.tell(&problem, Outcome::Unknown).unwrap();
    let report = learner.report();
    assert_eq!(report.remaining, before.remaining);
    assert_eq!((report.calls, report.unknown, report.feasible), (1, 1, 0));
    assert_eq!(learner.observations()[0].outcome, Outcome::Unknown);
}
