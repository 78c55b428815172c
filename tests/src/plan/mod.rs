//! Planning in environments, for host programs.

pub mod ideal;
pub mod lower_half;
pub mod record;
pub mod skills;
pub mod symbols;

use critreg::Error;
use critreg::plan::{
    self, Config, GroundTask, Guide, Memory, Planned, Planner, Sampler, SearchNode, Simulated,
    Waiting,
};
use critreg::task::{Environment, State};
use rand_core::Rng;

/// Most ground operators: those of ten buttons.
pub const MAX_OPERATORS: usize = 256;
/// Most operators in a plan skeleton.
const LENGTH: usize = 32;

/// A task of an environment, ground.
pub type Grounding<'e, E> = GroundTask<'e, E, MAX_OPERATORS>;

/// The memory of a planner on the heap of the host, for any number of nodes.
pub struct Room {
    /// All but what there is of each node.
    tables: Box<plan::Room<State, MAX_OPERATORS, 0, LENGTH>>,
    nodes: Vec<SearchNode>,
    open: Vec<Waiting>,
    visited: Vec<u32>,
}

impl Room {
    /// Memory for so many nodes.
    pub fn new(nodes: usize) -> Room {
        Room {
            tables: Box::default(),
            nodes: vec![SearchNode::default(); nodes],
            open: vec![Waiting::default(); nodes],
            visited: vec![0; nodes],
        }
    }

    /// Lends all of it.
    pub fn lend(&mut self) -> Memory<'_, State> {
        let mut memory = self.tables.lend();
        memory.search.nodes = &mut self.nodes;
        memory.search.open = &mut self.open;
        memory.search.visited = &mut self.visited;
        memory
    }
}

/// Plans a task from its initial state, as the framework does. Lots, and the samples of each
/// skeleton, are the numbers that `numbers` begins.
///
/// # Errors
/// Those of [`Planner::plan`].
pub fn plan<'m, E: Environment, R: Rng + Clone>(
    grounding: &'m Grounding<'_, E>,
    initial: &State,
    advice: (impl Sampler<Simulated<'m, E>>, impl Guide),
    numbers: impl Fn() -> R,
    room: &'m mut Room,
) -> Result<Planned<'m, State>, Error> {
    plan_as(Config::default(), grounding, initial, advice, numbers, room)
}

/// As [`plan()`], with a configuration.
///
/// # Errors
/// Those of [`Planner::plan`].
pub fn plan_as<'m, E: Environment, R: Rng + Clone>(
    config: Config,
    grounding: &'m Grounding<'_, E>,
    initial: &State,
    (mut sampler, mut guide): (impl Sampler<Simulated<'m, E>>, impl Guide),
    numbers: impl Fn() -> R,
    room: &'m mut Room,
) -> Result<Planned<'m, State>, Error> {
    let mut planner = Planner {
        world: &mut grounding.simulated(),
        sampler: &mut sampler,
        guide: &mut guide,
        config,
    };
    planner.plan(grounding.task(), initial, numbers(), &numbers, room.lend())
}
