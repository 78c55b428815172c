//! Planning with the core: a skill is learned, and planned with.

use critreg::Error;
use critreg::env::blocks::Blocks;
use critreg::env::cluttered_table::{ClutteredTable, ClutteredTablePlace};
use critreg::env::coffee::Coffee;
use critreg::env::cover::{Cover, CoverRegrasp, RegionalBumpyCover};
use critreg::env::shelf::Shelf;
use critreg::env::stick_button::StickButton;
use critreg::env::stick_button_move::StickButtonMove;
use critreg::learn::{Capacity, Memory};
use critreg::plan::{self, Conclusion, Config, GroundTask, Planner, ReasonId};
use critreg::random::generator;
use critreg::skill::{
    Describe, Oracle, RegionGuide, RegionSampler, SkillRoom, Trainer, Training, TrainingRoom,
};
use critreg::task::{State, Task};
use critreg::text::TextBuffer;

/// What the caller lends and asks for. Nothing of it is known when compiling.
pub struct Room<E> {
    environment: E,
    tasks: &'static [Task],
    skill: usize,
    training: Training,
    config: Config,
    seed: u64,
    skills: SkillRoom<8, 8>,
    situations: TrainingRoom<8, 32>,
    planner: plan::Room<State, 32, 256, 8>,
    learner: (Memory<'static, f64>, Capacity),
    text: [u8; 512],
}

/// Whether there is a plan, or a reason why there is none, in every built-in environment.
macro_rules! plan_in {
    ($($name:ident $environment:ty;)*) => {$(
        #[unsafe(no_mangle)]
        pub fn $name(room: Room<$environment>) -> bool {
            plan(room).unwrap_or(false)
        }
    )*};
}

plan_in! {
    no_std_plan_blocks Blocks;
    no_std_plan_cluttered_table ClutteredTable;
    no_std_plan_cluttered_table_place ClutteredTablePlace;
    no_std_plan_coffee Coffee;
    no_std_plan_cover Cover;
    no_std_plan_cover_regrasp CoverRegrasp;
    no_std_plan_cover_regional_bumpy RegionalBumpyCover;
    no_std_plan_shelf Shelf;
    no_std_plan_stick_button StickButton;
    no_std_plan_stick_button_move StickButtonMove;
}

fn plan<E: Describe>(mut room: Room<E>) -> Result<bool, Error> {
    let environment = &room.environment;
    let mut skills = room.skills.lend(environment)?;
    let memory = room.situations.lend(room.planner.lend(), room.learner);
    let mut trainer = Trainer::new(environment, room.training, memory);
    trainer.learn(&mut skills, room.skill, room.tasks)?;
    let found = trainer.situations(&skills, room.skill, room.tasks, 1)?;
    let mut oracle = Oracle::new(environment, &mut skills);
    for situation in found.iter().flatten() {
        oracle.answer(situation, None, &mut generator(room.seed))?;
    }
    let task = room.tasks.first().ok_or(Error::NoRegion)?;
    let ground = GroundTask::<E, 32>::new(environment, task)?;
    let mut guide = RegionGuide::new(environment, &skills, &task.initial);
    let mut planner = Planner {
        world: &mut ground.simulated(),
        sampler: &mut RegionSampler::new(environment, &skills),
        guide: &mut guide,
        config: room.config,
    };
    let lots = generator(room.seed);
    let samples = || generator(room.seed);
    let memory = room.planner.lend();
    let planned = planner.plan(ground.task(), &task.initial, lots, samples, memory)?;
    let solved = planned.conclusion == Conclusion::Solved;
    let mut text = TextBuffer::new(&mut room.text);
    let reason = planned.metrics.main_reason().unwrap_or(ReasonId(0));
    let explained = guide.explain(&ground.operators, reason, &mut text);
    Ok(solved || explained.is_ok())
}
