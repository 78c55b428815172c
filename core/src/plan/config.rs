//! How to plan, and how long.

use super::heuristic::Heuristic;
use super::skeleton::MAX_SKELETON;

/// How to plan, and how long. The defaults are those of the Predicators framework,
/// with about as many samples as it draws in the time that it has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Config {
    /// What guides the search.
    pub heuristic: Heuristic,
    /// Most plan skeletons to refine.
    pub max_skeletons: u32,
    /// Tries of a step with parameters before it steps back; a step without any has
    /// one.
    pub max_tries: u32,
    /// Most operators in a plan skeleton: longer sequences are not extended. At
    /// most [`MAX_SKELETON`], and as many as the memory has steps.
    pub max_length: usize,
    /// Most actions in a plan.
    pub max_actions: u32,
    /// Most samples, each of which runs a controller: the budget that stands for
    /// time, so that the same inputs always end in the same way.
    pub max_samples: u32,
    /// How many sequences that lead to one abstract state are extended before all others
    /// are. Behind the first they are plan skeletons of their own only if continuous
    /// choices, or the order of steps, leave something else behind. The bound doubles with
    /// each skeleton that cannot be refined, and when nothing else is left, so none is
    /// lost. [`u32::MAX`], the default, is no bound, as in the framework; where no operator
    /// has parameters it is 1.
    pub skeletons_per_state: u32,
    /// How many nodes are expanded and samples drawn after the first objection of a
    /// guide or a sampler. If there is no plan by then, planning begins anew without
    /// advice, and so do the limits above. So wrong advice costs at most so much, but
    /// never a plan.
    pub patience: u32,
}

impl Default for Config {
    fn default() -> Self {
        Config {
            heuristic: Heuristic::default(),
            max_skeletons: 1000,
            max_tries: 10,
            max_length: MAX_SKELETON,
            max_actions: 100,
            max_samples: 10_000,
            skeletons_per_state: u32::MAX,
            patience: 256,
        }
    }
}
