//! What the version-space learner is given, and what it reports.

use super::cover::{Cover, MAX_STEPS, MEMBERS};
use super::forms::{MAX_LEFTS, MAX_WORDS, Sample, Span};
use crate::domain::Node;
use crate::error::Error;
use crate::grammar::MAX_CONSTRAINTS;
use crate::learn::Observation;
use crate::region::Region;

/// Most observations: 2048, or 256 without the feature `many_observations`.
pub const MAX_OBSERVATIONS: usize = 64 * MAX_WORDS;

/// How much a learner has room for.
///
/// | table of [`Memory`] | bytes, numbers of 8 bytes |
/// |---|---|
/// | `spans` | 16 per form tracked and step |
/// | `bits` | 16 per form tracked and 64 observations |
/// | `features`, `columns` | 18 per 8 forms, and 64 more |
/// | `instances` | 1 per form and instance, and 512 per instance |
/// | `rows`, `lefts` | [`Capacity::lefts`] times 8 per observation, and once more |
/// | `covers` | 5120 per step |
/// | `sets` | 16 per step and 64 observations |
/// | `region`, `support` | about 4200 |
/// | `samples`, `observations` | 4 and 56 per observation |
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Capacity {
    /// Forms; those that find no room are left out, the most complex ones.
    pub forms: usize,
    /// Of how many of them, the simplest ones, the version space is tracked; of all if
    /// there are fewer. That of the others is computed from the samples whenever it is
    /// needed: what is learned is the same, for less memory and more time.
    pub tracked: usize,
    /// Observations: answers that can be told, at most [`MAX_OBSERVATIONS`].
    pub observations: usize,
    /// Problem instances.
    pub instances: usize,
    /// Steps of the sequence of actions that is learned about, at most 4.
    pub steps: usize,
}

impl Capacity {
    /// Room for features.
    pub const fn features(self) -> usize {
        let wanted = 64 + self.forms / 8;
        if wanted < 60_000 { wanted } else { 60_000 }
    }

    /// Room for left sides of forms.
    pub const fn lefts(self) -> usize {
        let wanted = 16 + self.forms / 128;
        if wanted < MAX_LEFTS {
            wanted
        } else {
            MAX_LEFTS
        }
    }

    /// Numbers that the right sides have in all instances.
    pub const fn instance_values(self) -> usize {
        self.features() * self.instances
    }

    /// Forms whose version space is tracked.
    pub(super) const fn tracked(self) -> usize {
        if self.tracked < self.forms {
            self.tracked
        } else {
            self.forms
        }
    }

    /// Intervals of forms.
    pub const fn spans(self) -> usize {
        self.tracked() * self.steps
    }

    /// Words of the table that tells which form excludes which observation.
    pub const fn bits(self) -> usize {
        2 * self.tracked() * self.observations.div_ceil(64)
    }

    /// Numbers that the left sides have at the samples; at first, those that all
    /// features have in an instance.
    pub const fn rows(self) -> usize {
        let rows = self.lefts() * self.observations;
        if rows < self.features() {
            self.features()
        } else {
            rows
        }
    }

    /// Words of the sets of samples: at which a step worked, and at which it failed.
    pub const fn sets(self) -> usize {
        2 * self.steps * self.observations.div_ceil(64)
    }

    /// What supports the constraints of a region.
    pub const fn support(self) -> usize {
        MAX_CONSTRAINTS
    }

    /// Explanations: a committee for every step.
    pub const fn covers(self) -> usize {
        MEMBERS * self.steps
    }

    pub(super) fn check(self) -> Result<(), Error> {
        if self.steps == 0 || self.steps > MAX_STEPS {
            return Err(Error::InvalidArgument("a learner has one to four steps"));
        }
        if self.observations > MAX_OBSERVATIONS {
            return Err(Error::InvalidArgument(
                "a learner has room for at most 2048 observations, or 256 in a small build",
            ));
        }
        Ok(())
    }
}

/// The tables of a learner, lent by the caller. Each must have at least the
/// length that [`Capacity`] tells; what is longer is not used.
#[derive(Debug)]
pub struct Memory<'m, R> {
    /// [`Capacity::features`] terms.
    pub features: &'m mut [Node],
    /// [`Capacity::features`] indices.
    pub columns: &'m mut [u16],
    /// [`Capacity::instance_values`] numbers.
    pub instances: &'m mut [R],
    /// [`Capacity::spans`] intervals.
    pub spans: &'m mut [Span<R>],
    /// [`Capacity::bits`] words.
    pub bits: &'m mut [u64],
    /// [`Capacity::rows`] numbers.
    pub rows: &'m mut [R],
    /// [`Capacity::lefts`] numbers.
    pub lefts: &'m mut [R],
    /// [`Capacity::sets`] words.
    pub sets: &'m mut [u64],
    /// [`Capacity::covers`] explanations.
    pub covers: &'m mut [Cover<R>],
    /// [`Capacity::observations`] entries.
    pub samples: &'m mut [Sample],
    /// [`Capacity::observations`] observations.
    pub observations: &'m mut [Observation],
    /// [`Capacity::support`] entries.
    pub support: &'m mut [Evidence],
    /// Where the region is written.
    pub region: &'m mut Region,
}

impl<R> Memory<'_, R> {
    /// The same memory, lent for a shorter time.
    pub fn reborrow(&mut self) -> Memory<'_, R> {
        Memory {
            features: self.features,
            columns: self.columns,
            instances: self.instances,
            spans: self.spans,
            bits: self.bits,
            rows: self.rows,
            lefts: self.lefts,
            sets: self.sets,
            covers: self.covers,
            samples: self.samples,
            observations: self.observations,
            support: self.support,
            region: self.region,
        }
    }
}

/// What decides the questions of a learner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Config {
    /// Seed of all random choices.
    pub seed: u64,
    /// How many answers are asked for.
    pub calls: u32,
    /// How many of these, the last ones, are draws from the region to certify it.
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
    /// Confidence of the certificate, in `[0, 0.9999]`.
    pub confidence: f64,
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
            confidence: 0.95,
        }
    }
}

impl Config {
    pub(super) fn check(&self) -> Result<(), Error> {
        let share = |x: f64, high: f64| (0.0..=high).contains(&x);
        if share(self.exploring, 1.0)
            && share(self.noise, 0.2)
            && share(self.slack, 0.2)
            && share(self.confidence, 0.9999)
        {
            Ok(())
        } else {
            Err(Error::InvalidArgument(
                "exploring is in [0, 1], noise and slack in [0, 0.2], confidence in [0, 0.9999]",
            ))
        }
    }
}

/// How learning went so far.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Report {
    /// Forms in use.
    pub forms: usize,
    /// Forms that found no room.
    pub forms_left_out: usize,
    /// Answers told.
    pub calls: usize,
    /// Samples whose answer is decided, feasible and infeasible ones.
    pub feasible: usize,
    /// Infeasible ones.
    pub infeasible: usize,
    /// Samples put aside because their answer is unknown.
    pub unknown: usize,
    /// Constraints that found no room in the region, which is too large without them.
    pub constraints_left_out: usize,
    /// Samples that the region is wrong about, see [`Config::slack`].
    pub strays: usize,
    /// Draws from the region, and what they prove.
    pub certificate: super::Certificate,
}

/// What supports a constraint of a region.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
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
