//! What is wrong with a domain text or a region text, in words.

use crate::boundary::limits::CRITREG_DOMAIN_TEXT_MAX;
use crate::boundary::pointer;
use crate::boundary::status::{Failure, Fallible, critreg_status};
use crate::boundary::text::explain;
use crate::region::making::REGION_TEXT_MAX;
use core::ffi::c_char;
use critreg_core::domain::{Domain, MAX_SAMPLE_POINTS};
use critreg_core::region::Region;

/// Reads a domain text and says what is wrong with it, such as
/// "line 3, column 7: unknown object".
///
/// @param domain The domain text, ended by NUL.
/// @param text Receives the words, ended by NUL: an empty text if all is well.
/// They are written also if the check fails, which is what they are for, and cut
/// off where the buffer ends. 256 bytes are always enough.
/// @param len Length of text in bytes; 0 if the words are not wanted.
/// @param needed NULL, or receives the length of the words with their NUL.
/// @return CRITREG_OK if the text is a domain; CRITREG_SYNTAX_ERROR; CRITREG_CAPACITY_EXCEEDED if it is
/// longer than CRITREG_DOMAIN_TEXT_MAX or declares too many things;
/// CRITREG_INVALID_ARGUMENT if it is not UTF-8; CRITREG_NULL_POINTER,
/// CRITREG_MISALIGNED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_check_domain(
    domain: *const c_char,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for both.
    unsafe {
        let checked = check_domain(domain);
        explain(checked, text, len, needed)
    }
}

/// Reads a region text and says what is wrong with it.
///
/// @param domain The domain text that the region speaks about, ended by NUL.
/// @param region_text The region text, ended by NUL.
/// @param text Receives the words, as for critreg_check_domain(). If the domain
/// text is wrong, they are about that.
/// @param len Length of text in bytes; 0 if the words are not wanted.
/// @param needed NULL, or receives the length of the words with their NUL.
/// @return CRITREG_OK if critreg_region_parse() would accept both texts, else as
/// critreg_check_domain().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_check_region(
    domain: *const c_char,
    region_text: *const c_char,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for both.
    unsafe {
        let checked = check_region(domain, region_text);
        explain(checked, text, len, needed)
    }
}

const _: () = assert!(MAX_SAMPLE_POINTS == 6, "an error names it");

/// Whether a learner has room for the points that move with a parameter.
fn check_points(domain: &Domain<'_>) -> Fallible {
    let moving = domain.points().iter().filter(|point| point.sampled).count();
    if moving > MAX_SAMPLE_POINTS {
        let count = u32::try_from(moving).unwrap_or(u32::MAX);
        return Err(Failure::TooMany(
            count,
            "points move with a parameter, 6 fit",
        ));
    }
    Ok(())
}

/// What is large is on the stack while this runs, and no more when words are written.
///
/// # Safety
/// If not NULL, the text can be read up to its NUL.
#[inline(never)]
unsafe fn check_domain(domain: *const c_char) -> Fallible {
    // SAFETY: by this function's contract.
    let text = unsafe { pointer::text(domain, CRITREG_DOMAIN_TEXT_MAX, "domain")? };
    let mut domain = Domain::empty();
    domain.read(text)?;
    check_points(&domain)
}

/// # Safety
/// If not NULL, the texts can be read up to their NUL.
#[inline(never)]
unsafe fn check_region(domain: *const c_char, region_text: *const c_char) -> Fallible {
    // SAFETY: by this function's contract.
    let domain_text = unsafe { pointer::text(domain, CRITREG_DOMAIN_TEXT_MAX, "domain")? };
    let mut domain = Domain::empty();
    domain.read(domain_text)?;
    // SAFETY: as above.
    let text = unsafe { pointer::text(region_text, REGION_TEXT_MAX, "region_text")? };
    let mut region = Region::default();
    Ok(region.read(&domain, text)?)
}
