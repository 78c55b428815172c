//! Making a planner.

use crate::boundary::handle;
use crate::boundary::memory::ALIGNMENT;
use crate::boundary::pointer::{self, Output};
use crate::boundary::status::{Failure, Fallible, critreg_status, status_of};
use crate::boundary::text;
use crate::planner::config::{self, CRITREG_PDDL_TEXT_MAX, critreg_planner_config};
use crate::planner::handle::{Inner, Message, Words, critreg_planner, with_planner};
use crate::planner::layout::PlannerLayout;
use crate::planner::tables::{NO_ACTION, Ranges};
use core::cell::Cell;
use core::ffi::{c_char, c_void};

/// How many bytes of memory a planner takes.
///
/// Where the capacities are constants, CRITREG_PLANNER_WORDS() sizes a static array
/// instead.
///
/// @param config What the planner is to do, with its capacities.
/// @return The number of bytes; 0 if the configuration is wrong or memory cannot be
/// that large.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_planner_size(config: *const critreg_planner_config) -> usize {
    // SAFETY: the header makes it the caller's promise.
    let config = unsafe { config::read(config) };
    let capacity = config.and_then(|config| config.capacity());
    let layout = capacity.ok().and_then(PlannerLayout::new);
    layout.map_or(0, |layout| layout.size)
}

/// The alignment in bytes that the memory of a planner needs. An array of uint64_t
/// and what malloc() returns have it.
#[unsafe(no_mangle)]
pub extern "C" fn critreg_planner_align() -> usize {
    ALIGNMENT
}

/// Makes a planner for a problem, in memory of the program.
///
/// Operators and problem come as PDDL, see PLANNING above. Operators have no
/// parameters until critreg_planner_set_ranges() says so.
///
/// A planner needs no end: to plan another problem, make another planner in the
/// same memory.
///
/// @param memory Memory for the planner, aligned to critreg_planner_align(). From
/// now on it belongs to the planner: do not write to it, move it or copy it.
/// @param memory_len Its length in bytes, at least critreg_planner_size().
/// @param domain The PDDL domain, ended by NUL. Copied.
/// @param problem A PDDL problem of that domain, ended by NUL. Copied.
/// @param config How to plan, with the length of a state. Copied.
/// @param planner Receives the handle, which lies at the start of the memory.
/// @return CRITREG_TOO_SMALL if the memory is too short for the capacities;
/// CRITREG_SYNTAX_ERROR (ask critreg_check_pddl() where);
/// CRITREG_CAPACITY_EXCEEDED if the texts, the ground operators or the ground atoms
/// find no room; CRITREG_INVALID_ARGUMENT for a wrong configuration or a text that
/// is not UTF-8; CRITREG_NULL_POINTER, CRITREG_MISALIGNED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_planner_init(
    memory: *mut c_void,
    memory_len: usize,
    domain: *const c_char,
    problem: *const c_char,
    config: *const critreg_planner_config,
    planner: *mut *mut critreg_planner,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise.
    let made = unsafe {
        read_texts(domain, problem)
            .and_then(|texts| init(memory.cast(), memory_len, texts, config, planner))
    };
    status_of(made)
}

/// The domain and the problem text.
///
/// # Safety
/// If not NULL, the texts can be read up to their NUL.
pub(crate) unsafe fn read_texts<'a>(
    domain: *const c_char,
    problem: *const c_char,
) -> Fallible<[&'a str; 2]> {
    // SAFETY: by this function's contract.
    unsafe {
        Ok([
            pointer::text(domain, CRITREG_PDDL_TEXT_MAX, "domain")?,
            pointer::text(problem, CRITREG_PDDL_TEXT_MAX, "problem")?,
        ])
    }
}

/// # Safety
/// The contract of [`critreg_planner_init`].
unsafe fn init(
    memory: *mut u8,
    memory_len: usize,
    [domain, problem]: [&str; 2],
    config: *const critreg_planner_config,
    planner: *mut *mut critreg_planner,
) -> Fallible {
    pointer::check(memory.cast::<u64>(), "memory")?;
    // SAFETY: by this function's contract, for both.
    let (config, output) = unsafe { (config::read(config)?, Output::new(planner, "planner")?) };
    let settings = config.settings()?;
    let layout = PlannerLayout::new(config.capacity()?)
        .filter(|layout| layout.size <= memory_len)
        .ok_or(Failure::TooSmall("the memory of the planner"))?;
    // SAFETY: the memory was checked for NULL, alignment and length; the caller
    // lends it to this planner alone, and the parts of a layout do not overlap.
    unsafe {
        let place = layout.parts.handle.place(memory);
        // If this fails, a planner that was here before is one no more.
        handle::retire(place);
        let tables = layout.make(memory, domain, problem)?;
        let words = layout.parts.words.fill_with(memory, || Cell::new(0));
        critreg_planner::put(place, tables, settings, Words::new(words));
        output.write(place);
    }
    Ok(())
}

/// Says which continuous parameters the operators of a PDDL action have. Before,
/// and with a count of 0, they have none.
///
/// ```c
/// static const double ranges[][2] = {{0.0, 1.0}};
/// status = critreg_planner_set_ranges(planner, "PickStick", &ranges[0][0], 1);
/// ```
///
/// @param planner The planner.
/// @param name The name of the action, ended by NUL; case does not matter.
/// @param ranges The least and the greatest value of each parameter: 2 * count
/// numbers. NULL if count is 0. Copied.
/// @param count How many parameters there are, at most CRITREG_MAX_PARAMETERS.
/// @return CRITREG_INVALID_ARGUMENT if there is no such action, or a range is upside
/// down; CRITREG_CAPACITY_EXCEEDED for too many parameters; CRITREG_NOT_FINITE,
/// CRITREG_BUSY, CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_planner_set_ranges(
    planner: *mut critreg_planner,
    name: *const c_char,
    ranges: *const f64,
    count: usize,
) -> critreg_status {
    let set = |_: &critreg_planner, inner: &mut Inner| {
        // SAFETY: the header makes it the caller's promise.
        let ranges = unsafe { Ranges::read(ranges, count)? };
        // SAFETY: the header makes it the caller's promise.
        let place = unsafe { inner.tables.action(name)? };
        let slot = inner.tables.ranges.get_mut(place);
        *slot.ok_or(NO_ACTION)? = ranges;
        Ok(())
    };
    // SAFETY: as above.
    unsafe { with_planner(planner, set) }
}

/// Why the last call on this planner failed that did fail, in words, as
/// critreg_learner_message().
///
/// @param planner The planner; may be called from its callbacks.
/// @param text Receives the words, ended by NUL.
/// @param len Length of text in bytes; 0 to ask for the length only.
/// @param needed NULL, or receives the length of the words with their NUL, also
/// if the buffer is too small.
/// @return CRITREG_TOO_SMALL (nothing but needed is written);
/// CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_planner_message(
    planner: *const critreg_planner,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for both.
    unsafe {
        handle::read(planner, |handle| {
            text::write(&Message(handle), text, len, needed)
        })
    }
}
