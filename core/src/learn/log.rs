//! The observations of a learner, and saving and resuming a run by replaying them.
//!
//! | bytes | content (little endian) |
//! |---|---|
//! | 4 | `CRLG` |
//! | 2 | version |
//! | 4 | fingerprint of the problem |
//! | 4 | number of its instances |
//! | 4 | fingerprint of the learner |
//! | 2 | number of parameters n |
//! | 2 | what the learner did since the last observation |
//! | 4 | number of observations |
//! | 4 | number of questions that were asked |
//! | 4 | number of observations that are no longer kept |
//! | 4 | number of those whose answers are not taken in |
//! | 8 + 8 n each | an observation: instance (4), outcome (2, [`Outcome::code`]), what it was asked for, if it was, and what the learner did before (2), parameters |
//! | 18 + 8 n each | such a question: id (8), what became of it (2), and as an observation, with the outcome that waits |
//! | 4 | CRC-32 of all before |
//!
//! What a learner did follows from the observations and the notes beside them, so nothing is
//! asked again to resume it.

use super::problem::{Begun, Problem};
use super::question::{PURPOSE, Purpose, Question, State, Trial};
use super::{Learner, OBSERVATIONS_FULL, Outcome, Query};
use crate::domain::MAX_PARAMETERS;
use crate::error::Error;
use crate::region::Theta;
use crate::table::Blank;
use crate::wire::{FRAME, Reader, Writer};

const MAGIC: &[u8; 4] = b"CRLG";
const VERSION: u16 = 4;
const HEADER: usize = 4 + 4 + 4 + 2 + 2 + 4 + 4 + 4 + 4;

/// A sample that was tried and what came of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Observation {
    /// Index of the problem instance.
    pub instance: u32,
    /// What came of it.
    pub outcome: Outcome,
    /// What it was asked for and what the learner did before, as the learner notes it.
    pub(super) notes: u16,
    /// The parameters of the action.
    pub theta: Theta,
}

/// What a learner knows of a run beside what was told.
#[derive(Clone, Copy, Debug, Default)]
pub struct Notes {
    /// What was done since the last observation.
    pub since: u16,
    /// Questions that were asked.
    pub asked: u32,
    /// Observations that are no longer kept.
    pub dropped: usize,
}

impl Blank for Observation {
    const BLANK: Self = Observation {
        instance: 0,
        outcome: Outcome::Unknown,
        notes: 0,
        theta: [0.0; MAX_PARAMETERS],
    };
}

impl Observation {
    /// What came of a query that was asked.
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
            notes: 0,
            theta: query.theta,
        })
    }

    /// Whether the learner asked for it.
    pub fn asked(&self) -> bool {
        self.notes & PURPOSE != Purpose::Told as u16
    }

    /// The sample.
    pub fn query(&self) -> Query {
        Query {
            instance: self.instance as usize,
            theta: self.theta,
        }
    }

    /// How many bytes it takes to write one.
    pub(super) fn saved_len(problem: &Problem<'_>) -> usize {
        8 + 8 * problem.domain().parameters().len()
    }

    pub(super) fn write(&self, writer: &mut Writer<'_>, problem: &Problem<'_>) {
        writer.u32(self.instance);
        // From -255 to 2.
        writer.i16(self.outcome.code() as i16);
        writer.u16(self.notes);
        for (value, _) in self.theta.iter().zip(problem.domain().parameters()) {
            writer.f64(*value);
        }
    }

    pub(super) fn read(reader: &mut Reader<'_>, problem: &Problem<'_>) -> Result<Self, Error> {
        let instance = reader.u32()?;
        let outcome = Outcome::from_code(reader.i16()?.into())
            .map_err(|_| Error::Corrupt("a saved outcome is none"))?;
        let notes = reader.u16()?;
        let mut theta = [0.0; MAX_PARAMETERS];
        for (value, _) in theta.iter_mut().zip(problem.domain().parameters()) {
            *value = reader.f64()?;
        }
        Ok(Observation {
            instance,
            outcome,
            notes,
            theta,
        })
    }
}

/// Bytes of a question that is open, beside those of an observation.
const TRIAL: usize = 8 + 2;

impl Trial {
    fn write(&self, writer: &mut Writer<'_>, problem: &Problem<'_>) -> Result<(), Error> {
        let (state, outcome) = match self.state {
            State::Open => (0, Outcome::Unknown),
            State::Again => (1, Outcome::Unknown),
            State::Forgotten => (2, Outcome::Unknown),
            State::Answered(outcome) => (3, outcome),
        };
        writer.u64(self.question.id);
        writer.u16(state);
        let observation = Observation {
            notes: self.purpose as u16,
            ..Observation::new(self.query(), outcome)?
        };
        observation.write(writer, problem);
        Ok(())
    }

    fn read(reader: &mut Reader<'_>, problem: &Problem<'_>) -> Result<Self, Error> {
        let (id, state) = (reader.u64()?, reader.u16()?);
        let observation = Observation::read(reader, problem)?;
        let query = observation.query();
        Ok(Trial {
            state: match state {
                0 => State::Open,
                1 => State::Again,
                2 => State::Forgotten,
                3 => State::Answered(observation.outcome),
                _ => return Err(Error::Corrupt("a saved question is none")),
            },
            ..Trial::new(
                Question { id, query },
                Purpose::of_notes(observation.notes)?,
            )
        })
    }
}

/// How many bytes [`save`] needs for a learner in its present state.
pub fn saved_len(learner: &(impl Learner + ?Sized), problem: &Problem<'_>) -> usize {
    let each = Observation::saved_len(problem);
    let trials = learner.trials().len() * (TRIAL + each);
    FRAME + HEADER + each * learner.observations().len() + trials
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
    let Begun { fingerprint, count } = problem.begun();
    writer.u32(fingerprint);
    writer.u32(count);
    writer.u32(learner.fingerprint());
    writer.u16(u16::try_from(parameters).map_err(|_| TOO_MANY)?);
    let notes = learner.notes();
    writer.u16(notes.since);
    writer.u32(u32::try_from(observations.len()).map_err(|_| TOO_MANY)?);
    writer.u32(notes.asked);
    writer.u32(u32::try_from(notes.dropped).map_err(|_| TOO_MANY)?);
    writer.u32(u32::try_from(learner.trials().len()).map_err(|_| TOO_MANY)?);
    for observation in observations {
        observation.write(&mut writer, problem);
    }
    for trial in learner.trials() {
        trial.write(&mut writer, problem)?;
    }
    writer.finish("bytes for a saved learner")
}

/// Brings a fresh learner to the state that [`save`] wrote, by telling it the same answers.
/// It may have more calls and more room than the saved one had, and more instances behind
/// those of the saved run.
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
    check_fresh(learner)?;
    let mut reader = Reader::new(bytes, MAGIC, VERSION)?;
    Begun::check(&mut reader, problem)?;
    if reader.u32()? != learner.fingerprint() {
        return Err(Error::Mismatch(
            "saved with another configuration or capacity",
        ));
    }
    if usize::from(reader.u16()?) != problem.domain().parameters().len() {
        return Err(Error::Corrupt("the saved samples have other parameters"));
    }
    let (since, count) = (reader.u16()?, reader.u32()?);
    let (asked, dropped, trials) = (reader.u32()?, reader.u32()?, reader.u32()?);
    if usize::try_from(count).map_or(true, |count| count > learner.room()) {
        return Err(OBSERVATIONS_FULL);
    }
    or_restart(learner, problem, |learner| {
        for _ in 0..count {
            let saved = Observation::read(&mut reader, problem)?;
            learner.replay(problem, &saved)?;
        }
        let notes = Notes {
            since,
            asked,
            dropped: dropped as usize,
        };
        learner.reopen(problem, notes)?;
        for _ in 0..trials {
            let saved = Trial::read(&mut reader, problem)?;
            learner.restore(problem, saved)?;
        }
        reader.finish()
    })
}

/// Tells a fresh learner what was saved. If some of it is wrong, which is not seen before it
/// is told, the learner is as fresh as before.
pub(super) fn or_restart<L: Learner + ?Sized, T>(
    learner: &mut L,
    problem: &Problem<'_>,
    tell: impl FnOnce(&mut L) -> Result<T, Error>,
) -> Result<T, Error> {
    let told = tell(learner);
    if told.is_err() {
        learner.restart(problem.domain());
    }
    told
}

/// Checks that nothing was asked or told yet.
pub(super) fn check_fresh(learner: &(impl Learner + ?Sized)) -> Result<(), Error> {
    match learner.observations().is_empty() && learner.trials().is_empty() {
        true => Ok(()),
        false => Err(Error::OutOfSequence(
            "resume before anything is asked or told",
        )),
    }
}

impl Begun {
    /// Reads the problem that something was saved for, and checks that it goes on with this.
    pub(super) fn check(reader: &mut Reader<'_>, problem: &Problem<'_>) -> Result<(), Error> {
        let begun = Begun {
            fingerprint: reader.u32()?,
            count: reader.u32()?,
        };
        match problem.continues(begun) {
            true => Ok(()),
            false => Err(Error::Mismatch(
                "saved for another domain or other instances",
            )),
        }
    }
}
