//! Learners.
//!
//! | module | content |
//! |---|---|
//! | [`config`] | what a learner is told to do |
//! | [`check`] | what is wrong with that, in words |
//! | `any` | what all learners of the core have in common for C |
//! | [`handle`] | a learner in the caller's memory |
//! | `layout`, `tables` | where its parts lie |
//! | [`making`] | making one |
//! | [`choosing`] | choosing instances of a source |
//! | [`outcome`] | what came of a trial, as C says it |
//! | [`learning`] | asking and telling |
//! | [`challenge`] | what is learned, held against what is specified |
//! | [`questions`] | several questions at once |
//! | [`inspection`] | what is asked about one: whether it is finished, what it learned |
//! | [`quality`] | how good a region is, and why there is none |
//! | [`report`] | how learning went |
//! | [`picture`] | what is learned and what was told, as a picture |
//! | [`saving`] | saving a run and resuming it |

pub(crate) mod any;
pub mod challenge;
pub mod check;
pub mod choosing;
pub mod config;
pub mod handle;
pub mod inspection;
pub(crate) mod layout;
pub mod learning;
pub mod making;
pub mod outcome;
pub mod picture;
pub mod quality;
pub mod questions;
pub mod report;
pub mod saving;
pub(crate) mod tables;
