//! How learning went.

use super::certificate::Certificate;
use crate::table::Blank;

/// How learning went so far.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Report {
    /// Forms in use.
    pub forms: usize,
    /// Forms that found no room.
    pub forms_left_out: usize,
    /// Outcomes told.
    pub calls: usize,
    /// Feasible samples.
    pub feasible: usize,
    /// Infeasible ones. With noise, each takes several calls.
    pub infeasible: usize,
    /// Samples put aside because their outcome is unknown.
    pub unknown: usize,
    /// Constraints that found no room in the region, which is too large without them.
    pub constraints_left_out: usize,
    /// Samples that the region is wrong about, see [`Config::slack`](super::Config::slack).
    pub strays: usize,
    /// Draws from the region, and what they prove.
    pub certificate: Certificate,
}

/// What supports a constraint of a region.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Evidence {
    /// The step of the sequence that it was learned for, from one.
    pub step: u32,
    /// The extreme value over the feasible samples: the bound cannot be tighter.
    pub feasible: f64,
    /// The value of the first infeasible sample that only this constraint
    /// excludes: the bound must be tighter.
    pub infeasible: f64,
    /// How many infeasible samples it excludes.
    pub support: u32,
}

impl Blank for Evidence {
    const BLANK: Self = Evidence {
        step: 0,
        feasible: 0.0,
        infeasible: 0.0,
        support: 0,
    };
}
