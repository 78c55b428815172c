//! What controllers and samplers of the family share.

use super::Action;
use super::world::{Block, Target, around};
use crate::env::float32;
use crate::random::uniform_in;
use crate::real::Real;
use crate::task::{
    Controller, ControllerId, Environment, ObjectId, OperatorId, Parameters, State, Terminal,
    TypeId, always,
};
use rand_core::Rng;

/// Where one can click.
const SPACE: [f64; 2] = [0.0, 1.0];

/// A controller that clicks once, at its parameter.
pub(super) const fn controller<E: Environment<Action = Action>>(
    name: &'static str,
    arguments: &'static [TypeId],
) -> Controller<E> {
    Controller {
        name,
        arguments,
        parameters: &[SPACE],
        initiable: always,
        // Without a parameter it clicks nowhere, which does nothing.
        policy: |_, _, _, parameters| {
            parameters
                .first()
                .map_or(Action::NAN, |p| float32::read(*p))
        },
        terminal: Terminal::FirstAction,
    }
}

/// The parameters of an operator: where `draw` clicks for its controller, its block and
/// its target, kept within the parameter space. No parameters where it clicks nowhere.
pub(super) fn parameters<E: Environment>(
    OperatorId(operator): OperatorId,
    state: &State,
    objects: &[ObjectId],
    draw: impl FnOnce(ControllerId, Block, Option<Target>) -> Option<f64>,
) -> Parameters {
    let click = || {
        let controller = E::OPERATORS.get(usize::from(operator))?.controller;
        let block = Block::read(state, *objects.first()?)?;
        let target = objects
            .get(1)
            .and_then(|target| Target::read(state, *target));
        draw(controller, block, target)
    };
    let [low, high] = SPACE;
    let click = click().map(|click| Real::clamp(click, low, high));
    float32::drawn(click.into_iter().collect())
}

/// Draws where to pick a block: anywhere on it.
pub(super) fn sample_pick(block: &Block, rng: &mut impl Rng) -> f64 {
    let [low, high] = SPACE;
    let (left, right) = block.extent().into_inner();
    uniform_in(rng, Real::max(low, left), Real::min(high, right))
}

/// Draws where to put a block down: on the fifth about the centre of a target,
/// wherever the block is held.
pub(super) fn sample_place(target: &Target, rng: &mut impl Rng) -> f64 {
    let (left, right) = around(target.pose, target.width / 10.0).into_inner();
    uniform_in(rng, left, right)
}
