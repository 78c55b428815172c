//! How much is tried to learn a skill, and what it took.

use crate::learn::Config;
use crate::learn::version_space::{Quality, Report, Why};
use crate::plan;
use crate::skill::tuning::{CANDIDATES, PRECISION_WANTED};

/// How much is tried to learn a skill. The defaults suit an environment whose tasks cost
/// little to make; they are chosen with `report -- table`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Training {
    /// What the learner is given about a controller alone.
    pub learner: Config,
    /// Questions about two controllers.
    pub chained: u32,
    /// How many controllers may be run to learn one about which there is a single text. Its
    /// questions are what the ways to situations leave of them, if that is more than the
    /// learner's calls.
    pub budget: u32,
    /// Tasks that situations are taken from.
    pub tasks: usize,
    /// Situations in which parameters are tried.
    pub situations: usize,
    /// Situations of a text without parameters, each of which is tried once.
    pub states: usize,
    /// Controllers that may be run on the way to one situation, at each attempt.
    pub way: u32,
}

impl Default for Training {
    fn default() -> Self {
        Training {
            learner: Config {
                precision_wanted: PRECISION_WANTED,
                ..Config::default()
            },
            chained: 200,
            budget: 0,
            tasks: 150,
            situations: 20,
            states: 150,
            way: plan::Config::default().max_samples,
        }
    }
}

impl Training {
    /// Situations to choose from: the more there are, the more those that are chosen
    /// differ.
    pub(super) fn candidates(&self) -> usize {
        CANDIDATES * self.situations.max(self.states)
    }
}

/// What it took to learn a skill.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Learned {
    /// Whether there is a region.
    pub region: bool,
    /// Tasks that situations were taken from.
    pub tasks: usize,
    /// Situations that were found, and say something.
    pub situations: usize,
    /// Controllers that were run, those on the way to a situation included.
    pub runs: u32,
    /// What the learner was told, and what draws from the region prove.
    pub report: Report,
    /// What the region is worth.
    pub quality: Quality,
    /// Why there is no region, or no better one.
    pub why: Why,
}
