/// What is computed with.
pub type Real = f32;

const SQRT_EPSILON: Real = 3.452_669_8e-4;

fn abs(value: Real) -> Real {
    libm::fabsf(value)
}

fn sqrt(value: Real) -> Real {
    libm::sqrtf(value)
}

fn atan2(y: Real, x: Real) -> Real {
    libm::atan2f(y, x)
}

use sine::sin_cos;

