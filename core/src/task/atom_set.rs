//! Sets of ground atoms, such as abstract states.

use super::atom::GroundAtom;
use crate::error::Error;

/// Most ground atoms over the objects of one task of an environment.
pub const MAX_ATOMS: usize = 128;

/// Atoms that one word of an [`AtomSet`] has a bit for.
const BITS: usize = 64;

/// The ground atoms of a task, at most 64 for each of `N` words: either every predicate
/// with every choice of distinct objects of the right types, or, where it was given as
/// PDDL, those that its operators name.
///
/// They are in the order of the predicates, then of the objects, the last one
/// changing fastest. An [`AtomSet`] refers to them by their place.
#[derive(Clone, Debug)]
pub struct Atoms<const N: usize = 2> {
    atoms: [[GroundAtom; BITS]; N],
    used: usize,
}

impl<const N: usize> Atoms<N> {
    /// No atoms yet, for [`Self::insert`].
    pub(crate) fn none() -> Self {
        Atoms {
            atoms: [[GroundAtom::default(); BITS]; N],
            used: 0,
        }
    }

    /// Puts an atom to its place, unless it is there. Whether it is new.
    pub(crate) fn insert(&mut self, atom: GroundAtom) -> Result<bool, Error> {
        let Err(place) = self.as_slice().binary_search(&atom) else {
            return Ok(false);
        };
        self.push(atom)?;
        let used = self.atoms.as_flattened_mut().get_mut(..self.used);
        crate::table::move_last(used.unwrap_or_default(), place);
        Ok(true)
    }

    /// Appends an atom, which comes behind all others.
    pub(super) fn push(&mut self, atom: GroundAtom) -> Result<(), Error> {
        let slot = self.atoms.as_flattened_mut().get_mut(self.used);
        *slot.ok_or(Error::CapacityExceeded("ground atoms of a task"))? = atom;
        self.used += 1;
        Ok(())
    }

    /// The atoms in order.
    pub fn as_slice(&self) -> &[GroundAtom] {
        let atoms = self.atoms.as_flattened().get(..self.used);
        atoms.unwrap_or_default()
    }

    /// The set of these atoms.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] if one of them is not over the task's objects.
    pub fn set(&self, atoms: impl IntoIterator<Item = GroundAtom>) -> Result<AtomSet<N>, Error> {
        let mut set = AtomSet::EMPTY;
        for atom in atoms {
            set = set.union(self.singleton(&atom).ok_or(Error::InvalidArgument(
                "an atom is not over distinct objects of the task",
            ))?);
        }
        Ok(set)
    }

    /// The set of this atom alone; `None` if it is not over the task's objects.
    pub fn singleton(&self, atom: &GroundAtom) -> Option<AtomSet<N>> {
        let place = self.as_slice().binary_search(atom).ok()?;
        Some(AtomSet::single(place as u32))
    }

    /// The atoms of a set, in order.
    pub fn members(&self, set: AtomSet<N>) -> impl Iterator<Item = &GroundAtom> {
        let atoms = self.as_slice();
        set.places()
            .filter_map(move |place| atoms.get(place as usize))
    }

    /// The atoms in order, each with the set of it alone.
    pub(super) fn singletons(&self) -> impl Iterator<Item = (AtomSet<N>, &GroundAtom)> {
        (0..).map(AtomSet::single).zip(self.as_slice())
    }
}

/// A set of ground atoms, such as an abstract state: one bit for each atom of
/// [`Atoms`], in `N` words. Sets of different tasks must not be mixed.
///
/// Two words, which is what environments have, are as fast as a number of 128 bits;
/// more serve larger PDDL texts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct AtomSet<const N: usize = 2>([u64; N]);

impl<const N: usize> Default for AtomSet<N> {
    fn default() -> Self {
        AtomSet::EMPTY
    }
}

impl<const N: usize> AtomSet<N> {
    /// No atom.
    pub const EMPTY: AtomSet<N> = AtomSet([0; N]);

    /// The atom at a place of [`Atoms::as_slice`] alone; no atom beyond the last bit.
    #[must_use]
    pub fn single(place: u32) -> AtomSet<N> {
        let mut set = AtomSet::EMPTY;
        if let Some(word) = set.0.get_mut(place as usize / BITS) {
            *word = 1u64.wrapping_shl(place);
        }
        set
    }

    /// The atoms in either set.
    #[must_use]
    pub fn union(self, other: AtomSet<N>) -> AtomSet<N> {
        self.with(other, |own, other| own | other)
    }

    /// The atoms in both sets.
    #[must_use]
    pub fn intersection(self, other: AtomSet<N>) -> AtomSet<N> {
        self.with(other, |own, other| own & other)
    }

    /// The atoms of this set that are not in the other.
    #[must_use]
    pub fn difference(self, other: AtomSet<N>) -> AtomSet<N> {
        self.with(other, |own, other| own & !other)
    }

    #[inline(always)]
    fn with(mut self, other: AtomSet<N>, join: impl Fn(u64, u64) -> u64) -> AtomSet<N> {
        for (own, other) in self.0.iter_mut().zip(other.0) {
            *own = join(*own, other);
        }
        self
    }

    /// Whether the other set has all atoms of this one.
    pub fn is_subset(self, other: AtomSet<N>) -> bool {
        self.difference(other).is_empty()
    }

    /// Whether the atom at a place is in the set.
    pub fn contains(self, place: u32) -> bool {
        let word = self.0.get(place as usize / BITS);
        word.is_some_and(|word| word.wrapping_shr(place) & 1 == 1)
    }

    /// Takes out the atom with the lowest place, and returns that place.
    pub fn pop_first(&mut self) -> Option<u32> {
        let mut words = (0..).step_by(BITS).zip(&mut self.0);
        let (first, word) = words.find(|(_, word)| **word != 0)?;
        let place: u32 = first + word.trailing_zeros();
        *word &= word.wrapping_sub(1);
        Some(place)
    }

    /// The set as numbers: bit i of word w for the atom at place 64 w + i.
    pub fn words(self) -> [u64; N] {
        self.0
    }

    /// A number that is mostly another one for another set: multiplicative hashing (Knuth),
    /// of which the upper half is good.
    pub(crate) fn hash(self) -> u32 {
        const GOLDEN: u64 = 0x9E37_79B9_7F4A_7C15;
        let join = |mixed: u64, word: &u64| mixed.wrapping_mul(GOLDEN) ^ word;
        (self.0.iter().rfold(0, join).wrapping_mul(GOLDEN) >> 32) as u32
    }

    /// Whether there are none.
    pub fn is_empty(self) -> bool {
        self.0.iter().fold(0, |all, word| all | word) == 0
    }

    /// How many there are.
    pub fn len(self) -> u32 {
        self.0.iter().map(|word| word.count_ones()).sum()
    }

    /// The places of its atoms in [`Atoms::as_slice`], ascending.
    pub fn places(self) -> impl Iterator<Item = u32> {
        let mut rest = self;
        core::iter::from_fn(move || rest.pop_first())
    }
}
