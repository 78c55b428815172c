//! Expressions over a domain: the terms of offsets, features and constraints.

mod parser;
mod properties;
mod unit;
mod words;
mod writer;

pub use parser::MAX_DEPTH;
pub use properties::Dependence;
pub(super) use words::is_reserved;
