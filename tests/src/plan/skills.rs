//! Learning the skills of an environment, for host programs.

use super::{MAX_OPERATORS, Room};
use crate::pick::ENVIRONMENT;
use crate::room::VersionSpaceRoom;
use critreg::Error;
use critreg::learn::version_space::Capacity;
use critreg::random::generator;
use critreg::skill::{self, Describe, Learned, Skills, Trainer, Training, TrainingMemory};
use critreg::task::Task;
use std::ops::RangeInclusive;

/// Memory for the skills of any environment.
pub type SkillRoom = skill::SkillRoom<8, 8>;

/// Most situations.
const SITUATIONS: usize = 150;

/// How much is tried to learn skills, and the memory for it.
pub struct TrainingRoom {
    training: Training,
    tables: Box<skill::TrainingRoom<SITUATIONS, MAX_OPERATORS>>,
    planner: Room,
    learner: VersionSpaceRoom,
}

impl TrainingRoom {
    /// Memory for so much training.
    pub fn new(training: Training) -> TrainingRoom {
        let instances = training.situations.max(training.states);
        let calls = [training.learner.calls, training.chained, training.budget];
        let calls = calls.into_iter().max().unwrap_or_default() as usize;
        TrainingRoom {
            training,
            tables: Box::default(),
            planner: Room::new(1000),
            learner: VersionSpaceRoom::new(Capacity {
                forms: 12_000,
                tracked: usize::MAX,
                sums: usize::MAX,
                questions: 16,
                observations: calls.max(instances),
                instances,
                steps: 2,
            }),
        }
    }

    /// A trainer whose random choices are those of a seed.
    pub fn trainer<'m, E: Describe>(
        &'m mut self,
        environment: &'m E,
        seed: u64,
    ) -> Trainer<'m, 'm, E> {
        let mut training = self.training;
        training.learner.seed = seed;
        Trainer::new(environment, training, self.lend())
    }

    /// Lends all of it.
    pub fn lend(&mut self) -> TrainingMemory<'_> {
        let capacity = self.learner.capacity;
        let learner = (self.learner.lend(), capacity);
        self.tables.lend(self.planner.lend(), learner)
    }
}

/// Random tasks of the stick-button environment.
pub fn tasks(seed: u64, buttons: RangeInclusive<usize>, count: usize) -> Vec<Task> {
    let mut rng = generator(seed);
    let task = |_| {
        ENVIRONMENT
            .task(buttons.clone(), &mut rng)
            .expect("the buttons find room")
    };
    (0..count).map(task).collect()
}

/// Learns all skills from training tasks of a seed, with one or two buttons as those of
/// the framework.
///
/// # Errors
/// Those of [`Trainer::learn`].
pub fn learn(
    skills: &mut Skills<'_>,
    seed: u64,
    room: &mut TrainingRoom,
) -> Result<Vec<Learned>, Error> {
    let tasks = tasks(seed ^ 0x7EA1_0000_0000, 1..=2, room.training.states);
    learn_from(&ENVIRONMENT, skills, &tasks, seed, room)
}

/// Learns all skills of an environment from training tasks.
///
/// # Errors
/// Those of [`Trainer::learn`].
pub fn learn_from<E: Describe>(
    environment: &E,
    skills: &mut Skills<'_>,
    tasks: &[Task],
    seed: u64,
    room: &mut TrainingRoom,
) -> Result<Vec<Learned>, Error> {
    let mut trainer = room.trainer(environment, seed);
    let all = 0..E::DESCRIPTIONS.len();
    all.map(|index| trainer.learn(skills, index, tasks))
        .collect()
}
