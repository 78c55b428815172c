//! Action-feasibility regions: which parameters of an action work in an instance.
//!
//! A [`Region`] is lifted: its constraints speak of objects and points, not of
//! numbers. [`Region::ground`] puts an instance in; the [`Grounded`] region is a
//! set of parameters. Along a line of parameters it is a set of intervals in closed form,
//! because there every side of a constraint is piecewise linear or the root of a
//! quadratic function. With one parameter this line is everything. Sampling is uniform,
//! see [`Grounded::sample`]. An [`Intersection`] is what several regions admit at once.
//! [`Region::implies`] is about all instances at once: a proof, or a counterexample.

mod boxes;
mod bytes;
mod choices;
mod export;
mod ground;
mod halving;
mod implication;
mod intersection;
mod interval;
mod lifted;
mod many;
mod margins;
mod obligations;
mod parameters;
mod program;
mod sample;
mod slice;

pub use bytes::SavedRegion;
pub use ground::Grounded;
pub use implication::{Implication, Limit, ProofConfig, Verdict};
pub use intersection::{Intersection, Part};
pub use interval::{Interval, IntervalSet, MAX_INTERVALS};
pub use lifted::Region;
pub use parameters::Theta;
