/// What is computed with.
pub type Real = f64;

const SQRT_EPSILON: Real = 1.0 / 67_108_864.0;

fn abs(value: Real) -> Real {
    libm::fabs(value)
}

fn sqrt(value: Real) -> Real {
    libm::sqrt(value)
}

fn atan2(y: Real, x: Real) -> Real {
    libm::atan2(y, x)
}

fn sin_cos(angle: Real) -> (Real, Real) {
    libm::sincos(angle)
}

