//! What a planner does (thesis 4.1.1): an [`Environment`] has a simulator,
//! [`Predicate`]s, [`Operator`]s (Definition 2) and [`Controller`]s; a [`State`] is
//! abstracted to the [`AtomSet`] of what holds in it (Definition 1), a [`Task`] is
//! T = (O, x_0, g), and [`try_operator`] rolls an operator out and looks at its effects.

mod abstraction;
mod atom;
mod atom_set;
mod controller;
mod environment;
mod operator;
mod rollout;
mod state;
mod trial;

pub use atom::{
    Arguments, GroundAtom, Groundings, LiftedAtom, MAX_ARGUMENTS, Predicate, PredicateId,
};
pub use atom_set::{AtomSet, Atoms, MAX_ATOMS};
pub use controller::{Controller, OfAction, Parameters, Terminal, always};
pub use environment::{Environment, Failure, sample_uniform};
pub use operator::{ControllerId, GroundOperator, Operator, OperatorId, ground_operators};
pub use rollout::{Ending, Rollout, rollout, rollout_from};
pub use state::{MAX_STATE_VALUES, Naming, ObjectId, ObjectName, ObjectType, State, TypeId};
pub use trial::{Trial, Verdict, try_operator, try_operator_from};

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
