//! What the tests, benchmarks and reports of critreg share.
pub mod actions;
pub mod arm;
pub mod by_hand;
pub mod data;
pub mod golden;
pub mod lottery;
pub mod pick;
pub mod picture;
pub mod plan;
pub mod report;
pub mod room;
pub mod text;
pub mod trying;
