//! Writes expressions.

use crate::domain::node::{name_of, node_at};
use crate::domain::{Coordinate, Domain, Metric, Node, NodeId};
use crate::text::write_number;
use core::fmt;

impl Domain<'_> {
    /// Writes an expression so that reading it gives the same expression.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_expression(
        &self,
        out: &mut dyn fmt::Write,
        nodes: &[Node],
        id: NodeId,
    ) -> fmt::Result {
        self.write_term(out, nodes, id, Precedence::Sum)
    }

    fn write_term(
        &self,
        out: &mut dyn fmt::Write,
        nodes: &[Node],
        id: NodeId,
        place: Precedence,
    ) -> fmt::Result {
        let Ok(node) = node_at(nodes, id) else {
            return Err(fmt::Error);
        };
        if let Some(negated) = negated(nodes, node) {
            out.write_char('-')?;
            return self.write_term(out, nodes, negated, Precedence::Factor);
        }
        let (a, operator, b, own) = match node {
            Node::Sum(a, b) => (a, " + ", b, Precedence::Sum),
            Node::Difference(a, b) => (a, " - ", b, Precedence::Sum),
            Node::Product(a, b) => (a, "*", b, Precedence::Product),
            leaf => return self.write_leaf(out, leaf),
        };
        let brackets = own < place;
        if brackets {
            out.write_char('(')?;
        }
        self.write_term(out, nodes, a, own)?;
        out.write_str(operator)?;
        self.write_term(out, nodes, b, own.above())?;
        if brackets {
            out.write_char(')')?;
        }
        Ok(())
    }

    fn write_leaf(&self, out: &mut dyn fmt::Write, node: Node) -> fmt::Result {
        match node {
            Node::Number(value) => write_number(out, value),
            Node::Constant(i) => {
                out.write_str(self.constants().get(usize::from(i)).map_or("?", |c| c.name))
            }
            Node::Attribute(i) => {
                let (object, attribute) = self.slot(i).ok_or(fmt::Error)?;
                out.write_str(object.name)?;
                out.write_char('.')?;
                out.write_str(attribute.name)
            }
            Node::Parameter(i) => out.write_str(
                self.parameters()
                    .get(usize::from(i))
                    .map_or("?", |p| p.name),
            ),
            Node::Coordinate(coordinate, p) => {
                self.write_point(out, p)?;
                out.write_char('.')?;
                out.write_str(name_of(&Coordinate::NAMED, coordinate))
            }
            Node::Distance(metric, a, b) => {
                self.write_points(out, name_of(&Metric::NAMED, metric), &[a, b])
            }
            Node::Angle(a, b) => self.write_points(out, "angle", &[a, b]),
            Node::VertexAngle(a, b, c) => self.write_points(out, "angle", &[a, b, c]),
            Node::Area(shape) => {
                let (object, _) = self.shapes().get(usize::from(shape)).ok_or(fmt::Error)?;
                let object = self.objects().get(usize::from(*object)).ok_or(fmt::Error)?;
                out.write_str("area(")?;
                out.write_str(object.name)?;
                out.write_char(')')
            }
            Node::Extreme(extreme, relation) => {
                out.write_str(extreme.name())?;
                out.write_char('(')?;
                self.write_leaf(out, relation.term())?;
                out.write_char(')')
            }
            Node::Sum(..) | Node::Difference(..) | Node::Product(..) => Err(fmt::Error),
        }
    }

    fn write_points(&self, out: &mut dyn fmt::Write, name: &str, points: &[u8]) -> fmt::Result {
        out.write_str(name)?;
        let mut before = "(";
        for point in points {
            out.write_str(before)?;
            self.write_point(out, *point)?;
            before = ", ";
        }
        out.write_char(')')
    }

    fn write_point(&self, out: &mut dyn fmt::Write, point: u8) -> fmt::Result {
        let point = self.points().get(usize::from(point)).ok_or(fmt::Error)?;
        out.write_str(point.owner)?;
        if !point.part.is_empty() {
            out.write_char('.')?;
            out.write_str(point.part)?;
        }
        Ok(())
    }
}

/// What a term is the negative of: `-x` is read as `0 - x`, but `-2` as a number.
fn negated(nodes: &[Node], node: Node) -> Option<NodeId> {
    let Node::Difference(zero, term) = node else {
        return None;
    };
    let is_zero = matches!(node_at(nodes, zero), Ok(Node::Number(0.0)));
    let is_number = matches!(node_at(nodes, term), Ok(Node::Number(_)));
    (is_zero && !is_number).then_some(term)
}

#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Precedence {
    Sum,
    Product,
    Factor,
}

impl Precedence {
    fn above(self) -> Precedence {
        match self {
            Precedence::Sum => Precedence::Product,
            Precedence::Product | Precedence::Factor => Precedence::Factor,
        }
    }
}
