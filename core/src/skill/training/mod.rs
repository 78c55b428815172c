//! Learning skills from training tasks.

mod candidates;
mod config;
mod memory;
mod oracle;
mod realise;
mod selection;
mod situation;
mod trainer;

pub use config::{Learned, Training};
pub use memory::TrainingMemory;
pub use oracle::Oracle;
pub use situation::{Candidate, MAX_CHAIN, Situation};
pub use trainer::Trainer;
