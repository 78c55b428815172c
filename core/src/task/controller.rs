//! Controllers and their runs (thesis 4.1.1: C and its low-level policies).

use super::environment::{Environment, Failure};
use super::state::{MAX_STATE_VALUES, ObjectId, State, TypeId};
use crate::domain::MAX_PARAMETERS;
use crate::real::Real;
use heapless::Vec;

/// Index of a [`Controller`] in the table of its environment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct ControllerId(pub u8);

/// The continuous parameters theta of an action, in single precision as the
/// framework that recorded the reference data keeps them.
pub type Parameters = Vec<f32, MAX_PARAMETERS>;

/// A function of a state and an action ((o_1, .., o_v), theta).
pub type OfAction<E, T> = fn(&E, &State, &[ObjectId], &[f32]) -> T;

/// A controller: a policy with objects and continuous parameters, run until a
/// condition holds.
pub struct Controller<E: Environment> {
    /// Its name.
    pub name: &'static str,
    /// The types of its objects.
    pub arguments: &'static [TypeId],
    /// Its parameter space: the `[low, high]` of each parameter.
    pub parameters: &'static [[f64; 2]],
    /// Whether it can start in a state.
    pub initiable: OfAction<E, bool>,
    /// What it commands in a state.
    pub policy: OfAction<E, E::Action>,
    /// When it is done.
    pub terminal: Terminal<E>,
}

/// When a controller is done.
pub enum Terminal<E> {
    /// As soon as this holds in a state.
    When(OfAction<E, bool>),
    /// After its first action, whatever came of it.
    FirstAction,
}

impl<E> Terminal<E> {
    fn holds(
        &self,
        environment: &E,
        state: &State,
        objects: &[ObjectId],
        parameters: &[f32],
        actions: u32,
    ) -> bool {
        match self {
            Terminal::When(holds) => holds(environment, state, objects, parameters),
            Terminal::FirstAction => actions > 0,
        }
    }
}

/// An `initiable` for controllers that can always start.
pub fn always<E>(_: &E, _: &State, _: &[ObjectId], _: &[f32]) -> bool {
    true
}

/// How a controller's run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// Its terminal condition holds.
    Terminal,
    /// It was stopped after [`Environment::MAX_CONTROLLER_STEPS`].
    StepLimit,
    /// It could not start.
    NotInitiable,
    /// A step changed nothing.
    Stuck,
    /// A step had no outcome.
    Failed(Failure),
}

/// A controller's run.
#[derive(Clone, Debug)]
pub struct Rollout {
    /// The last state; the start state if the run could not start, was stuck or
    /// failed.
    pub state: State,
    /// How many actions were taken; zero if the run could not start, was stuck or
    /// failed.
    pub actions: u32,
    /// How it ended.
    pub ending: Ending,
}

/// Runs a controller from `start` to its terminal condition.
///
/// A run is stuck when two successive states agree in every number; this is how
/// targets that cannot be reached fail.
pub fn rollout<E: Environment>(
    environment: &E,
    controller: &Controller<E>,
    objects: &[ObjectId],
    parameters: &[f32],
    start: &State,
) -> Rollout {
    let mut run = Rollout {
        state: start.clone(),
        actions: 0,
        ending: Ending::StepLimit,
    };
    (run.actions, run.ending) =
        rollout_from(environment, controller, objects, parameters, &mut run.state);
    if run.actions == 0 {
        run.state.clone_from(start);
    }
    run
}

/// As [`rollout`], in a state that the caller lends: states are large, and small
/// machines have no stack for several. Tells how many actions were taken and how the
/// run ended; if there were none, the state is one on the way and means nothing.
pub fn rollout_from<E: Environment>(
    environment: &E,
    controller: &Controller<E>,
    objects: &[ObjectId],
    parameters: &[f32],
    state: &mut State,
) -> (u32, Ending) {
    if !(controller.initiable)(environment, state, objects, parameters) {
        return (0, Ending::NotInitiable);
    }
    let is_done = |state: &State, actions| {
        let terminal = &controller.terminal;
        terminal.holds(environment, state, objects, parameters, actions)
    };
    if is_done(state, 0) {
        return (0, Ending::Terminal);
    }
    let mut before = Values([0.0; MAX_STATE_VALUES]);
    for actions in 1..=E::MAX_CONTROLLER_STEPS {
        before.copy_from(state);
        let action = (controller.policy)(environment, state, objects, parameters);
        if let Err(failure) = environment.simulate(state, action) {
            return (0, Ending::Failed(failure));
        }
        if is_done(state, actions) {
            return (actions, Ending::Terminal);
        }
        if before.agree_with(state) {
            return (0, Ending::Stuck);
        }
    }
    (E::MAX_CONTROLLER_STEPS, Ending::StepLimit)
}

/// The numbers of a state before a step; those beyond its length mean nothing.
struct Values([f64; MAX_STATE_VALUES]);

impl Values {
    fn copy_from(&mut self, state: &State) {
        for (copy, value) in self.0.iter_mut().zip(state.values()) {
            *copy = *value;
        }
    }

    fn agree_with(&self, after: &State) -> bool {
        let close = |(a, b): (&f64, &f64)| Real::abs(a - b) <= 1e-3 + 1e-5 * Real::abs(*b);
        self.0.iter().zip(after.values()).all(close)
    }
}
