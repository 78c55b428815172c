//! How long a learner takes between two answers: a robot that asks as it goes cannot wait.

use super::{Scenario, angles, chain, groups, interval, noise, pick, state, synthetic, union};
use crate::room::VersionSpaceRoom;
use critreg::domain::Domain;
use critreg::learn::version_space::{Capacity, Config};
use critreg::learn::{Learner, Outcome, Problem, Query};
use critreg::random::{generator, uniform};
use std::time::{Duration, Instant};

/// Objects of the domain whose forms fill any room.
const BOXES: usize = 16;
const PARAMETERS: usize = 6;
const FORMS: usize = 16_384;
const SAMPLES: usize = 500;
const INSTANCES: usize = 16;
/// How often each run is repeated: the machine may do something else meanwhile, so that the least
/// time of each call counts.
const REPEATED: usize = 5;

/// What comes of a sample.
type Answer<'a> = dyn Fn(&Problem<'_>, &Query) -> Outcome + 'a;

/// Prints the median, the 99th percentile and the most of ask and tell together, in each
/// scenario, and where many forms have many parameters: with a truth, and with answers by
/// chance. Only scenarios with this part of a name.
pub fn print(seeds: usize, first: u64, only: &str) {
    println!("report: latency\nseeds: {seeds}");
    let wanted = |name: &str| name.contains(only);
    let known = [
        pick(),
        chain(),
        angles(),
        noise(),
        interval(),
        union(),
        state(),
        groups(),
        synthetic(0),
    ];
    for scenario in known.iter().filter(|own| wanted(own.name)) {
        let all = (0..seeds as u64).flat_map(|seed| learn_scenario(scenario, first + seed));
        print_times(scenario.name, all.collect());
    }
    let domain = crowded();
    for (name, chance) in [("crowd", false), ("chance", true)] {
        if !wanted(name) {
            continue;
        }
        let all = (0..seeds as u64).flat_map(|seed| learn_crowd(&domain, first + seed, chance));
        print_times(name, all.collect());
    }
}

fn print_times(name: &str, mut times: Vec<Duration>) {
    times.sort();
    let at = |share: f64| {
        let place = (share * times.len() as f64) as usize;
        let time = times.get(place.min(times.len() - 1)).expect("some calls");
        1e3 * time.as_secs_f64()
    };
    println!("\nscenario: {name}\ncalls: {}", times.len());
    println!("median_ms: {:.3}", at(0.5));
    println!("p99_ms: {:.3}", at(0.99));
    println!("worst_ms: {:.3}", at(1.0));
    let all: Duration = times.iter().sum();
    println!("sum_ms: {:.1}", 1e3 * all.as_secs_f64());
}

fn learn_scenario(scenario: &Scenario, seed: u64) -> Vec<Duration> {
    let instances = scenario.draw(seed, scenario.instances);
    let problem = Problem::new(&scenario.domain, &instances, scenario.instances).expect("valid");
    let parameters = scenario.domain.parameters().len();
    learn(
        &problem,
        scenario.capacity(),
        scenario.config(seed),
        &|problem, query| {
            let instance = problem.instance(query.instance).expect("an instance");
            scenario.judge(instance, &query.theta[..parameters])
        },
    )
}

/// A domain with so many objects and parameters that its forms fill the room.
fn crowded() -> Domain<'static> {
    let mut text = String::new();
    for index in 0..BOXES {
        text += &format!("object box{index} {{ x: length, y: length }}\n");
    }
    text += "constant margin = 0.25: length\n";
    for index in 0..PARAMETERS {
        text += &format!("parameter p{index} in [0, 4]: length\n");
    }
    text += "point hand = world + (p0, p1)\npoint other = world + (p2, p3)\n";
    Domain::parse(text.leak()).expect("the text is valid")
}

fn learn_crowd(domain: &Domain<'_>, seed: u64, chance: bool) -> Vec<Duration> {
    let mut rng = generator(seed);
    let numbers = 2 * BOXES * INSTANCES;
    let instances: Vec<f64> = (0..numbers).map(|_| 4.0 * uniform(&mut rng)).collect();
    let problem = Problem::new(domain, &instances, INSTANCES).expect("valid");
    let capacity = Capacity {
        instances: INSTANCES,
        ..Capacity::new(FORMS, SAMPLES)
    };
    let config = Config {
        seed,
        calls: SAMPLES as u32,
        ..Config::default()
    };
    learn(&problem, capacity, config, &|problem, query| {
        if chance {
            return Outcome::from_feasible(query.theta[5].to_bits().count_ones() % 2 == 0);
        }
        let instance = problem.instance(query.instance).expect("an instance");
        let [p0, p1, p2, ..] = query.theta;
        let clear = (p0 - instance[0]).hypot(p1 - instance[1]) >= 0.75;
        Outcome::from_feasible(clear && p2 <= instance[2] + 0.25)
    })
}

/// Learns, and returns how long each question took together with taking in its answer: the
/// least of several runs, which all ask the same.
fn learn(
    problem: &Problem<'_>,
    capacity: Capacity,
    config: Config,
    answer: &Answer<'_>,
) -> Vec<Duration> {
    let mut least = learn_once(problem, capacity, config, answer);
    for _ in 1..REPEATED {
        let again = learn_once(problem, capacity, config, answer);
        assert_eq!(least.len(), again.len(), "equal seeds ask the same");
        for (least, again) in least.iter_mut().zip(again) {
            *least = again.min(*least);
        }
    }
    least
}

fn learn_once(
    problem: &Problem<'_>,
    capacity: Capacity,
    config: Config,
    answer: &Answer<'_>,
) -> Vec<Duration> {
    let mut room = VersionSpaceRoom::<f64>::new(capacity);
    let mut learner = room.learner(problem.domain(), config).expect("enough room");
    let mut times = Vec::new();
    // The first question lays the forms out.
    let mut laid_out = false;
    while !learner.is_finished() {
        let started = Instant::now();
        // Without parameters it may have asked about all instances.
        let Ok(query) = learner.ask(problem) else {
            break;
        };
        let asked = started.elapsed();
        let outcome = answer(problem, &query);
        let started = Instant::now();
        learner.tell(problem, outcome).expect("room");
        if std::mem::replace(&mut laid_out, true) {
            times.push(asked + started.elapsed());
        }
    }
    times
}
