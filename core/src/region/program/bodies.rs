//! Relations between bodies, as far as sums, products, roots and extremes say them.
//!
//! What is said is what the relations of `geometry` are, apart from the clearance of two
//! bodies that both have sides, which is another one while they overlap, and of lines.

use super::places::{Places, dot};
use super::{Operand, Operation, Program, Value};
use crate::domain::{Domain, NodeId, Quantity, Solid};
use crate::error::Error;
use crate::geometry::{Axis, Dimensions, Relation};
use heapless::Vec;

const BOTH_HAVE_SIDES: Error = Error::InvalidArgument(
    "the clearance of two bodies that both have sides cannot be written down; say it of a circle",
);
const A_LINE: Error = Error::InvalidArgument(
    "how clear a line is of a body cannot be written down; say it of points along the line",
);

/// How many axes of a body span what can stand on it.
const FOOTPRINT: usize = 2;

/// A body where it stands.
struct Standing {
    centre: [Value; 3],
    /// The angle by which it is turned, if that is about the z axis.
    yaw: Option<Value>,
    axes: [[Value; 3]; 3],
    /// Half of each size that it has.
    halves: [Option<Value>; 3],
    radius: Option<Value>,
}

impl Standing {
    fn has_sides(&self, count: usize) -> bool {
        self.halves.iter().take(count).any(Option::is_some)
    }

    /// Its sides among the first axes: directions, each with half a size.
    fn sides(&self, count: usize) -> impl Iterator<Item = ([Value; 3], Value)> {
        let sides = self.axes.into_iter().zip(self.halves).take(count);
        sides.filter_map(|(axis, half)| Some((axis, half?)))
    }
}

impl<P: Program> Places<'_, P> {
    /// The least value of a relation over the parts that it is about.
    pub(super) fn between_bodies(&mut self, quantity: Quantity) -> Result<Value, Error> {
        self.code.check_bodies()?;
        let Quantity::Relation(relation, a, b) = quantity else {
            return Err(A_LINE);
        };
        let domain = self.domain;
        let mut least = None;
        for first in domain.parts(a) {
            for second in domain.parts(b) {
                let own = self.relation(relation, [first, second])?;
                least = Some(match least {
                    Some(least) => self.lesser(least, own)?,
                    None => own,
                });
            }
        }
        least.ok_or(Error::InvalidArgument("a compound has no parts"))
    }

    fn relation(&mut self, relation: Relation, points: [u8; 2]) -> Result<Value, Error> {
        let dimensions = dimensions(self.domain);
        let count = match dimensions {
            Dimensions::Plane => 2,
            Dimensions::Space => 3,
        };
        let [a, b] = points;
        let (a, b) = (self.standing(a)?, self.standing(b)?);
        let mut d = [Value::ZERO; 3];
        for (own, (to, from)) in d
            .iter_mut()
            .take(count)
            .zip(a.centre.into_iter().zip(b.centre))
        {
            *own = self.code.minus(to, from)?;
        }
        match relation {
            Relation::Clear => {
                let distance = match (a.has_sides(count), b.has_sides(count)) {
                    (false, _) => self.distance_from_core(&b, d, count)?,
                    (true, false) => self.distance_from_core(&a, d, count)?,
                    (true, true) => return Err(BOTH_HAVE_SIDES),
                };
                self.without_radii(distance, [&a, &b])
            }
            Relation::Inside => self.room(&a, &b, d, count),
            Relation::InsideAlong(axis) => {
                let half = along(axis, b.halves.into_iter())?;
                let half = half.unwrap_or(Value::ZERO);
                let half = self.code.plus(half, b.radius.unwrap_or(Value::ZERO))?;
                match index_of(axis) {
                    // In the plane nothing counts along it.
                    index if index >= count => self.without_radii(half, [&a]),
                    index => self.slab([&a, &b], index, half, d),
                }
            }
            Relation::Over => {
                let point = Standing {
                    halves: [None; 3],
                    radius: None,
                    ..a
                };
                self.room(&point, &b, d, FOOTPRINT)
            }
            Relation::Corner => {
                let nearest = self.fold_corners(&a, &b, d, count, Places::lesser)?;
                self.without_radii(nearest, [&a, &b])
            }
            Relation::Coordinate(axis) => {
                let direction = along(axis, b.axes.into_iter())?;
                dot(&mut self.code, d, direction)
            }
            Relation::Magnitude(axis) => {
                let direction = along(axis, b.axes.into_iter())?;
                let coordinate = dot(&mut self.code, d, direction)?;
                self.code.norm([coordinate, Value::ZERO, Value::ZERO])
            }
        }
    }

    /// The body of a point.
    fn standing(&mut self, point: u8) -> Result<Standing, Error> {
        let placed = self.placed(point)?;
        let body = self.domain.body_of(point);
        let solid = body.map_or_else(Solid::default, |body| body.solid);
        let [[a, b, c], [d, e, f], [g, h, i]] = placed.turn.rows(&mut self.code)?;
        let mut standing = Standing {
            centre: placed.origin,
            yaw: placed.yaw,
            axes: [[a, d, g], [b, e, h], [c, f, i]],
            halves: [None; 3],
            radius: None,
        };
        if let Some(radius) = solid.radius {
            standing.radius = Some(self.size(radius)?);
        }
        let half = Value::constant(self.code.number(0.5)?);
        for (index, size) in solid.sizes.into_iter().enumerate() {
            let Some(size) = size else { continue };
            let size = self.size(size)?;
            let size = self.code.times(half, size)?;
            if let Some(own) = standing.halves.get_mut(index) {
                *own = Some(size);
            }
            let axis = standing
                .axes
                .into_iter()
                .nth(index)
                .unwrap_or([Value::ZERO; 3]);
            if !solid.centred {
                for (own, entry) in standing.centre.iter_mut().zip(axis) {
                    let step = self.code.times(size, entry)?;
                    *own = self.code.plus(*own, step)?;
                }
            }
        }
        Ok(standing)
    }

    /// A size, which has to be one: a body without it is another one, or absent.
    fn size(&mut self, id: NodeId) -> Result<Value, Error> {
        let size = self.given(Some(id))?;
        self.code.require_positive(size.value)?;
        Ok(size)
    }

    fn without_radii<const N: usize>(
        &mut self,
        distance: Value,
        bodies: [&Standing; N],
    ) -> Result<Value, Error> {
        let mut left = distance;
        for radius in bodies.into_iter().filter_map(|body| body.radius) {
            left = self.code.minus(left, radius)?;
        }
        Ok(left)
    }

    /// How much room there is for a body in another one.
    fn room(
        &mut self,
        a: &Standing,
        b: &Standing,
        d: [Value; 3],
        count: usize,
    ) -> Result<Value, Error> {
        if b.radius.is_none() && b.has_sides(count) {
            let mut room = None;
            self.local(b, d, count)?;
            for (index, half) in b.halves.into_iter().enumerate().take(count) {
                let Some(half) = half else { continue };
                let own = self.slab([a, b], index, half, d)?;
                room = Some(match room {
                    Some(room) => self.lesser(room, own)?,
                    None => own,
                });
            }
            return Ok(room.unwrap_or(Value::ZERO));
        }
        let farthest = self.fold_corners(a, b, d, count, Places::greater)?;
        let mut room = b.radius.unwrap_or(Value::ZERO);
        room = self.code.minus(room, a.radius.unwrap_or(Value::ZERO))?;
        self.code.minus(room, farthest)
    }

    /// How much room there is for a body between two sides of another one, across an axis.
    fn slab(
        &mut self,
        [a, b]: [&Standing; 2],
        index: usize,
        half: Value,
        d: [Value; 3],
    ) -> Result<Value, Error> {
        let direction = nth(b.axes, index);
        let turned = self.turned(a.yaw, b.yaw)?;
        let mut room = half;
        for (side, own) in a.halves.into_iter().enumerate() {
            let Some(own) = own else { continue };
            let across = match turned {
                Some(axes) => nth(nth(axes, side), index),
                None => dot(&mut self.code, nth(a.axes, side), direction)?,
            };
            let across = self.magnitude(across)?;
            let extent = self.code.times(across, own)?;
            room = self.code.minus(room, extent)?;
        }
        if let Some(radius) = a.radius {
            room = self.code.minus(room, radius)?;
        }
        let offset = dot(&mut self.code, d, direction)?;
        let offset = self.magnitude(offset)?;
        self.code.minus(room, offset)
    }

    /// A vector in the frame of a body.
    fn local(&mut self, body: &Standing, d: [Value; 3], count: usize) -> Result<[Value; 3], Error> {
        let mut local = [Value::ZERO; 3];
        for (own, axis) in local.iter_mut().zip(body.axes) {
            *own = dot(&mut self.code, d, axis)?;
        }
        // All three of them are as long as the vector.
        self.code.note_turned(d, local, body.axes)?;
        for own in local.iter_mut().skip(count) {
            *own = Value::ZERO;
        }
        Ok(local)
    }

    /// The distance from the core of a body to what lies off its centre; below zero, how deep
    /// that is in it.
    fn distance_from_core(
        &mut self,
        body: &Standing,
        d: [Value; 3],
        count: usize,
    ) -> Result<Value, Error> {
        if !body.has_sides(count) {
            return self.code.norm(d);
        }
        let local = self.local(body, d, count)?;
        let mut beyond = [Value::ZERO; 3];
        let mut deepest: Option<Value> = None;
        let axes = local.into_iter().zip(body.halves);
        for (own, (along, half)) in beyond.iter_mut().zip(axes).take(count) {
            let along = self.magnitude(along)?;
            let past = self.code.minus(along, half.unwrap_or(Value::ZERO))?;
            *own = self.greater(past, Value::ZERO)?;
            deepest = Some(match deepest {
                Some(deepest) => self.greater(deepest, past)?,
                None => past,
            });
        }
        let outside = self.code.norm(beyond)?;
        let inside = self.lesser(deepest.unwrap_or(Value::ZERO), Value::ZERO)?;
        self.code.plus(outside, inside)
    }

    /// The least or the greatest of how far the corners of a body are from the core of
    /// another one.
    fn fold_corners(
        &mut self,
        a: &Standing,
        b: &Standing,
        d: [Value; 3],
        count: usize,
        choose: fn(&mut Self, Value, Value) -> Result<Value, Error>,
    ) -> Result<Value, Error> {
        let sides: Vec<_, 3> = a.sides(count).collect();
        let mut chosen = None;
        for corner in 0..1u32 << sides.len() {
            let mut at = d;
            for (index, (axis, half)) in sides.iter().enumerate() {
                for (own, entry) in at.iter_mut().zip(*axis).take(count) {
                    let step = self.code.times(entry, *half)?;
                    *own = match corner >> index & 1 {
                        0 => self.code.plus(*own, step)?,
                        _ => self.code.minus(*own, step)?,
                    };
                }
            }
            let own = self.distance_from_core(b, at, count)?;
            chosen = Some(match chosen {
                Some(chosen) => choose(self, chosen, own)?,
                None => own,
            });
        }
        Ok(chosen.unwrap_or(Value::ZERO))
    }

    fn magnitude(&mut self, a: Value) -> Result<Value, Error> {
        match a.value {
            Operand::Zero | Operand::One => Ok(a),
            _ => self.code.norm([a, Value::ZERO, Value::ZERO]),
        }
    }

    fn lesser(&mut self, a: Value, b: Value) -> Result<Value, Error> {
        let operation = Operation::Least(a.value, b.value);
        Ok(Value::constant(self.code.operation(operation)?))
    }

    fn greater(&mut self, a: Value, b: Value) -> Result<Value, Error> {
        let operation = Operation::Greatest(a.value, b.value);
        Ok(Value::constant(self.code.operation(operation)?))
    }
}

/// Whether bodies lie in the plane.
fn dimensions(domain: &Domain<'_>) -> Dimensions {
    match domain.bodies().is_empty() || domain.axes() < 3 {
        true => Dimensions::Plane,
        false => Dimensions::Space,
    }
}

/// What belongs to an axis.
fn along<T>(axis: Axis, mut all: impl Iterator<Item = T>) -> Result<T, Error> {
    all.nth(index_of(axis))
        .ok_or(Error::InvalidArgument("a body has three axes"))
}

fn index_of(axis: Axis) -> usize {
    match axis {
        Axis::X => 0,
        Axis::Y => 1,
        Axis::Z => 2,
    }
}

/// One of three values, or vectors; any other one is the first.
fn nth<T: Copy>(all: [T; 3], index: usize) -> T {
    let [first, ..] = all;
    all.into_iter().nth(index).unwrap_or(first)
}
