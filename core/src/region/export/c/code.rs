//! Straight-line C: constants, each computed once from those before it.

use crate::error::Error;
use crate::region::program::{Operand, Operation, Program};
use crate::text::write_number;
use core::fmt;

/// Where the name of what is written stands in pieces of C.
const NAME: u8 = b'@';

/// Writes C, and numbers what it computes.
pub(super) struct Code<'o> {
    out: &'o mut dyn fmt::Write,
    name: &'o str,
    next: u16,
}

impl<'o> Code<'o> {
    pub(super) fn new(out: &'o mut dyn fmt::Write, name: &'o str) -> Self {
        Code { out, name, next: 0 }
    }

    /// Writes C, with the name of what is written in place of each `@`.
    pub(super) fn text(&mut self, text: &str) -> Result<(), Error> {
        let mut rest = text;
        while let Some(place) = rest.bytes().position(|byte| byte == NAME) {
            self.raw(rest.get(..place).unwrap_or_default())?;
            self.raw(self.name)?;
            rest = rest.get(place.saturating_add(1)..).unwrap_or_default();
        }
        self.raw(rest)
    }

    /// Writes text as it is.
    pub(super) fn raw(&mut self, text: &str) -> Result<(), Error> {
        self.out.write_str(text).map_err(full)
    }

    pub(super) fn whole(&mut self, number: usize) -> Result<(), Error> {
        write!(self.out, "{number}").map_err(full)
    }

    /// What is written by something else.
    pub(super) fn written(
        &mut self,
        write: impl FnOnce(&mut dyn fmt::Write) -> fmt::Result,
    ) -> Result<(), Error> {
        write(self.out).map_err(full)
    }

    pub(super) fn operand(&mut self, operand: Operand) -> Result<(), Error> {
        match operand {
            Operand::Zero => self.text("(@_real)0"),
            Operand::One => self.text("(@_real)1"),
            Operand::Slot(place) => self.place("instance[", place),
            Operand::Theta(place) => self.place("theta[", place),
            Operand::Temp(number) => write!(self.out, "t{number}").map_err(full),
        }
    }

    fn place(&mut self, array: &str, place: u8) -> Result<(), Error> {
        write!(self.out, "{array}{place}]").map_err(full)
    }

    /// The next constant of the code.
    fn fresh(&mut self) -> Result<Operand, Error> {
        let full = Error::CapacityExceeded("constants of a region's C");
        let number = self.next;
        self.next = number.checked_add(1).ok_or(full)?;
        Ok(Operand::Temp(number))
    }
}

impl Program for Code<'_> {
    fn operation(&mut self, operation: Operation) -> Result<Operand, Error> {
        match operation {
            Operation::Number(number) => {
                let constant = self.fresh()?;
                self.text("    @_LET ")?;
                self.operand(constant)?;
                self.text(" = (@_real)")?;
                write_number(self.out, number).map_err(full)?;
                self.raw(";\n")?;
                Ok(constant)
            }
            Operation::Sum(a, b) => self.cases(&["", " + "], &[a, b]),
            Operation::Difference(Operand::Zero, b) => self.cases(&["-"], &[b]),
            Operation::Difference(a, b) => self.cases(&["", " - "], &[a, b]),
            Operation::Product(a, b) => self.cases(&["", " * "], &[a, b]),
            Operation::Magnitude(a) => self.cases(&["@_abs(", ")"], &[a]),
            Operation::Root(a) => self.cases(&["@_sqrt(", ")"], &[a]),
            Operation::ArcTangent(y, x) => self.cases(&["@_atan2(", ", ", ")"], &[y, x]),
            Operation::Least(..) | Operation::Greatest(..) | Operation::Extreme(..) => Err(
                Error::InvalidArgument("an extreme is written as C member by member"),
            ),
        }
    }

    fn sine_and_cosine(&mut self, angle: Operand) -> Result<[Operand; 2], Error> {
        let both = [self.fresh()?, self.fresh()?];
        let [first, second] = both;
        self.text("    @_real ")?;
        self.operand(first)?;
        self.raw(", ")?;
        self.operand(second)?;
        self.text(";\n    @_sin_cos(")?;
        self.operand(angle)?;
        for place in both {
            self.raw(", &")?;
            self.operand(place)?;
        }
        self.text(");\n")?;
        Ok(both)
    }

    /// Frames are multiplied, as scenes do.
    fn keeps_angles(&self) -> bool {
        false
    }

    fn check_bodies(&self) -> Result<(), Error> {
        Err(Error::InvalidArgument(
            "a relation between bodies cannot be written as C; use the library for this region",
        ))
    }

    fn require_positive(&mut self, _: Operand) -> Result<(), Error> {
        self.check_bodies()
    }

    fn cases(&mut self, pieces: &[&str], operands: &[Operand]) -> Result<Operand, Error> {
        let constant = self.fresh()?;
        self.text("    @_LET ")?;
        self.operand(constant)?;
        self.raw(" = ")?;
        let mut operands = operands.iter();
        for piece in pieces {
            self.text(piece)?;
            if let Some(operand) = operands.next() {
                self.operand(*operand)?;
            }
        }
        self.raw(";\n")?;
        Ok(constant)
    }
}

fn full(_: fmt::Error) -> Error {
    Error::CapacityExceeded("the text of a region's C")
}
