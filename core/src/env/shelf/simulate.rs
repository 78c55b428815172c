//! The transition function.

use super::predicates::is_over;
use super::world::{World, table};
use super::{Action, OPENING};
use crate::geometry::Intersects;

/// One action; `None` if the values are no state of this environment.
pub(super) fn simulate(values: &mut [f64], action: Action) -> Option<()> {
    let world = World::read(values)?;
    let after = match action {
        Action::Rest => None,
        Action::Pick { pitch, yaw } => pick(world, pitch, yaw),
        Action::Place { x, y } => place(world, x, y),
    };
    if let Some(after) = after {
        after.write(values);
    }
    Some(())
}

/// The world after a grasp; `None` if it is not possible.
fn pick(mut world: World, pitch: f64, yaw: f64) -> Option<World> {
    let [x, y, z, ..] = world.item;
    if world.is_held() {
        return None;
    }
    world.robot = [x, y, z, yaw, pitch];
    let (hand, item) = (world.hand(), world.box_body());
    let [_, between_fingers, _] = world.hand_frame().axes();
    let fits = item.extent(between_fingers) <= OPENING;
    if !fits || hand.intersects(&table()) || hand.intersects(&item) {
        return None;
    }
    let [_, _, _, item_yaw, _, held] = &mut world.item;
    (*item_yaw, *held) = (yaw, 1.0);
    Some(world)
}

/// The world after the box was placed; `None` if that is not possible.
fn place(mut world: World, x: f64, y: f64) -> Option<World> {
    let [_, _, _, yaw, pitch] = world.robot;
    let [_, _, _, item_yaw, height, _] = world.item;
    let [shelf_x, shelf_y, shelf_z, _] = world.shelf;
    if !world.is_held() {
        return None;
    }
    let at = [shelf_x + x, shelf_y + y, shelf_z + 0.5 * height];
    let [x, y, z] = at;
    world.robot = [x, y, z, 0.0, pitch];
    world.item = [x, y, z, item_yaw - yaw, height, 0.0];
    let (hand, item, floor, above) = (
        world.hand(),
        world.box_body(),
        world.floor(),
        world.board_above(),
    );
    let collides = item.intersects(&above)
        || hand.intersects(&floor)
        || hand.intersects(&above)
        || world.walls().iter().any(|wall| hand.intersects(wall));
    (is_over(&floor, &item) && !collides).then_some(world)
}
