//! The built-in stick-button environment.
//!
//! | module | content |
//! |---|---|
//! | [`environment`] | tasks, and picking the stick: to learn in |
//! | [`world`] | operators and atoms: to plan in |

pub mod environment;
pub mod world;
