//! The transition function.

use super::world::{World, are_close, centre, is_free};
use super::{Action, BLOCK_SIZE, Block, LIFT_HEIGHT, PICK_TOLERANCE, ROBOT_TYPE, TABLE_HEIGHT};
use crate::task::{Failure, ObjectId, State};

/// No block is to blame: the state is none of this environment, or the command no
/// numbers.
const NO_OUTCOME: Failure = Failure { culprit: None };

/// What a step changes.
struct Move {
    block: ObjectId,
    /// Where the block is afterwards.
    to: [f64; 3],
    /// Whether it is held there; the fingers are open if not.
    held: bool,
}

/// One step. A command that cannot be carried out changes nothing; the robot's
/// place never changes.
pub(super) fn simulate(state: &mut State, action: Action) -> Result<(), Failure> {
    match decide(state, action)? {
        Some(step) => carry_out(state, &step).ok_or(NO_OUTCOME),
        None => Ok(()),
    }
}

/// What the command does, if anything.
fn decide(state: &State, action: Action) -> Result<Option<Move>, Failure> {
    let world = World::of(state).ok_or(NO_OUTCOME)?;
    let is_open = world.is_open().ok_or(NO_OUTCOME)?;
    if !action.iter().all(|number| number.is_finite()) {
        return Err(NO_OUTCOME);
    }
    let [x, y, z, fingers] = action.map(f64::from);
    let place = [x, y, z];
    let closes = fingers < 0.5;
    // Fingers that are as commanded do nothing.
    if closes != is_open {
        return Ok(None);
    }
    if closes {
        return Ok(pick(&world, place));
    }
    let (held, _) = world.held().ok_or(NO_OUTCOME)?;
    Ok(if z < TABLE_HEIGHT + BLOCK_SIZE {
        put_on_table(&world, held, place)
    } else {
        stack(&world, held, place)
    })
}

/// Lifts the block that lies there. It gets the command's x and y, not its own.
fn pick(world: &World<'_>, place: [f64; 3]) -> Option<Move> {
    let (block, numbers) = nearest(world, place)?;
    let [x, y, _] = place;
    world.is_clear(block, numbers).then_some(Move {
        block,
        to: [x, y, LIFT_HEIGHT],
        held: true,
    })
}

/// Puts the held block on the table unless that is close to a block: to the held one
/// itself, too, where it was lifted.
fn put_on_table(world: &World<'_>, held: ObjectId, to: [f64; 3]) -> Option<Move> {
    let [x, y, _] = to;
    let taken = world.blocks.iter().map(|[x, y, ..]| [*x, *y]);
    is_free([x, y], taken).then_some(Move {
        block: held,
        to,
        held: false,
    })
}

/// Puts the held block on the highest one below the place.
fn stack(world: &World<'_>, held: ObjectId, place: [f64; 3]) -> Option<Move> {
    let (other, numbers) = highest_below(world, place)?;
    let [x, y, z] = centre(numbers);
    (other != held && world.is_clear(other, numbers)).then_some(Move {
        block: held,
        to: [x, y, z + BLOCK_SIZE],
        held: false,
    })
}

/// The nearest of the blocks at a place; of several the one with the first name.
fn nearest<'a>(world: &World<'a>, place: [f64; 3]) -> Option<(ObjectId, &'a Block)> {
    let there = |block| are_close(place, centre(block), PICK_TOLERANCE);
    let distance_squared = |block: &Block| {
        let differences = place.into_iter().zip(centre(block)).map(|(a, b)| a - b);
        differences.fold(0.0, |sum, difference| sum + difference * difference)
    };
    let blocks = world.named_blocks().filter(|(_, block)| there(*block));
    blocks.reduce(|best, next| {
        let nearer = distance_squared(next.1) < distance_squared(best.1);
        if nearer { next } else { best }
    })
}

/// The highest of the blocks below a place; of several the one with the first name.
fn highest_below<'a>(world: &World<'a>, [x, y, z]: [f64; 3]) -> Option<(ObjectId, &'a Block)> {
    let below = |block: &Block| {
        let [block_x, block_y, block_z] = centre(block);
        let above_it = are_close([x, y], [block_x, block_y], PICK_TOLERANCE);
        above_it && block_z < z - PICK_TOLERANCE
    };
    let height = |block: &Block| {
        let [_, _, z] = centre(block);
        z
    };
    let blocks = world.named_blocks().filter(|(_, block)| below(block));
    blocks.reduce(|best, next| {
        if height(next.1) > height(best.1) {
            next
        } else {
            best
        }
    })
}

fn carry_out(state: &mut State, step: &Move) -> Option<()> {
    let robot = state.of_type(ROBOT_TYPE).next()?;
    let block: &mut Block = state.attributes_mut(step.block)?.try_into().ok()?;
    let [x, y, z, held, ..] = block;
    [*x, *y, *z] = step.to;
    *held = f64::from(step.held);
    let [_, _, _, fingers] = state.attributes_mut(robot)? else {
        return None;
    };
    *fingers = f64::from(!step.held);
    Some(())
}
