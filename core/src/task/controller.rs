//! Controllers (thesis 4.1.1: C and its low-level policies).

// A circle that is in the matter: an environment has controllers, and a controller
// commands what its environment takes for an action.
use super::environment::Environment;
use super::state::{ObjectId, State, TypeId};
use crate::domain::MAX_PARAMETERS;
use heapless::Vec;

/// The continuous parameters theta of an action.
pub type Parameters = Vec<f64, MAX_PARAMETERS>;

/// A function of a state and an action ((o_1, .., o_v), theta).
pub type OfAction<E, T> = fn(&E, &State, &[ObjectId], &[f64]) -> T;

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
    pub(super) fn holds(
        &self,
        environment: &E,
        state: &State,
        objects: &[ObjectId],
        parameters: &[f64],
        actions: u32,
    ) -> bool {
        match self {
            Terminal::When(holds) => holds(environment, state, objects, parameters),
            Terminal::FirstAction => actions > 0,
        }
    }
}

/// An `initiable` for controllers that can always start.
pub fn always<E>(_: &E, _: &State, _: &[ObjectId], _: &[f64]) -> bool {
    true
}
