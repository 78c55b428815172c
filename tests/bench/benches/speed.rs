//! How long the inner loops take: `cargo bench -p critreg-bench --bench speed`.

use criterion::{Criterion, criterion_group, criterion_main};
use critreg::domain::{PointSet, Scene};
use critreg::grammar::{Features, Hypotheses};
use critreg::learn::{Learner, Problem};
use critreg::random::generator;
use critreg::region::Region;
use critreg::task::Environment;
use critreg_tests::pick;
use critreg_tests::room::Algorithm1Room;
use std::hint::black_box;

const TRUE_REGION: &str = "grasp.y <= 2.9 and dist(grasp, holder.centre) >= 0.25";

fn simulator(c: &mut Criterion) {
    let start = pick::ENVIRONMENT.task(1..=1, &mut generator(1)).unwrap();
    c.bench_function("one simulate step", |b| {
        let mut state = start.initial.clone();
        let mut dx = 0.5_f32;
        b.iter(|| {
            dx = -dx;
            let action = black_box([dx, 0.0, 0.0, -1.0]);
            pick::ENVIRONMENT.simulate(&mut state, action)
        });
    });
    let instance = start.initial.values();
    c.bench_function("one PickStick rollout", |b| {
        b.iter(|| pick::ENVIRONMENT.try_pick(black_box(instance), &[0.1]));
    });
}

fn validation(c: &mut Criterion) {
    let domain = pick::domain();
    let instances = pick::instances(1, 1);
    let mut room = Algorithm1Room::new(20_000, 0);
    let capacity = room.capacity;
    let memory = room.lend();
    let values = &mut memory.values[..capacity.features()];
    let mut features = Features::enumerate(&domain, memory.features, values).unwrap();
    let scene = Scene::new(&domain, &instances, PointSet::all(&domain)).unwrap();
    c.bench_function("features of one sample", |b| {
        b.iter(|| features.evaluate(&scene, black_box(&pick::theta(0.5))));
    });
    features.evaluate(&scene, &pick::theta(0.5));
    let mut hypotheses = Hypotheses::enumerate(&features, memory.pairs);
    println!(
        "{:?}, {} features",
        hypotheses.enumeration(),
        features.len()
    );
    c.bench_function("validation of 20 000 hypotheses", |b| {
        b.iter(|| hypotheses.update(black_box(&features), black_box(true)));
    });
    c.bench_function("features and validation", |b| {
        b.iter(|| {
            features.evaluate(&scene, black_box(&pick::theta(0.5)));
            hypotheses.update(&features, black_box(true));
        });
    });
}

fn sampling(c: &mut Criterion) {
    let domain = pick::domain();
    let region = Region::parse(&domain, TRUE_REGION).unwrap();
    let instance = pick::instances(1, 1);
    let mut rng = generator(1);
    c.bench_function("one sample_region", |b| {
        b.iter(|| region.sample::<f64>(&domain, black_box(&instance), &mut rng));
    });
    let grounded = region.ground::<f64>(&domain, &instance).unwrap();
    c.bench_function("one sample of a grounded region", |b| {
        b.iter(|| grounded.sample(&mut rng));
    });
    let thetas: Vec<_> = (0..4096).map(|i| f64::from(i) / 4096.0).collect();
    let mut inside = vec![0; thetas.len()];
    c.bench_function("4096 memberships in a grounded region", |b| {
        b.iter(|| grounded.contains_many(black_box(&thetas), &mut inside));
    });
}

fn learning(c: &mut Criterion) {
    let domain = pick::domain();
    let instances = pick::instances(1, 4);
    let problem = Problem::new(&domain, &instances, 4).unwrap();
    let mut room = Algorithm1Room::new(20_000, 256);
    c.bench_function("whole learn_region, algorithm1", |b| {
        b.iter(|| {
            let mut learner = pick::learner(&domain, 7, &mut room).unwrap();
            pick::run(&mut learner, &problem).unwrap();
            learner.observations().len()
        });
    });
}

criterion_group!(benches, simulator, validation, sampling, learning);
criterion_main!(benches);
