//! How long the version-space learner takes, and how that grows:
//! `cargo bench -p critreg-bench --bench learner`.

use criterion::{BatchSize, BenchmarkId, Criterion, criterion_group, criterion_main};
use critreg::Error;
use critreg::domain::Domain;
use critreg::learn::version_space::{Capacity, Config};
use critreg::learn::{Learner, Outcome, Problem, Query, VersionSpace, learn_region};
use critreg::random::{generator, uniform};
use critreg_tests::report;
use critreg_tests::room::VersionSpaceRoom;

const BOXES: usize = 16;

/// A domain with so many objects that its forms fill any room, and some parameters.
fn crowded(parameters: usize) -> Domain<'static> {
    let mut text = String::new();
    for index in 0..BOXES {
        text += &format!("object box{index} {{ x: length, y: length }}\n");
    }
    text += "constant margin = 0.25: length\n";
    for index in 0..parameters {
        text += &format!("parameter p{index} in [0, 4]: length\n");
    }
    text += "point hand = world + (p0, 0.5)\n";
    Domain::parse(text.leak()).expect("the text is valid")
}

fn crowd(seed: u64, count: usize) -> Vec<f64> {
    let mut rng = generator(seed);
    (0..2 * BOXES * count)
        .map(|_| 4.0 * uniform(&mut rng))
        .collect()
}

fn room(forms: usize, observations: usize, instances: usize) -> VersionSpaceRoom {
    VersionSpaceRoom::new(Capacity {
        forms,
        tracked: usize::MAX,
        sums: usize::MAX,
        questions: 16,
        observations,
        instances,
        steps: 1,
    })
}

fn is_left_of_box(problem: &Problem<'_>, query: &Query) -> Outcome {
    let instance = problem.instance(query.instance).expect("an instance");
    Outcome::from_feasible(query.theta[0] <= instance[0] - 0.25)
}

/// One `tell` after so many others.
fn tell(c: &mut Criterion) {
    let mut group = c.benchmark_group("tell");
    let cases = [
        (2500, 50, 1),
        (5000, 50, 1),
        (10_000, 50, 1),
        (10_000, 25, 1),
        (10_000, 100, 1),
        (10_000, 50, 6),
    ];
    for (forms, told, parameters) in cases {
        let domain = crowded(parameters);
        let instances = crowd(1, 4);
        let problem = Problem::new(&domain, &instances, 4).expect("valid");
        let name = format!("{forms} forms, {told} observations, {parameters} parameters");
        group.bench_function(BenchmarkId::from_parameter(name), |b| {
            b.iter_custom(|rounds| {
                let mut time = std::time::Duration::ZERO;
                for round in 0..rounds {
                    let mut room = room(forms, told + 1, 4);
                    let config = Config {
                        seed: round,
                        calls: told as u32 + 2,
                        certifying: 0,
                        ..Config::default()
                    };
                    let capacity = room.capacity;
                    let mut learner =
                        VersionSpace::<f64>::new(&domain, config, capacity, room.lend())
                            .expect("room");
                    learner.ask(&problem).expect("not finished");
                    assert_eq!(learner.report().forms, forms, "the room is full");
                    for _ in 0..told {
                        let query = learner.ask(&problem).expect("not finished");
                        let answer = is_left_of_box(&problem, &query);
                        learner.tell(&problem, answer).expect("room");
                    }
                    let query = learner.ask(&problem).expect("not finished");
                    let answer = is_left_of_box(&problem, &query);
                    let start = std::time::Instant::now();
                    learner.tell(&problem, answer).expect("room");
                    time += start.elapsed();
                }
                time
            });
        });
    }
    group.finish();
}

fn whole(c: &mut Criterion) {
    let scenario = report::pick();
    let instances = scenario.draw(1, 4);
    let problem = Problem::new(&scenario.domain, &instances, 4).expect("valid");
    for forms in [1000, 10_000] {
        let mut room = room(forms, 100, 4);
        let mut seed = 0;
        c.bench_function(
            &format!("whole learn_region of the pick, {forms} forms"),
            |b| {
                b.iter_batched(
                    || seed += 1,
                    |()| {
                        let config = Config {
                            seed: 7,
                            ..Config::default()
                        };
                        let capacity = room.capacity;
                        let mut learner = VersionSpace::<f64>::new(
                            &scenario.domain,
                            config,
                            capacity,
                            room.lend(),
                        )
                        .expect("room");
                        learn_region(&mut learner, &problem, |_, query| {
                            let instance = problem.instance(query.instance)?;
                            Ok::<_, Error>(scenario.judge(instance, &query.theta[..1]))
                        })
                        .is_ok()
                    },
                    BatchSize::SmallInput,
                );
            },
        );
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(20);
    targets = tell, whole
}
criterion_main!(benches);
