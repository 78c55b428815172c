//! What planning cost, and what stood in its way.

use super::config::Config;
use super::guide::ReasonId;
use crate::task::OperatorId;

/// Counts of one planning. All are there however it ended.
#[derive(Debug, Default)]
pub struct Metrics<'m> {
    /// Tries of a step: parameters were drawn and the controller was run, or none were
    /// found. Steps without parameters count too, so the length of the plan is the least.
    pub samples: u32,
    /// Plan skeletons that were refined.
    pub skeletons: u32,
    /// Sequences of operators that were extended by one.
    pub nodes_expanded: u32,
    /// Sequences of operators that were created, the empty one included.
    pub nodes_created: u32,
    /// Sequences that the guide pruned.
    pub pruned: u32,
    /// Sequences that the guide postponed: they were left out until patience ended.
    pub postponed: u32,
    /// Sequences that were not extended because of their length.
    pub cut_off: u32,
    /// Sequences that were not extended at first, as enough others lead to the same
    /// abstract state: see [`Config::skeletons_per_state`].
    pub repeated: u32,
    /// Sequences that were left out because they begin with one that cannot work: a step
    /// without parameters, after none but such, whose controller takes no action.
    pub dead: u32,
    /// Skeletons that were given up because a step with parameters had used its tries:
    /// [`Config::max_tries`].
    pub tries_spent: u32,
    /// Draws that ended with the sampler knowing that no parameters work.
    pub empty_draws: u32,
    /// Draws in which the sampler knew where to draw.
    pub informed_draws: u32,
    /// If patience ended: what was spent until then. The limits count from there.
    pub advised: Option<Spent>,
    /// Actions taken in the world; runs that failed without a result not counted.
    pub actions: u64,
    /// Operators in the plan.
    pub plan_length: u32,
    /// Counts that found no place in the two tables below.
    pub uncounted: u32,
    /// The effort at the first objection.
    first_objection: Option<u32>,
    failures: &'m mut [u32],
    reasons: &'m mut [u32],
}

/// What of the limits of planning is spent.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Spent {
    /// Samples.
    pub samples: u32,
    /// Skeletons.
    pub skeletons: u32,
}

impl Spent {
    /// Whether nothing of a limit is left.
    pub(super) fn exceeds(self, config: &Config) -> bool {
        self.samples >= config.max_samples || self.skeletons >= config.max_skeletons
    }
}

impl<'m> Metrics<'m> {
    /// Nothing counted. `failures` has a counter for each operator, `reasons` for
    /// each [`ReasonId`]; what has none is counted in [`Metrics::uncounted`].
    pub fn new(failures: &'m mut [u32], reasons: &'m mut [u32]) -> Self {
        failures.fill(0);
        reasons.fill(0);
        Metrics {
            failures,
            reasons,
            ..Metrics::default()
        }
    }

    /// For each operator, by its id: how often a step of it failed.
    pub fn failures(&self) -> &[u32] {
        self.failures
    }

    /// For each reason, by its id: how often it stood in the way.
    pub fn reasons(&self) -> &[u32] {
        self.reasons
    }

    /// The operator whose steps failed most often, the first of equals; `None` if
    /// none failed.
    pub fn most_failed(&self) -> Option<OperatorId> {
        most(self.failures).and_then(|place| u8::try_from(place).ok().map(OperatorId))
    }

    /// The most frequent reason, the first of equals: why no plan was found.
    /// `None` if no reason was given.
    pub fn main_reason(&self) -> Option<ReasonId> {
        most(self.reasons).and_then(|place| u16::try_from(place).ok().map(ReasonId))
    }

    /// What of the limits is spent.
    pub(super) fn spent(&self) -> Spent {
        let before = self.advised.unwrap_or_default();
        Spent {
            samples: self.samples.saturating_sub(before.samples),
            skeletons: self.skeletons.saturating_sub(before.skeletons),
        }
    }

    /// Whether advice counts, and there was some.
    pub(super) fn is_advised(&self) -> bool {
        let advice = [self.postponed, self.empty_draws, self.informed_draws];
        self.advised.is_none() && advice.iter().any(|count| *count > 0)
    }

    /// Whether it is time to go on without advice.
    pub(super) fn is_patience_spent(&self, config: &Config) -> bool {
        let since = |first| self.effort().saturating_sub(first) >= config.patience;
        let tired = self.first_objection.is_some_and(since);
        self.is_advised() && (tired || self.spent().exceeds(config))
    }

    fn effort(&self) -> u32 {
        self.nodes_expanded.saturating_add(self.samples)
    }

    /// From here on advice no longer counts.
    pub(super) fn end_advice(&mut self) {
        self.advised = Some(self.spent());
    }

    pub(super) fn fail(&mut self, OperatorId(operator): OperatorId) {
        let counter = self.failures.get_mut(usize::from(operator));
        *counter.unwrap_or(&mut self.uncounted) += 1;
    }

    pub(super) fn blame(&mut self, ReasonId(reason): ReasonId) {
        let effort = self.effort();
        self.first_objection.get_or_insert(effort);
        let counter = self.reasons.get_mut(usize::from(reason));
        *counter.unwrap_or(&mut self.uncounted) += 1;
    }
}

/// Where the first of the largest counts is, if that is not zero.
fn most(counts: &[u32]) -> Option<usize> {
    let largest = *counts.iter().max().filter(|count| **count > 0)?;
    counts.iter().position(|count| *count == largest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_without_a_counter_are_counted_together() {
        let (mut failures, mut reasons) = ([7; 2], [7; 3]);
        let mut metrics = Metrics::new(&mut failures, &mut reasons);
        assert_eq!((metrics.most_failed(), metrics.main_reason()), (None, None));
        for operator in [0, 1, 1, 2] {
            metrics.fail(OperatorId(operator));
        }
        for reason in [2, 1, 2, 1, 3, 9, 9] {
            metrics.blame(ReasonId(reason));
        }
        assert_eq!(metrics.failures(), [1, 2]);
        assert_eq!(metrics.reasons(), [0, 2, 2]);
        assert_eq!(metrics.uncounted, 4);
        assert_eq!(metrics.most_failed(), Some(OperatorId(1)));
        assert_eq!(
            metrics.main_reason(),
            Some(ReasonId(1)),
            "the first of equals"
        );
    }
}
