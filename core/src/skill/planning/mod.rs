//! Planning with skills.

mod explain;
mod informed;
mod joint_region;

pub use informed::Informed;
