//! Regions: the parameters with which an action is expected to work.
//!
//! | module | content |
//! |---|---|
//! | [`handle`] | a region in the caller's memory |
//! | `layout` | where its parts lie, and those of a domain |
//! | [`making`] | making one from its text or its bytes |
//! | [`writing`] | writing one as text or bytes |
//! | [`constraint`] | its constraints, one by one |
//! | [`sampling`] | what it says about an instance: membership, intervals, samples |

pub mod constraint;
pub mod handle;
pub(crate) mod layout;
pub mod making;
pub mod sampling;
pub mod writing;
