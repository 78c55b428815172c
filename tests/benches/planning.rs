//! How long planning takes: `cargo bench --bench planning`.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use critreg::domain::{State, Task};
use critreg::plan::{Conclusion, Config, Metrics, Planned, Planner, Search, Unguided};
use critreg::random::generator;
use critreg_tests::pick::ENVIRONMENT;
use critreg_tests::plan::ideal::Ideal;
use critreg_tests::plan::{Grounding, Room};
use std::ops::RangeInclusive;

const TASKS: usize = 50;
const NODES: usize = 4096;

fn tasks(buttons: RangeInclusive<usize>) -> Vec<Task> {
    let mut rng = generator(1);
    let task = |_| ENVIRONMENT.task(buttons.clone(), &mut rng).unwrap();
    (0..TASKS).map(task).collect()
}

/// Searches 100 skeletons, unguided; returns how many nodes were created.
fn skeletons(grounding: &Grounding, room: &mut Room) -> u32 {
    let memory = room.lend();
    let mut metrics = Metrics::new(memory.failures, memory.reasons);
    let config = Config::default();
    let (task, lots) = (grounding.task(), generator(1));
    let mut search = Search::new(task, &config, lots, memory.search, &mut metrics).unwrap();
    for _ in 0..100 {
        search.next_skeleton(&mut Unguided, &mut metrics).unwrap();
    }
    metrics.nodes_created
}

fn search(c: &mut Criterion) {
    let mut room = Room::new(NODES);
    let groundings: Vec<_> = tasks(3..=4)
        .iter()
        .map(|t| Grounding::new(t).unwrap())
        .collect();
    let nodes: u32 = groundings.iter().map(|g| skeletons(g, &mut room)).sum();
    let mut group = c.benchmark_group("search");
    group.throughput(Throughput::Elements(nodes.into()));
    group.bench_function("nodes of the search, LM-cut, 3 or 4 buttons", |b| {
        b.iter(|| -> u32 { groundings.iter().map(|g| skeletons(g, &mut room)).sum() });
    });
}

/// Plans a task from scratch with what an ideal learner knows.
fn plan<'m>(task: &Task, grounding: &'m Grounding, room: &'m mut Room) -> Planned<'m, State> {
    let mut ideal = Ideal {
        initial: &task.initial,
    };
    let mut planner = Planner {
        world: &mut grounding.simulated(),
        sampler: &mut ideal.clone(),
        guide: &mut ideal,
        config: Config::default(),
    };
    let samples = || generator(2);
    let planned = planner.plan(
        grounding.task(),
        &task.initial,
        generator(1),
        samples,
        room.lend(),
    );
    planned.unwrap()
}

fn planning(c: &mut Criterion) {
    let mut room = Room::new(NODES);
    for buttons in [1..=1, 3..=4] {
        let tasks = tasks(buttons.clone());
        let (mut samples, mut length, mut nodes) = (0, 0, 0);
        for task in &tasks {
            let grounding = Grounding::new(task).unwrap();
            let planned = plan(task, &grounding, &mut room);
            assert_eq!(planned.conclusion, Conclusion::Solved);
            samples += planned.metrics.samples;
            length += planned.metrics.plan_length;
            nodes += planned.metrics.nodes_created;
        }
        println!("{buttons:?} buttons: {samples} samples, {length} steps, {nodes} nodes");
        let mut group = c.benchmark_group("planning");
        group.throughput(Throughput::Elements(TASKS as u64));
        group.bench_function(
            format!("50 tasks, {buttons:?} buttons, ideal sampler"),
            |b| {
                b.iter(|| {
                    let plan = |task| {
                        let grounding = Grounding::new(task).unwrap();
                        plan(task, &grounding, &mut room).metrics.samples
                    };
                    tasks.iter().map(plan).sum::<u32>()
                });
            },
        );
    }
}

criterion_group!(benches, search, planning);
criterion_main!(benches);
