//! Where the parts of a learner lie in its memory.

use crate::boundary::memory::{Packer, Part, append};
use crate::boundary::precision::{Precision, in_precision};
use crate::boundary::status::Fallible;
use crate::learner::any::{AnyLearner, Capacity};
use crate::learner::config::{CRITREG_DEFAULT_QUESTIONS, critreg_config};
use crate::learner::handle::critreg_learner;
use crate::learner::tables;
use crate::region::handle::critreg_region;
use crate::region::layout::DomainLayout;
use critreg_core::domain::Domain;
#[cfg(feature = "algorithm1")]
use critreg_core::learn::algorithm1;
use critreg_core::learn::version_space;

/// The parts of a learner. Its tables stand behind the others.
pub(crate) struct LearnerLayout {
    pub(crate) handle: Part<critreg_learner>,
    pub(crate) region: Part<critreg_region>,
    pub(crate) domain: DomainLayout,
    front: Packer,
    pub(crate) capacity: Capacity,
    pub(crate) precision: Precision,
    pub(crate) size: usize,
}

impl LearnerLayout {
    pub(crate) const fn new(capacity: Capacity, precision: Precision) -> Option<LearnerLayout> {
        let mut packer = Packer { size: 0 };
        let handle = append!(packer, 1);
        let region = append!(packer, 1);
        let Some(domain) = DomainLayout::new(&mut packer) else {
            return None;
        };
        let end = in_precision!(precision, R => tables::end::<R>(packer, capacity));
        let Some(size) = end else { return None };
        Some(LearnerLayout {
            handle,
            region,
            domain,
            front: packer,
            capacity,
            precision,
            size,
        })
    }

    /// The capacity with the most forms, up to a number, for which there is
    /// room in so many bytes.
    pub(crate) fn largest(
        bytes: usize,
        capacity: Capacity,
        precision: Precision,
        most: usize,
    ) -> Capacity {
        let fits = |forms| {
            let layout = LearnerLayout::new(capacity.with_forms(forms), precision);
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
        capacity.with_forms(enough)
    }

    /// Makes a learner about a domain.
    ///
    /// # Safety
    /// As for [`Part::fill`], and [`critreg_config::algorithm1`].
    pub(crate) unsafe fn make(
        &self,
        memory: *mut u8,
        domain: &Domain<'_>,
        config: &critreg_config,
    ) -> Fallible<&'static mut dyn AnyLearner> {
        in_precision!(self.precision, R => {
            // SAFETY: by this function's contract.
            unsafe { tables::make::<R>(self.front, self.capacity, memory, domain, config) }
        })
    }
}

/// The macro CRITREG_LEARNER_WORDS_FOR of the header, in bytes.
const fn promised(forms: usize, observations: usize, instances: usize, steps: usize) -> usize {
    use crate::boundary::limits::*;
    let sums = if forms / 16 < 512 { forms / 16 } else { 512 };
    let plain = if forms / 128 < 48 { forms / 128 } else { 48 } + 16;
    let derived = if sums > 0 { plain } else { 0 };
    let lefts = plain + derived;
    let per_form = CRITREG_SPAN_BYTES * steps + 16 * observations.div_ceil(64);
    CRITREG_LEARNER_FIXED_BYTES
        + CRITREG_HANDLE_POINTERS * size_of::<*const u8>()
        + (forms / 8 + 64 + 2 * derived) * (CRITREG_FEATURE_BYTES + 8 * instances)
        + sums * (CRITREG_SUM_BYTES + 8 * instances)
        + instances * CRITREG_INSTANCE_BYTES
        + (forms + sums) * per_form
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
                sums: usize::MAX,
                observations,
                instances,
                steps,
                questions: CRITREG_DEFAULT_QUESTIONS as usize,
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
