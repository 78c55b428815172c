//! Tasks (thesis 4.1.1: T = (O, x_0, g)).

use super::atom::GroundAtom;
use super::environment::Environment;
use super::state::State;
use heapless::Vec;

/// Most atoms in the goal of a task.
pub const MAX_GOAL_ATOMS: usize = 16;

/// A task: the objects and where they start, and what shall hold in the end.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Task {
    /// The objects and the initial state x_0.
    pub initial: State,
    /// The goal g: all of these atoms.
    pub goal: Vec<GroundAtom, MAX_GOAL_ATOMS>,
}

impl Task {
    /// Whether the goal holds in a state.
    pub fn is_solved<E: Environment>(&self, environment: &E, state: &State) -> bool {
        self.goal.iter().all(|atom| atom.holds(environment, state))
    }
}
