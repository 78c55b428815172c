//! How many bits it takes to write down a bound.

use super::{DirectedForm, Forms};
use crate::domain::{Metric, Node, Quantity};
use crate::geometry::Relation;
use crate::real::Real;

impl<R: Real> Forms<'_, R> {
    /// The length of a bound's description in bits: which form, unless it is named
    /// already, which direction, and which threshold of those that the samples tell
    /// apart.
    pub(in super::super) fn bound_length(&self, form: &DirectedForm, named: bool) -> f64 {
        let level = self.level_length.get(usize::from(form.level));
        let length = match self.sum(form) {
            Some(sum) => Some(f64::from(sum.length)),
            None => level.map(|level| level + self.class_length(form)),
        };
        let length = length.filter(|_| !named);
        length.unwrap_or(self.tuning.form_again) + self.threshold_length()
    }

    /// What a form costs for what it measures, in bits.
    pub(super) fn class_length(&self, form: &DirectedForm) -> f64 {
        let tuning = self.tuning;
        let lhs = self.left_term(form);
        let node = self.features.nodes().get(usize::from(lhs.0));
        let quantity = match node.filter(|_| self.has_bodies) {
            Some(Node::Quantity(quantity) | Node::Extreme(_, quantity)) => quantity,
            Some(Node::Parameter(_)) => return tuning.parameter_class,
            _ => return 0.0,
        };
        match quantity {
            Quantity::Relation(Relation::Coordinate(_), ..) => tuning.parameter_class,
            Quantity::Relation(
                Relation::InsideAlong(_) | Relation::Corner | Relation::Magnitude(_),
                ..,
            )
            | Quantity::Angle(..)
            | Quantity::FoldedAngle(..)
            | Quantity::Off(..)
            | Quantity::VertexAngle(..) => tuning.axis_class,
            Quantity::Relation(..) | Quantity::Attribute(_) => 0.0,
            Quantity::Distance(Metric::Straight, ..) | Quantity::Gap(..) | Quantity::Sight(..) => {
                tuning.distance_class
            }
            Quantity::Distance(..) | Quantity::Coordinate(..) => tuning.world_class,
        }
    }

    /// The length of a threshold's description, among those that the samples tell apart.
    pub(in super::super) fn threshold_length(&self) -> f64 {
        self.threshold_length
    }
}
