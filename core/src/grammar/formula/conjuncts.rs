//! Formulas as what they join by `and`.

use super::{Constraint, Formula, Inequality, MAX_CONSTRAINTS, Step};
use crate::domain::{Node, copy, is_same};
use crate::error::Error;
use core::ops::Range;
use heapless::Vec;

/// One of the statements that a formula joins by `and`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Conjunct {
    /// Its place among them.
    pub index: usize,
    /// The places of its constraints in the formula.
    pub constraints: Range<usize>,
}

/// A walk along a formula that tells whether [`Formula::and`] made it of certain
/// statements.
pub(crate) struct FormulaComparison<'f> {
    formula: &'f Formula,
    constraints: usize,
    steps: usize,
}

impl FormulaComparison<'_> {
    /// Whether the next statement says that one of these inequalities holds; their terms
    /// are in `nodes`.
    pub(crate) fn next_is(&mut self, nodes: &[Node], any_of: &[Inequality]) -> bool {
        let joined = self.steps > 0;
        let mut same = true;
        for (index, own) in any_of.iter().enumerate() {
            same &= self.is_constraint(nodes, own);
            same &= index == 0 || self.is_step(Step::Or);
        }
        same && (!joined || any_of.is_empty() || self.is_step(Step::And))
    }

    /// Whether there is no further statement.
    pub(crate) fn is_at_end(&self) -> bool {
        self.steps == self.formula.steps.len()
    }

    fn is_constraint(&mut self, nodes: &[Node], own: &Inequality) -> bool {
        let place = self.constraints;
        self.constraints += 1;
        let known = self.formula.constraints.get(place).is_some_and(|other| {
            let ours = &self.formula.nodes;
            let rhs = Node::Number(own.bound);
            let named = match (other.name, own.name) {
                (None, None) => true,
                (Some(a), Some(b)) => is_same(ours, a, nodes, b),
                _ => false,
            };
            named
                && other.comparison == own.comparison
                && ours.get(usize::from(other.rhs.0)) == Some(&rhs)
                && is_same(ours, other.lhs, nodes, own.lhs)
        });
        known && u8::try_from(place).is_ok_and(|place| self.is_step(Step::Constraint(place)))
    }

    fn is_step(&mut self, step: Step) -> bool {
        self.steps += 1;
        self.formula.steps.get(self.steps - 1) == Some(&step)
    }
}

impl Formula {
    /// A walk from its beginning, to compare it with statements.
    pub(crate) fn comparison(&self) -> FormulaComparison<'_> {
        FormulaComparison {
            formula: self,
            constraints: 0,
            steps: 0,
        }
    }

    /// The formula made of some of its conjuncts.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`], for a formula whose brackets leave no room for its
    /// conjuncts alone.
    pub fn select(&self, mut keep: impl FnMut(&Conjunct) -> bool) -> Result<Formula, Error> {
        let mut selected = Formula::everything();
        let mut before = 0;
        for (index, steps) in self.conjuncts()?.iter().enumerate() {
            let steps = self.steps.get(steps.clone()).unwrap_or_default();
            let own = steps.iter().filter(|s| matches!(s, Step::Constraint(_)));
            let constraints = before..before + own.count();
            before = constraints.end;
            if keep(&Conjunct { index, constraints }) {
                self.copy_steps(steps, &mut selected)?;
            }
        }
        Ok(selected)
    }

    /// How many statements it joins by `and`; none if it is `true`.
    pub fn conjunct_count(&self) -> usize {
        self.conjuncts().map_or(0, |conjuncts| conjuncts.len())
    }

    /// The steps of each conjunct.
    fn conjuncts(&self) -> Result<Vec<Range<usize>, MAX_CONSTRAINTS>, Error> {
        const FULL: Error = Error::CapacityExceeded("statements that a formula joins");
        let mut conjuncts = Vec::new();
        // The last steps of what is still to be taken apart.
        let mut ends: Vec<usize, MAX_CONSTRAINTS> = Vec::new();
        if let Some(last) = self.steps.len().checked_sub(1) {
            ends.push(last).map_err(|_| FULL)?;
        }
        while let Some(end) = ends.pop() {
            let start = self.start_of(end).map_err(|_| FULL)?;
            if self.steps.get(end) != Some(&Step::And) {
                conjuncts.push(start..end + 1).map_err(|_| FULL)?;
                continue;
            }
            let right = end.checked_sub(1).ok_or(FULL)?;
            let middle = self.start_of(right).map_err(|_| FULL)?;
            let left = middle.checked_sub(1).ok_or(FULL)?;
            ends.push(left).map_err(|_| FULL)?;
            ends.push(right).map_err(|_| FULL)?;
        }
        conjuncts.reverse();
        Ok(conjuncts)
    }

    /// Adds `and` and a statement of this formula to another one.
    fn copy_steps(&self, steps: &[Step], to: &mut Formula) -> Result<(), Error> {
        let joined = !to.steps.is_empty();
        for step in steps {
            match step {
                Step::Constraint(index) => match self.constraints.get(usize::from(*index)) {
                    Some(constraint) => self.copy_constraint(constraint, to)?,
                    None => continue,
                },
                other => to.push_step(*other)?,
            }
        }
        if joined {
            to.push_step(Step::And)
        } else {
            Ok(())
        }
    }

    fn copy_constraint(&self, constraint: &Constraint, to: &mut Formula) -> Result<(), Error> {
        let name = constraint.name;
        let copied = Constraint {
            lhs: copy(&self.nodes, constraint.lhs, &mut to.nodes)?,
            comparison: constraint.comparison,
            rhs: copy(&self.nodes, constraint.rhs, &mut to.nodes)?,
            name: match name {
                Some(name) => Some(copy(&self.nodes, name, &mut to.nodes)?),
                None => None,
            },
        };
        to.push_constraint(copied)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Domain;
    use std::string::String;
    use std::vec::Vec;

    #[test]
    fn what_is_joined_by_and_comes_apart_in_order() {
        let domain = Domain::parse("parameter a in [0, 1] parameter b in [0, 1]").unwrap();
        let cases: [(&str, &[&str]); 5] = [
            ("true", &[]),
            ("a < 0.5", &["a < 0.5"]),
            (
                "a < 0.5 and (b < 0.25 or a > b) and not b > 0.75",
                &["a < 0.5", "b < 0.25 or a > b", "not b > 0.75"],
            ),
            (
                "a < 0.5 and (b < 0.25 and (a > b and a < 1))",
                &["a < 0.5", "b < 0.25", "a > b", "a < 1"],
            ),
            (
                "a < 0.5 or b < 0.25 and a > b",
                &["a < 0.5 or b < 0.25 and a > b"],
            ),
        ];
        for (text, parts) in cases {
            let formula = Formula::parse(&domain, text).unwrap();
            assert_eq!(formula.conjunct_count(), parts.len(), "{text}");
            let mut ends = Vec::new();
            for (wanted, part) in parts.iter().enumerate() {
                let one = formula.select(|conjunct| {
                    if conjunct.index == wanted {
                        ends.push(conjunct.constraints.clone());
                    }
                    conjunct.index == wanted
                });
                let mut written = String::new();
                one.unwrap().write(&domain, &mut written).unwrap();
                assert_eq!(written, *part);
            }
            let all = formula.constraints().len();
            assert!(ends.windows(2).all(|pair| pair[0].end == pair[1].start));
            assert_eq!(ends.last().map_or(0, |last| last.end), all);
            assert_eq!(
                formula.select(|_| true).unwrap().conjunct_count(),
                parts.len()
            );
        }
    }
}
