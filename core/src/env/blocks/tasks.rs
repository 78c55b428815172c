//! Random tasks: build these piles.

use super::world::{Block, World, is_free};
use super::{BLOCK_SIZE, BLOCK_TYPE, Blocks, ON, ON_TABLE, REACH_X, REACH_Y, TABLE_HEIGHT};
use crate::error::Error;
use crate::random::{below, uniform, uniform_in};
use crate::task::{Arguments, GroundAtom, State, Task};
use core::ops::RangeInclusive;
use heapless::Vec;
use rand_core::Rng;

/// Most blocks in a generated task: as many as a state has room for.
pub const MAX_BLOCKS: usize = 8;

/// How likely a block is to begin a pile.
const NEW_PILE: f64 = 0.2;

/// The robot in every task. It is single precision in the framework.
const ROBOT: [f64; 4] = [1.35_f32 as f64, 0.75_f32 as f64, 0.7_f32 as f64, 1.0];

/// How often something is drawn again before the generator gives up.
const MAX_DRAWS: usize = 10_000;

const NO_ROOM: Error =
    Error::InvalidArgument("found no free place for all piles: draw again, or fewer blocks");

/// For each block in the order of names whether it is the lowest of a pile. If not,
/// it lies on the one before.
type Piles = Vec<bool, MAX_BLOCKS>;

impl Blocks {
    /// A random task with a number of blocks drawn from `blocks`: three or four for
    /// training in the framework, five or six for its tests.
    ///
    /// Each block but the first begins a pile of its own with a probability of one
    /// fifth, and lies on the one before otherwise. Piles stand anywhere within reach and
    /// as far apart as blocks are put. The goal is to have other piles, drawn in the
    /// same way.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] if `blocks` is empty or not within two and
    /// [`MAX_BLOCKS`] (one block has no other piles), or if a pile finds no room in 10 000
    /// draws, as can happen with five piles and more: another task then may.
    pub fn task<G: Rng>(&self, blocks: RangeInclusive<usize>, rng: &mut G) -> Result<Task, Error> {
        let (least, most) = blocks.into_inner();
        if least < 2 || most < least || most > MAX_BLOCKS {
            return Err(Error::InvalidArgument(
                "ask for at least two and at most eight blocks",
            ));
        }
        let count = least + below(rng, most - least + 1);
        let piles = draw_piles(count, rng)?;
        let initial = place(&piles, rng)?;
        for _ in 0..MAX_DRAWS {
            let others = draw_piles(count, rng)?;
            if others != piles {
                return Ok(Task {
                    goal: goal(&others, &initial)?,
                    initial,
                });
            }
        }
        Err(NO_ROOM)
    }
}

fn draw_piles<G: Rng>(count: usize, rng: &mut G) -> Result<Piles, Error> {
    let mut piles = Piles::new();
    for block in 0..count {
        let is_lowest = block == 0 || uniform(rng) < NEW_PILE;
        piles.push(is_lowest).map_err(|_| NO_ROOM)?;
    }
    Ok(piles)
}

/// A state with these piles, at random places and of random colours.
fn place<G: Rng>(piles: &Piles, rng: &mut G) -> Result<State, Error> {
    let mut places: Vec<[f64; 2], MAX_BLOCKS> = Vec::new();
    let mut blocks: Vec<Block, MAX_BLOCKS> = Vec::new();
    let mut level = 0.0;
    for is_lowest in piles {
        if *is_lowest {
            let place = free_place(&places, rng)?;
            places.push(place).map_err(|_| NO_ROOM)?;
            level = 0.0;
        } else {
            level += 1.0;
        }
        let [x, y] = *places.last().ok_or(NO_ROOM)?;
        let z = TABLE_HEIGHT + BLOCK_SIZE * (0.5 + level);
        let [red, green, blue] = core::array::from_fn(|_| uniform(rng));
        let block = [x, y, z, 0.0, red, green, blue];
        blocks.push(block).map_err(|_| NO_ROOM)?;
    }
    World {
        blocks: &blocks,
        robot: &ROBOT,
    }
    .to_state()
}

/// A place for a pile, apart from the others.
fn free_place<G: Rng>(others: &[[f64; 2]], rng: &mut G) -> Result<[f64; 2], Error> {
    for _ in 0..MAX_DRAWS {
        let place = [REACH_X, REACH_Y].map(|[low, high]| uniform_in(rng, low, high));
        if is_free(place, others.iter().copied()) {
            return Ok(place);
        }
    }
    Err(NO_ROOM)
}

/// The atoms of these piles of the state's blocks.
fn goal(
    piles: &Piles,
    initial: &State,
) -> Result<Vec<GroundAtom, { crate::task::MAX_GOAL_ATOMS }>, Error> {
    let mut goal = Vec::new();
    let mut before = None;
    for (block, is_lowest) in initial.of_type(BLOCK_TYPE).zip(piles) {
        let (predicate, lower) = if *is_lowest {
            (ON_TABLE, None)
        } else {
            (ON, before)
        };
        let objects = Arguments::new([Some(block), lower].into_iter().flatten())?;
        goal.push(GroundAtom { predicate, objects })
            .map_err(|_| Error::CapacityExceeded("atoms of a goal"))?;
        before = Some(block);
    }
    Ok(goal)
}
