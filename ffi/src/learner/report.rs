//! How learning went, for C.

use crate::boundary::status::{critreg_status, status_of};
use crate::boundary::structs::{self, Versioned};
use crate::learner::quality::number;
use crate::region::quality::CRITREG_NO_QUALITY;
use core::ffi::c_void;
use core::mem::offset_of;
use critreg_core::learn::VersionSpace;
#[cfg(feature = "algorithm1")]
use critreg_core::learn::algorithm1;
use critreg_core::real::Real;

/// In a critreg_report: this did not happen (yet), or never does in this learner.
pub const CRITREG_NOT_RUN: u64 = u64::MAX;

/// How learning went so far.
///
/// CRITREG_VERSION_SPACE counts forms, from the first query on;
/// it deletes none. CRITREG_ALGORITHM1 counts every comparison of two features on
/// its own; it ignores no samples and has no certificate, so these are 0.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct critreg_report {
    /// Size of this struct in bytes, from critreg_report_init().
    pub struct_size: u32,
    /// What the region is worth: CRITREG_EXACT, CRITREG_APPROXIMATE, CRITREG_PROVISIONAL or,
    /// if there is none, CRITREG_NO_QUALITY.
    pub quality: u32,
    /// Hypotheses that the grammar makes of the domain.
    pub enumerated: u64,
    /// Those the learner started with.
    pub kept: u64,
    /// Those that found no room in the memory: the most complex ones.
    pub left_out: u64,
    /// CRITREG_ALGORITHM1: hypotheses left after the negative sample, or
    /// CRITREG_NOT_RUN.
    pub after_negative: u64,
    /// CRITREG_ALGORITHM1: hypotheses left after the positive sample, or
    /// CRITREG_NOT_RUN.
    pub after_positive: u64,
    /// Hypotheses left now.
    pub remaining: u64,
    /// Outcomes told of what was asked: calls of the simulator.
    pub calls: u64,
    /// Samples that were feasible. With noise a sample takes several calls, so
    /// that feasible and infeasible ones are fewer than the calls.
    pub feasible: u64,
    /// Samples that were infeasible.
    pub infeasible: u64,
    /// Samples that were put aside, because their outcome is CRITREG_UNKNOWN.
    pub unknown: u64,
    /// CRITREG_VERSION_SPACE: samples that the region is wrong about; see
    /// critreg_config.slack.
    pub strays: u64,
    /// Constraints that found no room in the region.
    pub constraints_left_out: u64,
    /// The certificate of CRITREG_VERSION_SPACE: this many of the last samples are
    /// independent, uniform draws from the region as it is now.
    pub certificate_draws: u64,
    /// Those that worked.
    pub certificate_feasible: u64,
    /// With the configured confidence, at least this share of the region works in
    /// the training instances (Clopper and Pearson 1934); 0 without draws.
    pub certificate_lower_bound: f64,
    /// The share of the region that works lies between these two, each with the configured
    /// confidence, by the same draws; NaN without draws.
    pub precision_low: f64,
    /// See precision_low.
    pub precision_high: f64,
    /// The share of what works that is in the region, likewise, by draws from everything
    /// since the region is as it is; NaN without feasible ones.
    pub recall_low: f64,
    /// See recall_low.
    pub recall_high: f64,
    /// Outcomes told of what was not asked, see critreg_observe().
    pub observed: u64,
}

// SAFETY: it is repr(C) and starts with struct_size.
unsafe impl Versioned for critreg_report {
    const FIRST: usize = offset_of!(critreg_report, precision_low);
}

const EMPTY: critreg_report = critreg_report {
    struct_size: size_of::<critreg_report>() as u32,
    quality: CRITREG_NO_QUALITY,
    enumerated: 0,
    kept: 0,
    left_out: 0,
    after_negative: CRITREG_NOT_RUN,
    after_positive: CRITREG_NOT_RUN,
    remaining: 0,
    calls: 0,
    feasible: 0,
    infeasible: 0,
    unknown: 0,
    strays: 0,
    constraints_left_out: 0,
    certificate_draws: 0,
    certificate_feasible: 0,
    certificate_lower_bound: 0.0,
    precision_low: f64::NAN,
    precision_high: f64::NAN,
    recall_low: f64::NAN,
    recall_high: f64::NAN,
    observed: 0,
};

/// Called by critreg_learn_region() after every sample.
///
/// @param progress_data That of the configuration.
/// @param report How learning went so far; valid until the callback returns.
/// @return CRITREG_OK to go on. Anything else stops learning and becomes the
/// status of critreg_learn_region(): CRITREG_CANCELLED, or CRITREG_USER_STATUS
/// and above. What was learned so far stays, and learning can go on later.
pub type critreg_progress = Option<
    unsafe extern "C" fn(
        progress_data: *mut c_void,
        report: *const critreg_report,
    ) -> critreg_status,
>;

impl critreg_report {
    #[cfg(feature = "algorithm1")]
    pub(crate) fn of_algorithm1(report: &algorithm1::Report) -> Self {
        let counted = |count: Option<usize>| count.map_or(CRITREG_NOT_RUN, |n| n as u64);
        critreg_report {
            enumerated: report.enumeration.enumerated,
            kept: report.enumeration.kept,
            left_out: report.enumeration.left_out,
            after_negative: counted(report.after_negative),
            after_positive: counted(report.after_positive),
            remaining: report.remaining as u64,
            calls: report.calls as u64,
            feasible: report.feasible as u64,
            infeasible: report
                .calls
                .saturating_sub(report.feasible + report.unknown) as u64,
            unknown: report.unknown as u64,
            constraints_left_out: report.constraints_left_out as u64,
            ..EMPTY
        }
    }

    pub(crate) fn of_version_space<R: Real>(learner: &VersionSpace<'_, R>) -> Self {
        let report = learner.report();
        let confidence = learner.config().confidence;
        let unknown = (f64::NAN, f64::NAN);
        let (precision_low, precision_high) = report.precision(confidence).unwrap_or(unknown);
        let (recall_low, recall_high) = report.recall(confidence).unwrap_or(unknown);
        critreg_report {
            quality: number(learner.quality()),
            precision_low,
            precision_high,
            recall_low,
            recall_high,
            enumerated: report.forms.saturating_add(report.forms_left_out) as u64,
            kept: report.forms as u64,
            left_out: report.forms_left_out as u64,
            remaining: report.forms as u64,
            calls: report.calls as u64,
            observed: report.observed as u64,
            feasible: report.feasible as u64,
            infeasible: report.infeasible as u64,
            unknown: report.unknown as u64,
            strays: report.strays as u64,
            constraints_left_out: report.constraints_left_out as u64,
            certificate_draws: report.certificate.draws.into(),
            certificate_feasible: report.certificate.feasible.into(),
            certificate_lower_bound: report.certificate.lower_bound,
            ..EMPTY
        }
    }
}

/// Prepares a report for critreg_learner_report().
///
/// @param report The report.
/// @param size sizeof *report; see critreg_config_init().
/// @return As critreg_config_init().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_report_init(
    report: *mut critreg_report,
    size: usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise.
    status_of(unsafe { structs::init(report, size, EMPTY) })
}
