//! The tables of learners, owned, for host programs.

mod algorithm1;
mod version_space;

pub use algorithm1::Algorithm1Room;
pub use version_space::VersionSpaceRoom;
