//! Single precision, in which the Predicators framework has parameters.
//!
//! The environments that were recorded from it round what they draw and what they read,
//! and so replay it to the last bit. The rest of the library hands on doubles as they are.

use crate::task::{self, Environment, OperatorId, Parameters};
use rand_core::Rng;

/// A parameter as the framework reads it.
pub(super) fn read(parameter: f64) -> f32 {
    parameter as f32
}

/// Parameters as the framework draws them.
pub(super) fn drawn(mut parameters: Parameters) -> Parameters {
    for parameter in &mut parameters {
        *parameter = f64::from(read(*parameter));
    }
    parameters
}

/// Parameters uniform over the space of an operator's controller, as the framework draws them.
pub(super) fn sample_uniform<E: Environment>(
    operator: OperatorId,
    rng: &mut impl Rng,
) -> Parameters {
    drawn(task::sample_uniform::<E>(operator, rng))
}
