//! Recordings of environments of the Predicators framework: `tests/data/<name>`,
//! whose columns `tests/data/README.md` describes.
//!
//! One format serves all environments: states are numbers of typed objects, atoms
//! and operators have names. [`replay`] holds an environment against its recording.
//!
//! The readers panic on damaged data: they serve tests and reports only.

mod records;
mod replay;

pub use replay::{Counts, replay, replay_within};

use crate::data::{lines, next};
use critreg::task::{Environment, Task};
use records::{States, ground_atom};
use std::str::SplitWhitespace;

/// The recording of one environment, as text.
pub struct Recording {
    states: &'static str,
    transitions: &'static str,
    atoms: &'static str,
    feasibility: &'static str,
    chains: &'static str,
    tasks: &'static str,
    baseline: &'static str,
}

macro_rules! recording {
    ($name:literal) => {
        Recording {
            states: include_str!(concat!("../../data/", $name, "/states.txt")),
            transitions: include_str!(concat!("../../data/", $name, "/transitions.txt")),
            atoms: include_str!(concat!("../../data/", $name, "/atoms.txt")),
            feasibility: include_str!(concat!("../../data/", $name, "/feasibility.txt")),
            chains: include_str!(concat!("../../data/", $name, "/chains.txt")),
            tasks: include_str!(concat!("../../data/", $name, "/tasks.txt")),
            baseline: include_str!(concat!("../../data/", $name, "/baseline.txt")),
        }
    };
}

/// `cover`.
pub static COVER: Recording = recording!("cover");
/// `cover_regrasp`.
pub static COVER_REGRASP: Recording = recording!("cover_regrasp");
/// `regional_bumpy_cover`.
pub static REGIONAL_BUMPY_COVER: Recording = recording!("regional_bumpy_cover");
/// `cluttered_table`.
pub static CLUTTERED_TABLE: Recording = recording!("cluttered_table");
/// `cluttered_table_place`.
pub static CLUTTERED_TABLE_PLACE: Recording = recording!("cluttered_table_place");
/// `blocks`.
pub static BLOCKS: Recording = recording!("blocks");
/// `coffee`.
pub static COFFEE: Recording = recording!("coffee");
/// `stick_button_move`.
pub static STICK_BUTTON_MOVE: Recording = recording!("stick_button_move");

/// A recorded task.
pub struct RecordedTask {
    /// The seed of the experiment.
    pub seed: u64,
    /// `train` or `test`.
    pub split: &'static str,
    /// Its place among the tasks of the seed and split.
    pub index: usize,
    /// The task.
    pub task: Task,
}

/// How the framework's planner fared with the original samplers.
#[derive(Debug)]
pub struct Baseline {
    /// The number of tasks.
    pub tasks: u32,
    /// How many of them were solved.
    pub solved: u32,
    /// Mean number of samples drawn for a plan.
    pub mean_samples: f64,
    /// Median number of samples.
    pub median_samples: f64,
    /// The largest number of samples.
    pub max_samples: f64,
    /// Mean length of the plans.
    pub mean_plan_length: f64,
    /// Mean number of skeletons refined for a plan.
    pub mean_skeletons: f64,
}

impl Recording {
    /// The recorded tasks of an environment.
    pub fn tasks<E: Environment>(&self) -> Vec<RecordedTask> {
        let mut states = States::default();
        let task = |mut words: SplitWhitespace<'static>| {
            let words = &mut words;
            let (seed, split) = (next(words), words.next().expect("train or test"));
            let (index, goal) = (next(words), words.next().expect("a goal"));
            let initial = states.read::<E>(words);
            let atom = |text| ground_atom::<E>(&initial, text);
            let goal = goal.split(';').map(atom).collect();
            RecordedTask {
                seed,
                split,
                index,
                task: Task { initial, goal },
            }
        };
        lines(self.tasks).map(task).collect()
    }

    /// The framework's own results.
    pub fn baseline(&self) -> Baseline {
        let words = &mut self.baseline.split_whitespace();
        Baseline {
            tasks: next(words),
            solved: next(words),
            mean_samples: next(words),
            median_samples: next(words),
            max_samples: next(words),
            mean_plan_length: next(words),
            mean_skeletons: next(words),
        }
    }
}
