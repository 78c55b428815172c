//! The cluttered-table environments: to grasp one can among others.
//!
//! Cans stand on a table, seen from above; all lengths are in the unit of its side,
//! and commands stay in the unit square. One command is one straight approach from a
//! start to an end point, which grasps the can that the end lies in. It collides with
//! every other can that lies too much in its direction: if, at the end, the approach
//! and the way from that can to the end make an angle of less than a quarter of pi.
//! How far away a can is does not matter, nor on which side of the start it stands.
//! Cans in the way are moved first, of which there are two variants:
//!
//! - [`ClutteredTable`]: a held can is dumped, and then is gone. Many cans stand at
//!   random; from some directions a can is free, from others it is not.
//! - [`ClutteredTablePlace`]: a held can is placed somewhere else, by an approach that
//!   must not collide either. The one other can stands just in the way.
//!
//! # In closed form
//!
//! With s the start and e the end of an approach, c the can it is about, and o any
//! other can that is not trashed, a controller's parameters (s, e) do what they shall
//! if, for every o, (e - s) (e - o) <= |e - s| |e - o| / sqrt(2); and for a grasp
//! |e - c| < r as well, while e is in no other can, and (in the first variant) not
//! all parameters are zero. An approach that starts where it ends collides with nothing.
//!
//! # Source
//!
//! The environments `cluttered_table` and `cluttered_table_place` of the Predicators
//! framework, to the last digit and with single precision where it has it; only the
//! task generator's stream of random numbers differs. Two things are said in other words:
//! `Dump` has its can as an object here, though its command is always the same, because
//! what is learned is about objects; and a command on which the framework stops with an
//! assertion (to grasp two cans at once) is a [`Failure`] without a culprit.
//!
//! ```
//! use critreg::task::{Environment, Failure, ObjectId, Verdict, try_operator};
//! use critreg::env::cluttered_table::{ClutteredTablePlace, FIRST_CAN};
//! use critreg::random::generator;
//!
//! let environment = ClutteredTablePlace;
//! let task = environment.task(&mut generator(3))?;
//! let [grasp, _] = ClutteredTablePlace::OPERATORS else { unreachable!() };
//! let [x, y, ..] = *task.initial.get::<5>(FIRST_CAN).unwrap();
//! let approach = |start: [f64; 2]| {
//!     let parameters = [start[0], start[1], x, y];
//!     try_operator(&environment, grasp, &[FIRST_CAN], &parameters, &task.initial)
//! };
//! // Through the other can, which is to blame.
//! let culprit = Some(ObjectId(1));
//! assert_eq!(approach([0.2, 0.1]).verdict, Verdict::Failed(Failure { culprit }));
//! assert!(approach([0.2, 1.0]).is_feasible());
//! # Ok::<(), critreg::Error>(())
//! ```

mod controllers;
mod operators;
mod predicates;
mod sample;
mod simulate;
mod skills;
mod tasks;

pub use controllers::{DUMP, GRASP, PLACE};
pub use predicates::{HAND_EMPTY, HOLDING, UNTRASHED};
pub use tasks::MAX_CANS;

use crate::domain::{Attribute, Dimension};
use crate::task::{
    Controller, Environment, Failure, Naming, ObjectId, ObjectType, Operator, OperatorId,
    Parameters, Predicate, State, TypeId,
};
use rand_core::Rng;

/// Radius of a can.
pub const CAN_RADIUS: f64 = 0.01;
/// Where a trashed can is, along x and along y.
pub const TRASH: f64 = -999.0;

/// Type of the cans.
pub const CAN_TYPE: TypeId = TypeId(0);
/// The first can, which every task is about; the others follow.
pub const FIRST_CAN: ObjectId = ObjectId(0);

/// A command: x and y of the start of an approach, x and y of its end.
pub type Action = [f32; 4];

/// What describes a can: x and y of its centre, radius, grasped, trashed.
pub type Can = [f64; 5];

/// The environment in which a held can is dumped. See the [module](self).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ClutteredTable;

/// The environment in which a held can is placed elsewhere. See the [module](self).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ClutteredTablePlace;

impl Environment for ClutteredTable {
    type Action = Action;

    const TYPES: &'static [ObjectType] = &TYPES;
    const PREDICATES: &'static [Predicate<Self>] = &predicates::predicates();
    const CONTROLLERS: &'static [Controller<Self>] =
        &[controllers::approach("Grasp"), controllers::dump()];
    const OPERATORS: &'static [Operator<'static>] = &[operators::DUMP, operators::GRASP];

    fn simulate(&self, state: &mut State, action: Action) -> Result<(), Failure> {
        simulate::dump_or_grasp(state, action)
    }

    /// As in the framework: a grasp starts anywhere and ends at the can's centre.
    fn sample<G: Rng>(
        &self,
        operator: OperatorId,
        state: &State,
        objects: &[ObjectId],
        rng: &mut G,
    ) -> Parameters {
        sample::controller_of::<Self>(operator)
            .and_then(|controller| sample::from_anywhere(controller, state, objects, rng))
            .unwrap_or_default()
    }
}

impl Environment for ClutteredTablePlace {
    type Action = Action;

    const TYPES: &'static [ObjectType] = &TYPES;
    const PREDICATES: &'static [Predicate<Self>] = &predicates::predicates();
    const CONTROLLERS: &'static [Controller<Self>] = &[
        controllers::approach("Grasp"),
        controllers::approach("Place"),
    ];
    const OPERATORS: &'static [Operator<'static>] = &[operators::GRASP, operators::PLACE];

    fn simulate(&self, state: &mut State, action: Action) -> Result<(), Failure> {
        simulate::place_or_grasp(state, action)
    }

    /// As in the framework, without a draw: every approach starts at the same place.
    /// A grasp ends at the can's centre, a place beside the can that shall be grasped in
    /// the end. Parameters cannot depend on the goal here, but this can is the first
    /// one in every task.
    fn sample<G: Rng>(
        &self,
        operator: OperatorId,
        state: &State,
        objects: &[ObjectId],
        _rng: &mut G,
    ) -> Parameters {
        sample::controller_of::<Self>(operator)
            .and_then(|controller| sample::from_the_front(controller, state, objects))
            .unwrap_or_default()
    }
}

static TYPES: [ObjectType; 1] = [ObjectType {
    name: "can",
    attributes: &[
        Attribute::new("x", Dimension::Length),
        Attribute::new("y", Dimension::Length),
        Attribute::new("radius", Dimension::Length),
        Attribute::new("grasped", Dimension::Flag),
        Attribute::new("trashed", Dimension::Flag),
    ],
    naming: Naming::Numbered("can"),
}];

/// The cans of a state; `None` if it does not belong to these environments.
pub fn cans(state: &State) -> Option<&[Can]> {
    let (cans, []) = state.values().as_chunks() else {
        return None;
    };
    Some(cans)
}

/// Whether a can is held.
fn is_held([_, _, _, grasped, _]: &Can) -> bool {
    *grasped > 0.5
}

/// Whether a can still stands on the table, or is held.
fn is_untrashed([_, _, _, _, trashed]: &Can) -> bool {
    *trashed < 0.5
}
