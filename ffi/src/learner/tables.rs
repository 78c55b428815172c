//! The tables of a learner in its memory, and what lies in them at first.

use crate::boundary::memory::{Packer, Part, append};
use crate::boundary::status::{Failure, Fallible};
use crate::learner::any::{AnyLearner, Capacity};
use crate::learner::config::critreg_config;
use critreg_core::domain::{Domain, Node};
use critreg_core::learn::Observation;
use critreg_core::learn::version_space::{self, Cover, Evidence, Sample, Span, VersionSpace};
#[cfg(feature = "algorithm1")]
use critreg_core::learn::{self, Algorithm1, Bounds};
use critreg_core::real::Real;
use critreg_core::region::Region;

/// A kind of learner and, behind it, its tables in their order: of each what is in it, how
/// much, and how its part is filled with what.
macro_rules! tables {
    ($name:ident: $room:ident::$learner:ident with $capacity:ident;
     $($table:ident: $type:ty, $count:expr, $fill:ident($first:expr);)*) => {
        struct $name<R: 'static> {
            learner: Part<$room::$learner<'static, R>>,
            $($table: Part<$type>,)*
        }

        impl<R: 'static> $name<R> {
            const fn new(packer: &mut Packer, $capacity: $room::Capacity) -> Option<Self> {
                Some($name {
                    learner: append!(packer, 1),
                    $($table: append!(packer, $count),)*
                })
            }
        }

        impl<R: Real> $name<R> {
            /// # Safety
            /// As for [`Part::fill`].
            unsafe fn lend(&self, memory: *mut u8) -> $room::Memory<'static, R> {
                // SAFETY: by this function's contract; the parts do not overlap.
                unsafe { $room::Memory { $($table: self.$table.$fill(memory, $first),)* } }
            }
        }
    };
}

#[cfg(feature = "algorithm1")]
tables! {
    Algorithm1Tables: learn::Algorithm1 with capacity;
    features: Node, capacity.features(), fill(Node::Number(0.0));
    values: R, capacity.features(), fill(R::ZERO);
    bounds: Bounds<R>, capacity.lefts(), fill(Default::default());
    observations: Observation, capacity.observations, fill(Default::default());
    pairs: u8, capacity.pairs(), fill(0);
}

tables! {
    VersionSpaceTables: version_space::VersionSpace with capacity;
    features: Node, capacity.features(), fill(Node::Number(0.0));
    instances: R, capacity.instance_values(), fill(R::ZERO);
    spans: Span<R>, capacity.spans(), fill(Default::default());
    bits: u64, capacity.bits(), fill(0);
    rows: R, capacity.rows(), fill(R::ZERO);
    lefts: R, capacity.lefts(), fill(R::ZERO);
    sets: u64, capacity.sets(), fill(0);
    region: Region, 1, put(Region::default());
    support: Evidence, capacity.support(), fill(Default::default());
    covers: Cover<R>, capacity.covers(), fill_with(Default::default);
    observations: Observation, capacity.observations, fill(Default::default());
    samples: Sample, capacity.observations, fill(Default::default());
    columns: u16, capacity.features(), fill(0);
}

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
const fn is_countable(capacity: version_space::Capacity) -> bool {
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
            learner.settle(domain)?;
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
