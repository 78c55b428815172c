//! What skills are used and learned in: an environment of this library, or a program that
//! is asked by callbacks.

use super::description::Describe;
use crate::error::Error;
use crate::task::{
    Arguments, AtomSet, Atoms, ControllerId, GroundAtom, GroundOperator, LiftedAtom, ObjectId,
    ObjectType, OperatorId, Parameters, PredicateId, State, Task, TypeId, ground_operators,
    rollout, try_operator,
};
use core::fmt::{self, Write};
use heapless::VecView;
use rand_core::Rng;

/// A controller, as far as skills know it.
#[derive(Clone, Copy, Debug)]
pub struct Signature {
    /// Its name.
    pub name: &'static str,
    /// The types of its objects.
    pub arguments: &'static [TypeId],
    /// How many continuous parameters it has.
    pub parameters: usize,
}

/// What an operator says of an atom.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Said {
    /// It holds before, and nothing is said of it afterwards.
    Stays,
    /// It holds before, and no longer afterwards.
    Ends,
    /// It holds afterwards.
    Added,
}

/// What skills are used in.
pub trait Setting {
    /// The types of objects.
    fn types(&self) -> &'static [ObjectType];

    /// A controller by its index.
    ///
    /// # Errors
    /// [`Error::Mismatch`] if there is none with this index.
    fn signature(&self, id: ControllerId) -> Result<Signature, Error>;

    /// The controller of an operator, and its objects when these stand for the operator's
    /// parameters.
    ///
    /// # Errors
    /// [`Error::Mismatch`] if there is no such operator, [`Error::InvalidArgument`] if
    /// objects are missing.
    fn call(
        &self,
        operator: OperatorId,
        objects: &[ObjectId],
    ) -> Result<(ControllerId, Arguments), Error>;

    /// Visits the preconditions and add effects of an operator with these objects. What is
    /// not visited, as by default, is not known to end without being said to.
    fn visit_atoms(
        &self,
        _operator: OperatorId,
        _objects: &[ObjectId],
        _visit: &mut dyn FnMut(Said, GroundAtom),
    ) {
    }

    /// Parameters of the original sampler for the controller of an operator.
    fn draw<R: Rng>(
        &self,
        operator: OperatorId,
        state: &State,
        objects: &[ObjectId],
        rng: &mut R,
    ) -> Parameters;

    /// Whether a predicate is about single objects of this type.
    fn narrows(&self, predicate: PredicateId, kind: TypeId) -> bool;

    /// Whether a predicate of one object holds of it.
    fn holds_of(&self, predicate: PredicateId, state: &State, object: ObjectId) -> bool;

    /// Writes the name of an object.
    ///
    /// # Errors
    /// Those of `out`, and if there is no such object.
    fn write_name(&self, state: &State, object: ObjectId, out: &mut dyn Write) -> fmt::Result;
}

/// What skills are learned in: a setting with training tasks, in which operators can be
/// tried. Which task a state is of, the state knows: [`State::mark`].
pub trait Practice: Setting {
    /// A training task.
    type Task;

    /// The state that a task begins in.
    fn initial<'t>(&self, task: &'t Self::Task) -> &'t State;

    /// The atoms of a task and those that hold initially; the ground operators are put into
    /// `operators`.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] if they find no room.
    fn ground(
        &self,
        task: &Self::Task,
        operators: &mut VecView<GroundOperator>,
    ) -> Result<(Atoms, AtomSet), Error>;

    /// Whether an atom holds in a state.
    ///
    /// # Errors
    /// Whatever ends learning.
    fn holds(&self, atom: &GroundAtom, state: &State) -> Result<bool, Error>;

    /// Runs an operator's controller from a state and writes the state afterwards. Returns
    /// how many actions it took; zero if it failed.
    ///
    /// # Errors
    /// Whatever ends learning. That the operator fails is no error.
    fn execute(
        &self,
        ground: &GroundOperator,
        parameters: &[f64],
        state: &mut State,
    ) -> Result<u32, Error>;

    /// Runs an operator's controller and looks at its effects. Tells whether an action was
    /// taken and all of them hold; then the state is the one afterwards.
    ///
    /// # Errors
    /// Whatever ends learning.
    fn try_operator(
        &self,
        ground: &GroundOperator,
        parameters: &[f64],
        state: &mut State,
    ) -> Result<bool, Error>;
}

impl<E: Describe> Setting for E {
    fn types(&self) -> &'static [ObjectType] {
        E::TYPES
    }

    fn signature(&self, id: ControllerId) -> Result<Signature, Error> {
        let controller = self.controller(id)?;
        Ok(Signature {
            name: controller.name,
            arguments: controller.arguments,
            parameters: controller.parameters.len(),
        })
    }

    fn call(
        &self,
        OperatorId(id): OperatorId,
        objects: &[ObjectId],
    ) -> Result<(ControllerId, Arguments), Error> {
        let operator = E::OPERATORS.get(usize::from(id));
        let operator = operator.ok_or(Error::Mismatch("an operator is not of this environment"))?;
        Ok((operator.controller, operator.controller_objects(objects)?))
    }

    fn visit_atoms(
        &self,
        OperatorId(id): OperatorId,
        objects: &[ObjectId],
        visit: &mut dyn FnMut(Said, GroundAtom),
    ) {
        let Some(operator) = E::OPERATORS.get(usize::from(id)) else {
            return;
        };
        let ground = |lifted: &LiftedAtom<'_>| lifted.ground(objects).ok();
        for atom in operator.preconditions.iter().filter_map(ground) {
            let mut deleted = operator.delete_effects.iter().filter_map(ground);
            let ends = deleted.any(|other| other == atom);
            visit(if ends { Said::Ends } else { Said::Stays }, atom);
        }
        for atom in operator.add_effects.iter().filter_map(ground) {
            visit(Said::Added, atom);
        }
    }

    fn draw<R: Rng>(
        &self,
        operator: OperatorId,
        state: &State,
        objects: &[ObjectId],
        rng: &mut R,
    ) -> Parameters {
        self.sample(operator, state, objects, rng)
    }

    fn narrows(&self, PredicateId(id): PredicateId, kind: TypeId) -> bool {
        let predicate = E::PREDICATES.get(usize::from(id));
        predicate.is_some_and(|predicate| predicate.arguments == [kind])
    }

    fn holds_of(&self, predicate: PredicateId, state: &State, object: ObjectId) -> bool {
        let predicate = E::PREDICATES.get(usize::from(predicate.0));
        predicate.is_some_and(|predicate| (predicate.classifier)(self, state, &[object]))
    }

    fn write_name(&self, state: &State, object: ObjectId, out: &mut dyn Write) -> fmt::Result {
        let name = state.name(E::TYPES, object).ok_or(fmt::Error)?;
        name.write(out)
    }
}

impl<E: Describe> Practice for E {
    type Task = Task;

    fn initial<'t>(&self, task: &'t Task) -> &'t State {
        &task.initial
    }

    fn ground(
        &self,
        task: &Task,
        operators: &mut VecView<GroundOperator>,
    ) -> Result<(Atoms, AtomSet), Error> {
        let atoms = Atoms::new::<E>(&task.initial)?;
        ground_operators(E::OPERATORS, &task.initial, &atoms, operators)?;
        let initial = atoms.abstract_state(self, &task.initial);
        Ok((atoms, initial))
    }

    fn holds(&self, atom: &GroundAtom, state: &State) -> Result<bool, Error> {
        Ok(atom.holds(self, state))
    }

    fn execute(
        &self,
        ground: &GroundOperator,
        parameters: &[f64],
        state: &mut State,
    ) -> Result<u32, Error> {
        let (id, objects) = self.call(ground.operator, ground.objects.as_slice())?;
        let controller = self.controller(id)?;
        let run = rollout(self, controller, objects.as_slice(), parameters, state);
        state.clone_from(&run.state);
        Ok(run.actions)
    }

    fn try_operator(
        &self,
        ground: &GroundOperator,
        parameters: &[f64],
        state: &mut State,
    ) -> Result<bool, Error> {
        let (operator, objects) = (self.operator(ground)?, ground.objects.as_slice());
        let tried = try_operator(self, operator, objects, parameters, state);
        let works = tried.is_feasible();
        if works {
            *state = tried.state;
        }
        Ok(works)
    }
}
