//! A planner in the caller's memory.

use crate::boundary::handle::{self, Handle};
use crate::boundary::memory::ALIGNMENT;
use crate::boundary::pointer::{self, Output};
use crate::boundary::status::{
    CRITREG_BUSY, CRITREG_OK, Failure, Fallible, Message, critreg_status, status_of,
};
use crate::boundary::text;
use crate::planner_config::{self, critreg_planner_config};
use crate::planner_layout::{PlannerLayout, Ranges, Tables};
use crate::planner_metrics::critreg_metrics;
use core::cell::{Cell, RefCell};
use core::ffi::{c_char, c_void};
use core::fmt;
use critreg_core::Error;
use critreg_core::domain::MAX_PARAMETERS;
use critreg_core::pddl::Problem;
use critreg_core::plan;
use critreg_core::task::GroundAtom;

/// Longest domain or problem text of a planner in bytes, with its NUL.
pub const CRITREG_PDDL_TEXT_MAX: usize = 65_536;

/// A planner for one problem. It lies at the start of the memory it was made in.
pub struct critreg_planner {
    seal: usize,
    /// What the last call left behind, also readable from a callback.
    pub(crate) metrics: Cell<critreg_metrics>,
    message: Cell<Option<Failure>>,
    /// The atom that the last failure is about, if it is one.
    pub(crate) culprit: Cell<Option<GroundAtom>>,
    problem: &'static Problem<'static>,
    inner: RefCell<Inner>,
}

/// What a call on a planner borrows.
pub(crate) struct Inner {
    pub(crate) tables: Tables,
    pub(crate) settings: plan::Config,
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
    let handle = match unsafe { handle::open(planner) } {
        Ok(handle) => handle,
        Err(failure) => return failure.status(),
    };
    let Ok(mut inner) = handle.inner.try_borrow_mut() else {
        return CRITREG_BUSY;
    };
    match body(handle, &mut inner) {
        Ok(()) => CRITREG_OK,
        Err(failure) => {
            handle.message.set(Some(failure));
            failure.status()
        }
    }
}

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
    let config = unsafe { planner_config::read(config) };
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
    let (config, output) = unsafe {
        (
            planner_config::read(config)?,
            Output::new(planner, "planner")?,
        )
    };
    let settings = config.settings()?;
    let layout = PlannerLayout::new(config.capacity()?)
        .filter(|layout| layout.size <= memory_len)
        .ok_or(Failure::TooSmall("the memory of the planner"))?;
    // SAFETY: the memory was checked for NULL, alignment and length; the caller
    // lends it to this planner alone, and the parts of a layout do not overlap.
    unsafe {
        let place = layout.handle.place(memory);
        // If this fails, a planner that was here before is one no more.
        handle::retire(place);
        let tables = layout.make(memory, domain, problem)?;
        let made = critreg_planner {
            seal: 0,
            metrics: Cell::new(critreg_metrics::NONE),
            message: Cell::new(None),
            culprit: Cell::new(None),
            problem: tables.problem,
            inner: RefCell::new(Inner {
                tables,
                settings,
                plan_length: 0,
            }),
        };
        handle::put(place, made);
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
        if count > MAX_PARAMETERS {
            return Err(Error::CapacityExceeded("parameters of an operator").into());
        }
        let numbers = match count {
            0 => &[],
            // SAFETY: the header makes it the caller's promise.
            _ => unsafe { pointer::slice(ranges, 2 * count, "ranges")? },
        };
        if !numbers.iter().all(|number| number.is_finite()) {
            return Err(Error::NotFinite("an end of a range").into());
        }
        let (ranges, _) = numbers.as_chunks();
        if ranges.iter().any(|[low, high]| low > high) {
            return Err(Failure::invalid("a range ends below its beginning"));
        }
        // SAFETY: the header makes it the caller's promise.
        let place = unsafe { inner.action(name)? };
        let slot = inner.tables.ranges.get_mut(place);
        *slot.ok_or(NO_ACTION)? = Ranges::new(ranges);
        Ok(())
    };
    // SAFETY: as above.
    unsafe { with_planner(planner, set) }
}

const NO_ACTION: Failure = Failure::invalid("the PDDL domain has no action of this name");

impl Inner {
    /// The place of the action with a name.
    ///
    /// # Safety
    /// If not NULL, the name can be read up to its NUL.
    pub(crate) unsafe fn action(&self, name: *const c_char) -> Fallible<usize> {
        // SAFETY: by this function's contract.
        let name = unsafe { pointer::text(name, CRITREG_PDDL_TEXT_MAX, "name")? };
        let found = self.tables.problem.domain().find_action(name);
        Ok(usize::from(found.ok_or(NO_ACTION)?.0))
    }
}

/// A failure, and the atom it is about.
struct Words<'a>(&'a critreg_planner);

impl fmt::Display for Words<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Words(handle) = self;
        Message(handle.message.get()).fmt(f)?;
        match handle.culprit.get() {
            Some(atom) => write!(f, ": {}", handle.problem.atom_text(&atom)),
            None => Ok(()),
        }
    }
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
        let handle = handle::open(planner);
        status_of(handle.and_then(|handle| text::write(&Words(handle), text, len, needed)))
    }
}
