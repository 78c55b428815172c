//! What a planner asks the program.

use crate::boundary::limits::CRITREG_MAX_PARAMETERS;
use crate::boundary::rng::critreg_rng;
use crate::boundary::status::{critreg_status, status_of};
use crate::boundary::structs::{self, Versioned};
use crate::planner::config::CRITREG_MAX_ARGUMENTS;
use crate::skill::handle::critreg_skills;
use core::ffi::{c_char, c_void};

/// A ground atom or a ground operator: a predicate, or a PDDL action, with its
/// objects.
///
/// Names are spelled as where they are declared, ended by NUL, and stay where they
/// are as long as the planner does.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct critreg_ground {
    /// Name of the predicate or action.
    pub name: *const c_char,
    /// Names of its objects, in order; NULL beyond the last.
    pub object_names: [*const c_char; CRITREG_MAX_ARGUMENTS],
    /// Which predicate or action it is: 0 for the first in the domain text.
    pub index: u32,
    /// How many objects it has.
    pub object_count: u32,
    /// Which objects: places among all objects and constants of the problem in the
    /// order of their names (by ASCII code, without regard to case); 0 beyond the
    /// last.
    pub objects: [u32; CRITREG_MAX_ARGUMENTS],
}

impl critreg_ground {
    /// No predicate and no action.
    pub(crate) const NONE: critreg_ground = critreg_ground {
        name: core::ptr::null(),
        object_names: [core::ptr::null(); CRITREG_MAX_ARGUMENTS],
        index: 0,
        object_count: 0,
        objects: [0; CRITREG_MAX_ARGUMENTS],
    };
}

/// A step of a plan skeleton whose parameters are to be drawn.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct critreg_draw {
    /// The operators of the whole skeleton: what comes later may narrow what is
    /// good now.
    pub skeleton: *const critreg_ground,
    /// How many there are.
    pub length: usize,
    /// The step to draw for, from 0; its operator is at this place of the skeleton.
    pub step: usize,
    /// The state before it.
    pub state: *const f64,
    /// How many numbers it has.
    pub state_len: usize,
    /// How many parameters are to be drawn: the ranges of
    /// critreg_planner_set_ranges(). May be 0.
    pub parameter_count: usize,
    /// Which try of the step in this state it is, from 1.
    pub attempt: u32,
    /// 1; or 0 once critreg_planner_config.patience is at its end: then draw as if
    /// nothing were known.
    pub advised: i32,
}

/// What was drawn.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct critreg_drawn {
    /// The parameters, within their ranges; hold NAN. execute gets just these.
    pub parameters: [f64; CRITREG_MAX_PARAMETERS],
    /// 1 if the parameters are from where they are expected to work, such as a
    /// learned region; holds 0.
    pub informed: i32,
    /// Why there are no parameters, if there are none; holds CRITREG_NO_REASON.
    pub reason: u32,
}

/// What to do with a sequence of operators: CRITREG_KEEP, CRITREG_POSTPONE or
/// CRITREG_PRUNE.
pub type critreg_advice = i32;

/// Go on with it.
pub const CRITREG_KEEP: critreg_advice = 0;
/// Leave it out, with everything that begins with it, until
/// critreg_planner_config.patience is at its end. The right advice from knowledge
/// that may be wrong, such as a learned region.
pub const CRITREG_POSTPONE: critreg_advice = 1;
/// Drop it, with everything that begins with it. For what is certain: a plan may
/// be lost.
pub const CRITREG_PRUNE: critreg_advice = 2;

/// How many reasons are counted one by one: numbers below this. A callback that
/// gives others, or none, is counted in critreg_metrics.uncounted.
pub const CRITREG_MAX_REASONS: u32 = 64;

/// No reason was given.
pub const CRITREG_NO_REASON: u32 = 0xFFFF;

/// Runs the controller of an operator in the program's simulator.
///
/// This and the other callbacks of a planner must return: no longjmp(), no C++
/// exception may leave them; see critreg_planner_recover(). They may not touch the memory of the planner, nor call
/// functions on it other than those that take it as const; the others return
/// CRITREG_BUSY. If one returns anything but CRITREG_OK, planning stops and
/// critreg_plan() returns that.
///
/// @param user_data What the program passed to critreg_plan().
/// @param ground The operator and its objects.
/// @param parameters Its parameters: CRITREG_MAX_PARAMETERS numbers, 0 beyond the
/// last.
/// @param before The state before.
/// @param after Holds a copy of it; receives the state afterwards, which may be
/// any if the operator fails.
/// @param len How many numbers a state has.
/// @param actions Receives how many low-level actions it took, at least 1; or 0,
/// which it is set to already, if the operator failed.
/// @return CRITREG_OK, also if the operator failed; CRITREG_CANCELLED, or
/// CRITREG_USER_STATUS and above.
pub type critreg_execute = Option<
    unsafe extern "C" fn(
        user_data: *mut c_void,
        ground: *const critreg_ground,
        parameters: *const f64,
        before: *const f64,
        after: *mut f64,
        len: usize,
        actions: *mut u32,
    ) -> critreg_status,
>;

/// Tells whether an atom holds in a state.
///
/// @param user_data What the program passed to critreg_plan().
/// @param ground The atom: a predicate and its objects.
/// @param state The state.
/// @param len How many numbers it has.
/// @param holds Receives 1 or 0.
/// @return CRITREG_OK, or what shall stop planning.
pub type critreg_holds = Option<
    unsafe extern "C" fn(
        user_data: *mut c_void,
        ground: *const critreg_ground,
        state: *const f64,
        len: usize,
        holds: *mut i32,
    ) -> critreg_status,
>;

/// Draws the parameters of a step, for instance with critreg_sample_regions().
/// Asked for operators without parameters, too: it may expect that they do not work.
///
/// @param user_data What the program passed to critreg_plan().
/// @param draw The step to draw for.
/// @param rng Random numbers. They follow from the seed of critreg_plan().
/// @param drawn Receives the parameters, or why there are none.
/// @return CRITREG_OK; CRITREG_EMPTY_REGION if no parameters are expected to work in
/// this state, upon which an earlier step is tried again; CRITREG_NO_SAMPLE if none were
/// found, which is a failed try like any other; or what shall stop planning. So what
/// critreg_sample_region() returned may be passed on.
pub type critreg_sample = Option<
    unsafe extern "C" fn(
        user_data: *mut c_void,
        draw: *const critreg_draw,
        rng: *mut critreg_rng,
        drawn: *mut critreg_drawn,
    ) -> critreg_status,
>;

/// Advises the search before anything is sampled for a sequence of operators. It is
/// asked when the search comes to the sequence; all shorter prefixes were kept.
///
/// @param user_data What the program passed to critreg_plan().
/// @param prefix The operators so far.
/// @param length How many there are, at least 1.
/// @param initial The state that planning begins in.
/// @param len How many numbers it has.
/// @param advice Receives what to do; holds CRITREG_KEEP.
/// @param reason Receives why, unless it is kept; holds CRITREG_NO_REASON.
/// @return CRITREG_OK, or what shall stop planning.
pub type critreg_advise = Option<
    unsafe extern "C" fn(
        user_data: *mut c_void,
        prefix: *const critreg_ground,
        length: usize,
        initial: *const f64,
        len: usize,
        advice: *mut critreg_advice,
        reason: *mut u32,
    ) -> critreg_status,
>;

/// What a planner asks the program. Fill it with critreg_callbacks_init() and set
/// at least execute and holds.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct critreg_callbacks {
    /// Size of this struct in bytes, from critreg_callbacks_init().
    pub struct_size: u32,
    /// 1: sequences of operators that skills expect not to work are dropped, and a plan may be
    /// lost. 0, the default: they are postponed, until critreg_planner_config.patience is at
    /// its end.
    pub prune: u32,
    /// Runs operators. Must be set.
    pub execute: critreg_execute,
    /// Tells what holds. Must be set.
    pub holds: critreg_holds,
    /// Draws parameters. NULL, the default: uniform over their ranges.
    pub sample: critreg_sample,
    /// Advises the search. NULL, the default: everything is kept.
    pub advise: critreg_advise,
    /// What was learned, or NULL, the default. Where something is known of a step, its
    /// parameters are drawn from that, and sample is asked where nothing is, or without
    /// advice; what cannot work is postponed before advise is asked. Actions have the
    /// parameters of their controllers. The skills are in use while critreg_plan() runs.
    pub skills: *mut critreg_skills,
}

// SAFETY: it is repr(C) and starts with struct_size.
unsafe impl Versioned for critreg_callbacks {
    const FIRST: usize = size_of::<critreg_callbacks>();
}

const NOTHING: critreg_callbacks = critreg_callbacks {
    struct_size: size_of::<critreg_callbacks>() as u32,
    prune: 0,
    execute: None,
    holds: None,
    sample: None,
    advise: None,
    skills: core::ptr::null_mut(),
};

impl critreg_callbacks {
    /// The callbacks at a pointer.
    ///
    /// # Safety
    /// If the pointer is not NULL and aligned, its `struct_size` is readable and as
    /// many bytes are.
    pub(crate) unsafe fn read(
        callbacks: *const critreg_callbacks,
    ) -> crate::boundary::status::Fallible<critreg_callbacks> {
        // SAFETY: by this function's contract; a callback is NULL or a function.
        unsafe { structs::read(callbacks, NOTHING, "callbacks") }
    }
}

/// Fills callbacks with the defaults.
///
/// @param callbacks The callbacks.
/// @param size sizeof *callbacks, as for critreg_config_init().
/// @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED; CRITREG_INVALID_ARGUMENT if
/// size is smaller than the struct ever was, or larger than this library knows.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_callbacks_init(
    callbacks: *mut critreg_callbacks,
    size: usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise.
    status_of(unsafe { structs::init(callbacks, size, NOTHING) })
}
