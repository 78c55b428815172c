//! Sets of ground atoms, such as abstract states.

use super::atom::GroundAtom;
use crate::error::Error;
use crate::table::move_last;
use heapless::Vec;

/// Most ground atoms over the objects of one task.
pub const MAX_ATOMS: usize = 128;

/// The ground atoms of a task: either every predicate with every choice of distinct
/// objects of the right types, or, where it was given as PDDL, those that its operators
/// name.
///
/// They are in the order of the predicates, then of the objects, the last one
/// changing fastest. An [`AtomSet`] refers to them by their place.
#[derive(Clone, Debug)]
pub struct Atoms {
    atoms: Vec<GroundAtom, MAX_ATOMS>,
}

impl Atoms {
    /// No atoms yet, for [`Self::insert`].
    pub(crate) const fn none() -> Self {
        Atoms { atoms: Vec::new() }
    }

    /// Puts an atom to its place, unless it is there.
    pub(crate) fn insert(&mut self, atom: GroundAtom) -> Result<(), Error> {
        let Err(place) = self.atoms.binary_search(&atom) else {
            return Ok(());
        };
        self.push(atom)?;
        move_last(&mut self.atoms, place);
        Ok(())
    }

    /// Appends an atom.
    pub(super) fn push(&mut self, atom: GroundAtom) -> Result<(), Error> {
        let full = |_| Error::CapacityExceeded("ground atoms of a task");
        self.atoms.push(atom).map_err(full)
    }

    /// The atoms in order.
    pub fn as_slice(&self) -> &[GroundAtom] {
        &self.atoms
    }

    /// The set of these atoms.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] if one of them is not over the task's objects.
    pub fn set(&self, atoms: impl IntoIterator<Item = GroundAtom>) -> Result<AtomSet, Error> {
        let mut set = AtomSet::EMPTY;
        for atom in atoms {
            set = set.union(self.singleton(&atom).ok_or(Error::InvalidArgument(
                "an atom is not over distinct objects of the task",
            ))?);
        }
        Ok(set)
    }

    /// The set of this atom alone; `None` if it is not over the task's objects.
    pub fn singleton(&self, atom: &GroundAtom) -> Option<AtomSet> {
        self.singletons()
            .find(|(_, a)| *a == atom)
            .map(|(set, _)| set)
    }

    /// The atoms of a set, in order.
    pub fn members(&self, set: AtomSet) -> impl Iterator<Item = &GroundAtom> {
        self.singletons()
            .filter(move |(bit, _)| bit.is_subset(set))
            .map(|(_, atom)| atom)
    }

    /// The atoms in order, each with the set of it alone.
    pub(super) fn singletons(&self) -> impl Iterator<Item = (AtomSet, &GroundAtom)> {
        let bits = (0..).map(|place| AtomSet(1u128.wrapping_shl(place)));
        bits.zip(self.atoms.iter())
    }
}

/// A set of ground atoms, such as an abstract state: one bit for each atom of
/// [`Atoms`]. Sets of different tasks must not be mixed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
// A C program lends memory that is aligned for 64-bit words; and a node of a search
// is a quarter smaller.
#[repr(Rust, packed(8))]
pub struct AtomSet(u128);

impl AtomSet {
    /// No atom.
    pub const EMPTY: AtomSet = AtomSet(0);

    /// The atom at a place of [`Atoms::as_slice`] alone; no atom beyond
    /// [`MAX_ATOMS`].
    #[must_use]
    pub fn single(place: u32) -> AtomSet {
        AtomSet(1u128.checked_shl(place).unwrap_or(0))
    }

    /// The atoms in either set.
    #[must_use]
    pub fn union(self, other: AtomSet) -> AtomSet {
        AtomSet(self.0 | other.0)
    }

    /// The atoms in both sets.
    #[must_use]
    pub fn intersection(self, other: AtomSet) -> AtomSet {
        AtomSet(self.0 & other.0)
    }

    /// The atoms of this set that are not in the other.
    #[must_use]
    pub fn difference(self, other: AtomSet) -> AtomSet {
        AtomSet(self.0 & !other.0)
    }

    /// Whether the other set has all atoms of this one.
    pub fn is_subset(self, other: AtomSet) -> bool {
        self.difference(other).is_empty()
    }

    /// Whether the atom at a place is in the set.
    pub fn contains(self, place: u32) -> bool {
        !self.intersection(AtomSet::single(place)).is_empty()
    }

    /// Takes out the atom with the lowest place, and returns that place.
    pub fn pop_first(&mut self) -> Option<u32> {
        let place = (self.0 != 0).then(|| self.0.trailing_zeros())?;
        self.0 &= self.0.wrapping_sub(1);
        Some(place)
    }

    /// The set as a number: bit i for the atom at place i.
    pub fn bits(self) -> u128 {
        self.0
    }

    /// Whether there are none.
    pub fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// How many there are.
    pub fn len(self) -> u32 {
        self.0.count_ones()
    }

    /// The places of its atoms in [`Atoms::as_slice`], ascending.
    pub fn places(self) -> impl Iterator<Item = u32> {
        let mut rest = self;
        core::iter::from_fn(move || rest.pop_first())
    }
}
