//! critreg learns with which parameters a robot's action will work.
//!
//! A task-and-motion planner picks an action (grasp the stick) and then draws its
//! continuous parameters (where along the stick), simulates, fails and draws
//! again. critreg learns the **action-feasibility region** instead: a few readable
//! inequalities, from which the planner then samples. The method is that of a
//! bachelor thesis (Aachen 2025), cited here as "thesis".
//!
//! The crate needs no operating system and no heap, has no unsafe code, and does
//! not panic: what cannot be done comes back as an [`Error`].
//!
//! # The layers, from the top
//!
//! | module | what it knows |
//! |---|---|
//! | [`mod@env`] | built-in environments: a simulator, its predicates, controllers, operators, tasks; all but `stick_button` with the feature `environments` |
//! | [`skill`] | regions in the planner: roles, learning from training tasks, sampler and guide |
//! | [`plan`] | a bilevel planner: sequences of operators first, then their parameters |
//! | [`pddl`] | operators and problems as text, grounded |
//! | [`mod@task`] | states, predicates, operators, controllers, environments, tasks |
//! | [`learn`] | learners: they ask for samples, are told what came of them, and end with a region |
//! | [`region`] | regions: constraints, grounded in an instance, sampled exactly |
//! | [`grammar`] | features and hypotheses made of a domain, formulas and their text |
//! | [`domain`] | what can be said of an action: the domain text, terms, and numbers put into them |
//! | [`geometry`] | frames of reference, shapes, intersection |
//! | [`real`], [`random`], [`table`], [`text`] | numbers, random numbers, tables in lent memory, reading and writing |
//!
//! Each knows only those below it; no layer knows an environment. Data flow one
//! way: a domain text makes a [`domain::Domain`], that a [`grammar::Features`]
//! table, that a [`grammar::Hypotheses`] table; a [`learn::Learner`] asks about a
//! [`learn::Problem`] and makes a [`region::Region`].
//!
//! # Learning to pick a stick
//!
//! ```
//! use critreg::domain::{Domain, Node};
//! use critreg::env::stick_button::StickButton;
//! use critreg::learn::{Algorithm1, Bounds, Capacity, Config, Memory, Observation, Problem};
//! use critreg::random::generator;
//!
//! # fn main() -> Result<(), critreg::Error> {
//! let environment = StickButton { angles: false };
//! let domain = Domain::parse(StickButton::PICK_DOMAIN)?;
//! let task = environment.task(1..=1, &mut generator(3))?;
//! let problem = Problem::new(&domain, task.initial.values(), 1)?;
//!
//! const ROOM: Capacity = Capacity { hypotheses: 4096, observations: 64 };
//! let mut features = [Node::Number(0.0); ROOM.features()];
//! let mut values = [0.0_f64; ROOM.features()];
//! let mut pairs = [0; ROOM.pairs()];
//! let mut bounds = [Bounds::default(); ROOM.lefts()];
//! let mut observations = [Observation::default(); ROOM.observations];
//! let memory = Memory {
//!     features: &mut features,
//!     values: &mut values,
//!     pairs: &mut pairs,
//!     bounds: &mut bounds,
//!     observations: &mut observations,
//! };
//! let config = Config {
//!     iterations: 40,
//!     negative: Some([0.95, 0.0, 0.0, 0.0, 0.0, 0.0]),
//!     positive: Some([0.5, 0.0, 0.0, 0.0, 0.0, 0.0]),
//!     ..Config::default()
//! };
//! let mut learner = Algorithm1::new(&domain, config, ROOM, memory)?;
//! let learned = critreg::learn::learn_region(&mut learner, &problem, |_, query| {
//!     environment.try_pick(problem.instance(query.instance)?, &query.theta)
//! });
//! // The thesis's learner often ends with nothing; that is an answer, too.
//! assert!(learned.is_ok() || learned == Err(critreg::Error::NoRegion));
//! # Ok(())
//! # }
//! ```
#![no_std]
#![forbid(unsafe_code)]

#[cfg(test)]
extern crate std;

pub mod domain;
pub mod env;
mod error;
pub mod geometry;
pub mod grammar;
pub mod learn;
pub mod pddl;
pub mod plan;
pub mod random;
pub mod real;
pub mod region;
pub mod skill;
pub mod table;
pub mod task;
pub mod text;
mod wire;

pub use error::{Error, SyntaxError};
