//! Saving what was learned, and going on from there.

use crate::boundary::pointer;
use crate::boundary::status::{Fallible, critreg_status};
use crate::boundary::text;
use crate::skill::handle::{Inner, critreg_skills, with_skills};
use critreg_core::Error;
use critreg_core::skill::{Course, Skills};

/// Saves what was learned so far: the skills that are learned, and the runs that were kept
/// of the one that is being learned. Versioned, checksummed, the same on every machine.
///
/// @param skills The skills.
/// @param bytes Receives the bytes.
/// @param len Length of bytes; 0 to ask for the length only.
/// @param needed NULL, or receives how many bytes it takes, also if the buffer is too small.
/// @return CRITREG_TOO_SMALL (nothing but needed is written); CRITREG_OUT_OF_SEQUENCE if
/// there is no training task yet; CRITREG_CAPACITY_EXCEEDED, CRITREG_BUSY,
/// CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_skills_save(
    skills: *mut critreg_skills,
    bytes: *mut u8,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_skills(skills, |inner| {
            inner.begin()?;
            let count = inner.learned_count;
            inner.course(|course| {
                let length = course.saved_len(count);
                text::write_bytes(length, bytes, len, needed, |bytes| {
                    Ok(course.save(count, bytes)?)
                })
            })
        })
    }
}

/// Brings fresh skills to the state that critreg_skills_save() wrote; critreg_skills_learn()
/// then goes on from there.
///
/// @param skills Skills that were just made, with the texts, configuration, controllers,
/// skills and training tasks of the saved ones. They may have room for more.
/// @param bytes The saved bytes.
/// @param len How many there are.
/// @return CRITREG_CORRUPT for damaged bytes; CRITREG_MISMATCH if they belong to other texts,
/// tasks or another configuration; CRITREG_CAPACITY_EXCEEDED if the runs that were kept find
/// no room (critreg_skills_config.runs); CRITREG_OUT_OF_SEQUENCE if the skills are not fresh:
/// in all these cases nothing is known of any skill; CRITREG_BUSY, CRITREG_NULL_POINTER,
/// CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_skills_resume(
    skills: *mut critreg_skills,
    bytes: *const u8,
    len: usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_skills(skills, |inner| {
            let bytes = pointer::slice(bytes, len, "bytes")?;
            if inner.begun {
                return Err(Error::OutOfSequence("resume skills that were just made").into());
            }
            inner.begin()?;
            let resumed = inner.course(|course| Ok(course.resume(bytes)?));
            // What was refused leaves them as they were, but for what was added.
            inner.learned_count = *resumed.as_ref().unwrap_or(&0);
            resumed.map(|_| ())
        })
    }
}

impl Inner {
    /// What was learned so far.
    fn course<T>(
        &mut self,
        body: impl FnOnce(&mut Course<'_, '_, '_>) -> Fallible<T>,
    ) -> Fallible<T> {
        let count = self.skill_count;
        let skills = self.skills.get_mut(..count).unwrap_or_default();
        let controllers = self.controller_count;
        let changes = self.changes.get_mut(..controllers).unwrap_or_default();
        body(&mut Course {
            skills: &mut Skills::resume(skills, changes),
            learned: self.learned.get_mut(..count).unwrap_or_default(),
            journal: &mut self.journal,
            fingerprint: self.fingerprint.0,
        })
    }
}
