//! Regions in the planner: roles, learning from training tasks, sampling, and why
//! something cannot work.

mod judging;
mod learned;
mod negative_control;
mod roles;
mod situations;
