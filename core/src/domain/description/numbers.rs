//! Statements that declare numbers: constants and parameters.

use super::parser::DomainParser;
use crate::domain::{Constant, Dimension, Parameter};
use crate::text::Failed;

impl DomainParser<'_, '_> {
    #[inline(never)]
    pub(super) fn constant_statement(&mut self) -> Result<(), Failed> {
        let name = self.new_name("expected the name of the constant", true)?;
        self.lexer.expect("=", "expected `=` and a value")?;
        let at = self.lexer.place();
        let value = self.number()?;
        self.lexer
            .expect(":", "expected `:` and a dimension, as in `= 3.0: length`")?;
        let dimension = self.dimension()?;
        if let Some(measured) = value.1
            && measured != dimension
        {
            return Err(self
                .lexer
                .fail_at(at, "the value has another dimension than the constant"));
        }
        let constant = Constant {
            name,
            dimension,
            value: value.0,
        };
        self.domain
            .constants
            .push(constant)
            .map_err(|_| self.lexer.full("constants of a domain"))
    }

    #[inline(never)]
    pub(super) fn parameter_statement(&mut self) -> Result<(), Failed> {
        let name = self.new_name("expected the name of the parameter", false)?;
        self.lexer
            .expect("in", "expected `in` and a range, as in `in [0, 1]`")?;
        self.lexer
            .expect("[", "expected `[` and the smallest value")?;
        let (low, low_dimension) = self.number()?;
        self.lexer
            .expect(",", "expected `,` and the largest value")?;
        let at = self.lexer.place();
        let (high, high_dimension) = self.number()?;
        if low >= high {
            return Err(self
                .lexer
                .fail_at(at, "the largest value must be above the smallest"));
        }
        self.lexer.expect("]", "expected `]`")?;
        let measured = low_dimension.or(high_dimension);
        let dimension = if self.lexer.accept(":") {
            self.dimension()?
        } else {
            measured.unwrap_or(Dimension::None)
        };
        if [low_dimension, high_dimension]
            .iter()
            .flatten()
            .any(|d| *d != dimension)
        {
            return Err(self
                .lexer
                .fail_at(at, "the range has another dimension than the parameter"));
        }
        let parameter = Parameter {
            name,
            dimension,
            low,
            high,
        };
        self.domain
            .parameters
            .push(parameter)
            .map_err(|_| self.lexer.full("parameters of an action"))
    }

    /// Reads an expression over constants: its value, and what it measures.
    fn number(&mut self) -> Result<(f64, Option<Dimension>), Failed> {
        let at = self.lexer.place();
        let kept = self.domain.nodes.len();
        let id = self.expression()?;
        let dimension = self.domain.dimension(&self.domain.nodes, id);
        let value = self.domain.constant_value(&self.domain.nodes, id);
        self.domain.nodes.truncate(kept);
        match value {
            Some(value) if value.is_finite() => Ok((value, dimension)),
            Some(_) => Err(self.lexer.fail_at(at, "the value is too large")),
            None => Err(self
                .lexer
                .fail_at(at, "the value must be made of numbers and constants")),
        }
    }
}
