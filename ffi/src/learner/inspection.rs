//! What is asked about a learner: whether it is finished, what it learned, how that went.

use crate::boundary::handle;
use crate::boundary::pointer::Output;
use crate::boundary::status::critreg_status;
use crate::boundary::structs;
use crate::boundary::text;
use crate::learner::handle::{critreg_learner, with_learner};
use crate::learner::quality;
use crate::learner::report::critreg_report;
use crate::region::handle::critreg_region;
use crate::region::quality::CRITREG_PROVISIONAL;
use core::ffi::c_char;

/// Whether there is nothing more to ask.
///
/// @param learner The learner; may be called from its callbacks.
/// @param finished Receives 1 or 0.
/// @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_is_finished(
    learner: *const critreg_learner,
    finished: *mut i32,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for both.
    unsafe {
        handle::read(learner, |handle| {
            Output::new(finished, "finished")?.write(i32::from(handle.finished.get()));
            Ok(())
        })
    }
}

/// What is learned so far: the best region there is, of whatever quality; see
/// critreg_region_quality().
///
/// @param learner The learner.
/// @param region Receives the region. It belongs to the learner and is valid until
/// the next call of critreg_learn_region(), critreg_tell(), critreg_observe(),
/// critreg_conclude(), critreg_learner_resume() or critreg_learner_resume_journal() on it; after that using it gives
/// CRITREG_NOT_A_HANDLE. To keep it, save it and load it into memory of its own;
/// what supports its constraints is not saved.
/// @return CRITREG_NO_REGION if there is none, see critreg_learner_why();
/// CRITREG_BUSY, CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_learner_region(
    learner: *mut critreg_learner,
    region: *mut *const critreg_region,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for both.
    unsafe {
        with_learner(learner, |handle, inner| {
            let output = Output::new(region, "region")?;
            output.write(inner.give_region(handle.domain, CRITREG_PROVISIONAL)?);
            Ok(())
        })
    }
}

/// Why there is no region, or none that is exact: as a code and in words.
///
/// ```c
/// uint32_t why;
/// char words[CRITREG_WHY_MAX];
/// CHECK(critreg_learner_why(learner, &why, words, sizeof words, NULL));
/// printf("%s\n", words);
/// ```
///
/// @param learner The learner.
/// @param why NULL, or receives the code: CRITREG_WHY_EXPLAINED, or another one. What the
/// code counts is in the words; also what could be compared but found no room, if that may be
/// why: lend memory for more forms then.
/// @param text NULL, or receives the words, ended by NUL; CRITREG_WHY_MAX bytes are enough.
/// @param len Length of text in bytes; 0 to ask for the length only.
/// @param needed NULL, or receives the length of the words with their NUL.
/// @return CRITREG_TOO_SMALL; CRITREG_BUSY, CRITREG_NULL_POINTER, CRITREG_MISALIGNED,
/// CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_learner_why(
    learner: *mut critreg_learner,
    why: *mut u32,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_learner(learner, |handle, inner| {
            let known = inner.learner.why();
            if let Some(output) = Output::optional(why, "why")? {
                output.write(quality::code(&known));
            }
            if text.is_null() && len == 0 && needed.is_null() {
                return Ok(());
            }
            let words = quality::Words {
                why: known,
                left_out: inner.learner.left_out(handle.domain),
                domain: handle.domain,
            };
            text::write(&words, text, len, needed)
        })
    }
}

/// How learning went so far.
///
/// @param learner The learner; may be called from its callbacks.
/// @param report A report from critreg_report_init(), to be filled.
/// @return CRITREG_INVALID_ARGUMENT if the report was not initialised;
/// CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_learner_report(
    learner: *const critreg_learner,
    report: *mut critreg_report,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for both.
    unsafe {
        handle::read(learner, |handle| {
            structs::write(handle.report.get(), report, "report")
        })
    }
}

/// Why the last call on this learner failed that did fail, in words; an empty text
/// if none did. Calls that take the learner as const, and refusals with
/// CRITREG_BUSY or CRITREG_NOT_A_HANDLE, leave no words.
///
/// @param learner The learner; may be called from its callbacks.
/// @param text Receives the words, ended by NUL; 128 bytes are always enough.
/// @param len Length of text in bytes; 0 to ask for the length only.
/// @param needed NULL, or receives the length of the words with their NUL, also
/// if the buffer is too small.
/// @return CRITREG_TOO_SMALL (nothing but needed is written);
/// CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_learner_message(
    learner: *const critreg_learner,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for both.
    unsafe {
        handle::read(learner, |handle| {
            text::write(&handle.inner.message(), text, len, needed)
        })
    }
}
