//! The feature grammar (thesis 4.2): what can be said about a sample.
//!
//! [`Features`] enumerates the features of a domain from simple to complex;
//! [`Hypotheses`] compares them in pairs, one bit per hypothesis, and prunes by
//! samples. A [`Formula`] is a statement made of constraints with `and`, `or` and
//! `not`; it has a text form and is what regions are made of.

mod block;
mod body_leaves;
mod derived;
mod features;
mod formula;
mod hypotheses;
mod kind;
mod laws;
mod leaves;

pub(crate) use features::feature_id;
pub use features::{FACTORS, Features, MAX_COMPLEXITY};
pub use formula::{
    Comparison, Conjunct, Constraint, Formula, Inequality, MAX_CONSTRAINTS, MAX_FORMULA_NODES,
    MAX_FORMULA_STEPS, Step, Truth,
};
pub use hypotheses::{Enumeration, Hypotheses, MAX_PAIR_COMPLEXITY};
pub(crate) use hypotheses::{Run, bit};
pub(crate) use kind::Kind;
