//! The predicates, in the order of their names.

use super::world::{World, table};
use super::{BOX_TYPE, RESTING, ROBOT_TYPE, SHELF_TYPE, Shelf};
use crate::geometry::Cuboid;
use crate::real::Real;
use crate::task::{Predicate, PredicateId};

/// `HandEmpty(robot)`: the robot does not hold the box.
pub const HAND_EMPTY: PredicateId = PredicateId(0);
/// `Holding(robot, box)`: the robot holds the box.
pub const HOLDING: PredicateId = PredicateId(1);
/// `InShelf(box, shelf)`: the box stands on the floor board of the shelf.
pub const IN_SHELF: PredicateId = PredicateId(2);
/// `OnTable(box)`: the box stands on the table.
pub const ON_TABLE: PredicateId = PredicateId(3);

pub(super) static PREDICATES: [Predicate<Shelf>; 4] = [
    Predicate {
        name: "HandEmpty",
        arguments: &[ROBOT_TYPE],
        classifier: |_, state, _| World::of(state).is_some_and(|world| !world.is_held()),
    },
    Predicate {
        name: "Holding",
        arguments: &[ROBOT_TYPE, BOX_TYPE],
        classifier: |_, state, _| World::of(state).is_some_and(|world| world.is_held()),
    },
    Predicate {
        name: "InShelf",
        arguments: &[BOX_TYPE, SHELF_TYPE],
        classifier: |_, state, _| {
            World::of(state).is_some_and(|world| stands_on(&world, &world.floor()))
        },
    },
    Predicate {
        name: "OnTable",
        arguments: &[BOX_TYPE],
        classifier: |_, state, _| World::of(state).is_some_and(|world| stands_on(&world, &table())),
    },
];

/// Whether the box is let go and stands on a board.
fn stands_on(world: &World, board: &Cuboid<f64>) -> bool {
    let [_, _, z, _, height, _] = world.item;
    let [_, _, middle] = board.frame.origin();
    let [_, _, half] = board.half;
    let gap = z - 0.5 * height - (middle + half);
    !world.is_held() && Real::abs(gap) <= RESTING && is_over(board, &world.box_body())
}

/// Whether no corner of a body lies beyond the edge of a level board.
pub(super) fn is_over(board: &Cuboid<f64>, body: &Cuboid<f64>) -> bool {
    let [half_x, half_y, _] = board.half;
    body.vertices().into_iter().all(|corner| {
        let [x, y, _] = board.frame.to_local(corner);
        Real::abs(x) <= half_x && Real::abs(y) <= half_y
    })
}
