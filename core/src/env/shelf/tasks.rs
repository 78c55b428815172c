//! Random tasks: put the box in the shelf.

use super::{
    BOX, BOX_DEPTH, BOX_WIDTH, FINGER_LENGTH, HAND_LENGTH, HAND_THICKNESS, HAND_WIDTH, IN_SHELF,
    OVERHANG, SHELF, SHELF_TOP, Shelf, TABLE_SIZE, World,
};
use crate::error::Error;
use crate::random::uniform_in;
use crate::task::{Arguments, GroundAtom, Task};
use heapless::Vec;
use rand_core::Rng;

/// How far the box is from x = y = 0 at most, along each axis.
pub const BOX_RANGE: f64 = 0.25;
/// How far the box is turned at most, to either side.
pub const BOX_YAW: f64 = 0.35;
/// The lowest and the highest box.
pub const BOX_HEIGHTS: [f64; 2] = [0.08, 0.16];
/// The least and the greatest x, y and z of the shelf.
pub const SHELF_PLACES: [[f64; 2]; 3] = [[1.0, 1.2], [-0.2, 0.2], [0.43, 0.55]];
/// The narrowest and the widest shelf.
pub const SHELF_WIDTHS: [f64; 2] = [0.3, 0.6];
/// Where the hand is first: its x, y, z, yaw and pitch.
pub const REST_POSE: [f64; 5] = [0.0, 0.0, 0.5, 0.0, 0.0];

// On this the closed forms of the feasible sets rest.
const _: () = {
    let [_, highest] = BOX_HEIGHTS;
    let [_, _, [_, highest_floor]] = SHELF_PLACES;
    let clearance = SHELF_TOP - highest_floor;
    let half_thickness = 0.5 * HAND_THICKNESS;
    let half_width = 0.5 * HAND_WIDTH;
    let upright = HAND_LENGTH * HAND_LENGTH + half_thickness * half_thickness;
    let room = 0.5 * TABLE_SIZE - BOX_RANGE;
    let corner = BOX_DEPTH * BOX_DEPTH + BOX_WIDTH * BOX_WIDTH + highest * highest;
    assert!(OVERHANG * OVERHANG > upright, "the walls surround the hand");
    assert!(
        room * room > upright + half_width * half_width,
        "the hand is above the table"
    );
    assert!(
        FINGER_LENGTH * FINGER_LENGTH > 0.25 * corner,
        "the hand keeps off the box"
    );
    assert!(
        0.5 * highest + FINGER_LENGTH < clearance,
        "the hand begins below the board above"
    );
    assert!(highest < clearance && BOX_WIDTH < HAND_WIDTH);
};

impl Shelf {
    /// A random task: to put the box in the shelf.
    ///
    /// # Errors
    /// None with these numbers: those of [`World::to_state`].
    pub fn task<G: Rng>(&self, rng: &mut G) -> Result<Task, Error> {
        let mut within = |[low, high]: [f64; 2]| uniform_in(rng, low, high);
        let x = within([-BOX_RANGE, BOX_RANGE]);
        let y = within([-BOX_RANGE, BOX_RANGE]);
        let yaw = within([-BOX_YAW, BOX_YAW]);
        let height = within(BOX_HEIGHTS);
        let [shelf_x, shelf_y, shelf_z] = SHELF_PLACES.map(&mut within);
        let width = within(SHELF_WIDTHS);
        let world = World {
            robot: REST_POSE,
            item: [x, y, 0.5 * height, yaw, height, 0.0],
            shelf: [shelf_x, shelf_y, shelf_z, width],
        };
        let atom = GroundAtom {
            predicate: IN_SHELF,
            objects: Arguments::new([BOX, SHELF])?,
        };
        Ok(Task {
            initial: world.to_state()?,
            goal: Vec::from_iter([atom]),
        })
    }
}
