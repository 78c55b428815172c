//! Planning with skills.

mod expectation;
mod explain;
mod foresight;
mod guide;
mod here;
mod joint_region;
mod knowledge;
mod original;
mod sampler;

pub use guide::RegionGuide;
pub(super) use original::{completed, proposal};
pub use sampler::RegionSampler;
