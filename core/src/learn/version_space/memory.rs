//! How much a version space learner has room for, and the tables that it lives in.

use super::committee::MEMBERS;
use super::forms::{MAX_LHS, MAX_WORDS};
use super::hypothesis::MAX_CLAUSES;
use crate::error::Error;
use crate::grammar::MAX_CONSTRAINTS;
use crate::learn::question::MAX_QUESTIONS;
use crate::learn::tables::memory;

// What lies in the memory and what tells its lengths know each other: the entries of the
// tables are types of the rooms that are made of them.

/// Most observations: 2048, or 256 without the feature `many_observations`.
pub const MAX_OBSERVATIONS: usize = 64 * MAX_WORDS;

/// Most forms with a sum on the right.
pub const MAX_SUMS: usize = 512;

/// Most steps of a sequence of actions.
pub(super) const MAX_STEPS: usize = 4;

/// How much a learner has room for.
///
/// | tables of [`Memory`] | bytes, numbers of 8 bytes |
/// |---|---|
/// | `intervals` | 16 per form tracked, and sum if all are, and step |
/// | `exclusions` | 16 per form tracked, and sum if all are, and 64 observations |
/// | `features`, `rhs_features` | 18 per 8 forms, and 64 more |
/// | `rhs_values` | 1 per form and instance, and 512 per instance |
/// | `lhs_values`, `lhs`, `lefts` | [`Capacity::lhs`] times 8 per observation, and twice more |
/// | `sums`, `sum_values` | 28 per sum, and 8 per sum and instance |
/// | `ends`, `failures` | 16 per instance and per observation |
/// | `hypotheses`, `approximations` | 5328 per step, and 592 |
/// | `sample_sets` | 16 per step and 64 observations |
/// | `trials` | 80 per question |
/// | `region`, `evidence` | about 4200 |
/// | `samples`, `observations` | 4 and 56 per observation |
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Capacity {
    /// Forms; those that find no room are left out, the most complex ones.
    pub forms: usize,
    /// Of how many of them, the simplest ones, the version space is tracked; of all if
    /// there are fewer. That of the others is computed from the samples whenever it is
    /// needed: what is learned is the same, for less memory and more time.
    pub tracked: usize,
    /// Observations: outcomes that can be told, at most [`MAX_OBSERVATIONS`].
    pub observations: usize,
    /// Problem instances.
    pub instances: usize,
    /// Steps of the sequence of actions that is learned about, at most 4.
    pub steps: usize,
    /// Forms more whose right side is a sum of scaled features, or whose left side is
    /// derived; as many as a sixteenth of `forms`, and [`MAX_SUMS`], at most. They are looked
    /// for where the other forms explain the answers at length or not at all. With zero they
    /// are not.
    pub sums: usize,
    /// Questions that can be open at once, at most [`MAX_QUESTIONS`]; forgotten ones are among
    /// them until their place is needed.
    pub questions: usize,
}

impl Capacity {
    /// Room for so many forms and observations, 16 instances, 16 open questions, and a single
    /// action.
    pub const fn new(forms: usize, observations: usize) -> Capacity {
        Capacity {
            forms,
            tracked: usize::MAX,
            observations,
            instances: 16,
            steps: 1,
            sums: usize::MAX,
            questions: 16,
        }
    }

    /// Features.
    pub const fn features(self) -> usize {
        let wanted = 64 + self.forms / 8 + 2 * self.derived();
        if wanted < 60_000 { wanted } else { 60_000 }
    }

    /// Left sides of the forms that are enumerated.
    pub const fn plain(self) -> usize {
        let wanted = 16 + self.forms / 128;
        if wanted < MAX_LHS / 2 {
            wanted
        } else {
            MAX_LHS / 2
        }
    }

    /// Left sides beside them that are derived for sums.
    pub(super) const fn derived(self) -> usize {
        if self.sums() == 0 { 0 } else { self.plain() }
    }

    /// Left sides of all forms.
    pub const fn lhs(self) -> usize {
        self.plain() + self.derived()
    }

    /// Forms with sums.
    pub const fn sums(self) -> usize {
        let (most, wanted) = (self.forms / 16, self.sums);
        let most = if most < MAX_SUMS { most } else { MAX_SUMS };
        if wanted < most { wanted } else { most }
    }

    /// Numbers that the right sides of sums have in all instances.
    pub const fn sum_values(self) -> usize {
        self.sums() * self.instances
    }

    /// Instances in the search for sums.
    pub const fn ends(self) -> usize {
        if self.sums() == 0 { 0 } else { self.instances }
    }

    /// Samples in the search for sums.
    pub const fn failures(self) -> usize {
        if self.sums() == 0 {
            0
        } else {
            self.observations
        }
    }

    /// Numbers that the right sides have in all instances.
    pub const fn rhs_values(self) -> usize {
        self.features() * self.instances
    }

    /// Numbers that the left sides have at the samples; at first, those that all
    /// features have in an instance.
    pub const fn lhs_values(self) -> usize {
        let values = self.lhs() * self.observations;
        if values < self.features() {
            self.features()
        } else {
            values
        }
    }

    /// Forms whose version space is tracked; where all are, those with sums are among them,
    /// behind the others.
    pub(super) const fn tracked(self) -> usize {
        if self.tracked < self.forms {
            self.tracked
        } else {
            self.forms + self.sums()
        }
    }

    /// Intervals S of forms.
    pub const fn intervals(self) -> usize {
        self.tracked() * self.steps
    }

    /// Words of the bitmaps that tell which form excludes which sample.
    pub const fn exclusions(self) -> usize {
        2 * self.tracked() * self.observations.div_ceil(64)
    }

    /// Words of the sets of samples: at which a step worked, and at which it failed.
    pub const fn sample_sets(self) -> usize {
        2 * self.steps * self.observations.div_ceil(64)
    }

    /// Observations, and samples.
    pub const fn observations(self) -> usize {
        self.observations
    }

    /// Questions that are open.
    pub const fn questions(self) -> usize {
        self.questions
    }

    /// Hypotheses: a committee for every step, and a draft.
    pub const fn hypotheses(self) -> usize {
        MEMBERS * self.steps + 1
    }

    /// Hypotheses that explain most answers: one for every step.
    pub const fn approximations(self) -> usize {
        self.steps
    }

    /// What supports the constraints of a region.
    pub const fn evidence(self) -> usize {
        let most = 2 * MAX_CLAUSES * self.steps;
        if most < MAX_CONSTRAINTS {
            most
        } else {
            MAX_CONSTRAINTS
        }
    }

    /// Regions: the one that is learned.
    pub const fn region(self) -> usize {
        1
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
        if self.questions == 0 || self.questions > MAX_QUESTIONS {
            return Err(Error::InvalidArgument(
                "a learner has room for one to 64 open questions",
            ));
        }
        Ok(())
    }
}

/// The one list of its tables, see `learn/tables.rs`.
#[doc(hidden)]
#[macro_export]
macro_rules! version_space_tables {
    ([$($receiver:tt)*] $real:ty $(, $($argument:tt)*)?) => {
        $($receiver)*! {
            [$($($argument)*)?]
            /// Terms.
            features: $crate::domain::Node, features;
            /// Right sides in the instances.
            rhs_values: $real, rhs_values;
            /// Left sides at the samples.
            lhs_values: $real, lhs_values;
            /// Left sides at the sample that is looked at.
            lhs: $real, lhs;
            /// S of the forms.
            intervals: $crate::learn::version_space::Interval<$real>, intervals;
            /// Which form excludes which sample.
            exclusions: u64, exclusions;
            /// At which samples a step worked and failed.
            sample_sets: u64, sample_sets;
            /// The committees.
            hypotheses: $crate::learn::version_space::Hypothesis<$real>, hypotheses;
            /// Those that explain most answers, where none explains all.
            approximations: $crate::learn::version_space::Hypothesis<$real>, approximations;
            /// What was asked and told.
            observations: $crate::learn::Observation, observations;
            /// Questions that are open.
            trials: $crate::learn::Trial, questions;
            /// What supports the constraints of the region.
            evidence: $crate::learn::version_space::Evidence, evidence;
            /// Where the region is written.
            region: $crate::region::Region, region;
            /// Samples whose label is decided.
            samples: $crate::learn::version_space::Sample, observations;
            /// Which features the right sides are.
            rhs_features: u16, features;
            /// The left sides.
            lefts: $crate::learn::version_space::Left, lhs;
            /// Forms with a sum on the right.
            sums: $crate::learn::version_space::Sum, sums;
            /// Those right sides in the instances.
            sum_values: $real, sum_values;
            /// What the samples of the instances say about a left side.
            ends: $crate::learn::version_space::End<$real>, ends;
            /// The infeasible samples by instance.
            failures: $crate::learn::version_space::Failure<$real>, failures;
        }
    };
}

version_space_tables! { [memory] R }
