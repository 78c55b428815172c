//! Skills in the caller's memory.

use crate::boundary::handle::{self, Exclusive, Handle};
use crate::boundary::status::{Failure, Fallible, critreg_status};
use crate::skill::config::Settings;
use crate::skill::facts::Facts;
use crate::skill::layout::{Pool, TrainingTables};
use crate::skill::learning::Progress;
use crate::skill::practice::{Desk, TaskEntry};
use core::cell::OnceCell;
use core::fmt;
use critreg_core::skill::{Changes, Journal, Learned, Skill, Skills};
use critreg_core::task::PredicateId;

/// Skills: what is learned of a program's controllers. They lie at the start of the memory
/// they were made in.
pub struct critreg_skills {
    seal: usize,
    inner: Exclusive<Inner>,
}

/// What a call on skills borrows.
pub(crate) struct Inner {
    pub(crate) facts: Facts,
    pub(crate) texts: Pool,
    /// Room for predicates that narrow groups.
    pub(crate) narrowing: &'static mut [PredicateId],
    /// Tells apart what is learned from.
    pub(crate) fingerprint: Fingerprint,
    pub(crate) skills: &'static mut [Option<Skill>],
    pub(crate) learned: &'static mut [Learned],
    pub(crate) changes: &'static mut [Changes],
    /// The changes before the skill that is being learned.
    pub(crate) changes_before: &'static mut [Changes],
    pub(crate) tasks: &'static [OnceCell<TaskEntry>],
    pub(crate) controller_count: usize,
    pub(crate) skill_count: usize,
    pub(crate) task_count: usize,
    /// How many skills were learned: the first ones.
    pub(crate) learned_count: usize,
    /// Whether learning has begun, so that nothing can be added.
    pub(crate) begun: bool,
    pub(crate) desk: Desk,
    pub(crate) journal: Journal<'static>,
    pub(crate) training: TrainingTables,
    pub(crate) settings: Settings,
    pub(crate) progress: Progress,
}

// SAFETY: the seal is a word of the handle, and private.
unsafe impl Handle for critreg_skills {
    const KIND: u64 = 0x736B_696C_6C73_7263;
    const NAME: &'static str = "skills";

    fn seal(handle: *const Self) -> *const usize {
        // SAFETY: a place inside of the handle; nothing is read.
        unsafe { &raw const (*handle).seal }
    }
}

impl Inner {
    /// What is known, to plan with.
    pub(crate) fn known(&mut self) -> Skills<'_> {
        let skills = self.skills.get_mut(..self.skill_count).unwrap_or_default();
        let changes = self
            .changes
            .get_mut(..self.controller_count)
            .unwrap_or_default();
        Skills::resume(skills, changes)
    }
}

impl critreg_skills {
    /// Writes and seals a handle; what lay there before is lost.
    ///
    /// # Safety
    /// As for [`handle::put`].
    pub(crate) unsafe fn put(place: *mut critreg_skills, inner: Inner) {
        let made = critreg_skills {
            seal: 0,
            inner: Exclusive::new(inner),
        };
        // SAFETY: by this function's contract.
        unsafe { handle::put(place, made) }
    }

    /// Lends skills to another call, such as planning.
    ///
    /// # Errors
    /// [`Failure::Busy`] if they are in use.
    pub(crate) fn lend<T>(&self, body: impl FnOnce(&mut Inner) -> Fallible<T>) -> Fallible<T> {
        self.inner
            .borrow(body)
            .unwrap_or(Err(Failure::Busy("skills")))
    }

    pub(crate) fn message(&self) -> impl fmt::Display {
        self.inner.message()
    }
}

/// Runs a call on skills: refuses it if they are in use, and keeps the words about a failure.
///
/// # Safety
/// As for [`handle::open`].
pub(crate) unsafe fn with_skills(
    skills: *mut critreg_skills,
    body: impl FnOnce(&mut Inner) -> Fallible,
) -> critreg_status {
    // SAFETY: by this function's contract.
    match unsafe { handle::open(skills) } {
        Ok(handle) => handle.inner.call(body),
        Err(failure) => failure.status(),
    }
}

/// A checksum that grows (FNV-1a).
#[derive(Clone, Copy)]
pub(crate) struct Fingerprint(pub(crate) u32);

impl Fingerprint {
    pub(crate) const NOTHING: Fingerprint = Fingerprint(0x811C_9DC5);

    pub(crate) fn bytes(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = (self.0 ^ u32::from(*byte)).wrapping_mul(0x0100_0193);
        }
    }

    pub(crate) fn text(&mut self, text: &str) {
        self.bytes(text.as_bytes());
        self.bytes(&[0]);
    }

    pub(crate) fn numbers(&mut self, numbers: impl Iterator<Item = f64>) {
        numbers.for_each(|number| self.bytes(&number.to_bits().to_le_bytes()));
    }
}
