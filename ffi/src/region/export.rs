//! A region as C or Rust that needs no library.

use crate::boundary::handle;
use crate::boundary::pointer;
use crate::boundary::precision::{CRITREG_F32, CRITREG_F64};
use crate::boundary::status::{Failure, critreg_status};
use crate::boundary::text;
use crate::region::handle::critreg_region;
use core::ffi::c_char;
use core::fmt;
use critreg_core::Error;

/// Longest name of what is written, with its NUL.
const NAME_MAX: usize = 65;

/// Writes a region as C99 that needs no library: a header with static inline functions,
/// for a robot on which there is no room for more.
///
/// ```text
/// int  pick_contains(instance, theta)    1 if the parameters are inside
/// void pick_margins(instance, theta, values, gradients)
///                                        as critreg_region_margins()
/// int  pick_intervals(instance, ends)    lower and upper ends, up to
///                                        2 * pick_MAX_INTERVALS numbers; how many
/// int  pick_sample(instance, share, theta)
///                                        a draw for a uniform share in [0, 1); 0 if
///                                        nothing is inside
/// ```
///
/// The last two are there for an action with one parameter whose constraints have a closed
/// form that can be written: those of coordinates and distances, not of angles of what
/// moves, nor extremes of that; a comment at the head of the text says so. The numbers are
/// double, or float where pick_FLOAT is defined.
///
/// What is computed is what the library computes, in the same order: with
/// -ffp-contract=off the answers are equal to the last bit, apart from what sin, cos and
/// atan2 of the C library round otherwise. Within rounding of the end of an interval,
/// pick_contains() looks at the constraints and critreg_region_contains() at the interval.
/// Numbers are not checked: where one is NaN, nothing is inside.
///
/// @param region The region.
/// @param name What all names begin with, as "pick": up to 64 letters, digits and _.
/// @param text Receives the C, ended by NUL.
/// @param len Length of text in bytes; 0 to ask for the length only.
/// @param needed NULL, or receives the length of the text with its NUL, also if the
/// buffer is too small.
/// @return CRITREG_TOO_SMALL (nothing but needed is written); CRITREG_INVALID_ARGUMENT for
/// a name that is none in C, and for a region about relations between bodies or angles
/// with a symmetry, which cannot be written; CRITREG_NULL_POINTER, CRITREG_MISALIGNED,
/// CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_region_to_c(
    region: *const critreg_region,
    name: *const c_char,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        handle::read(region, |region| {
            let name = pointer::text(name, NAME_MAX, "name").map_err(|failure| match failure {
                Failure::Core(Error::CapacityExceeded(_)) => {
                    Failure::invalid("the name is too long")
                }
                other => other,
            })?;
            let write =
                |out: &mut dyn fmt::Write| Ok(region.region.write_c(region.domain, name, out)?);
            text::write_by(write, text, len, needed)
        })
    }
}

/// Writes a region as a module of Rust that needs the crate libm only, and neither std nor a
/// heap: contains(), margins(), intervals() and sample(), which say what those of
/// critreg_region_to_c() do, and are there where those are.
///
/// What is computed is what the library computes, equal to the last bit.
///
/// @param region The region.
/// @param precision What the module computes with: CRITREG_F64 or CRITREG_F32.
/// @param text Receives the module, ended by NUL.
/// @param len Length of text in bytes; 0 to ask for the length only.
/// @param needed NULL, or receives the length of the text with its NUL, also if the
/// buffer is too small.
/// @return CRITREG_INVALID_ARGUMENT for another precision; otherwise as
/// critreg_region_to_c().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_region_to_rust(
    region: *const critreg_region,
    precision: u32,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        handle::read(region, |handle| {
            let critreg_region { region, domain, .. } = handle;
            let write = |out: &mut dyn fmt::Write| match precision {
                CRITREG_F64 => Ok(region.write_rust::<f64>(domain, out)?),
                CRITREG_F32 => Ok(region.write_rust::<f32>(domain, out)?),
                _ => Err(Failure::invalid("there is no precision with this number")),
            };
            text::write_by(write, text, len, needed)
        })
    }
}
