//! Curves: features along a line of parameters.

use super::line::Line;
use super::{Algebra, Arithmetic, Measure, cross, dot};
use crate::domain::node::Extreme;
use crate::real::Real;

/// `line(t) + factor * bend(t)`, where the bend is the length of a vector, the angle
/// between it and a fixed direction, or another [`Bend`].
///
/// This is what the features of the grammar become along a line of parameters. Unknown are
/// those with two lengths or angles of vectors, a product of two parameters, a turn by a
/// parameter, or an extreme of values that vary.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curve<R> {
    /// The straight part.
    pub line: Line<R>,
    /// By what the bend is multiplied.
    pub factor: R,
    /// The vector whose length or angle is taken.
    pub vector: [Line<R>; 3],
    /// What is taken of the vector.
    pub bend: Bend<R>,
}

/// What a curve has of its vector.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bend<R> {
    /// Its length.
    Length,
    /// Its angle to a direction; here is its part along that.
    Angle(Line<R>),
    /// The cosine of that angle, times how long the direction is.
    Cosine([R; 3]),
    /// The sine of that angle, times how long the direction is.
    Sine([R; 3]),
}

impl<R: Real> Curve<R> {
    /// Whether its value along the line is known. It may be infinite everywhere, as
    /// an extreme over nothing is.
    pub fn is_known(&self) -> bool {
        if self.factor == R::ZERO {
            return self.line.slope.is_finite();
        }
        // Roots are found by squares, of which an overflow would hide one.
        let known = |v: &Line<R>| v.at.abs() + v.slope.abs() <= R::LARGE;
        self.line.slope.abs() + self.factor.abs() <= R::LARGE
            && self.vector.iter().all(known)
            // The roots of an angle against a straight line have no closed form.
            && match self.bend {
                Bend::Length => true,
                Bend::Angle(along) => known(&along) && self.line.slope == R::ZERO,
                Bend::Cosine(_) | Bend::Sine(_) => self.line.slope == R::ZERO,
            }
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
        let vector = self.vector.map(|v| v.value(t));
        let length = R::norm(vector);
        match self.bend {
            Bend::Length => length,
            Bend::Angle(along) => {
                let along = along.value(t);
                let across = (length * length - along * along).max(R::ZERO).sqrt();
                across.atan2(along)
            }
            Bend::Cosine(direction) => dot(vector, direction) / length,
            Bend::Sine(direction) => R::norm(cross(vector, direction)) / length,
        }
    }

    /// Where it may be zero: the roots of `line(t) = -factor * |vector(t)|`, squared, or
    /// NaN or infinite where there is none. A root of the squared equation need not be one
    /// of the curve.
    pub fn roots(&self) -> [R; 2] {
        if let Bend::Sine(direction) = self.bend {
            return self.roots_of_sine(direction);
        }
        let Some((Line { at: a, slope: b }, factor)) = self.as_length() else {
            return [R::NAN; 2];
        };
        if factor == R::ZERO {
            return [-a / b, R::NAN];
        }
        let zero = |v: &Line<R>| v.at == R::ZERO && v.slope == R::ZERO;
        let [x, y, z] = &self.vector;
        let single = match (zero(x), zero(y), zero(z)) {
            (_, true, true) => Some(x),
            (true, _, true) => Some(y),
            (true, true, _) => Some(z),
            _ => None,
        };
        if let Some(v) = single {
            let (at, slope) = (factor * v.at, factor * v.slope);
            return [-(a + at) / (b + slope), -(a - at) / (b - slope)];
        }
        let [c, d, e] = squares(&self.vector, factor);
        quadratic_roots(c - b * b, d - a * b, e - a * a)
    }

    /// The straight part and the factor of a curve with the length of the same vector that
    /// has the same roots: a vector has an angle to a direction where its part along the
    /// direction is its length times the cosine. `None` if there are no roots.
    fn as_length(&self) -> Option<(Line<R>, R)> {
        match self.bend {
            Bend::Length => Some((self.line, self.factor)),
            Bend::Angle(along) => {
                let angle = -self.line.at / self.factor;
                let possible = angle >= R::ZERO && angle <= R::from_f64(core::f64::consts::PI);
                possible.then(|| (along, -angle.sin_cos().1))
            }
            Bend::Cosine(direction) => {
                let along = dot(self.vector, direction.map(Line::constant));
                Some((along.scaled(self.factor), self.line.at))
            }
            Bend::Sine(_) => None,
        }
    }

    /// Where the part of the vector across a direction is its length times some number.
    fn roots_of_sine(&self, direction: [R; 3]) -> [R; 2] {
        let across = cross(self.vector, direction.map(Line::constant));
        let [a, b, c] = squares(&across, self.factor);
        let [d, e, f] = squares(&self.vector, self.line.at);
        quadratic_roots(a - d, b - e, c - f)
    }

    /// Whether the value at `t` is zero, up to rounding.
    pub fn is_near_zero(&self, t: R) -> bool {
        let size = self.line.at.abs() + (self.line.slope * t).abs();
        let tolerance = R::SQRT_EPSILON * (R::ONE + size);
        self.value(t).abs() <= tolerance
    }

    /// Whether it may jump at `t`: an angle does where its vector turns round in the origin.
    pub fn may_jump(&self, t: R) -> bool {
        if self.factor == R::ZERO || !matches!(self.bend, Bend::Angle(_)) {
            return false;
        }
        let size = self.vector.iter().fold(R::ZERO, |size, v| {
            size.max(v.at.abs() + (v.slope * t).abs())
        });
        R::norm(self.vector.map(|v| v.value(t))) <= R::SQRT_EPSILON * size
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

impl<R: Real> Algebra<R> for Line<R> {
    type Measure = Curve<R>;
    fn measure(self) -> Curve<R> {
        Curve {
            line: self,
            factor: R::ZERO,
            vector: [Line::constant(R::ZERO); 3],
            bend: Bend::Length,
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
            bend: Bend::Length,
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
            bend: Bend::Angle(dot(moving, direction)),
        }
    }
    /// It is one curve only where it does not vary; else there is one for each multiple.
    fn folded(self, period: R) -> Curve<R> {
        let known = self.known();
        known.map_or_else(Curve::unknown, |at| Curve::constant(at.folded(period)))
    }
    fn known(self) -> Option<R> {
        (self.slope == R::ZERO).then_some(self.at)
    }
    fn about(self) -> Option<(R, R)> {
        Some((self.known()?, R::ZERO))
    }
    /// It is one curve only where nothing moves; else it is made of pieces.
    fn length_of<const N: usize>(
        vectors: [[Self; 3]; N],
        _: R,
        value: impl Fn([[R; 3]; N]) -> R,
    ) -> Curve<R> {
        let moves = vectors.iter().flatten().any(|v| v.known().is_none());
        match moves {
            true => Curve::unknown(),
            false => Curve::constant(value(vectors.map(|vector| vector.map(|v| v.at)))),
        }
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
    fn over(self, other: Self) -> Self {
        match (self.as_constant(), other.as_constant()) {
            (Some(a), Some(b)) => Self::constant(a / b),
            (None, Some(b)) => Curve {
                line: self.line.over(Line::constant(b)),
                factor: self.factor / b,
                ..self
            },
            (_, None) => Self::unknown(),
        }
    }
    fn scaled(self, factor: R) -> Self {
        Curve {
            line: self.line.scaled(factor),
            factor: self.factor * factor,
            ..self
        }
    }
    fn widened(self, _: R) -> Self {
        self
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

/// The square of a factor times the length of a vector along a line: `[a, b, c]` of
/// `a t^2 + 2 b t + c`.
fn squares<R: Real>(vector: &[Line<R>; 3], factor: R) -> [R; 3] {
    let square = |f: fn(&Line<R>) -> R, g: fn(&Line<R>) -> R| {
        let products = vector.iter().map(|v| f(v) * g(v));
        factor * factor * products.fold(R::ZERO, |sum, p| sum + p)
    };
    [
        square(|v| v.slope, |v| v.slope),
        square(|v| v.at, |v| v.slope),
        square(|v| v.at, |v| v.at),
    ]
}

/// The roots of `a t^2 + 2 b t + c`, without cancellation. Two roots that are one but for
/// rounding are one: where a curve touches zero, and of an angle that is a right one.
fn quadratic_roots<R: Real>(a: R, b: R, c: R) -> [R; 2] {
    let discriminant = b * b - a * c;
    let rounding = R::from_f64(8.0) * R::EPSILON * b * b;
    if discriminant < -rounding {
        return [R::NAN; 2];
    }
    let root = if discriminant.abs() <= rounding {
        R::ZERO
    } else {
        discriminant.sqrt()
    };
    let q = if b < R::ZERO { root - b } else { -(b + root) };
    [q / a, c / q]
}
