//! Straight-line code: constants, each computed once from those before it.

use super::phrases::Phrases;
use crate::domain::MAX_PARAMETERS;
use crate::error::Error;
use crate::text::write_number;
use core::fmt;
use heapless::Vec;

/// Most operands of a template.
const MOST_OPERANDS: usize = 8;

/// What an operation takes: a number that is known by now, or where it stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Operand {
    Zero,
    One,
    /// A number of the instance, by its place.
    Slot(u8),
    /// A parameter, by its place.
    Theta(u8),
    /// A constant of the code, by its number.
    Temp(u16),
}

/// A value and its derivatives by the parameters.
#[derive(Clone, Copy, Debug)]
pub(super) struct Value {
    pub(super) value: Operand,
    pub(super) slopes: [Operand; MAX_PARAMETERS],
}

impl Value {
    pub(super) const ZERO: Value = Value::constant(Operand::Zero);

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

/// What is put into a template.
#[derive(Clone, Copy)]
pub(super) enum Part<'t> {
    Operand(Operand),
    Whole(usize),
    Number(f64),
    Text(&'t str),
}

impl From<Operand> for Part<'_> {
    fn from(operand: Operand) -> Self {
        Part::Operand(operand)
    }
}

impl From<usize> for Part<'_> {
    fn from(number: usize) -> Self {
        Part::Whole(number)
    }
}

impl<'t> From<&'t str> for Part<'t> {
    fn from(text: &'t str) -> Self {
        Part::Text(text)
    }
}

/// Writes code, and numbers what it computes.
pub(super) struct Code<'o> {
    out: &'o mut dyn fmt::Write,
    pub(super) phrases: &'static Phrases,
    /// What names begin with; empty if they stand in a module.
    name: &'o str,
    next: u16,
}

impl<'o> Code<'o> {
    pub(super) fn new(
        out: &'o mut dyn fmt::Write,
        phrases: &'static Phrases,
        name: &'o str,
    ) -> Self {
        Code {
            out,
            phrases,
            name,
            next: 0,
        }
    }

    /// Fills in a template.
    pub(super) fn say(&mut self, template: &str, parts: &[Part<'_>]) -> Result<(), Error> {
        let mut rest = template;
        while let Some(place) = rest.bytes().position(|byte| byte == b'@' || byte == b'$') {
            self.raw(rest.get(..place).unwrap_or_default())?;
            let mut mark = rest.bytes().skip(place);
            match (mark.next(), mark.next()) {
                (Some(b'$'), Some(letter)) => {
                    let part = parts.get(usize::from(letter.wrapping_sub(b'a')));
                    let missing = Error::InvalidArgument("a template has no such part");
                    self.part(*part.ok_or(missing)?)?;
                }
                _ if self.name.is_empty() => {}
                _ => {
                    self.raw(self.name)?;
                    self.raw("_")?;
                }
            }
            rest = rest.get(place.saturating_add(2)..).unwrap_or_default();
        }
        self.raw(rest)
    }

    fn part(&mut self, part: Part<'_>) -> Result<(), Error> {
        match part {
            Part::Operand(operand) => self.operand(operand),
            Part::Whole(number) => write!(self.out, "{number}").map_err(full),
            Part::Number(number) => write_number(self.out, number).map_err(full),
            Part::Text(text) => self.raw(text),
        }
    }

    /// Writes text as it is.
    pub(super) fn raw(&mut self, text: &str) -> Result<(), Error> {
        self.out.write_str(text).map_err(full)
    }

    /// What is written by something else.
    pub(super) fn written(
        &mut self,
        write: impl FnOnce(&mut dyn fmt::Write) -> fmt::Result,
    ) -> Result<(), Error> {
        write(self.out).map_err(full)
    }

    fn operand(&mut self, operand: Operand) -> Result<(), Error> {
        match operand {
            Operand::Zero => self.say(self.phrases.zero, &[]),
            Operand::One => self.say(self.phrases.one, &[]),
            Operand::Slot(place) => write!(self.out, "instance[{place}]").map_err(full),
            Operand::Theta(place) => write!(self.out, "theta[{place}]").map_err(full),
            Operand::Temp(number) => write!(self.out, "t{number}").map_err(full),
        }
    }

    /// The next constant of the code.
    fn fresh(&mut self) -> Result<Operand, Error> {
        let full = Error::CapacityExceeded("constants of a region's code");
        let number = self.next;
        self.next = number.checked_add(1).ok_or(full)?;
        Ok(Operand::Temp(number))
    }

    /// A constant of the code, by a template.
    pub(super) fn constant(
        &mut self,
        template: &str,
        operands: &[Operand],
    ) -> Result<Operand, Error> {
        self.bound(self.phrases.real, template, operands)
    }

    /// A constant that says yes or no.
    pub(super) fn flag(&mut self, template: &str, operands: &[Operand]) -> Result<Operand, Error> {
        self.bound(self.phrases.flag, template, operands)
    }

    fn bound(
        &mut self,
        begin: &str,
        template: &str,
        operands: &[Operand],
    ) -> Result<Operand, Error> {
        let constant = self.fresh()?;
        self.say(begin, &[constant.into()])?;
        let mut parts: Vec<Part<'_>, MOST_OPERANDS> = Vec::new();
        for operand in operands {
            let full = Error::CapacityExceeded("operands of a constant");
            parts.push(Part::Operand(*operand)).map_err(|_| full)?;
        }
        self.say(template, &parts)?;
        self.raw(";\n")?;
        Ok(constant)
    }

    /// A number of the text.
    pub(super) fn number(&mut self, number: f64) -> Result<Operand, Error> {
        if number == 0.0 {
            return Ok(Operand::Zero);
        }
        if number == 1.0 {
            return Ok(Operand::One);
        }
        let constant = self.fresh()?;
        self.say(self.phrases.real, &[constant.into()])?;
        self.say(self.phrases.number, &[Part::Number(number)])?;
        self.raw(";\n")?;
        Ok(constant)
    }

    pub(super) fn sum(&mut self, a: Operand, b: Operand) -> Result<Operand, Error> {
        match (a, b) {
            (Operand::Zero, other) | (other, Operand::Zero) => Ok(other),
            _ => self.constant("$a + $b", &[a, b]),
        }
    }

    pub(super) fn difference(&mut self, a: Operand, b: Operand) -> Result<Operand, Error> {
        match (a, b) {
            (_, Operand::Zero) => Ok(a),
            (Operand::Zero, _) => self.constant("-$a", &[b]),
            _ => self.constant("$a - $b", &[a, b]),
        }
    }

    pub(super) fn product(&mut self, a: Operand, b: Operand) -> Result<Operand, Error> {
        match (a, b) {
            (Operand::Zero, _) | (_, Operand::Zero) => Ok(Operand::Zero),
            (Operand::One, other) | (other, Operand::One) => Ok(other),
            _ => self.constant("$a * $b", &[a, b]),
        }
    }

    pub(super) fn quotient(&mut self, a: Operand, b: Operand) -> Result<Operand, Error> {
        match b {
            Operand::One => Ok(a),
            _ => self.constant("$a / $b", &[a, b]),
        }
    }

    pub(super) fn plus(&mut self, a: Value, b: Value) -> Result<Value, Error> {
        self.each(a, b, Code::sum)
    }

    pub(super) fn minus(&mut self, a: Value, b: Value) -> Result<Value, Error> {
        self.each(a, b, Code::difference)
    }

    fn each(
        &mut self,
        a: Value,
        b: Value,
        operation: impl Fn(&mut Self, Operand, Operand) -> Result<Operand, Error>,
    ) -> Result<Value, Error> {
        let mut result = Value::constant(operation(self, a.value, b.value)?);
        let slopes = a.slopes.into_iter().zip(b.slopes);
        for (slope, (a, b)) in result.slopes.iter_mut().zip(slopes) {
            *slope = operation(self, a, b)?;
        }
        Ok(result)
    }

    pub(super) fn times(&mut self, a: Value, b: Value) -> Result<Value, Error> {
        let mut result = Value::constant(self.product(a.value, b.value)?);
        let slopes = a.slopes.into_iter().zip(b.slopes);
        for (slope, (of_a, of_b)) in result.slopes.iter_mut().zip(slopes) {
            let first = self.product(of_a, b.value)?;
            let second = self.product(a.value, of_b)?;
            *slope = self.sum(first, second)?;
        }
        Ok(result)
    }

    pub(super) fn over(&mut self, a: Value, b: Value) -> Result<Value, Error> {
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

    pub(super) fn negated(&mut self, a: Value) -> Result<Value, Error> {
        self.minus(Value::ZERO, a)
    }

    /// Sine and cosine of an angle.
    pub(super) fn sin_cos(&mut self, angle: Value) -> Result<[Value; 2], Error> {
        if angle.value == Operand::Zero && !angle.varies() {
            return Ok([Value::ZERO, Value::constant(Operand::One)]);
        }
        let (first, second) = (self.fresh()?, self.fresh()?);
        let parts = [first.into(), second.into(), angle.value.into()];
        self.say(self.phrases.sin_cos, &parts)?;
        let (mut sin, mut cos) = (Value::constant(first), Value::constant(second));
        let slopes = sin.slopes.iter_mut().zip(&mut cos.slopes);
        for ((of_sin, of_cos), slope) in slopes.zip(angle.slopes) {
            *of_sin = self.product(cos.value, slope)?;
            let negative = self.product(sin.value, slope)?;
            *of_cos = self.difference(Operand::Zero, negative)?;
        }
        Ok([sin, cos])
    }

    /// The length of a vector.
    pub(super) fn norm(&mut self, vector: [Value; 3]) -> Result<Value, Error> {
        let is_zero = |v: &Value| v.value == Operand::Zero && !v.varies();
        let [x, y, z] = vector;
        if is_zero(&y) && is_zero(&z) {
            let mut length = Value::constant(self.constant(self.phrases.abs, &[x.value])?);
            for (slope, own) in length.slopes.iter_mut().zip(x.slopes) {
                if own != Operand::Zero {
                    *slope = self.constant(self.phrases.magnitude_slope, &[x.value, own])?;
                }
            }
            return Ok(length);
        }
        let mut square = Value::ZERO;
        for own in vector {
            let own = self.times(own, own)?;
            square = self.plus(square, own)?;
        }
        let mut length = Value::constant(self.constant(self.phrases.sqrt, &[square.value])?);
        let parts = x.slopes.into_iter().zip(y.slopes.into_iter().zip(z.slopes));
        let slopes = length.slopes.iter_mut().zip(square.slopes);
        for ((slope, own), (of_x, (of_y, of_z))) in slopes.zip(parts) {
            if own == Operand::Zero {
                continue;
            }
            // A vector along the x axis is as long as that coordinate is far from zero.
            let along = self.constant(self.phrases.magnitude_slope, &[x.value, of_x])?;
            let operands = [y.value, of_y, z.value, of_z, along, length.value, own];
            *slope = self.constant(self.phrases.length_slope, &operands)?;
        }
        Ok(length)
    }
}

fn full(_: fmt::Error) -> Error {
    Error::CapacityExceeded("the text of a region's code")
}
