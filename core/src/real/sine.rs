//! Sine and cosine in single precision.
//!
//! `libm` computes those of an `f32` in `f64`, which is a thousand instructions on a
//! microcontroller without double precision, and dearer than all else of a draw. Only
//! products and sums are used here, each rounded, so every target gets the same bytes.

/// Angles up to here are reduced with a number of quarter turns below 256, whose
/// products with the first two parts of a quarter turn are exact.
const LARGEST: f32 = 400.0;

/// A quarter turn in three parts (Cody and Waite 1980): the first two have 16 bits.
const QUARTER_TURN: [f32; 3] = [1.570_800_8, -4.454_399_5e-6, -5.564_431_6e-11];

/// Sine and cosine of an angle in radians, within 2.5 units in the last place.
pub(super) fn sin_cos(angle: f32) -> (f32, f32) {
    // So is NaN.
    if !(-LARGEST..=LARGEST).contains(&angle) {
        return libm::sincosf(angle);
    }
    let half = if angle < 0.0 { -0.5 } else { 0.5 };
    let quarters = (angle * core::f32::consts::FRAC_2_PI + half) as i32;
    let count = quarters as f32;
    let [first, second, third] = QUARTER_TURN;
    let rest = angle - count * first - count * second - count * third;
    let (sine, cosine) = (sine(rest), cosine(rest));
    match quarters & 3 {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}

/// For an angle of at most an eighth of a turn; the polynomial is that of Cephes
/// (Moshier 1992), as is the one of the cosine.
fn sine(angle: f32) -> f32 {
    let square = angle * angle;
    let tail = (-1.951_529_6e-4 * square + 8.332_161e-3) * square - 1.666_665_5e-1;
    angle + angle * (square * tail)
}

fn cosine(angle: f32) -> f32 {
    let square = angle * angle;
    let tail = (2.443_315_7e-5 * square - 1.388_731_6e-3) * square + 4.166_664_6e-2;
    1.0 - 0.5 * square + square * square * tail
}
