//! What a learner is told to do.

#[cfg(feature = "algorithm1")]
use crate::boundary::pointer;
use crate::boundary::precision::Precision;
use crate::boundary::status::{Failure, Fallible, critreg_status, status_of};
use crate::boundary::structs::{self, Versioned};
use crate::learner::any::Capacity;
use crate::learner::report::critreg_progress;
use core::ffi::c_void;
use core::mem::offset_of;
use critreg_core::Error;
#[cfg(feature = "algorithm1")]
use critreg_core::domain::Domain;
#[cfg(feature = "algorithm1")]
use critreg_core::learn::algorithm1;
use critreg_core::learn::{MAX_QUESTIONS, version_space};
#[cfg(feature = "algorithm1")]
use critreg_core::region::Theta;

/// For critreg_config.learner: the learner of the thesis (Algorithm 1, 4.3). It
/// prunes hypotheses "left comparison right". It is the baseline and it is
/// fragile: often it learns nothing, and says so with CRITREG_NO_REGION.
pub const CRITREG_ALGORITHM1: u32 = 1;

/// For critreg_config.learner: the sound learner, and the default. It keeps every
/// hypothesis that agrees with the outcomes, asks where they disagree, names the thresholds it
/// finds, says what supports each constraint, and certifies the region by draws
/// from it. Where none explains the outcomes it says CRITREG_NO_REGION.
pub const CRITREG_VERSION_SPACE: u32 = 2;

/// Observations a learner has room for unless the configuration tells: this many,
/// or calls + 2 if that is more.
pub const CRITREG_DEFAULT_OBSERVATIONS: u32 = 256;

/// Forms that critreg_learner_size() makes room for unless the configuration
/// tells.
pub const CRITREG_DEFAULT_FORMS: u32 = 4096;

/// Most forms that a learner takes without being told how many.
pub const CRITREG_MAX_DEFAULT_FORMS: u32 = 1 << 24;

/// Problem instances a learner has room for unless the configuration tells.
pub const CRITREG_DEFAULT_INSTANCES: u32 = 16;

/// Questions that can be open at once unless the configuration tells.
pub const CRITREG_DEFAULT_QUESTIONS: u32 = 16;

/// Most questions that can be open at once.
pub const CRITREG_MAX_QUESTIONS: u32 = 64;

const _: () = assert!(CRITREG_MAX_QUESTIONS as usize == MAX_QUESTIONS);

/// Most steps of a sequence of actions.
pub const CRITREG_MAX_STEPS: u32 = 4;

/// Most observations of CRITREG_VERSION_SPACE; 256 in a library that was built without
/// the feature many_observations.
pub const CRITREG_MAX_OBSERVATIONS: u32 = 2048;

const _: () = assert!(version_space::MAX_OBSERVATIONS <= CRITREG_MAX_OBSERVATIONS as usize);

/// Fewest forms that make a learner: the four comparisons of one pair.
pub(crate) const FEWEST_FORMS: usize = 4;

/// What a learner does. Fill it with critreg_config_init() and change what you
/// like. Nothing in it is kept after critreg_learner_init() returns, except the
/// progress callback and its data.
///
/// A field of one learner is ignored by the other.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct critreg_config {
    /// Size of this struct in bytes, from critreg_config_init().
    pub struct_size: u32,
    /// Which learner: CRITREG_VERSION_SPACE, the default, or CRITREG_ALGORITHM1.
    pub learner: u32,
    /// Seed of all random choices. Default 0. The same seed, domain, instances,
    /// capacities and outcomes give the same region on every machine.
    pub seed: u64,
    /// Forms to have room for, at least 4: the differences of two features that
    /// CRITREG_VERSION_SPACE bounds, or the comparisons of two features that are the
    /// hypotheses of CRITREG_ALGORITHM1. More reach more complex constraints and take
    /// more time per sample. Default 0: what the memory has room for.
    pub forms: u32,
    /// Samples to have room for. When they are used up, telling returns
    /// CRITREG_CAPACITY_EXCEEDED. CRITREG_VERSION_SPACE takes at most
    /// CRITREG_MAX_OBSERVATIONS. Default 0: CRITREG_DEFAULT_OBSERVATIONS, or
    /// calls + 2 if that is more; with critreg_observe() say how many it takes in all.
    pub observations: u32,
    /// Outcomes that CRITREG_VERSION_SPACE asks for in all; samples that
    /// CRITREG_ALGORITHM1 draws itself (K of the thesis), beside its manual ones.
    /// Default 100.
    pub calls: u32,
    /// CRITREG_VERSION_SPACE: how many draws from the region certify it, with the last
    /// calls. With noise a draw takes several calls, of which they get a quarter of all at
    /// most. Default 10.
    pub certifying: u32,
    /// CRITREG_VERSION_SPACE: problem instances to have room for, at least 1.
    /// Learning from more returns CRITREG_CAPACITY_EXCEEDED. Default
    /// CRITREG_DEFAULT_INSTANCES.
    pub instances: u32,
    /// CRITREG_VERSION_SPACE: steps of the sequence of actions that is learned
    /// about, from 1 to CRITREG_MAX_STEPS; see critreg_outcome. Default 1.
    pub steps: u32,
    /// CRITREG_VERSION_SPACE: share of the outcomes that is wrong, from 0 to 0.2. If
    /// it is not 0, samples are asked again until the outcome is beyond doubt:
    /// noise costs calls. Default 0.
    pub noise: f64,
    /// CRITREG_VERSION_SPACE: share of the queries that look for what nothing
    /// hints at, from 0 to 1. Default 0.1.
    pub exploring: f64,
    /// CRITREG_VERSION_SPACE: how far the boundary of a constraint may lie elsewhere
    /// in single instances, as a share of what its left side ranges over, from 0 to
    /// 0.2: for actions that work a little beyond a boundary or fail a little before
    /// it. With 0 the region agrees with every answer. Default 0.05.
    pub slack: f64,
    /// CRITREG_VERSION_SPACE: confidence of the certificate, from 0 to 0.9999.
    /// Default 0.95.
    pub confidence: f64,
    /// CRITREG_ALGORITHM1: parameters that are expected to fail (z- of the thesis),
    /// tried first in the first instance: one number per parameter of the domain,
    /// within its range. Copied. Default NULL: not tried.
    pub negative: *const f64,
    /// CRITREG_ALGORITHM1: parameters that are expected to work (z+ of the thesis),
    /// tried next in the first instance. Copied. Default NULL: not tried.
    pub positive: *const f64,
    /// Called after every sample that critreg_learn_region() tries. Default NULL.
    pub progress: critreg_progress,
    /// Passed to the progress callback. Default NULL.
    pub progress_data: *mut c_void,
    /// CRITREG_VERSION_SPACE: of how many forms, the simplest ones, it is tracked what
    /// the outcomes say about them. That of the others is computed whenever it is
    /// needed: the region is the same, for less memory and more time. Default
    /// UINT32_MAX: of all.
    pub tracked: u32,
    /// What is computed with: CRITREG_F64, the default, or CRITREG_F32. A library that
    /// was built without one of them refuses it with CRITREG_INVALID_ARGUMENT.
    pub precision: u32,
    /// CRITREG_VERSION_SPACE: forms more to have room for whose right side is a sum of sizes
    /// ("board.half - item.half", "0.4 * stack.width"), whose left side is derived ("hand.x +
    /// hand.y", coordinates in the frame of an object, a parameter times a size), or that are
    /// conditions on the scene alone ("part.width <= gripper.open"). They are looked for
    /// where the others explain the outcomes at length or not at all. Default UINT32_MAX: a
    /// sixteenth of forms, at most 512. 0: none.
    pub sums: u32,
    /// CRITREG_VERSION_SPACE: which share of the region must work at least where no region
    /// agrees with all outcomes, from 0.5 to 0.999. The learner then looks for the largest
    /// such region, and spends a quarter of the calls to estimate how good it is. Default 0.95.
    pub precision_wanted: f64,
    /// CRITREG_VERSION_SPACE: questions that can be open at once, from 1 to
    /// CRITREG_MAX_QUESTIONS; see critreg_ask_many(). Default CRITREG_DEFAULT_QUESTIONS; for
    /// each one more critreg_learner_size() tells CRITREG_QUESTION_BYTES more.
    pub questions: u32,
}

// SAFETY: it is repr(C) and starts with struct_size.
unsafe impl Versioned for critreg_config {
    const FIRST: usize = offset_of!(critreg_config, tracked);
}

fn defaults() -> critreg_config {
    let settings = version_space::Config::default();
    critreg_config {
        struct_size: size_of::<critreg_config>() as u32,
        learner: CRITREG_VERSION_SPACE,
        seed: settings.seed,
        forms: 0,
        observations: 0,
        calls: settings.calls,
        certifying: settings.certifying,
        instances: CRITREG_DEFAULT_INSTANCES,
        steps: 1,
        noise: settings.noise,
        exploring: settings.exploring,
        slack: settings.slack,
        confidence: settings.confidence,
        negative: core::ptr::null(),
        positive: core::ptr::null(),
        progress: None,
        progress_data: core::ptr::null_mut(),
        tracked: u32::MAX,
        precision: Precision::DEFAULT.number(),
        sums: u32::MAX,
        precision_wanted: settings.precision_wanted,
        questions: CRITREG_DEFAULT_QUESTIONS,
    }
}

/// Reads a configuration, NULL being the default.
///
/// # Safety
/// If the pointer is not NULL and aligned, its `struct_size` is readable and as
/// many bytes are.
pub(crate) unsafe fn read(config: *const critreg_config) -> Fallible<critreg_config> {
    if config.is_null() {
        return Ok(defaults());
    }
    // SAFETY: by this function's contract.
    let known = unsafe { structs::read(config, defaults(), "config")? };
    known.precision()?;
    match known.learner {
        CRITREG_VERSION_SPACE => Ok(known),
        #[cfg(feature = "algorithm1")]
        CRITREG_ALGORITHM1 => Ok(known),
        #[cfg(not(feature = "algorithm1"))]
        CRITREG_ALGORITHM1 => Err(Failure::invalid(
            "the library was built without this learner",
        )),
        _ => Err(Failure::invalid("there is no learner with this number")),
    }
}

impl critreg_config {
    pub(crate) fn precision(&self) -> Fallible<Precision> {
        Precision::new(self.precision)
    }

    /// The capacities it asks for; no forms means as many as there is room.
    pub(crate) fn capacity(&self) -> Fallible<Capacity> {
        let enough = self.calls.saturating_add(2);
        let observations = match self.observations {
            0 => enough.max(CRITREG_DEFAULT_OBSERVATIONS),
            told => told,
        };
        if (1..FEWEST_FORMS).contains(&(self.forms as usize)) {
            return Err(Failure::invalid("a learner needs at least four forms"));
        }
        #[cfg(feature = "algorithm1")]
        if self.learner == CRITREG_ALGORITHM1 {
            return Ok(Capacity::Algorithm1(algorithm1::Capacity {
                hypotheses: self.forms as usize,
                observations: observations as usize,
            }));
        }
        if !(1..=CRITREG_MAX_STEPS).contains(&self.steps) {
            return Err(Failure::invalid("a learner has one to four steps"));
        }
        if self.instances == 0 {
            return Err(Failure::invalid("a learner has at least one instance"));
        }
        if !(1..=CRITREG_MAX_QUESTIONS).contains(&self.questions) {
            return Err(Failure::invalid(
                "config.questions: a learner has room for 1 to 64 open questions",
            ));
        }
        if observations as usize > version_space::MAX_OBSERVATIONS {
            return Err(Failure::invalid(
                "this learner has room for at most 2048 observations, or 256 in a small build",
            ));
        }
        Ok(Capacity::VersionSpace(version_space::Capacity {
            forms: self.forms as usize,
            tracked: self.tracked as usize,
            observations: observations as usize,
            instances: self.instances as usize,
            steps: self.steps as usize,
            sums: self.sums as usize,
            questions: self.questions as usize,
        }))
    }

    /// What [`critreg_core::learn::Algorithm1`] wants to know.
    ///
    /// # Safety
    /// `negative` and `positive`, if not NULL and aligned, have a readable number
    /// for every parameter of the domain.
    #[cfg(feature = "algorithm1")]
    pub(crate) unsafe fn algorithm1(&self, domain: &Domain<'_>) -> Fallible<algorithm1::Config> {
        // SAFETY: by this function's contract, for both.
        let (negative, positive) = unsafe {
            (
                sample(self.negative, domain, "config.negative")?,
                sample(self.positive, domain, "config.positive")?,
            )
        };
        Ok(algorithm1::Config {
            seed: self.seed,
            iterations: self.calls,
            negative,
            positive,
        })
    }

    /// What [`critreg_core::learn::VersionSpace`] wants to know.
    pub(crate) fn version_space(&self) -> Fallible<version_space::Config> {
        let shares = [
            self.noise,
            self.exploring,
            self.slack,
            self.confidence,
            self.precision_wanted,
        ];
        if !shares.iter().all(|share| share.is_finite()) {
            return Err(Error::NotFinite("a share of the configuration").into());
        }
        Ok(self.shares())
    }

    /// The same, whatever its shares are.
    pub(crate) fn shares(&self) -> version_space::Config {
        version_space::Config {
            seed: self.seed,
            calls: self.calls,
            certifying: self.certifying,
            exploring: self.exploring,
            noise: self.noise,
            slack: self.slack,
            precision_wanted: self.precision_wanted,
            confidence: self.confidence,
            ..version_space::Config::default()
        }
    }
}

/// # Safety
/// As for [`critreg_config::algorithm1`].
#[cfg(feature = "algorithm1")]
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
    // SAFETY: the header makes it the caller's promise.
    status_of(unsafe { structs::init(config, size, defaults()) })
}
