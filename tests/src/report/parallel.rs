//! Several workers at once: what the answers cost that come late.

use super::judge::Truth;
use super::runs::{Course, for_seeds, with_learner, with_seed};
use super::scenario::{Scenario, chain, pick};
use super::statistics::{Run, Statistics};
use super::synthetic;
use critreg::learn::{Learner, Problem, Question, VersionSpace};
use critreg::random::{generator, uniform_in};

/// Questions that are open at once.
const WORKERS: [usize; 3] = [1, 4, 16];

/// A run and how long it took, in trials of mean length.
struct Timed {
    run: Run,
    time: f64,
}

/// Prints for some scenarios and numbers of workers, each of random speed, how many answers it
/// takes until the region is exact, and how much time the whole run.
pub fn print(seeds: usize, first: u64) {
    for scenario in [pick(), chain(), synthetic(0)] {
        for workers in WORKERS {
            let all = for_seeds(seeds, 100, |index| {
                let seed = first + index as u64;
                with_seed(&scenario, seed, |own| run(own, seed, workers))
            });
            println!("report: parallel {}", scenario.name);
            println!("workers: {workers}");
            let time = all.iter().map(|own| own.time).sum::<f64>() / seeds as f64;
            println!("trials_in_a_row_mean: {time:.1}");
            let runs: Vec<Run> = all.into_iter().map(|own| own.run).collect();
            let statistics = Statistics {
                learner: "version_space",
                instances: scenario.instances,
                calls: scenario.calls,
                runs: &runs,
            };
            statistics.print();
        }
    }
}

/// Whenever a worker is idle it gets a question; a trial takes from half to one and a half
/// times its mean.
fn run(scenario: &Scenario, seed: u64, workers: usize) -> Timed {
    let config = scenario.config(seed);
    with_learner(scenario, seed, config, |learner, problem| {
        work(learner, problem, (scenario, seed), workers)
    })
}

fn work(
    learner: &mut VersionSpace<'_, f64>,
    problem: &Problem<'_>,
    (scenario, seed): (&Scenario, u64),
    workers: usize,
) -> Timed {
    let (truth, domain) = (Truth::new(scenario, seed), problem.domain());
    let used = domain.parameters().len();
    let mut speed = generator(seed ^ 0x5BEE_D000);
    let (mut course, mut now, mut calls) = (Course::default(), 0.0, 0);
    let mut busy: Vec<(f64, Question)> = Vec::new();
    while !learner.is_finished() {
        while busy.len() < workers
            && let Some(question) = learner.ask_more(problem).expect("a question")
        {
            busy.push((now + uniform_in(&mut speed, 0.5, 1.5), question));
        }
        let done = (0..busy.len()).min_by(|a, b| busy[*a].0.total_cmp(&busy[*b].0));
        let Some(done) = done else { break };
        let (at, question) = busy.swap_remove(done);
        now = at;
        let instance = problem.instance(question.query.instance);
        let instance = instance.expect("an instance");
        let outcome = scenario.judge(instance, &question.query.theta[..used]);
        learner
            .tell_id(problem, question.id, outcome)
            .expect("it is open");
        calls += 1;
        course.note(calls, learner);
    }
    Timed {
        run: course.judged(domain, &truth),
        time: now,
    }
}
