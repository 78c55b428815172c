//! Random tasks: hold the first can.

use super::{
    CAN_RADIUS, CAN_TYPE, Can, ClutteredTable, ClutteredTablePlace, FIRST_CAN, HOLDING, TYPES,
};
use crate::error::Error;
use crate::geometry::distance;
use crate::random::{uniform, uniform_in};
use crate::task::{Arguments, GroundAtom, State, Task};
use heapless::Vec;
use rand_core::Rng;

/// Most cans in a generated task; with more, the order of the objects would no
/// longer be that of their names.
pub const MAX_CANS: usize = 10;

/// The part of the table, along x and along y, in which cans stand at random.
const CLUTTER: [f64; 2] = [0.25, 0.75];

/// How often a can is drawn again before the generator gives up. Hardly any draw
/// is not free.
const MAX_DRAWS: usize = 10_000;

const NO_ROOM: Error =
    Error::InvalidArgument("found no free place for all cans: ask for fewer of them");

impl ClutteredTable {
    /// A random task with this many cans: five for training in the framework, ten
    /// for its tests.
    ///
    /// The cans stand anywhere in the middle of the table and do not touch.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] if `cans` is not within one and [`MAX_CANS`], or if
    /// a can finds no room in 10 000 draws.
    pub fn task<G: Rng>(&self, cans: usize, rng: &mut G) -> Result<Task, Error> {
        if !(1..=MAX_CANS).contains(&cans) {
            return Err(Error::InvalidArgument(
                "ask for at least one and at most ten cans",
            ));
        }
        let mut centres: Vec<[f64; 2], MAX_CANS> = Vec::new();
        for _ in 0..cans {
            let centre = free_place(&centres, rng)?;
            centres.push(centre).map_err(|_| NO_ROOM)?;
        }
        hold_the_first(&centres)
    }
}

impl ClutteredTablePlace {
    /// One of the two tasks there are: the first can stands to the right or to the left
    /// at the back, each with a probability of one half, and the other one in front
    /// of it.
    ///
    /// # Errors
    /// None: a state has room for two cans.
    pub fn task<G: Rng>(&self, rng: &mut G) -> Result<Task, Error> {
        let x = if uniform(rng) < 0.5 { 0.3 } else { 0.1 };
        hold_the_first(&[[x, 0.8], [0.2, 0.6]])
    }
}

/// A place, in single precision as in the framework, where a can touches none of
/// the others.
fn free_place<G: Rng>(others: &[[f64; 2]], rng: &mut G) -> Result<[f64; 2], Error> {
    let [low, high] = CLUTTER;
    for _ in 0..MAX_DRAWS {
        let mut draw = || f64::from(uniform_in(rng, low, high) as f32);
        let centre = [draw(), draw()];
        let apart = |other: &[f64; 2]| distance(centre, *other) > CAN_RADIUS + CAN_RADIUS;
        if others.iter().all(apart) {
            return Ok(centre);
        }
    }
    Err(NO_ROOM)
}

/// The task to hold the first of the cans that stand at these places.
fn hold_the_first(centres: &[[f64; 2]]) -> Result<Task, Error> {
    let mut initial = State::new();
    for [x, y] in centres {
        let can: Can = [*x, *y, CAN_RADIUS, 0.0, 0.0];
        initial.add(&TYPES, CAN_TYPE, &can)?;
    }
    let held = GroundAtom {
        predicate: HOLDING,
        objects: Arguments::new([FIRST_CAN])?,
    };
    let goal = Vec::from_slice(&[held]).map_err(|_| Error::CapacityExceeded("atoms of a goal"))?;
    Ok(Task { initial, goal })
}
