//! What planning cost, and what stood in its way, for C.

use crate::boundary::status::{Failure, Fallible, critreg_status, status_of};
use crate::boundary::structs::{self, Versioned};
use crate::planner::callbacks::CRITREG_NO_REASON;
use crate::planner::names::Names;
use core::ffi::c_char;
use critreg_core::Error;
use critreg_core::plan::{Conclusion, Metrics, ReasonId};

/// For critreg_metrics.conclusion: nothing was planned yet, or the call was refused
/// before planning began.
pub const CRITREG_NOT_PLANNED: u32 = 0;
/// There is a plan.
pub const CRITREG_SOLVED: u32 = 1;
/// No further sequence of operators reaches the goal: there is no plan, or it was
/// pruned, or it needs other samples.
pub const CRITREG_EXHAUSTED: u32 = 2;
/// Likewise, but some sequences were not extended beyond
/// critreg_planner_config.max_length.
pub const CRITREG_LENGTH_SPENT: u32 = 3;
/// critreg_planner_config.max_skeletons were refined in vain.
pub const CRITREG_SKELETONS_SPENT: u32 = 4;
/// critreg_planner_config.max_samples were drawn.
pub const CRITREG_SAMPLES_SPENT: u32 = 5;
/// The memory is full; critreg_planner_message() says which.
pub const CRITREG_MEMORY_FULL: u32 = 6;
/// A callback stopped planning. Then the counts are 0, except those of
/// critreg_planner_failures() and critreg_planner_reasons().
pub const CRITREG_STOPPED: u32 = 7;

/// What the last critreg_plan() cost, and what stood in its way.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct critreg_metrics {
    /// Size of this struct in bytes, from critreg_metrics_init().
    pub struct_size: u32,
    /// How planning ended: CRITREG_SOLVED or another code.
    pub conclusion: u32,
    /// Operators in the plan.
    pub plan_length: u32,
    /// Tries of a step: parameters were drawn and execute was called, or
    /// CRITREG_NO_SAMPLE was returned. Steps without parameters count too, so the length
    /// of the plan is the least.
    pub samples: u32,
    /// Plan skeletons that were refined.
    pub skeletons: u32,
    /// Sequences of operators that were extended by one.
    pub nodes_expanded: u32,
    /// Sequences of operators that were created, the empty one included.
    pub nodes_created: u32,
    /// Sequences that advise pruned.
    pub pruned: u32,
    /// Sequences that advise postponed: they were left out until patience ended.
    pub postponed: u32,
    /// Sequences that were not extended because of their length.
    pub cut_off: u32,
    /// Draws that ended with CRITREG_EMPTY_REGION.
    pub empty_draws: u32,
    /// Draws that were informed; see critreg_drawn.
    pub informed_draws: u32,
    /// 1 if critreg_planner_config.patience ended, so that planning began anew
    /// without advice; else 0.
    pub patience_ended: u32,
    /// Reasons that were not given, or not below CRITREG_MAX_REASONS.
    pub uncounted: u32,
    /// Low-level actions that execute told of.
    pub actions: u64,
    /// The PDDL action whose steps failed most often; NULL if none did. The name
    /// stays where it is as long as the planner does.
    pub most_failed: *const c_char,
    /// The reason that was given most often: why no plan was found.
    /// CRITREG_NO_REASON if none was.
    pub main_reason: u32,
    /// Sequences that were not extended at first, as enough others lead to the same
    /// abstract state; see critreg_planner_config.skeletons_per_state.
    pub repeated: u32,
}

// SAFETY: it is repr(C) and starts with struct_size.
unsafe impl Versioned for critreg_metrics {
    const FIRST: usize = size_of::<critreg_metrics>();
}

impl critreg_metrics {
    /// Of no planning.
    pub(crate) const NONE: critreg_metrics = critreg_metrics {
        struct_size: size_of::<critreg_metrics>() as u32,
        conclusion: CRITREG_NOT_PLANNED,
        plan_length: 0,
        samples: 0,
        skeletons: 0,
        nodes_expanded: 0,
        nodes_created: 0,
        pruned: 0,
        postponed: 0,
        cut_off: 0,
        empty_draws: 0,
        informed_draws: 0,
        patience_ended: 0,
        uncounted: 0,
        actions: 0,
        most_failed: core::ptr::null(),
        main_reason: CRITREG_NO_REASON,
        repeated: 0,
    };

    /// Of a planning that a callback stopped.
    pub(crate) const STOPPED: critreg_metrics = critreg_metrics {
        conclusion: CRITREG_STOPPED,
        ..critreg_metrics::NONE
    };

    /// Of a planning that ended.
    pub(crate) fn new(conclusion: Conclusion, metrics: &Metrics<'_>, names: &Names) -> Self {
        let most_failed = metrics.most_failed().map(|o| names.action(o.0));
        let reason = metrics.main_reason().map(|ReasonId(id)| u32::from(id));
        critreg_metrics {
            conclusion: match conclusion {
                Conclusion::Solved => CRITREG_SOLVED,
                Conclusion::Exhausted => CRITREG_EXHAUSTED,
                Conclusion::LengthSpent => CRITREG_LENGTH_SPENT,
                Conclusion::SkeletonsSpent => CRITREG_SKELETONS_SPENT,
                Conclusion::SamplesSpent => CRITREG_SAMPLES_SPENT,
                Conclusion::Full(_) => CRITREG_MEMORY_FULL,
            },
            plan_length: metrics.plan_length,
            samples: metrics.samples,
            skeletons: metrics.skeletons,
            nodes_expanded: metrics.nodes_expanded,
            nodes_created: metrics.nodes_created,
            pruned: metrics.pruned,
            postponed: metrics.postponed,
            cut_off: metrics.cut_off,
            empty_draws: metrics.empty_draws,
            informed_draws: metrics.informed_draws,
            patience_ended: u32::from(metrics.advised.is_some()),
            uncounted: metrics.uncounted,
            repeated: metrics.repeated,
            actions: metrics.actions,
            most_failed: most_failed.unwrap_or(core::ptr::null()),
            main_reason: reason.unwrap_or(CRITREG_NO_REASON),
            ..critreg_metrics::NONE
        }
    }
}

/// What a planning that ended comes to.
pub(crate) fn verdict(conclusion: Conclusion) -> Fallible {
    let how = match conclusion {
        Conclusion::Solved => return Ok(()),
        Conclusion::Full(what) => return Err(Error::CapacityExceeded(what).into()),
        Conclusion::Exhausted => "no sequence of operators is left that reaches the goal",
        Conclusion::LengthSpent => "no sequence of up to max_length operators is left",
        Conclusion::SkeletonsSpent => "max_skeletons were refined in vain",
        Conclusion::SamplesSpent => "max_samples were drawn in vain",
    };
    Err(Failure::NoPlan(how))
}

/// Fills metrics, so that critreg_planner_metrics() knows their size.
///
/// @param metrics The metrics.
/// @param size sizeof *metrics, as for critreg_config_init().
/// @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED; CRITREG_INVALID_ARGUMENT if
/// size is smaller than the struct ever was, or larger than this library knows.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_metrics_init(
    metrics: *mut critreg_metrics,
    size: usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise.
    status_of(unsafe { structs::init(metrics, size, critreg_metrics::NONE) })
}
