//! What came of a trial.

use crate::error::Error;

/// What came of a sample.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Outcome {
    /// The action worked.
    Feasible,
    /// The action failed; in a sequence of actions, the number of the one that
    /// failed, from one.
    FailedStep(u8),
    /// There is no answer: the simulator crashed, say, or took too long. It teaches
    /// nothing, and the sample is put aside.
    #[default]
    Unknown,
}

impl Outcome {
    /// The outcome of a single action.
    pub const fn from_feasible(feasible: bool) -> Outcome {
        if feasible {
            Outcome::Feasible
        } else {
            Outcome::FailedStep(1)
        }
    }

    /// Whether the action is known to have worked.
    pub const fn is_feasible(self) -> bool {
        matches!(self, Outcome::Feasible)
    }

    /// The label of the sample: whether the action worked; `None` if that is unknown.
    pub const fn label(self) -> Option<bool> {
        match self {
            Outcome::Feasible => Some(true),
            Outcome::FailedStep(_) => Some(false),
            Outcome::Unknown => None,
        }
    }

    /// As a number, in saved bytes and in C: 1 if the action worked, -k if step k failed,
    /// 2 if that is unknown.
    pub const fn code(self) -> i32 {
        match self {
            Outcome::Feasible => 1,
            Outcome::FailedStep(step) => -(step as i32),
            Outcome::Unknown => 2,
        }
    }

    /// The outcome with this code.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] for a number that is the code of none; 0, which says
    /// that some step failed but not which, is none either.
    pub fn from_code(code: i32) -> Result<Outcome, Error> {
        match code {
            1 => Ok(Outcome::Feasible),
            2 => Ok(Outcome::Unknown),
            _ => match u8::try_from(code.unsigned_abs()) {
                Ok(step) if code < 0 => Ok(Outcome::FailedStep(step)),
                _ => Err(Error::InvalidArgument(
                    "an outcome is 1 (works), -k (step k failed, at most 255) or 2 (unknown)",
                )),
            },
        }
    }
}
