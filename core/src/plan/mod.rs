//! Bilevel planning: first which operators, then with which parameters.
//!
//! The upper level searches for *plan skeletons*: sequences of ground operators
//! that reach the goal in the abstract. The lower level *refines* a skeleton: it
//! draws parameters step by step, runs the controllers and steps back where the
//! world does not do what the operators promise; a skeleton that cannot be refined
//! makes the upper level look for another one. This is "search, then sample"
//! (SeSamE; Srivastava et al. 2014; Chitnis et al. 2022), the planner of the
//! Predicators framework, in which the thesis was evaluated (5.1).
//!
//! | part | what it is |
//! |---|---|
//! | [`Search`] | A* over sequences of operators, one skeleton after the other |
//! | [`Heuristic`] | LM-cut, h-max, h-add |
//! | [`Guide`] | advice to the search: keep, postpone or prune a prefix |
//! | [`Refiner`] | backtracking over the steps of a skeleton |
//! | [`World`], [`Sampler`] | what is planned in, and where parameters come from; [`Simulated`] is both for an [`Environment`](crate::task::Environment) |
//! | [`Planner`] | all together; [`GroundTask`] is what it plans, [`Room`] the memory it needs |
//!
//! Learned knowledge enters in two places. A sampler draws from a region instead of
//! everything, and sees the later steps, which may narrow what is good now. A guide
//! sees, before anything is drawn, that a prefix cannot work. Both give a reason,
//! so that there is an answer to "why was no plan found?".
//!
//! Knowledge may be wrong, so it has until [`Config::patience`] ends. Then planning
//! begins anew without it: what can be solved without is solved.
//!
//! There is no clock. Budgets are counts and memory, so the same inputs always end
//! in the same way, on every machine.
//!
//! ```
//! use critreg::env::stick_button::StickButton;
//! use critreg::plan::{Conclusion, Config, GroundTask, Planner, Room, Unguided};
//! use critreg::random::generator;
//!
//! let environment = StickButton { angles: false };
//! let task = environment.task(1..=1, &mut generator(3))?;
//! let ground = GroundTask::<_, 32>::new(&environment, &task)?;
//! let mut planner = Planner {
//!     world: &mut ground.simulated(),
//!     sampler: &mut ground.simulated(),
//!     guide: &mut Unguided,
//!     config: Config::default(),
//! };
//! // 32 ground operators, 256 nodes of the search, plans of up to 8 steps.
//! let mut room = Room::<_, 32, 256, 8>::default();
//! let (lots, samples) = (generator(1), || generator(1));
//! let planned = planner.plan(ground.task(), &task.initial, lots, samples, room.lend())?;
//!
//! assert_eq!(planned.conclusion, Conclusion::Solved);
//! let end = planned.steps.last().map_or(&task.initial, |step| &step.state);
//! assert!(task.is_solved(&environment, end));
//! # Ok::<(), critreg::Error>(())
//! ```

mod config;
mod guide;
mod heuristic;
mod metrics;
mod open;
mod planner;
mod refine;
mod room;
mod search;
mod skeleton;
mod task;
mod visited;
mod why;
mod world;

pub use config::Config;
pub use guide::{Advice, Guide, ReasonId, Unguided};
pub use heuristic::{Cached, Estimate, Estimator, Heuristic, HeuristicMemory, Progress, links};
pub use metrics::{Metrics, Spent};
pub use open::Waiting;
pub use planner::{Conclusion, Memory, Planned, Planner};
pub use refine::{Refinement, Refiner, Step};
pub use room::Room;
pub use search::{Search, SearchMemory, SearchNode};
pub use skeleton::{MAX_SKELETON, Skeleton};
pub use task::{AbstractTask, GroundTask};
pub use why::Why;
pub use world::{Draw, Drawn, Sampler, Simulated, World};
