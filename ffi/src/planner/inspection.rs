//! What is asked about the last planning: what it cost, what stood in its way.

use crate::boundary::handle;
use crate::boundary::pointer::Output;
use crate::boundary::status::{Failure, critreg_status};
use crate::boundary::structs;
use crate::boundary::text;
use crate::planner::callbacks::CRITREG_MAX_REASONS;
use crate::planner::handle::{Inner, critreg_planner, with_planner};
use crate::planner::metrics::critreg_metrics;
use core::ffi::c_char;

/// What the last critreg_plan() cost, however it ended.
///
/// @param planner The planner; may be called from its callbacks.
/// @param metrics Metrics from critreg_metrics_init(), to be filled.
/// @return CRITREG_INVALID_ARGUMENT if the metrics were not initialised;
/// CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_planner_metrics(
    planner: *const critreg_planner,
    metrics: *mut critreg_metrics,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for both.
    unsafe {
        handle::read(planner, |handle| {
            structs::write(handle.metrics.get(), metrics, "metrics")
        })
    }
}

/// How often steps of a PDDL action failed in the last critreg_plan().
///
/// @param planner The planner.
/// @param name The name of the action, ended by NUL; case does not matter.
/// @param count Receives how often.
/// @return CRITREG_INVALID_ARGUMENT if there is no such action; CRITREG_BUSY,
/// CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_planner_failures(
    planner: *mut critreg_planner,
    name: *const c_char,
    count: *mut u32,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_planner(planner, |_, inner: &mut Inner| {
            let output = Output::new(count, "count")?;
            let failures = inner.tables.failures.get(inner.tables.action(name)?);
            output.write(failures.copied().unwrap_or(0));
            Ok(())
        })
    }
}

/// How often a reason was given in the last critreg_plan().
///
/// @param planner The planner.
/// @param reason The number of the reason, below CRITREG_MAX_REASONS.
/// @param count Receives how often.
/// @return CRITREG_INVALID_ARGUMENT for a larger number; CRITREG_BUSY,
/// CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_planner_reasons(
    planner: *mut critreg_planner,
    reason: u32,
    count: *mut u32,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for both.
    unsafe {
        with_planner(planner, |_, inner: &mut Inner| {
            let output = Output::new(count, "count")?;
            let own = Some(reason).filter(|reason| *reason < CRITREG_MAX_REASONS);
            let counted = own.and_then(|reason| inner.tables.reasons.get(reason as usize));
            let none = Failure::invalid("reasons are counted below CRITREG_MAX_REASONS");
            output.write(*counted.ok_or(none)?);
            Ok(())
        })
    }
}

/// What stood in the way most often in the last critreg_plan(), in the words of the skills,
/// such as "RobotPressButton(robby, button0, stick) needs button0.y <= 2.9, and it is 4.1"; also if a plan
/// was found. Empty if it is a reason of the program, or if there is none.
///
/// @param planner The planner; may be called from its callbacks.
/// @param text Receives the words, ended by NUL; CRITREG_REASON_MAX bytes are always enough.
/// @param len Length of text in bytes; 0 to ask for the length only.
/// @param needed NULL, or receives the length of the words with their NUL, also if the buffer
/// is too small.
/// @return CRITREG_TOO_SMALL (nothing but needed is written); CRITREG_NULL_POINTER,
/// CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_planner_reason_text(
    planner: *const critreg_planner,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for both.
    unsafe {
        handle::read(planner, |handle| {
            text::write(&handle.words, text, len, needed)
        })
    }
}
