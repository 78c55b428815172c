//! A journal: records that are appended to a file, one after each answer.
//!
//! | bytes | content of a record (little endian) |
//! |---|---|
//! | 4 | `CRLJ` |
//! | 2 | version |
//! | 4 | fingerprint of the problem |
//! | 4 | number of its instances |
//! | 4 | fingerprint of the learner |
//! | 4 | place among all that was told |
//! | 8 + 8 n | the observation, as in a saved run |
//! | 4 | CRC-32 of all before |
//!
//! A record says all that it takes to check it, so there is no head to be written first. One
//! that was torn when the machine stopped is noticed and left out.

use super::Learner;
use super::log::{Notes, Observation, check_fresh, or_restart};
use super::problem::{Begun, Problem};
use super::question::KEPT;
use crate::error::Error;
use crate::wire::{FRAME, Reader, Writer};

const MAGIC: &[u8; 4] = b"CRLJ";
const VERSION: u16 = 2;

/// Bytes of a record.
fn record_len(problem: &Problem<'_>) -> usize {
    FRAME + 4 * 4 + Observation::saved_len(problem)
}

/// How many bytes [`journal`] needs.
pub fn journal_len(learner: &(impl Learner + ?Sized), problem: &Problem<'_>, from: usize) -> usize {
    record_len(problem)
        * learner
            .observations()
            .len()
            .saturating_sub(written(learner, from))
}

/// Of what is kept, the observations that are among the first `from` that were told.
fn written(learner: &(impl Learner + ?Sized), from: usize) -> usize {
    from.saturating_sub(learner.notes().dropped)
}

/// Writes what is to be appended to a journal that has the first `from` observations in it,
/// and returns how many bytes that is. A question that is open is not part of it: after
/// resuming, the learner asks what it would ask then.
///
/// # Errors
/// [`Error::CapacityExceeded`] if `bytes` is shorter than [`journal_len`].
pub fn journal(
    learner: &(impl Learner + ?Sized),
    problem: &Problem<'_>,
    from: usize,
    bytes: &mut [u8],
) -> Result<usize, Error> {
    const TOO_SHORT: Error = Error::CapacityExceeded("bytes for a journal");
    let length = journal_len(learner, problem, from);
    let records = bytes.get_mut(..length).ok_or(TOO_SHORT)?;
    let records = records.chunks_exact_mut(record_len(problem));
    let dropped = learner.notes().dropped;
    let observations = learner.observations().iter().enumerate();
    let observations = observations.skip(written(learner, from));
    for ((place, observation), record) in observations.zip(records) {
        let mut writer = Writer::new(record, MAGIC, VERSION);
        let Begun { fingerprint, count } = problem.begun();
        writer.u32(fingerprint);
        writer.u32(count);
        writer.u32(learner.fingerprint());
        writer.u32(u32::try_from(dropped + place).map_err(|_| TOO_SHORT)?);
        observation.write(&mut writer, problem);
        writer.finish("bytes for a journal")?;
    }
    Ok(length)
}

/// Brings a fresh learner to the state that a journal tells of, and returns how many of its
/// bytes stand. What is behind, beginning with the first record that is torn or damaged, was
/// left out, and is to be cut off before anything is appended. As in
/// [`resume`](super::resume), the learner may have more calls and more room, and more
/// instances.
///
/// # Errors
/// [`Error::Mismatch`] for a record of another problem or configuration,
/// [`Error::Corrupt`] if one is missing before it, [`Error::CapacityExceeded`] if there is no
/// room for its observation, [`Error::OutOfSequence`] if the learner is not fresh: then
/// nothing was told.
pub fn resume_journal<L: Learner + ?Sized>(
    learner: &mut L,
    problem: &Problem<'_>,
    bytes: &[u8],
) -> Result<usize, Error> {
    check_fresh(learner)?;
    or_restart(learner, problem, |learner| {
        let mut stands = 0;
        for record in bytes.chunks_exact(record_len(problem)) {
            let Ok(mut reader) = Reader::new(record, MAGIC, VERSION) else {
                break;
            };
            Begun::check(&mut reader, problem)?;
            if reader.u32()? != learner.fingerprint() {
                return Err(Error::Mismatch("saved with another configuration"));
            }
            let place = reader.u32()? as usize;
            let saved = Observation::read(&mut reader, problem)?;
            if stands == 0 && saved.notes & KEPT != 0 {
                // What was dropped before is in no journal.
                let notes = Notes {
                    dropped: place,
                    ..learner.notes()
                };
                learner.reopen(problem, notes)?;
            }
            if place != learner.notes().dropped + learner.observations().len() {
                return Err(Error::Corrupt("a record of the journal is missing"));
            }
            learner.replay(problem, &saved)?;
            stands += record.len();
        }
        let notes = Notes {
            since: 0,
            ..learner.notes()
        };
        learner.reopen(problem, notes)?;
        Ok(stands)
    })
}
