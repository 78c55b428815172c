//! Making a learner, and what its domain is like.

use crate::boundary::handle;
use crate::boundary::limits::CRITREG_DOMAIN_TEXT_MAX;
use crate::boundary::memory::ALIGNMENT;
use crate::boundary::pointer::{self, Output};
use crate::boundary::status::{Failure, Fallible, critreg_status, status_of};
use crate::learner::config::{
    self, CRITREG_DEFAULT_FORMS, CRITREG_MAX_DEFAULT_FORMS, FEWEST_FORMS, critreg_config,
};
use crate::learner::handle::{Inner, critreg_learner};
use crate::learner::layout::LearnerLayout;
use core::ffi::{c_char, c_void};
use critreg_core::domain::Domain;

/// How many bytes of memory a learner takes.
///
/// Where the capacities are constants, CRITREG_LEARNER_WORDS() sizes a static
/// array instead.
///
/// @param config What the learner is to do, with its capacities; NULL for the
/// defaults. Where it leaves the number of forms open it is
/// CRITREG_DEFAULT_FORMS.
/// @return The number of bytes; 0 if the configuration is wrong or memory cannot
/// be that large.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_learner_size(config: *const critreg_config) -> usize {
    // SAFETY: the header makes it the caller's promise.
    let layout = unsafe { config::read(config) }.and_then(|config| {
        let mut capacity = config.capacity()?;
        if capacity.forms() == 0 {
            capacity = capacity.with_forms(CRITREG_DEFAULT_FORMS as usize);
        }
        Ok(LearnerLayout::new(capacity, config.precision()?))
    });
    layout.ok().flatten().map_or(0, |layout| layout.size)
}

/// The alignment in bytes that the memory of a learner needs. An array of
/// uint64_t and what malloc() returns have it.
#[unsafe(no_mangle)]
pub extern "C" fn critreg_learner_align() -> usize {
    ALIGNMENT
}

/// Makes a learner in memory of the program.
///
/// The capacities come from the configuration. Where it leaves the number of
/// forms open, the learner takes as many as the memory has room for beside
/// the observations, so that CRITREG_LEARNER_WORDS(4096, 256) words and a config
/// of NULL make room for at least 4096 forms and 256 samples. What is
/// learned depends on the number of forms; where the same result is wanted
/// from memory of another size, set config.forms.
///
/// A learner needs no end: reuse its memory when you are done with it. What the
/// memory held before does not matter.
///
/// @param memory Memory for the learner, aligned to critreg_learner_align(). From
/// now on it belongs to the learner: do not write to it, move it or copy it.
/// @param memory_len Its length in bytes.
/// @param domain What there is to know about the action, in the language of the
/// domain text above, ended by NUL. Copied.
/// @param config What the learner does; NULL for the defaults. Copied.
/// @param learner Receives the handle, which lies at the start of the memory.
/// @return CRITREG_TOO_SMALL if the memory is too short for the capacities;
/// CRITREG_SYNTAX_ERROR (ask critreg_check_domain() where);
/// CRITREG_CAPACITY_EXCEEDED if the text is longer than CRITREG_DOMAIN_TEXT_MAX
/// or declares too many things; CRITREG_INVALID_ARGUMENT for a domain without
/// parameters (CRITREG_ALGORITHM1 only), a text that is not UTF-8, a wrong configuration or a manual sample
/// outside of the ranges of the parameters; CRITREG_NOT_FINITE for a manual sample
/// or a share of the configuration; CRITREG_NULL_POINTER, CRITREG_MISALIGNED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_learner_init(
    memory: *mut c_void,
    memory_len: usize,
    domain: *const c_char,
    config: *const critreg_config,
    learner: *mut *mut critreg_learner,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise.
    status_of(unsafe { init(memory.cast(), memory_len, domain, config, learner) })
}

/// # Safety
/// The contract of [`critreg_learner_init`].
unsafe fn init(
    memory: *mut u8,
    memory_len: usize,
    domain: *const c_char,
    config: *const critreg_config,
    learner: *mut *mut critreg_learner,
) -> Fallible {
    pointer::check(memory.cast::<u64>(), "memory")?;
    // SAFETY: by this function's contract, for all three.
    let (text, config, output) = unsafe {
        (
            pointer::text(domain, CRITREG_DOMAIN_TEXT_MAX, "domain")?,
            config::read(config)?,
            Output::new(learner, "learner")?,
        )
    };
    let precision = config.precision()?;
    let mut capacity = config.capacity()?;
    if capacity.forms() == 0 {
        let most = CRITREG_MAX_DEFAULT_FORMS as usize;
        capacity = LearnerLayout::largest(memory_len, capacity, precision, most);
    }
    let layout = LearnerLayout::new(capacity, precision)
        .filter(|layout| layout.size <= memory_len && capacity.forms() >= FEWEST_FORMS)
        .ok_or(Failure::TooSmall("the memory of the learner"))?;
    // SAFETY: the memory was checked for NULL, alignment and length; the caller
    // lends it to this learner alone, and the parts of a layout do not overlap.
    unsafe {
        // If this fails, a learner that was here before is one no more.
        handle::retire(layout.handle.place(memory));
        let domain = layout.domain.put(memory, text)?;
        output.write(put(&layout, memory, domain, &config)?);
    }
    Ok(())
}

/// Puts a learner about a domain there. Never inlined: it takes no stack while the domain
/// is read.
///
/// # Safety
/// As for [`LearnerLayout::make`].
#[inline(never)]
unsafe fn put(
    layout: &LearnerLayout,
    memory: *mut u8,
    domain: &'static Domain<'static>,
    config: &critreg_config,
) -> Fallible<*mut critreg_learner> {
    // SAFETY: by this function's contract.
    unsafe {
        let mut inner = Inner {
            learner: layout.make(memory, domain, config)?,
            precision: layout.precision,
            steps: layout.capacity.steps(),
            region: layout.region.place(memory),
            progress: config.progress,
            progress_data: config.progress_data,
        };
        inner.retire_region();
        let place = layout.handle.place(memory);
        critreg_learner::put(place, domain, inner);
        Ok(place)
    }
}

/// How many numbers an instance has: one per attribute of every object of the
/// domain, in order of declaration.
///
/// @param learner The learner.
/// @param len Receives the number.
/// @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_learner_instance_len(
    learner: *const critreg_learner,
    len: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for both.
    unsafe {
        handle::read(learner, |handle| {
            Output::new(len, "len")?.write(handle.domain.instance_len());
            Ok(())
        })
    }
}

/// How many parameters the action has: the length of a sample.
///
/// @param learner The learner.
/// @param count Receives the number.
/// @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_learner_parameter_count(
    learner: *const critreg_learner,
    count: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for both.
    unsafe {
        handle::read(learner, |handle| {
            Output::new(count, "count")?.write(handle.domain.parameters().len());
            Ok(())
        })
    }
}
