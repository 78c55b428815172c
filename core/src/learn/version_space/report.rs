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
    /// Outcomes told of what was asked.
    pub calls: usize,
    /// Outcomes told of what was not.
    pub observed: usize,
    /// Those of them that are no longer kept, because the log was longer than the table: what
    /// is learned agrees with what is kept.
    pub dropped: usize,
    /// Feasible samples.
    pub feasible: usize,
    /// Infeasible ones. With noise, each that was asked takes several calls.
    pub infeasible: usize,
    /// Samples put aside because their outcome is unknown.
    pub unknown: usize,
    /// Constraints that found no room in the region, which is too large without them.
    pub constraints_left_out: usize,
    /// Samples that the region is wrong about, see [`Config::slack`](super::Config::slack).
    pub strays: usize,
    /// Draws from the region, and what they prove.
    pub certificate: Certificate,
    /// Feasible samples that were drawn from everything since the region is as it is.
    pub found: u32,
    /// Those of them that are in the region: `inside / found` estimates the recall.
    pub inside: u32,
}

impl Report {
    /// An interval for the share of the region that works, as far as draws from it that were
    /// not used to choose it tell; `None` without such draws. Each end holds with so much
    /// confidence (Clopper and Pearson 1934).
    pub fn precision(&self, confidence: f64) -> Option<(f64, f64)> {
        let Certificate {
            draws, feasible, ..
        } = self.certificate;
        interval(draws, feasible, confidence)
    }

    /// The same for the share of what works that is in the region.
    pub fn recall(&self, confidence: f64) -> Option<(f64, f64)> {
        interval(self.found, self.inside, confidence)
    }

    /// The upper end of [`Report::precision`].
    pub(super) fn precision_at_most(&self, confidence: f64) -> Option<f64> {
        self.precision(confidence).map(|(_, upper)| upper)
    }
}

/// Between which shares the truth lies where so many of some draws are successes.
fn interval(draws: u32, successes: u32, confidence: f64) -> Option<(f64, f64)> {
    let lower = |own: u32| Certificate::new(draws, own, confidence).lower_bound;
    (draws > 0).then(|| (lower(successes), 1.0 - lower(draws - successes.min(draws))))
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
