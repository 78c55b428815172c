//! What is known of types, controllers and actions, whichever the problem.

use crate::planner::tables::Ranges;
use core::cell::OnceCell;
use critreg_core::Error;
use critreg_core::domain::Domain;
use critreg_core::pddl;
use critreg_core::skill::Signature;
use critreg_core::task::{
    Arguments, ControllerId, MAX_ARGUMENTS, ObjectId, ObjectType, OperatorId, PredicateId, TypeId,
};
use heapless::Vec;

/// Types, controllers and actions of a program. Entries are added once, and stay.
#[derive(Clone, Copy)]
pub(crate) struct Facts {
    pub(crate) pddl: &'static pddl::Domain<'static>,
    /// Which numbers of a state belong to which object.
    pub(crate) layout: &'static Domain<'static>,
    /// The types of the layout.
    pub(crate) types: &'static [ObjectType],
    pub(crate) controllers: &'static [OnceCell<ControllerEntry>],
    /// For each PDDL action its controller.
    pub(crate) calls: &'static [OnceCell<ActionCall>],
}

/// A controller.
pub(crate) struct ControllerEntry {
    pub(crate) name: &'static str,
    pub(crate) arguments: Vec<TypeId, MAX_ARGUMENTS>,
    pub(crate) ranges: Ranges,
}

/// Which controller an action runs, and which of its parameters are the controller's objects.
pub(crate) struct ActionCall {
    pub(crate) controller: ControllerId,
    pub(crate) places: Vec<u8, MAX_ARGUMENTS>,
}

/// The type of what belongs to no type of the layout.
pub(crate) const NO_TYPE: TypeId = TypeId(u8::MAX);

impl Facts {
    pub(crate) fn entry(&self, ControllerId(id): ControllerId) -> Option<&'static ControllerEntry> {
        self.controllers.get(usize::from(id))?.get()
    }

    fn action(&self, OperatorId(id): OperatorId) -> Option<&'static ActionCall> {
        self.calls.get(usize::from(id))?.get()
    }

    /// The controller with a name.
    pub(crate) fn find(&self, name: &str) -> Option<ControllerId> {
        let named = |cell: &OnceCell<ControllerEntry>| {
            cell.get()
                .is_some_and(|own| own.name.eq_ignore_ascii_case(name))
        };
        let place = self.controllers.iter().position(named)?;
        u8::try_from(place).ok().map(ControllerId)
    }

    /// The ranges of an action's parameters.
    pub(crate) fn ranges(&self, action: OperatorId) -> Option<&'static Ranges> {
        let call = self.action(action)?;
        self.entry(call.controller).map(|own| &own.ranges)
    }

    pub(crate) fn signature(&self, id: ControllerId) -> Result<Signature, Error> {
        let entry = self
            .entry(id)
            .ok_or(Error::Mismatch("there is no such controller"))?;
        Ok(Signature {
            name: entry.name,
            arguments: &entry.arguments,
            parameters: entry.ranges.as_slice().len(),
        })
    }

    pub(crate) fn call(
        &self,
        action: OperatorId,
        objects: &[ObjectId],
    ) -> Result<(ControllerId, Arguments), Error> {
        let call = self.action(action);
        let call = call.ok_or(Error::Mismatch("an action has no controller"))?;
        let chosen = call.places.iter();
        let chosen = chosen.filter_map(|place| objects.get(usize::from(*place)).copied());
        Ok((call.controller, Arguments::new(chosen)?))
    }

    /// Whether a predicate is about single objects of a type of the layout.
    pub(crate) fn narrows(&self, PredicateId(id): PredicateId, kind: TypeId) -> bool {
        let predicate = self.pddl.predicates().get(usize::from(id));
        let arguments = predicate.map(|own| self.pddl.arguments(own));
        let Some([only]) = arguments else {
            return false;
        };
        self.type_of(only.type_id) == kind
    }

    /// The type of the layout that has the name of a PDDL type, or of the nearest supertype.
    pub(crate) fn type_of(&self, mut kind: TypeId) -> TypeId {
        loop {
            let Some(own) = self.pddl.types().get(usize::from(kind.0)) else {
                return NO_TYPE;
            };
            let mut all = (0..).map(TypeId).zip(self.types);
            let found = all.find(|(_, other)| other.name.eq_ignore_ascii_case(own.name));
            if let Some((found, _)) = found {
                return found;
            }
            if own.parent == kind {
                return NO_TYPE;
            }
            kind = own.parent;
        }
    }
}
