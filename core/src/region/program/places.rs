//! Where points are, in the order of operations of a scene and its samples.

use super::{Operand, Program, Value};
use crate::domain::{Base, Domain, MAX_PARAMETERS, Node, NodeId, Point, Shape};
use crate::error::Error;
use crate::region::obligations::Members;
use heapless::Vec;

/// How many points are computed once; further ones are where they are used.
const KEPT: usize = 16;

/// How a point is turned.
#[derive(Clone, Copy, Debug)]
pub(super) enum Turn {
    None,
    /// About the z axis: the cosine and the sine.
    Planar([Value; 2]),
    /// The matrix, by rows.
    Tilted([[Value; 3]; 3]),
}

impl Turn {
    pub(super) fn rows(&self, code: &mut impl Program) -> Result<[[Value; 3]; 3], Error> {
        let o = Value::ZERO;
        Ok(match *self {
            Turn::None => [[Value::ONE, o, o], [o, Value::ONE, o], [o, o, Value::ONE]],
            Turn::Planar([cos, sin]) => [
                [cos, code.negated(sin)?, o],
                [sin, cos, o],
                [o, o, Value::ONE],
            ],
            Turn::Tilted(rows) => rows,
        })
    }

    /// Where it turns the x axis to.
    pub(super) fn heading(&self) -> [Value; 3] {
        match *self {
            Turn::None => [Value::ONE, Value::ZERO, Value::ZERO],
            Turn::Planar([cos, sin]) => [cos, sin, Value::ZERO],
            Turn::Tilted(rows) => rows.map(|[x, ..]| x),
        }
    }

    fn varies(&self) -> bool {
        match self {
            Turn::None => false,
            Turn::Planar(direction) => direction.iter().any(Value::varies),
            Turn::Tilted(rows) => rows.iter().flatten().any(Value::varies),
        }
    }
}

/// Where a point is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placed {
    pub(super) origin: [Value; 3],
    pub(super) turn: Turn,
    /// The angle by which it is turned, if that is about the z axis and wanted.
    pub(super) yaw: Option<Value>,
}

/// Computes what points and given terms are.
pub(in crate::region) struct Places<'d, P> {
    pub(in crate::region) domain: &'d Domain<'d>,
    /// What takes the operations.
    pub(in crate::region) code: P,
    pub(super) theta: [Value; MAX_PARAMETERS],
    /// Whether parameters move along a line, where only straight things have a closed form.
    pub(super) is_line: bool,
    /// Which members of groups extremes are over.
    pub(in crate::region) members: Members,
    kept: Vec<(u8, Placed), KEPT>,
}

/// The error of what has no closed form along a line of parameters.
pub(in crate::region) const NOT_STRAIGHT: Error =
    Error::InvalidArgument("a constraint has no closed form that is written as code");

impl<'d, P: Program> Places<'d, P> {
    pub(in crate::region) fn new(
        domain: &'d Domain<'d>,
        code: P,
        theta: [Value; MAX_PARAMETERS],
        is_line: bool,
    ) -> Self {
        Places {
            domain,
            code,
            theta,
            is_line,
            members: Members::Present,
            kept: Vec::new(),
        }
    }

    /// A product; along a line, one of the two has to be fixed.
    pub(super) fn times(&mut self, a: Value, b: Value) -> Result<Value, Error> {
        if self.is_line && a.varies() && b.varies() {
            return Err(NOT_STRAIGHT);
        }
        self.code.times(a, b)
    }

    /// A quotient; along a line, of something fixed.
    pub(super) fn over(&mut self, a: Value, b: Value) -> Result<Value, Error> {
        if self.is_line && b.varies() {
            return Err(NOT_STRAIGHT);
        }
        self.code.over(a, b)
    }

    /// Where a point is.
    pub(super) fn placed(&mut self, index: u8) -> Result<Placed, Error> {
        if let Some((_, placed)) = self.kept.iter().find(|(own, _)| *own == index) {
            return Ok(*placed);
        }
        let missing = Error::InvalidArgument("a region speaks of a point that is not there");
        let domain = self.domain;
        let point = domain.points().get(usize::from(index)).ok_or(missing)?;
        let placed = self.place(point)?;
        // A point that is not kept is computed again.
        let _ = self.kept.push((index, placed));
        Ok(placed)
    }

    fn place(&mut self, point: &Point<'_>) -> Result<Placed, Error> {
        let mut placed = match point.base {
            Base::World => Placed {
                origin: [Value::ZERO; 3],
                turn: Turn::None,
                yaw: self.code.keeps_angles().then_some(Value::ZERO),
            },
            Base::Object(object) => self.object(object)?,
            Base::Point(earlier) => self.placed(earlier)?,
        };
        if point.turn != [None; 3] {
            let [yaw, pitch, roll] = point.turn;
            let angles = [self.given(yaw)?, self.given(pitch)?, self.given(roll)?];
            let inner = self.rotation(angles)?;
            placed.turn = self.compose(&placed.turn, &inner)?;
            placed.yaw = match (placed.yaw, point.turn) {
                (Some(own), [_, None, None]) => {
                    let [yaw, ..] = angles;
                    Some(self.code.plus(own, yaw)?)
                }
                _ => None,
            };
        }
        if self.is_line && placed.turn.varies() {
            return Err(NOT_STRAIGHT);
        }
        if point.offset == [None; 3] {
            return Ok(placed);
        }
        if point.sampled {
            self.advance(&mut placed.origin, &placed.turn, point)?;
        } else {
            // What does not move is summed up before it is added.
            let mut step = [Value::ZERO; 3];
            self.advance(&mut step, &placed.turn, point)?;
            for (own, step) in placed.origin.iter_mut().zip(step) {
                *own = self.code.plus(*own, step)?;
            }
        }
        Ok(placed)
    }

    fn object(&mut self, object: u8) -> Result<Placed, Error> {
        let pose = self.domain.pose_slots(object);
        let of_slot = |slot: Option<u8>| {
            slot.map_or(Value::ZERO, |slot| Value::constant(Operand::Slot(slot)))
        };
        let turn = match pose.angles {
            [None, None, None] => Turn::None,
            angles => self.rotation(angles.map(of_slot))?,
        };
        Ok(Placed {
            origin: pose.position.map(of_slot),
            turn,
            yaw: match pose.angles {
                [yaw, None, None] => self.code.keeps_angles().then(|| of_slot(yaw)),
                _ => None,
            },
        })
    }

    fn rotation(&mut self, [yaw, pitch, roll]: [Value; 3]) -> Result<Turn, Error> {
        let is_zero = |angle: &Value| angle.value == Operand::Zero && !angle.varies();
        let code = &mut self.code;
        let [sa, ca] = code.sin_cos(yaw)?;
        if is_zero(&pitch) && is_zero(&roll) {
            return Ok(Turn::Planar([ca, sa]));
        }
        let [sb, cb] = code.sin_cos(pitch)?;
        let [sc, cc] = code.sin_cos(roll)?;
        let mut product = |a, b| code.times(a, b);
        let (ca_sb, sa_sb) = (product(ca, sb)?, product(sa, sb)?);
        let parts = [
            [product(ca_sb, sc)?, product(sa, cc)?],
            [product(ca_sb, cc)?, product(sa, sc)?],
            [product(sa_sb, sc)?, product(ca, cc)?],
            [product(sa_sb, cc)?, product(ca, sc)?],
        ];
        let (xx, yx) = (product(ca, cb)?, product(sa, cb)?);
        let (zy, zz) = (product(cb, sc)?, product(cb, cc)?);
        let [[a, b], [c, d], [e, f], [g, h]] = parts;
        Ok(Turn::Tilted([
            [xx, code.minus(a, b)?, code.plus(c, d)?],
            [yx, code.plus(e, f)?, code.minus(g, h)?],
            [code.negated(sb)?, zy, zz],
        ]))
    }

    /// The product of two rotations: `inner` is turned first.
    fn compose(&mut self, outer: &Turn, inner: &Turn) -> Result<Turn, Error> {
        let code = &mut self.code;
        let [ca, sa, cb, sb] = match (outer, inner) {
            (outer, Turn::None) => return Ok(*outer),
            (Turn::None, inner) => return Ok(*inner),
            (Turn::Planar([ca, sa]), Turn::Planar([cb, sb])) => [*ca, *sa, *cb, *sb],
            _ => {
                let (outer, inner) = (outer.rows(code)?, inner.rows(code)?);
                let [[a, b, c], [d, e, f], [g, h, i]] = inner;
                let columns = [[a, d, g], [b, e, h], [c, f, i]];
                let mut product = [[Value::ZERO; 3]; 3];
                for (row, outer) in product.iter_mut().zip(outer) {
                    for (entry, column) in row.iter_mut().zip(columns) {
                        *entry = dot(code, outer, column)?;
                    }
                }
                return Ok(Turn::Tilted(product));
            }
        };
        let (a, b) = (code.times(ca, cb)?, code.times(sa, sb)?);
        let (c, d) = (code.times(sa, cb)?, code.times(ca, sb)?);
        Ok(Turn::Planar([code.minus(a, b)?, code.plus(c, d)?]))
    }

    /// Moves a point along the axes of a rotation.
    fn advance(
        &mut self,
        origin: &mut [Value; 3],
        turn: &Turn,
        point: &Point<'_>,
    ) -> Result<(), Error> {
        let rows = turn.rows(&mut self.code)?;
        for (step, axis) in point.offset.iter().zip(0..) {
            if step.is_none() {
                continue;
            }
            let step = self.given(*step)?;
            for (own, row) in origin.iter_mut().zip(rows) {
                let entry = row.into_iter().nth(axis).unwrap_or(Value::ZERO);
                let moved = self.times(step, entry)?;
                *own = self.code.plus(*own, moved)?;
            }
        }
        Ok(())
    }

    /// A term of the domain: an offset, a turn, a size.
    pub(super) fn given(&mut self, id: Option<NodeId>) -> Result<Value, Error> {
        let Some(id) = id else {
            return Ok(Value::ZERO);
        };
        let missing = Error::InvalidArgument("a term of the domain is not there");
        let node = self.domain.nodes().get(usize::from(id.0)).ok_or(missing)?;
        match *node {
            Node::Sum(a, b) => {
                let (a, b) = (self.given(Some(a))?, self.given(Some(b))?);
                self.code.plus(a, b)
            }
            Node::Difference(a, b) => {
                let (a, b) = (self.given(Some(a))?, self.given(Some(b))?);
                self.code.minus(a, b)
            }
            Node::Product(a, b) => {
                let (a, b) = (self.given(Some(a))?, self.given(Some(b))?);
                self.times(a, b)
            }
            Node::Quotient(a, b) => {
                let (a, b) = (self.given(Some(a))?, self.given(Some(b))?);
                self.over(a, b)
            }
            leaf => self.leaf(leaf)?.ok_or(missing),
        }
    }

    /// The value of a parameter or of a term whose value is given; none of another one.
    pub(super) fn leaf(&mut self, leaf: Node) -> Result<Option<Value>, Error> {
        Ok(Some(match leaf {
            Node::Number(number) => Value::constant(self.code.number(number)?),
            Node::Constant(index) => {
                let constant = self.domain.constants().get(usize::from(index));
                let number = constant.map_or(0.0, |constant| constant.value);
                Value::constant(self.code.number(number)?)
            }
            Node::Parameter(index) => {
                let known = self.theta.get(usize::from(index));
                known.copied().unwrap_or(Value::ZERO)
            }
            Node::Area(shape) => self.area(shape)?,
            Node::Quantity(quantity) => match quantity.slot() {
                Some(slot) => Value::constant(Operand::Slot(slot)),
                None => return Ok(None),
            },
            Node::Extreme(..)
            | Node::Sum(..)
            | Node::Difference(..)
            | Node::Product(..)
            | Node::Quotient(..) => {
                return Ok(None);
            }
        }))
    }

    fn area(&mut self, shape: u8) -> Result<Value, Error> {
        let (a, b, factor) = match self.domain.shapes().get(usize::from(shape)) {
            Some((_, Shape::Circle { radius })) => (*radius, *radius, core::f64::consts::PI),
            Some((_, Shape::Rectangle { width, height })) => (*width, *height, 1.0),
            None => return Err(Error::InvalidArgument("a shape is not there")),
        };
        let factor = Value::constant(self.code.number(factor)?);
        let (a, b) = (self.given(Some(a))?, self.given(Some(b))?);
        let area = self.times(factor, a)?;
        self.times(area, b)
    }
}

/// The scalar product of two vectors.
pub(in crate::region) fn dot(
    code: &mut impl Program,
    a: [Value; 3],
    b: [Value; 3],
) -> Result<Value, Error> {
    let mut sum = Value::ZERO;
    for (a, b) in a.into_iter().zip(b) {
        let product = code.times(a, b)?;
        sum = code.plus(sum, product)?;
    }
    Ok(sum)
}
