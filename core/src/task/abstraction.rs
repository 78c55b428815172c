//! Which atoms hold in a state: its abstraction (thesis 4.1.1, Definition 1).

use super::atom::{GroundAtom, Groundings, PredicateId};
use super::atom_set::{AtomSet, Atoms};
use super::environment::Environment;
use super::state::State;
use crate::error::Error;

impl GroundAtom {
    /// Whether the atom holds in a state; false for a predicate that the
    /// environment does not have.
    pub fn holds<E: Environment>(&self, environment: &E, state: &State) -> bool {
        E::PREDICATES
            .get(usize::from(self.predicate.0))
            .is_some_and(|p| (p.classifier)(environment, state, self.objects.as_slice()))
    }
}

impl Atoms {
    /// The atoms of an environment over the objects of `state`.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] if they are more than [`MAX_ATOMS`](super::MAX_ATOMS).
    pub fn new<E: Environment>(state: &State) -> Result<Self, Error> {
        let mut atoms = Atoms::none();
        for (id, predicate) in (0..).zip(E::PREDICATES) {
            let groundings = Groundings::new(state, predicate.arguments)?;
            for objects in groundings.filter(|objects| objects.are_distinct()) {
                let predicate = PredicateId(id);
                atoms.push(GroundAtom { predicate, objects })?;
            }
        }
        Ok(atoms)
    }

    /// ABSTRACT(x, Psi): the set of all ground atoms that hold in the state.
    pub fn abstract_state<E: Environment>(&self, environment: &E, state: &State) -> AtomSet {
        self.singletons()
            .filter(|(_, atom)| atom.holds(environment, state))
            .fold(AtomSet::EMPTY, |set, (bit, _)| set.union(bit))
    }
}
