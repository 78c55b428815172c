//! The tables of a version-space learner, owned.

use critreg::Error;
use critreg::domain::{Domain, Node};
use critreg::learn::version_space::{Capacity, Config, Cover, Evidence, Memory, Sample, Span};
use critreg::learn::{Observation, VersionSpace};
use critreg::real::Real;
use critreg::region::Region;

/// Memory for a version-space learner of some capacity.
pub struct VersionSpaceRoom<R = f64> {
    /// What there is room for.
    pub capacity: Capacity,
    features: Vec<Node>,
    columns: Vec<u16>,
    instances: Vec<R>,
    spans: Vec<Span<R>>,
    bits: Vec<u64>,
    rows: Vec<R>,
    lefts: Vec<R>,
    sets: Vec<u64>,
    covers: Vec<Cover<R>>,
    samples: Vec<Sample>,
    observations: Vec<Observation>,
    support: Vec<Evidence>,
    region: Region,
}

impl<R: Real> VersionSpaceRoom<R> {
    /// Room of this capacity.
    pub fn new(capacity: Capacity) -> Self {
        VersionSpaceRoom {
            capacity,
            features: vec![Node::Number(0.0); capacity.features()],
            columns: vec![0; capacity.features()],
            instances: vec![R::ZERO; capacity.instance_values()],
            spans: vec![Span::default(); capacity.spans()],
            bits: vec![0; capacity.bits()],
            rows: vec![R::ZERO; capacity.rows()],
            lefts: vec![R::ZERO; capacity.lefts()],
            sets: vec![0; capacity.sets()],
            covers: vec![Cover::default(); capacity.covers()],
            samples: vec![Sample::default(); capacity.observations],
            observations: vec![Observation::default(); capacity.observations],
            support: vec![Evidence::default(); capacity.support()],
            region: Region::default(),
        }
    }

    /// A learner in this room.
    ///
    /// # Errors
    /// Those of [`VersionSpace::new`].
    pub fn learner(
        &mut self,
        domain: &Domain<'_>,
        config: Config,
    ) -> Result<VersionSpace<'_, R>, Error> {
        VersionSpace::new(domain, config, self.capacity, self.lend())
    }

    /// The tables, lent to one learner.
    pub fn lend(&mut self) -> Memory<'_, R> {
        Memory {
            features: &mut self.features,
            columns: &mut self.columns,
            instances: &mut self.instances,
            spans: &mut self.spans,
            bits: &mut self.bits,
            rows: &mut self.rows,
            lefts: &mut self.lefts,
            sets: &mut self.sets,
            covers: &mut self.covers,
            samples: &mut self.samples,
            observations: &mut self.observations,
            support: &mut self.support,
            region: &mut self.region,
        }
    }
}
