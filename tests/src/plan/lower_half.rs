//! The region that the thesis learned.

use critreg::Error;
use critreg::env::stick_button::{PICK_STICK, StickButton};
use critreg::plan::{Draw, Drawn, Sampler, Simulated};
use critreg::task::{Environment, State};
use rand_core::Rng;

/// Draws grasps from mu <= 0.5, all else as the original sampler.
#[derive(Clone, Copy, Debug)]
pub struct LowerHalf<'a>(pub Simulated<'a, StickButton>);

impl<'a> Sampler<Simulated<'a, StickButton>> for LowerHalf<'a> {
    fn sample<R: Rng>(&mut self, draw: &Draw<'_, State>, rng: &mut R) -> Result<Drawn, Error> {
        let drawn = self.0.sample(draw, rng)?;
        let operators = StickButton::OPERATORS;
        let operator = &operators[usize::from(draw.operator.operator.0)];
        let Drawn::Parameters(mut drawn) = drawn else {
            return Ok(drawn);
        };
        if operator.controller == PICK_STICK {
            // Half of a uniform number, exactly.
            drawn.iter_mut().for_each(|mu| *mu *= 0.5);
        }
        Ok(Drawn::Parameters(drawn))
    }
}
