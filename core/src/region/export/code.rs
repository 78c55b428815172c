//! Straight-line code: constants, each computed once from those before it.

use super::phrases::Phrases;
use crate::domain::Extreme;
use crate::error::Error;
use crate::region::program::{Case, Operand, Operation, Program};
use crate::text::write_number;
use core::fmt;
use heapless::Vec;

/// Most operands of a template.
const MOST_OPERANDS: usize = 8;

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
    phrases: &'static Phrases,
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
    fn constant(&mut self, template: &str, operands: &[Operand]) -> Result<Operand, Error> {
        self.bound(self.phrases.real, template, operands)
    }

    /// A constant that says yes or no.
    fn flag(&mut self, template: &str, operands: &[Operand]) -> Result<Operand, Error> {
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
}

impl Program for Code<'_> {
    fn operation(&mut self, operation: Operation) -> Result<Operand, Error> {
        let phrases = self.phrases;
        match operation {
            Operation::Number(number) => {
                let constant = self.fresh()?;
                self.say(phrases.real, &[constant.into()])?;
                self.say(phrases.number, &[Part::Number(number)])?;
                self.raw(";\n")?;
                Ok(constant)
            }
            Operation::Sum(a, b) => self.constant("$a + $b", &[a, b]),
            Operation::Difference(Operand::Zero, b) => self.constant("-$a", &[b]),
            Operation::Difference(a, b) => self.constant("$a - $b", &[a, b]),
            Operation::Product(a, b) => self.constant("$a * $b", &[a, b]),
            Operation::Quotient(a, b) => self.constant("$a / $b", &[a, b]),
            Operation::Magnitude(a) => self.constant(phrases.abs, &[a]),
            Operation::Root(a) => self.constant(phrases.sqrt, &[a]),
            Operation::ArcTangent(y, x) => self.constant(phrases.atan2, &[y, x]),
            Operation::Least(..) | Operation::Greatest(..) | Operation::Extreme(..) => Err(
                Error::InvalidArgument("an extreme is written as code member by member"),
            ),
        }
    }

    fn sine_and_cosine(&mut self, angle: Operand) -> Result<[Operand; 2], Error> {
        let both = [self.fresh()?, self.fresh()?];
        let [first, second] = both;
        let parts = [first.into(), second.into(), angle.into()];
        self.say(self.phrases.sin_cos, &parts)?;
        Ok(both)
    }

    fn cases(&mut self, case: Case, operands: &[Operand]) -> Result<Operand, Error> {
        let [above, below] = self.phrases.infinite;
        let template = match case {
            Case::MagnitudeSlope => self.phrases.magnitude_slope,
            Case::LengthSlope => self.phrases.length_slope,
            Case::Ratio => self.phrases.ratio,
            Case::Nothing(Extreme::Least) => above,
            Case::Nothing(Extreme::Greatest) => below,
            Case::Counts(Extreme::Least) => return self.flag("$a == $a && $b < $c", operands),
            Case::Counts(Extreme::Greatest) => return self.flag("$a == $a && $b > $c", operands),
            Case::Choice => self.phrases.choose,
        };
        self.constant(template, operands)
    }

    /// Frames are multiplied, as scenes do.
    fn keeps_angles(&self) -> bool {
        false
    }

    fn check_bodies(&self) -> Result<(), Error> {
        Err(Error::InvalidArgument(
            "a relation between bodies cannot be written as code; use the library for this region",
        ))
    }

    fn require_positive(&mut self, _: Operand) -> Result<(), Error> {
        self.check_bodies()
    }
}

fn full(_: fmt::Error) -> Error {
    Error::CapacityExceeded("the text of a region's code")
}
