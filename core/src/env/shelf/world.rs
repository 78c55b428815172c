//! A state read as what is in the world, and the bodies of it.

use super::{
    BOARD, BOX_DEPTH, BOX_TYPE, BOX_WIDTH, FINGER_LENGTH, HAND_LENGTH, HAND_THICKNESS, HAND_WIDTH,
    OVERHANG, ROBOT_TYPE, SHELF_DEPTH, SHELF_TOP, SHELF_TYPE, Shelf, TABLE_SIZE,
};
use crate::error::Error;
use crate::geometry::{Cuboid, Frame3};
use crate::task::{Environment, State};

/// What is in the world: the numbers of a state by object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct World {
    /// The robot's x, y, z, yaw and pitch.
    pub robot: [f64; 5],
    /// The box's x, y, z, yaw, height and held.
    pub item: [f64; 6],
    /// The shelf's x, y, z and width.
    pub shelf: [f64; 4],
}

impl World {
    /// Reads a state; `None` if it does not belong to this environment.
    pub fn of(state: &State) -> Option<Self> {
        World::read(state.values())
    }

    /// Reads the numbers of a state; `None` if they are none.
    pub fn read(values: &[f64]) -> Option<Self> {
        let (robot, rest) = values.split_first_chunk()?;
        let (item, rest) = rest.split_first_chunk()?;
        let (shelf, []) = rest.split_first_chunk()? else {
            return None;
        };
        Some(World {
            robot: *robot,
            item: *item,
            shelf: *shelf,
        })
    }

    /// Writes the numbers back to those of the same state.
    pub(super) fn write(&self, values: &mut [f64]) {
        let all = self.robot.iter().chain(&self.item).chain(&self.shelf);
        for (value, number) in values.iter_mut().zip(all) {
            *value = *number;
        }
    }

    /// The state with these numbers.
    ///
    /// # Errors
    /// Those of [`State::add`].
    pub fn to_state(&self) -> Result<State, Error> {
        let types = Shelf::TYPES;
        let mut state = State::new();
        state.add(types, ROBOT_TYPE, &self.robot)?;
        state.add(types, BOX_TYPE, &self.item)?;
        state.add(types, SHELF_TYPE, &self.shelf)?;
        Ok(state)
    }

    pub(super) fn is_held(&self) -> bool {
        let [.., held] = self.item;
        held > 0.5
    }

    /// The frame of the hand.
    pub(super) fn hand_frame(&self) -> Frame3<f64> {
        let [x, y, z, yaw, pitch] = self.robot;
        Frame3::new([x, y, z], [yaw, pitch, 0.0])
    }

    /// The hand, without its fingers.
    pub(super) fn hand(&self) -> Cuboid<f64> {
        let back = -0.5 * (FINGER_LENGTH + HAND_LENGTH);
        let size = [HAND_LENGTH - FINGER_LENGTH, HAND_WIDTH, HAND_THICKNESS];
        Cuboid::within(self.hand_frame().shifted([back, 0.0, 0.0]), size)
    }

    /// The box.
    pub(super) fn box_body(&self) -> Cuboid<f64> {
        let [x, y, z, yaw, height, _] = self.item;
        Cuboid::new([x, y, z], [BOX_DEPTH, BOX_WIDTH, height], [yaw, 0.0, 0.0])
    }

    /// The floor board of the shelf.
    pub(super) fn floor(&self) -> Cuboid<f64> {
        let [_, _, z, width] = self.shelf;
        let across = [-0.5 * width, 0.5 * width];
        self.shelf_part([0.0, SHELF_DEPTH], across, [z - BOARD, z])
    }

    /// The board of the shelf above.
    pub(super) fn board_above(&self) -> Cuboid<f64> {
        let [.., width] = self.shelf;
        let across = [-0.5 * width, 0.5 * width];
        self.shelf_part(SURROUNDED, across, [SHELF_TOP, SHELF_TOP + BOARD])
    }

    /// The walls of the shelf: to the right and to the left.
    pub(super) fn walls(&self) -> [Cuboid<f64>; 2] {
        let [_, _, z, width] = self.shelf;
        let up = [z - BOARD, SHELF_TOP + BOARD];
        let side = 0.5 * width;
        [[-side - BOARD, -side], [side, side + BOARD]]
            .map(|across| self.shelf_part(SURROUNDED, across, up))
    }

    /// A part of the shelf that extends from one number to another: along x and y as
    /// seen from the middle of the floor board's front edge, along z in the world.
    fn shelf_part(&self, x: [f64; 2], y: [f64; 2], z: [f64; 2]) -> Cuboid<f64> {
        let [shelf_x, shelf_y, ..] = self.shelf;
        let [x, y] = [(shelf_x, x), (shelf_y, y)].map(|(at, ends)| ends.map(|end| at + end));
        let middle = [x, y, z].map(|[low, high]| 0.5 * (low + high));
        let size = [x, y, z].map(|[low, high]| high - low);
        Cuboid::new(middle, size, [0.0; 3])
    }
}

/// Where board above and walls are along x, from the front edge of the floor board.
const SURROUNDED: [f64; 2] = [-OVERHANG, SHELF_DEPTH];

/// The table.
pub(super) fn table() -> Cuboid<f64> {
    Cuboid::new(
        [0.0, 0.0, -0.5 * BOARD],
        [TABLE_SIZE, TABLE_SIZE, BOARD],
        [0.0; 3],
    )
}
