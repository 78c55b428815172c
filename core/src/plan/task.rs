//! What is planned: a task in the abstract, and one of an environment made abstract.

use super::world::Simulated;
use crate::error::Error;
use crate::task::{AtomSet, Atoms, Environment, GroundOperator, Task, ground_operators};
use heapless::Vec;

/// A task in the abstract (a STRIPS problem). Where its ground operators come from
/// does not matter.
#[derive(Clone, Copy, Debug)]
pub struct AbstractTask<'t, const N: usize = 2> {
    /// All ground operators, in the order in which they are tried.
    pub operators: &'t [GroundOperator<N>],
    /// What holds in the beginning.
    pub initial: AtomSet<N>,
    /// What shall hold in the end.
    pub goal: AtomSet<N>,
}

impl<'t, const N: usize> AbstractTask<'t, N> {
    /// The actions whose preconditions hold in a state, each with its place.
    pub(super) fn applicable(
        &self,
        state: AtomSet<N>,
    ) -> impl Iterator<Item = (u16, &'t GroundOperator<N>)> + use<'t, N> {
        let all = (0..).zip(self.operators);
        all.filter(move |(_, o)| !o.is_goal() && o.is_applicable(state))
    }

    /// Of the sets of atoms that reach the goal, the first that holds in a state; `None`
    /// if none does. Mostly there is only [`Self::goal`]; alternatives to it stand behind
    /// all operators, see [`GroundOperator::is_goal`].
    pub fn reached(&self, state: AtomSet<N>) -> Option<AtomSet<N>> {
        let operators = self.operators.iter().rev();
        let alternatives = operators.take_while(|operator| operator.is_goal());
        let goals = core::iter::once(self.goal).chain(alternatives.map(|o| o.preconditions));
        goals.into_iter().find(|goal| goal.is_subset(state))
    }
}

/// A task of an environment with all that a planner needs to know of it, for up to
/// `OPERATORS` ground operators.
#[derive(Debug)]
pub struct GroundTask<'e, E, const OPERATORS: usize> {
    /// The environment.
    pub environment: &'e E,
    /// The atoms over the task's objects.
    pub atoms: Atoms,
    /// Its ground operators.
    pub operators: Vec<GroundOperator, OPERATORS>,
    /// What holds in its initial state.
    pub initial: AtomSet,
    /// Its goal.
    pub goal: AtomSet,
}

impl<'e, E: Environment, const OPERATORS: usize> GroundTask<'e, E, OPERATORS> {
    /// Grounds a task of an environment.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] if there are more ground operators than room, or more
    /// atoms than [`MAX_ATOMS`](crate::task::MAX_ATOMS); [`Error::InvalidArgument`] if
    /// the goal is not about the task's objects.
    pub fn new(environment: &'e E, task: &Task) -> Result<Self, Error> {
        let atoms = Atoms::new::<E>(&task.initial)?;
        let mut operators = Vec::<_, OPERATORS>::new();
        ground_operators(E::OPERATORS, &task.initial, &atoms, &mut operators)?;
        Ok(GroundTask {
            environment,
            operators,
            initial: atoms.abstract_state(environment, &task.initial),
            goal: atoms.set(task.goal.iter().copied())?,
            atoms,
        })
    }

    /// The task in the abstract.
    pub fn task(&self) -> AbstractTask<'_> {
        AbstractTask {
            operators: &self.operators,
            initial: self.initial,
            goal: self.goal,
        }
    }

    /// The environment as a world to plan in, and as its own sampler.
    pub fn simulated(&self) -> Simulated<'_, E> {
        Simulated {
            environment: self.environment,
            atoms: &self.atoms,
        }
    }
}
