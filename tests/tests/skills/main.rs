//! Regions in the planner: roles, learning from training tasks, sampling, and why
//! something cannot work.

mod learned;
mod negative_control;
mod pairs;
mod region_guide;
mod roles;
mod situations;
