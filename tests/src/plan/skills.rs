//! Learning the skills of an environment, for host programs.

use super::{MAX_OPERATORS, Room};
use crate::pick::ENVIRONMENT;
use crate::room::VersionSpaceRoom;
use critreg::Error;
use critreg::learn::version_space::Capacity;
use critreg::random::generator;
use critreg::region::Theta;
use critreg::skill::{
    Candidate, Changes, Describe, Learned, Setting, Skill, Skills, Training, TrainingMemory,
};
use critreg::task::{GroundOperator, Task};
use std::ops::RangeInclusive;

/// The memory of skills.
pub struct SkillRoom {
    skills: Vec<Option<Skill>>,
    changes: Vec<Changes>,
}

impl SkillRoom {
    /// Room for the skills of an environment.
    pub fn new<E: Describe>(environment: &E) -> Self {
        let count = environment.descriptions().len();
        SkillRoom {
            skills: (0..count).map(|_| None).collect(),
            changes: vec![Changes::default(); E::CONTROLLERS.len()],
        }
    }

    /// Skills of which nothing is known yet.
    pub fn lend(&mut self, environment: &impl Describe) -> Skills<'_> {
        Skills::new(environment, &mut self.skills, &mut self.changes)
            .expect("the descriptions are valid")
    }
}

/// The memory of learning a skill.
pub struct TrainingRoom {
    capacity: Capacity,
    settings: Vec<Option<Setting>>,
    candidates: Vec<Candidate>,
    proposals: Vec<Theta>,
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
        let calls = training
            .learner
            .calls
            .max(training.chained)
            .max(training.budget) as usize;
        let candidates = 4 * instances;
        let capacity = Capacity {
            forms: 12_000,
            tracked: usize::MAX,
            observations: calls.max(instances),
            instances,
            steps: 2,
        };
        TrainingRoom {
            capacity,
            settings: (0..2 * instances).map(|_| None).collect(),
            candidates: vec![Candidate::default(); candidates],
            proposals: vec![Theta::default(); candidates],
            instances: vec![0.0; 64 * candidates],
            operators: heapless::Vec::new(),
            planner: Room::new(1000),
            learner: VersionSpaceRoom::new(capacity),
        }
    }

    /// Lends all of it.
    pub fn lend(&mut self) -> TrainingMemory<'_> {
        TrainingMemory {
            settings: &mut self.settings,
            candidates: &mut self.candidates,
            proposals: &mut self.proposals,
            instances: &mut self.instances,
            operators: &mut self.operators,
            planner: self.planner.lend(),
            learner: self.learner.lend(),
            capacity: self.capacity,
        }
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
/// Those of [`Skills::learn`].
pub fn learn(
    skills: &mut Skills<'_>,
    seed: u64,
    training: &Training,
    room: &mut TrainingRoom,
) -> Result<Vec<Learned>, Error> {
    let tasks = tasks(seed ^ 0x7EA1_0000_0000, 1..=2, training.states);
    learn_from(&ENVIRONMENT, skills, &tasks, seed, training, room)
}

/// Learns all skills of an environment from training tasks.
///
/// # Errors
/// Those of [`Skills::learn`].
pub fn learn_from<E: Describe>(
    environment: &E,
    skills: &mut Skills<'_>,
    tasks: &[Task],
    seed: u64,
    training: &Training,
    room: &mut TrainingRoom,
) -> Result<Vec<Learned>, Error> {
    let training = Training {
        learner: critreg::learn::version_space::Config {
            seed,
            ..training.learner
        },
        ..*training
    };
    let all = 0..environment.descriptions().len();
    all.map(|index| skills.learn(index, environment, tasks, &training, room.lend()))
        .collect()
}
