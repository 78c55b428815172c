//! Built-in environments: worlds to learn in, to measure with and to test on.
//!
//! Each implements [`crate::task::Environment`]; nothing else in the library
//! knows of any of them. [`stick_button`] is that of the thesis and always there; the
//! others (`blocks`, `cluttered_table`, `coffee`, `cover`, `shelf`, `stick_button_move`)
//! are there with the Cargo feature `environments`.

/// A text about the objects of an environment, behind its constants. The files are beside the
/// one that asks for them.
macro_rules! text {
    ($objects:literal) => {
        concat!(include_str!("skills/constants.txt"), include_str!($objects))
    };
}

#[cfg(feature = "environments")]
pub mod blocks;
#[cfg(feature = "environments")]
pub mod cluttered_table;
#[cfg(feature = "environments")]
pub mod coffee;
#[cfg(feature = "environments")]
pub mod cover;
mod float32;
#[cfg(feature = "environments")]
pub mod shelf;
pub mod stick_button;
#[cfg(feature = "environments")]
pub mod stick_button_move;
