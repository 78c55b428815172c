//! Built-in environments: worlds to learn in, to measure with and to test on.
//!
//! Each implements [`crate::domain::Environment`]; nothing else in the library
//! knows of any of them.

pub mod shelf;
pub mod stick_button;
