//! How often the learners find the true region, measured by the simulator.

mod domains;
mod instances;
mod judge;
mod judged;
mod latency;
mod parallel;
mod passive;
mod pddl;
mod proof;
mod row;
mod runs;
mod scenario;
mod sensitivity;
mod shapes;
mod statistics;
mod synthetic;
mod table;

pub use domains::{NAMES as DOMAINS, print as domains, train, training};
pub use instances::print as instances;
pub use judge::{Score, Truth};
pub use latency::print as latency;
pub use parallel::print as parallel;
pub use passive::print as passive;
pub use pddl::pddl;
pub use proof::{Claim, proof};
pub use runs::{LEARNERS, for_seeds, run_seed};
pub use scenario::{Scenario, angles, chain, noise, pick};
pub use sensitivity::print as sensitivity;
pub use shapes::{groups, interval, state, union};
pub use statistics::{Run, Statistics};
pub use synthetic::synthetic;
pub use table::print as table;
