//! A sample along a line of parameters.

use super::Sample;
use super::bodies::Bodies;
use crate::domain::algebra::{Algebra, Arithmetic, Curve, Line, Range};
use crate::domain::node::{Node, NodeId, Quantity, period};
use crate::domain::schema::MAX_PARAMETERS;
use crate::real::Real;

/// More multiples than that are too many to try each.
const MAX_MULTIPLES: f64 = 1000.0;

/// Along a line, an extreme and a relation between bodies are made of curves, of which one
/// counts at each position.
impl<R: Real> Sample<'_, '_, R, Line<R>> {
    /// How many curves a term is made of: one for each piece of a relation, of each member of
    /// a group and each part of a compound.
    pub(crate) fn curve_count(&self, term: Node) -> usize {
        match term {
            Node::Quantity(_) | Node::Extreme(..) => {
                let mut count = 0;
                self.each_single(term, &mut |_| count += 1);
                count * self.most_pieces(term)
            }
            Node::Number(_)
            | Node::Constant(_)
            | Node::Parameter(_)
            | Node::Area(_)
            | Node::Sum(..)
            | Node::Difference(..)
            | Node::Product(..)
            | Node::Quotient(..) => 1,
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
            (Some(term @ (Node::Extreme(..) | Node::Quantity(_))), Some(index)) => {
                self.chosen_curve(*term, index)
            }
            (Some(node), _) => self.node(*node, |id| self.measure_choosing(nodes, id, chosen)),
            (None, _) => Curve::unknown(),
        }
    }

    /// One of the curves that a term is made of.
    fn chosen_curve(&self, term: Node, index: usize) -> Curve<R> {
        let pieces = self.most_pieces(term);
        let (wanted, piece) = (index.checked_div(pieces), index.checked_rem(pieces));
        let (mut place, mut found) = (0, None);
        self.each_single(term, &mut |own| {
            if Some(place) == wanted {
                found = Some(own);
            }
            place += 1;
        });
        let curve = found.zip(piece);
        curve.map_or_else(Curve::unknown, |(own, piece)| self.curve(own, piece))
    }

    /// Visits the quantity of each member and of each part that a term is about.
    fn each_single(&self, term: Node, visit: &mut dyn FnMut(Quantity)) {
        match term {
            Node::Extreme(_, quantity) => {
                for own in self.scene.of_members(quantity) {
                    self.scene.domain.each_part(own, visit);
                }
            }
            _ => {
                if let Some(quantity) = term.quantity() {
                    self.scene.domain.each_part(quantity, visit);
                }
            }
        }
    }

    /// The most pieces that one of these quantities has, and at least one.
    fn most_pieces(&self, term: Node) -> usize {
        let mut most = 1;
        self.each_single(term, &mut |own| most = most.max(self.piece_count(own)));
        most
    }

    /// One curve of a quantity.
    fn curve(&self, quantity: Quantity, index: usize) -> Curve<R> {
        let curve = match (quantity, self.bodies(quantity)) {
            (Quantity::FoldedAngle(n, a, b), _) => self.folded(n, [a, b], index),
            (_, Some((bodies, _))) if bodies.are_absent() => None,
            (_, Some((Bodies::Pair(pair, difference), _))) => pair.piece(index, difference),
            (_, Some((Bodies::Sight(sight, ends), _))) => sight.piece(index, ends),
            (_, None) => Some(self.leaf(Node::Quantity(quantity))),
        };
        curve.unwrap_or_else(|| Curve::constant(R::INFINITY))
    }

    fn piece_count(&self, quantity: Quantity) -> usize {
        match (quantity, self.bodies(quantity)) {
            (Quantity::FoldedAngle(n, a, b), _) => {
                let multiples = self.multiples(n, [a, b]);
                multiples.map_or(1, |(_, count)| count)
            }
            (_, Some((Bodies::Pair(pair, _), _))) => pair.piece_count(),
            (_, Some((Bodies::Sight(sight, ends), _))) => sight.piece_count(ends),
            (_, None) => 1,
        }
    }

    /// How far a folded angle is from one of the multiples that can be the nearest one.
    fn folded(&self, symmetry: u8, points: [u8; 2], index: usize) -> Option<Curve<R>> {
        let turned = self.scene.turned(points, self.theta);
        let (Some(turned), Some((first, count))) = (turned, self.multiples(symmetry, points))
        else {
            return Some(self.folded_angle(symmetry, points));
        };
        let multiple = (index < count).then_some(first + index as f64)?;
        let from = Line::constant(R::from_f64(multiple * period(symmetry)));
        let zero = Line::constant(R::ZERO);
        Some(Line::norm([turned.minus(from), zero, zero]))
    }

    /// The first and the number of the multiples that an angle between two points can be
    /// nearest to, with whatever parameters.
    fn multiples(&self, symmetry: u8, points: [u8; 2]) -> Option<(f64, usize)> {
        let mut all = [Range::constant(R::ZERO); MAX_PARAMETERS];
        for (range, parameter) in all.iter_mut().zip(self.scene.domain.parameters()) {
            let [low, high] = [parameter.low, parameter.high].map(R::from_f64);
            *range = Range { low, high };
        }
        let Range { low, high } = self.scene.turned(points, &all)?;
        let nearest = |end: R| libm::floor(end.to_f64() / period(symmetry) + 0.5);
        let [first, last] = [low, high].map(nearest);
        let count = last - first;
        (count < MAX_MULTIPLES).then_some((first, 1 + count as usize))
    }
}
