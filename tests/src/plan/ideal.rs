//! What an ideal learner would know of the stick-button environment, upright: the
//! regions in closed form, as a sampler and a guide.

use crate::pick::ENVIRONMENT;
use critreg::Error;
use critreg::domain::{Environment, GroundOperator, State};
use critreg::env::stick_button::{
    BUTTON_RADIUS, FIRST_BUTTON, HOLDER_WIDTH, PICK_STICK, PLACE_STICK, ROBOT_PRESS_BUTTON,
    ROBOT_RADIUS, STICK_PRESS_BUTTON, STICK_WIDTH, StickButton, TIP_WIDTH, World, ZONE_HEIGHT,
};
use critreg::plan::{Advice, Draw, Drawn, Guide, ReasonId, Sampler, Simulated, Skeleton};
use critreg::random::uniform_in;
use rand_core::Rng;

/// How many reasons there are.
pub const REASONS: usize = 2;
/// A button is out of reach of the hand.
pub const OUT_OF_REACH: ReasonId = ReasonId(0);
/// No grasp is good for the pick and all presses with the stick that follow.
pub const NO_GRASP: ReasonId = ReasonId(1);

/// The highest y of the robot's centre.
const TOP: f64 = ZONE_HEIGHT - ROBOT_RADIUS;
/// A press by hand certainly fails from here on: robot and button would not meet.
const HAND_TOP: f64 = TOP + ROBOT_RADIUS + BUTTON_RADIUS;
/// How far from the boundaries grasps are drawn: more than the tolerance of picks.
const MARGIN: f64 = 0.04;

/// The stick is always picked where it lies in the beginning.
#[derive(Clone, Copy, Debug)]
pub struct Ideal<'a> {
    /// The initial state.
    pub initial: &'a State,
    /// Postpones instead of pruning.
    pub lenient: bool,
}

impl Ideal<'_> {
    /// The intervals of mu for a pick with the operators that follow it.
    fn grasps<'s>(&self, later: impl Iterator<Item = &'s GroundOperator>) -> Option<[[f64; 2]; 2]> {
        let world = World::of(self.initial)?;
        let ([_, stick, ..], [_, holder, _]) = (*world.stick, *world.holder);
        let centre = holder + HOLDER_WIDTH / 2.0;
        // In y of the grasp.
        let (mut low, mut high) = (stick, f64::min(stick + STICK_WIDTH, TOP) - MARGIN);
        for operator in later {
            let controller = controller(operator);
            if controller == Some(PLACE_STICK) {
                break;
            }
            if controller == Some(STICK_PRESS_BUTTON) {
                let [_, y, _] = button(self.initial, operator.objects.as_slice().get(2)?)?;
                let reach = STICK_WIDTH - TIP_WIDTH;
                high = high.min(TOP + reach - y + stick - MARGIN);
                low = low.max(ROBOT_RADIUS + reach - y + stick + MARGIN);
            }
        }
        let clearance = HOLDER_WIDTH / 2.0 + ROBOT_RADIUS + MARGIN;
        let parts = [
            [low, high.min(centre - clearance)],
            [low.max(centre + clearance), high],
        ];
        Some(parts.map(|part| part.map(|y| (y - stick) / STICK_WIDTH)))
    }
}

fn controller(operator: &GroundOperator) -> Option<critreg::domain::ControllerId> {
    let operators = ENVIRONMENT.operators();
    let operator = operators.get(usize::from(operator.operator.0))?;
    Some(operator.controller)
}

fn button<'s>(state: &'s State, object: &critreg::domain::ObjectId) -> Option<&'s [f64; 3]> {
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
        let parts = self.grasps(draw.skeleton.from(draw.step + 1).iter());
        let [first, second] = parts.ok_or(Error::Mismatch("no state of this environment"))?;
        if length(first) + length(second) == 0.0 {
            return Ok(Drawn::Empty(NO_GRASP));
        }
        let along = uniform_in(rng, 0.0, length(first) + length(second));
        let mu = if along < length(first) {
            first[0] + along
        } else {
            second[0] + along - length(first)
        };
        Ok(Drawn::Parameters([mu as f32].into_iter().collect()))
    }
}

impl Guide for Ideal<'_> {
    fn judge(&mut self, prefix: Skeleton<'_>) -> Advice {
        let against = |reason| {
            if self.lenient {
                Advice::Postpone(reason)
            } else {
                Advice::Prune(reason)
            }
        };
        let Some(last) = prefix.iter().next_back() else {
            return Advice::Keep;
        };
        let pressed = last.objects.as_slice().get(1);
        let by_hand = controller(last) == Some(ROBOT_PRESS_BUTTON);
        let button = pressed
            .filter(|_| by_hand)
            .and_then(|b| button(self.initial, b));
        if button.is_some_and(|[_, y, _]| *y >= HAND_TOP) {
            return against(OUT_OF_REACH);
        }
        // The last pick, with what follows it.
        let picks = |step: &usize| prefix.get(*step).and_then(controller) == Some(PICK_STICK);
        let Some(pick) = (0..prefix.len()).rev().find(picks) else {
            return Advice::Keep;
        };
        match self.grasps(prefix.from(pick + 1).iter()) {
            Some([a, b]) if length(a) + length(b) == 0.0 => against(NO_GRASP),
            _ => Advice::Keep,
        }
    }
}
