//! What an expression is evaluated to: a number, a curve along a line of
//! parameters, or a range over a box of parameters.
//!
//! One evaluator serves all three. A number answers "is this sample inside?", a
//! curve has its roots in closed form and so gives exact intervals, and a range
//! that misses zero proves that a whole box is outside.

use super::group::Extreme;
use crate::real::Real;

/// What can be added, subtracted and multiplied.
pub trait Arithmetic<R: Real>: Copy {
    /// A number that does not vary.
    fn constant(value: R) -> Self;
    /// A quantity nothing is known about.
    fn unknown() -> Self;
    /// `self + other`
    fn plus(self, other: Self) -> Self;
    /// `self - other`
    fn minus(self, other: Self) -> Self;
    /// `self * other`
    fn times(self, other: Self) -> Self;
    /// `self * factor`
    fn scaled(self, factor: R) -> Self {
        self.times(Self::constant(factor))
    }
}

/// What features are computed in.
pub trait Measure<R: Real>: Arithmetic<R> {
    /// The extreme of two quantities, everywhere.
    fn extreme(self, extreme: Extreme, other: Self) -> Self;
    /// Subtracts a number, in place.
    fn lower(&mut self, by: R);
}

/// What parameters and positions are computed in.
pub trait Algebra<R: Real>: Arithmetic<R> {
    /// What features are computed in; it also holds lengths of vectors.
    type Measure: Measure<R>;
    /// The same quantity as a feature.
    fn measure(self) -> Self::Measure;
    /// The length of a vector.
    fn norm(vector: [Self; 3]) -> Self::Measure;
    /// The angle between two vectors, in `[0, pi]`; zero if one of them is zero.
    fn angle(a: [Self; 3], b: [Self; 3]) -> Self::Measure;
    /// The number, if it does not vary.
    fn known(self) -> Option<R>;
}

fn dot<R: Real, A: Arithmetic<R>>(a: [A; 3], b: [A; 3]) -> A {
    let ([ax, ay, az], [bx, by, bz]) = (a, b);
    ax.times(bx).plus(ay.times(by)).plus(az.times(bz))
}

impl<R: Real> Arithmetic<R> for R {
    fn constant(value: R) -> R {
        value
    }
    fn unknown() -> R {
        R::NAN
    }
    fn plus(self, other: R) -> R {
        self + other
    }
    fn minus(self, other: R) -> R {
        self - other
    }
    fn times(self, other: R) -> R {
        self * other
    }
}

impl<R: Real> Measure<R> for R {
    fn extreme(self, extreme: Extreme, other: R) -> R {
        extreme.of(self, other)
    }
    fn lower(&mut self, by: R) {
        *self -= by;
    }
}

impl<R: Real> Algebra<R> for R {
    type Measure = R;
    fn measure(self) -> R {
        self
    }
    fn norm([x, y, z]: [R; 3]) -> R {
        // One component: exact, and no square root. It is the common case.
        if y == R::ZERO && z == R::ZERO {
            return x.abs();
        }
        (x * x + y * y + z * z).sqrt()
    }
    /// Well conditioned for every angle: the arc tangent of the lengths of the cross
    /// and the dot product.
    fn angle(a: [R; 3], b: [R; 3]) -> R {
        let ([ax, ay, az], [bx, by, bz]) = (a, b);
        let cross = [az * by - ay * bz, ax * bz - az * bx, ay * bx - ax * by];
        R::norm(cross).atan2(dot(a, b))
    }
    fn known(self) -> Option<R> {
        Some(self)
    }
}

/// `at + slope * t` for a position `t` on a line through the parameter space.
/// A slope that is not a number marks an unknown quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line<R> {
    /// Value at `t = 0`.
    pub at: R,
    /// Change with `t`.
    pub slope: R,
}

impl<R: Real> Line<R> {
    /// The value at `t`.
    pub fn value(&self, t: R) -> R {
        self.at + self.slope * t
    }
}

impl<R: Real> Arithmetic<R> for Line<R> {
    fn constant(value: R) -> Self {
        Line {
            at: value,
            slope: R::ZERO,
        }
    }
    fn unknown() -> Self {
        Line {
            at: R::unknown(),
            slope: R::unknown(),
        }
    }
    fn plus(self, other: Self) -> Self {
        Line {
            at: self.at + other.at,
            slope: self.slope + other.slope,
        }
    }
    fn minus(self, other: Self) -> Self {
        Line {
            at: self.at - other.at,
            slope: self.slope - other.slope,
        }
    }
    fn times(self, other: Self) -> Self {
        if other.slope == R::ZERO {
            self.scaled(other.at)
        } else if self.slope == R::ZERO {
            other.scaled(self.at)
        } else {
            Self::unknown()
        }
    }
    fn scaled(self, factor: R) -> Self {
        Line {
            at: self.at * factor,
            slope: self.slope * factor,
        }
    }
}

impl<R: Real> Algebra<R> for Line<R> {
    type Measure = Curve<R>;
    fn measure(self) -> Curve<R> {
        Curve {
            line: self,
            factor: R::ZERO,
            vector: [Line::constant(R::ZERO); 3],
            along: None,
        }
    }
    fn norm(vector: [Self; 3]) -> Curve<R> {
        if vector.iter().all(|v| v.slope == R::ZERO) {
            return Curve::constant(R::norm(vector.map(|v| v.at)));
        }
        Curve {
            line: Line::constant(R::ZERO),
            factor: R::ONE,
            vector,
            along: None,
        }
    }
    fn angle(a: [Self; 3], b: [Self; 3]) -> Curve<R> {
        let settled = |vector: [Self; 3]| {
            let vary = vector.iter().any(|v| v.slope != R::ZERO);
            (!vary).then(|| vector.map(|v| v.at))
        };
        let (moving, fixed) = match (settled(a), settled(b)) {
            (Some(a), Some(b)) => return Curve::constant(R::angle(a, b)),
            (None, Some(b)) => (a, b),
            (Some(a), None) => (b, a),
            (None, None) => return Curve::unknown(),
        };
        let length = R::norm(fixed);
        if length == R::ZERO {
            return Curve::constant(R::ZERO);
        }
        let direction = fixed.map(|v| Line::constant(v / length));
        Curve {
            line: Line::constant(R::ZERO),
            factor: R::ONE,
            vector: moving,
            along: Some(dot(moving, direction)),
        }
    }
    fn known(self) -> Option<R> {
        (self.slope == R::ZERO).then_some(self.at)
    }
}

/// `line(t) + factor * |vector(t)|`, or `line(t) + factor * angle(t)` with the angle
/// between the vector and a fixed direction: what the features of the grammar become
/// along a line of parameters, unless they hold two lengths or angles of vectors, a
/// product of two parameters, a turn by a parameter or an extreme of what varies; those
/// are unknown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curve<R> {
    /// The straight part.
    pub line: Line<R>,
    /// How often the length or the angle counts.
    pub factor: R,
    /// The vector whose length or angle is taken.
    pub vector: [Line<R>; 3],
    /// For an angle, the part of the vector along the direction.
    pub along: Option<Line<R>>,
}

impl<R: Real> Curve<R> {
    /// Whether its value along the line is known. It may be infinite everywhere, as
    /// an extreme over nothing is.
    pub fn is_known(&self) -> bool {
        if self.factor == R::ZERO {
            return self.line.slope.is_finite();
        }
        let known = |v: &Line<R>| (v.at + v.slope).is_finite();
        (self.line.slope + self.factor).is_finite()
            && self.vector.iter().all(known)
            // The roots of an angle against a straight line have no closed form.
            && self.along.is_none_or(|along| known(&along) && self.line.slope == R::ZERO)
    }

    /// Whether its value along the line is known, and a number everywhere.
    pub fn is_finite(&self) -> bool {
        self.line.at.is_finite() && self.is_known()
    }

    /// The value at `t`.
    #[inline]
    pub fn value(&self, t: R) -> R {
        let straight = self.line.value(t);
        if self.factor == R::ZERO {
            return straight;
        }
        straight + self.factor * self.bend(t)
    }

    /// The length or angle of the vector at `t`.
    fn bend(&self, t: R) -> R {
        let length = R::norm(self.vector.map(|v| v.value(t)));
        let Some(along) = self.along else {
            return length;
        };
        let along = along.value(t);
        let across = (length * length - along * along).max(R::ZERO).sqrt();
        across.atan2(along)
    }

    /// The straight part and the factor of a curve with the same vector and the same
    /// roots that is no angle: a vector is at an angle to a direction where its part
    /// along it is its length times the cosine. `None` if there are no roots.
    pub fn without_angle(&self) -> Option<(Line<R>, R)> {
        let Some(along) = self.along else {
            return Some((self.line, self.factor));
        };
        let angle = -self.line.at / self.factor;
        let possible = angle >= R::ZERO && angle <= R::from_f64(core::f64::consts::PI);
        possible.then(|| (along, -angle.sin_cos().1))
    }

    /// Whether the value at `t` is zero but for rounding.
    pub fn is_near_zero(&self, t: R) -> bool {
        let size = self.line.at.abs() + (self.line.slope * t).abs();
        let tolerance = R::SQRT_EPSILON * (R::ONE + size);
        self.value(t).abs() <= tolerance
    }

    fn sum(self, other: Self, sign: R) -> Self {
        let line = self.line.plus(other.line.scaled(sign));
        let (factor, bent) = if other.factor == R::ZERO {
            (self.factor, self)
        } else if self.factor == R::ZERO {
            (sign * other.factor, other)
        } else {
            return Self::unknown();
        };
        Curve {
            line,
            factor,
            ..bent
        }
    }

    fn as_constant(&self) -> Option<R> {
        (self.factor == R::ZERO && self.line.slope == R::ZERO).then_some(self.line.at)
    }
}

impl<R: Real> Arithmetic<R> for Curve<R> {
    fn constant(value: R) -> Self {
        Line::constant(value).measure()
    }
    fn unknown() -> Self {
        Line::unknown().measure()
    }
    fn plus(self, other: Self) -> Self {
        self.sum(other, R::ONE)
    }
    fn minus(self, other: Self) -> Self {
        self.sum(other, -R::ONE)
    }
    fn times(self, other: Self) -> Self {
        match (self.as_constant(), other.as_constant()) {
            (Some(a), Some(b)) => Self::constant(a * b),
            (None, Some(factor)) => self.scaled(factor),
            (Some(factor), None) => other.scaled(factor),
            (None, None) => Self::unknown(),
        }
    }
    fn scaled(self, factor: R) -> Self {
        Curve {
            line: self.line.scaled(factor),
            factor: self.factor * factor,
            ..self
        }
    }
}

impl<R: Real> Measure<R> for Curve<R> {
    fn extreme(self, extreme: Extreme, other: Self) -> Self {
        match (self.as_constant(), other.as_constant()) {
            (Some(a), Some(b)) => Self::constant(extreme.of(a, b)),
            _ => Self::unknown(),
        }
    }
    fn lower(&mut self, by: R) {
        self.line.at -= by;
    }
}

/// All values between two bounds, over a box of parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range<R> {
    /// Not above any value.
    pub low: R,
    /// Not below any value.
    pub high: R,
}

impl<R: Real> Range<R> {
    /// The distances from zero.
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
        Range {
            low: self.low + other.low,
            high: self.high + other.high,
        }
    }
    fn minus(self, other: Self) -> Self {
        Range {
            low: self.low - other.high,
            high: self.high - other.low,
        }
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
}

impl<R: Real> Measure<R> for Range<R> {
    fn extreme(self, extreme: Extreme, other: Self) -> Self {
        Range {
            low: extreme.of(self.low, other.low),
            high: extreme.of(self.high, other.high),
        }
    }
    fn lower(&mut self, by: R) {
        self.low -= by;
        self.high -= by;
    }
}

impl<R: Real> Algebra<R> for Range<R> {
    type Measure = Range<R>;
    fn measure(self) -> Self {
        self
    }
    fn norm(vector: [Self; 3]) -> Self {
        let [x, y, z] = vector.map(Range::magnitude);
        Range {
            low: R::norm([x.low, y.low, z.low]),
            high: R::norm([x.high, y.high, z.high]),
        }
    }
    fn angle(a: [Self; 3], b: [Self; 3]) -> Self {
        let (dot, lengths) = (dot(a, b), Self::norm(a).times(Self::norm(b)));
        let Range { low, high } = lengths;
        if low == R::ZERO {
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
    fn known(self) -> Option<R> {
        (self.low == self.high).then_some(self.low)
    }
}
