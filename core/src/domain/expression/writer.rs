//! Writes expressions.

use super::words::{self, Function};
use crate::domain::node::node_at;
use crate::domain::{Domain, Metric, Node, NodeId, Quantity, Share};
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
        if let Some(feature) = self.feature_of(nodes, id) {
            return out.write_str(feature.name);
        }
        if let Some(negated) = negated(nodes, node) {
            out.write_char('-')?;
            return self.write_term(out, nodes, negated, Precedence::Factor);
        }
        let (a, operator, b, own) = match node {
            Node::Number(value) => return write_number(out, value),
            Node::Constant(i) => {
                let constant = self.constants().get(usize::from(i));
                return out.write_str(constant.ok_or(fmt::Error)?.name);
            }
            Node::Parameter(i) => {
                let parameter = self.parameters().get(usize::from(i));
                return out.write_str(parameter.ok_or(fmt::Error)?.name);
            }
            Node::Area(shape) => return self.write_area(out, shape),
            Node::Quantity(quantity) => return self.write_quantity(out, quantity),
            Node::Extreme(extreme, quantity) => {
                out.write_str(extreme.name())?;
                out.write_char('(')?;
                self.write_quantity(out, quantity)?;
                return out.write_char(')');
            }
            Node::Sum(a, b) => (a, " + ", b, Precedence::Sum),
            Node::Difference(a, b) => (a, " - ", b, Precedence::Sum),
            Node::Product(a, b) => (a, "*", b, Precedence::Product),
            Node::Quotient(a, b) => (a, "/", b, Precedence::Product),
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

    fn write_area(&self, out: &mut dyn fmt::Write, shape: u8) -> fmt::Result {
        let (object, _) = self.shapes().get(usize::from(shape)).ok_or(fmt::Error)?;
        let object = self.objects().get(usize::from(*object)).ok_or(fmt::Error)?;
        out.write_str(words::name_of(Function::Area).ok_or(fmt::Error)?)?;
        out.write_char('(')?;
        out.write_str(object.name)?;
        out.write_char(')')
    }

    fn write_quantity(&self, out: &mut dyn fmt::Write, quantity: Quantity) -> fmt::Result {
        match quantity {
            Quantity::Attribute(slot) => {
                let (object, attribute) = self.slot(slot).ok_or(fmt::Error)?;
                out.write_str(object.name)?;
                out.write_char('.')?;
                out.write_str(attribute.name)
            }
            Quantity::Coordinate(coordinate, point) => {
                self.write_point(out, point)?;
                out.write_char('.')?;
                out.write_str(words::name_of_coordinate(coordinate).ok_or(fmt::Error)?)
            }
            Quantity::Gap(share, a, b, slot) => {
                self.write_quantity(out, Quantity::Distance(Metric::Straight, a, b))?;
                out.write_str(" - ")?;
                if share != Share::Whole {
                    write_number(out, share.factor())?;
                    out.write_char('*')?;
                }
                self.write_quantity(out, Quantity::Attribute(slot))
            }
            Quantity::Distance(..)
            | Quantity::Angle(..)
            | Quantity::Off(..)
            | Quantity::Relation(..)
            | Quantity::VertexAngle(..) => {
                out.write_str(words::name_of_quantity(quantity).ok_or(fmt::Error)?)?;
                self.write_points(out, quantity.points())
            }
            Quantity::FoldedAngle(symmetry, a, b) => {
                out.write_str(words::name_of_quantity(quantity).ok_or(fmt::Error)?)?;
                out.write_char('(')?;
                self.write_point(out, a)?;
                out.write_str(", ")?;
                self.write_point(out, b)?;
                match symmetry {
                    2 => write!(out, ", {})", words::PI),
                    4 => write!(out, ", 0.5*{})", words::PI),
                    n => write!(out, ", {} {n})", words::SYMMETRY),
                }
            }
            Quantity::Sight(beam, a, b, body) => {
                out.write_str(words::name_of_quantity(quantity).ok_or(fmt::Error)?)?;
                out.write_char('(')?;
                out.write_str(words::name_of_beam(beam).ok_or(fmt::Error)?)?;
                self.write_points(out, [Some(a), Some(b), None])?;
                out.write_str(", ")?;
                self.write_point(out, body)?;
                out.write_char(')')
            }
        }
    }

    /// Writes points in brackets.
    fn write_points(&self, out: &mut dyn fmt::Write, points: [Option<u8>; 3]) -> fmt::Result {
        let mut before = "(";
        for point in points.iter().flatten() {
            out.write_str(before)?;
            self.write_point(out, *point)?;
            before = ", ";
        }
        out.write_char(')')
    }

    fn write_point(&self, out: &mut dyn fmt::Write, point: u8) -> fmt::Result {
        if let Some(compound) = self.compound(point) {
            return out.write_str(compound.name);
        }
        let point = self.points().get(usize::from(point)).ok_or(fmt::Error)?;
        out.write_str(point.owner)?;
        if !point.part.is_empty() {
            out.write_char('.')?;
            out.write_str(point.part)?;
        }
        Ok(())
    }
}

/// The term `x`, if a term is `-x`: that is read as `0 - x`, but `-2` as a number.
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
