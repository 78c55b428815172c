//! The transition function.

use super::world::{AT_JUG, World, distance_squared, hand, handle, is_pressing};
use super::{
    Action, BUTTON, CLOSED, Cup, GRASP_LIMIT, Jug, MAX_ANGULAR_SPEED, MAX_SPEED, OPEN, POURED,
    POURING_TILT, ROOM, Robot, WRIST_LIMIT,
};
use crate::real::Real;

/// How far fingers are from open or closed at most to count as that.
const FINGER_TOLERANCE: f64 = 1e-2;
/// How far the jug is from the tilt at which it pours at most to pour.
const TILT_TOLERANCE: f64 = 0.1;

/// What a step does.
enum Deed {
    /// The whole step is undone.
    Nothing,
    Press,
    Drop,
    /// Into the cup of this place.
    Pour(usize),
    /// The held jug moves along.
    Carry,
    Grasp,
    Turn,
    /// The hand alone.
    Move,
}

/// One step; `None` if the values are no state of this environment, or the command no
/// numbers.
pub(super) fn simulate(values: &mut [f64], action: Action) -> Option<()> {
    let before = World::read(values)?;
    if !action.iter().all(|number| number.is_finite()) {
        return None;
    }
    let robot = moved(before.robot, action);
    let deed = decide(&before, &robot);
    let (old_robot, old_jug) = (*before.robot, *before.jug);
    carry_out(WorldMut::read(values)?, deed, robot, (&old_robot, &old_jug))?;
    fill(values)
}

/// The robot after its motion, which ends at limits.
fn moved(&[x, y, z, tilt, wrist, fingers]: &Robot, action: Action) -> Robot {
    let [dx, dy, dz, tilting, turning, opening] = action.map(f64::from);
    let along = |place, speed| Real::clamp(place + speed * MAX_SPEED, 0.0, ROOM);
    [
        along(x, dx),
        along(y, dy),
        along(z, dz),
        Real::clamp(tilt + tilting * MAX_ANGULAR_SPEED, 0.0, POURING_TILT),
        Real::clamp(
            wrist + turning * MAX_ANGULAR_SPEED,
            -WRIST_LIMIT,
            WRIST_LIMIT,
        ),
        Real::clamp(fingers + opening, CLOSED, OPEN),
    ]
}

/// What the robot does by being there.
fn decide(before: &World<'_>, robot: &Robot) -> Deed {
    let [_, _, _, tilt, _, fingers] = *robot;
    let [_, _, rotation, ..] = *before.jug;
    let near = |a, b, tolerance| Real::abs(a - b) < tolerance;
    if is_pressing(robot) && !before.is_machine_on() {
        Deed::Press
    } else if before.is_jug_held() {
        if near(fingers, OPEN, FINGER_TOLERANCE) {
            Deed::Drop
        } else if near(tilt, POURING_TILT, TILT_TOLERANCE) {
            pour(before, robot)
        } else {
            Deed::Carry
        }
    } else if near(fingers, CLOSED, FINGER_TOLERANCE)
        && distance_squared(handle(before.jug), hand(robot)) < AT_JUG
        && Real::abs(rotation) < GRASP_LIMIT
    {
        // It is where the fingers are that counts: passing by with closed ones grasps.
        Deed::Grasp
    } else if before.is_twisting() {
        Deed::Turn
    } else {
        Deed::Move
    }
}

/// Pours into the cup below, if there is one that does not run over.
fn pour(before: &World<'_>, robot: &Robot) -> Deed {
    // The jug hangs lower or higher, but does not follow sideways.
    let place = World { robot, ..*before }.cup_below();
    let cup = place.and_then(|place| before.cups.get(place));
    match (place, cup) {
        (Some(place), Some([_, _, capacity, _, current])) if current + POURED <= *capacity => {
            Deed::Pour(place)
        }
        _ => Deed::Nothing,
    }
}

/// The numbers of a state, to change.
struct WorldMut<'a> {
    machine: &'a mut [f64; 1],
    cups: &'a mut [Cup],
    jug: &'a mut Jug,
    robot: &'a mut Robot,
}

impl<'a> WorldMut<'a> {
    fn read(values: &'a mut [f64]) -> Option<Self> {
        let (machine, rest) = values.split_first_chunk_mut()?;
        let (rest, robot) = rest.split_last_chunk_mut()?;
        let (rest, jug) = rest.split_last_chunk_mut()?;
        let (cups, []) = rest.as_chunks_mut() else {
            return None;
        };
        Some(WorldMut {
            machine,
            cups,
            jug,
            robot,
        })
    }
}

/// Writes what the step does, of the robot moved and of what was before.
fn carry_out(
    world: WorldMut<'_>,
    deed: Deed,
    moved: Robot,
    (old_robot, old_jug): (&Robot, &Jug),
) -> Option<()> {
    let [x, y, z, tilt, wrist, fingers] = moved;
    let [old_x, old_y, old_z, _, old_wrist, _] = *old_robot;
    let [jug_x, jug_y, rotation, held, _] = world.jug;
    *world.robot = match deed {
        Deed::Nothing => *old_robot,
        Deed::Press => {
            *world.machine = [1.0];
            upright(BUTTON, fingers)
        }
        Deed::Drop => {
            *held = 0.0;
            moved
        }
        Deed::Pour(place) => {
            let [_, _, _, _, current] = world.cups.get_mut(place)?;
            *current += POURED;
            [old_x, old_y, old_z, tilt, wrist, CLOSED]
        }
        Deed::Carry => {
            *jug_x += x - old_x;
            *jug_y += y - old_y;
            upright([x, y, z], CLOSED)
        }
        Deed::Grasp => {
            *held = 1.0;
            upright(handle(old_jug), fingers)
        }
        Deed::Turn => {
            *rotation += wrist - old_wrist;
            moved
        }
        Deed::Move => moved,
    };
    Some(())
}

/// A robot there, with its wrist neither tilted nor turned.
fn upright([x, y, z]: [f64; 3], fingers: f64) -> Robot {
    [x, y, z, 0.0, 0.0, fingers]
}

/// Fills a jug that is in a machine that is on.
fn fill(values: &mut [f64]) -> Option<()> {
    let world = World::read(values)?;
    if world.is_machine_on() && world.is_jug_in_machine() {
        let [_, _, _, _, filled] = WorldMut::read(values)?.jug;
        *filled = 1.0;
    }
    Some(())
}
