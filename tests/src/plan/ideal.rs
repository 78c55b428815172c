//! What an ideal learner would know of the stick-button environment, upright: the
//! regions in closed form, as a sampler and a guide.

use crate::pick::ENVIRONMENT;
use critreg::Error;
use critreg::env::stick_button::{
    FIRST_BUTTON, HOLDER_WIDTH, PICK_STICK, PLACE_STICK, ROBOT_PRESS_BUTTON, ROBOT_RADIUS,
    STICK_PRESS_BUTTON, STICK_WIDTH, StickButton, TIP_WIDTH, World, ZONE_HEIGHT,
};
use critreg::plan::{Advice, Draw, Drawn, Guide, ReasonId, Sampler, Simulated, Skeleton};
use critreg::random::uniform_in;
use critreg::task::{ControllerId, Environment, GroundOperator, ObjectId, State};
use rand_core::Rng;

/// How many reasons there are.
pub const REASONS: usize = 2;
/// A button is out of reach of the hand.
pub const OUT_OF_REACH: ReasonId = ReasonId(0);
/// No grasp is good for the pick and all presses with the stick that follow.
pub const NO_GRASP: ReasonId = ReasonId(1);

/// The highest y of the robot's centre.
const TOP: f64 = ZONE_HEIGHT - ROBOT_RADIUS;
/// How far from the boundaries grasps are drawn, if there is room: the tolerance of
/// picks.
const MARGIN: f64 = 0.032;

/// The stick is always picked where it lies in the beginning.
#[derive(Clone, Copy, Debug)]
pub struct Ideal<'a> {
    /// The initial state.
    pub initial: &'a State,
}

impl Ideal<'_> {
    /// The intervals of mu for a pick with the operators that follow it, and their
    /// length.
    fn grasps(&self, later: Skeleton<'_>, margin: f64) -> Option<([[f64; 2]; 2], f64)> {
        let world = World::of(self.initial)?;
        let ([_, stick, ..], [_, holder, _]) = (*world.stick, *world.holder);
        let centre = holder + HOLDER_WIDTH / 2.0;
        // In y of the grasp.
        let (mut low, mut high) = (stick, f64::min(stick + STICK_WIDTH, TOP) - margin);
        for operator in later.iter() {
            let controller = controller(operator);
            if controller == Some(PLACE_STICK) {
                break;
            }
            if controller == Some(STICK_PRESS_BUTTON) {
                let [_, y, _] = button(self.initial, operator.objects.as_slice().get(2)?)?;
                let reach = STICK_WIDTH - TIP_WIDTH;
                high = high.min(TOP + reach - y + stick - margin);
                low = low.max(ROBOT_RADIUS + reach - y + stick + margin);
            }
        }
        let clearance = HOLDER_WIDTH / 2.0 + ROBOT_RADIUS + margin;
        let parts = [
            [low, high.min(centre - clearance)],
            [low.max(centre + clearance), high],
        ];
        let parts = parts.map(|part| part.map(|y| (y - stick) / STICK_WIDTH));
        Some((parts, parts.into_iter().map(length).sum()))
    }
}

fn controller(operator: &GroundOperator) -> Option<ControllerId> {
    let operators = StickButton::OPERATORS;
    let operator = operators.get(usize::from(operator.operator.0))?;
    Some(operator.controller)
}

fn button<'s>(state: &'s State, object: &ObjectId) -> Option<&'s [f64; 3]> {
    let place = object.0.checked_sub(FIRST_BUTTON.0)?;
    World::of(state)?.buttons.get(usize::from(place))
}

fn length([low, high]: [f64; 2]) -> f64 {
    f64::max(high - low, 0.0)
}

impl<'w> Sampler<Simulated<'w, StickButton>> for Ideal<'_> {
    fn sample<R: Rng>(&mut self, draw: &Draw<'_, State>, rng: &mut R) -> Result<Drawn, Error> {
        if controller(draw.operator) != Some(PICK_STICK) {
            let (operator, objects) = (draw.operator.operator, draw.operator.objects);
            let drawn = ENVIRONMENT.sample(operator, draw.state, objects.as_slice(), rng);
            return Ok(Drawn::Parameters(drawn));
        }
        let later = draw.skeleton.from(draw.step + 1);
        let found = [MARGIN, 0.0].map(|margin| self.grasps(later, margin));
        let room = |(_, length): &([[f64; 2]; 2], f64)| *length > 0.0;
        let Some(([first, second], total)) = found.into_iter().flatten().find(room) else {
            return Ok(Drawn::Empty(NO_GRASP));
        };
        let along = uniform_in(rng, 0.0, total);
        let mu = if along < length(first) {
            first[0] + along
        } else {
            second[0] + along - length(first)
        };
        Ok(Drawn::Informed([mu].into_iter().collect()))
    }
}

impl Guide for Ideal<'_> {
    fn judge(&mut self, prefix: Skeleton<'_>) -> Advice {
        let Some(last) = prefix.iter().next_back() else {
            return Advice::Keep;
        };
        let pressed = last.objects.as_slice().get(1);
        let by_hand = controller(last) == Some(ROBOT_PRESS_BUTTON);
        let button = pressed
            .filter(|_| by_hand)
            .and_then(|b| button(self.initial, b));
        if button.is_some_and(|[_, y, _]| *y > TOP) {
            return Advice::Postpone(OUT_OF_REACH);
        }
        // The last pick, with what follows it.
        let picks = |step: &usize| prefix.get(*step).and_then(controller) == Some(PICK_STICK);
        let Some(pick) = (0..prefix.len()).rev().find(picks) else {
            return Advice::Keep;
        };
        match self.grasps(prefix.from(pick + 1), 0.0) {
            Some((_, 0.0)) => Advice::Postpone(NO_GRASP),
            _ => Advice::Keep,
        }
    }
}
