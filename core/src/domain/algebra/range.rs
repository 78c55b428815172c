//! Ranges: bounds of a term over a box of parameters.
//!
//! An end that became infinite because a number was too large is no bound: then nothing is
//! known on that side. So an overflow never proves anything.

use super::{Algebra, Arithmetic, Measure, dot};
use crate::domain::node::Extreme;
use crate::real::Real;

/// All values between two bounds, over a box of parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range<R> {
    /// Not above any value.
    pub low: R,
    /// Not below any value.
    pub high: R,
}

impl<R: Real> Range<R> {
    /// The range between two ends, each with the numbers that it was computed from.
    fn between<const N: usize>((low, lows): (R, [R; N]), (high, highs): (R, [R; N])) -> Range<R> {
        let overflows =
            |end: R, from: [R; N]| !end.is_finite() && from.iter().all(|own| own.is_finite());
        Range {
            low: if overflows(low, lows) {
                -R::INFINITY
            } else {
                low
            },
            high: if overflows(high, highs) {
                R::INFINITY
            } else {
                high
            },
        }
    }

    /// The range of the distances from zero.
    fn magnitude(self) -> Range<R> {
        let (a, b) = (self.low.abs(), self.high.abs());
        let crosses = self.low <= R::ZERO && self.high >= R::ZERO;
        Range {
            low: if crosses { R::ZERO } else { a.min(b) },
            high: a.max(b),
        }
    }
}

impl<R: Real> Arithmetic<R> for Range<R> {
    fn constant(value: R) -> Self {
        Range {
            low: value,
            high: value,
        }
    }
    fn unknown() -> Self {
        Range {
            low: -R::INFINITY,
            high: R::INFINITY,
        }
    }
    fn plus(self, other: Self) -> Self {
        Range::between(
            (self.low + other.low, [self.low, other.low]),
            (self.high + other.high, [self.high, other.high]),
        )
    }
    fn minus(self, other: Self) -> Self {
        Range::between(
            (self.low - other.high, [self.low, other.high]),
            (self.high - other.low, [self.high, other.low]),
        )
    }
    fn times(self, other: Self) -> Self {
        let (a, b) = (self.low * other.low, self.low * other.high);
        let (c, d) = (self.high * other.low, self.high * other.high);
        if !(a + b + c + d).is_finite() {
            return Self::unknown();
        }
        Range {
            low: a.min(b).min(c.min(d)),
            high: a.max(b).max(c.max(d)),
        }
    }
    fn over(self, other: Self) -> Self {
        if other.low <= R::ZERO && other.high >= R::ZERO {
            return Self::unknown();
        }
        let (a, b) = (self.low / other.low, self.low / other.high);
        let (c, d) = (self.high / other.low, self.high / other.high);
        if !(a + b + c + d).is_finite() {
            return Self::unknown();
        }
        Range {
            low: a.min(b).min(c.min(d)),
            high: a.max(b).max(c.max(d)),
        }
    }
    fn widened(self, by: R) -> Self {
        self.plus(Range { low: -by, high: by })
    }
}

impl<R: Real> Measure<R> for Range<R> {
    fn extreme(self, extreme: Extreme, other: Self) -> Self {
        Range {
            low: extreme.of(self.low, other.low),
            high: extreme.of(self.high, other.high),
        }
    }
    fn lower(&mut self, by: R) {
        *self = self.minus(Range::constant(by));
    }
}

impl<R: Real> Algebra<R> for Range<R> {
    type Measure = Range<R>;
    fn measure(self) -> Self {
        self
    }
    fn norm(vector: [Self; 3]) -> Self {
        let [x, y, z] = vector.map(Range::magnitude);
        let (low, high) = ([x.low, y.low, z.low], [x.high, y.high, z.high]);
        Range::between((R::norm(low), low), (R::norm(high), high))
    }
    fn angle(a: [Self; 3], b: [Self; 3]) -> Self {
        let (dot, lengths) = (dot(a, b), Self::norm(a).times(Self::norm(b)));
        let Range { low, high } = lengths;
        // Too short, or too long to be told.
        if !(low > R::ZERO && high.is_finite() && dot.low.is_finite() && dot.high.is_finite()) {
            let low = R::ZERO;
            let high = R::from_f64(core::f64::consts::PI);
            return Range { low, high };
        }
        // A cosine is farthest from zero where the vectors are shortest.
        let angle = |dot: R, lengths: [R; 2]| {
            let [positive, negative] = lengths.map(|length| dot / length);
            let cosine = if dot < R::ZERO { negative } else { positive };
            let cosine = cosine.clamp(-R::ONE, R::ONE);
            (R::ONE - cosine * cosine).sqrt().atan2(cosine)
        };
        Range {
            low: angle(dot.high, [low, high]),
            high: angle(dot.low, [high, low]),
        }
    }
    fn folded(self, period: R) -> Self {
        let half = period * R::from_f64(0.5);
        let nearest = period * (self.low / period + R::from_f64(0.5)).floor();
        let (low, high) = (self.low - nearest, self.high - nearest);
        // The lower end is at most half a period from zero, the upper one is above it.
        let is_narrow = high - low < period;
        if !is_narrow {
            return Range {
                low: R::ZERO,
                high: half,
            };
        }
        let passes_multiple = low <= R::ZERO && high >= R::ZERO || high >= period;
        let (one, other) = (low.abs(), high.folded(period));
        Range {
            low: if passes_multiple {
                R::ZERO
            } else {
                one.min(other)
            },
            high: if high >= half { half } else { one.max(other) },
        }
    }
    fn known(self) -> Option<R> {
        (self.low == self.high).then_some(self.low)
    }
    fn about(self) -> Option<(R, R)> {
        let half = (self.high - self.low) * R::from_f64(0.5);
        half.is_finite().then(|| (self.low + half, half))
    }
    fn length_of<const N: usize>(
        vectors: [[Self; 3]; N],
        slack: R,
        value: impl Fn([[R; 3]; N]) -> R,
    ) -> Self {
        let mut middles = [[R::ZERO; 3]; N];
        let mut moved = R::ZERO;
        for (middle, vector) in middles.iter_mut().zip(vectors) {
            let [Some((x, dx)), Some((y, dy)), Some((z, dz))] = vector.map(Range::about) else {
                return Self::unknown();
            };
            *middle = [x, y, z];
            moved = moved.max(R::norm([dx, dy, dz]));
        }
        let middle = value(middles);
        match (moved + slack).is_finite() && middle.is_finite() {
            true => Self::constant(middle).widened(moved + slack),
            false => Self::unknown(),
        }
    }
}
