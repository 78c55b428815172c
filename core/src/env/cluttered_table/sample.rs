//! The framework's own samplers.

use super::{FIRST_CAN, GRASP, PLACE};
use crate::env::float32;
use crate::random::uniform;
use crate::real::Real;
use crate::task::{ControllerId, Environment, ObjectId, OperatorId, Parameters, State};
use rand_core::Rng;

/// Where approaches start when cans are placed.
const FRONT: [f64; 2] = [0.2, 0.1];
/// How far beside the can that shall be grasped another one is placed.
const BESIDE: f64 = 0.2;
/// The largest x of a can placed to the right of it; beyond, it is placed to the left.
const RIGHTMOST: f64 = 0.4;
/// The y of a can that is placed, as a factor of the y of the can that shall be grasped.
const BEHIND: f64 = 1.1;

/// The controller of an operator.
pub(super) fn controller_of<E: Environment>(
    OperatorId(operator): OperatorId,
) -> Option<ControllerId> {
    let operators = E::OPERATORS;
    Some(operators.get(usize::from(operator))?.controller)
}

/// A grasp that starts anywhere in the unit square.
pub(super) fn from_anywhere<G: Rng>(
    controller: ControllerId,
    state: &State,
    objects: &[ObjectId],
    rng: &mut G,
) -> Option<Parameters> {
    match (controller, objects) {
        (GRASP, [can]) => {
            let start = [uniform(rng), uniform(rng)];
            approach(start, position(state, *can)?)
        }
        _ => None,
    }
}

/// A grasp or place that starts in front.
pub(super) fn from_the_front(
    controller: ControllerId,
    state: &State,
    objects: &[ObjectId],
) -> Option<Parameters> {
    match (controller, objects) {
        (GRASP, [can]) => approach(FRONT, position(state, *can)?),
        (PLACE, [_]) => {
            let [x, y] = position(state, FIRST_CAN)?;
            let right = x + BESIDE;
            let beside = if right > RIGHTMOST { x - BESIDE } else { right };
            approach(FRONT, [beside, y * BEHIND])
        }
        _ => None,
    }
}

fn position(state: &State, can: ObjectId) -> Option<[f64; 2]> {
    let [x, y, ..] = *state.get::<5>(can)?;
    Some([x, y])
}

/// The parameters of an approach, kept within the parameter space.
fn approach([start_x, start_y]: [f64; 2], [end_x, end_y]: [f64; 2]) -> Option<Parameters> {
    let numbers = [start_x, start_y, end_x, end_y];
    let parameters = numbers.map(|number| Real::clamp(number, 0.0, 1.0));
    Parameters::from_slice(&parameters).ok().map(float32::drawn)
}
