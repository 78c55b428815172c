//! The tables of a learner with Algorithm 1, owned.

use critreg::domain::Node;
use critreg::learn::{Bounds, Capacity, Memory, Observation};

/// Memory for Algorithm 1 of some capacity.
pub struct Algorithm1Room {
    /// What there is room for.
    pub capacity: Capacity,
    features: Vec<Node>,
    values: Vec<f64>,
    pairs: Vec<u8>,
    bounds: Vec<Bounds<f64>>,
    observations: Vec<Observation>,
}

impl Algorithm1Room {
    /// Room for so many hypotheses and observations.
    pub fn new(hypotheses: usize, observations: usize) -> Algorithm1Room {
        let capacity = Capacity {
            hypotheses,
            observations,
        };
        Algorithm1Room {
            capacity,
            features: vec![Node::Number(0.0); capacity.features()],
            values: vec![0.0; capacity.features()],
            pairs: vec![0; capacity.pairs()],
            bounds: vec![Bounds::default(); capacity.lefts()],
            observations: vec![Observation::default(); observations],
        }
    }

    /// The tables, lent to one learner.
    pub fn lend(&mut self) -> Memory<'_, f64> {
        Memory {
            features: &mut self.features,
            values: &mut self.values,
            pairs: &mut self.pairs,
            bounds: &mut self.bounds,
            observations: &mut self.observations,
        }
    }
}
