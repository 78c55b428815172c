//! The shelf environment: the thesis's motivating example (1.1).
//!
//! A box stands on a table. The robot grasps it with a pitch between horizontal and
//! top-down and a yaw, and places it in a shelf with a board above. How it grasps the
//! box decides not only whether the pick works, but also whether the box can be placed
//! later: below a low board a steep grasp collides with it, and which pitches are too
//! steep differs from task to task.
//!
//! # The world
//!
//! Lengths are metres, angles radians; x and y are horizontal, z is up and zero at the
//! table's top. Frames turn by yaw, pitch and roll as [`Frame3`](crate::geometry::Frame3)
//! does.
//!
//! | type | attributes |
//! |---|---|
//! | `robot` | `x y z`: the point that it grasps at; `yaw pitch` of the hand |
//! | `box` | `x y z`: its centre; `yaw`; its `height`; `held`: a flag |
//! | `shelf` | `x y z`: the middle of the front edge of its floor board; its `width` |
//!
//! There is one object of each type. All bodies are boxes
//! ([`Cuboid`](crate::geometry::Cuboid)):
//!
//! - The **table** is a square of side [`TABLE_SIZE`] around x = y = 0, [`BOARD`] thick.
//! - The **box** is [`BOX_DEPTH`] along its x axis, [`BOX_WIDTH`] along its y axis and
//!   `height` high. It stands upright, always.
//! - The **hand** is at the origin of its frame where it grasps. Its x axis points to
//!   where it reaches: ahead at a pitch of 0, straight down at pi/2. Its body begins
//!   [`FINGER_LENGTH`] behind the grasp, ends [`HAND_LENGTH`] behind it, is
//!   [`HAND_WIDTH`] wide (along y) and [`HAND_THICKNESS`] thick (along z). Fingers count
//!   as thin: they are no bodies, but between them is room for [`OPENING`] only.
//! - The **shelf** has a floor board, a board above and two side walls; it is open to the
//!   front, where x is least, and to the rear. The floor board is [`SHELF_DEPTH`] deep and
//!   `width` wide. The board above is at the height [`SHELF_TOP`], whatever that of the
//!   floor board. Board above and walls stand out by another [`OVERHANG`] in front of the
//!   floor board, so that they surround the whole hand. Boards and walls are [`BOARD`]
//!   thick, outwards.
//!
//! # What holds, and what the robot does
//!
//! | predicate | holds if |
//! |---|---|
//! | `HandEmpty(robot)` | the box is not held |
//! | `Holding(robot, box)` | the box is held |
//! | `InShelf(box, shelf)` | it is not held, its bottom is at the height of the floor board and no corner lies beyond the edge of the floor board |
//! | `OnTable(box)` | it is not held, its bottom is at the height of the table and no corner lies beyond the edge of the table |
//!
//! Heights agree within [`RESTING`]; corners may lie on the edge.
//!
//! | operator | precondition | adds | deletes |
//! |---|---|---|---|
//! | `Pick(robot, box)` | `HandEmpty`, `OnTable` | `Holding` | `HandEmpty`, `OnTable` |
//! | `Place(robot, box, shelf)` | `Holding` | `HandEmpty`, `InShelf` | `Holding` |
//!
//! The controllers have the same names and objects. Each commands one action and is done.
//!
//! | controller | parameters |
//! |---|---|
//! | `Pick` | `pitch` in `[0, pi/2]`, `yaw` in `[-1.2, 1.2]` |
//! | `Place` | `x` in `[0, 0.3]`: from the front edge of the floor board; `y` in `[-0.3, 0.3]`: from its middle |
//!
//! The original samplers are uniform over these.
//!
//! # The transition
//!
//! Motions are not simulated, only where they end. An action that is not possible, or
//! would end in a collision, changes nothing. Bodies collide if they overlap: touching is
//! allowed.
//!
//! *Pick*, if the box is not held, brings the hand to the centre of the box, with the yaw
//! and the pitch of the action. Then it must hold that
//!
//! 1. the box fits between the fingers: its extent along the hand's y axis is at most
//!    [`OPENING`];
//! 2. the hand overlaps neither the table nor the box.
//!
//! The fingers close and turn the box between them: it is held, and has the yaw of the
//! hand.
//!
//! *Place*, if the box is held, brings the hand to the place, at half the height of the
//! box above the floor board. It reaches straight into the shelf, with a yaw of zero, and
//! keeps its pitch. The box is turned as it was in the hand. Then it must hold that
//!
//! 1. no corner of the box lies beyond the edge of the floor board;
//! 2. the box does not overlap the board above;
//! 3. the hand overlaps no board and no wall.
//!
//! The box is let go: it is not held, and is where the hand is.
//!
//! # New tasks
//!
//! [`Shelf::task`] draws every number uniformly: x and y of the box within
//! [`BOX_RANGE`] of zero, its yaw within [`BOX_YAW`] of zero, its height in
//! [`BOX_HEIGHTS`]; x, y and z of the shelf in [`SHELF_PLACES`], its width in
//! [`SHELF_WIDTHS`]. The hand is in [`REST_POSE`]. The goal is that the box is in the
//! shelf. Every such task has a plan of two steps.
//!
//! # Which parameters work
//!
//! In these tasks the hand is above the table as far as it reaches, and the box fits
//! below the board above. The feasible sets are then, with the height `h` of the box,
//! finger length `f`, hand length `l`, width `w` and half thickness `t`:
//!
//! | of | feasible |
//! |---|---|
//! | `Pick` | `abs(yaw - box.yaw) <= SWIVEL` and `h/2 + f sin(pitch) - t cos(pitch) >= 0` |
//! | `Place`, with the pitch of the hand | `abs(y) <= width/2 - w/2` and `BOX_DEPTH/2 <= x <= SHELF_DEPTH - BOX_DEPTH/2` and `shelf.z + h/2 + l sin(pitch) + t cos(pitch) <= SHELF_TOP` |
//!
//! In words: the heel of the hand is above the table, its sides keep off the walls, and
//! its far end stays below the board above. [`SWIVEL`] is where the extent of the box
//! between the fingers reaches [`OPENING`]. The feasible set of the chain is what
//! satisfies both: a pitch that is steep enough for the table and shallow enough for the
//! board above, which is another range in each task.
//!
//! As the shelf stands along the axes of the world, each of these gaps is a coordinate, a
//! distance or a parameter of the texts in [`Describe`](crate::skill::Describe): the
//! heel is `hand.heel`, the far end `hand.end`, points of the hand that turn with the
//! pitch.
//!
//! ```
//! use critreg::task::{Environment, try_operator};
//! use critreg::env::shelf::{BOX, ROBOT, SHELF, Shelf};
//! use critreg::random::generator;
//!
//! let task = Shelf.task(&mut generator(1))?;
//! let yaw = task.initial.attributes(BOX).unwrap()[3];
//! let [pick, place] = Shelf::OPERATORS else { unreachable!() };
//! for (pitch, works) in [(0.4, true), (1.5, false)] {
//!     let picked = try_operator(&Shelf, pick, &[ROBOT, BOX], &[pitch, yaw], &task.initial);
//!     assert!(picked.is_feasible());
//!     let objects = [ROBOT, BOX, SHELF];
//!     let placed = try_operator(&Shelf, place, &objects, &[0.15, 0.0], &picked.state);
//!     assert_eq!(placed.is_feasible(), works, "pitch {pitch}");
//! }
//! # Ok::<(), critreg::Error>(())
//! ```

mod controllers;
mod operators;
mod predicates;
mod simulate;
mod skills;
mod tasks;
mod world;

pub use controllers::{PICK, PLACE};
pub use predicates::{HAND_EMPTY, HOLDING, IN_SHELF, ON_TABLE};
pub use tasks::{BOX_HEIGHTS, BOX_RANGE, BOX_YAW, REST_POSE, SHELF_PLACES, SHELF_WIDTHS};
pub use world::World;

use crate::domain::{Attribute, Dimension};
use crate::task::{
    Controller, Environment, Failure, Naming, ObjectId, ObjectType, Operator, Predicate, State,
    TypeId,
};

/// Side of the table's top.
pub const TABLE_SIZE: f64 = 1.2;
/// How thick boards and walls are, and the table.
pub const BOARD: f64 = 0.02;
/// Size of the box along its x axis, which the fingers reach along.
pub const BOX_DEPTH: f64 = 0.08;
/// Size of the box along its y axis, between the fingers.
pub const BOX_WIDTH: f64 = 0.06;
/// How far the fingers open.
pub const OPENING: f64 = 0.08;
/// The largest angle between box and hand at which the box fits between the fingers:
/// where `BOX_WIDTH cos + BOX_DEPTH sin` is [`OPENING`], which is the arc tangent of
/// 7/24.
pub const SWIVEL: f64 = 0.283_794_109_208_327_8;
/// From the point of the grasp back to the hand.
pub const FINGER_LENGTH: f64 = 0.1;
/// From the point of the grasp back to the far end of the hand.
pub const HAND_LENGTH: f64 = 0.29;
/// Size of the hand across, along its y axis.
pub const HAND_WIDTH: f64 = 0.13;
/// Size of the hand along its z axis.
pub const HAND_THICKNESS: f64 = 0.15;
/// How deep the floor board of the shelf is.
pub const SHELF_DEPTH: f64 = 0.3;
/// Height of the lower side of the shelf's board above.
pub const SHELF_TOP: f64 = 0.8;
/// How far the board above and the walls stand out in front of the floor board: more
/// than the hand does at any pitch.
pub const OVERHANG: f64 = 0.35;
/// How far the bottom of a box may be from what it stands on, for rounding.
pub const RESTING: f64 = 1e-6;

/// Type of the robot.
pub const ROBOT_TYPE: TypeId = TypeId(0);
/// Type of the box.
pub const BOX_TYPE: TypeId = TypeId(1);
/// Type of the shelf.
pub const SHELF_TYPE: TypeId = TypeId(2);

/// The robot, in every state.
pub const ROBOT: ObjectId = ObjectId(0);
/// The box, in every state.
pub const BOX: ObjectId = ObjectId(1);
/// The shelf, in every state.
pub const SHELF: ObjectId = ObjectId(2);

/// What a controller commands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Action {
    /// Nothing.
    Rest,
    /// Grasp the box where it is.
    Pick {
        /// Pitch of the hand.
        pitch: f64,
        /// Yaw of the hand.
        yaw: f64,
    },
    /// Place the box in the shelf.
    Place {
        /// How far behind the front edge of the floor board.
        x: f64,
        /// How far from the middle of the floor board, to the left.
        y: f64,
    },
}

/// The environment. See the [module](self).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Shelf;

impl Environment for Shelf {
    type Action = Action;

    const TYPES: &'static [ObjectType] = &TYPES;
    const PREDICATES: &'static [Predicate<Self>] = &predicates::PREDICATES;
    const CONTROLLERS: &'static [Controller<Self>] = &controllers::CONTROLLERS;
    const OPERATORS: &'static [Operator<'static>] = &operators::OPERATORS;

    fn simulate(&self, state: &mut State, action: Action) -> Result<(), Failure> {
        simulate::simulate(state.values_mut(), action).ok_or(Failure::default())
    }
}

const fn length(name: &'static str) -> Attribute<'static> {
    Attribute::new(name, Dimension::Length)
}

const fn angle(name: &'static str) -> Attribute<'static> {
    Attribute::new(name, Dimension::Angle)
}

const X: Attribute<'static> = length("x");
const Y: Attribute<'static> = length("y");
const Z: Attribute<'static> = length("z");
const YAW: Attribute<'static> = angle("yaw");
const HELD: Attribute<'static> = Attribute::new("held", Dimension::Flag);

static TYPES: [ObjectType; 3] = [
    ObjectType {
        name: "robot",
        attributes: &[X, Y, Z, YAW, angle("pitch")],
        naming: Naming::Single("robby"),
    },
    ObjectType {
        name: "box",
        attributes: &[X, Y, Z, YAW, length("height"), HELD],
        naming: Naming::Single("box"),
    },
    ObjectType {
        name: "shelf",
        attributes: &[X, Y, Z, length("width")],
        naming: Naming::Single("shelf"),
    },
];
