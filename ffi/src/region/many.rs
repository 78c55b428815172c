//! Many samples at once, in one instance.

use crate::boundary::handle;
use crate::boundary::pointer::{self, Output, OutputArray};
use crate::boundary::precision::in_precision;
use crate::boundary::rng::{critreg_rng, with_rng};
use crate::boundary::status::{Failure, critreg_status};
use crate::region::handle::critreg_region;

/// Whether an action with each of many parameters is expected to work in an instance: as
/// critreg_region_contains(), but the instance is looked at once.
///
/// @param region The region.
/// @param instance The instance: one number per attribute.
/// @param thetas The parameters of one sample behind those of another; NULL if there are
/// none.
/// @param count How many samples there are.
/// @param inside Receives 1 or 0 for each sample; NULL if count is 0. What it holds is
/// undefined unless the call succeeds.
/// @return CRITREG_NOT_FINITE for a number of the instance or of thetas;
/// CRITREG_INVALID_ARGUMENT for a count that no memory holds; CRITREG_NULL_POINTER,
/// CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_region_contains_many(
    region: *const critreg_region,
    instance: *const f64,
    thetas: *const f64,
    count: usize,
    inside: *mut u8,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        handle::read(region, |handle| {
            let parameters = handle.domain.parameters().len();
            let numbers = count.checked_mul(parameters);
            let numbers =
                numbers.ok_or(Failure::invalid("an array is longer than memory can be"))?;
            let thetas = pointer::slice(thetas, numbers, "thetas")?;
            let inside = pointer::zeros(inside, count, "inside")?;
            in_precision!(handle.precision, R => {
                handle.ground::<R>(instance)?.contains_many(thetas, inside)?
            });
            Ok(())
        })
    }
}

/// Draws many parameters from the region in an instance: the same as so many calls of
/// critreg_sample_region(), but the instance is looked at once.
///
/// @param region The region.
/// @param instance The instance: one number per attribute.
/// @param count How many samples are wanted.
/// @param rng The generator, which moves on, also if no parameters are found.
/// @param thetas Receives the parameters of one sample behind those of another. NULL if
/// there are none.
/// @param drawn Receives how many samples were drawn: count, or fewer if the call fails
/// with CRITREG_NO_SAMPLE. Those stand in thetas.
/// @return CRITREG_EMPTY_REGION, CRITREG_NO_SAMPLE as critreg_sample_region();
/// CRITREG_NOT_FINITE, CRITREG_INVALID_ARGUMENT, CRITREG_NULL_POINTER,
/// CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_sample_region_many(
    region: *const critreg_region,
    instance: *const f64,
    count: usize,
    rng: *mut critreg_rng,
    thetas: *mut f64,
    drawn: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all. A sample is written only
    // where `thetas` has room for it.
    unsafe {
        handle::read(region, |handle| {
            let output = Output::new(drawn, "drawn")?;
            let parameters = handle.domain.parameters().len();
            let numbers = count.checked_mul(parameters);
            let numbers =
                numbers.ok_or(Failure::invalid("an array is longer than memory can be"))?;
            OutputArray::new(thetas, numbers, "thetas")?;
            let mut found = 0;
            let result = in_precision!(handle.precision, R => {
                let grounded = handle.ground::<R>(instance)?;
                with_rng(rng, |rng| grounded.sample_many(count, rng, |index, theta| {
                    for (place, value) in theta.iter().take(parameters).enumerate() {
                        thetas.add(index * parameters + place).write(*value);
                    }
                    found = index + 1;
                }))?
            });
            output.write(found);
            Ok(result?)
        })
    }
}
