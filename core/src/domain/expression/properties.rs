//! What an expression measures, what it depends on, and its value if that is known.

use crate::domain::node::node_at;
use crate::domain::{Coordinate, Dimension, Domain, Node, NodeId};

/// What an expression depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Dependence {
    /// Literals and constants only.
    Constant,
    /// The problem instance.
    Instance,
    /// The parameters of the action.
    Sample,
}

impl Domain<'_> {
    /// What an expression measures; `None` for a literal, which fits anything.
    pub fn dimension(&self, nodes: &[Node], id: NodeId) -> Option<Dimension> {
        match node_at(nodes, id).ok()? {
            Node::Number(_) => None,
            Node::Constant(i) => self.constants().get(usize::from(i)).map(|c| c.dimension),
            Node::Attribute(i) => self.slot(i).map(|(_, a)| a.dimension),
            Node::Parameter(i) => self.parameters().get(usize::from(i)).map(|p| p.dimension),
            Node::Coordinate(Coordinate::Theta, _) | Node::Angle(..) | Node::VertexAngle(..) => {
                Some(Dimension::Angle)
            }
            Node::Coordinate(..) | Node::Distance(..) => Some(Dimension::Length),
            Node::Area(_) => Some(Dimension::Area),
            Node::Extreme(_, relation) => self.dimension(&[relation.term()], NodeId(0)),
            Node::Sum(a, b) | Node::Difference(a, b) => self
                .dimension(nodes, a)
                .or_else(|| self.dimension(nodes, b)),
            Node::Product(a, b) => {
                product_dimension(self.dimension(nodes, a), self.dimension(nodes, b)).ok()?
            }
        }
    }

    /// What an expression depends on.
    pub fn dependence(&self, nodes: &[Node], id: NodeId) -> Dependence {
        match node_at(nodes, id) {
            Ok(Node::Attribute(_)) => Dependence::Instance,
            Ok(Node::Parameter(_)) => Dependence::Sample,
            Ok(Node::Extreme(_, relation)) => self.dependence(&[relation.term()], NodeId(0)),
            Ok(Node::Sum(a, b) | Node::Difference(a, b) | Node::Product(a, b)) => {
                self.dependence(nodes, a).max(self.dependence(nodes, b))
            }
            Ok(leaf) => {
                let points = leaf.points().into_iter().flatten();
                let dependences = points.map(|i| match self.points().get(usize::from(i)) {
                    Some(point) if point.sampled => Dependence::Sample,
                    _ => Dependence::Instance,
                });
                dependences.max().unwrap_or(Dependence::Constant)
            }
            Err(_) => Dependence::Constant,
        }
    }

    /// A bit for each parameter in an expression, those of points left out.
    pub(in crate::domain) fn parameters_of(&self, nodes: &[Node], id: NodeId) -> u32 {
        match node_at(nodes, id) {
            Ok(Node::Parameter(p)) => 1u32.checked_shl(u32::from(p)).unwrap_or(0),
            Ok(Node::Sum(a, b) | Node::Difference(a, b) | Node::Product(a, b)) => {
                self.parameters_of(nodes, a) | self.parameters_of(nodes, b)
            }
            _ => 0,
        }
    }

    /// Whether a number of an instance occurs in an expression, that of points left
    /// out.
    pub(in crate::domain) fn reads(&self, nodes: &[Node], id: NodeId, slot: u8) -> bool {
        match node_at(nodes, id) {
            Ok(Node::Attribute(own)) => own == slot,
            Ok(Node::Sum(a, b) | Node::Difference(a, b) | Node::Product(a, b)) => {
                self.reads(nodes, a, slot) || self.reads(nodes, b, slot)
            }
            _ => false,
        }
    }

    /// The value of an expression that depends on constants only.
    pub fn constant_value(&self, nodes: &[Node], id: NodeId) -> Option<f64> {
        let value = |id| self.constant_value(nodes, id);
        match node_at(nodes, id).ok()? {
            Node::Number(value) => Some(value),
            Node::Constant(i) => self.constants().get(usize::from(i)).map(|c| c.value),
            Node::Sum(a, b) => Some(value(a)? + value(b)?),
            Node::Difference(a, b) => Some(value(a)? - value(b)?),
            Node::Product(a, b) => Some(value(a)? * value(b)?),
            _ => None,
        }
    }
}

/// The dimension of a product; literals scale, lengths make areas.
pub(super) fn product_dimension(
    a: Option<Dimension>,
    b: Option<Dimension>,
) -> Result<Option<Dimension>, &'static str> {
    use Dimension::{Area, Length, None as Plain};
    match (a, b) {
        (None, d) | (d, None) => Ok(d),
        (Some(Plain), d) | (d, Some(Plain)) => Ok(d),
        (Some(Length), Some(Length)) => Ok(Some(Area)),
        _ => Err("one factor of a product must be a plain number, or both lengths"),
    }
}
