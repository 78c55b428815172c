//! What an expression measures, what it depends on, and its value if that is known.

use super::unit::Unit;
use crate::domain::node::node_at;
use crate::domain::{Beam, Body, Coordinate, Dimension, Domain, Node, NodeId, Quantity};

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
    /// What an expression measures; `None` for a literal, and where there is no word for it:
    /// both fit anything.
    pub fn dimension(&self, nodes: &[Node], id: NodeId) -> Option<Dimension> {
        self.unit(nodes, id).dimension()
    }

    fn unit(&self, nodes: &[Node], id: NodeId) -> Unit {
        let of = |dimension: Option<Dimension>| dimension.map_or(Unit::Any, Unit::Of);
        if let Some(feature) = self.feature_of(nodes, id)
            && feature.dimension.is_some()
        {
            return of(feature.dimension);
        }
        let Ok(node) = node_at(nodes, id) else {
            return Unit::Any;
        };
        match node {
            Node::Number(_) => Unit::Any,
            Node::Constant(i) => of(self.constants().get(usize::from(i)).map(|c| c.dimension)),
            Node::Parameter(i) => of(self.parameters().get(usize::from(i)).map(|p| p.dimension)),
            Node::Area(_) => Unit::Of(Dimension::Area),
            Node::Quantity(quantity) | Node::Extreme(_, quantity) => of(self.measured_by(quantity)),
            Node::Sum(a, b) | Node::Difference(a, b) => {
                self.unit(nodes, a).plus(self.unit(nodes, b))
            }
            Node::Product(a, b) => self.unit(nodes, a).times(self.unit(nodes, b)),
            Node::Quotient(a, b) => self.unit(nodes, a).over(self.unit(nodes, b)),
        }
    }

    pub(super) fn measured_by(&self, quantity: Quantity) -> Option<Dimension> {
        match quantity {
            Quantity::Attribute(slot) => self.slot(slot).map(|(_, a)| a.dimension),
            Quantity::Coordinate(Coordinate::X | Coordinate::Y | Coordinate::Z, _)
            | Quantity::Distance(..)
            | Quantity::Gap(..)
            | Quantity::Relation(..)
            | Quantity::Sight(..) => Some(Dimension::Length),
            Quantity::Coordinate(Coordinate::Theta, _)
            | Quantity::Angle(..)
            | Quantity::FoldedAngle(..)
            | Quantity::Off(..)
            | Quantity::VertexAngle(..) => Some(Dimension::Angle),
        }
    }

    /// What an expression depends on.
    pub fn dependence(&self, nodes: &[Node], id: NodeId) -> Dependence {
        match node_at(nodes, id) {
            Err(_) | Ok(Node::Number(_) | Node::Constant(_) | Node::Area(_)) => {
                Dependence::Constant
            }
            Ok(Node::Parameter(_)) => Dependence::Sample,
            Ok(term @ (Node::Quantity(_) | Node::Extreme(..))) => {
                let mut found = Dependence::Instance;
                self.quantities(term, &mut |quantity| {
                    let mut points = quantity.points().into_iter().flatten();
                    let sized = |id| self.dependence(self.nodes(), id) == Dependence::Sample;
                    if points.any(|p| self.moves(p)) || self.sizes_of(quantity).any(sized) {
                        found = Dependence::Sample;
                    }
                });
                found
            }
            Ok(
                Node::Sum(a, b)
                | Node::Difference(a, b)
                | Node::Product(a, b)
                | Node::Quotient(a, b),
            ) => self.dependence(nodes, a).max(self.dependence(nodes, b)),
        }
    }

    /// A bit for each parameter in an expression; parameters of points do not count.
    pub(in crate::domain) fn parameters_of(&self, nodes: &[Node], id: NodeId) -> u32 {
        let Ok(node) = node_at(nodes, id) else {
            return 0;
        };
        match node.operands() {
            Some((a, b, _)) => self.parameters_of(nodes, a) | self.parameters_of(nodes, b),
            None => self.parameters_of_leaf(node),
        }
    }

    /// The bits of a parameter, or of those in the sizes of the bodies that a term is
    /// about; none for another term.
    pub(in crate::domain) fn parameters_of_leaf(&self, leaf: Node) -> u32 {
        let mut bits = parameter_bit(leaf);
        self.quantities(leaf, &mut |quantity| {
            for size in self.sizes_of(quantity) {
                bits |= self.parameters_of(self.nodes(), size);
            }
        });
        bits
    }

    /// The terms of the sizes of the bodies that a quantity is about.
    fn sizes_of(&self, quantity: Quantity) -> impl Iterator<Item = NodeId> {
        let points = match quantity {
            Quantity::Relation(_, a, b) | Quantity::Sight(Beam::Sweep, a, _, b) => {
                [Some(a), Some(b)]
            }
            Quantity::Sight(Beam::Line, _, _, body) => [Some(body), None],
            Quantity::Attribute(_)
            | Quantity::Coordinate(..)
            | Quantity::Distance(..)
            | Quantity::Gap(..)
            | Quantity::Angle(..)
            | Quantity::FoldedAngle(..)
            | Quantity::Off(..)
            | Quantity::VertexAngle(..) => [None; 2],
        };
        let bodies = points.into_iter().flatten();
        let bodies = bodies.filter_map(|point| self.body_of(point));
        bodies.flat_map(Body::terms)
    }

    /// Whether a number of an instance is in an expression; numbers that points depend on
    /// do not count.
    pub(in crate::domain) fn reads(&self, nodes: &[Node], id: NodeId, slot: u8) -> bool {
        let Ok(node) = node_at(nodes, id) else {
            return false;
        };
        match node.operands() {
            Some((a, b, _)) => self.reads(nodes, a, slot) || self.reads(nodes, b, slot),
            None => self.is_about(node, slot),
        }
    }

    /// Whether a term is a number of an instance, or an extreme that is taken of it.
    pub(in crate::domain) fn is_about(&self, term: Node, slot: u8) -> bool {
        let mut found = false;
        self.quantities(term, &mut |own| {
            found |= match own {
                Quantity::Attribute(own) | Quantity::Gap(_, _, _, own) => own == slot,
                _ => false,
            };
            let mut sizes = self.sizes_of(own);
            found |= sizes.any(|size| self.reads(self.nodes(), size, slot));
        });
        found
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
            Node::Quotient(a, b) => Some(value(a)? / value(b)?),
            Node::Parameter(_) | Node::Area(_) | Node::Quantity(_) | Node::Extreme(..) => None,
        }
    }
}

/// The bit of a parameter; none for another term.
fn parameter_bit(term: Node) -> u32 {
    let parameter = term.parameter();
    parameter.map_or(0, |p| 1u32.checked_shl(u32::from(p)).unwrap_or(0))
}
