//! Regions: the parameters with which an action is expected to work.
//!
//! | module | content |
//! |---|---|
//! | [`handle`] | a region in the caller's memory |
//! | `layout` | where its parts lie, and those of a domain |
//! | [`making`] | making one from its text or its bytes |
//! | [`check`] | what is wrong with a domain or region text, in words |
//! | [`quality`] | how good it is |
//! | [`writing`] | writing one as text or bytes |
//! | [`constraint`] | its constraints, one by one |
//! | [`sampling`] | what it says about an instance: membership, intervals, samples |
//! | [`many`] | membership of many samples, and many draws |
//! | [`margins`] | its constraints as functions with gradients |
//! | [`implies`] | whether it satisfies a specification, in all instances |
//! | [`export`] | the region as C or Rust that needs no library |
//! | [`picture`] | the region as a picture of an instance |

pub mod check;
pub mod constraint;
pub mod export;
pub mod handle;
pub mod implies;
pub(crate) mod layout;
pub mod making;
pub mod many;
pub mod margins;
pub mod picture;
pub mod quality;
pub mod sampling;
pub mod writing;
