//! Making a region from its text or its bytes.

use crate::boundary::handle;
use crate::boundary::limits::CRITREG_DOMAIN_TEXT_MAX;
use crate::boundary::memory::ALIGNMENT;
use crate::boundary::pointer::{self, Output};
use crate::boundary::precision::{Precision, in_precision};
use crate::boundary::status::{Failure, Fallible, critreg_status, status_of};
use crate::region::handle::critreg_region;
use crate::region::layout::RegionLayout;
use crate::region::quality::CRITREG_NO_QUALITY;
use core::ffi::{c_char, c_void};
use critreg_core::Error;
use critreg_core::region::SavedRegion;

/// Longest region text in bytes, with its NUL: what saved bytes can hold.
pub(crate) const REGION_TEXT_MAX: usize = 1 << 16;

/// How many bytes of memory a region takes that does not belong to a learner.
/// CRITREG_REGION_WORDS sizes a static array.
#[unsafe(no_mangle)]
pub extern "C" fn critreg_region_size() -> usize {
    RegionLayout::new().map_or(0, |layout| layout.size)
}

/// The alignment in bytes that the memory of a region needs. An array of uint64_t
/// and what malloc() returns have it.
#[unsafe(no_mangle)]
pub extern "C" fn critreg_region_align() -> usize {
    ALIGNMENT
}

/// Makes a region from its text, in memory of the program.
///
/// ```c
/// static uint64_t memory[CRITREG_REGION_WORDS];
/// critreg_region *region;
/// status = critreg_region_parse(memory, sizeof memory, DOMAIN,
///                               "grasp.y <= zone.top - robot.radius", &region);
/// ```
///
/// @param memory Memory for the region, aligned to critreg_region_align(). From
/// now on it belongs to the region: do not write to it, move it or copy it.
/// @param memory_len Its length in bytes, at least critreg_region_size().
/// @param domain The domain text, ended by NUL. Copied.
/// @param text The region text, ended by NUL. Copied.
/// @param region Receives the handle, which lies at the start of the memory.
/// @return CRITREG_TOO_SMALL; CRITREG_SYNTAX_ERROR (ask critreg_check_region()
/// where); CRITREG_CAPACITY_EXCEEDED if a text is too long or has too many parts;
/// CRITREG_INVALID_ARGUMENT if one is not UTF-8; CRITREG_NULL_POINTER,
/// CRITREG_MISALIGNED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_region_parse(
    memory: *mut c_void,
    memory_len: usize,
    domain: *const c_char,
    text: *const c_char,
    region: *mut *mut critreg_region,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise.
    let texts = unsafe {
        pointer::text(domain, CRITREG_DOMAIN_TEXT_MAX, "domain").and_then(|domain| {
            let text = pointer::text(text, REGION_TEXT_MAX, "text")?;
            Ok((domain, text))
        })
    };
    // SAFETY: as above.
    status_of(texts.and_then(|(domain, text)| unsafe {
        let written = Written {
            domain,
            text,
            precision: Precision::DEFAULT,
        };
        make(memory.cast(), memory_len, &written, region)
    }))
}

/// Makes a region from bytes that critreg_region_save() wrote, in memory of the
/// program.
///
/// @param memory Memory for the region, as for critreg_region_parse().
/// @param memory_len Its length in bytes, at least critreg_region_size().
/// @param bytes The saved bytes.
/// @param len How many there are.
/// @param region Receives the handle, which lies at the start of the memory.
/// @return CRITREG_CORRUPT if the bytes are damaged, incomplete or of an unknown
/// version; CRITREG_INVALID_ARGUMENT if the region computes with a precision that the
/// library was built without, CRITREG_NOT_FINITE if that cannot hold its numbers; and as
/// critreg_region_parse().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_region_load(
    memory: *mut c_void,
    memory_len: usize,
    bytes: *const u8,
    len: usize,
    region: *mut *mut critreg_region,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise.
    let saved = unsafe { pointer::slice(bytes, len, "bytes") };
    let loaded = saved.and_then(|bytes| {
        let saved = SavedRegion::read(bytes)?;
        if saved.domain_text.len() >= CRITREG_DOMAIN_TEXT_MAX {
            return Err(Error::CapacityExceeded("the domain text is too long").into());
        }
        let written = Written {
            domain: saved.domain_text,
            text: saved.region_text,
            precision: Precision::new(saved.bits.into())?,
        };
        // SAFETY: as above.
        unsafe { make(memory.cast(), memory_len, &written, region) }
    });
    status_of(loaded)
}

/// What a region is made from.
struct Written<'t> {
    domain: &'t str,
    text: &'t str,
    precision: Precision,
}

/// # Safety
/// If not NULL and aligned, `memory` is writable for `memory_len` bytes, holds
/// none of the texts and is lent to this region alone; `output` is writable.
unsafe fn make(
    memory: *mut u8,
    memory_len: usize,
    written: &Written<'_>,
    output: *mut *mut critreg_region,
) -> Fallible {
    pointer::check(memory.cast::<u64>(), "memory")?;
    let layout = RegionLayout::new()
        .filter(|layout| layout.size <= memory_len)
        .ok_or(Failure::TooSmall("the memory of the region"))?;
    // SAFETY: by this function's contract; the memory was checked for alignment
    // and length, and the parts of a layout do not overlap.
    unsafe {
        let output = Output::new(output, "region")?;
        let place = layout.handle.place(memory);
        // If this fails, a region that was here before is one no more.
        handle::retire(place);
        let domain = layout.domain.put(memory, written.domain)?;
        let precision = written.precision;
        critreg_region::put(place, domain, precision, (&[], CRITREG_NO_QUALITY), |own| {
            own.read(domain, written.text)?;
            in_precision!(precision, R => own.check_precision::<R>(domain)?);
            Ok(())
        })?;
        output.write(place);
    }
    Ok(())
}
