//! Asking and telling.

use crate::boundary::handle;
use crate::boundary::pointer::{self, Output, OutputArray};
use crate::boundary::status::{Failure, Fallible, critreg_status, stop_unless_ok};
use crate::learner::handle::{Inner, critreg_learner, problem, with_learner};
use crate::learner::outcome::{self, CRITREG_NO_OUTCOME, critreg_outcome};
use crate::region::handle::critreg_region;
use crate::region::quality::CRITREG_APPROXIMATE;
use core::ffi::c_void;
use critreg_core::learn::Query;
use critreg_core::region::Theta;

/// Whatever can tell whether an action works: a simulator, a motion planner, a
/// robot.
///
/// It must return: no longjmp(), no C++ exception may leave it. A handle that was left by a
/// longjmp() all the same answers CRITREG_BUSY until critreg_learner_recover(); a C++
/// exception ends the program, or does worse. It may not touch
/// the memory of the learner, nor call functions on it other than those that take
/// it as const; the others return CRITREG_BUSY.
///
/// @param user_data What the program passed to critreg_learn_region().
/// @param instance The instance: one number per attribute. Points to a number also
/// where the domain has no objects.
/// @param theta The parameters to try: one number each. Points to a number also if
/// there are none.
/// @param outcome Receives what came of it; holds CRITREG_NO_OUTCOME, which is refused.
/// @return CRITREG_OK if there is an outcome. Anything else stops learning and
/// becomes the status of critreg_learn_region(): CRITREG_CANCELLED, or
/// CRITREG_USER_STATUS and above. The sample then stays to be tried.
pub type critreg_simulate = Option<
    unsafe extern "C" fn(
        user_data: *mut c_void,
        instance: *const f64,
        theta: *const f64,
        outcome: *mut critreg_outcome,
    ) -> critreg_status,
>;

/// Learns a region by trying samples with a simulator until the learner has
/// nothing more to ask. It is the loop critreg_ask(), simulate(), critreg_tell().
///
/// ```c
/// static uint64_t memory[CRITREG_LEARNER_WORDS(4096, 256)];
/// critreg_learner *learner;
/// const critreg_region *region;
/// char text[512];
///
/// if (critreg_learner_init(memory, sizeof memory, DOMAIN, NULL, &learner) == CRITREG_OK
///     && critreg_learn_region(learner, instances, 4, try_grasp, NULL, &region) == CRITREG_OK
///     && critreg_region_format(region, text, sizeof text, NULL) == CRITREG_OK)
///     puts(text);
/// ```
///
/// If it was stopped, call it again to go on; it begins with the sample that was
/// not told. If learning is finished, it only returns the region.
///
/// @param learner The learner.
/// @param instances The problem instances, one behind the other: count times one
/// number per attribute, as the program has them or as critreg_choose_instances() chose them of
/// very many. They must be the same in all calls; others may be appended,
/// as far as there is room for them: what was told is then taken in again.
/// @param count How many instances there are, at least one.
/// @param simulate Tries a sample.
/// @param user_data Passed to simulate.
/// @param region NULL, or receives the region; it is valid as the one of
/// critreg_learner_region() is.
/// @return CRITREG_NO_REGION if nothing was learned that is exact or approximate, see
/// critreg_region_quality() and critreg_learner_why(); CRITREG_CAPACITY_EXCEEDED if
/// there is no room for another observation (critreg_learner_region() still has
/// what was learned) or for so many instances (critreg_config.instances); the status
/// of a callback that was not CRITREG_OK; CRITREG_INVALID_ARGUMENT for no instance, or
/// an outcome that was not written or is none (the sample then stays to be tried);
/// CRITREG_NOT_FINITE for a number of an instance; CRITREG_MISMATCH if the instances
/// changed; CRITREG_BUSY from a callback; CRITREG_NULL_POINTER, CRITREG_MISALIGNED,
/// CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_learn_region(
    learner: *mut critreg_learner,
    instances: *const f64,
    count: usize,
    simulate: critreg_simulate,
    user_data: *mut c_void,
    region: *mut *const critreg_region,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_learner(learner, |handle, inner| {
            let simulate = simulate.ok_or(Failure::Null("simulate"))?;
            let output = Output::optional(region, "region")?;
            let problem = problem(handle, instances, count)?;
            inner.retire_region();
            while !inner.learner.is_finished() {
                let query = inner.learner.ask(&problem)?;
                let instance = pointer::to_numbers(problem.instance(query.instance)?);
                let mut outcome = CRITREG_NO_OUTCOME;
                let status = simulate(user_data, instance, query.theta.as_ptr(), &mut outcome);
                stop_unless_ok(status, "simulate")?;
                inner.tell(&problem, outcome)?;
                show_progress(handle, inner)?;
            }
            let learned = inner.give_region(handle.domain, CRITREG_APPROXIMATE)?;
            if let Some(output) = output {
                output.write(learned);
            }
            Ok(())
        })
    }
}

/// Makes a learner usable again that answers CRITREG_BUSY because a callback was left by
/// longjmp(), which it must not be. The sample that was being tried stays to be tried; all
/// that was told before is kept. A learner that is not busy stays as it is.
///
/// @param learner The learner. No call on it may be running, so this is not for callbacks.
/// @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_learner_recover(learner: *mut critreg_learner) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for both.
    unsafe {
        handle::read(learner.cast_const(), |handle: &critreg_learner| {
            handle.inner.recover();
            Ok(())
        })
    }
}

/// Publishes the report and shows it to the callback. Never inlined: what is shown takes
/// no stack while a question is chosen.
#[inline(never)]
fn show_progress(handle: &critreg_learner, inner: &Inner) -> Fallible {
    handle.publish(inner);
    let Some(progress) = inner.progress else {
        return Ok(());
    };
    let report = handle.report.get();
    // SAFETY: the header says what the callback may do; the report outlives the call.
    stop_unless_ok(
        unsafe { progress(inner.progress_data, &report) },
        "progress",
    )
}

/// Tells which sample to try next. Asking again before telling gives the same one.
///
/// ```c
/// int32_t finished = 0;
/// while (critreg_is_finished(learner, &finished) == CRITREG_OK && !finished) {
///     size_t instance;
///     double theta[2];
///     critreg_outcome outcome;
///     CHECK(critreg_ask(learner, instances, count, &instance, theta));
///     outcome = try_on_the_robot(instance, theta);
///     CHECK(critreg_tell(learner, instances, count, outcome));
/// }
/// ```
///
/// @param learner The learner.
/// @param instances The problem instances, as for critreg_learn_region(). They are
/// checked in every call.
/// @param count How many there are.
/// @param instance Receives the index of the instance to try it in.
/// @param theta Receives the parameters: one number each. NULL if there are none.
/// @return CRITREG_OUT_OF_SEQUENCE if learning is finished; CRITREG_MISMATCH if
/// the instances changed; CRITREG_CAPACITY_EXCEEDED if there is no room for so
/// many (critreg_config.instances); CRITREG_INVALID_ARGUMENT, CRITREG_NOT_FINITE,
/// CRITREG_BUSY, CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_ask(
    learner: *mut critreg_learner,
    instances: *const f64,
    count: usize,
    instance: *mut usize,
    theta: *mut f64,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_learner(learner, |handle, inner| {
            let index = Output::new(instance, "instance")?;
            let numbers = handle.domain.parameters().len();
            let parameters = OutputArray::new(theta, numbers, "theta")?;
            let Query { instance, theta } =
                inner.learner.ask(&problem(handle, instances, count)?)?;
            index.write(instance);
            parameters.write(&theta);
            Ok(())
        })
    }
}

/// Tells the learner what came of a sample that it did not ask for: of a log, a
/// demonstration, somebody else's trials. It costs no call, works before anything is asked
/// and between critreg_ask() and critreg_tell() (the sample that was asked for stays to be
/// told), and is saved with the run. Where few parameters work, one sample that works says
/// where to look: also for a slot of a ten thousandth of the range.
///
/// ```c
/// for (size_t i = 0; i < logged; ++i)
///     CHECK(critreg_observe(learner, instances, count, log[i].instance, log[i].theta,
///                           log[i].worked));
/// CHECK(critreg_conclude(learner, instances, count));
/// ```
///
/// With noise, what was asked for is asked again until its outcome is beyond doubt; what was
/// not is taken at its word, and wrong outcomes make the region an approximate one, which is
/// judged by a quarter of what was not asked for.
///
/// A log may be longer than critreg_config.observations: when these are used up, of what was
/// not asked everything near the bounds of the region is kept and elsewhere every second
/// sample. What is learned agrees with what is kept.
///
/// @param learner The learner; CRITREG_VERSION_SPACE.
/// @param instances The problem instances, as for critreg_ask().
/// @param count How many there are.
/// @param instance The index of the instance that it was tried in.
/// @param theta The parameters: one number each. NULL if there are none.
/// @param outcome What came of it.
/// @return CRITREG_CAPACITY_EXCEEDED if there is no room for another observation, because
/// nearly all were asked for;
/// CRITREG_INVALID_ARGUMENT for an instance or outcome that is none, a step that the
/// configuration does not have, or CRITREG_ALGORITHM1; CRITREG_NOT_FINITE for a parameter;
/// and as critreg_ask() where that is not finished. Then nothing was told.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_observe(
    learner: *mut critreg_learner,
    instances: *const f64,
    count: usize,
    instance: usize,
    theta: *const f64,
    outcome: critreg_outcome,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_learner(learner, |handle, inner| {
            let given = pointer::slice(theta, handle.domain.parameters().len(), "theta")?;
            let mut theta = Theta::default();
            for (value, given) in theta.iter_mut().zip(given) {
                *value = *given;
            }
            let outcome = outcome::read(outcome, inner.steps)?;
            let problem = problem(handle, instances, count)?;
            let query = Query { instance, theta };
            inner.learner.observe(&problem, &query, outcome)?;
            inner.retire_region();
            Ok(())
        })
    }
}

/// Brings the region up to date with everything that was told. The region agrees with that
/// anyway as far as it can; but a better one is only looked for when the learner asks, at
/// the end, and now and then while critreg_observe() is called. A program that only
/// observes calls it before it asks for the region. What is asked next may be something
/// else than without it.
///
/// @param learner The learner.
/// @param instances The problem instances, as for critreg_ask().
/// @param count How many there are.
/// @return As critreg_ask(), where that is not finished.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_conclude(
    learner: *mut critreg_learner,
    instances: *const f64,
    count: usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_learner(learner, |handle, inner| {
            let problem = problem(handle, instances, count)?;
            inner.retire_region();
            Ok(inner.learner.conclude(&problem)?)
        })
    }
}

/// Tells the learner what came of the sample it asked for. If this fails, the
/// sample is still to be told.
///
/// @param learner The learner.
/// @param instances The problem instances, as for critreg_ask().
/// @param count How many there are.
/// @param outcome What came of the sample.
/// @return CRITREG_OUT_OF_SEQUENCE if nothing was asked; CRITREG_CAPACITY_EXCEEDED
/// if there is no room for another observation; CRITREG_INVALID_ARGUMENT for a number
/// that is no outcome, or a step that the configuration does not have; and as
/// critreg_ask().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_tell(
    learner: *mut critreg_learner,
    instances: *const f64,
    count: usize,
    outcome: critreg_outcome,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_learner(learner, |handle, inner| {
            inner.tell(&problem(handle, instances, count)?, outcome)?;
            inner.retire_region();
            Ok(())
        })
    }
}
