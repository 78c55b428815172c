//! Where the parts of a learner lie in its memory.

use crate::boundary::memory::{Packer, Part, append};
use crate::boundary::precision::Precision;
#[cfg(feature = "f32")]
use crate::boundary::precision::Single;
use crate::boundary::status::Fallible;
use crate::learner::any::{AnyLearner, Capacity, Kind};
use crate::learner::config::critreg_config;
use crate::learner::handle::critreg_learner;
use crate::region::handle::critreg_region;
use crate::region::layout::DomainLayout;
use critreg_core::domain::Domain;
#[cfg(feature = "algorithm1")]
use critreg_core::learn::{Algorithm1, algorithm1};
use critreg_core::learn::{VersionSpace, version_space};
use critreg_core::real::Real;
use critreg_core::table::Blank;

/// The parts of a learner.
pub(crate) struct LearnerLayout {
    pub(crate) handle: Part<critreg_learner>,
    pub(crate) region: Part<critreg_region>,
    pub(crate) domain: DomainLayout,
    tables: Tables,
    pub(crate) size: usize,
}

/// The tables of a learner of each precision.
enum Tables {
    #[cfg(feature = "f32")]
    Single(KindTables<Single>),
    #[cfg(feature = "f64")]
    Double(KindTables<f64>),
}

/// The tables of each kind of learner.
enum KindTables<R: 'static> {
    #[cfg(feature = "algorithm1")]
    Algorithm1(Algorithm1Tables<R>),
    VersionSpace(VersionSpaceTables<R>),
}

/// Declares where the tables lie that a learner's macro lists, and the learner itself.
macro_rules! tables {
    (
        [$name:ident $learner:ident $module:ident]
        $($(#[$doc:meta])* $table:ident: $entry:ty, $count:ident;)*
    ) => {
        struct $name<R: 'static> {
            capacity: $module::Capacity,
            learner: Part<$learner<'static, R>>,
            $($table: Part<$entry>,)*
        }

        impl<R: 'static> $name<R> {
            const fn new(packer: &mut Packer, capacity: $module::Capacity) -> Option<Self> {
                Some($name {
                    capacity,
                    learner: append!(packer, 1),
                    $($table: append!(packer, capacity.$count()),)*
                })
            }
        }

        impl<R: Real> $name<R> {
            /// Fills the tables and lends them.
            ///
            /// # Safety
            /// As for [`Part::fill_with`].
            unsafe fn lend(&self, memory: *mut u8) -> $module::Memory<'static, R> {
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

impl<R: 'static> KindTables<R> {
    const fn new(packer: &mut Packer, capacity: Capacity) -> Option<Self> {
        match capacity {
            #[cfg(feature = "algorithm1")]
            Capacity::Algorithm1(capacity) => match Algorithm1Tables::new(packer, capacity) {
                Some(tables) => Some(KindTables::Algorithm1(tables)),
                None => None,
            },
            Capacity::VersionSpace(capacity) if !is_sane(capacity) => None,
            Capacity::VersionSpace(capacity) => match VersionSpaceTables::new(packer, capacity) {
                Some(tables) => Some(KindTables::VersionSpace(tables)),
                None => None,
            },
        }
    }
}

impl<R: Real> KindTables<R> {
    /// Makes the learner whose tables these are.
    ///
    /// # Safety
    /// As for [`Part::fill`], and [`critreg_config::algorithm1`].
    unsafe fn make(
        &self,
        memory: *mut u8,
        domain: &Domain<'_>,
        config: &critreg_config,
    ) -> Fallible<Kind<R>> {
        match self {
            #[cfg(feature = "algorithm1")]
            KindTables::Algorithm1(tables) => {
                // SAFETY: by this function's contract.
                let (settings, lent) = unsafe { (config.algorithm1(domain)?, tables.lend(memory)) };
                let learner = Algorithm1::new(domain, settings, tables.capacity, lent)?;
                // SAFETY: as above.
                Ok(Kind::Algorithm1(unsafe {
                    tables.learner.put(memory, learner)
                }))
            }
            KindTables::VersionSpace(tables) => {
                // SAFETY: by this function's contract.
                let learner = unsafe { tables.put_blank(memory, config.version_space()?)? };
                learner.enumerate(domain)?;
                Ok(Kind::VersionSpace(learner))
            }
        }
    }
}

impl<R: Real> VersionSpaceTables<R> {
    /// Puts a learner there that knows no domain yet. Never inlined: what it is made of
    /// leaves the stack before it gets to know one.
    ///
    /// # Safety
    /// As for [`Part::fill`].
    #[inline(never)]
    unsafe fn put_blank(
        &self,
        memory: *mut u8,
        settings: version_space::Config,
    ) -> Fallible<&'static mut VersionSpace<'static, R>> {
        // SAFETY: by this function's contract; the parts do not overlap.
        unsafe {
            let blank = VersionSpace::blank(settings, self.capacity, self.lend(memory))?;
            Ok(self.learner.put(memory, blank))
        }
    }
}

/// Whether the products of a capacity can be computed.
const fn is_sane(capacity: version_space::Capacity) -> bool {
    const fn times(left: usize, right: usize) -> usize {
        left.saturating_mul(right)
    }
    let words = times(capacity.forms, capacity.observations.div_ceil(64));
    times(capacity.features(), capacity.instances) < usize::MAX
        && times(capacity.forms, capacity.steps) < usize::MAX
        && times(words, 2) < usize::MAX
}

impl LearnerLayout {
    pub(crate) const fn new(capacity: Capacity, precision: Precision) -> Option<LearnerLayout> {
        let mut packer = Packer { size: 0 };
        let handle = append!(packer, 1);
        let region = append!(packer, 1);
        let Some(domain) = DomainLayout::new(&mut packer) else {
            return None;
        };
        let tables = match precision {
            #[cfg(feature = "f32")]
            Precision::Single => match KindTables::new(&mut packer, capacity) {
                Some(tables) => Tables::Single(tables),
                None => return None,
            },
            #[cfg(feature = "f64")]
            Precision::Double => match KindTables::new(&mut packer, capacity) {
                Some(tables) => Tables::Double(tables),
                None => return None,
            },
        };
        Some(LearnerLayout {
            handle,
            region,
            domain,
            tables,
            size: packer.size,
        })
    }

    /// The capacity with the most hypotheses, up to a number, for which there is
    /// room in so many bytes.
    pub(crate) fn largest(
        bytes: usize,
        capacity: Capacity,
        precision: Precision,
        most: usize,
    ) -> Capacity {
        let fits = |hypotheses| {
            let layout = LearnerLayout::new(capacity.with_hypotheses(hypotheses), precision);
            layout.is_some_and(|layout| layout.size <= bytes)
        };
        let (mut enough, mut too_many) = (0, most.saturating_add(1));
        while too_many.saturating_sub(enough) > 1 {
            let middle = enough + (too_many - enough) / 2;
            if fits(middle) {
                enough = middle;
            } else {
                too_many = middle;
            }
        }
        capacity.with_hypotheses(enough)
    }

    /// Makes the learner whose tables these are.
    ///
    /// # Safety
    /// As for [`Part::fill`], and [`critreg_config::algorithm1`].
    pub(crate) unsafe fn make(
        &self,
        memory: *mut u8,
        domain: &Domain<'_>,
        config: &critreg_config,
    ) -> Fallible<AnyLearner> {
        // SAFETY: by this function's contract.
        unsafe {
            match &self.tables {
                #[cfg(feature = "f32")]
                Tables::Single(tables) => {
                    tables.make(memory, domain, config).map(AnyLearner::Single)
                }
                #[cfg(feature = "f64")]
                Tables::Double(tables) => {
                    tables.make(memory, domain, config).map(AnyLearner::Double)
                }
            }
        }
    }
}

/// The macro CRITREG_LEARNER_WORDS_FOR of the header, in bytes.
const fn promised(forms: usize, observations: usize, instances: usize, steps: usize) -> usize {
    use crate::boundary::limits::*;
    let lefts = if forms / 128 < 48 { forms / 128 } else { 48 } + 16;
    let per_form = CRITREG_SPAN_BYTES * steps + 16 * observations.div_ceil(64);
    CRITREG_LEARNER_FIXED_BYTES
        + CRITREG_HANDLE_POINTERS * size_of::<*const u8>()
        + (forms / 8 + 64) * (CRITREG_FEATURE_BYTES + 8 * instances)
        + forms * per_form
        + observations * (CRITREG_OBSERVATION_BYTES + 8 * lefts)
        + steps * CRITREG_STEP_BYTES
}

const fn fits(capacity: Capacity, bytes: usize) -> bool {
    match LearnerLayout::new(capacity, Precision::DEFAULT) {
        Some(layout) => layout.size <= bytes,
        None => false,
    }
}

// It promises enough memory for both learners; on every target that is built.
#[expect(clippy::indexing_slicing, reason = "runs while compiling only")]
const _: () = {
    const OBSERVATIONS: [usize; 5] = [1, 64, 65, 256, 2048];
    const SHAPES: [(usize, usize); 3] = [(1, 1), (16, 1), (64, 4)];
    let mut forms = 4;
    while forms < 1 << 18 {
        let mut at = 0;
        while at < OBSERVATIONS.len() * SHAPES.len() {
            let observations = OBSERVATIONS[at % OBSERVATIONS.len()];
            let (instances, steps) = SHAPES[at / OBSERVATIONS.len()];
            let bytes = promised(forms, observations, instances, steps);
            let capacity = version_space::Capacity {
                forms,
                tracked: usize::MAX,
                observations,
                instances,
                steps,
            };
            #[cfg(feature = "algorithm1")]
            {
                let first = algorithm1::Capacity {
                    hypotheses: forms,
                    observations,
                };
                assert!(fits(Capacity::Algorithm1(first), bytes));
            }
            assert!(fits(Capacity::VersionSpace(capacity), bytes));
            at += 1;
        }
        forms = forms * 3 / 2 + 1;
    }
};
