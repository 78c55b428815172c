//! draft
mod features;
mod formula;
mod hypotheses;
pub use features::*;
pub use formula::*;
pub use hypotheses::{Enumeration, Hypotheses, MAX_PAIR_COMPLEXITY};
pub(crate) use hypotheses::{Run, bit, feature_id};
