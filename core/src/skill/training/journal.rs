//! What came of the controllers that were run to learn a skill.

use crate::error::Error;
use crate::wire::{Reader, Writer};

/// The runs of controllers since a skill began to be learned, in lent memory: of each how
/// many actions it took, and the numbers of the state afterwards. Learning asks for the same
/// runs again if it begins anew, so none of them has to be repeated.
///
/// It keeps the first ones; those that find no room are run again.
#[derive(Debug)]
pub struct Journal<'m> {
    numbers: &'m mut [f64],
    used: usize,
    /// Where the next run stands that was not asked for again.
    next: usize,
    full: bool,
}

/// Numbers of a run, apart from those of the state: its actions, and how many those are.
const HEAD: usize = 2;

impl<'m> Journal<'m> {
    /// No runs yet. A run takes two numbers, and those of a state.
    pub fn new(numbers: &'m mut [f64]) -> Self {
        Journal {
            numbers,
            used: 0,
            next: 0,
            full: false,
        }
    }

    /// Forgets all runs.
    pub fn clear(&mut self) {
        (self.used, self.next, self.full) = (0, 0, false);
    }

    /// Begins again with the first run.
    pub fn rewind(&mut self) {
        (self.next, self.full) = (0, false);
    }

    /// Writes the state after the next run that is kept to `after`, and tells how many
    /// actions it took. `None` if there is none, or none with so many numbers.
    pub fn replay(&mut self, after: &mut [f64]) -> Option<u32> {
        let kept = self.numbers.get(self.next..self.used)?;
        let (head, rest) = kept.split_at_checked(HEAD)?;
        let (Some(actions), Some(length)) = (head.first(), head.last()) else {
            return None;
        };
        let values = rest.get(..*length as usize)?;
        if values.len() != after.len() {
            return None;
        }
        for (slot, value) in after.iter_mut().zip(values) {
            *slot = *value;
        }
        self.next += HEAD + after.len();
        Some(*actions as u32)
    }

    /// Keeps a run, behind all others.
    pub fn record(&mut self, actions: u32, after: &[f64]) {
        let room = self.numbers.get_mut(self.used..);
        let Some(room) = room.filter(|room| room.len() >= HEAD + after.len() && !self.full) else {
            // What follows would not stand where it is looked for.
            self.full = true;
            return;
        };
        let head = [f64::from(actions), after.len() as f64];
        for (slot, number) in room.iter_mut().zip(head.iter().chain(after)) {
            *slot = *number;
        }
        self.used += HEAD + after.len();
        self.next = self.used;
    }

    pub(in crate::skill) fn write(&self, writer: &mut Writer<'_>) {
        let kept = self.numbers.get(..self.used).unwrap_or_default();
        writer.u32(kept.len() as u32);
        kept.iter().for_each(|number| writer.f64(*number));
    }

    /// Reads what [`Journal::write`] wrote.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] if it finds no room.
    pub(in crate::skill) fn read(&mut self, reader: &mut Reader<'_>) -> Result<(), Error> {
        let count = reader.u32()? as usize;
        let room = self.numbers.get_mut(..count);
        for slot in room.ok_or(Error::CapacityExceeded("runs that were kept"))? {
            *slot = reader.f64()?;
        }
        self.clear();
        self.used = count;
        Ok(())
    }
}
