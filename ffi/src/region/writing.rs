//! Writing a region as text or bytes, and what its domain is like.

use crate::boundary::handle;
use crate::boundary::pointer::Output;
use crate::boundary::precision::in_precision;
use crate::boundary::status::critreg_status;
use crate::boundary::text;
use crate::region::handle::critreg_region;
use core::ffi::c_char;

/// Writes a region with its domain and precision as bytes: versioned, checksummed, the same
/// on every machine.
///
/// @param region The region.
/// @param bytes Receives the bytes.
/// @param len Length of bytes; 0 to ask for the length only.
/// @param needed NULL, or receives how many bytes the region takes, also if the
/// buffer is too small.
/// @return CRITREG_TOO_SMALL (nothing but needed is written);
/// CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_region_save(
    region: *const critreg_region,
    bytes: *mut u8,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    let save = |handle: &critreg_region| {
        let length = handle.region.saved_len(handle.domain);
        // SAFETY: the header makes it the caller's promise.
        unsafe {
            text::write_bytes(length, bytes, len, needed, |bytes| {
                Ok(in_precision!(handle.precision, R => {
                    handle.region.save::<R>(handle.domain, bytes)?
                }))
            })
        }
    };
    // SAFETY: as above.
    unsafe { handle::read(region, save) }
}

/// Writes a region as text. Reading that text with the same domain gives the same
/// region.
///
/// @param region The region.
/// @param text Receives the text, ended by NUL.
/// @param len Length of text in bytes; 0 to ask for the length only.
/// @param needed NULL, or receives the length of the text with its NUL, also if
/// the buffer is too small.
/// @return CRITREG_TOO_SMALL (nothing but needed is written);
/// CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_region_format(
    region: *const critreg_region,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for both.
    unsafe { handle::read(region, |handle| text::write(handle, text, len, needed)) }
}

/// How many numbers an instance has: one per attribute of every object of the
/// domain, in order of declaration.
///
/// @param region The region.
/// @param len Receives the number.
/// @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_region_instance_len(
    region: *const critreg_region,
    len: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for both.
    unsafe {
        handle::read(region, |handle| {
            Output::new(len, "len")?.write(handle.domain.instance_len());
            Ok(())
        })
    }
}

/// How many parameters the action has.
///
/// @param region The region.
/// @param count Receives the number.
/// @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_region_parameter_count(
    region: *const critreg_region,
    count: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for both.
    unsafe {
        handle::read(region, |handle| {
            Output::new(count, "count")?.write(handle.domain.parameters().len());
            Ok(())
        })
    }
}
