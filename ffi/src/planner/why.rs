//! Why there is no plan, as a code and a sentence.

use crate::boundary::handle;
use crate::boundary::pointer::Output;
use crate::boundary::status::critreg_status;
use crate::boundary::text;
use crate::planner::handle::{Words, critreg_planner};
use core::ffi::c_char;
use core::fmt;
use critreg_core::pddl::{Missing, Problem};
use critreg_core::plan::{Config, Metrics, Planned, Why};
use critreg_core::task::OperatorId;

/// For critreg_planner_why(): there is a plan, or nothing was planned yet.
pub const CRITREG_WHY_NOTHING: u32 = 0;
/// An atom of the goal cannot be reached, whatever is done: the sentence names it, and
/// what is missing.
pub const CRITREG_WHY_UNREACHABLE: u32 = 1;
/// No sequence of actions reaches the goal, however long.
pub const CRITREG_WHY_NO_SKELETON: u32 = 2;
/// The callback advise, or skills, pruned all sequences that reach the goal.
pub const CRITREG_WHY_PRUNED: u32 = 3;
/// No sequence of up to critreg_planner_config.max_length actions reaches the goal.
pub const CRITREG_WHY_LENGTH: u32 = 4;
/// Steps with parameters failed critreg_planner_config.max_tries times, while samples were
/// left.
pub const CRITREG_WHY_TRIES: u32 = 5;
/// Steps without parameters failed: the simulator does not do what the text says.
pub const CRITREG_WHY_WORLD: u32 = 6;
/// critreg_planner_config.max_skeletons were refined in vain.
pub const CRITREG_WHY_SKELETONS: u32 = 7;
/// critreg_planner_config.max_samples were drawn in vain.
pub const CRITREG_WHY_SAMPLES: u32 = 8;
/// The memory is full.
pub const CRITREG_WHY_MEMORY: u32 = 9;
/// A callback stopped planning.
pub const CRITREG_WHY_STOPPED: u32 = 10;

/// What is known of the end of a planning.
#[derive(Clone, Copy)]
pub(crate) enum Reason {
    /// Nothing is to be said.
    Nothing,
    /// A callback stopped planning.
    Stopped,
    /// There is no plan.
    NoPlan(NoPlan),
}

/// Why there is no plan, with numbers.
#[derive(Clone, Copy)]
pub(crate) struct NoPlan {
    why: Why,
    missing: Option<Missing>,
    most_failed: Option<OperatorId>,
    samples: u32,
    skeletons: u32,
    config: Config,
}

impl Reason {
    /// Of a planning that ended.
    pub(crate) fn new<S, const N: usize>(
        planned: &Planned<'_, S, N>,
        missing: Option<Missing>,
        config: &Config,
    ) -> Reason {
        let metrics: &Metrics<'_> = &planned.metrics;
        let Some(why) = Why::new(planned.conclusion, metrics, config) else {
            return Reason::Nothing;
        };
        Reason::NoPlan(NoPlan {
            why,
            missing,
            most_failed: metrics.most_failed(),
            samples: metrics.samples,
            skeletons: metrics.skeletons,
            config: *config,
        })
    }

    fn code(&self) -> u32 {
        match self {
            Reason::Nothing => CRITREG_WHY_NOTHING,
            Reason::Stopped => CRITREG_WHY_STOPPED,
            Reason::NoPlan(no_plan) => match no_plan.why {
                Why::NoSkeleton if no_plan.missing.is_some() => CRITREG_WHY_UNREACHABLE,
                Why::NoSkeleton => CRITREG_WHY_NO_SKELETON,
                Why::Pruned => CRITREG_WHY_PRUNED,
                Why::Length => CRITREG_WHY_LENGTH,
                Why::Tries => CRITREG_WHY_TRIES,
                Why::World => CRITREG_WHY_WORLD,
                Why::Skeletons => CRITREG_WHY_SKELETONS,
                Why::Samples => CRITREG_WHY_SAMPLES,
                Why::Memory(_) => CRITREG_WHY_MEMORY,
            },
        }
    }
}

/// The sentence.
struct Sentence<'a>(&'a Reason, &'a Problem<'static>, &'a Words);

impl fmt::Display for Sentence<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Sentence(reason, problem, words) = self;
        match reason {
            Reason::Nothing => return Ok(()),
            Reason::Stopped => return f.write_str("a callback stopped planning"),
            Reason::NoPlan(no_plan) => no_plan.write(problem, f)?,
        }
        if words.is_empty() {
            return Ok(());
        }
        write!(f, "; most often in the way: {words}")
    }
}

impl NoPlan {
    fn write(&self, problem: &Problem<'_>, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let NoPlan {
            samples, skeletons, ..
        } = self;
        let config = &self.config;
        let failed = self.most_failed.and_then(|OperatorId(id)| {
            let action = problem.domain().actions().get(usize::from(id));
            action.map(|action| action.name)
        });
        let failed = failed.unwrap_or("none");
        match (self.why, self.missing) {
            (Why::NoSkeleton, Some(missing)) => {
                write!(
                    f,
                    "the goal cannot be reached: {}",
                    problem.missing_text(missing)
                )
            }
            (Why::NoSkeleton, None) => {
                f.write_str("no sequence of actions reaches the goal, however long")
            }
            (Why::Pruned, _) => f.write_str("advice pruned every sequence that reaches the goal"),
            (Why::Length, _) => write!(
                f,
                "no sequence of up to {} actions reaches the goal: raise max_length",
                config.max_length
            ),
            (Why::Tries, _) => write!(
                f,
                "{skeletons} skeletons were given up after {} tries of a step, most often of \
                 {failed}, with {samples} of {} samples: raise max_tries",
                config.max_tries, config.max_samples
            ),
            (Why::World, _) => write!(
                f,
                "{skeletons} skeletons were given up at a step without parameters, most often \
                 {failed}: it does not do what its text says"
            ),
            (Why::Skeletons, _) => write!(
                f,
                "{skeletons} skeletons were refined in vain, most often failed {failed}: raise \
                 max_skeletons"
            ),
            (Why::Samples, _) => write!(
                f,
                "{samples} samples were drawn in vain, most often failed {failed}: raise \
                 max_samples"
            ),
            (Why::Memory(what), _) => write!(f, "no room left: {what}"),
        }
    }
}

/// Why the last critreg_plan() found no plan: what stood in the way, and what to change
/// first. critreg_planner_metrics() has the numbers.
///
/// ```c
/// if (critreg_plan(planner, &callbacks, state, 1, NULL, NULL) == CRITREG_NO_PLAN
///     && critreg_planner_why(planner, &why, text, sizeof text, NULL) == CRITREG_OK)
///     puts(text);   // the goal cannot be reached: nothing reaches (At roof), as Climb ...
/// ```
///
/// @param planner The planner; may be called from its callbacks.
/// @param why Receives CRITREG_WHY_UNREACHABLE or another code.
/// @param text Receives the sentence, ended by NUL; empty for CRITREG_WHY_NOTHING.
/// @param len Length of text in bytes; 0 to ask for the length only.
/// @param needed NULL, or receives the length of the sentence with its NUL, also
/// if the buffer is too small.
/// @return CRITREG_TOO_SMALL (of text nothing is written); CRITREG_NULL_POINTER,
/// CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_planner_why(
    planner: *const critreg_planner,
    why: *mut u32,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        handle::read(planner, |handle| {
            let reason = handle.reason.get();
            Output::new(why, "why")?.write(reason.code());
            let sentence = Sentence(&reason, handle.problem(), &handle.words);
            text::write(&sentence, text, len, needed)
        })
    }
}
