//! The transition function.

use super::world::{
    WorldMut, button_shape, holder_shape, is_set, robot_shape, stick_shape, tip_shape,
};
use super::{
    Action, MAX_ANGULAR_SPEED, MAX_SPEED, ROBOT_RADIUS, STICK_WIDTH, TABLE_WIDTH, ZONE_HEIGHT,
};
use crate::geometry::{Circle, Frame2, Intersects, Rectangle};
use crate::real::Real;

/// One step; `None` if the values are no state of this environment.
///
/// Moving never collides. A step that would take the robot out of its zone does
/// nothing at all, and nothing is clamped.
pub(super) fn simulate(angles: bool, values: &mut [f64], action: Action) -> Option<()> {
    let world = WorldMut::of(values)?;
    let [dx, dy, turn, press] = action.map(f64::from);
    let (dx, dy) = (dx * MAX_SPEED, dy * MAX_SPEED);
    let turn = if angles {
        turn * MAX_ANGULAR_SPEED
    } else {
        0.0
    };

    let [x, y, theta] = *world.robot;
    let robot = [x + dx, y + dy, theta + turn];
    if !is_reachable([x + dx, y + dy], TABLE_WIDTH) {
        return Some(());
    }
    let [mut sx, mut sy, mut stick_theta, mut held] = *world.stick;
    let was_held = is_set(held);
    if was_held {
        if angles {
            [sx, sy, stick_theta] = turn_about([x, y], turn, [sx, sy, stick_theta]);
        }
        sx += dx;
        sy += dy;
    }
    if press > 0.0 {
        let hand = robot_shape(&robot);
        let stick = stick_shape(&[sx, sy, stick_theta, held]);
        match push(was_held, &hand, &stick, world.holder) {
            Push::Nothing => {}
            Push::Pick => held = 1.0,
            Push::Release => held = 0.0,
            // The whole step is undone.
            Push::Collision => return Some(()),
        }
        press_buttons(was_held, &hand, &stick, world.buttons);
    }
    *world.robot = robot;
    *world.stick = [sx, sy, stick_theta, held];
    Some(())
}

/// Whether the whole robot is in the zone that it can reach, of a table of this width.
pub(in crate::env) fn is_reachable([x, y]: [f64; 2], width: f64) -> bool {
    (ROBOT_RADIUS..=width - ROBOT_RADIUS).contains(&x)
        && (ROBOT_RADIUS..=ZONE_HEIGHT - ROBOT_RADIUS).contains(&y)
}

/// The pose of the stick turned about a point. The angle is measured again, as
/// in the framework, and so comes back in `[-pi, pi]`.
fn turn_about(pivot: [f64; 2], turn: f64, [x, y, theta]: [f64; 3]) -> [f64; 3] {
    let [px, py] = pivot;
    let turned = Frame2::new(pivot, turn);
    let end = Frame2::new([x, y], theta).apply([STICK_WIDTH, 0.0]);
    let [[x, y], [end_x, end_y]] = [[x, y], end].map(|[x, y]| turned.apply([x - px, y - py]));
    [x, y, Real::atan2(end_y - y, end_x - x)]
}

/// What a push with the hand does to the stick.
pub(in crate::env) enum Push {
    Nothing,
    Pick,
    Release,
    Collision,
}

/// A held stick is released on the holder, where it is; a free one is picked if
/// the hand does not collide with the holder.
pub(in crate::env) fn push(
    was_held: bool,
    hand: &Circle<f64>,
    stick: &Rectangle<f64>,
    holder: &[f64; 3],
) -> Push {
    if was_held {
        if stick.intersects(&holder_shape(holder)) {
            Push::Release
        } else {
            Push::Nothing
        }
    } else if !stick.intersects(hand) {
        Push::Nothing
    } else if hand.intersects(&holder_shape(holder)) {
        Push::Collision
    } else {
        Push::Pick
    }
}

/// Presses every button under the tip, or under the hand if it was empty.
pub(in crate::env) fn press_buttons(
    was_held: bool,
    hand: &Circle<f64>,
    stick: &Rectangle<f64>,
    buttons: &mut [[f64; 3]],
) {
    let tip = tip_shape(stick);
    for button in buttons {
        let shape = button_shape(button);
        let meets = if was_held {
            tip.intersects(&shape)
        } else {
            hand.intersects(&shape)
        };
        if meets {
            let [_, _, pressed] = button;
            *pressed = 1.0;
        }
    }
}
