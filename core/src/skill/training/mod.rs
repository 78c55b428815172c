//! Learning skills from training tasks.

mod oracle;
mod selection;
mod settings;
mod trainer;

pub(super) use oracle::completed;
pub use settings::{Candidate, MAX_CHAIN, Setting};
pub use trainer::{Learned, Training, TrainingMemory};
