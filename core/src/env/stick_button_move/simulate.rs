//! The transition function.

use super::world::{WorldMut, robot_shape, stick_shape};
use super::{Action, TABLE_WIDTH};
use crate::env::stick_button::MAX_SPEED;
use crate::env::stick_button::simulate::{Push, is_reachable, press_buttons, push};
use crate::env::stick_button::world::{is_set, tip_shape};

/// One step; `None` if the values are no state of this environment.
///
/// Moving never collides. A step that would take the robot out of its zone does
/// nothing at all, and nothing is clamped.
pub(super) fn simulate(values: &mut [f64], action: Action) -> Option<()> {
    let world = WorldMut::of(values)?;
    let [dx, dy, _, press, pick_or_place] = action.map(f64::from);
    let (dx, dy) = (dx * MAX_SPEED, dy * MAX_SPEED);
    let (mut robot, mut stick) = (*world.robot, *world.stick);
    let [x, y, _, fingers] = &mut robot;
    (*x, *y) = (*x + dx, *y + dy);
    if !is_reachable([*x, *y], TABLE_WIDTH) {
        return Some(());
    }
    let [stick_x, stick_y, _, _, _, held] = &mut stick;
    let (is_held, is_closed) = (is_set(*held), !is_set(*fingers));
    if is_held && is_closed {
        *stick_x += dx;
        *stick_y += dy;
    }
    let (hand, shape) = (robot_shape(&robot), stick_shape(&stick));
    if pick_or_place > 0.0 && (is_closed || !is_held) {
        let done = match push(is_held, &hand, &shape, world.holder) {
            Push::Nothing => None,
            Push::Pick => Some([1.0, 0.0]),
            Push::Release => Some([0.0, 1.0]),
            // The whole step is undone, presses included.
            Push::Collision => return Some(()),
        };
        if let (Some(done), [_, _, _, fingers], [.., held]) = (done, &mut robot, &mut stick) {
            [*held, *fingers] = done;
        }
    }
    // Who presses is who did before anything was picked or placed.
    if press > 0.0 {
        press_buttons(is_held, &hand, &shape, world.buttons);
    }
    let [_, _, tip_x, tip_y, ..] = &mut stick;
    [*tip_x, *tip_y] = tip_shape(&shape).frame.origin();
    (*world.robot, *world.stick) = (robot, stick);
    Some(())
}
