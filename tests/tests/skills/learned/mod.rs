//! Learned skills: regions, planning with them, and why something cannot work.

mod completeness;
mod guide;
mod learning;
mod why;

use critreg::env::stick_button::StickButton;
use critreg::plan::{Draw, Drawn, Guide, Planned, Sampler, Simulated};
use critreg::random::{Generator, generator};
use critreg::region::Region;
use critreg::skill::{RegionGuide, RegionSampler, Skills, Training};
use critreg::task::{State, Task};
use critreg_tests::pick::ENVIRONMENT;
use critreg_tests::plan::skills::{TrainingRoom, learn};
use critreg_tests::plan::{self, Grounding, Room};

/// The regions that are learned in every detail.
const TRUE_REGIONS: [&str; 4] = [
    "grasp.y <= 2.9 and dist_y(grasp, holder.centre) >= 0.25",
    "button.y <= 2.9",
    "release.y >= 0.1 and release.y <= 2.9",
    "dist_y(grasp, stick.tip) - button.y <= -0.1 and dist_y(grasp, stick.tip) - button.y >= -2.9",
];

/// Skills with these regions; an empty text is no region.
fn know(skills: &mut Skills<'_>, regions: &[&str]) {
    for (index, text) in regions.iter().enumerate() {
        let skill = skills.get_mut(index).unwrap();
        let region = (!text.is_empty()).then(|| Region::parse(skill.domain(), text).unwrap());
        skill.set_region(region);
    }
}

/// Runs every controller once, so that it is seen what they change.
fn observe(skills: &mut Skills<'_>) {
    let training = Training {
        chained: 20,
        budget: 0,
        way: 10_000,
        tasks: 10,
        situations: 4,
        states: 10,
        learner: critreg::learn::version_space::Config {
            calls: 20,
            certifying: 2,
            ..Default::default()
        },
    };
    learn(skills, 1, &mut TrainingRoom::new(training)).unwrap();
}

/// Plans with numbers that begin again with each skeleton.
fn plan<'m, S: Sampler<Simulated<'m, StickButton>>, G: Guide>(
    task: &Task,
    grounding: &'m Grounding<'_, StickButton>,
    advice: (S, G),
    room: &'m mut Room,
) -> Planned<'m, State> {
    let numbers = || generator(7);
    plan::plan(grounding, &task.initial, advice, numbers, room).unwrap()
}

/// The region sampler and the region guide of these skills, for a task.
fn guided<'a>(
    skills: &'a Skills<'_>,
    task: &'a Task,
) -> (RegionSampler<'a, StickButton>, RegionGuide<'a, StickButton>) {
    let guide = RegionGuide::new(&ENVIRONMENT, skills, &task.initial);
    (RegionSampler::new(&ENVIRONMENT, skills), guide)
}

/// What the sampler of the environment draws.
fn draw_from(
    sampler: &mut RegionSampler<'_, StickButton>,
    draw: &Draw<'_, State>,
    rng: &mut Generator,
) -> Drawn {
    Sampler::<Simulated<'_, StickButton>>::sample(sampler, draw, rng).unwrap()
}

const NODES: usize = 10_000;
