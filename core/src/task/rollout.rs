//! Runs of controllers.

use super::controller::Controller;
use super::environment::{Environment, Failure};
use super::state::{MAX_STATE_VALUES, ObjectId, State};
use crate::real::Real;

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
    parameters: &[f64],
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
    parameters: &[f64],
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
