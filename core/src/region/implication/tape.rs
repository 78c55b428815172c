//! What two regions compute, as a list in which equal terms stand once.
//!
//! Terms that two constraints have in common are one node. So what is unknown of them
//! cancels where the constraints are compared.

use super::contraction::Empty;
use super::outward::{self, EVERYTHING, point};
use crate::domain::{Extreme, Quantity, Range};
use crate::error::Error;
use crate::region::program::{Case, ONLY_CODE, Operand, Operation, Program, Value, dot};
use heapless::Vec;

/// The error of a region that divides.
const NO_QUOTIENT: Error = Error::InvalidArgument(
    "a region that divides cannot be proven; multiply both sides by the divisor",
);

/// Most terms of what is proven at once.
pub(super) const MAX_NODES: usize = 512;
/// Most numbers of an instance and parameters that what is proven depends on.
pub(super) const MAX_VARIABLES: usize = 64;

/// Most terms that boxes are halved along.
pub(super) const MAX_CUTS: usize = 16;

/// Most sizes of bodies, and most identities.
pub(super) const MAX_SIZES: usize = 64;

/// The place of a node.
pub(super) type Place = u16;

/// What a term is: its operands stand before it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Node {
    Number(f64),
    /// What rounding has left open: a number between zero and this one.
    Slack(f64),
    /// A number of the instance or a parameter, by its place among those that are read.
    Variable(u8),
    /// Another term, which boxes are halved along; by its place among those.
    Cut(u8, Place),
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

/// Ranges of all variables, and behind them of all terms that boxes are halved along.
pub(super) type Corners = Vec<Range<f64>, { MAX_VARIABLES + MAX_CUTS }>;

impl Node {
    /// The same of other operands.
    pub(super) fn with_operands(self, mut of: impl FnMut(Place) -> Place) -> Node {
        match self {
            Node::Cut(index, a) => Node::Cut(index, of(a)),
            Node::Sum(a, b) => Node::Sum(of(a), of(b)),
            Node::Difference(a, b) => Node::Difference(of(a), of(b)),
            Node::Product(a, b) => Node::Product(of(a), of(b)),
            Node::Square(a) => Node::Square(of(a)),
            Node::Magnitude(a) => Node::Magnitude(of(a)),
            Node::Root(a) => Node::Root(of(a)),
            Node::Sine(a) => Node::Sine(of(a)),
            Node::Cosine(a) => Node::Cosine(of(a)),
            Node::ArcTangent(y, x) => Node::ArcTangent(of(y), of(x)),
            Node::Least(a, b) => Node::Least(of(a), of(b)),
            Node::Greatest(a, b) => Node::Greatest(of(a), of(b)),
            Node::Number(_) | Node::Slack(_) | Node::Variable(_) | Node::Extreme(..) => self,
        }
    }
}

/// Nodes, operands before what uses them.
#[derive(Debug, Default)]
pub(super) struct Tape {
    pub(super) nodes: Vec<Node, MAX_NODES>,
    /// What the variables are: slots and parameters.
    pub(super) variables: Vec<Operand, MAX_VARIABLES>,
    /// How many terms boxes are halved along, too.
    pub(super) cuts: u8,
    /// What has to be above zero.
    positive: Vec<Place, MAX_SIZES>,
    /// What is zero whatever the variables are.
    pub(super) identities: Vec<Place, MAX_SIZES>,
    /// Terms that stand for others, which are equal.
    pub(super) equals: Vec<(Place, Place), MAX_SIZES>,
}

impl Tape {
    pub(super) fn push(&mut self, node: Node) -> Result<Place, Error> {
        let full = Error::CapacityExceeded("terms of a proof: at most 512 of both regions");
        let place = match self.nodes.iter().position(|own| *own == node) {
            Some(place) => place,
            None => {
                self.nodes.push(node).map_err(|_| full)?;
                self.nodes.len() - 1
            }
        };
        let place = Place::try_from(place).map_err(|_| full)?;
        let equal = self.equals.iter().find(|(own, _)| *own == place);
        Ok(equal.map_or(place, |(_, other)| *other))
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

    /// Which nodes some of them are made of; a cosine has its sine beside it.
    pub(super) fn needed(&self, ends: impl Iterator<Item = Place>) -> Vec<bool, MAX_NODES> {
        let mut needed: Vec<bool, MAX_NODES> = Vec::new();
        // There is as much room as there is for nodes.
        let _ = needed.resize(self.nodes.len(), false);
        let need = |needed: &mut Vec<bool, MAX_NODES>, place: Place| {
            if let Some(own) = needed.get_mut(usize::from(place)) {
                *own = true;
            }
        };
        for end in ends {
            need(&mut needed, end);
        }
        for (place, node) in self.nodes.iter().enumerate().rev() {
            if needed.get(place) != Some(&true) {
                continue;
            }
            if let Node::Cosine(_) = node
                && let Ok(place) = Place::try_from(place)
            {
                need(&mut needed, place.saturating_sub(1));
            }
            let _ = node.with_operands(&mut |operand| {
                need(&mut needed, operand);
                operand
            });
        }
        needed
    }

    /// Notes that two terms are equal.
    fn identify(&mut self, a: Operand, b: Operand) -> Result<(), Error> {
        let full = Error::CapacityExceeded("turned vectors in a proof");
        let mut own = self;
        for (a, b) in [(a, b), (b, a)] {
            let difference = own.difference(a, b)?;
            let place = own.place(difference)?;
            own.identities.push(place).map_err(|_| full)?;
        }
        Ok(())
    }

    /// Whether all sizes of bodies are above zero.
    pub(super) fn has_sizes(&self, ranges: &Ranges) -> bool {
        let mut sizes = self.positive.iter();
        sizes.all(|size| range_of(ranges, *size).low > 0.0)
    }

    /// The term of which boxes are halved along another one; that one itself, if there is
    /// no room for more of them.
    pub(super) fn cut(&mut self, place: Place) -> Result<Place, Error> {
        let is_cut = |node: &Node| matches!(node, Node::Cut(_, own) if *own == place);
        if let Some(known) = self.nodes.iter().position(is_cut) {
            return Ok(Place::try_from(known).unwrap_or(place));
        }
        if usize::from(self.cuts) == MAX_CUTS {
            return Ok(place);
        }
        self.cuts += 1;
        self.push(Node::Cut(self.cuts - 1, place))
    }

    /// Adds a factor times a term to a sum, or begins one.
    pub(super) fn add_scaled(
        &mut self,
        sum: Option<Place>,
        factor: f64,
        term: Place,
    ) -> Result<Place, Error> {
        if factor == -1.0
            && let Some(sum) = sum
        {
            return self.push(Node::Difference(sum, term));
        }
        let term = match factor == 1.0 {
            true => term,
            false => {
                let factor = self.push(Node::Number(factor))?;
                self.push(Node::Product(factor, term))?
            }
        };
        match sum {
            Some(sum) => self.push(Node::Sum(sum, term)),
            None => Ok(term),
        }
    }

    /// Adds a number to a sum, or begins one.
    pub(super) fn add_constant(
        &mut self,
        sum: Option<Place>,
        constant: Range<f64>,
    ) -> Result<Place, Error> {
        if let Some(sum) = sum
            && constant == point(0.0)
        {
            return Ok(sum);
        }
        let mut number = self.push(Node::Number(constant.low))?;
        if constant.low < constant.high {
            let slack = outward::minus(point(constant.high), point(constant.low)).high;
            let slack = self.push(Node::Slack(slack))?;
            number = self.push(Node::Sum(number, slack))?;
        }
        match sum {
            Some(sum) => self.push(Node::Sum(sum, number)),
            None => Ok(number),
        }
    }

    /// The corner of a box that a node has.
    pub(super) fn corner_of(&self, node: Node) -> Option<usize> {
        match node {
            Node::Variable(index) => Some(usize::from(index)),
            Node::Cut(index, _) => Some(self.variables.len() + usize::from(index)),
            _ => None,
        }
    }

    /// The range of each node over a box, of which the terms that it is halved along are
    /// known, too.
    ///
    /// # Errors
    /// [`Empty`], if one of them cannot be in its range.
    pub(super) fn evaluate(&self, corners: &Corners, ranges: &mut Ranges) -> Result<(), Empty> {
        ranges.clear();
        for node in &self.nodes {
            let mut own = self.range(*node, corners, ranges);
            if let Node::Cut(..) = node
                && let Some(corner) = self.corner_of(*node).and_then(|own| corners.get(own))
            {
                own = outward::common(own, *corner).ok_or(Empty)?;
            }
            // There are as many places as there are for nodes.
            let _ = ranges.push(own);
        }
        Ok(())
    }

    /// The value of each node at the middle of a box, where terms that it is halved along
    /// are in the middle, too, whatever they are made of.
    pub(super) fn evaluate_middle(&self, corners: &Corners, ranges: &mut Ranges) {
        ranges.clear();
        for node in &self.nodes {
            let corner = self.corner_of(*node).and_then(|own| corners.get(own));
            let own = match corner {
                Some(corner) => point(corner.low + 0.5 * (corner.high - corner.low)),
                None => self.range(*node, corners, ranges),
            };
            let _ = ranges.push(own);
        }
    }

    fn range(&self, node: Node, corners: &Corners, ranges: &Ranges) -> Range<f64> {
        let of = |place: Place| range_of(ranges, place);
        match node {
            Node::Number(number) => point(number),
            Node::Slack(most) => outward::range(0.0, most),
            Node::Variable(index) => {
                let own = corners.get(usize::from(index));
                own.copied().unwrap_or(EVERYTHING)
            }
            Node::Cut(_, a) => of(a),
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
                match a == b {
                    true => Node::Number(0.0),
                    false => Node::Difference(a, b),
                }
            }
            Operation::Product(a, b) => match pair(a, b)? {
                (a, b) if a == b => Node::Square(a),
                (a, b) => Node::Product(a.min(b), a.max(b)),
            },
            Operation::Quotient(..) => return Err(NO_QUOTIENT),
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

    fn require_positive(&mut self, size: Operand) -> Result<(), Error> {
        let full = Error::CapacityExceeded("sizes of bodies in a proof: at most 64");
        let size = self.place(size)?;
        match self.positive.contains(&size) {
            true => Ok(()),
            false => self.positive.push(size).map_err(|_| full),
        }
    }

    /// Both have one length, and the vector is what its coordinates make of the axes.
    fn note_turned(
        &mut self,
        vector: [Value; 3],
        turned: [Value; 3],
        axes: [[Value; 3]; 3],
    ) -> Result<(), Error> {
        let (a, b) = (self.norm(vector)?.value, self.norm(turned)?.value);
        if a == b {
            return Ok(());
        }
        self.identify(a, b)?;
        let [[a0, a1, a2], [b0, b1, b2], [c0, c1, c2]] = axes;
        let rows = [[a0, b0, c0], [a1, b1, c1], [a2, b2, c2]];
        for (own, row) in vector.into_iter().zip(rows) {
            let back = dot(self, turned, row)?;
            if own.value != back.value {
                self.identify(own.value, back.value)?;
            }
        }
        let (a, b) = (self.place(a)?, self.place(b)?);
        // Without room, it is only known that both are equal.
        let _ = self.equals.push((a, b));
        Ok(())
    }

    fn cases(&mut self, _: Case, _: &[Operand]) -> Result<Operand, Error> {
        Err(ONLY_CODE)
    }
}
