//! The transition functions.

use super::controllers::DUMP_COMMAND;
use super::{Action, Can, TRASH, cans, is_held, is_untrashed};
use crate::geometry::distance;
use crate::task::{Failure, ObjectId, State};
use core::f64::consts::FRAC_1_SQRT_2;

/// No can is to blame: the state is none of these environments, or the command
/// one that it has no outcome for.
const NO_OUTCOME: Failure = Failure { culprit: None };

/// One step of the environment with a trash.
pub(super) fn dump_or_grasp(state: &mut State, action: Action) -> Result<(), Failure> {
    match (held(state)?, action == DUMP_COMMAND) {
        (Some(can), true) => {
            let [x, y, _, grasped, trashed] = can_mut(state, can)?;
            [*x, *y, *grasped, *trashed] = [TRASH, TRASH, 0.0, 1.0];
            Ok(())
        }
        (None, false) => grasp(state, action),
        // There is nothing to dump, or no hand to grasp with.
        (None, true) | (Some(_), false) => Ok(()),
    }
}

/// One step of the environment without a trash.
pub(super) fn place_or_grasp(state: &mut State, action: Action) -> Result<(), Failure> {
    match held(state)? {
        Some(can) => place(state, can, action),
        None => grasp(state, action),
    }
}

/// The can that is held.
fn held(state: &State) -> Result<Option<ObjectId>, Failure> {
    let cans = cans(state).ok_or(NO_OUTCOME)?;
    let mut held = with_ids(cans).filter(|(_, can)| is_held(can));
    match (held.next(), held.next()) {
        (None, _) => Ok(None),
        (Some((id, can)), None) if is_untrashed(can) => Ok(Some(id)),
        _ => Err(NO_OUTCOME),
    }
}

/// Grasps the can that the approach ends in; without one nothing happens.
fn grasp(state: &mut State, approach: Action) -> Result<(), Failure> {
    let cans = cans(state).ok_or(NO_OUTCOME)?;
    let end = end_of(approach)?;
    let Some(target) = can_at(cans, end)? else {
        return Ok(());
    };
    check_approach(cans, target, approach, end)?;
    let [_, _, _, grasped, _] = can_mut(state, target)?;
    *grasped = 1.0;
    Ok(())
}

/// The can that a point lies in.
fn can_at(cans: &[Can], point: [f64; 2]) -> Result<Option<ObjectId>, Failure> {
    let mut around = with_ids(cans).filter(|(_, can)| {
        let [_, _, radius, _, _] = **can;
        distance(point, centre(can)) < radius
    });
    match (around.next(), around.next()) {
        (None, _) => Ok(None),
        (Some((can, _)), None) => Ok(Some(can)),
        (Some(_), Some(_)) => Err(NO_OUTCOME),
    }
}

/// Places the held can where the approach ends, be that in another can.
fn place(state: &mut State, held: ObjectId, approach: Action) -> Result<(), Failure> {
    let cans = cans(state).ok_or(NO_OUTCOME)?;
    let end = end_of(approach)?;
    check_approach(cans, held, approach, end)?;
    let [x, y, _, grasped, _] = can_mut(state, held)?;
    [*x, *y] = end;
    *grasped = 0.0;
    Ok(())
}

/// Whether the approach collides with no can but the one it is about. Of several
/// the one farthest from its end is to blame, then the one with the first name.
///
/// The framework compares the angle with a quarter of pi. Its cosine exceeds
/// 1/sqrt(2) exactly when the angle is smaller, rounding included, and needs no arc
/// cosine. Where the angle is undefined, at an approach without length or a can that
/// stands at the end, neither comparison holds.
fn check_approach(
    cans: &[Can],
    about: ObjectId,
    [start_x, start_y, end_x, end_y]: Action,
    [to_x, to_y]: [f64; 2],
) -> Result<(), Failure> {
    // The command is in single precision, and so are its differences and length.
    let [along_x, along_y] = [end_x - start_x, end_y - start_y].map(f64::from);
    let length = f64::from(distance([start_x, start_y], [end_x, end_y]));
    let mut farthest = None;
    for (id, can) in with_ids(cans).filter(|(id, can)| *id != about && is_untrashed(can)) {
        let [x, y] = centre(can);
        let away = distance([to_x, to_y], [x, y]);
        let dot = along_x * (to_x - x) + along_y * (to_y - y);
        let cosine = dot / (length * away);
        if cosine > FRAC_1_SQRT_2 && farthest.is_none_or(|(_, most)| away > most) {
            farthest = Some((id, away));
        }
    }
    match farthest {
        Some((can, _)) => Err(Failure { culprit: Some(can) }),
        None => Ok(()),
    }
}

/// Where an approach ends, in double precision.
fn end_of(approach: Action) -> Result<[f64; 2], Failure> {
    let [_, _, x, y] = approach;
    if approach.iter().all(|number| number.is_finite()) {
        Ok([x, y].map(f64::from))
    } else {
        Err(NO_OUTCOME)
    }
}

/// The cans are all objects there are.
fn with_ids(cans: &[Can]) -> impl Iterator<Item = (ObjectId, &Can)> {
    (0..).map(ObjectId).zip(cans)
}

fn centre(&[x, y, ..]: &Can) -> [f64; 2] {
    [x, y]
}

fn can_mut(state: &mut State, can: ObjectId) -> Result<&mut Can, Failure> {
    let attributes = state.attributes_mut(can).ok_or(NO_OUTCOME)?;
    attributes.try_into().map_err(|_| NO_OUTCOME)
}

#[cfg(test)]
mod tests {
    use super::FRAC_1_SQRT_2;
    use core::f64::consts::FRAC_PI_4;

    #[test]
    fn the_cosine_exceeds_its_limit_exactly_when_the_angle_is_smaller() {
        for step in -1000_i64..=1000 {
            let cosine = f64::from_bits(FRAC_1_SQRT_2.to_bits().wrapping_add_signed(step));
            let angle = libm::acos(cosine);
            assert_eq!(angle < FRAC_PI_4, cosine > FRAC_1_SQRT_2, "step {step}");
        }
    }
}
