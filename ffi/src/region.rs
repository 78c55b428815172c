//! Regions in memory, as text and as bytes.

use crate::boundary::handle::{self, Handle};
use crate::boundary::limits::CRITREG_DOMAIN_TEXT_MAX;
use crate::boundary::memory::{ALIGNMENT, RegionLayout};
use crate::boundary::pointer::{self, Output};
use crate::boundary::precision::Precision;
use crate::boundary::status::{Failure, Fallible, critreg_status, status_of};
use crate::boundary::text;
use core::ffi::{c_char, c_void};
use core::fmt;
use critreg_core::Error;
use critreg_core::domain::Domain;
use critreg_core::grammar::MAX_CONSTRAINTS;
use critreg_core::learn::version_space::Evidence;
use critreg_core::real::Real;
use critreg_core::region::{Grounded, Region, SavedRegion};

/// Longest region text in bytes, with its NUL: what saved bytes can hold.
pub(crate) const REGION_TEXT_MAX: usize = 1 << 16;

/// A region: the parameters with which an action is expected to work, as
/// constraints over a domain. It knows its domain. It either belongs to a learner
/// or lies at the start of the memory it was made in.
pub struct critreg_region {
    seal: usize,
    pub(crate) domain: &'static Domain<'static>,
    pub(crate) region: Region,
    /// What is computed with: what the learner did.
    pub(crate) precision: Precision,
    /// What supports the first constraints, in their order; a region that was
    /// parsed or loaded knows none.
    evidence: [Evidence; MAX_CONSTRAINTS],
    known: usize,
}

// SAFETY: the seal is a word of the handle, and private.
unsafe impl Handle for critreg_region {
    const KIND: u64 = 0x7265_6769_6F6E_6372;
    const NAME: &'static str = "region";

    fn seal(handle: *const Self) -> *const usize {
        // SAFETY: a place inside of the handle; nothing is read.
        unsafe { &raw const (*handle).seal }
    }
}

impl critreg_region {
    /// Writes a handle with a copy of a region, field by field, because it is large; what
    /// lay there before is lost.
    ///
    /// # Safety
    /// As for [`handle::put`].
    pub(crate) unsafe fn put(
        place: *mut critreg_region,
        domain: &'static Domain<'static>,
        region: &Region,
        precision: Precision,
        support: &[Evidence],
    ) {
        // SAFETY: by this function's contract; the fields lie inside of the handle, and it
        // is whole when it is sealed.
        unsafe {
            (&raw mut (*place).domain).write(domain);
            (&raw mut (*place).precision).write(precision);
            (&raw mut (*place).known).write(support.len());
            (&raw mut (*place).region).write(Region::default());
            (&raw mut (*place).evidence).write([Evidence::default(); MAX_CONSTRAINTS]);
            (*place).region.copy_from(region);
            for (slot, own) in (*place).evidence.iter_mut().zip(support) {
                *slot = *own;
            }
            handle::seal(place);
        }
    }

    /// What supports a constraint, if that is known.
    pub(crate) fn evidence(&self, index: usize) -> Option<Evidence> {
        let known = self.evidence.iter().take(self.known);
        known.copied().nth(index)
    }

    /// The region in an instance.
    ///
    /// # Safety
    /// If not NULL and aligned, `instance` is readable for one instance.
    pub(crate) unsafe fn ground<R: Real>(&self, instance: *const f64) -> Fallible<Grounded<'_, R>> {
        // SAFETY: by this function's contract.
        let instance = unsafe { self.instance(instance)? };
        Ok(self.region.ground(self.domain, instance)?)
    }

    /// The numbers of an instance.
    ///
    /// # Safety
    /// As for [`critreg_region::ground`].
    pub(crate) unsafe fn instance<'a>(&self, instance: *const f64) -> Fallible<&'a [f64]> {
        // SAFETY: by this function's contract.
        unsafe { pointer::slice(instance, self.domain.instance_len(), "instance") }
    }
}

impl fmt::Display for critreg_region {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.region.write(self.domain, f)
    }
}

/// Runs a call on a region.
///
/// # Safety
/// As for [`handle::open`].
pub(crate) unsafe fn with_region(
    region: *const critreg_region,
    body: impl FnOnce(&critreg_region) -> Fallible,
) -> critreg_status {
    // SAFETY: by this function's contract.
    status_of(unsafe { handle::open(region) }.and_then(body))
}

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
    status_of(texts.and_then(|(d, t)| unsafe { make(memory.cast(), memory_len, d, t, region) }))
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
/// version; and as critreg_region_parse().
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
        let (domain, text) = (saved.domain_text, saved.region_text);
        // SAFETY: as above.
        unsafe { make(memory.cast(), memory_len, domain, text, region) }
    });
    status_of(loaded)
}

/// # Safety
/// If not NULL and aligned, `memory` is writable for `memory_len` bytes, holds
/// none of the texts and is lent to this region alone; `output` is writable.
unsafe fn make(
    memory: *mut u8,
    memory_len: usize,
    domain_text: &str,
    text: &str,
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
        let domain = layout.domain.put(memory, domain_text)?;
        let region = Region::parse(domain, text)?;
        critreg_region::put(place, domain, &region, Precision::DEFAULT, &[]);
        output.write(place);
    }
    Ok(())
}

/// Writes a region with its domain as bytes: versioned, checksummed, the same on
/// every machine.
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
                Ok(handle.region.save(handle.domain, bytes)?)
            })
        }
    };
    // SAFETY: as above.
    unsafe { with_region(region, save) }
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
    unsafe { with_region(region, |handle| text::write(handle, text, len, needed)) }
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
        with_region(region, |handle| {
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
        with_region(region, |handle| {
            Output::new(count, "count")?.write(handle.domain.parameters().len());
            Ok(())
        })
    }
}
