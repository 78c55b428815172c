//! Random tasks: press all buttons.

use super::world::World;
use super::{BUTTON_TYPE, PRESSED, StickButtonMove, TABLE_WIDTH};
use crate::env::stick_button::tasks::{SPACING, Table};
use crate::env::stick_button::world::{stick_shape, tip_shape};
use crate::env::stick_button::{UPRIGHT, ZONE_HEIGHT};
use crate::error::Error;
use crate::real::Real;
use crate::task::{Arguments, GroundAtom, Task};
use core::ops::RangeInclusive;
use rand_core::Rng;

impl StickButtonMove {
    /// A random task with a number of buttons drawn from `buttons`: one or two for training
    /// in the framework, three or four for its tests.
    ///
    /// Everything lies as in a task of
    /// [`StickButton`](crate::env::stick_button::StickButton), but that buttons keep away
    /// from the border of the reachable zone, too.
    ///
    /// # Errors
    /// Those of [`StickButton::arrange`](crate::env::stick_button::StickButton::arrange);
    /// the table is smaller, and too small for many buttons.
    pub fn task<G: Rng>(&self, buttons: RangeInclusive<usize>, rng: &mut G) -> Result<Task, Error> {
        let table = Table {
            width: TABLE_WIDTH,
            is_button_free: |y| Real::abs(y - ZONE_HEIGHT) > SPACING,
            angles: false,
        };
        let arrangement = table.arrange(buttons, rng)?;
        let world = arrangement.world();
        let ([x, y, _], [stick_x, stick_y, _, held]) = (*world.robot, *world.stick);
        let [tip_x, tip_y] = tip_shape(&stick_shape(world.stick)).frame.origin();
        press_all(&World {
            buttons: world.buttons,
            holder: world.holder,
            robot: &[x, y, UPRIGHT, 1.0],
            stick: &[stick_x, stick_y, tip_x, tip_y, UPRIGHT, held],
        })
    }
}

/// The task to press all buttons of this world.
fn press_all(world: &World<'_>) -> Result<Task, Error> {
    let initial = world.to_state()?;
    let mut goal = heapless::Vec::new();
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
