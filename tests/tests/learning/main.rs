//! The learners: what each promises, what all promise, and what they prove.

mod actions;
mod bodies;
mod learners;
mod membership;
mod proposals;
mod version_space;
