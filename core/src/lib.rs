//! critreg learns with which parameters a robot's action will work.
//!
//! A task-and-motion planner picks an action (grasp the stick) and then draws its
//! continuous parameters (where along the stick), simulates, fails and draws
//! again. critreg learns the **action-feasibility region** instead: a few readable
//! inequalities, from which the planner then samples. The method is that of a
//! bachelor thesis, "Learning Critical Regions via Feasibility Constraints in Task and
//! Motion Planning" (Aachen, 2025), cited here as "thesis".
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
//! | [`picture`] | pictures of a scene and of what a region admits there, as SVG |
//! | [`region`] | regions: constraints, grounded in an instance, sampled exactly |
//! | [`grammar`] | features and hypotheses made of a domain, formulas and their text |
//! | [`domain`] | what can be said of an action: the domain text, terms, and numbers put into them |
//! | [`geometry`] | frames of reference, shapes, intersection, bodies and the relations between them |
//! | [`real`], [`random`], [`table`], [`text`] | numbers, random numbers, tables in lent memory, reading and writing |
//!
//! Each knows only those below it; no layer knows an environment. Data flow one
//! way: a domain text makes a [`domain::Domain`], that a table of [`grammar::Features`],
//! that the forms of a learner; a [`learn::Learner`] asks about a [`learn::Problem`] and
//! makes a [`region::Region`].
//!
//! # Learning where to grasp a stick
//!
//! ```
//! use critreg::domain::Domain;
//! use critreg::learn::{Capacity, Config, Outcome, Problem, VersionSpace, learn_region};
//! use critreg::random::generator;
//!
//! // Memory for 4096 forms and 256 observations, as arrays.
//! critreg::room!(struct Room: f64, Capacity::new(4096, 256));
//!
//! # fn main() -> Result<(), critreg::Error> {
//! // What the planner knows: the only place where a domain is described.
//! let domain = Domain::parse(
//!     "object stick  { x: length, y: length, theta: angle }
//!      object holder { x: length, y: length, theta: angle }
//!      constant zone.top     = 3.0: length
//!      constant stick.width  = 3.0: length
//!      constant holder.width = 0.3: length
//!      constant robot.radius = 0.1: length
//!      parameter mu in [0, 1]
//!      point grasp         = stick  + (mu * stick.width, 0)      # in the stick's frame
//!      point holder.centre = holder + (0.5 * holder.width, 0)",
//! )?;
//! let instances = [
//!     2.0, 0.7, 1.57, 2.0, 1.0, 1.57, // stick x y theta, holder x y theta
//!     5.0, 1.1, 1.57, 5.0, 2.2, 1.57,
//!     7.5, 1.5, 1.57, 7.5, 1.6, 1.57,
//!     4.0, 0.9, 1.57, 4.0, 0.9, 1.57,
//! ];
//! let problem = Problem::new(&domain, &instances, 4)?;
//!
//! let mut room = Room::new();
//! let mut learner = VersionSpace::new(&domain, Config::default(), Room::CAPACITY, room.lend())?;
//!
//! // Whatever can tell whether the action works: a simulator, a motion planner, a robot.
//! // Here: the robot must stay in its zone.
//! let region = learn_region(&mut learner, &problem, |_, query| {
//!     let instance = problem.instance(query.instance)?;
//!     let y = instance[1] + query.theta[0] * 3.0 * instance[2].sin();
//!     Ok::<_, critreg::Error>(Outcome::from_feasible(y <= 2.9))
//! })?;
//! let text = region.display(&domain).to_string();
//! assert_eq!(text, "grasp.y <= 2.9 (zone.top - robot.radius)");
//!
//! // In a new scene: exact, uniform, or a proof that no parameters are in the region there.
//! let mut rng = generator(7);
//! let new_scene = [3.0, 2.0, 1.57, 3.0, 2.4, 1.57];
//! let [mu, ..] = region.sample::<f64>(&domain, &new_scene, &mut rng)?;
//! assert!(2.0 + 3.0 * mu <= 2.9 + 1e-6);
//! let too_high = [3.0, 2.95, 1.57, 3.0, 2.4, 1.57];
//! let drawn = region.sample::<f64>(&domain, &too_high, &mut rng);
//! assert_eq!(drawn, Err(critreg::Error::EmptyRegion));
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
pub mod picture;
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

/// The program of the README is compiled and run with those of the documentation.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
mod readme {}
