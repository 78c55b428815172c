//! Predicates and atoms (thesis 4.1.1).

use super::state::{ObjectId, State, TypeId};
use crate::error::Error;

/// Most arguments of a predicate, and most parameters of an operator.
pub const MAX_ARGUMENTS: usize = 10;

/// Index of a [`Predicate`] in the table of its environment.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct PredicateId(pub u8);

impl PredicateId {
    const NEGATION: u8 = 0x80;

    /// Of the atom that stands for a goal with alternatives.
    pub(crate) const GOAL: PredicateId = PredicateId(0x7F);

    /// The predicate that holds for what this one does not hold for, and the other way
    /// round. PDDL texts have such atoms, where a precondition or a goal is negative.
    #[must_use]
    pub fn negation(self) -> PredicateId {
        PredicateId(self.0 ^ Self::NEGATION)
    }

    /// Whether it is the negation of a predicate of the table.
    pub fn is_negation(self) -> bool {
        self.0 & Self::NEGATION != 0
    }
}

/// A predicate psi: a property of objects that holds in a state or does not.
pub struct Predicate<E> {
    /// Its name.
    pub name: &'static str,
    /// The types of its arguments.
    pub arguments: &'static [TypeId],
    /// The classifier c_psi: whether it holds for these objects, one for each
    /// argument, in this state.
    pub classifier: fn(&E, &State, &[ObjectId]) -> bool,
}

/// Up to [`MAX_ARGUMENTS`] objects, in order.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Arguments {
    // What lies beyond `count` stays zero, so the derived order and equality
    // compare the objects.
    objects: [ObjectId; MAX_ARGUMENTS],
    count: u8,
}

impl Arguments {
    /// No objects.
    pub const NONE: Arguments = Arguments {
        objects: [ObjectId(0); MAX_ARGUMENTS],
        count: 0,
    };

    /// These objects.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] if they are more than [`MAX_ARGUMENTS`].
    pub fn new(objects: impl IntoIterator<Item = ObjectId>) -> Result<Self, Error> {
        let mut arguments = Arguments::default();
        for object in objects {
            let slot = arguments
                .objects
                .get_mut(usize::from(arguments.count))
                .ok_or(Error::CapacityExceeded("arguments of an atom or operator"))?;
            *slot = object;
            arguments.count += 1;
        }
        Ok(arguments)
    }

    /// The objects.
    pub fn as_slice(&self) -> &[ObjectId] {
        self.objects
            .get(..usize::from(self.count))
            .unwrap_or_default()
    }

    pub(crate) fn as_mut_slice(&mut self) -> &mut [ObjectId] {
        self.objects
            .get_mut(..usize::from(self.count))
            .unwrap_or_default()
    }

    /// Whether no object occurs twice.
    pub fn are_distinct(&self) -> bool {
        let mut rest = self.as_slice().iter();
        while let Some(object) = rest.next() {
            if rest.clone().any(|other| other == object) {
                return false;
            }
        }
        true
    }
}

/// A predicate with variables: the parameters of an operator.
#[derive(Clone, Copy, Debug)]
pub struct LiftedAtom<'a> {
    /// The predicate.
    pub predicate: PredicateId,
    /// For each argument the index of an operator parameter.
    pub variables: &'a [u8],
}

impl<'a> LiftedAtom<'a> {
    /// The predicate of these variables.
    pub const fn new(predicate: PredicateId, variables: &'a [u8]) -> Self {
        LiftedAtom {
            predicate,
            variables,
        }
    }
}

impl LiftedAtom<'_> {
    /// The atom for these objects, one for each operator parameter.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] if a variable has no object;
    /// [`Error::CapacityExceeded`] beyond [`MAX_ARGUMENTS`] variables.
    pub fn ground(&self, objects: &[ObjectId]) -> Result<GroundAtom, Error> {
        Ok(GroundAtom {
            predicate: self.predicate,
            objects: substitute(self.variables, objects)?,
        })
    }
}

/// The objects that stand at these indices.
pub(super) fn substitute(variables: &[u8], objects: &[ObjectId]) -> Result<Arguments, Error> {
    let mut missing = false;
    let arguments = Arguments::new(variables.iter().map(|variable| {
        let object = objects.get(usize::from(*variable)).copied();
        missing |= object.is_none();
        object.unwrap_or_default()
    }))?;
    if missing {
        return Err(Error::InvalidArgument(
            "give one object for each operator parameter",
        ));
    }
    Ok(arguments)
}

/// A predicate with objects. Ordered by predicate, then by objects.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct GroundAtom {
    /// The predicate.
    pub predicate: PredicateId,
    /// Its arguments.
    pub objects: Arguments,
}

impl GroundAtom {
    /// Whether it is no atom of the world, but stands for a goal with alternatives.
    pub fn is_goal(&self) -> bool {
        self.predicate == PredicateId::GOAL
    }

    /// The atom that holds where this one does not.
    #[must_use]
    pub fn negation(self) -> GroundAtom {
        GroundAtom {
            predicate: self.predicate.negation(),
            ..self
        }
    }
}

/// All ways to fill typed places with objects of a state, the last place changing
/// fastest.
#[derive(Clone, Debug)]
pub struct Groundings<'a> {
    state: &'a State,
    types: &'a [TypeId],
    next: Option<Arguments>,
}

impl<'a> Groundings<'a> {
    /// The groundings of places of these types; an object may fill several.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] if they are more than [`MAX_ARGUMENTS`].
    pub fn new(state: &'a State, types: &'a [TypeId]) -> Result<Self, Error> {
        let firsts = || types.iter().map_while(|t| state.of_type(*t).next());
        let first = Arguments::new(firsts())?;
        Ok(Groundings {
            state,
            types,
            next: (firsts().count() == types.len()).then_some(first),
        })
    }

    fn after(&self, mut arguments: Arguments) -> Option<Arguments> {
        let places = arguments.as_mut_slice().iter_mut().zip(self.types);
        for (place, place_type) in places.rev() {
            let current = *place;
            let mut candidates = self.state.of_type(*place_type);
            if let Some(object) = candidates.find(|o| *o > current) {
                *place = object;
                return Some(arguments);
            }
            *place = self.state.of_type(*place_type).next()?;
        }
        None
    }
}

impl Iterator for Groundings<'_> {
    type Item = Arguments;

    fn next(&mut self) -> Option<Arguments> {
        let arguments = self.next?;
        self.next = self.after(arguments);
        Some(arguments)
    }
}
