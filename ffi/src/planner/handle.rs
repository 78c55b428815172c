//! A planner in the caller's memory.

use crate::boundary::handle::{self, Exclusive, Handle};
use crate::boundary::status::{Fallible, critreg_status};
use crate::planner::config::Settings;
use crate::planner::metrics::critreg_metrics;
use crate::planner::tables::Tables;
use crate::planner::why::Reason;
use core::cell::Cell;
use core::fmt::{self, Write as _};
use critreg_core::pddl::Problem;
use critreg_core::task::GroundAtom;

/// A planner for one problem. It lies at the start of the memory it was made in.
pub struct critreg_planner {
    seal: usize,
    /// What the last call left behind, also readable from a callback.
    pub(crate) metrics: Cell<critreg_metrics>,
    /// Why the last planning found no plan.
    pub(crate) reason: Cell<Reason>,
    /// The atom that the last failure is about, if it is one.
    pub(crate) culprit: Cell<Option<GroundAtom>>,
    /// What stood in the way most often, as skills say it.
    pub(crate) words: Words,
    problem: &'static Problem<'static>,
    pub(crate) inner: Exclusive<Inner>,
}

/// What a call on a planner borrows.
pub(crate) struct Inner {
    pub(crate) tables: Tables,
    pub(crate) settings: Settings,
    /// How many steps of the tables are the plan that was found last.
    pub(crate) plan_length: usize,
}

// SAFETY: the seal is a word of the handle, and private.
unsafe impl Handle for critreg_planner {
    const KIND: u64 = 0x706C_616E_6E65_7263;
    const NAME: &'static str = "planner";

    fn seal(handle: *const Self) -> *const usize {
        // SAFETY: a place inside of the handle; nothing is read.
        unsafe { &raw const (*handle).seal }
    }
}

impl critreg_planner {
    pub(crate) fn problem(&self) -> &'static Problem<'static> {
        self.problem
    }

    /// Writes and seals a handle; what lay there before is lost.
    ///
    /// # Safety
    /// As for [`handle::put`].
    pub(crate) unsafe fn put(
        place: *mut critreg_planner,
        tables: Tables,
        settings: Settings,
        words: Words,
    ) {
        let made = critreg_planner {
            seal: 0,
            metrics: Cell::new(critreg_metrics::NONE),
            reason: Cell::new(Reason::Nothing),
            culprit: Cell::new(None),
            words,
            problem: tables.problem,
            inner: Exclusive::new(Inner {
                tables,
                settings,
                plan_length: 0,
            }),
        };
        // SAFETY: by this function's contract.
        unsafe { handle::put(place, made) }
    }
}

/// Words in memory of the planner, which can be read while it is in use. What finds no room is
/// cut off.
pub(crate) struct Words {
    bytes: &'static [Cell<u8>],
    length: Cell<usize>,
}

impl Words {
    /// None yet.
    pub(crate) fn new(bytes: &'static [Cell<u8>]) -> Words {
        Words {
            bytes,
            length: Cell::new(0),
        }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.length.get() == 0
    }

    /// Forgets the words, and takes others.
    pub(crate) fn begin(&self) -> Writer<'_> {
        self.length.set(0);
        Writer(self)
    }
}

/// Writes words.
pub(crate) struct Writer<'w>(&'w Words);

impl fmt::Write for Writer<'_> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        let Writer(words) = self;
        for byte in text.bytes() {
            // The last one is that of the NUL.
            let room = words.bytes.split_last().map_or(&[][..], |(_, room)| room);
            if let Some(slot) = room.get(words.length.get()) {
                slot.set(byte);
                words.length.set(words.length.get() + 1);
            }
        }
        Ok(())
    }
}

impl fmt::Display for Words {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // Names and numbers are ASCII, so a byte is a character.
        let bytes = self.bytes.iter().take(self.length.get());
        bytes
            .map(Cell::get)
            .try_for_each(|byte| f.write_char(char::from(byte)))
    }
}

/// Runs a call on a planner: refuses it if the planner is in use, and keeps the
/// words about a failure.
///
/// # Safety
/// As for [`handle::open`].
pub(crate) unsafe fn with_planner(
    planner: *mut critreg_planner,
    body: impl FnOnce(&critreg_planner, &mut Inner) -> Fallible,
) -> critreg_status {
    // SAFETY: by this function's contract.
    match unsafe { handle::open(planner) } {
        Ok(handle) => handle.inner.call(|inner| body(handle, inner)),
        Err(failure) => failure.status(),
    }
}

/// A failure, and the atom it is about.
pub(crate) struct Message<'a>(pub(crate) &'a critreg_planner);

impl fmt::Display for Message<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Message(handle) = self;
        handle.inner.message().fmt(f)?;
        match handle.culprit.get() {
            Some(atom) => write!(f, ": {}", handle.problem.atom_text(&atom)),
            None => Ok(()),
        }
    }
}
