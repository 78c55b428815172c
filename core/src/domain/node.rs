//! Terms, as nodes in a list.
//!
//! An expression is a node in a list in which operands stand before the node that
//! uses them, so a list is evaluated in one sweep, and equal terms are stored once.

use crate::error::Error;
use crate::geometry::Relation;
use crate::real::Real;
use crate::table::Blank;
use core::mem::discriminant;
use core::ops::RangeInclusive;
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

/// How wide a straight line between two points is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beam {
    /// `line(a, b)`: not at all, as a line of sight.
    Line,
    /// `sweep(a, b)`: as the circle of the first point, which drives along it.
    Sweep,
}

/// A share of a size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Share {
    /// Half of it: of a width or a diameter.
    Half,
    /// All of it: of a radius.
    Whole,
    /// One and a half of it.
    OneAndHalf,
    /// Twice.
    Twice,
}

impl Share {
    /// All of them, in the order of the grammar.
    pub const ALL: [Share; 4] = [Share::Whole, Share::Half, Share::OneAndHalf, Share::Twice];

    /// By what the size is multiplied.
    pub const fn factor(self) -> f64 {
        match self {
            Share::Half => 0.5,
            Share::Whole => 1.0,
            Share::OneAndHalf => 1.5,
            Share::Twice => 2.0,
        }
    }
}

/// In how many ways a thing can be turned and look the same, where its angles are folded.
pub const SYMMETRIES: RangeInclusive<u8> = 2..=12;

/// The angle by which such a thing is turned to look the same.
pub(super) fn period(symmetry: u8) -> f64 {
    core::f64::consts::TAU / f64::from(symmetry)
}

/// A number that belongs to an object or to points, in an instance and at a sample. A
/// quantity of a group names the first member, which stands for each of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// An attribute of an object, by its place in an instance.
    Attribute(u8),
    /// A coordinate of a point.
    Coordinate(Coordinate, u8),
    /// The distance of two points.
    Distance(Metric, u8, u8),
    /// The straight distance of two points minus a share of an attribute, by its place in an
    /// instance: how far from a member of a group with a size of its own.
    Gap(Share, u8, u8, u8),
    /// The angle between the x axes of two points, in `[0, pi]`.
    Angle(u8, u8),
    /// The angle between the x axes of two points, where a turn by a whole fraction of a full
    /// turn changes nothing: how far the angle is from the nearest multiple of `2 pi / n`, in
    /// `[0, pi / n]`, for an `n` in [`SYMMETRIES`].
    FoldedAngle(u8, u8, u8),
    /// The angle between the x axis of the second point and the direction from there to the
    /// first one, in `[0, pi]`; zero where they are one point.
    Off(u8, u8),
    /// A relation between the bodies of two points: the first one's to the second one's. A
    /// point without a body is a body without extent.
    Relation(Relation, u8, u8),
    /// How far the straight line between the first two points is from the body of the third
    /// one; below zero, how deep it goes in.
    Sight(Beam, u8, u8, u8),
    /// The angle at the second point between the directions to the first and to the
    /// third, in `[0, pi]`; zero where one of them is the second point itself.
    VertexAngle(u8, u8, u8),
}

impl Quantity {
    /// Its place in an instance, if it is an attribute.
    pub(crate) fn slot(self) -> Option<u8> {
        match self {
            Quantity::Attribute(slot) => Some(slot),
            Quantity::Coordinate(..)
            | Quantity::Distance(..)
            | Quantity::Gap(..)
            | Quantity::Angle(..)
            | Quantity::FoldedAngle(..)
            | Quantity::Off(..)
            | Quantity::Relation(..)
            | Quantity::Sight(..)
            | Quantity::VertexAngle(..) => None,
        }
    }

    /// The points that it depends on.
    pub(super) fn points(self) -> [Option<u8>; 3] {
        match self {
            Quantity::Attribute(_) => [None; 3],
            Quantity::Coordinate(_, a) => [Some(a), None, None],
            Quantity::Distance(_, a, b)
            | Quantity::Gap(_, a, b, _)
            | Quantity::Angle(a, b)
            | Quantity::FoldedAngle(_, a, b)
            | Quantity::Off(a, b)
            | Quantity::Relation(_, a, b) => [Some(a), Some(b), None],
            Quantity::Sight(_, a, b, c) | Quantity::VertexAngle(a, b, c) => {
                [Some(a), Some(b), Some(c)]
            }
        }
    }

    /// The same quantity of other points; it takes as many of them as it needs.
    pub(super) fn with_points(self, [a, b, c]: [u8; 3]) -> Quantity {
        match self {
            Quantity::Attribute(slot) => Quantity::Attribute(slot),
            Quantity::Coordinate(axis, _) => Quantity::Coordinate(axis, a),
            Quantity::Distance(metric, ..) => Quantity::Distance(metric, a, b),
            Quantity::Gap(share, _, _, slot) => Quantity::Gap(share, a, b, slot),
            Quantity::Angle(..) => Quantity::Angle(a, b),
            Quantity::FoldedAngle(n, ..) => Quantity::FoldedAngle(n, a, b),
            Quantity::Off(..) => Quantity::Off(a, b),
            Quantity::Relation(relation, ..) => Quantity::Relation(relation, a, b),
            Quantity::Sight(beam, ..) => Quantity::Sight(beam, a, b, c),
            Quantity::VertexAngle(..) => Quantity::VertexAngle(a, b, c),
        }
    }
}

/// One term. Indices of constants, attributes, points and shapes refer to the
/// domain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Node {
    /// A literal number; it fits every dimension.
    Number(f64),
    /// A constant.
    Constant(u8),
    /// A parameter of the action.
    Parameter(u8),
    /// The area of a shape.
    Area(u8),
    /// A quantity of an object or of points.
    Quantity(Quantity),
    /// The least or greatest value of a quantity over the members of a group that an
    /// instance has.
    Extreme(Extreme, Quantity),
    /// `a + b`
    Sum(NodeId, NodeId),
    /// `a - b`
    Difference(NodeId, NodeId),
    /// `a * b`
    Product(NodeId, NodeId),
    /// `a / b`
    Quotient(NodeId, NodeId),
}

impl Blank for Node {
    const BLANK: Self = Node::Number(0.0);
}

const _: () = assert!(
    size_of::<Node>() == 16,
    "tables of features are made of them"
);

/// Makes a term of two operands.
type Operation = fn(NodeId, NodeId) -> Node;

/// Questions about terms. Each is answered here, once, for every kind of term.
impl Node {
    /// The operands of a sum, difference, product or quotient, and a function that makes the same
    /// of other operands.
    pub(crate) fn operands(self) -> Option<(NodeId, NodeId, Operation)> {
        match self {
            Node::Sum(a, b) => Some((a, b, Node::Sum)),
            Node::Difference(a, b) => Some((a, b, Node::Difference)),
            Node::Product(a, b) => Some((a, b, Node::Product)),
            Node::Quotient(a, b) => Some((a, b, Node::Quotient)),
            Node::Number(_)
            | Node::Constant(_)
            | Node::Parameter(_)
            | Node::Area(_)
            | Node::Quantity(_)
            | Node::Extreme(..) => None,
        }
    }

    /// Its index, if it is a parameter.
    pub(super) fn parameter(self) -> Option<u8> {
        match self {
            Node::Parameter(parameter) => Some(parameter),
            Node::Number(_)
            | Node::Constant(_)
            | Node::Area(_)
            | Node::Quantity(_)
            | Node::Extreme(..)
            | Node::Sum(..)
            | Node::Difference(..)
            | Node::Product(..)
            | Node::Quotient(..) => None,
        }
    }

    /// Whether the text, the domain or an instance gives its value. Other terms need a
    /// pose, parameters or operands.
    pub(super) fn is_given(self) -> bool {
        match self {
            Node::Number(_) | Node::Constant(_) | Node::Area(_) => true,
            Node::Quantity(quantity) => quantity.slot().is_some(),
            Node::Parameter(_)
            | Node::Extreme(..)
            | Node::Sum(..)
            | Node::Difference(..)
            | Node::Product(..)
            | Node::Quotient(..) => false,
        }
    }

    /// The quantity, if the term is one, and not the extreme of one.
    pub(super) fn quantity(self) -> Option<Quantity> {
        match self {
            Node::Quantity(quantity) => Some(quantity),
            Node::Number(_)
            | Node::Constant(_)
            | Node::Parameter(_)
            | Node::Area(_)
            | Node::Extreme(..)
            | Node::Sum(..)
            | Node::Difference(..)
            | Node::Product(..)
            | Node::Quotient(..) => None,
        }
    }
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

    /// The one of two values that counts.
    pub fn of<R: Real>(self, a: R, b: R) -> R {
        match self {
            Extreme::Least => a.min(b),
            Extreme::Greatest => a.max(b),
        }
    }

    /// The value over nothing: infinite, so that "at least" holds of a least value and
    /// "at most" of a greatest one.
    pub fn of_nothing<R: Real>(self) -> R {
        match self {
            Extreme::Least => R::INFINITY,
            Extreme::Greatest => -R::INFINITY,
        }
    }
}

/// What is wrong with a list of terms. It is small because recursive functions return
/// it.
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
    let (Ok(own), Ok(other)) = (node_at(nodes, id), node_at(others, other)) else {
        return false;
    };
    match (own.operands(), other.operands()) {
        (Some((a, b, _)), Some((c, d, _))) => {
            discriminant(&own) == discriminant(&other) && same(a, c) && same(b, d)
        }
        _ => own == other,
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
