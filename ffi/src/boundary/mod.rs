//! The boundary to C: what comes from a C program is checked here, and what goes back
//! is written here. Nothing in this room knows of learners, regions or planners.
//!
//! | module | content |
//! |---|---|
//! | [`status`] | status codes, and the words for them |
//! | `pointer` | checks of pointers, lengths and texts; places for results |
//! | `handle` | how a handle is told from other memory: its seal |
//! | `structs` | structs of the caller that start with their size |
//! | `text` | text and bytes that go into a buffer of the caller |
//! | [`limits`] | the numbers of the header: how much there is at most |
//! | [`memory`] | the parts of a handle, in the caller's memory |
//! | [`precision`] | what numbers are computed with |
//! | [`rng`] | random numbers by value |
//! | [`version`] | which version of the library this is, and what it was built with |

pub(crate) mod handle;
pub mod limits;
pub mod memory;
pub(crate) mod pointer;
pub mod precision;
pub mod rng;
pub mod status;
pub(crate) mod structs;
pub(crate) mod text;
pub mod version;
