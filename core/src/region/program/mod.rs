//! A region as a straight-line program: numbers, each computed from those before it.
//!
//! | file | content |
//! |---|---|
//! | `mod.rs` | operations, values with their derivatives, and the trait of what takes them |
//! | `places.rs` | where points are |
//! | `terms.rs` | what terms are |
//! | `bodies.rs` | relations between bodies |
//!
//! What takes the operations writes them down (as C or Rust), or keeps them to compute with
//! ranges. They are those of a scene and its samples, in the same order.

mod bodies;
mod places;
mod terms;

pub(super) use places::{NOT_STRAIGHT, Places, dot};
pub(super) use terms::Term;

use crate::domain::{Extreme, MAX_PARAMETERS, Quantity};
use crate::error::Error;

/// What an operation takes: a number that is known by now, or where it stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Operand {
    Zero,
    One,
    /// A number of the instance, by its place.
    Slot(u8),
    /// A parameter, by its place.
    Theta(u8),
    /// What was computed before, by its number.
    Temp(u16),
}

/// What is computed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Operation {
    Number(f64),
    Sum(Operand, Operand),
    Difference(Operand, Operand),
    Product(Operand, Operand),
    Quotient(Operand, Operand),
    /// The absolute value.
    Magnitude(Operand),
    /// The square root.
    Root(Operand),
    /// The angle of a vector, of its y and its x.
    ArcTangent(Operand, Operand),
    /// The lesser of two.
    Least(Operand, Operand),
    /// The greater of two.
    Greatest(Operand, Operand),
    /// An extreme over the members of a group, whatever there are.
    Extreme(Extreme, Quantity),
}

/// A value and its derivatives by the parameters.
#[derive(Clone, Copy, Debug)]
pub(super) struct Value {
    pub(super) value: Operand,
    pub(super) slopes: [Operand; MAX_PARAMETERS],
}

impl Value {
    pub(super) const ZERO: Value = Value::constant(Operand::Zero);
    pub(super) const ONE: Value = Value::constant(Operand::One);

    /// What no parameter moves.
    pub(super) const fn constant(value: Operand) -> Value {
        Value {
            value,
            slopes: [Operand::Zero; MAX_PARAMETERS],
        }
    }

    /// Whether a parameter moves it.
    pub(super) fn varies(&self) -> bool {
        self.slopes.iter().any(|slope| *slope != Operand::Zero)
    }
}

/// A distinction of cases, by the operands `a`, `b` and so on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Case {
    /// The derivative of the magnitude of `a`, of which that is `b`; at zero, as if it had
    /// moved the value.
    MagnitudeSlope,
    /// The derivative of the length `f` of a vector, of whose square that is `g`, twice over.
    /// A vector along the x axis (y is `a`, its derivative `b`, for z `c` and `d`) is as long
    /// as that coordinate is far from zero, with the derivative `e`.
    LengthSlope,
    /// `b / a`, or zero.
    Ratio,
    /// The extreme over nothing.
    Nothing(Extreme),
    /// Whether the member is there of which `a` is a number, and its value `b` counts rather
    /// than `c`.
    Counts(Extreme),
    /// `b` if `a`, which says yes or no, or else `c`.
    Choice,
}

/// The error of what only code has.
pub(super) const ONLY_CODE: Error =
    Error::InvalidArgument("derivatives and members that may be absent are for code only");

/// Takes operations, and numbers what they compute.
pub(super) trait Program {
    /// Adds an operation.
    fn operation(&mut self, operation: Operation) -> Result<Operand, Error>;

    /// Adds the sine and the cosine of an angle.
    fn sine_and_cosine(&mut self, angle: Operand) -> Result<[Operand; 2], Error>;

    /// Adds a distinction of cases. Derivatives and extremes have some, and only what is
    /// written as code has those.
    fn cases(&mut self, case: Case, operands: &[Operand]) -> Result<Operand, Error>;

    /// Refuses relations between bodies, if it cannot take them.
    fn check_bodies(&self) -> Result<(), Error> {
        Ok(())
    }

    /// Whether it takes sines of sums of angles, where things are turned one in another.
    fn keeps_angles(&self) -> bool {
        true
    }

    /// Adds that a size of a body has to be above zero.
    fn require_positive(&mut self, size: Operand) -> Result<(), Error>;

    /// Notes that a vector is another one, turned into a frame with these axes.
    fn note_turned(
        &mut self,
        _vector: [Value; 3],
        _turned: [Value; 3],
        _axes: [[Value; 3]; 3],
    ) -> Result<(), Error> {
        Ok(())
    }

    /// A number of the text.
    fn number(&mut self, number: f64) -> Result<Operand, Error> {
        match number {
            0.0 => Ok(Operand::Zero),
            1.0 => Ok(Operand::One),
            _ => self.operation(Operation::Number(number)),
        }
    }

    fn sum(&mut self, a: Operand, b: Operand) -> Result<Operand, Error> {
        match (a, b) {
            (Operand::Zero, other) | (other, Operand::Zero) => Ok(other),
            _ => self.operation(Operation::Sum(a, b)),
        }
    }

    fn difference(&mut self, a: Operand, b: Operand) -> Result<Operand, Error> {
        match b {
            Operand::Zero => Ok(a),
            _ => self.operation(Operation::Difference(a, b)),
        }
    }

    fn product(&mut self, a: Operand, b: Operand) -> Result<Operand, Error> {
        match (a, b) {
            (Operand::Zero, _) | (_, Operand::Zero) => Ok(Operand::Zero),
            (Operand::One, other) | (other, Operand::One) => Ok(other),
            _ => self.operation(Operation::Product(a, b)),
        }
    }

    fn quotient(&mut self, a: Operand, b: Operand) -> Result<Operand, Error> {
        match b {
            Operand::One => Ok(a),
            _ => self.operation(Operation::Quotient(a, b)),
        }
    }

    fn plus(&mut self, a: Value, b: Value) -> Result<Value, Error> {
        each(a, b, |a, b| self.sum(a, b))
    }

    fn minus(&mut self, a: Value, b: Value) -> Result<Value, Error> {
        each(a, b, |a, b| self.difference(a, b))
    }

    fn times(&mut self, a: Value, b: Value) -> Result<Value, Error> {
        let mut result = Value::constant(self.product(a.value, b.value)?);
        let slopes = a.slopes.into_iter().zip(b.slopes);
        for (slope, (of_a, of_b)) in result.slopes.iter_mut().zip(slopes) {
            let first = self.product(of_a, b.value)?;
            let second = self.product(a.value, of_b)?;
            *slope = self.sum(first, second)?;
        }
        Ok(result)
    }

    fn over(&mut self, a: Value, b: Value) -> Result<Value, Error> {
        let mut result = Value::constant(self.quotient(a.value, b.value)?);
        let slopes = a.slopes.into_iter().zip(b.slopes);
        for (slope, (of_a, of_b)) in result.slopes.iter_mut().zip(slopes) {
            let second = self.product(result.value, of_b)?;
            let change = self.difference(of_a, second)?;
            *slope = match change {
                Operand::Zero => Operand::Zero,
                _ => self.quotient(change, b.value)?,
            };
        }
        Ok(result)
    }

    fn negated(&mut self, a: Value) -> Result<Value, Error> {
        self.minus(Value::ZERO, a)
    }

    /// Sine and cosine of an angle.
    fn sin_cos(&mut self, angle: Value) -> Result<[Value; 2], Error> {
        if angle.value == Operand::Zero && !angle.varies() {
            return Ok([Value::ZERO, Value::ONE]);
        }
        let mut both = self.sine_and_cosine(angle.value)?.map(Value::constant);
        let [sin, cos] = &mut both;
        let slopes = sin.slopes.iter_mut().zip(&mut cos.slopes);
        for ((of_sin, of_cos), slope) in slopes.zip(angle.slopes) {
            *of_sin = self.product(cos.value, slope)?;
            let negative = self.product(sin.value, slope)?;
            *of_cos = self.difference(Operand::Zero, negative)?;
        }
        Ok(both)
    }

    /// The length of a vector.
    fn norm(&mut self, vector: [Value; 3]) -> Result<Value, Error> {
        let is_zero = |v: &Value| v.value == Operand::Zero && !v.varies();
        let [x, y, z] = vector;
        if is_zero(&y) && is_zero(&z) {
            let mut length = Value::constant(self.operation(Operation::Magnitude(x.value))?);
            for (slope, own) in length.slopes.iter_mut().zip(x.slopes) {
                if own != Operand::Zero {
                    *slope = self.cases(Case::MagnitudeSlope, &[x.value, own])?;
                }
            }
            return Ok(length);
        }
        let mut square = Value::ZERO;
        for own in vector {
            let own = self.times(own, own)?;
            square = self.plus(square, own)?;
        }
        let mut length = Value::constant(self.operation(Operation::Root(square.value))?);
        let parts = x.slopes.into_iter().zip(y.slopes.into_iter().zip(z.slopes));
        let slopes = length.slopes.iter_mut().zip(square.slopes);
        for ((slope, own), (of_x, (of_y, of_z))) in slopes.zip(parts) {
            if own == Operand::Zero {
                continue;
            }
            // A vector along the x axis is as long as that coordinate is far from zero.
            let along = self.cases(Case::MagnitudeSlope, &[x.value, of_x])?;
            let operands = [y.value, of_y, z.value, of_z, along, length.value, own];
            *slope = self.cases(Case::LengthSlope, &operands)?;
        }
        Ok(length)
    }
}

fn each(
    a: Value,
    b: Value,
    mut operation: impl FnMut(Operand, Operand) -> Result<Operand, Error>,
) -> Result<Value, Error> {
    let mut result = Value::constant(operation(a.value, b.value)?);
    let slopes = a.slopes.into_iter().zip(b.slopes);
    for (slope, (a, b)) in result.slopes.iter_mut().zip(slopes) {
        *slope = operation(a, b)?;
    }
    Ok(result)
}
