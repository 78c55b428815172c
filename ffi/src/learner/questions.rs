//! Several questions at once, for several workers.

use crate::boundary::pointer::{Output, OutputArray};
use crate::boundary::status::{Fallible, critreg_status};
use crate::learner::config::CRITREG_MAX_QUESTIONS;
use crate::learner::handle::{critreg_learner, problem, with_learner};
use crate::learner::outcome::{self, critreg_outcome};
use critreg_core::learn::{Question, open_questions};
use heapless::Vec;

/// Questions that are given at once.
type Questions = Vec<Question, { CRITREG_MAX_QUESTIONS as usize }>;

/// Where questions are written, each with its id, instance and parameters.
struct Outputs {
    wanted: usize,
    /// Numbers of a sample.
    numbers: usize,
    ids: OutputArray<u64>,
    instances: OutputArray<usize>,
    thetas: OutputArray<f64>,
    given: Output<usize>,
}

impl Outputs {
    /// # Safety
    /// As for [`OutputArray::new`]: `wanted` ids and instances, and as many samples of
    /// `numbers` parameters.
    unsafe fn new(
        wanted: usize,
        numbers: usize,
        (ids, instances, thetas): (*mut u64, *mut usize, *mut f64),
        given: *mut usize,
    ) -> Fallible<Self> {
        // There are never more.
        let wanted = wanted.min(CRITREG_MAX_QUESTIONS as usize);
        // SAFETY: by this function's contract, for all.
        unsafe {
            Ok(Outputs {
                wanted,
                numbers,
                ids: OutputArray::new(ids, wanted, "ids")?,
                instances: OutputArray::new(instances, wanted, "instance_numbers")?,
                thetas: OutputArray::new(thetas, wanted * numbers, "thetas")?,
                given: Output::new(given, "given")?,
            })
        }
    }

    fn write(self, questions: &Questions) {
        self.ids.write_each(questions.iter().map(|own| own.id));
        let instances = questions.iter().map(|own| own.query.instance);
        self.instances.write_each(instances);
        let numbers = self.numbers;
        let thetas = questions.iter();
        let thetas = thetas.flat_map(move |own| own.query.theta.into_iter().take(numbers));
        self.thetas.write_each(thetas);
        self.given.write(questions.len());
    }
}

/// Asks for several samples at once, for as many workers: threads, processes, robots. Each
/// has an id, by which critreg_tell_id() knows it. They are chosen to be good together: each
/// for what is left whichever answers the open ones get. No two open questions are about the
/// same sample.
///
/// It never waits. It gives fewer questions than wanted, or none, if no more are worth asking
/// before an answer comes: the calls that are left are all asked for, or
/// critreg_config.questions are open. With CRITREG_ALGORITHM1 there is one at a time.
///
/// ```c
/// while (critreg_is_finished(learner, &finished) == CRITREG_OK && !finished) {
///     CHECK(critreg_ask_many(learner, instances, count, idle_workers(), ids, numbers, thetas,
///                            &given));
///     for (size_t i = 0; i < given; ++i)
///         start_worker(ids[i], numbers[i], &thetas[i * PARAMETERS]);
///     wait_for_a_worker(&id, &outcome);
///     CHECK(critreg_tell_id(learner, instances, count, id, outcome));
/// }
/// ```
///
/// @param learner The learner.
/// @param instances The problem instances, as for critreg_ask().
/// @param count How many there are.
/// @param wanted How many questions there is room for.
/// @param ids Receives the id of each.
/// @param instance_numbers Receives the index of the instance to try each in.
/// @param thetas Receives the parameters of each, one sample behind the other. NULL if there
/// are none.
/// @param given Receives how many questions there are; 0 also if learning is finished.
/// @return As critreg_ask(), where that is not finished. If it fails, questions that were
/// asked on the way are open: critreg_open_questions().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_ask_many(
    learner: *mut critreg_learner,
    instances: *const f64,
    count: usize,
    wanted: usize,
    ids: *mut u64,
    instance_numbers: *mut usize,
    thetas: *mut f64,
    given: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_learner(learner, |handle, inner| {
            let numbers = handle.domain.parameters().len();
            let arrays = (ids, instance_numbers, thetas);
            let outputs = Outputs::new(wanted, numbers, arrays, given)?;
            let problem = problem(handle, instances, count)?;
            inner.retire_region();
            let mut questions = Questions::new();
            while questions.len() < outputs.wanted
                && let Some(question) = inner.learner.ask_more(&problem)?
            {
                // There is room for all that can be open.
                let _ = questions.push(question);
            }
            outputs.write(&questions);
            Ok(())
        })
    }
}

/// Tells the learner what came of a question, in any order. What it learns does not depend on
/// the order in which answers come between two calls of critreg_ask() or critreg_ask_many():
/// the answer to a question before which others are open waits for these, at most until the
/// learner asks next or critreg_conclude() is called. What critreg_learner_report() and
/// critreg_learner_region() tell is without it until then. Among questions that
/// critreg_observe() comes in between, the order of that does matter.
///
/// CRITREG_UNKNOWN teaches nothing, and the learner asks something else next.
///
/// @param learner The learner.
/// @param instances The problem instances, as for critreg_ask().
/// @param count How many there are.
/// @param id The id of the question.
/// @param outcome What came of it.
/// @return CRITREG_OUT_OF_SEQUENCE if no question with this id waits for an answer, since it
/// was told, or forgotten so long ago that its place was needed: critreg_observe() takes it
/// then; and as critreg_tell(). If it fails, the question still waits.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_tell_id(
    learner: *mut critreg_learner,
    instances: *const f64,
    count: usize,
    id: u64,
    outcome: critreg_outcome,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_learner(learner, |handle, inner| {
            let outcome = outcome::read(outcome, inner.steps)?;
            let problem = problem(handle, instances, count)?;
            inner.learner.tell_id(&problem, id, outcome)?;
            inner.retire_region();
            Ok(())
        })
    }
}

/// Waits no longer for the answer to a question: its worker was lost, or is too slow. Its
/// sample may be asked about again, with another id. An answer that comes all the same is
/// taken: it is a fact about the world.
///
/// @param learner The learner.
/// @param id The id of the question.
/// @return CRITREG_OUT_OF_SEQUENCE if no question with this id waits for an answer;
/// CRITREG_BUSY, CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_forget(learner: *mut critreg_learner, id: u64) -> critreg_status {
    // SAFETY: the header makes it the caller's promise.
    unsafe { with_learner(learner, |_, inner| Ok(inner.learner.forget(id)?)) }
}

/// Tells which questions are open, in the order in which they were asked; for a run that was
/// resumed with critreg_learner_resume(), to hand them to its workers again.
///
/// @param learner The learner.
/// @param wanted How many questions there is room for.
/// @param ids Receives the id of each.
/// @param instance_numbers Receives the index of the instance to try each in.
/// @param thetas Receives the parameters of each, one sample behind the other. NULL if there
/// are none.
/// @param given Receives how many were written.
/// @return CRITREG_BUSY, CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_open_questions(
    learner: *mut critreg_learner,
    wanted: usize,
    ids: *mut u64,
    instance_numbers: *mut usize,
    thetas: *mut f64,
    given: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_learner(learner, |handle, inner| {
            let numbers = handle.domain.parameters().len();
            let arrays = (ids, instance_numbers, thetas);
            let outputs = Outputs::new(wanted, numbers, arrays, given)?;
            let mut questions = Questions::new();
            for open in open_questions(&*inner.learner).take(outputs.wanted) {
                // As above.
                let _ = questions.push(open);
            }
            outputs.write(&questions);
            Ok(())
        })
    }
}
