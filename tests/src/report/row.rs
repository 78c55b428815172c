//! A row of the table: what planning took.

use crate::plan::{Grounding, Room, plan_as};
use critreg::plan::{Conclusion, Config, Guide, Planned, Sampler, Simulated, Unguided};
use critreg::skill::{Describe, RegionGuide, RegionSampler, Skills};
use critreg::task::{Environment, State, Task};
use rand_core::Rng;
use std::time::Instant;

/// Sums over planned tasks.
#[derive(Clone, Debug, Default)]
pub(super) struct Row {
    tests: String,
    sampler: String,
    tasks: u32,
    solved: u32,
    samples: u64,
    samples_max: u32,
    plan_length: u64,
    skeletons: u64,
    postponed: u64,
    began_anew: u32,
    seconds: f64,
    /// How often was learned.
    pub(super) learners: u32,
    /// Regions that were found.
    pub(super) regions: u32,
    /// Controllers that were run to learn.
    pub(super) learning_calls: u64,
}

impl Row {
    /// A row of these tests with this sampler.
    pub(super) fn new(tests: &str, sampler: &str) -> Row {
        Row {
            tests: tests.into(),
            sampler: sampler.into(),
            ..Row::default()
        }
    }

    /// Plans a task with the original sampler; see [`Row::plan`].
    ///
    /// # Panics
    /// As [`Row::plan`].
    pub(super) fn plan_originally<E: Environment, R: Rng + Clone>(
        &mut self,
        (environment, task): (&E, &Task),
        numbers: impl Fn() -> R,
        room: &mut Room,
    ) {
        let started = Instant::now();
        let grounding = ground(environment, task);
        let advice = (grounding.simulated(), Unguided);
        self.plan((&grounding, task), advice, numbers, room);
        self.seconds += started.elapsed().as_secs_f64();
    }

    /// Plans a task with skills; see [`Row::plan`].
    ///
    /// # Panics
    /// As [`Row::plan`].
    pub(super) fn plan_with_skills<E: Describe, R: Rng + Clone>(
        &mut self,
        problem: (&E, &Task),
        skills: &Skills<'_>,
        numbers: impl Fn() -> R,
        room: &mut Room,
    ) {
        self.plan_with_skills_as(Config::default(), problem, skills, numbers, room);
    }

    /// As [`Row::plan_with_skills`], with a configuration.
    ///
    /// # Panics
    /// As [`Row::plan`].
    pub(super) fn plan_with_skills_as<E: Describe, R: Rng + Clone>(
        &mut self,
        config: Config,
        (environment, task): (&E, &Task),
        skills: &Skills<'_>,
        numbers: impl Fn() -> R,
        room: &mut Room,
    ) {
        let started = Instant::now();
        let grounding = ground(environment, task);
        let sampler = RegionSampler::new(environment, skills);
        let guide = RegionGuide::new(environment, skills, &task.initial);
        self.plan_as(config, (&grounding, task), (sampler, guide), numbers, room);
        self.seconds += started.elapsed().as_secs_f64();
    }

    /// Plans a task. Lots and samples are the numbers that `numbers` begins, with each
    /// skeleton again.
    ///
    /// # Panics
    /// If planning fails with an error, or with a plan that does not work.
    pub(super) fn plan<'m, E: Environment, R: Rng + Clone>(
        &mut self,
        (grounding, task): (&'m Grounding<'_, E>, &Task),
        advice: (impl Sampler<Simulated<'m, E>>, impl Guide),
        numbers: impl Fn() -> R,
        room: &'m mut Room,
    ) {
        self.plan_as(Config::default(), (grounding, task), advice, numbers, room);
    }

    fn plan_as<'m, E: Environment, R: Rng + Clone>(
        &mut self,
        config: Config,
        (grounding, task): (&'m Grounding<'_, E>, &Task),
        advice: (impl Sampler<Simulated<'m, E>>, impl Guide),
        numbers: impl Fn() -> R,
        room: &'m mut Room,
    ) {
        let planned = plan_as(config, grounding, &task.initial, advice, numbers, room);
        let planned = planned.expect("the environment does not fail");
        self.add(grounding.environment, task, &planned);
    }

    fn add<E: Environment>(&mut self, environment: &E, task: &Task, planned: &Planned<'_, State>) {
        self.tasks += 1;
        let metrics = &planned.metrics;
        self.began_anew += u32::from(metrics.advised.is_some());
        if planned.conclusion == Conclusion::Solved {
            let end = planned
                .steps
                .last()
                .map_or(&task.initial, |step| &step.state);
            assert!(task.is_solved(environment, end), "the plan does not work");
            self.solved += 1;
            self.samples += u64::from(metrics.samples);
            self.samples_max = self.samples_max.max(metrics.samples);
            self.plan_length += u64::from(metrics.plan_length);
            self.skeletons += u64::from(metrics.skeletons);
            self.postponed += u64::from(metrics.postponed + metrics.pruned);
        }
    }

    fn mean(&self, sum: u64) -> f64 {
        sum as f64 / f64::from(self.solved.max(1))
    }

    /// Prints a `key: value` line each.
    pub(super) fn print(&self) {
        println!("tests: {}", self.tests);
        println!("sampler: {}", self.sampler);
        println!("solved: {}/{}", self.solved, self.tasks);
        println!("samples_mean: {:.4}", self.mean(self.samples));
        println!("samples_max: {}", self.samples_max);
        println!("plan_length_mean: {:.4}", self.mean(self.plan_length));
        let per_step = self.samples as f64 / self.plan_length.max(1) as f64;
        println!("samples_per_step: {per_step:.4}");
        println!("skeletons_mean: {:.4}", self.mean(self.skeletons));
        println!("pruned_mean: {:.4}", self.mean(self.postponed));
        println!("began_anew: {}", self.began_anew);
        println!(
            "time_us_mean: {:.1}",
            1e6 * self.seconds / f64::from(self.tasks.max(1))
        );
        if self.learners > 0 {
            let each = |sum: f64| sum / f64::from(self.learners);
            println!("learners: {}", self.learners);
            println!("regions_mean: {:.2}", each(f64::from(self.regions)));
            println!(
                "learning_calls_mean: {:.1}",
                each(self.learning_calls as f64)
            );
        }
    }

    /// Prints after how many planned tasks learning has cost less than it saves.
    pub(super) fn print_payback(&self, original: &Row) {
        let saved = original.mean(original.samples) - self.mean(self.samples);
        let calls = self.learning_calls as f64 / f64::from(self.learners.max(1));
        println!("paid_back_after_tasks: {:.0}", (calls / saved).ceil());
    }
}

/// A task with its atoms and operators.
///
/// # Panics
/// If they find no room.
pub(super) fn ground<'e, E: Environment>(environment: &'e E, task: &Task) -> Grounding<'e, E> {
    Grounding::new(environment, task).expect("room for the task")
}
