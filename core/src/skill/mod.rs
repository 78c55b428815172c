//! Skills: what is known of the controllers of an environment, as regions.
//!
//! An environment says in a domain text what can be said of a controller, or of two
//! that run one after the other ([`Describe`]). The objects of the text are *roles*,
//! which a state and ground operators fill ([`RoleBinding`]). From training tasks
//! [`Skills::learn`] learns regions (the thesis's RegionLearningApproach, 5.2, and its
//! sequential feasibility, 7.2):
//!
//! | text | of a controller alone | with a later one |
//! |---|---|---|
//! | with parameters | with which parameters it works | with which the later one works, too |
//! | without | in which states it works | in which states the two can work |
//!
//! The later controller may have parameters of its own and need others in between (pick,
//! put, pick): what is learned is whether there are any with which it works.
//!
//! [`Informed`] plans with them: as a sampler it draws from the region of a step and
//! those of all later steps at once, as a guide it postpones what cannot work.

mod changes;
mod context;
mod description;
mod planning;
mod role_binding;
mod room;
mod skills;
mod training;
mod tuning;

pub use changes::Changes;
pub use context::Context;
pub use description::{Describe, Description};
pub use planning::{RegionGuide, RegionSampler};
pub use role_binding::RoleBinding;
pub use room::{SkillRoom, TrainingRoom};
pub use skills::{Skill, Skills};
pub use training::{
    Candidate, Learned, MAX_CHAIN, Oracle, Situation, Trainer, Training, TrainingMemory,
};
