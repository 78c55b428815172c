//! Terms, as nodes in a list.
//!
//! An expression is a node in a list in which operands stand before the node that
//! uses them, so a list is evaluated in one sweep, and equal terms are stored once.

use crate::error::Error;
use crate::real::Real;
use crate::table::Blank;
use heapless::VecView;

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
    pub(super) const NAMED: [(&str, Coordinate); 4] = [
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
    pub(super) const NAMED: [(&str, Metric); 4] = [
        ("dist_x", Metric::X),
        ("dist_y", Metric::Y),
        ("dist_z", Metric::Z),
        ("dist", Metric::Straight),
    ];
}

/// The value with this name.
pub(super) fn named<T: Copy>(all: &[(&str, T)], name: &str) -> Option<T> {
    let mut all = all.iter();
    all.find(|(own, _)| *own == name).map(|(_, value)| *value)
}

/// The name of a value.
pub(super) fn name_of<T: PartialEq>(all: &[(&'static str, T)], value: T) -> &'static str {
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

impl Blank for Node {
    const BLANK: Self = Node::Number(0.0);
}

/// Which of several values counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extreme {
    /// `min(...)`
    Least,
    /// `max(...)`
    Greatest,
}

impl Extreme {
    /// Both, in the order of the grammar.
    pub const ALL: [Extreme; 2] = [Extreme::Least, Extreme::Greatest];

    /// Its name in the texts.
    pub const fn name(self) -> &'static str {
        match self {
            Extreme::Least => "min",
            Extreme::Greatest => "max",
        }
    }

    /// The one with this name.
    pub fn from_name(name: &str) -> Option<Extreme> {
        Extreme::ALL.into_iter().find(|e| e.name() == name)
    }

    /// The one of two values that counts.
    pub fn of<R: Real>(self, a: R, b: R) -> R {
        match self {
            Extreme::Least => a.min(b),
            Extreme::Greatest => a.max(b),
        }
    }

    /// The value over nothing: infinite, so that "at least" of a least value and
    /// "at most" of a greatest one hold.
    pub fn of_nothing<R: Real>(self) -> R {
        match self {
            Extreme::Least => R::INFINITY,
            Extreme::Greatest => -R::INFINITY,
        }
    }
}

/// A term about the members of one group, of which the extreme is taken. It names
/// the first member, which stands for each of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// As [`Node::Attribute`].
    Attribute(u8),
    /// As [`Node::Coordinate`].
    Coordinate(Coordinate, u8),
    /// As [`Node::Distance`].
    Distance(Metric, u8, u8),
    /// As [`Node::Angle`].
    Angle(u8, u8),
    /// As [`Node::VertexAngle`].
    VertexAngle(u8, u8, u8),
}

impl Relation {
    /// The relation that is this term; `None` for any other term.
    pub fn of(term: Node) -> Option<Relation> {
        match term {
            Node::Attribute(slot) => Some(Relation::Attribute(slot)),
            Node::Coordinate(coordinate, point) => Some(Relation::Coordinate(coordinate, point)),
            Node::Distance(metric, a, b) => Some(Relation::Distance(metric, a, b)),
            Node::Angle(a, b) => Some(Relation::Angle(a, b)),
            Node::VertexAngle(a, b, c) => Some(Relation::VertexAngle(a, b, c)),
            _ => None,
        }
    }

    /// The term about the first member.
    pub fn term(self) -> Node {
        match self {
            Relation::Attribute(slot) => Node::Attribute(slot),
            Relation::Coordinate(coordinate, point) => Node::Coordinate(coordinate, point),
            Relation::Distance(metric, a, b) => Node::Distance(metric, a, b),
            Relation::Angle(a, b) => Node::Angle(a, b),
            Relation::VertexAngle(a, b, c) => Node::VertexAngle(a, b, c),
        }
    }
}

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
