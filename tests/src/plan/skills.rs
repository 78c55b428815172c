//! Learning the skills of the stick-button environment, for host programs.

use super::{MAX_OPERATORS, Room};
use crate::pick::ENVIRONMENT;
use crate::report::VersionSpaceRoom;
use critreg::Error;
use critreg::domain::{Environment, GroundOperator, Task};
use critreg::learn::version_space::Capacity;
use critreg::plan::skill::{
    Changes, Describe, Learned, Setting, Skill, Skills, Training, TrainingMemory,
};
use critreg::random::generator;
use std::ops::RangeInclusive;

/// The memory of skills.
pub struct SkillRoom {
    skills: Vec<Option<Skill>>,
    changes: Vec<Changes>,
}

impl Default for SkillRoom {
    fn default() -> Self {
        let count = ENVIRONMENT.descriptions().len();
        SkillRoom {
            skills: (0..count).map(|_| None).collect(),
            changes: vec![Changes::default(); ENVIRONMENT.controllers().len()],
        }
    }
}

impl SkillRoom {
    /// Skills of which nothing is known yet.
    pub fn lend(&mut self) -> Skills<'_> {
        Skills::new(&ENVIRONMENT, &mut self.skills, &mut self.changes)
            .expect("the descriptions are valid")
    }
}

/// The memory of learning a skill.
pub struct TrainingRoom {
    capacity: Capacity,
    settings: Vec<Option<Setting>>,
    instances: Vec<f64>,
    operators: heapless::Vec<GroundOperator, MAX_OPERATORS>,
    planner: Room,
    learner: VersionSpaceRoom,
}

impl TrainingRoom {
    /// Memory for so many calls of each of two controllers, or states of one without
    /// parameters.
    pub fn new(training: &Training) -> TrainingRoom {
        let instances = training.instances.max(training.states);
        let calls = 2 * training.learner.calls as usize;
        let capacity = Capacity {
            forms: 12_000,
            tracked: usize::MAX,
            observations: calls.max(instances),
            instances,
            steps: 2,
        };
        TrainingRoom {
            capacity,
            settings: (0..instances).map(|_| None).collect(),
            instances: vec![0.0; 64 * instances],
            operators: heapless::Vec::new(),
            planner: Room::new(1000),
            learner: VersionSpaceRoom::new(capacity),
        }
    }

    /// Lends all of it.
    pub fn lend(&mut self) -> TrainingMemory<'_> {
        TrainingMemory {
            settings: &mut self.settings,
            instances: &mut self.instances,
            operators: &mut self.operators,
            planner: self.planner.lend(),
            learner: self.learner.lend(),
            capacity: self.capacity,
        }
    }
}

/// Random tasks.
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
/// Those of [`Skills::learn`].
pub fn learn(
    skills: &mut Skills<'_>,
    seed: u64,
    training: &Training,
    room: &mut TrainingRoom,
) -> Result<Vec<Learned>, Error> {
    let tasks = tasks(seed ^ 0x7EA1_0000_0000, 1..=2, training.states);
    let training = Training {
        learner: critreg::learn::version_space::Config {
            seed,
            ..training.learner
        },
        ..*training
    };
    let all = 0..ENVIRONMENT.descriptions().len();
    all.map(|index| skills.learn(index, &ENVIRONMENT, &tasks, &training, room.lend()))
        .collect()
}
