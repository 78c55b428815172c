//! How many samples the planner draws for each task of the thesis's table (6.1), with the
//! original samplers and with learned regions.

use crate::pick::ENVIRONMENT;
use crate::plan::record;
use crate::plan::skills::{SkillRoom, TrainingRoom, learn};
use crate::plan::{Grounding, Room, plan};
use critreg::Error;
use critreg::plan::{Conclusion, Planned, Unguided};
use critreg::skill::{RegionGuide, RegionSampler, Training};
use critreg::task::State;
use rand_pcg::Pcg64;

/// The seed that the regions are learned with.
const SEED: u64 = 1;

/// What planning cost with one kind of sampler.
pub struct Series {
    /// What it is called.
    pub name: &'static str,
    /// The class of its line in the picture; that of its marks ends with `-mark`.
    pub class: &'static str,
    /// Samples of each task, in ascending order.
    pub samples: Vec<u32>,
    /// Steps of all plans, the fewest samples that can do.
    pub steps: u32,
    /// How many of the tasks were solved.
    pub solved: usize,
}

impl Series {
    fn new(name: &'static str, class: &'static str, planned: &[Cost]) -> Series {
        let mut samples: Vec<u32> = planned.iter().map(|cost| cost.samples).collect();
        samples.sort_unstable();
        Series {
            name,
            class,
            samples,
            steps: planned.iter().filter_map(|cost| cost.steps).sum(),
            solved: planned.iter().filter(|cost| cost.steps.is_some()).count(),
        }
    }

    /// What there is to say about it.
    pub fn words(&self) -> String {
        let (sum, count): (u32, usize) = (self.samples.iter().sum(), self.samples.len());
        format!(
            "{}: {} of {count} solved; {:.2} samples for {:.2} steps on average, {} at most",
            self.name,
            self.solved,
            f64::from(sum) / count as f64,
            f64::from(self.steps) / self.solved as f64,
            self.samples.last().copied().unwrap_or_default()
        )
    }
}

/// What is measured.
pub struct Measured {
    /// The original samplers.
    pub original: Series,
    /// The learned regions, as sampler and guide.
    pub learned: Series,
    /// How many controllers were run to learn them.
    pub learning: u32,
}

/// Plans all tasks with the original samplers, then with learned regions.
///
/// # Panics
/// If the memory does not suffice to learn or to plan.
pub fn measure() -> Measured {
    let generators: Vec<Pcg64> = record::streams().map(|s| s.generator).collect();
    let mut skill_room = SkillRoom::default();
    let mut skills = skill_room.lend(&ENVIRONMENT).expect("valid descriptions");
    let mut training_room = TrainingRoom::new(Training::default());
    let costs = learn(&mut skills, SEED, &mut training_room).expect("enough room");
    let mut room = Room::new(10_000);
    let (mut original, mut learned) = (vec![], vec![]);
    for run in record::runs_of_the_thesis() {
        let grounding = Grounding::new(&ENVIRONMENT, &run.task).expect("few buttons");
        let initial = &run.task.initial;
        let numbers = || generators[run.planner_seed as usize].clone();
        let unguided = (grounding.simulated(), Unguided);
        let planned = plan(&grounding, initial, unguided, numbers, &mut room);
        original.push(Cost::of(planned));
        let sampler = RegionSampler::new(&ENVIRONMENT, &skills);
        let guide = RegionGuide::new(&ENVIRONMENT, &skills, initial);
        let planned = plan(&grounding, initial, (sampler, guide), numbers, &mut room);
        learned.push(Cost::of(planned));
    }
    Measured {
        original: Series::new("original samplers", "original", &original),
        learned: Series::new("learned regions", "learned", &learned),
        learning: costs.iter().map(|cost| cost.runs).sum(),
    }
}

/// What planning a task cost.
struct Cost {
    samples: u32,
    /// Steps of the plan, if there is one.
    steps: Option<u32>,
}

impl Cost {
    fn of(planned: Result<Planned<'_, State>, Error>) -> Cost {
        let planned = planned.expect("samplers that do not fail");
        let solved = planned.conclusion == Conclusion::Solved;
        Cost {
            samples: planned.metrics.samples,
            steps: solved.then_some(planned.metrics.plan_length),
        }
    }
}
