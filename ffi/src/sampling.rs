//! What a region says about an instance: membership, intervals, samples.

use crate::pointer::{self, Output, OutputArray};
use crate::region::{critreg_region, with_region};
use crate::rng::{critreg_rng, with_rng};
use crate::status::{Failure, critreg_status};
use critreg_core::region::Theta;

/// Whether an action with these parameters is expected to work.
///
/// @param region The region.
/// @param instance The instance: one number per attribute.
/// @param theta The parameters: one number each. Outside of their ranges they
/// are not inside of any region.
/// @param inside Receives 1 or 0.
/// @return CRITREG_NOT_FINITE for a number of the instance or of theta;
/// CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_region_contains(
    region: *const critreg_region,
    instance: *const f64,
    theta: *const f64,
    inside: *mut i32,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_region(region, |handle| {
            let output = Output::new(inside, "inside")?;
            let count = handle.domain.parameters().len();
            let theta = pointer::slice(theta, count, "theta")?;
            output.write(i32::from(handle.ground(instance)?.contains(theta)?));
            Ok(())
        })
    }
}

/// The exact set of values that the region admits for the only parameter of an
/// action, as sorted intervals that do not touch.
///
/// Whether the ends belong to the set, which depends on < and <= in the
/// constraints, is not told: no sampler can notice. Where a constraint has no
/// closed form (a turn by the parameter, a sum of two distances) the set is too
/// large rather than too small; critreg_sample_region() is right all the same.
///
/// @param region The region of an action with one parameter.
/// @param instance The instance: one number per attribute.
/// @param ends Receives lower and upper end of each interval: 2 * capacity
/// numbers. NULL if capacity is 0.
/// @param capacity How many intervals there is room for.
/// @param count Receives how many intervals there are, also if they are more than
/// capacity; 0 for an empty set.
/// @return CRITREG_TOO_SMALL if there are more than capacity (nothing but count is
/// written); CRITREG_INVALID_ARGUMENT unless the action has one parameter;
/// CRITREG_NOT_FINITE, CRITREG_NULL_POINTER, CRITREG_MISALIGNED,
/// CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_region_intervals(
    region: *const critreg_region,
    instance: *const f64,
    ends: *mut f64,
    capacity: usize,
    count: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_region(region, |handle| {
            let count = Output::new(count, "count")?;
            if capacity > 0 {
                pointer::check(ends, "ends")?;
            }
            let grounded = handle.ground(instance)?;
            let set = grounded.intervals()?;
            let intervals = set.intervals();
            count.write(intervals.len());
            if intervals.len() > capacity {
                return Err(Failure::TooSmall("the array for the intervals"));
            }
            let numbers = intervals.iter().flat_map(|i| [i.low, i.high]);
            for (index, number) in numbers.enumerate() {
                ends.add(index).write(number);
            }
            Ok(())
        })
    }
}

/// Whether it is proven that the region admits no parameters in an instance. With
/// one parameter the answer is exact; with several, 0 may mean that no proof was
/// found.
///
/// @param region The region.
/// @param instance The instance: one number per attribute.
/// @param empty Receives 1 or 0.
/// @return CRITREG_NOT_FINITE, CRITREG_NULL_POINTER, CRITREG_MISALIGNED,
/// CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_region_is_empty(
    region: *const critreg_region,
    instance: *const f64,
    empty: *mut i32,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_region(region, |handle| {
            let output = Output::new(empty, "empty")?;
            output.write(i32::from(handle.ground(instance)?.is_proven_empty()?));
            Ok(())
        })
    }
}

/// Draws parameters from the region in an instance. This is what a planner calls.
///
/// One parameter: uniform over the exact intervals. Several: uniform by rejection;
/// if the region is small, by hit-and-run, which tends to uniform. What comes back
/// always satisfies critreg_region_contains().
///
/// ```c
/// critreg_rng rng = critreg_rng_seed(7);
/// double theta[1];
/// switch (critreg_sample_region(region, instance, &rng, theta)) {
/// case CRITREG_OK:           return try_action(theta);
/// case CRITREG_EMPTY_REGION: return prune_this_skeleton();
/// default:                   return try_action_with_any_parameters();
/// }
/// ```
///
/// @param region The region.
/// @param instance The instance: one number per attribute.
/// @param rng The generator, which moves on, also if no parameters are found.
/// @param theta Receives the parameters: one number each.
/// @return CRITREG_EMPTY_REGION if it is proven that there are none,
/// CRITREG_NO_SAMPLE if none were found within the budget; CRITREG_NOT_FINITE,
/// CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_sample_region(
    region: *const critreg_region,
    instance: *const f64,
    rng: *mut critreg_rng,
    theta: *mut f64,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_region(region, |handle| {
            let output = OutputArray::new(theta, "theta")?;
            let (region, domain) = (&handle.region, handle.domain);
            let instance = handle.instance(instance)?;
            let drawn: Theta = with_rng(rng, |rng| region.sample::<f64>(domain, instance, rng))??;
            let count = domain.parameters().len();
            output.write(drawn.get(..count).unwrap_or(&[]));
            Ok(())
        })
    }
}
