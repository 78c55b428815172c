//! Learning skills from training tasks.

mod candidates;
mod config;
mod journal;
mod memory;
mod oracle;
mod realise;
mod saving;
mod selection;
mod situation;
mod trainer;

pub use config::{Learned, Training};
pub use journal::Journal;
pub use memory::TrainingMemory;
pub use oracle::Oracle;
pub use saving::Course;
pub use situation::{Candidate, MAX_CHAIN, Situation};
pub use trainer::Trainer;
