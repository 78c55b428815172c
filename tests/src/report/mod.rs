//! How often the learners find the true region, measured by the simulator.

mod judge;
mod room;
mod scenario;
mod shapes;
mod statistics;
mod synthetic;

pub use judge::{Score, Truth};
pub use room::VersionSpaceRoom;
pub use scenario::{Scenario, angles, chain, noise, pick};
pub use shapes::{groups, interval, state, union};
pub use statistics::{Run, Statistics};
pub use synthetic::synthetic;
