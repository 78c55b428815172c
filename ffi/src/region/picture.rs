//! A picture of a region.

use crate::boundary::handle;
use crate::boundary::precision::in_precision;
use crate::boundary::status::critreg_status;
use crate::boundary::text;
use crate::region::handle::critreg_region;
use core::ffi::c_char;
use core::fmt;
use critreg_core::picture::Picture;

/// Draws a region in an instance, as SVG: its text; the scene with its bodies, and where
/// the action moves points and bodies, green where it is expected to work and grey where
/// not; beside it the parameters that are inside, of one as intervals, of two as an area,
/// of more as draws. In space the scene is seen from above and from the side.
///
/// The same region and instance give the same text everywhere. It has some 10 to 100 KB.
///
/// ```c
/// size_t needed;
/// critreg_region_to_svg(region, instance, NULL, 0, &needed);
/// ```
///
/// @param region The region.
/// @param instance The instance: one number per attribute.
/// @param text Receives the SVG, ended by NUL.
/// @param len Length of text in bytes; 0 to ask for the length only.
/// @param needed NULL, or receives the length of the text with its NUL, also if the
/// buffer is too small.
/// @return CRITREG_TOO_SMALL (nothing but needed is written); CRITREG_NOT_FINITE for a
/// number of the instance; CRITREG_CAPACITY_EXCEEDED if more points of the domain move
/// than fit; CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_region_to_svg(
    region: *const critreg_region,
    instance: *const f64,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        handle::read(region, |handle| {
            let picture = Picture {
                domain: handle.domain,
                instance: handle.instance(instance)?,
                region: Some(&handle.region),
                tried: &|_| (),
            };
            let write = |out: &mut dyn fmt::Write| in_precision!(handle.precision, R => Ok(picture.write_svg::<R>(out)?));
            text::write_by(write, text, len, needed)
        })
    }
}
