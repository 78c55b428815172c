//! What two regions compute, as a list in which equal terms stand once.
//!
//! Terms that two constraints have in common are one node. So what is unknown of them
//! cancels where the constraints are compared.

use super::outward::{self, EVERYTHING, point};
use crate::domain::{Extreme, Quantity, Range};
use crate::error::Error;
use crate::region::program::{NOT_C, Operand, Operation, Program};
use heapless::Vec;

/// Most terms of what is proven at once.
pub(super) const MAX_NODES: usize = 512;
/// Most numbers of an instance and parameters that what is proven depends on.
pub(super) const MAX_VARIABLES: usize = 64;

/// The place of a node.
pub(super) type Place = u16;

/// What a term is: its operands stand before it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Node {
    Number(f64),
    /// A number of the instance or a parameter, by its place among those that are read.
    Variable(u8),
    /// An extreme over a group, of which nothing is known but that it is one number.
    Extreme(Extreme, Quantity),
    Sum(Place, Place),
    Difference(Place, Place),
    Product(Place, Place),
    Square(Place),
    Magnitude(Place),
    Root(Place),
    Sine(Place),
    Cosine(Place),
    ArcTangent(Place, Place),
    Least(Place, Place),
    Greatest(Place, Place),
}

/// Ranges of all nodes.
pub(super) type Ranges = Vec<Range<f64>, MAX_NODES>;

/// Ranges of all variables.
pub(super) type Corners = Vec<Range<f64>, MAX_VARIABLES>;

/// Nodes, operands before what uses them.
#[derive(Debug, Default)]
pub(super) struct Tape {
    pub(super) nodes: Vec<Node, MAX_NODES>,
    /// What the variables are: slots and parameters.
    pub(super) variables: Vec<Operand, MAX_VARIABLES>,
}

impl Tape {
    fn push(&mut self, node: Node) -> Result<Place, Error> {
        let full = Error::CapacityExceeded("terms of a proof: at most 512 of both regions");
        let place = match self.nodes.iter().position(|own| *own == node) {
            Some(place) => place,
            None => {
                self.nodes.push(node).map_err(|_| full)?;
                self.nodes.len() - 1
            }
        };
        Place::try_from(place).map_err(|_| full)
    }

    /// The node of an operand.
    pub(super) fn place(&mut self, operand: Operand) -> Result<Place, Error> {
        match operand {
            Operand::Zero => self.push(Node::Number(0.0)),
            Operand::One => self.push(Node::Number(1.0)),
            Operand::Temp(place) => Ok(place),
            Operand::Slot(_) | Operand::Theta(_) => {
                let full = Error::CapacityExceeded(
                    "numbers that a proof is about: at most 64 of the instance and parameters",
                );
                let known = self.variables.iter().position(|own| *own == operand);
                let index = match known {
                    Some(index) => index,
                    None => {
                        self.variables.push(operand).map_err(|_| full)?;
                        self.variables.len() - 1
                    }
                };
                let index = u8::try_from(index).map_err(|_| full)?;
                self.push(Node::Variable(index))
            }
        }
    }

    /// The range of each node over a box.
    pub(super) fn evaluate(&self, corners: &Corners, ranges: &mut Ranges) {
        ranges.clear();
        for node in &self.nodes {
            let own = self.range(*node, corners, ranges);
            // There are as many places as there are for nodes.
            let _ = ranges.push(own);
        }
    }

    fn range(&self, node: Node, corners: &Corners, ranges: &Ranges) -> Range<f64> {
        let of = |place: Place| range_of(ranges, place);
        match node {
            Node::Number(number) => point(number),
            Node::Variable(index) => {
                let own = corners.get(usize::from(index));
                own.copied().unwrap_or(EVERYTHING)
            }
            Node::Extreme(..) => EVERYTHING,
            Node::Sum(a, b) => outward::plus(of(a), of(b)),
            Node::Difference(a, b) => outward::minus(of(a), of(b)),
            Node::Product(a, b) => outward::times(of(a), of(b)),
            Node::Square(a) => outward::square(of(a)),
            Node::Magnitude(a) => outward::magnitude(of(a)),
            Node::Root(a) => outward::root(of(a)),
            Node::Sine(a) => outward::sine(of(a)),
            Node::Cosine(a) => outward::cosine(of(a)),
            Node::ArcTangent(y, x) => outward::arc_tangent(of(y), of(x)),
            Node::Least(a, b) => outward::least(of(a), of(b)),
            Node::Greatest(a, b) => outward::greatest(of(a), of(b)),
        }
    }
}

/// The range of a node; everything if there is no such node.
pub(super) fn range_of(ranges: &Ranges, place: Place) -> Range<f64> {
    ranges
        .get(usize::from(place))
        .copied()
        .unwrap_or(EVERYTHING)
}

impl Program for &mut Tape {
    fn operation(&mut self, operation: Operation) -> Result<Operand, Error> {
        let mut pair = |a, b| Ok::<_, Error>((self.place(a)?, self.place(b)?));
        let node = match operation {
            Operation::Number(number) => Node::Number(number),
            Operation::Extreme(extreme, quantity) => Node::Extreme(extreme, quantity),
            Operation::Sum(a, b) => {
                let (a, b) = pair(a, b)?;
                Node::Sum(a.min(b), a.max(b))
            }
            Operation::Difference(a, b) => {
                let (a, b) = pair(a, b)?;
                Node::Difference(a, b)
            }
            Operation::Product(a, b) => match pair(a, b)? {
                (a, b) if a == b => Node::Square(a),
                (a, b) => Node::Product(a.min(b), a.max(b)),
            },
            Operation::Magnitude(a) => Node::Magnitude(self.place(a)?),
            Operation::Root(a) => Node::Root(self.place(a)?),
            Operation::ArcTangent(y, x) => {
                let (y, x) = pair(y, x)?;
                Node::ArcTangent(y, x)
            }
            Operation::Least(a, b) => {
                let (a, b) = pair(a, b)?;
                Node::Least(a.min(b), a.max(b))
            }
            Operation::Greatest(a, b) => {
                let (a, b) = pair(a, b)?;
                Node::Greatest(a.min(b), a.max(b))
            }
        };
        self.push(node).map(Operand::Temp)
    }

    fn sine_and_cosine(&mut self, angle: Operand) -> Result<[Operand; 2], Error> {
        let angle = self.place(angle)?;
        let (sine, cosine) = (Node::Sine(angle), Node::Cosine(angle));
        Ok([
            Operand::Temp(self.push(sine)?),
            Operand::Temp(self.push(cosine)?),
        ])
    }

    fn cases(&mut self, _: &[&str], _: &[Operand]) -> Result<Operand, Error> {
        Err(NOT_C)
    }
}
