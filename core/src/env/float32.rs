//! Single precision, in which the Predicators framework has parameters.
//!
//! The environments that were recorded from it round what they draw and what they read,
//! and so replay it to the last bit. The rest of the library hands on doubles as they are.

use crate::task::Parameters;

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
