//! The tables of a version-space learner, owned.

use critreg::domain::Node;
use critreg::learn::Observation;
use critreg::learn::version_space::{Capacity, Cover, Memory, Sample, Span};
use critreg::real::Real;

/// Memory for a version-space learner of some capacity.
pub struct VersionSpaceRoom<R = f64> {
    /// What there is room for.
    pub capacity: Capacity,
    features: Vec<Node>,
    values: Vec<R>,
    columns: Vec<u16>,
    instances: Vec<R>,
    spans: Vec<Span<R>>,
    bits: Vec<u64>,
    rows: Vec<R>,
    covers: Vec<Cover<R>>,
    samples: Vec<Sample>,
    observations: Vec<Observation>,
}

impl<R: Real> VersionSpaceRoom<R> {
    /// Room of this capacity.
    pub fn new(capacity: Capacity) -> Self {
        VersionSpaceRoom {
            capacity,
            features: vec![Node::Number(0.0); capacity.features()],
            values: vec![R::ZERO; capacity.features()],
            columns: vec![0; capacity.features()],
            instances: vec![R::ZERO; capacity.instance_values()],
            spans: vec![Span::default(); capacity.spans()],
            bits: vec![0; capacity.bits()],
            rows: vec![R::ZERO; capacity.rows()],
            covers: vec![Cover::default(); capacity.covers()],
            samples: vec![Sample::default(); capacity.observations],
            observations: vec![Observation::default(); capacity.observations],
        }
    }

    /// The tables, lent to one learner.
    pub fn lend(&mut self) -> Memory<'_, R> {
        Memory {
            features: &mut self.features,
            values: &mut self.values,
            columns: &mut self.columns,
            instances: &mut self.instances,
            spans: &mut self.spans,
            bits: &mut self.bits,
            rows: &mut self.rows,
            covers: &mut self.covers,
            samples: &mut self.samples,
            observations: &mut self.observations,
        }
    }
}
