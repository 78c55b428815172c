//! Operators (thesis 4.1.1, Definition 2).

use super::atom::{Arguments, Groundings, LiftedAtom, substitute};
use super::atom_set::{AtomSet, Atoms};
use super::state::{ObjectId, State, TypeId};
use crate::error::Error;
use heapless::VecView;

/// Index of an [`Operator`] in the table of its environment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct OperatorId(pub u8);

impl OperatorId {
    /// Of no operator of a table: that one of the alternatives of a goal holds.
    pub const GOAL: OperatorId = OperatorId(u8::MAX);
}

/// Index of a [`Controller`](super::Controller) in the table of its environment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct ControllerId(pub u8);

/// An operator omega = (PAR, PRE, EFF+, EFF-, CON).
#[derive(Clone, Copy, Debug)]
pub struct Operator<'a> {
    /// Its name.
    pub name: &'a str,
    /// PAR: the types of its parameters.
    pub parameters: &'a [TypeId],
    /// PRE: what must hold before.
    pub preconditions: &'a [LiftedAtom<'a>],
    /// EFF+: what holds afterwards.
    pub add_effects: &'a [LiftedAtom<'a>],
    /// EFF-: what no longer holds afterwards, unless it is added.
    pub delete_effects: &'a [LiftedAtom<'a>],
    /// The controller of CON.
    pub controller: ControllerId,
    /// PAR_CON: for each object of the controller the index of a parameter.
    pub controller_arguments: &'a [u8],
}

impl Operator<'_> {
    /// The controller's objects when these stand for the operator's parameters.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] if there are fewer objects than parameters.
    pub fn controller_objects(&self, objects: &[ObjectId]) -> Result<Arguments, Error> {
        substitute(self.controller_arguments, objects)
    }

    /// The ground operator for these objects. `None` if a precondition or an add
    /// effect is not among `atoms` because it names one object twice: it can
    /// never hold.
    pub fn ground(
        &self,
        id: OperatorId,
        objects: Arguments,
        atoms: &Atoms,
    ) -> Option<GroundOperator> {
        let set = |lifted: &[LiftedAtom<'_>]| {
            lifted.iter().try_fold(AtomSet::EMPTY, |set, atom| {
                let atom = atom.ground(objects.as_slice()).ok()?;
                Some(set.union(atoms.singleton(&atom)?))
            })
        };
        let deleted = self.delete_effects.iter().filter_map(|atom| {
            let atom = atom.ground(objects.as_slice()).ok()?;
            atoms.singleton(&atom)
        });
        Some(GroundOperator {
            operator: id,
            objects,
            cost: 1,
            preconditions: set(self.preconditions)?,
            add_effects: set(self.add_effects)?,
            delete_effects: deleted.fold(AtomSet::EMPTY, AtomSet::union),
        })
    }
}

/// An operator with objects for its parameters; its atoms are sets over the
/// [`Atoms`] of the task.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GroundOperator<const N: usize = 2> {
    /// The operator.
    pub operator: OperatorId,
    /// The objects, one for each parameter.
    pub objects: Arguments,
    /// What it costs; 1 unless a PDDL text says otherwise.
    pub cost: u32,
    /// What must hold before.
    pub preconditions: AtomSet<N>,
    /// What holds afterwards.
    pub add_effects: AtomSet<N>,
    /// What no longer holds afterwards, unless it is added.
    pub delete_effects: AtomSet<N>,
}

impl<const N: usize> GroundOperator<N> {
    /// An operator that does nothing, to fill tables with.
    pub const NONE: GroundOperator<N> = GroundOperator {
        operator: OperatorId(0),
        objects: Arguments::NONE,
        cost: 1,
        preconditions: AtomSet::EMPTY,
        add_effects: AtomSet::EMPTY,
        delete_effects: AtomSet::EMPTY,
    };

    /// Whether it is no action, but says that its preconditions reach a goal with
    /// alternatives.
    pub fn is_goal(&self) -> bool {
        self.operator == OperatorId::GOAL
    }

    /// Whether the preconditions hold.
    pub fn is_applicable(&self, state: AtomSet<N>) -> bool {
        self.preconditions.is_subset(state)
    }

    /// The abstract transition F: deletes, then adds.
    pub fn apply(&self, state: AtomSet<N>) -> AtomSet<N> {
        state
            .difference(self.delete_effects)
            .union(self.add_effects)
    }

    /// What must hold before so that these atoms can hold afterwards, if nothing
    /// but the add effects changes: without those, and with the preconditions.
    #[must_use]
    pub fn regress(&self, atoms: AtomSet<N>) -> AtomSet<N> {
        atoms.difference(self.add_effects).union(self.preconditions)
    }
}

/// Appends all ground operators of a task to `out`: in the order of `operators`,
/// then of the objects, the last parameter changing fastest. An object may fill
/// several parameters.
///
/// # Errors
/// [`Error::CapacityExceeded`] if they find no room in `out`.
pub fn ground_operators(
    operators: &[Operator<'_>],
    state: &State,
    atoms: &Atoms,
    out: &mut VecView<GroundOperator>,
) -> Result<(), Error> {
    for (id, operator) in (0..).map(OperatorId).zip(operators) {
        for objects in Groundings::new(state, operator.parameters)? {
            if let Some(ground) = operator.ground(id, objects, atoms) {
                out.push(ground)
                    .map_err(|_| Error::CapacityExceeded("ground operators"))?;
            }
        }
    }
    Ok(())
}
