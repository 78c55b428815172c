//! Choosing instances of a source.

use crate::boundary::pointer::{self, Output};
use crate::boundary::status::{Failure, critreg_status, stop_unless_ok};
use crate::learner::handle::{critreg_learner, with_learner};
use core::ffi::c_void;

/// Makes an instance of a source: a task of a generator, a scene of a data set.
///
/// It must return, as a critreg_simulate must, and may not use the learner.
///
/// @param user_data What the program passed to critreg_choose_instances().
/// @param number Which instance, from 0. The same number makes the same instance.
/// @param instance Receives it: one number per attribute. Points to a number also where the
/// domain has no objects.
/// @return CRITREG_OK, or anything else to stop; that becomes the status of
/// critreg_choose_instances().
pub type critreg_make_instance = Option<
    unsafe extern "C" fn(
        user_data: *mut c_void,
        number: usize,
        instance: *mut f64,
    ) -> critreg_status,
>;

/// Chooses instances of a source that can make thousands, and writes them into an array for
/// critreg_learn_region(), critreg_ask() and all others that take instances: as many as there
/// is room for, those that differ most. Where instances are alike, a condition that holds in all
/// of them by chance looks as good as the one that matters. Only what is chosen takes memory.
///
/// The source is divided into as many parts as there is room for instances, and of each the one
/// is taken that differs most from those before, in what the learner measures: distances,
/// coordinates, angles. Every instance is made two or three times. The same source makes the same
/// choice.
///
/// ```c
/// static double instances[64 * NUMBERS];
/// size_t count;
/// CHECK(critreg_choose_instances(learner, 1000, make_task, NULL, instances, 64, &count));
/// CHECK(critreg_learn_region(learner, instances, count, try_grasp, NULL, &region));
/// ```
///
/// @param learner The learner, of which nothing was asked and nothing told;
/// CRITREG_VERSION_SPACE.
/// @param offered How many instances the source has.
/// @param make Makes one.
/// @param user_data Passed to make.
/// @param instances Receives the chosen ones, one behind the other. If the call fails, it holds
/// anything.
/// @param room For how many there is room; no more than critreg_config.instances are written.
/// @param count Receives how many there are.
/// @return CRITREG_OUT_OF_SEQUENCE after something was asked or told;
/// CRITREG_INVALID_ARGUMENT if there is no instance, no room for one, or CRITREG_ALGORITHM1;
/// CRITREG_NOT_FINITE for a number of an instance; what make returned if that is not CRITREG_OK;
/// CRITREG_BUSY from a callback; CRITREG_NULL_POINTER, CRITREG_MISALIGNED,
/// CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_choose_instances(
    learner: *mut critreg_learner,
    offered: usize,
    make: critreg_make_instance,
    user_data: *mut c_void,
    instances: *mut f64,
    room: usize,
    count: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_learner(learner, |handle, inner| {
            let make = make.ok_or(Failure::Null("make"))?;
            let output = Output::new(count, "count")?;
            let numbers = handle.domain.instance_len().checked_mul(room);
            let numbers = numbers.ok_or(Failure::invalid("room is too large"))?;
            let chosen = pointer::zeros(instances, numbers, "instances")?;
            let mut make = |number: usize, own: &mut [f64]| {
                let mut none = 0.0;
                let place = match own {
                    [] => &raw mut none,
                    _ => own.as_mut_ptr(),
                };
                stop_unless_ok(make(user_data, number, place), "make")
            };
            let learner = &mut inner.learner;
            output.write(learner.choose_instances(handle.domain, offered, &mut make, chosen)?);
            Ok(())
        })
    }
}
