//! Reads formulas.

use super::{Comparison, Constraint, Formula, Step};
use crate::domain::{Domain, MAX_DEPTH, NodeId};
use crate::error::Error;
use crate::text::{Failed, Lexer, Token};

impl Formula {
    /// Reads a formula; the whole text must be one.
    ///
    /// # Errors
    /// [`Error::Syntax`] with line and column; [`Error::CapacityExceeded`].
    pub fn parse(domain: &Domain<'_>, text: &str) -> Result<Formula, Error> {
        let mut formula = Formula::everything();
        formula.read(domain, text)?;
        Ok(formula)
    }

    /// As [`Formula::parse`], in place: formulas are large.
    ///
    /// # Errors
    /// Those of [`Formula::parse`]. After one it is no formula of any use.
    #[inline(never)]
    pub(crate) fn read(&mut self, domain: &Domain<'_>, text: &str) -> Result<(), Error> {
        self.clear();
        let mut parser = FormulaParser {
            domain,
            lexer: Lexer::new(text),
            formula: self,
            depth: 0,
        };
        let read = parser.whole();
        parser.lexer.outcome(read)?;
        if self.steps.as_slice() == [Step::True] {
            self.clear();
        }
        Ok(())
    }
}

struct FormulaParser<'f, 'd, 't, 's> {
    domain: &'d Domain<'t>,
    lexer: Lexer<'s>,
    formula: &'f mut Formula,
    depth: u8,
}

impl FormulaParser<'_, '_, '_, '_> {
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
        if self.depth >= MAX_DEPTH {
            return Err(self.lexer.fail("the formula is nested deeper than 12"));
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
        if self.lexer.token() != Token::Symbol("(") || !self.opens_formula() {
            return self.constraint();
        }
        self.lexer.advance();
        self.disjunction()?;
        self.lexer.expect(")", "expected `and`, `or` or `)`")
    }

    /// Whether the bracket that it stands on is one of a formula: something in it is
    /// compared or joined. All others belong to expressions.
    #[inline(never)]
    fn opens_formula(&self) -> bool {
        let mut ahead = self.lexer.clone();
        let mut open = 0u32;
        loop {
            match ahead.advance() {
                Token::Symbol("(") => open = open.saturating_add(1),
                Token::Symbol(")") if open > 1 => open -= 1,
                Token::Symbol(")") | Token::End => return false,
                Token::Name("and" | "or" | "not" | "true") => return true,
                token if is_compared(token) => return true,
                _ => {}
            }
        }
    }

    fn constraint(&mut self) -> Result<(), Failed> {
        let lhs = self.expression()?;
        let at = self.lexer.place();
        let comparison = comparison(self.lexer.token())
            .ok_or_else(|| self.lexer.fail_at(at, "expected `<`, `<=`, `>=` or `>`"))?;
        self.lexer.advance();
        let rhs = self.expression()?;
        let mut name = None;
        if self.lexer.accept("(") {
            name = Some(self.expression()?);
            self.lexer
                .expect(")", "expected `)` behind the name of the bound")?;
        }
        let dimension = |id: NodeId| self.domain.dimension(&self.formula.nodes, id);
        let sides = [Some(lhs), Some(rhs), name].map(|id| id.and_then(dimension));
        let mut measured = sides.iter().flatten();
        if let Some(first) = measured.next()
            && measured.any(|d| d != first)
        {
            return Err(self
                .lexer
                .fail_at(at, "the two sides have different dimensions"));
        }
        if is_compared(self.lexer.token()) {
            return Err(self
                .lexer
                .fail("write two constraints joined by `and`: 0 <= a and a <= 1"));
        }
        let constraint = Constraint {
            lhs,
            comparison,
            rhs,
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

/// The comparison that a token is.
fn comparison(token: Token<'_>) -> Option<Comparison> {
    let mut all = Comparison::ALL.into_iter();
    all.find(|comparison| token == Token::Symbol(comparison.symbol()))
}

fn is_compared(token: Token<'_>) -> bool {
    comparison(token).is_some()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::format;
    use std::string::{String, ToString};

    fn read(text: &str) -> Result<String, String> {
        let domain = Domain::parse("parameter a in [0, 1] parameter b in [0, 1]").unwrap();
        let formula = Formula::parse(&domain, text).map_err(|error| error.to_string())?;
        let mut written = String::new();
        formula.write(&domain, &mut written).unwrap();
        Ok(written)
    }

    #[test]
    fn a_bracket_belongs_to_a_formula_or_to_an_expression() {
        for (text, written) in [
            ("((a + 1)*(b + 1) < 2)", "(a + 1)*(b + 1) < 2"),
            ("(a) < 1 (b)", "a < 1 (b)"),
            ("(not (a < 1)) and (true)", "not a < 1 and true"),
            (
                "((a) < 1 or (b < 1)) and a > b",
                "(a < 1 or b < 1) and a > b",
            ),
        ] {
            assert_eq!(read(text).as_deref(), Ok(written), "{text}");
        }
        for (text, error) in [
            ("(a", "column 3: expected `)`"),
            ("(a < 1", "column 7: expected `and`, `or` or `)`"),
            ("(a + (b < 1))", "column 9: expected `)`"),
            ("(a)", "column 4: expected `<`, `<=`, `>=` or `>`"),
            ("()", "column 2: expected a number, a name or `(`"),
            (
                "0 < a < 1",
                "column 7: write two constraints joined by `and`: 0 <= a and a <= 1",
            ),
            (
                "(0 <= a >= 1)",
                "column 9: write two constraints joined by `and`: 0 <= a and a <= 1",
            ),
            ("(a < 1) < 2", "column 9: expected `and`, `or` or the end"),
            ("(a < ?)", "column 6: expected a number, a name or `(`"),
        ] {
            assert_eq!(read(text), Err(format!("line 1, {error}")), "{text}");
        }
    }

    #[test]
    fn the_error_names_the_deepest_nesting() {
        const FORMULA: &str = "the formula is nested deeper than 12";
        const EXPRESSION: &str =
            "the expression is nested deeper than 12; brackets and operators in a row count";
        let brackets = |n: usize, inner: &str| format!("{}{inner}{}", "(".repeat(n), ")".repeat(n));
        let row = |n: usize, operator: &str| format!("{}a < 1", format!("a{operator}").repeat(n));
        let last = usize::from(MAX_DEPTH) - 1;
        // What is read at the last level, and not any more one level deeper.
        type Nested<'n> = &'n dyn Fn(usize) -> String;
        let cases: [(Nested<'_>, &str); 6] = [
            (&|n| brackets(n, "a < 1"), FORMULA),
            (&|n| format!("{}a < 1", "not ".repeat(n)), FORMULA),
            (&|n| format!("{} < 1", brackets(n, "a")), EXPRESSION),
            (&|n| format!("a < {}", brackets(n, "1")), EXPRESSION),
            (&|n| row(n + 1, " + "), EXPRESSION),
            (&|n| row(n + 1, "*"), EXPRESSION),
        ];
        for (nested, error) in cases {
            assert!(read(&nested(last)).is_ok(), "{}", nested(last));
            let deeper = read(&nested(last + 1)).unwrap_err();
            assert!(deeper.ends_with(&format!(": {error}")), "{deeper}");
        }
        // What is written without brackets is counted as it is written.
        let left = |n: usize| format!("(a{}){} < 1", " + b".repeat(n), " - b".repeat(n));
        assert_eq!(
            read(&left(6)),
            Ok(format!("a{}{} < 1", " + b".repeat(6), " - b".repeat(6)))
        );
        let deeper = read(&left(7)).unwrap_err();
        assert!(deeper.ends_with(&format!(": {EXPRESSION}")), "{deeper}");
        // Formulas and expressions are counted apart, and another error is not hidden.
        let both = brackets(last, &format!("{} < 1", brackets(last, "a")));
        assert!(read(&both).is_ok());
        let broken = read(&both.replace('a', "?")).unwrap_err();
        assert!(
            broken.ends_with("expected a number, a name or `(`"),
            "{broken}"
        );
    }
}
