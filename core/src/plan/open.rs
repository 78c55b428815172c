//! The open list of the search.

use crate::error::Error;

/// A node that waits. The least comes first: fields in order of importance.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Waiting {
    /// Cost so far and estimated cost to the goal.
    pub(super) priority: u32,
    /// Drawn by lot.
    pub(super) lot: u64,
    /// The node.
    pub(super) node: u32,
}

impl Waiting {
    /// What is set aside comes behind everything else.
    const ASIDE: u32 = 1 << 31;

    /// A node with this priority.
    pub(super) fn new(priority: u32, lot: u64, node: u32) -> Self {
        Waiting {
            priority: priority.min(Self::ASIDE - 1),
            lot,
            node,
        }
    }

    /// The same, set aside.
    pub(super) fn aside(self) -> Self {
        Waiting {
            priority: self.priority | Self::ASIDE,
            ..self
        }
    }

    pub(super) fn is_aside(&self) -> bool {
        self.priority & Self::ASIDE != 0
    }
}

/// A binary heap in lent memory, the least item first.
#[derive(Debug)]
pub(super) struct OpenList<'m> {
    slots: &'m mut [Waiting],
    used: usize,
}

impl<'m> OpenList<'m> {
    pub(super) fn new(slots: &'m mut [Waiting]) -> Self {
        OpenList { slots, used: 0 }
    }

    /// How many more there is room for.
    pub(super) fn room(&self) -> usize {
        self.slots.len().saturating_sub(self.used)
    }

    pub(super) fn push(&mut self, item: Waiting) -> Result<(), Error> {
        if self.room() == 0 {
            return Err(Error::CapacityExceeded("open list of the search"));
        }
        let place = self.used;
        self.used += 1;
        self.rise(place, item);
        Ok(())
    }

    pub(super) fn pop(&mut self) -> Option<Waiting> {
        let first = *self.slots.get(..self.used)?.first()?;
        self.used = self.used.saturating_sub(1);
        if let Some(last) = self.slots.get(self.used).copied() {
            self.sink(0, last);
        }
        Some(first)
    }

    /// Makes what is set aside wait among the others again.
    pub(super) fn rejoin(&mut self) {
        for slot in self.slots.iter_mut().take(self.used) {
            slot.priority &= !Waiting::ASIDE;
        }
        for place in (0..self.used / 2).rev() {
            if let Some(item) = self.slots.get(place).copied() {
                self.sink(place, item);
            }
        }
    }

    pub(super) fn clear(&mut self) {
        self.used = 0;
    }

    /// Puts an item where `place` is free, or above.
    fn rise(&mut self, mut place: usize, item: Waiting) {
        while place > 0 {
            let above = (place - 1) / 2;
            match self.slots.get(above).copied() {
                Some(parent) if item < parent => self.set(place, parent),
                _ => break,
            }
            place = above;
        }
        self.set(place, item);
    }

    /// Puts an item where `place` is free, or below.
    fn sink(&mut self, mut place: usize, item: Waiting) {
        loop {
            let left = 2 * place + 1;
            let children = self.slots.get(..self.used).and_then(|s| s.get(left..));
            let mut children = (left..).zip(children.unwrap_or_default()).take(2);
            let Some((mut below, mut least)) = children.next() else {
                break;
            };
            if let Some((right, other)) = children.next()
                && other < least
            {
                (below, least) = (right, other);
            }
            if item <= *least {
                break;
            }
            let least = *least;
            self.set(place, least);
            place = below;
        }
        self.set(place, item);
    }

    fn set(&mut self, place: usize, item: Waiting) {
        if let Some(slot) = self.slots.get_mut(place) {
            *slot = item;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand_core::Rng;
    use std::vec::Vec;

    #[test]
    fn comes_out_sorted_and_full_is_an_answer() {
        let mut rng = crate::random::generator(1);
        let mut slots = [Waiting::default(); 100];
        let mut open = OpenList::new(&mut slots);
        let mut all: Vec<_> = (0..100)
            .map(|node| Waiting {
                priority: rng.next_u32() % 8,
                lot: rng.next_u64(),
                node,
            })
            .collect();
        for _ in 0..2 {
            for item in &all {
                open.push(*item).unwrap();
            }
            assert!(open.push(Waiting::default()).is_err());
            all.sort();
            let sorted: Vec<_> = core::iter::from_fn(|| open.pop()).collect();
            assert_eq!(sorted, all);
            open.push(Waiting::default()).unwrap();
            open.clear();
            assert_eq!(open.pop(), None);
        }
    }
}
