//! Learning a region by asking for samples and being told what came of them.
//!
//! A learner never owns the simulator. It is *asked* for a [`Query`], the next
//! sample to try, and *told* the [`Outcome`]; [`learn_region`] is that loop and
//! nothing more. So a simulator can be a function, another process
//! or a robot, and a run can be saved and resumed: everything a learner knows
//! follows from its configuration and its observations.
//!
//! | learner | idea |
//! |---|---|
//! | [`VersionSpace`], the default | sound: keep every explanation of the answers, ask where they disagree |
//! | [`Algorithm1`], the baseline | the thesis's Algorithm 1: prune `left op right` hypotheses |
//!
//! [`Config`], [`Capacity`], [`Memory`] and [`Report`] are those of the default learner;
//! those of the baseline are in [`algorithm1`].
//!
//! # Words
//!
//! | word | meaning |
//! |---|---|
//! | query | a sample to try: parameters in an instance |
//! | outcome | what came of it; a *call* is an outcome that was asked for |
//! | observation | a query and its outcome, as they are kept; also of what nobody asked |
//! | sample | a query whose label is decided: feasible or not |
//! | form | the difference of two features, which a bound limits |
//! | hypothesis | a conjunction of bounds; in Algorithm 1 a single comparison |
//!
//! # Asking and telling
//!
//! ```
//! use critreg::domain::Domain;
//! use critreg::learn::{Capacity, Config, Learner, Outcome, Problem, VersionSpace};
//!
//! critreg::room!(struct Room: f64, Capacity::new(1024, 64));
//!
//! let domain = Domain::parse(
//!     "object wall { x: length, y: length }
//!      constant margin = 0.25: length
//!      parameter reach in [0, 4]: length
//!      point hand = world + (reach, 0)",
//! )?;
//! let problem = Problem::new(&domain, &[2.0, 0.0, 3.0, 0.0], 2)?; // two walls
//! let config = Config { calls: 60, ..Config::default() };
//! let mut room = Room::new();
//! let mut learner = VersionSpace::new(&domain, config, Room::CAPACITY, room.lend())?;
//! while !learner.is_finished() {
//!     let query = learner.ask(&problem)?;
//!     let wall = problem.instance(query.instance)?[0];
//!     // The hand keeps a distance from the wall.
//!     let works = query.theta[0] <= wall - 0.25;
//!     learner.tell(&problem, Outcome::from_feasible(works))?;
//! }
//! let region = learner.region()?.display(&domain).to_string();
//! assert_eq!(region, "reach - wall.x <= -0.25 (-margin)");
//! let report = learner.report();
//! assert_eq!((report.calls, report.strays), (60, 0));
//! // Ten draws from the region worked: with 95% confidence, at least 74% of it works.
//! assert!(report.certificate.lower_bound > 0.74);
//! # Ok::<(), critreg::Error>(())
//! ```

pub mod algorithm1;
mod challenge;
mod journal;
mod log;
mod outcome;
mod problem;
mod question;
mod tables;
pub mod version_space;

pub use algorithm1::Algorithm1;
pub use challenge::challenge;
pub use journal::{journal, journal_len, resume_journal};
#[doc(hidden)]
pub use log::Notes;
pub use log::{Observation, resume, save, saved_len};
pub use outcome::Outcome;
pub use problem::Problem;
#[doc(hidden)]
pub use question::Trial;
pub use question::{MAX_QUESTIONS, Question};
pub use version_space::{Capacity, Certificate, Config, Evidence, Memory, Report, VersionSpace};

use crate::domain::Domain;
use crate::error::Error;
use crate::region::{Region, Theta};

/// The sample a learner wants tried: z = (p, theta) (thesis Eq. 4.3).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Query {
    /// Index of the problem instance.
    pub instance: usize,
    /// The parameters of the action.
    pub theta: Theta,
}

/// The interface that all learners share. The problem is the same in all calls; only
/// instances may be appended, which [`Algorithm1`] refuses.
pub trait Learner {
    /// The sample to try next. Asking again before the answer is told gives the
    /// same sample.
    ///
    /// # Errors
    /// [`Error::OutOfSequence`] if learning is finished; [`Error::Mismatch`] if
    /// the problem is not the one learning began with.
    fn ask(&mut self, problem: &Problem<'_>) -> Result<Query, Error>;

    /// Takes the answer to the last query: what came of it.
    ///
    /// # Errors
    /// [`Error::OutOfSequence`] if nothing was asked,
    /// [`Error::CapacityExceeded`] if there is no room for another observation,
    /// [`Error::Mismatch`] if the problem is not the one learning began with. Then
    /// nothing was told, and the query still waits for its answer.
    fn tell(&mut self, problem: &Problem<'_>, outcome: Outcome) -> Result<(), Error>;

    /// A question more beside those that are open, for one more worker; `None` if none is
    /// worth asking before an answer comes: the calls that are left are all asked for, or
    /// there is no room for more. [`Learner::ask`] is the case of one. No two open questions
    /// are about the same sample.
    ///
    /// The answers may come in any order. What is asked next, and what is learned, depends on
    /// what was told before it was asked, and not on the order in which that came.
    ///
    /// # Errors
    /// [`Error::Mismatch`] if the problem is not the one learning began with.
    fn ask_more(&mut self, problem: &Problem<'_>) -> Result<Option<Question>, Error>;

    /// Takes the answer to a question, by its id. It may have to wait for those of questions
    /// that were asked before; but it is taken in when the learner asks next, or
    /// [`concludes`](Learner::conclude).
    ///
    /// # Errors
    /// [`Error::OutOfSequence`] if no such question waits for an answer, and those of
    /// [`Learner::tell`]. Then nothing was told.
    fn tell_id(&mut self, problem: &Problem<'_>, id: u64, outcome: Outcome) -> Result<(), Error>;

    /// Waits no longer for the answer to a question: the worker was lost. Its sample may be
    /// asked about again. An answer that comes all the same is taken, as long as the room of
    /// the question was not needed for another.
    ///
    /// # Errors
    /// [`Error::OutOfSequence`] if no such question is open.
    fn forget(&mut self, id: u64) -> Result<(), Error>;

    /// Takes what came of a sample that was not asked for: from a log, a demonstration,
    /// somebody else's trials. It costs no call, and a question that is open stays open.
    ///
    /// # Errors
    /// Those of [`Learner::tell`], but for the sequence; [`Error::NotFinite`] or
    /// [`Error::InvalidArgument`] for a sample that is none; [`Error::InvalidArgument`] if the
    /// learner only learns from what it asks. Then nothing was told.
    fn observe(
        &mut self,
        problem: &Problem<'_>,
        query: &Query,
        outcome: Outcome,
    ) -> Result<(), Error>;

    /// Brings the region up to date with all that was told. It agrees with that anyway as far
    /// as it can, but a better one is looked for when the learner asks, or now and then while
    /// observations come in.
    ///
    /// # Errors
    /// [`Error::Mismatch`] if the problem is not the one learning began with.
    fn conclude(&mut self, problem: &Problem<'_>) -> Result<(), Error>;

    /// The questions whose answers are not taken in.
    #[doc(hidden)]
    fn trials(&self) -> &[Trial];

    /// What is saved beside observations and questions, for [`Learner::reopen`].
    #[doc(hidden)]
    fn notes(&self) -> Notes;

    /// Does what led to a saved observation, and takes it.
    ///
    /// # Errors
    /// Those of [`Learner::tell`]; [`Error::Mismatch`] if it is none of this learner.
    #[doc(hidden)]
    fn replay(&mut self, problem: &Problem<'_>, saved: &Observation) -> Result<(), Error>;

    /// Does what was done after the last observation.
    ///
    /// # Errors
    /// Those of [`Learner::ask`].
    #[doc(hidden)]
    fn reopen(&mut self, problem: &Problem<'_>, notes: Notes) -> Result<(), Error>;

    /// Opens a question that was open.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] if there is no room for it, and those of [`Learner::ask`].
    #[doc(hidden)]
    fn restore(&mut self, problem: &Problem<'_>, saved: Trial) -> Result<(), Error>;

    /// Makes it as it was before anything was asked or told.
    #[doc(hidden)]
    fn restart(&mut self, domain: &Domain<'_>);

    /// Whether there is nothing more to ask.
    fn is_finished(&self) -> bool;

    /// What is learned so far.
    ///
    /// # Errors
    /// [`Error::NoRegion`] if no constraint explains the observations.
    fn region(&self) -> Result<&Region, Error>;

    /// All that was told, in order.
    fn observations(&self) -> &[Observation];

    /// How many observations there is room for.
    fn room(&self) -> usize;

    /// A checksum of everything that decides what is asked, apart from the
    /// problem and the answers.
    fn fingerprint(&self) -> u32;
}

/// Of what there is no room for more when a learner was told as much as it can keep, and what
/// to do about it.
pub(crate) const OBSERVATIONS: &str = "observations; reserve as many as it will be told, with \
    critreg_config.observations in C and the option `observations` in Python";

/// The error of a learner that was told as much as it can keep.
pub const OBSERVATIONS_FULL: Error = Error::CapacityExceeded(OBSERVATIONS);

/// The questions whose answers a learner waits for, in the order in which they were asked:
/// to hand them out again after a run was resumed.
pub fn open_questions(learner: &(impl Learner + ?Sized)) -> impl Iterator<Item = Question> {
    let open = learner.trials().iter().filter(|trial| trial.is_open());
    open.map(|trial| trial.question)
}

/// Asks, tries and tells until the learner is finished, and returns the region.
///
/// `simulate` tries a sample; its error ends the learning and is passed on, and
/// the learner can be asked again afterwards. See the [crate] for an example.
///
/// # Errors
/// Those of [`Learner`] and of `simulate`.
pub fn learn_region<'l, L: Learner, E: From<Error>>(
    learner: &'l mut L,
    problem: &Problem<'_>,
    mut simulate: impl FnMut(&L, &Query) -> Result<Outcome, E>,
) -> Result<&'l Region, E> {
    while !learner.is_finished() {
        let query = learner.ask(problem)?;
        let outcome = simulate(learner, &query)?;
        learner.tell(problem, outcome)?;
    }
    Ok(learner.region()?)
}
