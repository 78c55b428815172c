//! What came of a trial, as C says it.

use crate::boundary::status::{Failure, Fallible};
use critreg_core::learn::Outcome;

/// What came of a trial: CRITREG_INFEASIBLE, CRITREG_FEASIBLE, CRITREG_UNKNOWN or
/// CRITREG_FAILED_STEP(k); see OUTCOMES above.
pub type critreg_outcome = i32;

/// The action failed. It is what false says. Of a sequence of actions it does not say
/// enough: use CRITREG_FAILED_STEP(k).
pub const CRITREG_INFEASIBLE: critreg_outcome = 0;
/// The action worked. It is what true says.
pub const CRITREG_FEASIBLE: critreg_outcome = 1;
/// There is no answer: the trial crashed, say, or took too long. It teaches nothing, and
/// the sample is put aside.
pub const CRITREG_UNKNOWN: critreg_outcome = 2;
/// What an outcome holds before a callback is to write it, so that one that was not
/// written is noticed. It is refused.
pub const CRITREG_NO_OUTCOME: critreg_outcome = i32::MIN;

/// The outcome with a number of the header, for a learner about so many steps; `None` is
/// for one that makes no difference between steps.
pub(crate) fn read(outcome: critreg_outcome, steps: Option<usize>) -> Fallible<Outcome> {
    let refused = |expected| Err(Failure::Number(expected, outcome));
    match outcome {
        CRITREG_NO_OUTCOME => Err(Failure::invalid("no outcome was written")),
        CRITREG_INFEASIBLE if steps.is_some_and(|steps| steps > 1) => {
            refused("the outcome of a sequence that failed is -k, for its step k")
        }
        CRITREG_INFEASIBLE => Ok(Outcome::FailedStep(1)),
        _ => match (Outcome::from_code(outcome), steps) {
            (Ok(Outcome::FailedStep(step)), Some(steps)) if usize::from(step) > steps => {
                refused("a failed step is -k, with k from 1 to the steps of the configuration")
            }
            (Ok(outcome), _) => Ok(outcome),
            (Err(_), _) => refused(
                "an outcome is 0 (infeasible), 1 (feasible), 2 (unknown) or -k (step k failed)",
            ),
        },
    }
}
