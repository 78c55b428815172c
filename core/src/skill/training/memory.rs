//! The memory of learning a skill.

use super::situation::{Candidate, Situation};
use crate::learn::{Capacity, Memory};
use crate::plan;
use crate::region::Theta;
use crate::task::{GroundOperator, State};
use heapless::VecView;

/// The memory of learning a skill. All of it is used again for the next.
#[derive(Debug)]
pub struct TrainingMemory<'m> {
    /// The situations that a skill is tried in.
    pub situations: &'m mut [Option<Situation>],
    /// Situations to choose from: four for each.
    pub candidates: &'m mut [Candidate],
    /// One for each candidate.
    pub proposals: &'m mut [Theta],
    /// The numbers of the instances of all candidates.
    pub instances: &'m mut [f64],
    /// For the ground operators of a task.
    pub operators: &'m mut VecView<GroundOperator>,
    /// For planning to where an operator is applicable.
    pub planner: plan::Memory<'m, State>,
    /// For the learner, with this capacity; two steps are needed for two controllers.
    pub learner: Memory<'m, f64>,
    /// Its capacity.
    pub capacity: Capacity,
}
