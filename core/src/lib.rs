//! draft
#![no_std]
#![forbid(unsafe_code)]
#[cfg(test)]
extern crate std;
pub mod domain;
pub mod env;
mod error;
pub mod geometry;
pub mod grammar;
pub mod learn;
pub mod random;
pub mod real;
pub mod region;
pub mod table;
pub mod text;
mod wire;
pub use error::{Error, SyntaxError};
