//! Learning skills from training tasks.

mod oracle;
mod selection;
mod situations;
mod trainer;

pub(super) use oracle::completed;
pub use situations::{Candidate, MAX_CHAIN, Situation};
pub use trainer::{Learned, Training, TrainingMemory};
