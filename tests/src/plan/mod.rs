//! Planning in environments, for host programs.

pub mod ideal;
pub mod lower_half;
pub mod record;
pub mod skills;

use critreg::Error;
use critreg::plan::{
    AbstractTask, Cached, Config, Guide, HeuristicMemory, Memory, Planned, Planner, Progress,
    Sampler, SearchMemory, SearchNode, Simulated, Step, Waiting,
};
use critreg::task::{AtomSet, Atoms, Environment, GroundOperator, State, Task, ground_operators};
use rand_core::Rng;

/// Most ground operators: those of ten buttons.
pub const MAX_OPERATORS: usize = 256;
/// Most operators of an environment.
const LIFTED: usize = 16;
/// Links between atoms and operators: at most four preconditions and effects each.
const LINKS: usize = 4 * MAX_OPERATORS;
/// Abstract states whose estimate is remembered.
const CACHE: usize = 256;

/// The memory of a planner on the heap of the host.
pub struct Room {
    progress: Vec<Progress>,
    links: Vec<u16>,
    cache: Vec<Cached>,
    nodes: Vec<SearchNode>,
    open: Vec<Waiting>,
    steps: Vec<Step<State>>,
    failures: Vec<u32>,
    reasons: Vec<u32>,
}

impl Room {
    /// Memory for so many nodes, and for skeletons of up to 32 operators.
    pub fn new(nodes: usize) -> Room {
        Room {
            progress: vec![Progress::default(); MAX_OPERATORS],
            links: vec![0; LINKS],
            cache: vec![Cached::default(); CACHE],
            nodes: vec![SearchNode::default(); nodes],
            open: vec![Waiting::default(); nodes],
            steps: vec![Step::default(); 32],
            failures: vec![0; LIFTED],
            reasons: vec![0; MAX_OPERATORS],
        }
    }

    /// Lends all of it.
    pub fn lend(&mut self) -> Memory<'_, State> {
        Memory {
            search: SearchMemory {
                heuristic: HeuristicMemory {
                    operators: &mut self.progress,
                    links: &mut self.links,
                    cache: &mut self.cache,
                },
                nodes: &mut self.nodes,
                open: &mut self.open,
            },
            steps: &mut self.steps,
            failures: &mut self.failures,
            reasons: &mut self.reasons,
        }
    }
}

/// A task with all that a planner needs to know of it in the abstract.
pub struct Grounding<'e, E> {
    environment: &'e E,
    /// The atoms over its objects.
    pub atoms: Atoms,
    /// The ground operators.
    pub operators: heapless::Vec<GroundOperator, MAX_OPERATORS>,
    initial: AtomSet,
    goal: AtomSet,
}

impl<'e, E: Environment> Grounding<'e, E> {
    /// Of a task of an environment.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] with too many objects.
    pub fn new(environment: &'e E, task: &Task) -> Result<Self, Error> {
        let atoms = Atoms::new::<E>(&task.initial)?;
        let mut operators = heapless::Vec::new();
        ground_operators(E::OPERATORS, &task.initial, &atoms, &mut operators)?;
        Ok(Grounding {
            environment,
            operators,
            initial: atoms.abstract_state(environment, &task.initial),
            goal: atoms.set(task.goal.iter().copied())?,
            atoms,
        })
    }

    /// The task in the abstract.
    pub fn task(&self) -> AbstractTask<'_> {
        AbstractTask {
            operators: &self.operators,
            initial: self.initial,
            goal: self.goal,
        }
    }

    /// Plans from the initial state. Lots, and the samples of each skeleton, are the
    /// numbers that `numbers` begins.
    ///
    /// # Errors
    /// Those of [`Planner::plan`].
    pub fn plan<'m, R: Rng + Clone>(
        &'m self,
        initial: &State,
        (mut sampler, mut guide): (impl Sampler<Simulated<'m, E>>, impl Guide),
        numbers: impl Fn() -> R,
        room: &'m mut Room,
    ) -> Result<Planned<'m, State>, Error> {
        let mut planner = Planner {
            world: &mut self.simulated(),
            sampler: &mut sampler,
            guide: &mut guide,
            config: Config::default(),
        };
        planner.plan(self.task(), initial, numbers(), &numbers, room.lend())
    }

    /// The environment.
    pub fn environment(&self) -> &'e E {
        self.environment
    }

    /// The environment with the task's atoms: world and original sampler.
    pub fn simulated(&self) -> Simulated<'_, E> {
        Simulated {
            environment: self.environment,
            atoms: &self.atoms,
        }
    }
}
