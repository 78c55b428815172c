//! A constraint with extremes, along a line of parameters.
//!
//! The least of several curves is not a curve. But if one member is chosen in each
//! extreme, the sides of the constraint are curves. Where the sides are equal, they are
//! equal for the members that have the least or greatest values there. So the constraint
//! can change only at the roots of all choices. Whether it does so at a root, and what
//! holds between two roots, follows from evaluating the constraint itself.

use crate::domain::{Arithmetic, Curve, Line, MAX_PARAMETERS, Node, NodeId, Sample, Scene};
use crate::grammar::{Comparison, Constraint};
use crate::real::Real;
use heapless::Vec;

/// Most extremes that vary along a line, in one constraint.
const MAX_EXTREMES: usize = 4;
/// Most ways of choosing a member in each extreme.
const MAX_CHOICES: usize = 1024;

/// A line of parameters, and a scene along that line.
#[derive(Clone, Copy)]
pub(super) struct Along<'s, 'a, R> {
    pub(super) scene: &'s Scene<'a, R>,
    pub(super) theta: &'s [Line<R>],
    pub(super) sample: &'s Sample<'s, 'a, R, Line<R>>,
}

/// A constraint along a line, and the ways of choosing one member in each extreme.
pub(super) struct Choices<'s, 'a, R> {
    along: Along<'s, 'a, R>,
    nodes: &'s [Node],
    constraint: &'s Constraint,
    /// The extremes that vary, and how many members each has.
    extremes: Vec<(NodeId, usize), MAX_EXTREMES>,
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
            extremes: Vec::new(),
        };
        choices.collect(constraint.lhs)?;
        choices.collect(constraint.rhs)?;
        let known = choices.count() <= MAX_CHOICES && choices.curves().all(|c| c.is_known());
        known.then_some(choices)
    }

    pub(super) fn comparison(&self) -> Comparison {
        self.constraint.comparison
    }

    /// Left minus right, for each choice of members.
    pub(super) fn curves(&self) -> impl Iterator<Item = Curve<R>> {
        (0..self.count()).map(|choice| {
            let [lhs, rhs] = [self.constraint.lhs, self.constraint.rhs].map(|id| {
                let chosen = |extreme| self.chosen(choice, extreme);
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

    /// Finds the extremes of an expression that vary; `None` if there are too many.
    fn collect(&mut self, id: NodeId) -> Option<()> {
        match self.nodes.get(usize::from(id.0))? {
            Node::Sum(a, b) | Node::Difference(a, b) | Node::Product(a, b) => {
                self.collect(*a)?;
                self.collect(*b)
            }
            Node::Extreme(_, quantity) => {
                let sample = self.along.sample;
                let found = self.extremes.iter().any(|(other, _)| *other == id);
                if found || sample.measure(self.nodes, id).is_known() {
                    return Some(());
                }
                let members = sample.member_count(*quantity);
                self.extremes.push((id, members)).ok()
            }
            Node::Number(_)
            | Node::Constant(_)
            | Node::Parameter(_)
            | Node::Area(_)
            | Node::Quantity(_) => Some(()),
        }
    }

    /// In how many ways one member can be chosen in each extreme.
    fn count(&self) -> usize {
        self.extremes.iter().map(|(_, members)| *members).product()
    }

    /// The member of an extreme in a choice: a digit of the number of the choice.
    fn chosen(&self, choice: usize, extreme: NodeId) -> Option<usize> {
        let mut rest = choice;
        for (id, members) in &self.extremes {
            if *id == extreme {
                return rest.checked_rem(*members);
            }
            rest = rest.checked_div(*members)?;
        }
        None
    }
}
