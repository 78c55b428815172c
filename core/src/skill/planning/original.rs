//! Draws of the original sampler: the environment's own one, which knows of no regions.

use crate::region::Theta;
use crate::skill::setting::Setting;
use crate::task::{GroundOperator, Parameters, State};
use rand_core::Rng;

/// These first parameters, and behind them those of the original sampler.
pub(in crate::skill) fn completed<R: Rng, const N: usize>(
    setting: &impl Setting,
    ground: &GroundOperator<N>,
    state: &State,
    first: &[f64],
    rng: &mut R,
) -> Parameters {
    let objects = ground.objects.as_slice();
    let mut parameters = setting.draw(ground.operator, state, objects, rng);
    for (value, given) in parameters.iter_mut().zip(first) {
        *value = *given;
    }
    parameters
}

/// Parameters of the original sampler, as a sample of a learner.
pub(in crate::skill) fn proposal<R: Rng>(
    setting: &impl Setting,
    ground: &GroundOperator,
    state: &State,
    rng: &mut R,
) -> Theta {
    let drawn = setting.draw(ground.operator, state, ground.objects.as_slice(), rng);
    let mut theta = Theta::default();
    for (value, drawn) in theta.iter_mut().zip(&drawn) {
        *value = *drawn;
    }
    theta
}
