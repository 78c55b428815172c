//! A sample along a line of parameters.

use super::Sample;
use super::bodies::Bodies;
use crate::domain::algebra::{Arithmetic, Curve, Line};
use crate::domain::node::{Node, NodeId, Quantity};
use crate::real::Real;

/// Along a line, an extreme and a relation between bodies are made of curves, of which one
/// counts at each position.
impl<R: Real> Sample<'_, '_, R, Line<R>> {
    /// How many curves a term is made of: one for each member of a group, and for each piece
    /// of a relation.
    pub(crate) fn curve_count(&self, term: Node) -> usize {
        match term {
            Node::Quantity(quantity) => self.piece_count(quantity),
            Node::Extreme(_, quantity) => {
                let members = self.scene.of_members(quantity);
                members.count() * self.most_pieces(quantity)
            }
            Node::Number(_)
            | Node::Constant(_)
            | Node::Parameter(_)
            | Node::Area(_)
            | Node::Sum(..)
            | Node::Difference(..)
            | Node::Product(..) => 1,
        }
    }

    /// As [`Sample::measure`], with one curve in place of a term where `chosen` has one for
    /// it, by its number. One that does not exist is infinite: it has no roots.
    pub(crate) fn measure_choosing(
        &self,
        nodes: &[Node],
        id: NodeId,
        chosen: &impl Fn(NodeId) -> Option<usize>,
    ) -> Curve<R> {
        match (nodes.get(usize::from(id.0)), chosen(id)) {
            (Some(Node::Extreme(_, quantity)), Some(index)) => {
                let pieces = self.most_pieces(*quantity).max(1);
                let member = self.scene.of_members(*quantity).nth(index / pieces);
                member.map_or_else(Curve::unknown, |own| self.curve(own, index % pieces))
            }
            (Some(Node::Quantity(quantity)), Some(index)) => self.curve(*quantity, index),
            (Some(node), _) => self.node(*node, |id| self.measure_choosing(nodes, id, chosen)),
            (None, _) => Curve::unknown(),
        }
    }

    /// One curve of a quantity.
    fn curve(&self, quantity: Quantity, index: usize) -> Curve<R> {
        let nowhere = || Curve::constant(R::INFINITY);
        match self.bodies(quantity) {
            Some((bodies, _)) if bodies.are_absent() => nowhere(),
            Some((Bodies::Pair(pair, difference), _)) => {
                pair.piece(index, difference).unwrap_or_else(nowhere)
            }
            Some((Bodies::Sight(sight, ends), _)) => {
                sight.piece(index, ends).unwrap_or_else(nowhere)
            }
            None => self.leaf(Node::Quantity(quantity)),
        }
    }

    fn piece_count(&self, quantity: Quantity) -> usize {
        match self.bodies(quantity) {
            Some((Bodies::Pair(pair, _), _)) => pair.piece_count(),
            Some((Bodies::Sight(sight, ends), _)) => sight.piece_count(ends),
            None => 1,
        }
    }

    fn most_pieces(&self, quantity: Quantity) -> usize {
        let members = self.scene.of_members(quantity);
        members.map(|own| self.piece_count(own)).max().unwrap_or(1)
    }
}
