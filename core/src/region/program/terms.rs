//! Terms of constraints.

use super::places::{NOT_STRAIGHT, Places, Turn, dot};
use super::{Case, Operand, Operation, Program, Value};
use crate::domain::{Coordinate, Extreme, Metric, Node, NodeId, Quantity};
use crate::error::Error;
use crate::grammar::Constraint;
use crate::region::obligations::Members;

/// A term: a value, and along a line of parameters also a factor times the length of a
/// vector that moves.
#[derive(Clone, Copy, Debug)]
pub(in crate::region) struct Term {
    pub(in crate::region) line: Value,
    pub(in crate::region) bend: Option<(Operand, [Value; 3])>,
}

impl From<Value> for Term {
    fn from(line: Value) -> Term {
        Term { line, bend: None }
    }
}

impl Term {
    fn varies(&self) -> bool {
        self.bend.is_some() || self.line.varies()
    }
}

impl<P: Program> Places<'_, P> {
    /// How far a constraint is from its bound: at most zero where it holds.
    pub(in crate::region) fn margin(
        &mut self,
        nodes: &[Node],
        constraint: &Constraint,
    ) -> Result<Operand, Error> {
        let left = self.term(nodes, constraint.lhs)?.line.value;
        let right = self.term(nodes, constraint.rhs)?.line.value;
        match constraint.comparison.is_upper() {
            true => self.code.difference(left, right),
            false => self.code.difference(right, left),
        }
    }

    pub(in crate::region) fn term(&mut self, nodes: &[Node], id: NodeId) -> Result<Term, Error> {
        let missing = Error::InvalidArgument("an expression refers to a missing term");
        match *nodes.get(usize::from(id.0)).ok_or(missing)? {
            Node::Sum(a, b) => {
                let (a, b) = (self.term(nodes, a)?, self.term(nodes, b)?);
                let bend = single(a.bend, b.bend)?;
                let line = self.code.plus(a.line, b.line)?;
                Ok(Term { line, bend })
            }
            Node::Difference(a, b) => {
                let (a, b) = (self.term(nodes, a)?, self.term(nodes, b)?);
                self.difference(a, b)
            }
            Node::Product(a, b) => {
                let (a, b) = (self.term(nodes, a)?, self.term(nodes, b)?);
                if self.is_line && a.varies() && b.varies() {
                    return Err(NOT_STRAIGHT);
                }
                let bend = match (a.bend, b.bend) {
                    (Some((factor, vector)), _) => {
                        Some((self.code.product(factor, b.line.value)?, vector))
                    }
                    (None, Some((factor, vector))) => {
                        Some((self.code.product(factor, a.line.value)?, vector))
                    }
                    (None, None) => None,
                };
                let line = self.code.times(a.line, b.line)?;
                Ok(Term { line, bend })
            }
            Node::Quotient(a, b) => {
                let (a, b) = (self.term(nodes, a)?, self.term(nodes, b)?);
                let bend = match (a.bend, b.varies()) {
                    (_, true) if self.is_line => return Err(NOT_STRAIGHT),
                    (Some((factor, vector)), false) => {
                        Some((self.code.quotient(factor, b.line.value)?, vector))
                    }
                    (None, _) | (Some(_), true) => None,
                };
                let line = self.code.over(a.line, b.line)?;
                Ok(Term { line, bend })
            }
            Node::Extreme(extreme, quantity) => match self.members {
                Members::Present => self.extreme(extreme, quantity).map(Term::from),
                Members::One(index) => self.quantity(self.domain.of_member(quantity, index)),
                Members::Unknown => {
                    let operation = Operation::Extreme(extreme, quantity);
                    Ok(Value::constant(self.code.operation(operation)?).into())
                }
            },
            Node::Quantity(quantity) => self.quantity(quantity),
            leaf => Ok(self.leaf(leaf)?.ok_or(missing)?.into()),
        }
    }

    pub(in crate::region) fn difference(&mut self, a: Term, b: Term) -> Result<Term, Error> {
        let negative = match b.bend {
            Some((factor, vector)) => {
                let zero = Operand::Zero;
                Some((self.code.difference(zero, factor)?, vector))
            }
            None => None,
        };
        let bend = single(a.bend, negative)?;
        let line = self.code.minus(a.line, b.line)?;
        Ok(Term { line, bend })
    }

    fn quantity(&mut self, quantity: Quantity) -> Result<Term, Error> {
        match quantity {
            Quantity::Attribute(slot) => Ok(Value::constant(Operand::Slot(slot)).into()),
            Quantity::Coordinate(coordinate, point) => {
                let placed = self.placed(point)?;
                let [x, y, z] = placed.origin;
                Ok(Term::from(match coordinate {
                    Coordinate::X => x,
                    Coordinate::Y => y,
                    Coordinate::Z => z,
                    Coordinate::Theta => {
                        let [x, y, _] = placed.turn.heading();
                        self.atan2(y, x)?
                    }
                }))
            }
            Quantity::Distance(metric, a, b) => self.distance(metric, [a, b]),
            Quantity::Gap(share, a, b, slot) => {
                let distance = self.distance(Metric::Straight, [a, b])?;
                let share = self.code.number(share.factor())?;
                let size = self.code.product(Operand::Slot(slot), share)?;
                self.difference(distance, Value::constant(size).into())
            }
            Quantity::Angle(a, b) => {
                let (a, b) = (self.placed(a)?, self.placed(b)?);
                let angle = match self.turned(a.yaw, b.yaw)? {
                    Some([x, ..]) => self.angle(Turn::None.heading(), x)?,
                    None => self.angle(a.turn.heading(), b.turn.heading())?,
                };
                Ok(angle.into())
            }
            Quantity::Off(a, b) => {
                let direction = self.between(b, a)?;
                let heading = self.placed(b)?.turn.heading();
                Ok(self.angle(direction, heading)?.into())
            }
            Quantity::VertexAngle(a, vertex, b) => {
                let (a, b) = (self.between(vertex, a)?, self.between(vertex, b)?);
                Ok(self.angle(a, b)?.into())
            }
            Quantity::FoldedAngle(..) => Err(Error::InvalidArgument(
                "an angle with a symmetry cannot be written down; use the library for this region",
            )),
            Quantity::Relation(..) | Quantity::Sight(..) => {
                Ok(self.between_bodies(quantity)?.into())
            }
        }
    }

    /// The axes of what is turned by one angle, as seen from what is turned by another one.
    pub(super) fn turned(
        &mut self,
        yaw: Option<Value>,
        from: Option<Value>,
    ) -> Result<Option<[[Value; 3]; 3]>, Error> {
        let Some((yaw, from)) = yaw.zip(from) else {
            return Ok(None);
        };
        let angle = self.code.minus(yaw, from)?;
        let [sin, cos] = self.code.sin_cos(angle)?;
        let (o, negative) = (Value::ZERO, self.code.negated(sin)?);
        Ok(Some([
            [cos, sin, o],
            [negative, cos, o],
            [o, o, Value::ONE],
        ]))
    }

    fn distance(&mut self, metric: Metric, [a, b]: [u8; 2]) -> Result<Term, Error> {
        let [x, y, z] = self.between(b, a)?;
        let zero = Value::ZERO;
        let vector = match metric {
            Metric::X => [x, zero, zero],
            Metric::Y => [y, zero, zero],
            Metric::Z => [z, zero, zero],
            Metric::Straight => [x, y, z],
        };
        if self.is_line && vector.iter().any(Value::varies) {
            return Ok(Term {
                line: zero,
                bend: Some((Operand::One, vector)),
            });
        }
        Ok(self.code.norm(vector)?.into())
    }

    /// The vector from one point to another.
    fn between(&mut self, from: u8, to: u8) -> Result<[Value; 3], Error> {
        let (from, to) = (self.placed(from)?, self.placed(to)?);
        let mut vector = to.origin;
        for (own, from) in vector.iter_mut().zip(from.origin) {
            *own = self.code.minus(*own, from)?;
        }
        Ok(vector)
    }

    /// The angle between two vectors: the arc tangent of the lengths of their products.
    fn angle(&mut self, a: [Value; 3], b: [Value; 3]) -> Result<Value, Error> {
        let ([ax, ay, az], [bx, by, bz]) = (a, b);
        let pairs = [[ay, bz, az, by], [az, bx, ax, bz], [ax, by, ay, bx]];
        let mut cross = [Value::ZERO; 3];
        for (entry, [p, q, r, s]) in cross.iter_mut().zip(pairs) {
            let (first, second) = (self.times(p, q)?, self.times(r, s)?);
            *entry = self.code.minus(first, second)?;
        }
        if self.is_line && (cross.iter().any(Value::varies)) {
            return Err(NOT_STRAIGHT);
        }
        let across = self.code.norm(cross)?;
        let along = dot(&mut self.code, a, b)?;
        self.atan2(across, along)
    }

    fn atan2(&mut self, y: Value, x: Value) -> Result<Value, Error> {
        if self.is_line && (x.varies() || y.varies()) {
            return Err(NOT_STRAIGHT);
        }
        let code = &mut self.code;
        let angle = code.operation(Operation::ArcTangent(y.value, x.value))?;
        let mut angle = Value::constant(angle);
        if !x.varies() && !y.varies() {
            return Ok(angle);
        }
        let squares = [
            code.product(y.value, y.value)?,
            code.product(x.value, x.value)?,
        ];
        let square = code.sum(squares[0], squares[1])?;
        let slopes = y.slopes.into_iter().zip(x.slopes);
        for (slope, (of_y, of_x)) in angle.slopes.iter_mut().zip(slopes) {
            let (first, second) = (code.product(x.value, of_y)?, code.product(y.value, of_x)?);
            let turned = code.difference(first, second)?;
            if turned != Operand::Zero {
                *slope = code.cases(Case::Ratio, &[square, turned])?;
            }
        }
        Ok(angle)
    }

    /// The extreme over the members of a group that an instance has.
    fn extreme(&mut self, extreme: Extreme, quantity: Quantity) -> Result<Value, Error> {
        let mut best = Value::constant(self.code.cases(Case::Nothing(extreme), &[])?);
        let domain = self.domain;
        for (member, own) in domain.of_members(quantity) {
            let Term { line, bend: None } = self.quantity(own)? else {
                return Err(NOT_STRAIGHT);
            };
            if self.is_line && line.varies() {
                return Err(NOT_STRAIGHT);
            }
            // The numbers of a member that is absent are not equal to themselves.
            let first = Operand::Slot(member.first_slot);
            let operands = [first, line.value, best.value];
            let counts = self.code.cases(Case::Counts(extreme), &operands)?;
            let mut choose = |own: Operand, other: Operand| match own == other {
                true => Ok(own),
                false => self.code.cases(Case::Choice, &[counts, own, other]),
            };
            let mut chosen = Value::constant(choose(line.value, best.value)?);
            let slopes = line.slopes.into_iter().zip(best.slopes);
            for (slope, (own, other)) in chosen.slopes.iter_mut().zip(slopes) {
                *slope = choose(own, other)?;
            }
            best = chosen;
        }
        Ok(best)
    }
}

/// The bend of two, of which at most one may have one.
fn single<T>(a: Option<T>, b: Option<T>) -> Result<Option<T>, Error> {
    match (a, b) {
        (Some(_), Some(_)) => Err(NOT_STRAIGHT),
        (a, None) => Ok(a),
        (None, b) => Ok(b),
    }
}
