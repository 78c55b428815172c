//! How long planning takes: `cargo bench -p critreg-bench --bench planning`.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use critreg::env::stick_button::StickButton;
use critreg::plan::{
    Conclusion, Config, Guide, Metrics, Planner, Sampler, Search, Simulated, Unguided,
};
use critreg::random::generator;
use critreg::skill::{RegionGuide, RegionSampler, Training};
use critreg::task::Task;
use critreg_tests::pick::ENVIRONMENT;
use critreg_tests::plan::ideal::Ideal;
use critreg_tests::plan::skills::{SkillRoom, TrainingRoom, learn};
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
fn skeletons(grounding: &Grounding<'_, StickButton>, room: &mut Room) -> u32 {
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
        .map(|t| Grounding::new(&ENVIRONMENT, t).unwrap())
        .collect();
    let nodes: u32 = groundings.iter().map(|g| skeletons(g, &mut room)).sum();
    let mut group = c.benchmark_group("search");
    group.throughput(Throughput::Elements(nodes.into()));
    group.bench_function("nodes of the search, LM-cut, 3 or 4 buttons", |b| {
        b.iter(|| -> u32 { groundings.iter().map(|g| skeletons(g, &mut room)).sum() });
    });
}

/// Plans a task from scratch, and returns samples and steps.
fn plan<S, G: Guide>(
    task: &Task,
    grounding: &Grounding<'_, StickButton>,
    (mut sampler, mut guide): (S, G),
    room: &mut Room,
) -> [u32; 2]
where
    S: for<'g> Sampler<Simulated<'g, StickButton>>,
{
    let mut planner = Planner {
        world: &mut grounding.simulated(),
        sampler: &mut sampler,
        guide: &mut guide,
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
    let planned = planned.unwrap();
    assert_eq!(planned.conclusion, Conclusion::Solved);
    [planned.metrics.samples, planned.metrics.plan_length]
}

/// Plans all tasks with hooks for each of them.
fn bench<'t, S, G: Guide>(
    c: &mut Criterion,
    (name, tasks): (&str, &'t [Task]),
    hooks: impl Fn(&'t Task) -> (S, G),
) where
    S: for<'g> Sampler<Simulated<'g, StickButton>>,
{
    let mut room = Room::new(NODES);
    let mut all = || {
        tasks.iter().fold([0, 0], |[samples, steps], task| {
            let grounding = Grounding::new(&ENVIRONMENT, task).unwrap();
            let [more, longer] = plan(task, &grounding, hooks(task), &mut room);
            [samples + more, steps + longer]
        })
    };
    let [samples, steps] = all();
    println!("{name}: {samples} samples, {steps} steps");
    let mut group = c.benchmark_group("planning");
    group.throughput(Throughput::Elements(TASKS as u64));
    group.bench_function(name, |b| b.iter(&mut all));
}

fn planning(c: &mut Criterion) {
    let mut skill_room = SkillRoom::default();
    let mut skills = skill_room.lend(&ENVIRONMENT).unwrap();
    let mut training_room = TrainingRoom::new(Training::default());
    learn(&mut skills, 1, &mut training_room).unwrap();
    for buttons in [1..=1, 3..=4] {
        let tasks = tasks(buttons.clone());
        let name = format!("50 tasks, {buttons:?} buttons, ideal sampler");
        bench(c, (&name, &tasks), |task| {
            let ideal = Ideal {
                initial: &task.initial,
            };
            (ideal, ideal)
        });
        let name = format!("50 tasks, {buttons:?} buttons, learned regions");
        bench(c, (&name, &tasks), |task| {
            let guide = RegionGuide::new(&ENVIRONMENT, &skills, &task.initial);
            (RegionSampler::new(&ENVIRONMENT, &skills), guide)
        });
    }
}

criterion_group!(benches, search, planning);
criterion_main!(benches);
