//! Environments: the tuple of types, controllers, transition function and
//! predicates of thesis 4.1.1.

use super::atom::Predicate;
use super::controller::{Controller, Parameters};
use super::operator::{ControllerId, GroundOperator, Operator, OperatorId};
use super::state::{ObjectId, ObjectType, State};
use crate::error::Error;
use crate::random::uniform_in;
use crate::table::gather;
use rand_core::Rng;

/// A simulated world with its symbolic description.
///
/// Predicates and operators must be listed in the order of their names: it is the
/// order in which a planner enumerates their groundings.
pub trait Environment: Sized + 'static {
    /// What a controller commands in one step.
    type Action: Copy;

    /// After how many steps a controller is stopped.
    const MAX_CONTROLLER_STEPS: u32 = 50;

    /// Lambda and d: the types of objects and their attributes.
    const TYPES: &'static [ObjectType];

    /// Psi: the predicates.
    const PREDICATES: &'static [Predicate<Self>];

    /// C: the controllers.
    const CONTROLLERS: &'static [Controller<Self>];

    /// Omega: the operators.
    const OPERATORS: &'static [Operator<'static>];

    /// The operator that a ground one is an instance of.
    ///
    /// # Errors
    /// [`Error::Mismatch`] if it is none of this environment.
    fn operator(&self, ground: &GroundOperator) -> Result<&'static Operator<'static>, Error> {
        let operator = Self::OPERATORS.get(usize::from(ground.operator.0));
        operator.ok_or(Error::Mismatch("an operator is not of this environment"))
    }

    /// A controller by its index.
    ///
    /// # Errors
    /// [`Error::Mismatch`] if this environment has none with this index.
    fn controller(&self, id: ControllerId) -> Result<&'static Controller<Self>, Error> {
        let controller = Self::CONTROLLERS.get(usize::from(id.0));
        controller.ok_or(Error::Mismatch("a controller is not of this environment"))
    }

    /// f: changes the state by one action.
    ///
    /// # Errors
    /// [`Failure`] if the action has no outcome here; the state stays as it was.
    fn simulate(&self, state: &mut State, action: Self::Action) -> Result<(), Failure>;

    /// Draws parameters for the controller of an operator, from the state before
    /// it and the operator's objects.
    ///
    /// Unless an environment knows better, this is [`sample_uniform`].
    fn sample<G: Rng>(
        &self,
        operator: OperatorId,
        _state: &State,
        _objects: &[ObjectId],
        rng: &mut G,
    ) -> Parameters {
        sample_uniform::<Self>(operator, rng)
    }
}

/// Parameters uniform over the space of an operator's controller; no parameters for an
/// unknown operator.
pub fn sample_uniform<E: Environment>(
    OperatorId(operator): OperatorId,
    rng: &mut impl Rng,
) -> Parameters {
    let operator = E::OPERATORS.get(usize::from(operator));
    let controller = operator.and_then(|o| E::CONTROLLERS.get(usize::from(o.controller.0)));
    let space = controller.map_or(&[][..], |c| c.parameters);
    let numbers = space.iter().map(|[low, high]| uniform_in(rng, *low, *high));
    gather(numbers)
}

/// An action has no outcome, for example because of a collision.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Failure {
    /// The object that is to blame, if it is one.
    pub culprit: Option<ObjectId>,
}
