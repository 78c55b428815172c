//! Reads formulas.

use super::{Comparison, Constraint, Formula, Step};
use crate::domain::{Domain, NodeId};
use crate::error::Error;
use crate::text::{Failed, Lexer, Token};

impl Formula {
    /// Reads a formula; the whole text must be one.
    ///
    /// # Errors
    /// [`Error::Syntax`] with line and column; [`Error::CapacityExceeded`].
    pub fn parse(domain: &Domain<'_>, text: &str) -> Result<Formula, Error> {
        let mut parser = FormulaParser {
            domain,
            lexer: Lexer::new(text),
            formula: Formula::everything(),
            depth: 0,
        };
        let read = parser.whole();
        parser.lexer.outcome(read)?;
        if parser.formula.steps.as_slice() == [Step::True] {
            return Ok(Formula::everything());
        }
        Ok(parser.formula)
    }
}

/// Deepest nesting of brackets and `not` in a formula's text.
const MAX_NESTING: u8 = 12;

struct FormulaParser<'d, 't, 's> {
    domain: &'d Domain<'t>,
    lexer: Lexer<'s>,
    formula: Formula,
    depth: u8,
}

impl FormulaParser<'_, '_, '_> {
    fn whole(&mut self) -> Result<(), Failed> {
        self.disjunction()?;
        match self.lexer.token() {
            Token::End => Ok(()),
            _ => Err(self.lexer.fail("expected `and`, `or` or the end")),
        }
    }

    fn disjunction(&mut self) -> Result<(), Failed> {
        self.conjunction()?;
        while self.lexer.accept("or") {
            self.conjunction()?;
            self.push_step(Step::Or)?;
        }
        Ok(())
    }

    fn conjunction(&mut self) -> Result<(), Failed> {
        self.literal()?;
        while self.lexer.accept("and") {
            self.literal()?;
            self.push_step(Step::And)?;
        }
        Ok(())
    }

    fn literal(&mut self) -> Result<(), Failed> {
        if self.depth >= MAX_NESTING {
            return Err(self.lexer.fail("the formula is nested too deeply"));
        }
        self.depth += 1;
        let read = self.nested_literal();
        self.depth -= 1;
        read
    }

    fn nested_literal(&mut self) -> Result<(), Failed> {
        if self.lexer.accept("not") {
            self.literal()?;
            return self.push_step(Step::Not);
        }
        if self.lexer.accept("true") {
            return self.push_step(Step::True);
        }
        if self.lexer.token() != Token::Symbol("(") {
            return self.constraint();
        }
        // A bracket opens an expression or a formula: try both, and report the
        // error of the reading that got further.
        let (lexer, formula) = (self.lexer.clone(), &self.formula);
        let kept = (
            formula.nodes.len(),
            formula.constraints.len(),
            formula.steps.len(),
        );
        if self.constraint().is_ok() {
            return Ok(());
        }
        let as_constraint = core::mem::replace(&mut self.lexer, lexer);
        self.formula.truncate(kept);
        self.lexer.advance();
        let as_formula = self.bracketed();
        if as_formula.is_err() {
            self.lexer.note_further(&as_constraint);
        }
        as_formula
    }

    /// A formula and the bracket that closes it.
    fn bracketed(&mut self) -> Result<(), Failed> {
        self.disjunction()?;
        self.lexer.expect(")", "expected `and`, `or` or `)`")
    }

    fn constraint(&mut self) -> Result<(), Failed> {
        let left = self.expression()?;
        let at = self.lexer.place();
        let comparison = Comparison::ALL
            .into_iter()
            .find(|c| self.lexer.token() == Token::Symbol(c.symbol()))
            .ok_or_else(|| self.lexer.fail_at(at, "expected `<`, `<=`, `>=` or `>`"))?;
        self.lexer.advance();
        let right = self.expression()?;
        let mut name = None;
        if self.lexer.accept("(") {
            name = Some(self.expression()?);
            self.lexer
                .expect(")", "expected `)` behind the name of the bound")?;
        }
        let dimension = |id: NodeId| self.domain.dimension(&self.formula.nodes, id);
        let sides = [Some(left), Some(right), name].map(|id| id.and_then(dimension));
        let mut measured = sides.iter().flatten();
        if let Some(first) = measured.next()
            && measured.any(|d| d != first)
        {
            return Err(self
                .lexer
                .fail_at(at, "the two sides have different dimensions"));
        }
        let constraint = Constraint {
            left,
            comparison,
            right,
            name,
        };
        let pushed = self.formula.push_constraint(constraint);
        pushed.map_err(|full| self.lexer.note(full))
    }

    fn push_step(&mut self, step: Step) -> Result<(), Failed> {
        let pushed = self.formula.push_step(step);
        pushed.map_err(|full| self.lexer.note(full))
    }

    fn expression(&mut self) -> Result<NodeId, Failed> {
        self.domain
            .read_expression(&mut self.lexer, &mut self.formula.nodes)
    }
}
