//! What a constraint comes to in one state, in numbers.

use crate::domain::{Domain, MAX_PARAMETERS, Node, NodeId, PointSet, Range, Scene};
use crate::grammar::{Comparison, Constraint, Formula};
use crate::text::write_number;
use core::fmt::{self, Write};

/// What a constraint bounds, with all that the state tells taken to the other side.
pub(super) struct Here<'f> {
    formula: &'f Formula,
    bounded: Bounded,
}

enum Bounded {
    /// The left side is a number whatever the parameters are.
    Number(f64),
    /// This expression has to be so, and lies between these values.
    Expression {
        node: NodeId,
        comparison: Comparison,
        bound: f64,
        between: Range<f64>,
        /// Whether something was taken to the other side.
        moved: bool,
    },
}

impl<'f> Here<'f> {
    /// What the only constraint of a formula comes to in an instance; `None` if there are
    /// several, or if it cannot be told.
    pub(super) fn new(
        domain: &Domain<'_>,
        instance: &[f64],
        formula: &'f Formula,
    ) -> Option<Here<'f>> {
        let [constraint] = formula.constraints() else {
            return None;
        };
        let scene = Scene::<f64>::new(domain, instance, PointSet::all(domain)).ok()?;
        let mut theta = [Range {
            low: 0.0,
            high: 0.0,
        }; MAX_PARAMETERS];
        for (range, own) in theta.iter_mut().zip(domain.parameters()) {
            *range = Range {
                low: own.low,
                high: own.high,
            };
        }
        let sample = scene.sample(theta.get(..domain.parameters().len())?);
        let nodes = formula.nodes();
        let measure = |node| sample.measure(nodes, node);
        let Constraint {
            lhs,
            comparison,
            rhs,
            ..
        } = *constraint;
        let bound = known(measure(rhs))?;
        let bounded = match (known(measure(lhs)), nodes.get(usize::from(lhs.0))) {
            (Some(number), _) => Bounded::Number(number),
            (None, Some(Node::Difference(left, right))) => {
                let sides = [*left, *right].map(|side| known(measure(side)));
                match sides {
                    [None, Some(right)] => Bounded::Expression {
                        node: *left,
                        comparison,
                        bound: bound + right,
                        between: measure(*left),
                        moved: true,
                    },
                    [Some(left), None] => Bounded::Expression {
                        node: *right,
                        comparison: comparison.mirrored(),
                        bound: left - bound,
                        between: measure(*right),
                        moved: true,
                    },
                    _ => return None,
                }
            }
            (None, _) => Bounded::Expression {
                node: lhs,
                comparison,
                bound,
                between: measure(lhs),
                moved: false,
            },
        };
        Some(Here { formula, bounded })
    }

    /// Writes it behind the constraint.
    ///
    /// # Errors
    /// Those of `out`.
    pub(super) fn write(&self, domain: &Domain<'_>, out: &mut dyn Write) -> fmt::Result {
        let (low, high) = match &self.bounded {
            Bounded::Number(number) => (*number, *number),
            Bounded::Expression { between, .. } => (between.low, between.high),
        };
        if let Bounded::Expression {
            node,
            comparison,
            bound,
            moved: true,
            ..
        } = &self.bounded
        {
            out.write_str(", here ")?;
            domain.write_expression(out, self.formula.nodes(), *node)?;
            out.write_char(' ')?;
            out.write_str(comparison.symbol())?;
            out.write_char(' ')?;
            write_rounded(out, *bound)?;
        }
        if low.is_finite() && high.is_finite() {
            out.write_str(", and it is ")?;
            write_rounded(out, low)?;
            if low < high {
                out.write_str(" to ")?;
                write_rounded(out, high)?;
            }
        }
        Ok(())
    }
}

/// The number that a range is.
fn known(range: Range<f64>) -> Option<f64> {
    (range.low == range.high).then_some(range.low)
}

/// Writes a number to a thousandth, which is enough to understand it.
fn write_rounded(out: &mut dyn Write, number: f64) -> fmt::Result {
    let rounded = libm::round(number * 1e3) / 1e3;
    // Zero has no sign here.
    write_number(out, rounded + 0.0)
}
