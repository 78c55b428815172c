//! Writes formulas.

use super::{Constraint, Formula, Step, before};
use crate::domain::Domain;
use core::fmt;

impl Formula {
    /// Writes the formula so that reading it gives the same formula.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write(&self, domain: &Domain<'_>, out: &mut dyn fmt::Write) -> fmt::Result {
        match self.steps.len().checked_sub(1) {
            None => out.write_str("true"),
            Some(last) => self.write_step(domain, out, last, Precedence::Or),
        }
    }

    fn write_step(
        &self,
        domain: &Domain<'_>,
        out: &mut dyn fmt::Write,
        at: usize,
        place: Precedence,
    ) -> fmt::Result {
        let (word, own) = match self.steps.get(at).ok_or(fmt::Error)? {
            Step::True => return out.write_str("true"),
            Step::Constraint(index) => {
                let constraint = self.constraints.get(usize::from(*index));
                return self.write_constraint(domain, out, constraint.ok_or(fmt::Error)?);
            }
            Step::Not => {
                out.write_str("not ")?;
                return self.write_step(domain, out, before(at)?, Precedence::Literal);
            }
            Step::And => (" and ", Precedence::And),
            Step::Or => (" or ", Precedence::Or),
        };
        let right = before(at)?;
        let left = before(self.start_of(right)?)?;
        let brackets = own < place;
        if brackets {
            out.write_char('(')?;
        }
        self.write_step(domain, out, left, own)?;
        out.write_str(word)?;
        self.write_step(domain, out, right, own.above())?;
        if brackets {
            out.write_char(')')?;
        }
        Ok(())
    }

    /// Writes one constraint of the formula.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_constraint(
        &self,
        domain: &Domain<'_>,
        out: &mut dyn fmt::Write,
        constraint: &Constraint,
    ) -> fmt::Result {
        domain.write_expression(out, &self.nodes, constraint.lhs)?;
        out.write_char(' ')?;
        out.write_str(constraint.comparison.symbol())?;
        out.write_char(' ')?;
        domain.write_expression(out, &self.nodes, constraint.rhs)?;
        if let Some(name) = constraint.name {
            out.write_str(" (")?;
            domain.write_expression(out, &self.nodes, name)?;
            out.write_char(')')?;
        }
        Ok(())
    }
}

#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Precedence {
    Or,
    And,
    Literal,
}

impl Precedence {
    fn above(self) -> Precedence {
        match self {
            Precedence::Or => Precedence::And,
            Precedence::And | Precedence::Literal => Precedence::Literal,
        }
    }
}
