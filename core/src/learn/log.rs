//! The observations of a learner, and saving and resuming a run by replaying them.
//!
//! | bytes | content (little endian) |
//! |---|---|
//! | 4 | `CRLG` |
//! | 2 | version |
//! | 4 | fingerprint of the problem |
//! | 4 | fingerprint of the learner |
//! | 2 | number of parameters n |
//! | 4 | number of observations |
//! | 8 + 8 n each | instance, outcome ([`Outcome::code`]), parameters |
//! | 4 | CRC-32 of all before |

use super::problem::Problem;
use super::{Learner, Outcome, Query};
use crate::domain::MAX_PARAMETERS;
use crate::error::Error;
use crate::region::Theta;
use crate::table::Blank;
use crate::wire::{FRAME, Reader, Writer};

const MAGIC: &[u8; 4] = b"CRLG";
const VERSION: u16 = 2;
const HEADER: usize = 4 + 4 + 2 + 4;

/// A sample that was tried and what came of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Observation {
    /// Index of the problem instance.
    pub instance: u32,
    /// What came of it.
    pub outcome: Outcome,
    /// The parameters of the action.
    pub theta: Theta,
}

impl Blank for Observation {
    const BLANK: Self = Observation {
        instance: 0,
        outcome: Outcome::Unknown,
        theta: [0.0; MAX_PARAMETERS],
    };
}

impl Observation {
    /// What came of a query.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] if the failed step is zero.
    pub fn new(query: &Query, outcome: Outcome) -> Result<Self, Error> {
        if outcome == Outcome::FailedStep(0) {
            return Err(Error::InvalidArgument("steps are counted from one"));
        }
        let instance = u32::try_from(query.instance)
            .map_err(|_| Error::InvalidArgument("too many instances"))?;
        Ok(Observation {
            instance,
            outcome,
            theta: query.theta,
        })
    }
}

/// How many bytes [`save`] needs for a learner in its present state.
pub fn saved_len(learner: &(impl Learner + ?Sized), problem: &Problem<'_>) -> usize {
    let each = 8 + 8 * problem.domain().parameters().len();
    FRAME + HEADER + each * learner.observations().len()
}

/// Writes what a learner was told into `bytes` and returns how many were used.
///
/// # Errors
/// [`Error::CapacityExceeded`] if `bytes` is shorter than [`saved_len`].
pub fn save(
    learner: &(impl Learner + ?Sized),
    problem: &Problem<'_>,
    bytes: &mut [u8],
) -> Result<usize, Error> {
    const TOO_MANY: Error = Error::CapacityExceeded("observations to save");
    let observations = learner.observations();
    let parameters = problem.domain().parameters().len();
    let mut writer = Writer::new(bytes, MAGIC, VERSION);
    writer.u32(problem.fingerprint());
    writer.u32(learner.fingerprint());
    writer.u16(u16::try_from(parameters).map_err(|_| TOO_MANY)?);
    writer.u32(u32::try_from(observations.len()).map_err(|_| TOO_MANY)?);
    for observation in observations {
        writer.u32(observation.instance);
        writer.i32(observation.outcome.code());
        for value in observation.theta.iter().take(parameters) {
            writer.f64(*value);
        }
    }
    writer.finish("bytes for a saved learner")
}

/// Brings a fresh learner to the state that [`save`] wrote, by asking it the same
/// questions and telling it the same answers.
///
/// # Errors
/// [`Error::Corrupt`] for damaged bytes, [`Error::Mismatch`] if they were saved
/// for another problem or configuration, [`Error::CapacityExceeded`] if there is
/// no room for all observations, [`Error::OutOfSequence`] if the learner is not
/// fresh: then nothing was told.
pub fn resume<L: Learner + ?Sized>(
    learner: &mut L,
    problem: &Problem<'_>,
    bytes: &[u8],
) -> Result<(), Error> {
    if !learner.observations().is_empty() {
        return Err(Error::OutOfSequence(
            "resume before the first answer is told",
        ));
    }
    let mut reader = Reader::new(bytes, MAGIC, VERSION)?;
    if reader.u32()? != problem.fingerprint() {
        return Err(Error::Mismatch(
            "saved for another domain or other instances",
        ));
    }
    if reader.u32()? != learner.fingerprint() {
        return Err(Error::Mismatch(
            "saved with another configuration or capacity",
        ));
    }
    let parameters = reader.u16()?;
    let count = reader.u32()?;
    if usize::try_from(count).map_or(true, |count| count > learner.room()) {
        return Err(Error::CapacityExceeded("observations"));
    }
    for _ in 0..count {
        let instance = reader.u32()?;
        let outcome = Outcome::from_code(reader.i32()?)
            .map_err(|_| Error::Corrupt("a saved outcome is none"))?;
        let mut theta = [0.0; MAX_PARAMETERS];
        for value in theta.iter_mut().take(usize::from(parameters)) {
            *value = reader.f64()?;
        }
        let saved = Observation {
            instance,
            outcome,
            theta,
        };
        replay(learner, problem, &saved)?;
    }
    reader.finish()
}

fn replay(
    learner: &mut (impl Learner + ?Sized),
    problem: &Problem<'_>,
    saved: &Observation,
) -> Result<(), Error> {
    let query = learner.ask(problem)?;
    if Observation::new(&query, saved.outcome)? != *saved {
        return Err(Error::Mismatch(
            "the saved samples are not those of this learner",
        ));
    }
    learner.tell(problem, saved.outcome)
}
