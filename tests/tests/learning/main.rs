//! The learners: what each promises, what all promise, and what they prove.

mod actions;
mod bodies;
mod cases;
mod challenge;
mod choosing;
mod damage;
mod growing;
mod large_numbers;
mod laws;
mod learners;
mod left_out;
mod membership;
mod noise;
mod observing;
mod on_the_way;
mod proposals;
mod questions;
mod shelf;
mod task;
mod version_space;
mod why;
