//! A region in the caller's memory.

use crate::boundary::handle::{self, Handle};
use crate::boundary::pointer;
use crate::boundary::precision::Precision;
use crate::boundary::status::Fallible;
use core::fmt;
use critreg_core::domain::Domain;
use critreg_core::grammar::MAX_CONSTRAINTS;
use critreg_core::learn::version_space::Evidence;
use critreg_core::real::Real;
use critreg_core::region::{Grounded, Region};
use critreg_core::table::Blank;

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
    /// See critreg_region_quality().
    pub(crate) quality: u32,
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
    /// Writes a handle with a region that is made in place, field by field, because it is
    /// large; what lay there before is lost.
    ///
    /// # Errors
    /// Those of `make`; then there is no handle.
    ///
    /// # Safety
    /// As for [`handle::put`].
    pub(crate) unsafe fn put(
        place: *mut critreg_region,
        domain: &'static Domain<'static>,
        precision: Precision,
        (support, quality): (&[Evidence], u32),
        make: impl FnOnce(&mut Region) -> Fallible,
    ) -> Fallible {
        // SAFETY: by this function's contract; the fields lie inside of the handle, and it
        // is whole when it is sealed.
        unsafe {
            (&raw mut (*place).domain).write(domain);
            (&raw mut (*place).precision).write(precision);
            (&raw mut (*place).known).write(support.len());
            (&raw mut (*place).quality).write(quality);
            (&raw mut (*place).region).write(Region::default());
            (&raw mut (*place).evidence).write([Evidence::BLANK; MAX_CONSTRAINTS]);
            make(&mut (*place).region)?;
            for (slot, own) in (*place).evidence.iter_mut().zip(support) {
                *slot = *own;
            }
            handle::seal(place);
        }
        Ok(())
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
