//! draft
#![no_std]
#![forbid(unsafe_code)]
#[cfg(test)]
extern crate std;
pub mod domain;
pub mod geometry;
pub mod real;
