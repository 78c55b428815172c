//! The structs that a program fills or reads.

use crate::pointer;
use crate::status::{Failure, Fallible, critreg_status, status_of};
use core::ffi::c_void;
use core::mem::MaybeUninit;
use critreg_core::domain::Domain;
use critreg_core::learn::{self, Capacity};
use critreg_core::region::Theta;

/// For critreg_config.learner: the learner of the thesis (Algorithm 1, 4.3). It
/// prunes hypotheses "left comparison right". It is the baseline and it is
/// fragile: often it learns nothing, and says so with CRITREG_NO_REGION.
pub const CRITREG_ALGORITHM1: u32 = 1;

/// Observations a learner has room for unless the configuration tells: this many,
/// or iterations + 2 if that is more.
pub const CRITREG_DEFAULT_OBSERVATIONS: u32 = 256;

/// Most hypotheses that a learner takes without being told how many.
pub const CRITREG_MAX_DEFAULT_HYPOTHESES: u32 = 1 << 24;

/// In a critreg_report: this did not happen (yet).
pub const CRITREG_NOT_RUN: u64 = u64::MAX;

/// How learning went so far. Counts of hypotheses count every comparison of two
/// features on its own.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct critreg_report {
    /// Size of this struct in bytes, from critreg_report_init().
    pub struct_size: u32,
    /// Always 0.
    pub reserved: u32,
    /// Hypotheses that the grammar makes of the domain.
    pub enumerated: u64,
    /// Those the learner started with.
    pub kept: u64,
    /// Those that found no room in the memory: the most complex ones.
    pub left_out: u64,
    /// Hypotheses left after the negative sample, or CRITREG_NOT_RUN.
    pub after_negative: u64,
    /// Hypotheses left after the positive sample, or CRITREG_NOT_RUN.
    pub after_positive: u64,
    /// Hypotheses left now.
    pub remaining: u64,
    /// Samples told: calls of the simulator.
    pub calls: u64,
    /// Samples told that were feasible.
    pub feasible: u64,
    /// Constraints that found no room in the region.
    pub constraints_left_out: u64,
}

/// Called by critreg_learn_region() after every sample.
///
/// @param progress_data That of the configuration.
/// @param report How learning went so far; valid until the callback returns.
/// @return CRITREG_OK to go on. Anything else stops learning and becomes the
/// status of critreg_learn_region(): CRITREG_CANCELLED, or CRITREG_USER_STATUS
/// and above. What was learned so far stays, and learning can go on later.
pub type critreg_progress = Option<
    unsafe extern "C" fn(
        progress_data: *mut c_void,
        report: *const critreg_report,
    ) -> critreg_status,
>;

/// What a learner does. Fill it with critreg_config_init() and change what you
/// like. Nothing in it is kept after critreg_learner_init() returns, except the
/// progress callback and its data.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct critreg_config {
    /// Size of this struct in bytes, from critreg_config_init().
    pub struct_size: u32,
    /// Which learner: CRITREG_ALGORITHM1.
    pub learner: u32,
    /// Seed of all random choices. Default 0. The same seed, domain, instances,
    /// capacities and answers give the same region on every machine.
    pub seed: u64,
    /// Hypotheses to have room for: each takes a quarter of a byte, and 1.25 bytes
    /// for its features. More reach more complex constraints and take more time
    /// per sample. Default 0: what the memory has room for.
    pub hypotheses: u32,
    /// Samples to have room for, 56 bytes each. When they are used up, telling
    /// returns CRITREG_CAPACITY_EXCEEDED. Default 0: CRITREG_DEFAULT_OBSERVATIONS,
    /// or iterations + 2 if that is more.
    pub observations: u32,
    /// Samples that the learner draws itself (K of the thesis). Default 100.
    pub iterations: u32,
    /// Must be 0.
    pub reserved: u32,
    /// Parameters that are expected to fail (z- of the thesis), tried first in the
    /// first instance: one number per parameter of the domain, within its range.
    /// Copied. Default NULL: not tried.
    pub negative: *const f64,
    /// Parameters that are expected to work (z+ of the thesis), tried next in the
    /// first instance. Copied. Default NULL: not tried.
    pub positive: *const f64,
    /// Called after every sample that critreg_learn_region() tries. Default NULL.
    pub progress: critreg_progress,
    /// Passed to the progress callback. Default NULL.
    pub progress_data: *mut c_void,
}

/// Sizes of the first versions of the structs: smaller ones never existed.
const FIRST_CONFIG: usize = size_of::<critreg_config>();
const FIRST_REPORT: usize = size_of::<critreg_report>();

const DEFAULT: critreg_config = critreg_config {
    struct_size: size_of::<critreg_config>() as u32,
    learner: CRITREG_ALGORITHM1,
    seed: 0,
    hypotheses: 0,
    observations: 0,
    iterations: 100,
    reserved: 0,
    negative: core::ptr::null(),
    positive: core::ptr::null(),
    progress: None,
    progress_data: core::ptr::null_mut(),
};

impl critreg_report {
    pub(crate) fn new(report: learn::Report) -> Self {
        let counted = |count: Option<usize>| count.map_or(CRITREG_NOT_RUN, |n| n as u64);
        critreg_report {
            struct_size: size_of::<Self>() as u32,
            reserved: 0,
            enumerated: report.enumeration.enumerated,
            kept: report.enumeration.kept,
            left_out: report.enumeration.left_out,
            after_negative: counted(report.after_negative),
            after_positive: counted(report.after_positive),
            remaining: report.remaining as u64,
            calls: report.calls as u64,
            feasible: report.feasible as u64,
            constraints_left_out: report.constraints_left_out as u64,
        }
    }

    /// Writes it into a struct of the caller, which may be an older, shorter one.
    ///
    /// # Safety
    /// If the pointer is not NULL and aligned, its `struct_size` is readable and
    /// as many bytes are writable.
    pub(crate) unsafe fn write_to(mut self, report: *mut critreg_report) -> Fallible {
        pointer::check(report, "report")?;
        // SAFETY: checked; readable by this function's contract.
        let size = unsafe { (&raw const (*report).struct_size).read() };
        let bytes = known_size(size as usize, FIRST_REPORT, size_of::<Self>())?;
        self.struct_size = size;
        // SAFETY: `bytes` is at most the size of either struct.
        unsafe {
            core::ptr::copy_nonoverlapping((&raw const self).cast::<u8>(), report.cast(), bytes);
        }
        Ok(())
    }
}

fn known_size(size: usize, first: usize, now: usize) -> Fallible<usize> {
    if (first..=now).contains(&size) {
        Ok(size)
    } else {
        Err(Failure::invalid(
            "struct_size is not one this library knows: call the init function of the struct",
        ))
    }
}

/// Reads a configuration, NULL being the default.
///
/// # Safety
/// If the pointer is not NULL and aligned, its `struct_size` is readable and as
/// many bytes are.
pub(crate) unsafe fn read(config: *const critreg_config) -> Fallible<critreg_config> {
    let mut known = DEFAULT;
    if config.is_null() {
        return Ok(known);
    }
    pointer::check(config, "config")?;
    // SAFETY: checked; readable by this function's contract.
    let size = unsafe { (&raw const (*config).struct_size).read() };
    let bytes = known_size(size as usize, FIRST_CONFIG, size_of::<critreg_config>())?;
    // SAFETY: `bytes` is at most the size of either struct; both are repr(C), and
    // every bit pattern that C can have written is valid for the fields.
    unsafe {
        core::ptr::copy_nonoverlapping(config.cast::<u8>(), (&raw mut known).cast(), bytes);
    }
    if known.learner != CRITREG_ALGORITHM1 {
        return Err(Failure::invalid("there is no learner with this number"));
    }
    if known.reserved != 0 {
        return Err(Failure::invalid("reserved must be 0"));
    }
    Ok(known)
}

impl critreg_config {
    /// The capacities it asks for; no hypotheses means as many as there is room.
    pub(crate) fn capacity(&self) -> Capacity {
        let enough = self.iterations.saturating_add(2);
        let observations = match self.observations {
            0 => enough.max(CRITREG_DEFAULT_OBSERVATIONS),
            told => told,
        };
        Capacity {
            hypotheses: self.hypotheses as usize,
            observations: observations as usize,
        }
    }

    /// What the core learner wants to know.
    ///
    /// # Safety
    /// `negative` and `positive`, if not NULL and aligned, have a readable number
    /// for every parameter of the domain.
    pub(crate) unsafe fn settings(&self, domain: &Domain<'_>) -> Fallible<learn::Config> {
        // SAFETY: by this function's contract, for both.
        let (negative, positive) = unsafe {
            (
                sample(self.negative, domain, "config.negative")?,
                sample(self.positive, domain, "config.positive")?,
            )
        };
        Ok(learn::Config {
            seed: self.seed,
            iterations: self.iterations,
            negative,
            positive,
        })
    }
}

/// # Safety
/// As for [`critreg_config::settings`].
unsafe fn sample(
    numbers: *const f64,
    domain: &Domain<'_>,
    name: &'static str,
) -> Fallible<Option<Theta>> {
    if numbers.is_null() {
        return Ok(None);
    }
    // SAFETY: by this function's contract.
    let numbers = unsafe { pointer::slice(numbers, domain.parameters().len(), name)? };
    let mut theta = Theta::default();
    for (value, number) in theta.iter_mut().zip(numbers) {
        *value = *number;
    }
    Ok(Some(theta))
}

/// # Safety
/// If the pointer is not NULL and aligned, `size` bytes are writable.
unsafe fn init<T: Copy>(target: *mut T, size: usize, first: usize, value: T) -> Fallible {
    pointer::check(target, "the struct")?;
    let bytes = known_size(size, first, size_of::<T>())?;
    let value = MaybeUninit::new(value);
    // SAFETY: `bytes` is at most the size of the value and of the caller's struct.
    unsafe { core::ptr::copy_nonoverlapping(value.as_ptr().cast::<u8>(), target.cast(), bytes) };
    Ok(())
}

/// Fills a configuration with the defaults.
///
/// @param config The configuration.
/// @param size sizeof *config. It lets a program that was compiled with an older
/// header run with a newer library: the library writes and reads no more.
/// @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED; CRITREG_INVALID_ARGUMENT if
/// size is smaller than the struct ever was, or larger than this library knows.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_config_init(
    config: *mut critreg_config,
    size: usize,
) -> critreg_status {
    let mut value = DEFAULT;
    value.struct_size = u32::try_from(size).unwrap_or(0);
    // SAFETY: the header makes it the caller's promise.
    status_of(unsafe { init(config, size, FIRST_CONFIG, value) })
}

/// Prepares a report for critreg_learner_report().
///
/// @param report The report.
/// @param size sizeof *report; see critreg_config_init().
/// @return As critreg_config_init().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_report_init(
    report: *mut critreg_report,
    size: usize,
) -> critreg_status {
    let mut value = critreg_report::new(learn::Report::default());
    value.struct_size = u32::try_from(size).unwrap_or(0);
    // SAFETY: the header makes it the caller's promise.
    status_of(unsafe { init(report, size, FIRST_REPORT, value) })
}
