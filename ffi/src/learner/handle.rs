//! A learner in the caller's memory.

use crate::boundary::handle::{self, Exclusive, Handle};
use crate::boundary::pointer;
use crate::boundary::precision::Precision;
use crate::boundary::status::{Failure, Fallible, critreg_status};
use crate::learner::any::AnyLearner;
use crate::learner::outcome::{self, critreg_outcome};
use crate::learner::report::{critreg_progress, critreg_report};
use crate::region::handle::critreg_region;
use core::cell::Cell;
use core::ffi::c_void;
use critreg_core::Error;
use critreg_core::domain::Domain;
use critreg_core::learn::Problem;
use critreg_core::region::Region;

/// A learner. It lies at the start of the memory it was made in.
pub struct critreg_learner {
    seal: usize,
    /// What the last call left behind, also readable from a callback.
    pub(crate) report: Cell<critreg_report>,
    pub(crate) finished: Cell<bool>,
    pub(crate) domain: &'static Domain<'static>,
    pub(crate) inner: Exclusive<Inner>,
}

/// What a call on a learner borrows.
pub(crate) struct Inner {
    pub(crate) learner: &'static mut dyn AnyLearner,
    /// What it computes with.
    pub(crate) precision: Precision,
    /// See [`Capacity::steps`](crate::learner::any::Capacity::steps).
    pub(crate) steps: Option<usize>,
    /// Room for the handle of the learned region; a part of the caller's memory.
    pub(crate) region: *mut critreg_region,
    pub(crate) progress: critreg_progress,
    pub(crate) progress_data: *mut c_void,
}

impl Inner {
    /// Makes the region handle that was given out unusable, because what it
    /// describes is about to change.
    pub(crate) fn retire_region(&mut self) {
        // SAFETY: the region's part is reserved for the handle, and nothing refers
        // to it while a function runs that changes the learner.
        unsafe { handle::retire(self.region) }
    }

    /// Tells the learner what came of the sample it asked for.
    pub(crate) fn tell(&mut self, problem: &Problem<'_>, outcome: critreg_outcome) -> Fallible {
        let outcome = outcome::read(outcome, self.steps)?;
        Ok(self.learner.tell(problem, outcome)?)
    }

    /// Copies the learned region into its handle. The copy is what makes the handle
    /// refer to no memory that the learner writes to.
    ///
    /// # Errors
    /// [`Error::NoRegion`] if its quality is less than `least`.
    #[inline(never)]
    pub(crate) fn give_region(
        &mut self,
        domain: &'static Domain<'static>,
        least: u32,
    ) -> Fallible<*const critreg_region> {
        let region = self.learner.best_region()?;
        let support = self.learner.evidence();
        let quality = self.learner.quality();
        if (1..least).contains(&quality) {
            return Err(Error::NoRegion.into());
        }
        // SAFETY: the region's part is reserved for the handle; the header forbids to
        // use the handle while a function runs that may change the learner.
        unsafe {
            let copy = |own: &mut Region| {
                own.copy_from(region);
                Ok(())
            };
            critreg_region::put(
                self.region,
                domain,
                self.precision,
                (support, quality),
                copy,
            )?;
        };
        Ok(self.region)
    }
}

// SAFETY: the seal is a word of the handle, and private.
unsafe impl Handle for critreg_learner {
    const KIND: u64 = 0x6C65_6172_6E65_7263;
    const NAME: &'static str = "learner";

    fn seal(handle: *const Self) -> *const usize {
        // SAFETY: a place inside of the handle; nothing is read.
        unsafe { &raw const (*handle).seal }
    }
}

impl critreg_learner {
    /// Writes and seals a handle; what lay there before is lost.
    ///
    /// # Safety
    /// As for [`handle::put`].
    pub(crate) unsafe fn put(
        place: *mut critreg_learner,
        domain: &'static Domain<'static>,
        inner: Inner,
    ) {
        let made = critreg_learner {
            seal: 0,
            report: Cell::new(inner.learner.report()),
            finished: Cell::new(inner.learner.is_finished()),
            domain,
            inner: Exclusive::new(inner),
        };
        // SAFETY: by this function's contract.
        unsafe { handle::put(place, made) }
    }

    /// Takes over what the inner learner has to report.
    #[inline(never)]
    pub(crate) fn publish(&self, inner: &Inner) {
        self.report.set(inner.learner.report());
        self.finished.set(inner.learner.is_finished());
    }
}

/// Runs a call on a learner: refuses it if the learner is in use, and keeps the
/// words about a failure.
///
/// # Safety
/// As for [`handle::open`].
pub(crate) unsafe fn with_learner(
    learner: *mut critreg_learner,
    body: impl FnOnce(&critreg_learner, &mut Inner) -> Fallible,
) -> critreg_status {
    // SAFETY: by this function's contract.
    match unsafe { handle::open(learner) } {
        Ok(handle) => handle.inner.call(|inner| {
            let result = body(handle, inner);
            handle.publish(inner);
            result
        }),
        Err(failure) => failure.status(),
    }
}

/// Which number of which instance is NaN or infinite.
fn not_finite(domain: &'static Domain<'static>, instances: &[f64]) -> Option<Failure> {
    let each = domain.instance_len().max(1);
    let mut numbered = instances.chunks(each).zip(0u32..);
    numbered.find_map(|(instance, number)| {
        let slot = domain.first_not_finite(instance)?;
        Some(Failure::NotFinite(domain, number, u8::try_from(slot).ok()?))
    })
}

/// The problem that the caller's instances make with the learner's domain.
///
/// # Safety
/// If not NULL and aligned, `instances` is readable for `count` instances.
pub(crate) unsafe fn problem<'a>(
    handle: &critreg_learner,
    instances: *const f64,
    count: usize,
) -> Fallible<Problem<'a>> {
    let numbers = handle.domain.instance_len().checked_mul(count);
    let numbers = numbers.ok_or(Failure::invalid("count is too large"))?;
    // SAFETY: by this function's contract.
    let instances = unsafe { pointer::slice(instances, numbers, "instances")? };
    Problem::new(handle.domain, instances, count).map_err(|error| {
        let wrong = not_finite(handle.domain, instances);
        match error {
            Error::NotFinite(_) => wrong.unwrap_or(Failure::Core(error)),
            _ => Failure::Core(error),
        }
    })
}
