//! Random tasks: cover a target with its block.

use super::{
    BLOCK_TYPE, BLOCK_WIDTHS, BLOCKS, BUMPY_REGION, Cover, CoverRegrasp, Family, NOT_HELD,
    ROBOT_TYPE, RegionalBumpyCover, TARGET_TYPE, TARGET_WIDTHS, TARGETS,
};
use crate::error::Error;
use crate::random::{below, uniform, uniform_in};
use crate::real::Real;
use crate::task::{Arguments, GroundAtom, MAX_GOAL_ATOMS, ObjectId, State, Task};
use heapless::Vec;
use rand_core::Rng;

/// Where the empty hand is in the beginning.
const HAND: f64 = 0.5;
/// The robot's other numbers.
const ROBOT_POSE: [f64; 2] = [1.35, 0.65];
/// In how many tasks a block is held in the beginning.
const HELD: f64 = 0.75;
/// Where, in parts of half its width: in [`Cover`].
const CENTRE: [f64; 1] = [0.0];
/// The same in [`CoverRegrasp`].
const CENTRE_AND_ENDS: [f64; 3] = [-0.95, 0.0, 0.95];
/// In how many tasks the bumpy block is put into the bumpy region, if there is room.
const BUMPY: f64 = 0.25;

/// How far blocks keep from all before them, in parts of the sum of both widths: they
/// do not meet.
const APART: f64 = 0.5;
/// How far targets keep from all before them.
const FAR_APART: f64 = 1.5;

/// How often an object is drawn again before the generator gives up; most draws are
/// free.
const MAX_DRAWS: usize = 10_000;

impl Cover {
    /// A random task, the one at this place of a series: its goal is
    /// `Covers(block0, target0)`, `Covers(block1, target1)` or both, in turns.
    ///
    /// Blocks do not meet, and targets lie far from blocks and from one another. In
    /// three of four tasks one of the blocks is held, at its centre.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] if an object finds no room in 10 000 draws.
    pub fn task<G: Rng>(&self, index: usize, rng: &mut G) -> Result<Task, Error> {
        perhaps_holding::<Self, G>(index, &CENTRE, rng)
    }
}

impl CoverRegrasp {
    /// A random task, the one at this place of a series, as [`Cover::task`]; but a block
    /// that is held is held at its centre, near its left or near its right end.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] if an object finds no room in 10 000 draws.
    pub fn task<G: Rng>(&self, index: usize, rng: &mut G) -> Result<Task, Error> {
        perhaps_holding::<Self, G>(index, &CENTRE_AND_ENDS, rng)
    }
}

impl RegionalBumpyCover {
    /// A random task, the one at this place of a series, with the goals of
    /// [`Cover::task`].
    ///
    /// No block is held. Targets lie outside of the bumpy region and far from one
    /// another, blocks anywhere apart from the others, so that a block may lie right
    /// beside a target. The bumpy block is in the bumpy region in one of four tasks,
    /// the other one never.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] if an object finds no room in 10 000 draws.
    pub fn task<G: Rng>(&self, index: usize, rng: &mut G) -> Result<Task, Error> {
        let mut line = Line::default();
        let mut targets = [0.0; 2];
        for (target, width) in targets.iter_mut().zip(TARGET_WIDTHS) {
            let all = [0.0, BUMPY_REGION - width / 2.0];
            *target = line.draw(width, FAR_APART, all, rng)?;
        }
        let mut blocks = [[0.0; 6]; 2];
        for ((block, width), bumpy) in blocks.iter_mut().zip(BLOCK_WIDTHS).zip([1.0, 0.0]) {
            // One draw only: a block that finds the region occupied stays outside.
            let is_inside = bumpy > 0.0 && uniform(rng) < BUMPY;
            let inside = is_inside.then(|| uniform_in(rng, BUMPY_REGION, 1.0 - width / 2.0));
            let pose = match inside.filter(|pose| line.is_free(width, APART, *pose)) {
                Some(pose) => line.put(width, pose)?,
                None => line.draw(width, APART, [0.0, BUMPY_REGION], rng)?,
            };
            *block = [1.0, 0.0, width, pose, NOT_HELD, bumpy];
        }
        Ok(Task {
            initial: to_state::<Self, 6>(&blocks, HAND, targets)?,
            goal: goal::<Self>(index)?,
        })
    }
}

/// A task in which a block may be held, at one of these places.
fn perhaps_holding<E: Family, G: Rng>(
    index: usize,
    grasps: &[f64],
    rng: &mut G,
) -> Result<Task, Error> {
    let mut line = Line::default();
    let mut blocks = [[0.0; 5]; 2];
    for (block, width) in blocks.iter_mut().zip(BLOCK_WIDTHS) {
        let pose = line.draw(width, APART, [0.0, 1.0], rng)?;
        *block = [1.0, 0.0, width, pose, NOT_HELD];
    }
    let mut targets = [0.0; 2];
    for (target, width) in targets.iter_mut().zip(TARGET_WIDTHS) {
        *target = line.draw(width, FAR_APART, [0.0, 1.0], rng)?;
    }
    let mut hand = HAND;
    if uniform(rng) < HELD {
        let held = blocks.get_mut(below(rng, BLOCKS.len()));
        let offset = grasps.get(below(rng, grasps.len()));
        if let (Some([_, _, width, pose, grasp]), Some(offset)) = (held, offset) {
            *grasp = offset * *width / 2.0;
            hand = *pose + *grasp;
        }
    }
    Ok(Task {
        initial: to_state::<E, 5>(&blocks, hand, targets)?,
        goal: goal::<E>(index)?,
    })
}

/// What lies on the line so far: the width and pose of each object.
#[derive(Default)]
struct Line {
    objects: Vec<[f64; 2], { BLOCKS.len() + TARGETS.len() }>,
}

impl Line {
    /// Puts an object anywhere in a part of the line where it is free; its pose.
    fn draw<G: Rng>(
        &mut self,
        width: f64,
        apart: f64,
        [low, high]: [f64; 2],
        rng: &mut G,
    ) -> Result<f64, Error> {
        for _ in 0..MAX_DRAWS {
            let pose = uniform_in(rng, low + width / 2.0, high - width / 2.0);
            if self.is_free(width, apart, pose) {
                return self.put(width, pose);
            }
        }
        Err(Error::InvalidArgument(
            "found no free place for all objects: draw another task",
        ))
    }

    /// Whether an object of this width would keep its distance.
    fn is_free(&self, width: f64, apart: f64, pose: f64) -> bool {
        let keeps = |[other_width, other]: &[f64; 2]| {
            Real::abs(pose - *other) > (width + *other_width) * apart
        };
        self.objects.iter().all(keeps)
    }

    fn put(&mut self, width: f64, pose: f64) -> Result<f64, Error> {
        let full = |_| Error::CapacityExceeded("objects of a task");
        self.objects.push([width, pose]).map_err(full)?;
        Ok(pose)
    }
}

fn to_state<E: Family, const N: usize>(
    blocks: &[[f64; N]; 2],
    hand: f64,
    targets: [f64; 2],
) -> Result<State, Error> {
    let types = E::TYPES;
    let mut state = State::new();
    for block in blocks {
        state.add(types, BLOCK_TYPE, block)?;
    }
    let [x, z] = ROBOT_POSE;
    state.add(types, ROBOT_TYPE, &[hand, x, z])?;
    for (width, pose) in TARGET_WIDTHS.into_iter().zip(targets) {
        state.add(types, TARGET_TYPE, &[0.0, 1.0, width, pose])?;
    }
    Ok(state)
}

/// The goal of the task at this place of a series.
fn goal<E: Family>(index: usize) -> Result<Vec<GroundAtom, MAX_GOAL_ATOMS>, Error> {
    let ([block0, block1], [target0, target1]) = (BLOCKS, TARGETS);
    let pairs: &[[ObjectId; 2]] = match index % 3 {
        0 => &[[block0, target0]],
        1 => &[[block1, target1]],
        _ => &[[block0, target0], [block1, target1]],
    };
    let mut goal = Vec::new();
    for pair in pairs {
        let atom = GroundAtom {
            predicate: E::COVERS,
            objects: Arguments::new(*pair)?,
        };
        goal.push(atom)
            .map_err(|_| Error::CapacityExceeded("atoms of a goal"))?;
    }
    Ok(goal)
}
