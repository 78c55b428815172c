//! Memory of skills and of learning them, owned.

use super::changes::Changes;
use super::description::Describe;
use super::skills::{Skill, Skills};
use super::training::{Candidate, Situation, TrainingMemory};
use super::tuning::CANDIDATES;
use crate::error::Error;
use crate::learn::{Capacity, Memory};
use crate::plan;
use crate::region::Theta;
use crate::task::{GroundOperator, MAX_STATE_VALUES, State};

/// The memory of [`Skills`], about 16 kB each: as many as an environment has descriptions,
/// of as many controllers as it has.
#[derive(Debug)]
pub struct SkillRoom<const SKILLS: usize, const CONTROLLERS: usize> {
    skills: [Option<Skill>; SKILLS],
    changes: [Changes; CONTROLLERS],
}

impl<const SKILLS: usize, const CONTROLLERS: usize> Default for SkillRoom<SKILLS, CONTROLLERS> {
    fn default() -> Self {
        SkillRoom {
            skills: [const { None }; SKILLS],
            changes: [Changes::default(); CONTROLLERS],
        }
    }
}

impl<const SKILLS: usize, const CONTROLLERS: usize> SkillRoom<SKILLS, CONTROLLERS> {
    /// Skills of which nothing is known yet.
    ///
    /// # Errors
    /// Those of [`Skills::new`].
    pub fn lend<E: Describe>(&mut self, environment: &E) -> Result<Skills<'_>, Error> {
        Skills::new(environment, &mut self.skills, &mut self.changes)
    }
}

/// The memory of learning skills, about 3 kB for each of so many situations; for tasks with
/// so many ground operators.
#[derive(Debug)]
pub struct TrainingRoom<const SITUATIONS: usize, const OPERATORS: usize> {
    situations: [Option<Situation>; SITUATIONS],
    candidates: [[Candidate; CANDIDATES]; SITUATIONS],
    proposals: [[Theta; CANDIDATES]; SITUATIONS],
    instances: [[[f64; MAX_STATE_VALUES]; CANDIDATES]; SITUATIONS],
    operators: heapless::Vec<GroundOperator, OPERATORS>,
}

impl<const SITUATIONS: usize, const OPERATORS: usize> Default
    for TrainingRoom<SITUATIONS, OPERATORS>
{
    fn default() -> Self {
        TrainingRoom {
            situations: [const { None }; SITUATIONS],
            candidates: [[Candidate::default(); CANDIDATES]; SITUATIONS],
            proposals: [[Theta::default(); CANDIDATES]; SITUATIONS],
            instances: [[[0.0; MAX_STATE_VALUES]; CANDIDATES]; SITUATIONS],
            operators: heapless::Vec::new(),
        }
    }
}

impl<const SITUATIONS: usize, const OPERATORS: usize> TrainingRoom<SITUATIONS, OPERATORS> {
    /// All of it, with that of a planner and that of a learner of some capacity.
    pub fn lend<'m>(
        &'m mut self,
        planner: plan::Memory<'m, State>,
        (learner, capacity): (Memory<'m, f64>, Capacity),
    ) -> TrainingMemory<'m> {
        TrainingMemory {
            situations: &mut self.situations,
            candidates: self.candidates.as_flattened_mut(),
            proposals: self.proposals.as_flattened_mut(),
            instances: self.instances.as_flattened_mut().as_flattened_mut(),
            operators: &mut self.operators,
            planner,
            learner,
            capacity,
        }
    }
}
