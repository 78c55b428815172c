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
use critreg_core::domain::{Domain, Node};
use critreg_core::learn::Observation;
use critreg_core::learn::version_space::{self, Cover, Evidence, Sample, Span, VersionSpace};
#[cfg(feature = "algorithm1")]
use critreg_core::learn::{self, Algorithm1, Bounds};
use critreg_core::real::Real;
use critreg_core::region::Region;

/// The parts of a learner.
pub(crate) struct LearnerLayout {
    pub(crate) handle: Part<critreg_learner>,
    pub(crate) region: Part<critreg_region>,
    pub(crate) domain: DomainLayout,
    tables: Tables,
    pub(crate) capacity: Capacity,
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

#[cfg(feature = "algorithm1")]
struct Algorithm1Tables<R: 'static> {
    capacity: learn::Capacity,
    learner: Part<Algorithm1<'static, R>>,
    features: Part<Node>,
    values: Part<R>,
    bounds: Part<Bounds<R>>,
    observations: Part<Observation>,
    pairs: Part<u8>,
}

struct VersionSpaceTables<R: 'static> {
    capacity: version_space::Capacity,
    learner: Part<VersionSpace<'static, R>>,
    features: Part<Node>,
    columns: Part<u16>,
    instances: Part<R>,
    spans: Part<Span<R>>,
    bits: Part<u64>,
    rows: Part<R>,
    lefts: Part<R>,
    sets: Part<u64>,
    covers: Part<Cover<R>>,
    samples: Part<Sample>,
    observations: Part<Observation>,
    support: Part<Evidence>,
    region: Part<Region>,
}

impl<R: 'static> KindTables<R> {
    const fn new(packer: &mut Packer, capacity: Capacity) -> Option<Self> {
        match capacity {
            #[cfg(feature = "algorithm1")]
            Capacity::Algorithm1(capacity) => match Algorithm1Tables::new(packer, capacity) {
                Some(tables) => Some(KindTables::Algorithm1(tables)),
                None => None,
            },
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
                // SAFETY: by this function's contract; the parts do not overlap.
                let (settings, lent) = unsafe {
                    let lent = learn::Memory {
                        features: tables.features.fill(memory, Node::Number(0.0)),
                        values: tables.values.fill(memory, R::ZERO),
                        pairs: tables.pairs.fill(memory, 0),
                        bounds: tables.bounds.fill(memory, Default::default()),
                        observations: tables.observations.fill(memory, Default::default()),
                    };
                    (config.algorithm1(domain)?, lent)
                };
                let learner = Algorithm1::new(domain, settings, tables.capacity, lent)?;
                // SAFETY: as above.
                Ok(Kind::Algorithm1(unsafe {
                    tables.learner.put(memory, learner)
                }))
            }
            KindTables::VersionSpace(tables) => {
                // SAFETY: by this function's contract.
                let learner = unsafe { tables.put_blank(memory, config.version_space()?)? };
                learner.settle(domain)?;
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
            let lent = version_space::Memory {
                features: self.features.fill(memory, Node::Number(0.0)),
                columns: self.columns.fill(memory, 0),
                instances: self.instances.fill(memory, R::ZERO),
                spans: self.spans.fill(memory, Default::default()),
                bits: self.bits.fill(memory, 0),
                rows: self.rows.fill(memory, R::ZERO),
                lefts: self.lefts.fill(memory, R::ZERO),
                sets: self.sets.fill(memory, 0),
                covers: self.covers.fill_with(memory, Default::default),
                samples: self.samples.fill(memory, Default::default()),
                observations: self.observations.fill(memory, Default::default()),
                support: self.support.fill(memory, Default::default()),
                region: self.region.put(memory, Region::default()),
            };
            let blank = VersionSpace::blank(settings, self.capacity, lent)?;
            Ok(self.learner.put(memory, blank))
        }
    }
}

#[cfg(feature = "algorithm1")]
impl<R: 'static> Algorithm1Tables<R> {
    const fn new(packer: &mut Packer, capacity: learn::Capacity) -> Option<Self> {
        Some(Algorithm1Tables {
            capacity,
            learner: append!(packer, 1),
            features: append!(packer, capacity.features()),
            values: append!(packer, capacity.features()),
            bounds: append!(packer, capacity.lefts()),
            observations: append!(packer, capacity.observations),
            pairs: append!(packer, capacity.pairs()),
        })
    }
}

/// `left * right`, or a number that no memory has.
const fn times(left: usize, right: usize) -> usize {
    left.saturating_mul(right)
}

impl<R: 'static> VersionSpaceTables<R> {
    const fn new(packer: &mut Packer, capacity: version_space::Capacity) -> Option<Self> {
        // The products of the capacity are computed once they cannot overflow.
        let words = times(capacity.forms, capacity.observations.div_ceil(64));
        let most = [
            times(capacity.features(), capacity.instances),
            times(capacity.forms, capacity.steps),
            times(words, 2),
        ];
        let [a, b, c] = most;
        if a == usize::MAX || b == usize::MAX || c == usize::MAX {
            return None;
        }
        Some(VersionSpaceTables {
            capacity,
            learner: append!(packer, 1),
            features: append!(packer, capacity.features()),
            instances: append!(packer, capacity.instance_values()),
            spans: append!(packer, capacity.spans()),
            bits: append!(packer, capacity.bits()),
            rows: append!(packer, capacity.rows()),
            lefts: append!(packer, capacity.lefts()),
            sets: append!(packer, capacity.sets()),
            region: append!(packer, 1),
            support: append!(packer, capacity.support()),
            covers: append!(packer, capacity.covers()),
            observations: append!(packer, capacity.observations),
            samples: append!(packer, capacity.observations),
            columns: append!(packer, capacity.features()),
        })
    }
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
            capacity,
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
                let first = learn::Capacity {
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
