//! The tables of a learner in its memory, and what lies in them at first.

use crate::boundary::memory::{Packer, Part, append, parts};
use crate::boundary::status::{Failure, Fallible};
use crate::learner::any::{AnyLearner, Capacity};
use crate::learner::config::critreg_config;
use critreg_core::domain::Domain;
#[cfg(feature = "algorithm1")]
use critreg_core::learn::{Algorithm1, algorithm1};
use critreg_core::learn::{VersionSpace, version_space};
use critreg_core::real::Real;
use critreg_core::table::Blank;

/// Declares where a learner lies and, behind it, the tables that its macro lists.
macro_rules! tables {
    (
        [$name:ident $learner:ident $module:ident]
        $($(#[$doc:meta])* $table:ident: $entry:ty, $count:ident;)*
    ) => {
        parts! {
            $name<R> with capacity: $module::Capacity;
            learner: $learner<'static, R>, 1;
            $($table: $entry, capacity.$count();)*
        }

        impl<R: Real> $name<R> {
            /// Fills the tables and lends them.
            ///
            /// # Safety
            /// As for [`Part::fill_with`].
            pub(crate) unsafe fn lend(&self, memory: *mut u8) -> $module::Memory<'static, R> {
                // SAFETY: by this function's contract; the parts do not overlap.
                unsafe {
                    $module::Memory {
                        $($table: self.$table.fill_with(memory, || <$entry as Blank>::BLANK),)*
                    }
                }
            }
        }
    };
}

#[cfg(feature = "algorithm1")]
critreg_core::algorithm1_tables! { [tables] R, Algorithm1Tables Algorithm1 algorithm1 }
critreg_core::version_space_tables! { [tables] R, VersionSpaceTables VersionSpace version_space }

/// Where a learner ends whose tables begin behind `front`; `None` if no memory is that
/// long.
pub(crate) const fn end<R: 'static>(mut front: Packer, capacity: Capacity) -> Option<usize> {
    let fits = match capacity {
        #[cfg(feature = "algorithm1")]
        Capacity::Algorithm1(capacity) => {
            Algorithm1Tables::<R>::new(&mut front, capacity).is_some()
        }
        Capacity::VersionSpace(capacity) => {
            is_countable(capacity) && VersionSpaceTables::<R>::new(&mut front, capacity).is_some()
        }
    };
    if fits { Some(front.size) } else { None }
}

/// Whether no product of the capacity overflows when its tables are counted.
pub(crate) const fn is_countable(capacity: version_space::Capacity) -> bool {
    const fn times(left: usize, right: usize) -> Option<usize> {
        left.checked_mul(right)
    }
    let words = capacity.observations.div_ceil(64).saturating_mul(2);
    times(capacity.features(), capacity.instances).is_some()
        && times(capacity.forms, capacity.steps).is_some()
        && times(capacity.forms, words).is_some()
}

/// Makes a learner about a domain, with its tables behind `front`.
///
/// # Safety
/// As for [`Part::fill`], and [`critreg_config::algorithm1`]; the memory is as long as
/// [`end`] says.
pub(crate) unsafe fn make<R: Real>(
    mut front: Packer,
    capacity: Capacity,
    memory: *mut u8,
    domain: &Domain<'_>,
    config: &critreg_config,
) -> Fallible<&'static mut dyn AnyLearner> {
    const TOO_LONG: Failure = Failure::TooSmall("the memory of the learner");
    match capacity {
        #[cfg(feature = "algorithm1")]
        Capacity::Algorithm1(capacity) => {
            let tables = Algorithm1Tables::<R>::new(&mut front, capacity).ok_or(TOO_LONG)?;
            // SAFETY: by this function's contract; the parts do not overlap.
            unsafe {
                let (lent, settings) = (tables.lend(memory), config.algorithm1(domain)?);
                let learner = Algorithm1::new(domain, settings, capacity, lent)?;
                Ok(tables.learner.put(memory, learner))
            }
        }
        Capacity::VersionSpace(capacity) => {
            let tables = VersionSpaceTables::<R>::new(&mut front, capacity).ok_or(TOO_LONG)?;
            // SAFETY: as above.
            let learner = unsafe { put_blank(&tables, capacity, memory, config.version_space()?)? };
            learner.enumerate(domain)?;
            Ok(learner)
        }
    }
}

/// Puts a learner there that knows no domain yet. Never inlined: what it is made of
/// leaves the stack before it gets to know one.
///
/// # Safety
/// As for [`Part::fill`].
#[inline(never)]
unsafe fn put_blank<R: Real>(
    tables: &VersionSpaceTables<R>,
    capacity: version_space::Capacity,
    memory: *mut u8,
    settings: version_space::Config,
) -> Fallible<&'static mut VersionSpace<'static, R>> {
    // SAFETY: by this function's contract; the parts do not overlap.
    unsafe {
        let blank = VersionSpace::blank(settings, capacity, tables.lend(memory))?;
        Ok(tables.learner.put(memory, blank))
    }
}
