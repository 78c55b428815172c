//! Saving a run and resuming it.

use crate::boundary::pointer::{self, Output};
use crate::boundary::status::critreg_status;
use crate::boundary::text;
use crate::learner::handle::{critreg_learner, problem, with_learner};
use critreg_core::learn;

/// Saves what a learner was told, so that a run can be resumed: versioned,
/// checksummed, the same on every machine. A sample that was asked for but not
/// told is saved with it, and asked for again after resuming.
///
/// @param learner The learner.
/// @param instances The problem instances, as for critreg_ask().
/// @param count How many there are.
/// @param bytes Receives the bytes.
/// @param len Length of bytes; 0 to ask for the length only.
/// @param needed NULL, or receives how many bytes it takes, also if the buffer is
/// too small.
/// @return CRITREG_TOO_SMALL (nothing but needed is written);
/// CRITREG_INVALID_ARGUMENT, CRITREG_NOT_FINITE, CRITREG_BUSY,
/// CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_learner_save(
    learner: *mut critreg_learner,
    instances: *const f64,
    count: usize,
    bytes: *mut u8,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_learner(learner, |handle, inner| {
            let problem = problem(handle, instances, count)?;
            let length = learn::saved_len(&*inner.learner, &problem);
            text::write_bytes(length, bytes, len, needed, |bytes| {
                Ok(learn::save(&*inner.learner, &problem, bytes)?)
            })
        })
    }
}

/// Brings a fresh learner to the state that critreg_learner_save() wrote, by
/// replaying what was told.
///
/// @param learner A learner that was just made, with the domain, configuration and
/// number of forms of the saved one. It may have other calls, and room for more.
/// @param instances The instances of the saved run, and perhaps others behind.
/// @param count How many there are.
/// @param bytes The saved bytes.
/// @param len How many there are.
/// @return CRITREG_CORRUPT for damaged bytes; CRITREG_MISMATCH if they belong to
/// another domain, instances, configuration or number of forms;
/// CRITREG_OUT_OF_SEQUENCE if the learner is not fresh; CRITREG_CAPACITY_EXCEEDED
/// if there is no room for all observations: in all these cases nothing is told;
/// CRITREG_INVALID_ARGUMENT, CRITREG_NOT_FINITE, CRITREG_BUSY,
/// CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_learner_resume(
    learner: *mut critreg_learner,
    instances: *const f64,
    count: usize,
    bytes: *const u8,
    len: usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_learner(learner, |handle, inner| {
            let problem = problem(handle, instances, count)?;
            let bytes = pointer::slice(bytes, len, "bytes")?;
            inner.retire_region();
            Ok(learn::resume(&mut *inner.learner, &problem, bytes)?)
        })
    }
}

/// Writes what is to be appended to a journal: a file to which a program adds each answer as
/// it is told, instead of saving the whole run again. Each record has a checksum of its own,
/// so one that was torn when the machine stopped is noticed and everything before it stands.
///
/// ```c
/// CHECK(critreg_tell(learner, instances, count, outcome));
/// CHECK(critreg_learner_journal(learner, instances, count, written, bytes, sizeof bytes, &len));
/// fwrite(bytes, 1, len, file);
/// fflush(file);
/// written++;
/// ```
///
/// @param learner The learner.
/// @param instances The problem instances, as for critreg_ask().
/// @param count How many there are.
/// @param from How many observations the journal has, asked for or not: those from there on
/// are written.
/// @param bytes Receives the bytes; a record takes 34 and 8 for each parameter.
/// @param len Length of bytes; 0 to ask for the length only.
/// @param needed NULL, or receives how many bytes it takes, also if the buffer is
/// too small.
/// @return As critreg_learner_save().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_learner_journal(
    learner: *mut critreg_learner,
    instances: *const f64,
    count: usize,
    from: usize,
    bytes: *mut u8,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_learner(learner, |handle, inner| {
            let problem = problem(handle, instances, count)?;
            let length = learn::journal_len(&*inner.learner, &problem, from);
            text::write_bytes(length, bytes, len, needed, |bytes| {
                Ok(learn::journal(&*inner.learner, &problem, from, bytes)?)
            })
        })
    }
}

/// Brings a fresh learner to the state that a journal tells of.
///
/// @param learner A learner as for critreg_learner_resume().
/// @param instances The instances of the run, and perhaps others behind.
/// @param count How many there are.
/// @param bytes The journal.
/// @param len How many bytes it has.
/// @param stands NULL, or receives how many of them stand. What is behind was torn or
/// damaged and left out; cut it off before anything is appended.
/// @return CRITREG_MISMATCH for a record of another domain, instances, configuration or
/// number of forms, CRITREG_CORRUPT if one is missing before it,
/// CRITREG_CAPACITY_EXCEEDED if there is no room for it, CRITREG_OUT_OF_SEQUENCE if the
/// learner is not fresh: in all these cases nothing is told; CRITREG_INVALID_ARGUMENT,
/// CRITREG_NOT_FINITE, CRITREG_BUSY, CRITREG_NULL_POINTER, CRITREG_MISALIGNED,
/// CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_learner_resume_journal(
    learner: *mut critreg_learner,
    instances: *const f64,
    count: usize,
    bytes: *const u8,
    len: usize,
    stands: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_learner(learner, |handle, inner| {
            let output = Output::optional(stands, "stands")?;
            let problem = problem(handle, instances, count)?;
            let bytes = pointer::slice(bytes, len, "bytes")?;
            inner.retire_region();
            let good = learn::resume_journal(&mut *inner.learner, &problem, bytes)?;
            if let Some(output) = output {
                output.write(good);
            }
            Ok(())
        })
    }
}
