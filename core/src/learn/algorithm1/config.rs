//! What Algorithm 1 is given, and what it reports.

use crate::grammar::Enumeration;
use crate::learn::tables::memory;
use crate::region::Theta;

/// How many hypotheses and observations a learner has room for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Capacity {
    /// Hypotheses, rounded down to a multiple of four.
    pub hypotheses: usize,
    /// Observations: samples that can be told.
    pub observations: usize,
}

impl Capacity {
    /// Features: enough for the pairs of any usual domain.
    pub const fn features(self) -> usize {
        let wanted = 128 + self.hypotheses / 32;
        if wanted < 60_000 { wanted } else { 60_000 }
    }

    /// Left sides.
    pub const fn lhs(self) -> usize {
        self.features() / 4
    }

    /// Bytes of the hypothesis table.
    pub const fn pairs(self) -> usize {
        self.hypotheses / 4
    }

    /// Observations.
    pub const fn observations(self) -> usize {
        self.observations
    }
}

/// The one list of its tables, see `learn/tables.rs`.
#[doc(hidden)]
#[macro_export]
macro_rules! algorithm1_tables {
    ([$($receiver:tt)*] $real:ty $(, $($argument:tt)*)?) => {
        $($receiver)*! {
            [$($($argument)*)?]
            /// Terms.
            features: $crate::domain::Node, features;
            /// Their values at the sample that was told last.
            values: $real, features;
            /// Hypotheses: a byte for the four comparisons of a pair of features.
            pairs: u8, pairs;
            /// Numeric bounds on left sides.
            bounds: $crate::learn::algorithm1::Bounds<$real>, lhs;
            /// What was asked and told.
            observations: $crate::learn::Observation, observations;
        }
    };
}
algorithm1_tables! { [memory] R }

/// What decides the queries of [`Algorithm1`](super::Algorithm1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Config {
    /// Seed of all random choices.
    pub seed: u64,
    /// Iterations K of the active loop.
    pub iterations: u32,
    /// The manual sample z-, expected to fail; left out if `None`.
    pub negative: Option<Theta>,
    /// The manual sample z+, expected to work; left out if `None`.
    pub positive: Option<Theta>,
}

impl Default for Config {
    /// The thesis's K = 100, no manual samples.
    fn default() -> Self {
        Config {
            seed: 0,
            iterations: 100,
            negative: None,
            positive: None,
        }
    }
}

/// How learning went so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Report {
    /// Hypotheses of the grammar, and how many the table holds.
    pub enumeration: Enumeration,
    /// Hypotheses left after z- was told.
    pub after_negative: Option<usize>,
    /// Hypotheses left after z+ was told.
    pub after_positive: Option<usize>,
    /// Hypotheses left now.
    pub remaining: usize,
    /// Samples told.
    pub calls: usize,
    /// Samples told that were feasible.
    pub feasible: usize,
    /// Samples told about which nothing is known.
    pub unknown: usize,
    /// Bounds that found no room in the region.
    pub constraints_left_out: usize,
}
