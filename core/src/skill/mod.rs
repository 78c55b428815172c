//! Skills: the bridge between learning and planning.
//!
//! An environment says in a domain text what can be said of a controller, or of two
//! that run one after the other ([`Describe`]). From training tasks a [`Trainer`] learns
//! a region of each text (the thesis's RegionLearningApproach, 5.2, and its sequential
//! feasibility, 7.2):
//!
//! | text | of a controller alone | with a later one |
//! |---|---|---|
//! | with parameters | with which parameters it works | with which the later one works, too |
//! | without | in which states it works | in which states the two can work |
//!
//! The later controller may have parameters of its own and need others in between (pick,
//! put, pick): what is learned is whether there are any with which it works.
//!
//! | word | what it is |
//! |---|---|
//! | [`Skills`] | the store: a [`Skill`] for each text, with its region, and what controllers change ([`Changes`]) |
//! | [`RoleBinding`] | how the objects of a text, its *roles*, are filled from a [`Context`]: a state and the objects of ground operators |
//! | [`Situation`] | a state and the operators to try from it: an instance that can be run |
//! | [`Oracle`] | tries situations and answers the learner's questions |
//! | joint region | of a step in a plan skeleton: what its region and those of later steps have in common |
//! | [`RegionSampler`] | draws the parameters of a step from its joint region |
//! | [`RegionGuide`] | postpones, or prunes, a sequence of operators with an empty joint region |
//!
//! The last two are what a bilevel planner of the kind "search, then sample" (SeSamE, see
//! [`plan`](crate::plan)) asks for: its samplers, and advice to its search.

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
