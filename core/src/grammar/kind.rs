//! What kind of number a feature is: finer than its dimension.

use crate::domain::{Coordinate, Dimension, Domain, Node, NodeId, Quantity};

/// What kind of number a feature is. A place is compared with another place of the same
/// axis, so that nothing is compared that does not move with the scene; to it, sizes are
/// added.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Kind {
    /// A coordinate, by the number of its axis.
    Place(u8),
    /// The sum, or else the difference, of two coordinates of a point.
    Diagonal(bool),
    /// A parameter that may be a place or a size.
    Free,
    /// The heading of something.
    Heading,
    /// A size, a distance, an angle between things or any other number.
    Size(Dimension),
    /// A number that none is compared with.
    #[default]
    Other,
}

impl Kind {
    /// The kind of a feature.
    pub(crate) fn of(domain: &Domain<'_>, nodes: &[Node], id: NodeId) -> Kind {
        let Some(node) = nodes.get(usize::from(id.0)) else {
            return Kind::Other;
        };
        let coordinate = |id: NodeId| match Kind::of(domain, nodes, id) {
            Kind::Place(axis) => Some(axis),
            _ => None,
        };
        let sized = || match (domain.dimension(nodes, id), node) {
            (Some(dimension), _) => Kind::Size(dimension),
            (None, Node::Number(_)) => Kind::Other,
            // There is no word for it, so that the text gives what it is compared with as a
            // plain number: the volume of a bag.
            (None, _) => Kind::Size(Dimension::None),
        };
        let quantity = match *node {
            Node::Quantity(quantity) | Node::Extreme(_, quantity) => Some(quantity),
            _ => None,
        };
        match (quantity, *node) {
            (Some(Quantity::Coordinate(Coordinate::X, _)), _) => Kind::Place(0),
            (Some(Quantity::Coordinate(Coordinate::Y, _)), _) => Kind::Place(1),
            (Some(Quantity::Coordinate(Coordinate::Z, _)), _) => Kind::Place(2),
            (Some(Quantity::Coordinate(Coordinate::Theta, _)), _) => Kind::Heading,
            (Some(Quantity::Attribute(slot)), _) => match domain.axis_of(slot) {
                Some(axis) => Kind::Place(axis),
                None if domain.places(slot) => Kind::Heading,
                None => sized(),
            },
            (None, Node::Parameter(_)) if sized() == Kind::Size(Dimension::Length) => Kind::Free,
            (None, Node::Sum(a, b)) if coordinate(a).is_some() && coordinate(b).is_some() => {
                Kind::Diagonal(true)
            }
            (None, Node::Difference(a, b))
                if coordinate(a).is_some() && coordinate(b).is_some() =>
            {
                Kind::Diagonal(false)
            }
            _ => sized(),
        }
    }

    /// Whether a feature is a share of a coordinate, which says something else as soon as the
    /// whole scene is moved.
    pub(crate) fn is_share_of_place(domain: &Domain<'_>, nodes: &[Node], id: NodeId) -> bool {
        match nodes.get(usize::from(id.0)) {
            Some(Node::Product(_, of)) => {
                matches!(Kind::of(domain, nodes, *of), Kind::Place(_))
            }
            _ => false,
        }
    }
}
