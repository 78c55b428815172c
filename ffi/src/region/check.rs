//! What is wrong with a domain text or a region text, in words.

use crate::boundary::limits::CRITREG_DOMAIN_TEXT_MAX;
use crate::boundary::pointer;
use crate::boundary::status::{Failure, Fallible, critreg_status};
use crate::boundary::text::explain;
use crate::region::making::REGION_TEXT_MAX;
use core::ffi::c_char;
use core::fmt;
use critreg_core::Error;
use critreg_core::domain::{Domain, MAX_SAMPLE_POINTS, Name};
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
        let (checked, meant) = check_domain(domain);
        explain_meant(checked, meant, text, len, needed)
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
        let (checked, meant) = check_region(domain, region_text);
        explain_meant(checked, meant, text, len, needed)
    }
}

const _: () = assert!(MAX_SAMPLE_POINTS == 8, "an error names it");

/// Whether a learner has room for the points that move with a parameter.
fn check_points(domain: &Domain<'_>) -> Fallible {
    let moving = domain.points().iter().filter(|point| point.sampled).count();
    if moving > MAX_SAMPLE_POINTS {
        let count = u32::try_from(moving).unwrap_or(u32::MAX);
        return Err(Failure::TooMany(
            count,
            "points move with a parameter, 8 fit",
        ));
    }
    Ok(())
}

/// What is wrong with a text, and which name was meant where there is none.
type Checked = (Fallible, Option<Name<'static>>);

/// With a text that could not be read, which of the domain's names was meant.
fn with_meant(checked: Fallible, domain: &Domain<'static>, text: &str) -> Checked {
    let meant = match checked {
        Err(Failure::Core(Error::Syntax(error))) => domain.similar(text, &error),
        _ => None,
    };
    (checked, meant)
}

/// What is large is on the stack while this runs, and no more when words are written.
///
/// # Safety
/// If not NULL, the text can be read up to its NUL, until the words are written.
#[inline(never)]
unsafe fn check_domain(domain: *const c_char) -> Checked {
    // SAFETY: by this function's contract.
    let text = match unsafe { pointer::text(domain, CRITREG_DOMAIN_TEXT_MAX, "domain") } {
        Ok(text) => text,
        Err(failure) => return (Err(failure), None),
    };
    let mut domain = Domain::empty();
    let read = domain.read(text).map_err(Failure::from);
    with_meant(read.and_then(|()| check_points(&domain)), &domain, text)
}

/// # Safety
/// If not NULL, the texts can be read up to their NUL, until the words are written.
#[inline(never)]
unsafe fn check_region(domain: *const c_char, region_text: *const c_char) -> Checked {
    // SAFETY: by this function's contract.
    let texts = unsafe {
        let domain = pointer::text(domain, CRITREG_DOMAIN_TEXT_MAX, "domain");
        domain.map(|domain| {
            (
                domain,
                pointer::text(region_text, REGION_TEXT_MAX, "region_text"),
            )
        })
    };
    let (domain_text, text) = match texts {
        Ok(texts) => texts,
        Err(failure) => return (Err(failure), None),
    };
    let mut domain = Domain::empty();
    if let Err(error) = domain.read(domain_text) {
        return with_meant(Err(error.into()), &domain, domain_text);
    }
    let text = match text {
        Ok(text) => text,
        Err(failure) => return (Err(failure), None),
    };
    let mut region = Region::default();
    let read = region.read(&domain, text).map_err(Failure::from);
    with_meant(read, &domain, text)
}

/// What is wrong, and what was meant.
struct Words(Fallible, Option<Name<'static>>);

impl fmt::Display for Words {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Words(Err(failure), meant) = self else {
            return Ok(());
        };
        match meant {
            Some(name) => write!(f, "{failure}; did you mean {name}?"),
            None => write!(f, "{failure}"),
        }
    }
}

/// # Safety
/// As for [`text::write_cut_off`].
unsafe fn explain_meant(
    checked: Fallible,
    meant: Option<Name<'static>>,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: by this function's contract.
    unsafe { explain(&Words(checked, meant), checked, text, len, needed) }
}
