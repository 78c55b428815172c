//! Questions that are open: asked and not answered yet.
//!
//! Each has a number, its id, by which its answer is told. So many can be open at once, for
//! several workers, and their answers may come in any order, late or never.

use super::{Outcome, Query};
use crate::domain::MAX_PARAMETERS;
use crate::error::Error;
use crate::table::Blank;
use crate::wire::CHECKSUM;

/// Most questions that can be open at once.
pub const MAX_QUESTIONS: usize = 64;

/// A sample to be tried, and the number by which what comes of it is told.
///
/// The number says which sample it is about: an answer that comes after the run was resumed
/// elsewhere, or never was this learner's, is noticed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Question {
    /// By which [`Learner::tell_id`](super::Learner::tell_id) knows it.
    pub id: u64,
    /// The sample.
    pub query: Query,
}

impl Question {
    /// The question with this serial number: it stands above a checksum of the sample.
    pub(super) fn new(serial: u32, query: Query) -> Question {
        let id = u64::from(serial) << 32 | u64::from(query.checksum());
        Question { id, query }
    }
}

impl Query {
    /// A checksum of the sample.
    pub(super) fn checksum(&self) -> u32 {
        let mut digest = CHECKSUM.digest();
        digest.update(&(self.instance as u64).to_le_bytes());
        for value in self.theta {
            digest.update(&value.to_bits().to_le_bytes());
        }
        digest.finalize()
    }
}

/// What became of a question.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum State {
    /// Its answer is waited for.
    Open,
    /// Its label is not decided, so that it is to be asked again: answers may be wrong.
    Again,
    /// Its answer waits for those of the questions before it.
    Answered(Outcome),
    /// Nobody waits for its answer, which may come all the same.
    Forgotten,
}

/// What a query is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Purpose {
    /// To tell hypotheses apart.
    Doubt,
    /// It is drawn from the region, to certify it.
    Certify,
    /// It is drawn from the region, to learn what is wrong with it.
    Draw,
    /// It is drawn from everything.
    Anywhere,
    /// It was not asked.
    Told,
}

/// Where the purpose stands in the notes of an observation.
pub(super) const PURPOSE: u16 = (1 << 3) - 1;

/// In the notes of an observation: it was kept when others were dropped, and taken in without
/// a look for hypotheses.
pub(super) const KEPT: u16 = 1 << 12;

impl Purpose {
    const ALL: [Purpose; 5] = [
        Purpose::Doubt,
        Purpose::Certify,
        Purpose::Draw,
        Purpose::Anywhere,
        Purpose::Told,
    ];

    /// The purpose in the notes of an observation.
    pub(super) fn of_notes(notes: u16) -> Result<Purpose, Error> {
        let known = Purpose::ALL.get(usize::from(notes & PURPOSE));
        known
            .copied()
            .ok_or(Error::Corrupt("a saved purpose is none"))
    }
}

/// A question and what is known of its label.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trial {
    pub(super) question: Question,
    pub(super) state: State,
    /// How many more outcomes were feasible than infeasible.
    pub(super) lead: i32,
    /// The step that failed last, from one.
    pub(super) failed_step: u8,
    pub(super) purpose: Purpose,
}

impl Trial {
    /// A question that nothing is known of.
    pub(super) fn new(question: Question, purpose: Purpose) -> Trial {
        Trial {
            question,
            state: State::Open,
            lead: 0,
            failed_step: 1,
            purpose,
        }
    }

    /// The sample that it is about.
    pub(super) fn query(&self) -> &Query {
        &self.question.query
    }

    /// Whether it is to be asked again: after an answer that was not enough, or none.
    pub(super) fn is_undecided(&self) -> bool {
        self.state == State::Again || (self.state == State::Forgotten && self.lead != 0)
    }

    pub(super) fn is_open(&self) -> bool {
        self.state == State::Open
    }
}

impl Blank for Trial {
    const BLANK: Self = Trial {
        question: Question {
            id: 0,
            query: Query {
                instance: 0,
                theta: [0.0; MAX_PARAMETERS],
            },
        },
        state: State::Forgotten,
        lead: 0,
        failed_step: 1,
        purpose: Purpose::Told,
    };
}
