//! A constraint with extremes or with relations between bodies, along a line of parameters.
//!
//! The least of several curves is not a curve, nor is a relation between bodies, which has
//! a piece for each face and corner. But if one member or piece is chosen for each such
//! term, the sides of the constraint are curves. Where the sides are equal, they are
//! equal for the members and pieces that count there. So the constraint
//! can change only at the roots of all choices. Whether it does so at a root, and what
//! holds between two roots, follows from evaluating the constraint itself.

use crate::domain::{Arithmetic, Curve, Line, MAX_PARAMETERS, Node, NodeId, Sample, Scene};
use crate::grammar::{Comparison, Constraint};
use crate::real::Real;
use heapless::Vec;

/// Most terms in one constraint that are made of several curves.
const MAX_VARYING: usize = 4;
/// Most ways of choosing a curve for each of them.
const MAX_CHOICES: usize = 1024;

/// A line of parameters, and a scene along that line.
#[derive(Clone, Copy)]
pub(super) struct Along<'s, 'a, R> {
    pub(super) scene: &'s Scene<'a, R>,
    pub(super) theta: &'s [Line<R>],
    pub(super) sample: &'s Sample<'s, 'a, R, Line<R>>,
}

/// A constraint along a line, and the ways of choosing one curve for each of its terms.
pub(super) struct Choices<'s, 'a, R> {
    along: Along<'s, 'a, R>,
    nodes: &'s [Node],
    constraint: &'s Constraint,
    /// The terms that are made of several curves, and of how many.
    varying: Vec<(NodeId, usize), MAX_VARYING>,
}

impl<'s, 'a, R: Real> Choices<'s, 'a, R> {
    /// `None` if there are too many curves, or one is unknown.
    pub(super) fn new(
        along: Along<'s, 'a, R>,
        nodes: &'s [Node],
        constraint: &'s Constraint,
    ) -> Option<Self> {
        let mut choices = Choices {
            along,
            nodes,
            constraint,
            varying: Vec::new(),
        };
        choices.collect(constraint.lhs)?;
        choices.collect(constraint.rhs)?;
        let known = choices.count() <= MAX_CHOICES && choices.curves().all(|c| c.is_known());
        known.then_some(choices)
    }

    pub(super) fn comparison(&self) -> Comparison {
        self.constraint.comparison
    }

    /// Left minus right, for each choice of curves.
    pub(super) fn curves(&self) -> impl Iterator<Item = Curve<R>> {
        (0..self.count()).map(|choice| {
            let [lhs, rhs] = [self.constraint.lhs, self.constraint.rhs].map(|id| {
                let chosen = |term| self.chosen(choice, term);
                self.along.sample.measure_choosing(self.nodes, id, &chosen)
            });
            lhs.minus(rhs)
        })
    }

    /// Whether the constraint holds at `t`.
    pub(super) fn holds(&self, t: R) -> bool {
        let [lhs, rhs] = self.sides(t);
        self.constraint.comparison.holds(&lhs, &rhs)
    }

    /// Whether the two sides are equal at `t`, up to rounding.
    pub(super) fn is_near_zero(&self, t: R) -> bool {
        let [lhs, rhs] = self.sides(t);
        let tolerance = R::SQRT_EPSILON * (R::ONE + lhs.abs() + rhs.abs());
        (lhs - rhs).abs() <= tolerance
    }

    fn sides(&self, t: R) -> [R; 2] {
        let mut theta = [R::ZERO; MAX_PARAMETERS];
        for (value, line) in theta.iter_mut().zip(self.along.theta) {
            *value = line.value(t);
        }
        let sample = self.along.scene.sample::<R>(&theta);
        [self.constraint.lhs, self.constraint.rhs].map(|id| sample.measure(self.nodes, id))
    }

    /// Finds the terms of an expression that are made of several curves; `None` if there are
    /// too many.
    fn collect(&mut self, id: NodeId) -> Option<()> {
        match self.nodes.get(usize::from(id.0))? {
            Node::Sum(a, b)
            | Node::Difference(a, b)
            | Node::Product(a, b)
            | Node::Quotient(a, b) => {
                self.collect(*a)?;
                self.collect(*b)
            }
            term @ (Node::Extreme(..) | Node::Quantity(_)) => {
                let sample = self.along.sample;
                let found = self.varying.iter().any(|(other, _)| *other == id);
                if found || sample.measure(self.nodes, id).is_known() {
                    return Some(());
                }
                self.varying.push((id, sample.curve_count(*term))).ok()
            }
            Node::Number(_) | Node::Constant(_) | Node::Parameter(_) | Node::Area(_) => Some(()),
        }
    }

    /// In how many ways one curve can be chosen for each term.
    fn count(&self) -> usize {
        self.varying.iter().map(|(_, curves)| *curves).product()
    }

    /// The curve of a term in a choice: a digit of the number of the choice.
    fn chosen(&self, choice: usize, term: NodeId) -> Option<usize> {
        let mut rest = choice;
        for (id, curves) in &self.varying {
            if *id == term {
                return rest.checked_rem(*curves);
            }
            rest = rest.checked_div(*curves)?;
        }
        None
    }
}
