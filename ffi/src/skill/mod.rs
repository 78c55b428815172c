//! Skills, for programs in C: what is learned of a program's controllers, and used when it
//! plans.
//!
//! | module | content |
//! |---|---|
//! | [`config`] | how much is tried, and what there is room for |
//! | `layout` | where the parts of skills lie in their memory |
//! | [`handle`] | skills in the caller's memory |
//! | [`making`] | making them: controllers, skills and training tasks are added one by one |
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
pub(crate) mod facts;
pub mod handle;
pub(crate) mod layout;
pub mod learning;
pub mod making;
pub(crate) mod practice;
pub mod report;
pub mod saving;
