//! The library as C and C++ programs get it, and what its documents say of it.

mod abi;
mod examples;
mod export;
mod field;
mod pictures;
mod readme;
mod skills;
mod support;
