//! Random tasks: press all buttons.

use super::world::{World, stick_shape};
use super::{
    BUTTON_RADIUS, BUTTON_TYPE, HOLDER_HEIGHT, HOLDER_WIDTH, PRESSED, ROBOT_RADIUS, STICK_HEIGHT,
    STICK_WIDTH, StickButton, TABLE_HEIGHT, TABLE_WIDTH, UPRIGHT, ZONE_HEIGHT,
};
use crate::error::Error;
use crate::geometry::{Circle, Frame2, Intersects};
use crate::random::{below, uniform_in};
use crate::task::{Arguments, GroundAtom, Task};
use core::f64::consts::PI;
use core::ops::RangeInclusive;
use heapless::Vec;
use rand_core::Rng;

/// Most buttons in a generated task; with more, the order of the objects would no
/// longer be that of their names.
pub const MAX_BUTTONS: usize = 10;

/// How far robot, buttons and the edges of the table keep apart: the radius of
/// the circles around them that must not meet.
pub(in crate::env) const SPACING: f64 = ROBOT_RADIUS + 0.5;
// Robot and buttons have one spacing because they have one radius.
const _: () = assert!(ROBOT_RADIUS == BUTTON_RADIUS);

/// The largest y of a stick's corner in a new task.
const HIGHEST_STICK: f64 = 1.6;

/// How often an object is drawn again before the generator gives up. Even with
/// ten buttons on the table most draws are free.
const MAX_DRAWS: usize = 10_000;

const NO_ROOM: Error =
    Error::InvalidArgument("found no free place for all objects: ask for fewer buttons");

/// Where everything lies in a new task.
#[derive(Clone, Debug, PartialEq)]
pub struct Arrangement {
    robot: [f64; 3],
    stick: [f64; 4],
    holder: [f64; 3],
    buttons: Vec<[f64; 3], MAX_BUTTONS>,
}

impl Arrangement {
    /// What lies on the table.
    pub fn world(&self) -> World<'_> {
        World {
            robot: &self.robot,
            stick: &self.stick,
            holder: &self.holder,
            buttons: &self.buttons,
        }
    }
}

impl StickButton {
    /// A random task with a number of buttons drawn from `buttons`: one or two
    /// for training, three or four for the framework's tests, one for those of
    /// the thesis.
    ///
    /// # Errors
    /// Those of [`StickButton::arrange`].
    pub fn task<G: Rng>(&self, buttons: RangeInclusive<usize>, rng: &mut G) -> Result<Task, Error> {
        press_all(&self.arrange(buttons, rng)?.world())
    }

    /// Where everything lies in a random task, see [`StickButton::task`]; smaller than
    /// its state.
    ///
    /// Buttons lie anywhere on the table, robot and stick in the reachable zone,
    /// all apart from one another; the holder lies under the stick, and so that a
    /// button out of the robot's reach can be pressed with the stick.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] if `buttons` is empty or not within one and
    /// [`MAX_BUTTONS`], or if the objects find no room in 10 000 draws each.
    pub fn arrange<G: Rng>(
        &self,
        buttons: RangeInclusive<usize>,
        rng: &mut G,
    ) -> Result<Arrangement, Error> {
        let table = Table {
            width: TABLE_WIDTH,
            is_button_free: |_| true,
            angles: self.angles,
        };
        table.arrange(buttons, rng)
    }
}

/// What the variants of the environment differ in.
pub(in crate::env) struct Table {
    /// Size along x.
    pub(in crate::env) width: f64,
    /// Whether a button may lie at this y.
    pub(in crate::env) is_button_free: fn(f64) -> bool,
    /// Whether things lie at any angle.
    pub(in crate::env) angles: bool,
}

impl Table {
    /// See [`StickButton::arrange`].
    pub(in crate::env) fn arrange<G: Rng>(
        &self,
        buttons: RangeInclusive<usize>,
        rng: &mut G,
    ) -> Result<Arrangement, Error> {
        let (least, most) = buttons.into_inner();
        if least < 1 || most < least || most > MAX_BUTTONS {
            return Err(Error::InvalidArgument(
                "ask for at least one and at most ten buttons",
            ));
        }
        let count = least + below(rng, most - least + 1);
        // The circles that keep their distance: buttons, then the robot.
        let mut taken: Vec<Circle<f64>, { MAX_BUTTONS + 1 }> = Vec::new();
        let mut buttons: Vec<[f64; 3], MAX_BUTTONS> = Vec::new();
        for _ in 0..count {
            let circle = self.free_circle(TABLE_HEIGHT, self.is_button_free, &taken, rng)?;
            let [x, y] = circle.centre;
            taken.push(circle).map_err(|_| NO_ROOM)?;
            buttons.push([x, y, 0.0]).map_err(|_| NO_ROOM)?;
        }
        let circle = self.free_circle(ZONE_HEIGHT, |_| true, &taken, rng)?;
        taken.push(circle).map_err(|_| NO_ROOM)?;
        let [x, y] = circle.centre;
        let robot = [x, y, self.angle(rng)];
        let stick = self.free_stick(&taken, rng)?;
        let highest = buttons.iter().fold(0.0, |top, [_, y, _]| f64::max(top, *y));
        let holder = holder_under(&stick, highest, rng)?;
        Ok(Arrangement {
            robot,
            stick,
            holder,
            buttons,
        })
    }

    fn angle<G: Rng>(&self, rng: &mut G) -> f64 {
        if self.angles {
            uniform_in(rng, -PI, PI)
        } else {
            UPRIGHT
        }
    }

    /// A stick that meets none of the circles.
    fn free_stick<G: Rng>(&self, taken: &[Circle<f64>], rng: &mut G) -> Result<[f64; 4], Error> {
        for _ in 0..MAX_DRAWS {
            let x = uniform_in(rng, SPACING, self.width - SPACING);
            let y = uniform_in(rng, SPACING, HIGHEST_STICK);
            let stick = [x, y, self.angle(rng), 0.0];
            let shape = stick_shape(&stick);
            if !taken.iter().any(|circle| shape.intersects(circle)) {
                return Ok(stick);
            }
        }
        Err(NO_ROOM)
    }

    /// A circle in the lower part of the table, up to `top`, at a free y, that meets none
    /// of the others.
    fn free_circle<G: Rng>(
        &self,
        top: f64,
        is_free: impl Fn(f64) -> bool,
        taken: &[Circle<f64>],
        rng: &mut G,
    ) -> Result<Circle<f64>, Error> {
        for _ in 0..MAX_DRAWS {
            let x = uniform_in(rng, SPACING, self.width - SPACING);
            let y = uniform_in(rng, SPACING, top - SPACING);
            let circle = Circle {
                centre: [x, y],
                radius: SPACING,
            };
            if is_free(y) && !taken.iter().any(|other| circle.intersects(other)) {
                return Ok(circle);
            }
        }
        Err(NO_ROOM)
    }
}

/// The task to press all buttons of this world.
fn press_all(world: &World<'_>) -> Result<Task, Error> {
    let initial = world.to_state()?;
    let mut goal = Vec::new();
    for button in initial.of_type(BUTTON_TYPE) {
        let atom = GroundAtom {
            predicate: PRESSED,
            objects: Arguments::new([button])?,
        };
        goal.push(atom)
            .map_err(|_| Error::CapacityExceeded("atoms of a goal"))?;
    }
    Ok(Task { initial, goal })
}

/// The pose of a holder under the stick that leaves room for a grasp from which
/// the stick reaches up to `highest`.
fn holder_under<G: Rng>(
    &[x, y, theta, _]: &[f64; 4],
    highest: f64,
    rng: &mut G,
) -> Result<[f64; 3], Error> {
    let reach = highest - ZONE_HEIGHT;
    for _ in 0..MAX_DRAWS {
        let offset = uniform_in(rng, -HOLDER_WIDTH, STICK_WIDTH / 2.0);
        let room_below = offset > 2.0 * ROBOT_RADIUS;
        let room_above = STICK_WIDTH - (offset + HOLDER_WIDTH) > reach;
        if reach < 0.0 || room_below || room_above {
            let across = (STICK_HEIGHT - HOLDER_HEIGHT) / 2.0;
            let [x, y] = Frame2::new([x, y], theta).apply([offset, across]);
            return Ok([x, y, theta]);
        }
    }
    Err(NO_ROOM)
}
