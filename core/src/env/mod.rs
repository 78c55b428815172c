//! Built-in environments: worlds to learn in, to measure with and to test on.
//!
//! Each implements [`crate::task::Environment`]; nothing else in the library
//! knows of any of them.

pub mod blocks;
pub mod cluttered_table;
pub mod cover;
pub mod shelf;
pub mod stick_button;
