//! Ranges that are rounded outward: whatever real numbers go in, the result is inside.
//!
//! Sums, products and roots of `f64` are the nearest number there is (IEEE 754), so the next
//! one up or down is a bound. Of sines, cosines and arc tangents it is assumed that `libm` is
//! less than [`TRUSTED`] off, which is four units in the last place of the largest of them.

use crate::domain::Range;
use crate::real::Real;
use core::f64::consts::{FRAC_PI_2, PI, TAU};

/// By how much a sine, a cosine or an angle of `libm` is off at most.
pub(super) const TRUSTED: f64 = 4.0 * f64::EPSILON * PI;

/// Beyond this angle nothing is said of sines: quarter turns are not told apart.
const LARGEST_ANGLE: f64 = 1e6;

/// How near a sine's extreme an end of a range counts as beyond it.
const NEAR: f64 = 1e-9;

pub(super) const EVERYTHING: Range<f64> = Range {
    low: -f64::INFINITY,
    high: f64::INFINITY,
};

pub(super) const fn range(low: f64, high: f64) -> Range<f64> {
    Range { low, high }
}

pub(super) const fn point(value: f64) -> Range<f64> {
    range(value, value)
}

/// A sum and what rounding has left out of it (Knuth 1969); where that is no number, so is it.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let own = sum - a;
    (sum, (a - (sum - own)) + (b - own))
}

fn sum_down(a: f64, b: f64) -> f64 {
    let (sum, left_out) = two_sum(a, b);
    match left_out >= 0.0 {
        true => sum,
        false if sum.is_nan() => -f64::INFINITY,
        false => sum.next_down(),
    }
}

fn sum_up(a: f64, b: f64) -> f64 {
    -sum_down(-a, -b)
}

/// Products up to here lose no digits at the lower end of what numbers there are.
const SMALLEST_PRODUCT: f64 = 1e-280;

/// Whether a product is not rounded (Dekker 1971). "No" may be wrong.
pub(super) fn is_exact_product(a: f64, b: f64) -> bool {
    let plain = |x: f64| x == 0.0 || x == 1.0 || x == -1.0;
    if plain(a) || plain(b) {
        return true;
    }
    // The upper and the lower half of the digits.
    let split = |x: f64| {
        let scaled = 134_217_729.0 * x;
        let upper = scaled - (scaled - x);
        (upper, x - upper)
    };
    let product = a * b;
    let ((a1, a2), (b1, b2)) = (split(a), split(b));
    let left_out = a2 * b2 - (((product - a1 * b1) - a2 * b1) - a1 * b2);
    product.abs() > SMALLEST_PRODUCT && left_out == 0.0
}

/// A product, and whether it is exact. Zero times whatever there is is zero.
fn factor(a: f64, b: f64) -> (f64, bool) {
    match a == 0.0 || b == 0.0 {
        true => (0.0, true),
        false => (a * b, is_exact_product(a, b)),
    }
}

pub(super) fn plus(a: Range<f64>, b: Range<f64>) -> Range<f64> {
    range(sum_down(a.low, b.low), sum_up(a.high, b.high))
}

pub(super) fn negative(a: Range<f64>) -> Range<f64> {
    range(-a.high, -a.low)
}

pub(super) fn minus(a: Range<f64>, b: Range<f64>) -> Range<f64> {
    plus(a, negative(b))
}

pub(super) fn times(a: Range<f64>, b: Range<f64>) -> Range<f64> {
    let ends = [
        (a.low, b.low),
        (a.low, b.high),
        (a.high, b.low),
        (a.high, b.high),
    ];
    let mut product = range(f64::INFINITY, -f64::INFINITY);
    for (a, b) in ends {
        let (value, is_exact) = factor(a, b);
        let (low, high) = match is_exact {
            true => (value, value),
            false => (value.next_down(), value.next_up()),
        };
        product = range(product.low.min(low), product.high.max(high));
    }
    product
}

/// All quotients; everything, if the divisor may be zero.
pub(super) fn quotient(a: Range<f64>, b: Range<f64>) -> Range<f64> {
    if b.low <= 0.0 && b.high >= 0.0 {
        return EVERYTHING;
    }
    let inverse = range((1.0 / b.high).next_down(), (1.0 / b.low).next_up());
    times(a, inverse)
}

pub(super) fn magnitude(a: Range<f64>) -> Range<f64> {
    let (low, high) = (a.low.abs(), a.high.abs());
    let crosses = a.low <= 0.0 && a.high >= 0.0;
    range(if crosses { 0.0 } else { low.min(high) }, low.max(high))
}

pub(super) fn square(a: Range<f64>) -> Range<f64> {
    let own = magnitude(a);
    let square = times(own, own);
    range(square.low.max(0.0), square.high)
}

pub(super) fn root(a: Range<f64>) -> Range<f64> {
    let root = |x: f64| match x > 0.0 {
        true => Real::sqrt(x),
        false => 0.0,
    };
    let (low, high) = (root(a.low), root(a.high));
    range(low.next_down().max(0.0), high.next_up())
}

pub(super) fn least(a: Range<f64>, b: Range<f64>) -> Range<f64> {
    range(a.low.min(b.low), a.high.min(b.high))
}

pub(super) fn greatest(a: Range<f64>, b: Range<f64>) -> Range<f64> {
    range(a.low.max(b.low), a.high.max(b.high))
}

pub(super) fn sine(a: Range<f64>) -> Range<f64> {
    periodic(a, FRAC_PI_2, |x| Real::sin_cos(x).0)
}

pub(super) fn cosine(a: Range<f64>) -> Range<f64> {
    periodic(a, 0.0, |x| Real::sin_cos(x).1)
}

/// The range of a sine whose greatest value is at an angle.
fn periodic(a: Range<f64>, top: f64, value: impl Fn(f64) -> f64) -> Range<f64> {
    if !(a.low >= -LARGEST_ANGLE && a.high <= LARGEST_ANGLE) {
        return range(-1.0, 1.0);
    }
    // Whether an angle, or one that is turned on by full turns, is in the range.
    let passes = |angle: f64| {
        let turns = Real::floor((a.high + NEAR - angle) / TAU);
        angle + turns * TAU >= a.low - NEAR
    };
    let (first, last) = (value(a.low), value(a.high));
    let low = match passes(top - PI) {
        true => -1.0,
        false => (first.min(last) - TRUSTED).max(-1.0),
    };
    let high = match passes(top) {
        true => 1.0,
        false => (first.max(last) + TRUSTED).min(1.0),
    };
    range(low, high)
}

/// The angles of vectors, of their y and x.
pub(super) fn arc_tangent(y: Range<f64>, x: Range<f64>) -> Range<f64> {
    let all = range(-PI - TRUSTED, PI + TRUSTED);
    let straddles = y.low <= 0.0 && y.high >= 0.0;
    // At zero it is anything; across the negative x axis it jumps.
    if x.low <= 0.0 && straddles {
        return match y.low >= 0.0 {
            true => range(-TRUSTED, all.high),
            false => all,
        };
    }
    let corners = [
        (y.low, x.low),
        (y.low, x.high),
        (y.high, x.low),
        (y.high, x.high),
    ];
    let mut angles = range(f64::INFINITY, -f64::INFINITY);
    for (y, x) in corners {
        let angle = Real::atan2(y, x);
        if angle.is_nan() {
            return all;
        }
        angles = range(angles.low.min(angle), angles.high.max(angle));
    }
    range(angles.low - TRUSTED, angles.high + TRUSTED)
}

/// What two ranges have in common; `None` if nothing.
pub(super) fn common(a: Range<f64>, b: Range<f64>) -> Option<Range<f64>> {
    let both = range(a.low.max(b.low), a.high.min(b.high));
    (both.low <= both.high).then_some(both)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Generator, generator};
    use rand_core::Rng;

    fn share(rng: &mut Generator) -> f64 {
        f64::from(rng.next_u32()) / f64::from(u32::MAX)
    }

    fn random_range(rng: &mut Generator) -> Range<f64> {
        let centre = 8.0 * share(rng) - 4.0;
        let half = [0.0, 1e-9, 0.1, 3.0][(rng.next_u32() % 4) as usize] * share(rng);
        range(centre - half, centre + half)
    }

    /// The inside of a range, and its ends.
    fn sample(rng: &mut Generator, own: Range<f64>) -> f64 {
        match rng.next_u32() % 4 {
            0 => own.low,
            1 => own.high,
            _ => own.low + (own.high - own.low) * share(rng),
        }
    }

    type Unary = (fn(Range<f64>) -> Range<f64>, fn(f64) -> f64);
    type Binary = (
        fn(Range<f64>, Range<f64>) -> Range<f64>,
        fn(f64, f64) -> f64,
    );

    #[test]
    fn what_is_computed_of_samples_is_in_the_range() {
        let unary: [Unary; 5] = [
            (magnitude, f64::abs),
            (square, |x| x * x),
            (|a| root(magnitude(a)), |x| f64::sqrt(f64::abs(x))),
            (sine, f64::sin),
            (cosine, f64::cos),
        ];
        let binary: [Binary; 6] = [
            (plus, |a, b| a + b),
            (minus, |a, b| a - b),
            (times, |a, b| a * b),
            (least, f64::min),
            (greatest, f64::max),
            (arc_tangent, f64::atan2),
        ];
        let mut rng = generator(5);
        for _ in 0..40_000 {
            let (a, b) = (random_range(&mut rng), random_range(&mut rng));
            let (x, y) = (sample(&mut rng, a), sample(&mut rng, b));
            for (index, (of_range, of_number)) in unary.iter().enumerate() {
                let (range, value) = (of_range(a), of_number(x));
                assert!(range.low <= value && value <= range.high, "{index} {a:?}");
            }
            for (index, (of_range, of_number)) in binary.iter().enumerate() {
                let (range, value) = (of_range(a, b), of_number(x, y));
                assert!(
                    range.low <= value && value <= range.high,
                    "{index} {a:?} {b:?}"
                );
            }
        }
    }

    #[test]
    fn a_sum_is_rounded_only_if_it_is_not_exact() {
        assert_eq!(plus(point(1.5), point(0.25)), point(1.75));
        let tenths = plus(point(0.1), point(0.2));
        assert!(tenths.low < 0.3 + f64::EPSILON && tenths.low < tenths.high);
        assert_eq!(plus(point(f64::MAX), point(f64::MAX)).high, f64::INFINITY);
        assert!(plus(point(f64::MAX), point(f64::MAX)).low <= f64::MAX);
        assert_eq!(minus(EVERYTHING, EVERYTHING), EVERYTHING);
        assert_eq!(times(EVERYTHING, point(0.0)), point(0.0));
    }

    /// What is assumed of `libm`, against the identity that its errors would break.
    #[test]
    fn sines_and_angles_are_as_exact_as_is_assumed() {
        let mut rng = generator(9);
        let mut largest: f64 = 0.0;
        for _ in 0..200_000 {
            let angle = 12.0 * share(&mut rng) - 6.0;
            let (sin, cos) = Real::sin_cos(angle);
            largest = largest.max((sin - f64::sin(angle)).abs());
            largest = largest.max((cos - f64::cos(angle)).abs());
            let (y, x) = (share(&mut rng) - 0.5, share(&mut rng) - 0.5);
            largest = largest.max((Real::atan2(y, x) - f64::atan2(y, x)).abs());
            let circle = sin * sin + cos * cos - 1.0;
            assert!(circle.abs() < TRUSTED, "{angle}");
        }
        // The platform's own functions are off by less than one unit, too.
        assert!(largest < 0.5 * TRUSTED, "{largest}");
    }
}
