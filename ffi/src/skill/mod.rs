//! Skills, for programs in C: what is learned of a program's controllers, and used when it
//! plans.
//!
//! | module | content |
//! |---|---|
//! | [`config`] | how much is tried, and what there is room for |
//! | `layout` | where the parts of skills lie in their memory |
//! | [`handle`] | skills in the caller's memory |
//! | [`making`] | making them in memory of the program |
//! | [`controllers`] | adding controllers |
//! | [`descriptions`] | adding skills: controllers, and what can be said of them |
//! | [`training_tasks`] | adding training tasks |
//! | `facts` | what is known of types, controllers and actions |
//! | `arrangement` | which numbers of a state belong to which object |
//! | `practice` | the callbacks as what skills are learned in |
//! | [`learning`] | learning |
//! | [`report`] | what was learned, and what it took |
//! | [`saving`] | saving what was learned, and going on from there |
//! | `advice` | skills as the sampler and the guide of a planner |

pub(crate) mod advice;
pub(crate) mod arrangement;
pub mod config;
pub mod controllers;
pub mod descriptions;
pub(crate) mod facts;
pub mod handle;
pub(crate) mod layout;
pub mod learning;
pub mod making;
pub(crate) mod practice;
pub mod report;
pub mod saving;
pub mod training_tasks;
