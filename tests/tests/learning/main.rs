//! The learners: what each promises, what all promise, and what they prove.

mod actions;
mod bodies;
mod growing;
mod learners;
mod membership;
mod observing;
mod proposals;
mod questions;
mod shelf;
mod version_space;
