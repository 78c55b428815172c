//! A table of fixed capacity in memory that the caller lends.
//!
//! Two kinds of table exist in the library. Where the capacity is a constant
//! (the objects of a domain, the constraints of a region) it is a
//! `heapless::Vec`. Where the user chooses it at run time (hypotheses,
//! observations) it is a [`Table`]: a C program lends one block of memory whose
//! size only it knows, which `heapless` cannot express without unsafe code.

use crate::error::Error;
use crate::real::Real;
use heapless::{Vec, VecView};

/// Brings the last item to a place, the items from there on moving up by one: an
/// insertion after a push, without the panic of one out of bounds.
pub(crate) fn move_last<T>(items: &mut [T], place: usize) {
    let behind = items.get_mut(place..);
    if let Some((last, others)) = behind.and_then(<[T]>::split_last_mut) {
        for other in others {
            core::mem::swap(last, other);
        }
    }
}

/// Takes the item at a place out, the items behind it moving down by one, without the
/// panic of `Vec::remove` out of bounds.
pub(crate) fn take_out<T>(items: &mut VecView<T>, place: usize) -> Option<T> {
    let mut behind = items.get_mut(place..)?.iter_mut();
    let mut hole = behind.next()?;
    for next in behind {
        core::mem::swap(hole, next);
        hole = next;
    }
    items.pop()
}

/// Collects items, of which there are `N` at most, without the panic of `collect` if
/// there were more.
pub(crate) fn gather<T, const N: usize>(items: impl IntoIterator<Item = T>) -> Vec<T, N> {
    let mut all = Vec::new();
    for item in items {
        if all.push(item).is_err() {
            break;
        }
    }
    all
}

/// Swaps two rows of so many items each, if both are there.
pub(crate) fn swap_rows<T>(items: &mut [T], length: usize, first: usize, second: usize) {
    let (first, second) = (first.min(second), first.max(second));
    let Some((before, after)) = items.split_at_mut_checked(second * length) else {
        return;
    };
    let first = before.iter_mut().skip(first * length).take(length);
    first.zip(after).for_each(|(a, b)| core::mem::swap(a, b));
}

/// What the entries of a lent table hold before anything is kept there.
pub trait Blank {
    /// Such an entry.
    const BLANK: Self;
}

impl<R: Real> Blank for R {
    const BLANK: R = R::ZERO;
}

impl Blank for u8 {
    const BLANK: u8 = 0;
}

impl Blank for u16 {
    const BLANK: u16 = 0;
}

impl Blank for u64 {
    const BLANK: u64 = 0;
}

/// As much of a lent table as is needed.
///
/// # Errors
/// [`Error::InvalidArgument`] if it is shorter.
pub(crate) fn cut<T>(table: &mut [T], length: usize) -> Result<&mut [T], Error> {
    table.get_mut(..length).ok_or(Error::InvalidArgument(
        "the learner needs more memory for this capacity",
    ))
}

/// A vector over a borrowed slice; pushing to a full one is an error.
#[derive(Debug)]
pub struct Table<'m, T> {
    slots: &'m mut [T],
    used: usize,
    what: &'static str,
}

impl<T: Copy> Table<'_, T> {
    /// Keeps the items at certain places, in their order.
    pub(crate) fn keep(&mut self, wanted: impl Fn(usize) -> bool) {
        let mut kept = 0;
        for place in 0..self.used {
            if wanted(place)
                && let Some(item) = self.slots.get(place).copied()
                && let Some(slot) = self.slots.get_mut(kept)
            {
                *slot = item;
                kept += 1;
            }
        }
        self.used = kept;
    }
}

impl<'m, T> Table<'m, T> {
    /// An empty table whose capacity is the length of `slots`; `what` names it
    /// in the error of a push that finds no room.
    pub fn new(slots: &'m mut [T], what: &'static str) -> Self {
        Table {
            slots,
            used: 0,
            what,
        }
    }

    /// What lies at a place, also if it was cleared.
    pub(crate) fn slot(&self, place: usize) -> Option<&T> {
        self.slots.get(place)
    }

    /// Appends an item.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] if the table is full; it stays as it was.
    pub fn push(&mut self, item: T) -> Result<(), Error> {
        let slot = self
            .slots
            .get_mut(self.used)
            .ok_or(Error::CapacityExceeded(self.what))?;
        *slot = item;
        self.used += 1;
        Ok(())
    }

    /// Takes out the item at a place, the items behind it moving down by one.
    pub(crate) fn remove(&mut self, place: usize) {
        if let Some(behind) = self.as_mut_slice().get_mut(place..)
            && !behind.is_empty()
        {
            behind.rotate_left(1);
            self.used -= 1;
        }
    }

    /// Forgets all items.
    pub fn clear(&mut self) {
        self.used = 0;
    }

    /// How many items there can be.
    pub fn capacity(&self) -> usize {
        self.slots.len()
    }

    /// How many items there are.
    pub fn len(&self) -> usize {
        self.used
    }

    /// Whether there are no items.
    pub fn is_empty(&self) -> bool {
        self.used == 0
    }

    /// The items.
    pub fn as_slice(&self) -> &[T] {
        self.slots.get(..self.used).unwrap_or(&[])
    }

    /// The items, for as long as the memory is lent.
    pub fn into_slice(self) -> &'m [T] {
        self.slots.get(..self.used).unwrap_or_default()
    }

    /// The items, to change.
    pub fn as_mut_slice(&mut self) -> &mut [T] {
        self.slots.get_mut(..self.used).unwrap_or(&mut [])
    }
}
