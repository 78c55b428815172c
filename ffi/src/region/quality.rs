//! How good a region is, for C.

use crate::boundary::handle;
use crate::boundary::pointer::Output;
use crate::boundary::status::critreg_status;
use crate::region::handle::critreg_region;

/// Of a region: nothing is known of its quality; it was parsed, loaded, or learned by
/// CRITREG_ALGORITHM1. Of a learner: there is no region.
pub const CRITREG_NO_QUALITY: u32 = 0;
/// It agrees with the answers so far, but they are too few to tell it from chance.
pub const CRITREG_PROVISIONAL: u32 = 1;
/// It is wrong about some answers: the truth is not quite what the domain text can say, or
/// answers are wrong. The report estimates how good it is.
pub const CRITREG_APPROXIMATE: u32 = 2;
/// It agrees with all answers, but for the few that critreg_report.strays counts.
pub const CRITREG_EXACT: u32 = 3;

/// How good a learned region is, in one word.
///
/// @param region The region.
/// @param quality Receives CRITREG_EXACT, CRITREG_APPROXIMATE, CRITREG_PROVISIONAL or
/// CRITREG_NO_QUALITY; a larger number is better.
/// @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_region_quality(
    region: *const critreg_region,
    quality: *mut u32,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for both.
    unsafe {
        handle::read(region, |handle| {
            Output::new(quality, "quality")?.write(handle.quality);
            Ok(())
        })
    }
}
