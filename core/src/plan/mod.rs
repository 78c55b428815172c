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
//! | [`Planner`] | all together |
//! | [`crate::skill`] | learned regions as a sampler and a guide |
//!
//! Learned knowledge enters in two places. A sampler draws from a region instead of
//! everything, and sees the later steps, which may narrow what is good now. A guide
//! sees, before anything is drawn, that a prefix cannot work. Both give a reason,
//! so that there is an answer to "why was no plan found?". [`crate::skill`] is both, for what
//! was learned of an environment.
//!
//! Knowledge may be wrong, so it has until [`Config::patience`] ends. Then planning
//! begins anew without it: what can be solved without is solved.
//!
//! There is no clock. Budgets are counts and memory, so the same inputs always end
//! in the same way, on every machine.
//!
//! ```
//! # use critreg::plan::{Cached, HeuristicMemory, SearchNode, Progress, SearchMemory, Step, Waiting};
//! use critreg::task::{Atoms, Environment, GroundOperator, ground_operators};
//! use critreg::env::stick_button::StickButton;
//! use critreg::plan::{AbstractTask, Config, Memory, Conclusion, Planner, Simulated, Unguided};
//! use critreg::random::generator;
//!
//! let environment = StickButton { angles: false };
//! let task = environment.task(1..=1, &mut generator(3))?;
//! let atoms = Atoms::new::<StickButton>(&task.initial)?;
//! let mut operators: heapless::Vec<GroundOperator, 32> = heapless::Vec::new();
//! ground_operators(StickButton::OPERATORS, &task.initial, &atoms, &mut operators)?;
//! let goal = AbstractTask {
//!     operators: &operators,
//!     initial: atoms.abstract_state(&environment, &task.initial),
//!     goal: atoms.set(task.goal.iter().copied())?,
//! };
//!
//! let simulated = Simulated { environment: &environment, atoms: &atoms };
//! let (mut world, mut sampler, mut guide) = (simulated, simulated, Unguided);
//! let mut planner = Planner {
//!     world: &mut world,
//!     sampler: &mut sampler,
//!     guide: &mut guide,
//!     config: Config::default(),
//! };
//! # let (mut progress, mut links) = ([Progress::default(); 32], [0; 256]);
//! # let (mut cache, mut nodes) = ([Cached::default(); 64], [SearchNode::default(); 256]);
//! # let mut open = [Waiting::default(); 256];
//! # let mut steps: [Step<_>; 8] = core::array::from_fn(|_| Step::default());
//! # let (mut failures, mut reasons) = ([0; 8], []);
//! # let memory = Memory {
//! #     search: SearchMemory {
//! #         heuristic: HeuristicMemory { operators: &mut progress, links: &mut links, cache: &mut cache },
//! #         nodes: &mut nodes,
//! #         open: &mut open,
//! #     },
//! #     steps: &mut steps,
//! #     failures: &mut failures,
//! #     reasons: &mut reasons,
//! # };
//! let planned = planner.plan(goal, &task.initial, generator(1), || generator(1), memory)?;
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
mod search;
mod skeleton;
mod world;

pub use config::Config;
pub use guide::{Advice, Guide, ReasonId, Unguided};
pub use heuristic::{Cached, Estimate, Estimator, Heuristic, HeuristicMemory, Progress, links};
pub use metrics::{Metrics, Spent};
pub use open::Waiting;
pub use planner::{Conclusion, Memory, Planned, Planner};
pub use refine::{Refinement, Refiner, Step};
pub use search::{Search, SearchMemory, SearchNode};
pub use skeleton::{MAX_SKELETON, Skeleton};
pub use world::{Draw, Drawn, Sampler, Simulated, World};

use crate::task::{AtomSet, GroundOperator};

/// A task in the abstract (a STRIPS problem). Where its ground operators come from
/// does not matter.
#[derive(Clone, Copy, Debug)]
pub struct AbstractTask<'t> {
    /// All ground operators, in the order in which they are tried.
    pub operators: &'t [GroundOperator],
    /// What holds in the beginning.
    pub initial: AtomSet,
    /// What shall hold in the end.
    pub goal: AtomSet,
}
