//! Questions that are open: asking several at once, and taking answers in their order.
//!
//! An answer is taken in when no question before it is open, at the latest when the learner
//! asks next. So what is known when it asks follows from the answers, and not from the order
//! in which they came.

use super::VersionSpace;
use crate::error::Error;
use crate::learn::question::{Purpose, Question, State, Trial};
use crate::learn::{Outcome, Problem, Query};
use crate::real::Real;

impl<R: Real> VersionSpace<'_, R> {
    /// The open question that was asked first.
    pub(super) fn first_open(&self) -> Option<&Trial> {
        self.trials.as_slice().iter().find(|trial| trial.is_open())
    }

    /// How many questions are open.
    pub(super) fn open(&self) -> u32 {
        self.count_trials(Trial::is_open) as u32
    }

    fn count_trials(&self, is: impl Fn(&Trial) -> bool) -> usize {
        self.trials.as_slice().iter().filter(|own| is(own)).count()
    }

    /// Whether the sample of a query is asked about already.
    pub(super) fn is_asked(&self, query: &Query) -> bool {
        let mut trials = self.trials.as_slice().iter();
        trials.any(|trial| trial.state != State::Forgotten && trial.query() == query)
    }

    /// How many answers wait to be taken in.
    pub(super) fn waiting(&self) -> usize {
        self.count_trials(|trial| matches!(trial.state, State::Answered(_)))
    }

    /// One question more, if there is one that is worth asking now.
    pub(super) fn ask_another(&mut self, problem: &Problem<'_>) -> Result<Option<Question>, Error> {
        self.begin(problem)?;
        self.take_answers(problem, true)?;
        if self.calls_left() <= self.open() {
            return Ok(None);
        }
        let trials = self.trials.as_slice();
        let again = trials.iter().find(|own| own.is_undecided()).copied();
        let trial = match again {
            Some(known) => known,
            None if !self.has_place() => return Ok(None),
            None => match self.next_query(problem)? {
                Some((query, purpose)) => Trial::new(Question { id: 0, query }, purpose),
                None => return Ok(None),
            },
        };
        // There is never more than one about a sample.
        match self.place_of_query(trial.query()) {
            Some(place) => self.trials.remove(place),
            None => self.make_place(),
        }
        self.serial = self.serial.wrapping_add(1);
        let question = Question::new(self.serial, *trial.query());
        self.trials.push(Trial {
            question,
            state: State::Open,
            ..trial
        })?;
        Ok(Some(question))
    }

    /// Whether there is room for one more question: that of a forgotten one will do.
    fn has_place(&self) -> bool {
        self.trials.len() < self.trials.capacity() || self.forgotten().is_some()
    }

    fn make_place(&mut self) {
        if self.trials.len() == self.trials.capacity()
            && let Some(place) = self.forgotten()
        {
            self.trials.remove(place);
        }
    }

    fn forgotten(&self) -> Option<usize> {
        let mut trials = self.trials.as_slice().iter();
        trials.position(|own| own.state == State::Forgotten && !own.is_undecided())
    }

    /// Takes the answer to a question that is open or forgotten.
    ///
    /// # Errors
    /// Then nothing changed.
    pub(super) fn answer(
        &mut self,
        problem: &Problem<'_>,
        id: u64,
        outcome: Outcome,
    ) -> Result<(), Error> {
        self.begin(problem)?;
        self.check_step(outcome)?;
        self.check_room()?;
        let trial = self.awaited(id)?;
        let before = trial.state;
        trial.state = State::Answered(outcome);
        let taken = self.take_answers(problem, false);
        if taken.is_err()
            && let Some(trial) = self
                .trials
                .as_mut_slice()
                .iter_mut()
                .find(|own| own.question.id == id)
        {
            trial.state = before;
        }
        taken
    }

    /// Waits no longer for the answer to a question.
    pub(super) fn give_up(&mut self, id: u64) -> Result<(), Error> {
        self.awaited(id)?.state = State::Forgotten;
        Ok(())
    }

    fn awaited(&mut self, id: u64) -> Result<&mut Trial, Error> {
        let mut trials = self.trials.as_mut_slice().iter_mut();
        let awaited = |own: &&mut Trial| matches!(own.state, State::Open | State::Forgotten);
        let trial = trials.find(|own| own.question.id == id && awaited(own));
        trial.ok_or(Error::OutOfSequence(
            "no question with this id waits for an answer: it was told, or is long forgotten \
             (then tell it as an observation)",
        ))
    }

    /// Takes in the answers before which no question is open, or all.
    pub(super) fn take_answers(&mut self, problem: &Problem<'_>, all: bool) -> Result<(), Error> {
        let mut place = 0;
        while let Some(trial) = self.trials.as_slice().get(place).copied() {
            match trial.state {
                State::Answered(outcome) => {
                    self.make_room(problem)?;
                    let left = self.take(problem, trial, outcome)?;
                    match (left, self.trials.as_mut_slice().get_mut(place)) {
                        (Some(left), Some(own)) => {
                            *own = Trial {
                                state: State::Again,
                                ..left
                            };
                            place += 1;
                        }
                        _ => self.trials.remove(place),
                    }
                }
                State::Open | State::Forgotten if !all => break,
                _ => place += 1,
            }
        }
        Ok(())
    }

    /// The region is another one: draws from the old one that are on their way certify nothing.
    pub(super) fn outdate_draws(&mut self) {
        for trial in self.trials.as_mut_slice() {
            if trial.purpose == Purpose::Certify {
                trial.purpose = Purpose::Draw;
            }
        }
    }
}
