//! What a region says about an instance: membership, intervals, samples.

use crate::boundary::handle;
use crate::boundary::pointer::{self, Output, OutputArray};
use crate::boundary::precision::{Precision, in_precision};
use crate::boundary::rng::{critreg_rng, with_rng};
use crate::boundary::status::{Failure, Fallible, critreg_status, status_of};
use crate::region::handle::critreg_region;
use critreg_core::Error;
use critreg_core::real::Real;
use critreg_core::region::{Intersection, Part, Theta};
use heapless::Vec;

/// Whether an action with these parameters is expected to work.
///
/// @param region The region.
/// @param instance The instance: one number per attribute.
/// @param theta The parameters: one number each; NULL if there are none. Outside of
/// their ranges they are not inside of any region.
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
        handle::read(region, |handle| {
            let output = Output::new(inside, "inside")?;
            let count = handle.domain.parameters().len();
            let theta = pointer::slice(theta, count, "theta")?;
            let contains = in_precision!(handle.precision, R => {
                handle.ground::<R>(instance)?.contains(theta)?
            });
            output.write(i32::from(contains));
            Ok(())
        })
    }
}

/// The exact set of values that the region admits for the only parameter of an
/// action, as sorted intervals that do not touch.
///
/// Whether the ends belong to the set, which depends on < and <= in the
/// constraints, is not told: no sampler can notice. Where a constraint has no
/// closed form (a turn by the parameter, a sum of two distances), or there are more
/// than CRITREG_MAX_INTERVALS of them, the set is too large rather than too small;
/// critreg_sample_region() is right all the same.
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
        handle::read(region, |handle| {
            let count = Output::new(count, "count")?;
            if capacity > 0 {
                pointer::check(ends, "ends")?;
            }
            in_precision!(handle.precision, R => {
                let grounded = handle.ground::<R>(instance)?;
                let set = grounded.intervals()?;
                let intervals = set.intervals();
                count.write(intervals.len());
                if intervals.len() > capacity {
                    return Err(Failure::TooSmall("the array for the intervals"));
                }
                let numbers = intervals.iter().flat_map(|i| [i.low, i.high]);
                for (index, number) in numbers.enumerate() {
                    ends.add(index).write(number.to_f64());
                }
                Ok(())
            })
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
        handle::read(region, |handle| {
            let output = Output::new(empty, "empty")?;
            let empty = in_precision!(handle.precision, R => {
                handle.ground::<R>(instance)?.is_proven_empty()?
            });
            output.write(i32::from(empty));
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
/// case CRITREG_EMPTY_REGION: return postpone_this_skeleton();
/// default:                   return try_action_with_any_parameters();
/// }
/// ```
///
/// @param region The region.
/// @param instance The instance: one number per attribute.
/// @param rng The generator, which moves on, also if no parameters are found.
/// @param theta Receives the parameters: one number each. NULL if there are none.
/// @return CRITREG_EMPTY_REGION if it is proven that the region has none here,
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
        handle::read(region, |handle| {
            let count = handle.domain.parameters().len();
            let output = OutputArray::new(theta, count, "theta")?;
            let (region, domain) = (&handle.region, handle.domain);
            let instance = handle.instance(instance)?;
            let drawn: Theta = in_precision!(handle.precision, R => {
                with_rng(rng, |rng| region.sample::<R>(domain, instance, rng))??
            });
            output.write(&drawn);
            Ok(())
        })
    }
}

/// Most regions of critreg_sample_regions() and critreg_regions_are_empty().
pub const CRITREG_MAX_REGIONS: usize = 32;

/// Regions with an instance each.
struct Parts<'a> {
    parts: Vec<Part<'a>, CRITREG_MAX_REGIONS>,
    /// How many parameters the action has.
    parameters: usize,
    /// The finest of the regions'.
    precision: Precision,
}

/// The caller's regions, of which there is at least one.
///
/// # Safety
/// If not NULL and aligned, `regions` and `instances` have `count` pointers; those
/// to regions are readable for as long as a region is, those to instances for one
/// instance of their region.
unsafe fn parts<'a>(
    regions: *const *const critreg_region,
    instances: *const *const f64,
    count: usize,
) -> Fallible<Parts<'a>> {
    let mut all: Option<Parts<'a>> = None;
    // SAFETY: by this function's contract, for all.
    unsafe {
        let regions = pointer::slice(regions, count, "regions")?;
        let instances = pointer::slice(instances, count, "instances")?;
        for (region, instance) in regions.iter().zip(instances) {
            let handle: &'a critreg_region = handle::open(*region)?;
            let all = all.get_or_insert_with(|| Parts {
                parts: Vec::new(),
                parameters: handle.domain.parameters().len(),
                precision: handle.precision,
            });
            all.precision = all.precision.finer(handle.precision);
            let part = Part {
                region: &handle.region,
                domain: handle.domain,
                instance: handle.instance(*instance)?,
            };
            let full = Error::CapacityExceeded("regions of an intersection");
            all.parts.push(part).map_err(|_| full)?;
        }
    }
    all.ok_or(Failure::invalid("an intersection needs a region"))
}

/// Draws parameters that several regions admit, each in an instance of its own: the
/// region of an action, and those of what comes after it.
///
/// This is what a planner with a search of its own uses for chains. A region that
/// was learned about a sequence of actions, such as "pick, then press", says with
/// which parameters of the first action the last one works. It is put into as many
/// instances as the plan skeleton has last actions, one for each button that is
/// going to be pressed, and the intersection is known before anything is tried: if
/// it is empty, the skeleton contradicts what was learned.
///
/// ```c
/// const critreg_region *regions[] = {pick, pick_and_press, pick_and_press};
/// const double *instances[] = {now, with_first_button, with_second_button};
/// switch (critreg_sample_regions(regions, instances, 3, &rng, theta)) {
/// case CRITREG_OK:           return try_action(theta);
/// case CRITREG_EMPTY_REGION: return postpone_this_skeleton();
/// default:                   return try_action_with_any_parameters();
/// }
/// ```
///
/// Draws are made in the way of critreg_sample_region().
///
/// @param regions The regions. Their domains may differ, but not in number and
/// ranges of the parameters.
/// @param instances An instance for each: one number per attribute.
/// @param count How many regions there are, from 1 to CRITREG_MAX_REGIONS.
/// @param rng The generator, which moves on, also if no parameters are found.
/// @param theta Receives the parameters: one number each. NULL if there are none.
/// @return CRITREG_EMPTY_REGION if it is proven that the regions have none in common
/// here, CRITREG_NO_SAMPLE if none were found within the budget; CRITREG_MISMATCH if the
/// regions have other parameters; CRITREG_CAPACITY_EXCEEDED for too many regions;
/// CRITREG_INVALID_ARGUMENT for no region; CRITREG_NOT_FINITE,
/// CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_sample_regions(
    regions: *const *const critreg_region,
    instances: *const *const f64,
    count: usize,
    rng: *mut critreg_rng,
    theta: *mut f64,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    let drawn = unsafe {
        parts(regions, instances, count).and_then(|all| {
            in_precision!(all.precision, R => {
                let intersection = Intersection::<R>::new(&all.parts)?;
                let output = OutputArray::new(theta, all.parameters, "theta")?;
                output.write(&with_rng(rng, |rng| intersection.sample(rng))??);
                Ok(())
            })
        })
    };
    status_of(drawn)
}

/// Whether it is proven that several regions, each in an instance of its own, admit
/// no parameters together; see critreg_sample_regions() and
/// critreg_region_is_empty().
///
/// @param regions The regions.
/// @param instances An instance for each: one number per attribute.
/// @param count How many regions there are, from 1 to CRITREG_MAX_REGIONS.
/// @param empty Receives 1 or 0.
/// @return CRITREG_MISMATCH, CRITREG_CAPACITY_EXCEEDED, CRITREG_INVALID_ARGUMENT as
/// critreg_sample_regions(); CRITREG_NOT_FINITE, CRITREG_NULL_POINTER,
/// CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_regions_are_empty(
    regions: *const *const critreg_region,
    instances: *const *const f64,
    count: usize,
    empty: *mut i32,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    let answer = unsafe {
        parts(regions, instances, count).and_then(|all| {
            let output = Output::new(empty, "empty")?;
            let is_empty = in_precision!(all.precision, R => {
                Intersection::<R>::new(&all.parts)?.is_proven_empty()?
            });
            output.write(i32::from(is_empty));
            Ok(())
        })
    };
    status_of(answer)
}
