//! Random tasks: fill all cups.

use super::world::{Cup, World};
use super::{CUP_FILLED, CUP_RADIUS, CUP_TYPE, Coffee, JUG_RADIUS, OPEN, ROOM, Robot, TURN_LIMIT};
use crate::error::Error;
use crate::geometry::{Circle, Intersects};
use crate::random::{below, uniform_in};
use crate::task::{Arguments, GroundAtom, Task};
use core::ops::RangeInclusive;
use heapless::Vec;
use rand_core::Rng;

/// Most cups in a generated task.
pub const MAX_CUPS: usize = 4;

/// The robot in every task.
const ROBOT: Robot = [0.5 * ROOM, 0.5 * ROOM, ROOM, 0.0, 0.0, OPEN];
/// How far everything keeps from the edges of its part of the table, and cups, with their
/// radius, from one another.
const SPACING: f64 = 0.5;
/// Cups stand left of this, jugs within one of it.
const MIDDLE_X: f64 = 8.5;
/// Everything stands between these.
const TABLE_Y: [f64; 2] = [JUG_RADIUS + 1.5, 7.5 - 2.0 - JUG_RADIUS];
/// Least and most that a cup holds, and the share of it that is wanted.
const CAPACITY: [f64; 2] = [0.75, 1.5];
const WANTED: f64 = 0.75;

/// Draws of one cup, before all cups are drawn again, and how often that is done.
const MAX_DRAWS: usize = 10;
const MAX_ROUNDS: usize = 10_000;

const NO_ROOM: Error = Error::InvalidArgument("found no free place for all cups: ask for fewer");

/// The circles that cups keep free of others.
type Places = Vec<Circle<f64>, MAX_CUPS>;

impl Coffee {
    /// A random task with a number of cups drawn from `cups`: one or two for training in the
    /// framework, two or three for its tests.
    ///
    /// Cups stand apart on the left side of the table and differ in how much they hold; the
    /// jug stands on its right side, turned in any way that the robot can turn it to.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] if `cups` is empty or not within one and [`MAX_CUPS`], or
    /// if they find no room in 10 000 rounds.
    pub fn task<G: Rng>(&self, cups: RangeInclusive<usize>, rng: &mut G) -> Result<Task, Error> {
        let (least, most) = cups.into_inner();
        if least < 1 || most < least || most > MAX_CUPS {
            return Err(Error::InvalidArgument(
                "ask for at least one and at most four cups",
            ));
        }
        let count = least + below(rng, most - least + 1);
        let mut cups: Vec<Cup, MAX_CUPS> = Vec::new();
        for Circle { centre: [x, y], .. } in draw_places(count, rng)? {
            let [least, most] = CAPACITY;
            let capacity = uniform_in(rng, least, most);
            let cup = [x, y, capacity, WANTED * capacity, 0.0];
            cups.push(cup).map_err(|_| NO_ROOM)?;
        }
        let [low, high] = TABLE_Y;
        let x = uniform_in(rng, MIDDLE_X - 1.0 + SPACING, MIDDLE_X + 1.0 - SPACING);
        let y = uniform_in(rng, low + SPACING, high - SPACING);
        let rotation = uniform_in(rng, -TURN_LIMIT, TURN_LIMIT);
        fill_all(&World {
            machine: &[0.0],
            cups: &cups,
            jug: &[x, y, rotation, 0.0, 0.0],
            robot: &ROBOT,
        })
    }
}

/// Places for so many cups.
fn draw_places<G: Rng>(count: usize, rng: &mut G) -> Result<Places, Error> {
    for _ in 0..MAX_ROUNDS {
        let mut places = Places::new();
        while places.len() < count {
            let Some(place) = free_place(&places, rng) else {
                break;
            };
            places.push(place).map_err(|_| NO_ROOM)?;
        }
        if places.len() == count {
            return Ok(places);
        }
    }
    Err(NO_ROOM)
}

/// A place that meets none of the others.
fn free_place<G: Rng>(others: &[Circle<f64>], rng: &mut G) -> Option<Circle<f64>> {
    let radius = CUP_RADIUS + SPACING;
    let [low, high] = TABLE_Y;
    (0..MAX_DRAWS).find_map(|_| {
        let centre = [
            uniform_in(rng, radius, MIDDLE_X - 1.0 - radius),
            uniform_in(rng, low + SPACING, high - SPACING),
        ];
        let place = Circle { centre, radius };
        (!others.iter().any(|other| place.intersects(other))).then_some(place)
    })
}

/// The task to fill all cups of this world.
fn fill_all(world: &World<'_>) -> Result<Task, Error> {
    let initial = world.to_state()?;
    let mut goal = Vec::new();
    for cup in initial.of_type(CUP_TYPE) {
        let atom = GroundAtom {
            predicate: CUP_FILLED,
            objects: Arguments::new([cup])?,
        };
        goal.push(atom)
            .map_err(|_| Error::CapacityExceeded("atoms of a goal"))?;
    }
    Ok(Task { initial, goal })
}
