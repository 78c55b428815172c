//! Why no plan was found.

use super::config::Config;
use super::metrics::Metrics;
use super::planner::Conclusion;

/// Why no plan was found: what to change first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Why {
    /// No sequence of operators reaches the goal, however long: the text says that it is
    /// impossible.
    NoSkeleton,
    /// The guide pruned all sequences that reach the goal.
    Pruned,
    /// None of up to [`Config::max_length`] operators was found.
    Length,
    /// Skeletons were given up because a step with parameters had failed
    /// [`Config::max_tries`] times, while samples were left.
    Tries,
    /// Skeletons were given up because of a step without parameters: the world does not do
    /// what the operators promise.
    World,
    /// [`Config::max_skeletons`] were refined in vain.
    Skeletons,
    /// [`Config::max_samples`] were drawn in vain.
    Samples,
    /// Some memory is full; which.
    Memory(&'static str),
}

impl Why {
    /// What planning ended for; `None` if there is a plan.
    pub fn new(conclusion: Conclusion, metrics: &Metrics<'_>, config: &Config) -> Option<Why> {
        let failed = if metrics.tries_spent > 0 {
            Why::Tries
        } else {
            Why::World
        };
        Some(match conclusion {
            Conclusion::Solved => return None,
            Conclusion::Full(what) => Why::Memory(what),
            Conclusion::SamplesSpent => Why::Samples,
            // Most of the samples are left, so there were too few tries of each step.
            Conclusion::SkeletonsSpent
                if failed == Why::Tries && metrics.samples < config.max_samples / 2 =>
            {
                Why::Tries
            }
            Conclusion::SkeletonsSpent => Why::Skeletons,
            _ if metrics.skeletons > 0 => failed,
            _ if metrics.pruned > 0 => Why::Pruned,
            Conclusion::LengthSpent => Why::Length,
            Conclusion::Exhausted => Why::NoSkeleton,
        })
    }
}
