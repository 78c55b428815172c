//! What a version space learner is told to do.

use super::tuning::Tuning;
use crate::error::Error;

/// What decides the questions of a learner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Config {
    /// Seed of all random choices.
    pub seed: u64,
    /// How many outcomes are asked for.
    pub calls: u32,
    /// How many draws from the region certify it, with the last of these. With noise a draw
    /// takes several, up to a quarter of all.
    pub certifying: u32,
    /// Share of questions that look for what nobody suspects, in `[0, 1]`.
    pub exploring: f64,
    /// Share of answers that are wrong, in `[0, 0.2]`. If it is not zero, samples
    /// are asked again until the answer is beyond doubt.
    pub noise: f64,
    /// How far the boundary of a constraint may lie elsewhere in single instances, as
    /// a share of what the constraint's left side ranges over, in `[0, 0.2]`: for
    /// actions that work a little beyond a boundary or fail a little before it. If
    /// it is zero, the region agrees with every answer.
    pub slack: f64,
    /// Which share of the region must work at least where no region agrees with all answers,
    /// in `[0.5, 0.999]`.
    pub precision_wanted: f64,
    /// Confidence of the certificate, in `[0, 0.9999]`.
    pub confidence: f64,
    /// The numbers behind, see [`Tuning`].
    pub tuning: &'static Tuning,
}

impl Default for Config {
    fn default() -> Self {
        Config {
            seed: 0,
            calls: 100,
            certifying: 10,
            exploring: 0.1,
            noise: 0.0,
            slack: 0.05,
            precision_wanted: 0.95,
            confidence: 0.95,
            tuning: &Tuning::CHOSEN,
        }
    }
}

impl Config {
    /// Its shares, each with what is expected of it, in words and as a range.
    pub fn shares(&self) -> [(&'static str, f64, [f64; 2]); 5] {
        [
            ("config.noise is from 0 to 0.2", self.noise, [0.0, 0.2]),
            (
                "config.exploring is from 0 to 1",
                self.exploring,
                [0.0, 1.0],
            ),
            ("config.slack is from 0 to 0.2", self.slack, [0.0, 0.2]),
            (
                "config.confidence is from 0 to 0.9999",
                self.confidence,
                [0.0, 0.9999],
            ),
            (
                "config.precision_wanted is from 0.5 to 0.999",
                self.precision_wanted,
                [0.5, 0.999],
            ),
        ]
    }

    pub(super) fn check(&self) -> Result<(), Error> {
        let shares = self.shares();
        let fits = |(_, share, [low, high]): &(_, f64, [f64; 2])| (*low..=*high).contains(share);
        if shares.iter().all(fits) {
            Ok(())
        } else {
            Err(Error::InvalidArgument(
                "exploring is in [0, 1], noise and slack in [0, 0.2], confidence in [0, 0.9999], \
                 precision_wanted in [0.5, 0.999]",
            ))
        }
    }
}
