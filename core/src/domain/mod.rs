//! draft
mod dimension;
pub use dimension::Dimension;
