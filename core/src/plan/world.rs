//! What is planned in.

use super::guide::ReasonId;
use super::skeleton::Skeleton;
use crate::error::Error;
use crate::task::{Atoms, Environment, GroundOperator, Parameters, Rollout, State, rollout};
use rand_core::Rng;

/// Where operators can be tried: a simulator with its predicates.
pub trait World<const N: usize = 2> {
    /// A low-level state. The planner writes into states that the caller lends, and
    /// never looks into one.
    type State;
    /// What can go wrong in the world; it ends the planning and is passed on. That
    /// an operator fails is no error.
    type Error: From<Error>;

    /// How many continuous parameters an operator has.
    ///
    /// # Errors
    /// If there is no such operator.
    fn parameters(&self, operator: &GroundOperator<N>) -> Result<usize, Self::Error>;

    /// Whether the atom at a place of the task's atoms holds in a state.
    ///
    /// # Errors
    /// If there is no such atom, and those of the world.
    fn holds(&mut self, atom: u32, state: &Self::State) -> Result<bool, Self::Error>;

    /// Runs an operator's controller from a state and writes the state afterwards.
    /// Returns how many actions it took; zero if it failed, with any state
    /// afterwards.
    ///
    /// # Errors
    /// Those of the world.
    fn execute(
        &mut self,
        operator: &GroundOperator<N>,
        parameters: &[f64],
        before: &Self::State,
        after: &mut Self::State,
    ) -> Result<u32, Self::Error>;
}

/// A step whose parameters are to be drawn.
#[derive(Debug)]
pub struct Draw<'a, S, const N: usize = 2> {
    /// The whole plan skeleton: what comes later may narrow what is good now.
    pub skeleton: Skeleton<'a, N>,
    /// The step in it, from zero.
    pub step: usize,
    /// Its operator.
    pub operator: &'a GroundOperator<N>,
    /// The state before it.
    pub state: &'a S,
    /// Which try of the step in this state it is, from one.
    pub attempt: u32,
    /// Whether advice counts. Once it does not, a sampler draws as if it knew
    /// nothing: see [`Config::patience`](super::Config::patience).
    pub advised: bool,
}

/// What a sampler says.
#[derive(Clone, Debug, PartialEq)]
pub enum Drawn {
    /// Try these.
    Parameters(Parameters),
    /// Try these, from where they are expected to work. This is advice.
    Informed(Parameters),
    /// No parameters are expected to work in this state: step back at once. This is
    /// advice, too.
    Empty(ReasonId),
    /// None were found, and nothing is known: this try failed.
    Nothing,
}

/// Draws the continuous parameters of a step.
pub trait Sampler<W: World<N>, const N: usize = 2> {
    /// Draws parameters; asked for operators without any, too, which may know that
    /// they cannot work in a state.
    ///
    /// # Errors
    /// They end the planning and are passed on.
    fn sample<R: Rng>(
        &mut self,
        draw: &Draw<'_, W::State, N>,
        rng: &mut R,
    ) -> Result<Drawn, W::Error>;
}

/// An [`Environment`] as a world to plan in, and as its own sampler: the original
/// one, which knows of no regions.
#[derive(Clone, Copy, Debug)]
pub struct Simulated<'a, E> {
    /// The environment.
    pub environment: &'a E,
    /// The atoms of the task.
    pub atoms: &'a Atoms,
}

impl<E: Environment> World for Simulated<'_, E> {
    type State = State;
    type Error = Error;

    fn parameters(&self, ground: &GroundOperator) -> Result<usize, Error> {
        let operator = self.environment.operator(ground)?;
        let controller = self.environment.controller(operator.controller)?;
        Ok(controller.parameters.len())
    }

    fn holds(&mut self, atom: u32, state: &State) -> Result<bool, Error> {
        let atom = self.atoms.as_slice().get(atom as usize);
        let atom = atom.ok_or(Error::Mismatch("an atom is not of this task"))?;
        Ok(atom.holds(self.environment, state))
    }

    fn execute(
        &mut self,
        ground: &GroundOperator,
        parameters: &[f64],
        before: &State,
        after: &mut State,
    ) -> Result<u32, Error> {
        let operator = self.environment.operator(ground)?;
        let controller = self.environment.controller(operator.controller)?;
        let objects = operator.controller_objects(ground.objects.as_slice())?;
        let objects = objects.as_slice();
        let run = rollout(self.environment, controller, objects, parameters, before);
        let Rollout { state, actions, .. } = run;
        *after = state;
        Ok(actions)
    }
}

impl<E: Environment> Sampler<Simulated<'_, E>> for Simulated<'_, E> {
    fn sample<R: Rng>(&mut self, draw: &Draw<'_, State>, rng: &mut R) -> Result<Drawn, Error> {
        let GroundOperator {
            operator, objects, ..
        } = draw.operator;
        let objects = objects.as_slice();
        let drawn = self.environment.sample(*operator, draw.state, objects, rng);
        Ok(Drawn::Parameters(drawn))
    }
}
