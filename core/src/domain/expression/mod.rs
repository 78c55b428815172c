//! Expressions over a domain: the terms of offsets, features and constraints.
//!
//! An expression is a node in a list in which operands stand before the node that
//! uses them, so a list is evaluated in one sweep, and equal terms are stored once.

mod parser;

use super::dimension::Dimension;
use super::group::{Extreme, Relation};
use super::schema::Domain;
use crate::error::Error;
use crate::text::{Failed, Lexer, write_number};
use core::fmt;
use heapless::VecView;
use parser::ExpressionParser;

/// Index of a node in its list.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct NodeId(pub u16);

/// A number read off the pose of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coordinate {
    /// Position along the world's x axis.
    X,
    /// Position along the world's y axis.
    Y,
    /// Position along the world's z axis.
    Z,
    /// Heading in the world's x-y plane.
    Theta,
}

impl Coordinate {
    /// All of them, each with its name behind that of the point.
    const NAMED: [(&str, Coordinate); 4] = [
        ("x", Coordinate::X),
        ("y", Coordinate::Y),
        ("z", Coordinate::Z),
        ("theta", Coordinate::Theta),
    ];
}

/// How far apart two points are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Metric {
    /// `|a.x - b.x|`
    X,
    /// `|a.y - b.y|`
    Y,
    /// `|a.z - b.z|`
    Z,
    /// The length of the straight line between them, in 2D or 3D.
    Straight,
}

impl Metric {
    /// All of them, each with the name of its function.
    const NAMED: [(&str, Metric); 4] = [
        ("dist_x", Metric::X),
        ("dist_y", Metric::Y),
        ("dist_z", Metric::Z),
        ("dist", Metric::Straight),
    ];
}

/// The value with this name.
fn named<T: Copy>(all: &[(&str, T)], name: &str) -> Option<T> {
    let mut all = all.iter();
    all.find(|(own, _)| *own == name).map(|(_, value)| *value)
}

/// The name of a value.
fn name_of<T: PartialEq>(all: &[(&'static str, T)], value: T) -> &'static str {
    let mut all = all.iter();
    all.find(|(_, own)| *own == value)
        .map_or("?", |(name, _)| name)
}

/// One term. Indices of constants, attributes, points and shapes refer to the
/// domain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Node {
    /// A literal number; it fits every dimension.
    Number(f64),
    /// A constant.
    Constant(u8),
    /// An attribute of an object, by its place in an instance.
    Attribute(u8),
    /// A parameter of the action.
    Parameter(u8),
    /// A coordinate of a point.
    Coordinate(Coordinate, u8),
    /// The distance of two points.
    Distance(Metric, u8, u8),
    /// The angle between the x axes of two points, in `[0, pi]`.
    Angle(u8, u8),
    /// The angle at the second point between the directions to the first and to the
    /// third, in `[0, pi]`; zero where one of them is the second point itself.
    VertexAngle(u8, u8, u8),
    /// The area of a shape.
    Area(u8),
    /// The least or greatest value over the members of a group that an instance
    /// has.
    Extreme(Extreme, Relation),
    /// `a + b`
    Sum(NodeId, NodeId),
    /// `a - b`
    Difference(NodeId, NodeId),
    /// `a * b`
    Product(NodeId, NodeId),
}

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

/// Deepest nesting of an expression, so that walking one has bounded stack.
pub const MAX_DEPTH: u8 = 12;

/// Why a list of terms is of no use; small, because expressions are walked recursively.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TermError {
    /// A list is full.
    Full,
    /// A term is not in its list.
    Missing,
}

impl From<TermError> for Error {
    fn from(error: TermError) -> Error {
        match error {
            TermError::Full => Error::CapacityExceeded("terms of expressions"),
            TermError::Missing => Error::InvalidArgument("an expression refers to a missing term"),
        }
    }
}

/// Appends a node to a list, or finds it there.
///
/// # Errors
/// [`TermError::Full`].
pub(crate) fn intern(nodes: &mut VecView<Node>, node: Node) -> Result<NodeId, TermError> {
    let place = match nodes.iter().position(|n| *n == node) {
        Some(place) => place,
        None => {
            nodes.push(node).map_err(|_| TermError::Full)?;
            nodes.len() - 1
        }
    };
    u16::try_from(place)
        .map(NodeId)
        .map_err(|_| TermError::Full)
}

/// Whether two expressions, each in a list of its own, are the same.
pub(crate) fn is_same(nodes: &[Node], id: NodeId, others: &[Node], other: NodeId) -> bool {
    let same = |a, b| is_same(nodes, a, others, b);
    match (node_at(nodes, id), node_at(others, other)) {
        (Ok(Node::Sum(a, b)), Ok(Node::Sum(c, d)))
        | (Ok(Node::Difference(a, b)), Ok(Node::Difference(c, d)))
        | (Ok(Node::Product(a, b)), Ok(Node::Product(c, d))) => same(a, c) && same(b, d),
        (Ok(leaf), Ok(other)) => leaf == other,
        _ => false,
    }
}

/// Copies an expression from one list into another.
///
/// # Errors
/// [`TermError`].
pub(crate) fn copy(from: &[Node], id: NodeId, to: &mut VecView<Node>) -> Result<NodeId, TermError> {
    let node = node_at(from, id)?;
    let node = match node.operands() {
        Some((a, b, make)) => make(copy(from, a, to)?, copy(from, b, to)?),
        None => node,
    };
    intern(to, node)
}

pub(crate) fn node_at(nodes: &[Node], id: NodeId) -> Result<Node, TermError> {
    nodes
        .get(usize::from(id.0))
        .copied()
        .ok_or(TermError::Missing)
}

/// Makes a term of two operands.
type Operation = fn(NodeId, NodeId) -> Node;

impl Node {
    /// The operands of a sum, difference or product, and what makes one of others.
    pub(super) fn operands(self) -> Option<(NodeId, NodeId, Operation)> {
        match self {
            Node::Sum(a, b) => Some((a, b, Node::Sum)),
            Node::Difference(a, b) => Some((a, b, Node::Difference)),
            Node::Product(a, b) => Some((a, b, Node::Product)),
            _ => None,
        }
    }

    /// The points that a term is about, apart from those that an extreme is taken of.
    pub(super) fn points(self) -> [Option<u8>; 3] {
        match self {
            Node::Coordinate(_, a) => [Some(a), None, None],
            Node::Distance(_, a, b) | Node::Angle(a, b) => [Some(a), Some(b), None],
            Node::VertexAngle(a, b, c) => [Some(a), Some(b), Some(c)],
            _ => [None; 3],
        }
    }
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
    pub(super) fn parameters_of(&self, nodes: &[Node], id: NodeId) -> u32 {
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
    pub(super) fn reads(&self, nodes: &[Node], id: NodeId, slot: u8) -> bool {
        match node_at(nodes, id) {
            Ok(Node::Attribute(own)) => own == slot,
            Ok(Node::Sum(a, b) | Node::Difference(a, b) | Node::Product(a, b)) => {
                self.reads(nodes, a, slot) || self.reads(nodes, b, slot)
            }
            _ => false,
        }
    }

    /// Reads an expression from a text: sums, differences and products of
    /// numbers, constants, attributes, parameters, coordinates of points,
    /// `dist(a, b)`, `dist_x`, `dist_y`, `dist_z`, `angle(a, b)`, `angle(a, b, c)` and `area(o)`, and
    /// `min(...)` or `max(...)` of one of these that is about the members of a group.
    ///
    /// # Errors
    /// [`Error::Syntax`] with line and column, also for unknown names and for
    /// quantities of different dimension; [`Error::CapacityExceeded`].
    pub fn parse_expression(
        &self,
        lexer: &mut Lexer<'_>,
        nodes: &mut VecView<Node>,
    ) -> Result<NodeId, Error> {
        let read = self.read_expression(lexer, nodes);
        lexer.outcome(read)
    }

    /// As [`Domain::parse_expression`]; the lexer notes errors.
    pub(crate) fn read_expression(
        &self,
        lexer: &mut Lexer<'_>,
        nodes: &mut VecView<Node>,
    ) -> Result<NodeId, Failed> {
        self.parser(nodes, None).expression(lexer)
    }

    /// A parser that lets an expression be about a member of the group `own` without
    /// an extreme: of a point that each of its members has.
    pub(super) fn parser<'p>(
        &'p self,
        nodes: &'p mut VecView<Node>,
        own: Option<u8>,
    ) -> ExpressionParser<'p, 'p, 'p> {
        ExpressionParser {
            domain: self,
            nodes,
            own,
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

/// The dimension of a product; literals scale, lengths make areas.
fn product_dimension(
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
