//! The learners: what each promises, what all promise, and what they prove.

mod actions;
mod bodies;
mod choosing;
mod damage;
mod growing;
mod large_numbers;
mod learners;
mod membership;
mod noise;
mod observing;
mod proposals;
mod questions;
mod shelf;
mod version_space;
