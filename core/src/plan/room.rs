//! The memory of a planner as one value.

use super::heuristic::{Cached, HeuristicMemory, Progress};
use super::open::Waiting;
use super::planner::Memory;
use super::refine::Step;
use super::search::{SearchMemory, SearchNode};

/// Links between atoms and an operator: its preconditions and add effects, as many as it
/// has on the average at most.
const LINKS: usize = 8;

/// The tables of a planner, for up to `OPERATORS` ground operators, `NODES` nodes of the
/// search and plans of up to `STEPS` operators, in a world with states `S`.
///
/// [`Room::lend`] makes them a [`Memory`]. Where sizes are known at run time only, that is
/// made of slices instead.
#[derive(Clone, Debug)]
pub struct Room<S, const OPERATORS: usize, const NODES: usize, const STEPS: usize> {
    progress: [Progress; OPERATORS],
    links: [[u16; LINKS]; OPERATORS],
    cache: [Cached; OPERATORS],
    nodes: [SearchNode; NODES],
    open: [Waiting; NODES],
    visited: [u32; NODES],
    steps: [Step<S>; STEPS],
    failures: [u32; OPERATORS],
    reasons: [u32; OPERATORS],
}

impl<S: Default, const OPERATORS: usize, const NODES: usize, const STEPS: usize> Default
    for Room<S, OPERATORS, NODES, STEPS>
{
    fn default() -> Self {
        Room {
            progress: [Progress::default(); OPERATORS],
            links: [[0; LINKS]; OPERATORS],
            cache: [Cached::default(); OPERATORS],
            nodes: [SearchNode::default(); NODES],
            open: [Waiting::default(); NODES],
            visited: [0; NODES],
            steps: core::array::from_fn(|_| Step::default()),
            failures: [0; OPERATORS],
            reasons: [0; OPERATORS],
        }
    }
}

impl<S, const OPERATORS: usize, const NODES: usize, const STEPS: usize>
    Room<S, OPERATORS, NODES, STEPS>
{
    /// Lends all of it. It can be lent again once planning is over.
    pub fn lend(&mut self) -> Memory<'_, S> {
        Memory {
            search: SearchMemory {
                heuristic: HeuristicMemory {
                    operators: &mut self.progress,
                    links: self.links.as_flattened_mut(),
                    cache: &mut self.cache,
                },
                nodes: &mut self.nodes,
                open: &mut self.open,
                visited: &mut self.visited,
            },
            steps: &mut self.steps,
            failures: &mut self.failures,
            reasons: &mut self.reasons,
        }
    }
}
