//! The two sides of a constraint with extremes, along a line of parameters.
//!
//! The least of several curves is none, but for each choice of one member in each
//! extreme the sides are curves, and wherever the sides are equal, those of the
//! members that count there are. So the roots of all choices are where the
//! constraint can change its mind. In between, and for the question whether the
//! members of a root are the ones that count, the constraint itself is evaluated.

use crate::domain::{Arithmetic, Curve, Line, MAX_PARAMETERS, Node, NodeId, Sample, Scene};
use crate::grammar::{Comparison, Constraint};
use crate::real::Real;
use heapless::Vec;

/// Most extremes that vary along a line, in one constraint.
const MAX_EXTREMES: usize = 4;
/// Most choices of a member in each.
const MAX_CHOICES: usize = 1024;

/// Positions on a line of parameters, as numbers and as a line.
#[derive(Clone, Copy)]
pub(super) struct Along<'s, 'a, R> {
    pub(super) scene: &'s Scene<'a, R>,
    pub(super) theta: &'s [Line<R>],
    pub(super) sample: &'s Sample<'s, 'a, R, Line<R>>,
}

/// A constraint along a line.
pub(super) struct Gaps<'s, 'a, R> {
    along: Along<'s, 'a, R>,
    nodes: &'s [Node],
    constraint: &'s Constraint,
    /// The extremes that vary, and over how many members each is taken.
    extremes: Vec<(NodeId, usize), MAX_EXTREMES>,
}

impl<'s, 'a, R: Real> Gaps<'s, 'a, R> {
    /// `None` if its curves are too many or not all known.
    pub(super) fn new(
        along: Along<'s, 'a, R>,
        nodes: &'s [Node],
        constraint: &'s Constraint,
    ) -> Option<Self> {
        let mut gaps = Gaps {
            along,
            nodes,
            constraint,
            extremes: Vec::new(),
        };
        gaps.collect(constraint.left)?;
        gaps.collect(constraint.right)?;
        let known = gaps.choices() <= MAX_CHOICES && gaps.curves().all(|c| c.is_known());
        known.then_some(gaps)
    }

    pub(super) fn comparison(&self) -> Comparison {
        self.constraint.comparison
    }

    /// Left minus right, for each choice of members.
    pub(super) fn curves(&self) -> impl Iterator<Item = Curve<R>> {
        (0..self.choices()).map(|choice| {
            let [left, right] = [self.constraint.left, self.constraint.right].map(|id| {
                let chosen = |extreme| self.chosen(choice, extreme);
                self.along.sample.measure_choosing(self.nodes, id, &chosen)
            });
            left.minus(right)
        })
    }

    /// Whether the constraint holds at `t`.
    pub(super) fn holds(&self, t: R) -> bool {
        let [left, right] = self.sides(t);
        self.constraint.comparison.holds(&left, &right)
    }

    /// Whether the two sides are equal at `t` but for rounding.
    pub(super) fn is_near_zero(&self, t: R) -> bool {
        let [left, right] = self.sides(t);
        let tolerance = R::SQRT_EPSILON * (R::ONE + left.abs() + right.abs());
        (left - right).abs() <= tolerance
    }

    fn sides(&self, t: R) -> [R; 2] {
        let mut theta = [R::ZERO; MAX_PARAMETERS];
        for (value, line) in theta.iter_mut().zip(self.along.theta) {
            *value = line.value(t);
        }
        let sample = self.along.scene.sample::<R>(&theta);
        [self.constraint.left, self.constraint.right].map(|id| sample.measure(self.nodes, id))
    }

    /// Finds the extremes of an expression that vary; `None` if they are too many.
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

    /// How many choices there are of one member in each extreme.
    fn choices(&self) -> usize {
        self.extremes.iter().map(|(_, members)| *members).product()
    }

    /// The member of an extreme in a choice: its digit in the choice's number.
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
