//! The planner, for programs that have none of their own.
//!
//! | module | content |
//! |---|---|
//! | [`config`] | what a planner is told to do, and what it has room for |
//! | [`check`] | what is wrong with PDDL texts, in words, and what they need |
//! | [`callbacks`] | what it asks the program |
//! | `names` | the names of PDDL texts as C wants them |
//! | `tables`, `layout` | what lies in its memory, and where |
//! | [`handle`] | a planner in the caller's memory |
//! | [`making`] | making one |
//! | `world` | the callbacks as the world, the sampler and the guide of the core's planner |
//! | [`planning`], [`step`] | planning; the steps of the plan |
//! | [`why`] | why there is no plan |
//! | [`metrics`], [`inspection`] | what planning cost and what stood in its way, on request |

pub mod callbacks;
pub mod check;
pub mod config;
pub mod handle;
pub mod inspection;
pub(crate) mod layout;
pub mod making;
pub mod metrics;
pub(crate) mod names;
pub mod planning;
pub mod step;
pub(crate) mod tables;
pub mod why;
pub(crate) mod world;
