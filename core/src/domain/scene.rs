//! Putting numbers into expressions, in two steps: an instance makes a [`Scene`],
//! parameters make a sample of it. What depends on the instance only (the poses of
//! objects and key points, and all their sines and cosines) is computed once.

use super::algebra::{Algebra, Arithmetic};
use super::declarations::{Base, Point, Shape};
use super::instance::{TOO_LARGE, held};
use super::node::{Node, NodeId, Quantity};
use super::point_set::PointSet;
use super::schema::{Domain, MAX_OBJECTS, MAX_POINTS};
use super::turns::Turn;
use crate::error::Error;
use crate::geometry::{Dimensions, Rotation};
use crate::real::Real;
use heapless::Vec;

/// Most points of a domain that depend on a parameter.
pub const MAX_SAMPLE_POINTS: usize = 8;

/// Most numbers for the rotations of a scene: two for each object or turned point, if
/// it is turned about the z axis, nine if it is tilted. A point that is turned like its
/// base needs none.
const MAX_TURN_NUMBERS: usize = 3 * MAX_OBJECTS;

/// A domain in one problem instance: every pose that needs no parameters.
#[derive(Clone, Debug)]
pub struct Scene<'a, R> {
    pub(super) domain: &'a Domain<'a>,
    instance: &'a [f64],
    pub(super) points: PointSet,
    /// The origins of the points that do not depend on the parameters.
    pub(super) origins: Vec<[R; 3], MAX_POINTS>,
    /// Where the rotation of each such point is: most points share that of their base.
    turns: Vec<Turn, MAX_POINTS>,
    pub(super) rotations: Vec<R, MAX_TURN_NUMBERS>,
    /// Whether bodies lie in the plane or in space.
    pub(super) dimensions: Dimensions,
}

impl<'a, R: Real> Scene<'a, R> {
    /// The domain in `instance`, ready for expressions over `points`.
    ///
    /// # Errors
    /// Those of [`Domain::check_instance`]; [`Error::CapacityExceeded`] for more
    /// sample points than [`MAX_SAMPLE_POINTS`], or if the rotations of objects and
    /// turned points need more than 96 numbers: two each, but nine where the pitch or
    /// roll is not zero.
    pub fn new(
        domain: &'a Domain<'a>,
        instance: &'a [f64],
        points: PointSet,
    ) -> Result<Self, Error> {
        let mut scene = Scene::blank(domain, instance, points);
        scene.place_points()?;
        Ok(scene)
    }

    /// As [`Scene::new`], still without points: [`Scene::place_points`] adds them in
    /// place, so that nothing large is moved.
    pub(crate) fn blank(domain: &'a Domain<'a>, instance: &'a [f64], points: PointSet) -> Self {
        Scene {
            domain,
            instance,
            points,
            origins: Vec::new(),
            turns: Vec::new(),
            rotations: Vec::new(),
            dimensions: match domain.bodies().is_empty() || domain.axes() < 3 {
                true => Dimensions::Plane,
                false => Dimensions::Space,
            },
        }
    }

    pub(crate) fn place_points(&mut self) -> Result<(), Error> {
        self.domain.check_instance(self.instance)?;
        held::<R>(self.instance.iter().copied(), TOO_LARGE)?;
        if self.points.sampled.iter().nth(MAX_SAMPLE_POINTS).is_some() {
            return Err(Error::CapacityExceeded("points that depend on a parameter"));
        }
        for index in self.points.fixed.iter() {
            if let Some(point) = self.domain.points().get(usize::from(index)) {
                self.place(point)?;
            }
        }
        Ok(())
    }

    /// Turns and moves a point in the frame it is placed in.
    fn place(&mut self, point: &Point<'_>) -> Result<(), Error> {
        let (mut origin, base) = match point.base {
            Base::World => ([R::ZERO; 3], Turn::World),
            Base::Object(object) => (self.object_origin(object), self.object_turn(point, object)?),
            Base::Point(p) => self.placed(p),
        };
        let turn = if is_zero(&point.turn) {
            base
        } else {
            let angles = point.turn.map(|id| self.offset_term(id, &[]));
            let base = base.rotation(&self.rotations).unwrap_or(Rotation::None);
            Turn::keep(&base.compose(&Rotation::new(angles)), &mut self.rotations)?
        };
        if !is_zero(&point.offset) {
            let mut step = [R::ZERO; 3];
            if let Some(rotation) = turn.rotation(&self.rotations) {
                self.advance(&mut step, &rotation, &point.offset, &[]);
            }
            for (coordinate, step) in origin.iter_mut().zip(step) {
                *coordinate += step;
            }
        }
        // There is room: a domain has no more points.
        let _ = self.origins.push(origin);
        let _ = self.turns.push(turn);
        Ok(())
    }

    pub(super) fn slot(&self, slot: u8) -> R {
        self.instance
            .get(usize::from(slot))
            .map_or(R::ZERO, |value| R::from_f64(*value))
    }

    pub(super) fn object_origin(&self, object: u8) -> [R; 3] {
        let mut origin = [R::ZERO; 3];
        let pose = self.domain.pose_slots(object);
        for (coordinate, slot) in origin.iter_mut().zip(&pose.position) {
            if let Some(slot) = slot {
                *coordinate = self.slot(*slot);
            }
        }
        origin
    }

    pub(super) fn object_rotation(&self, object: u8) -> Rotation<R> {
        let read = |slot: Option<u8>| slot.map_or(R::ZERO, |slot| self.slot(slot));
        match self.domain.pose_slots(object).angles {
            [None, None, None] => Rotation::None,
            [Some(yaw), None, None] => Rotation::planar(self.slot(yaw)),
            // An absent member has none, and no room is kept for it.
            angles => match angles.map(read) {
                angles if angles.iter().all(|a| a.is_finite()) => Rotation::new(angles),
                _ => Rotation::None,
            },
        }
    }

    /// How the object of a point is turned. The points of its shape share the rotation of
    /// the object.
    fn object_turn(&mut self, point: &Point<'_>, object: u8) -> Result<Turn, Error> {
        if !is_zero(&point.offset) {
            let earlier = self.points.fixed.iter().zip(&self.turns);
            for (index, turn) in earlier {
                let other = self.domain.points().get(usize::from(index));
                if other.is_some_and(|p| p.base == point.base && is_zero(&p.turn)) {
                    return Ok(*turn);
                }
            }
        }
        Turn::keep(&self.object_rotation(object), &mut self.rotations)
    }

    /// Where a point is, and how it is turned.
    pub(super) fn placed(&self, point: u8) -> ([R; 3], Turn) {
        let rank = self.points.fixed.rank(point);
        match (self.origins.get(rank), self.turns.get(rank)) {
            (Some(origin), Some(turn)) => (*origin, *turn),
            _ => ([R::NAN; 3], Turn::Unknown),
        }
    }

    /// By how much the first of two points is turned further than the second one, where both
    /// are turned about the z axis only.
    pub(super) fn turned<A: Algebra<R>>(&self, points: [u8; 2], theta: &[A]) -> Option<A> {
        let [a, b] = points.map(|point| self.yaw(point, theta));
        Some(a?.minus(b?))
    }

    /// The heading of a point as a sum of angles, which may be any number of turns.
    fn yaw<A: Algebra<R>>(&self, point: u8, theta: &[A]) -> Option<A> {
        let mut yaw = A::constant(R::ZERO);
        let mut next = point;
        loop {
            let point = self.domain.points().get(usize::from(next))?;
            let [turn, None, None] = point.turn else {
                return None;
            };
            yaw = yaw.plus(self.offset_term(turn, theta));
            match point.base {
                Base::World => return Some(yaw),
                // Bases stand before what is placed in them.
                Base::Point(earlier) => next = earlier,
                Base::Object(object) => {
                    return match self.domain.pose_slots(object).angles {
                        [None, None, None] => Some(yaw),
                        [Some(own), None, None] => Some(yaw.plus(A::constant(self.slot(own)))),
                        _ => None,
                    };
                }
            }
        }
    }

    /// The value of an offset or turn, which never depends on points.
    pub(super) fn offset_term<A: Algebra<R>>(&self, id: Option<NodeId>, theta: &[A]) -> A {
        let Some(id) = id else {
            return A::constant(R::ZERO);
        };
        let term = |id| self.offset_term(Some(id), theta);
        match self.domain.nodes().get(usize::from(id.0)) {
            Some(Node::Sum(a, b)) => term(*a).plus(term(*b)),
            Some(Node::Difference(a, b)) => term(*a).minus(term(*b)),
            Some(Node::Product(a, b)) => term(*a).times(term(*b)),
            Some(Node::Quotient(a, b)) => term(*a).over(term(*b)),
            Some(Node::Parameter(p)) => parameter(theta, *p),
            Some(
                leaf @ (Node::Number(_)
                | Node::Constant(_)
                | Node::Area(_)
                | Node::Quantity(_)
                | Node::Extreme(..)),
            ) => A::constant(self.given(leaf)),
            None => A::unknown(),
        }
    }

    /// Moves a point along the axes of a rotation, leaving out what is zero.
    pub(super) fn advance<A: Algebra<R>>(
        &self,
        [x, y, z]: &mut [A; 3],
        rotation: &Rotation<R>,
        offset: &[Option<NodeId>; 3],
        theta: &[A],
    ) {
        let steps = offset.map(|id| id.map(|_| self.offset_term(id, theta)));
        let add = |coordinate: &mut A, step: A, entry: R| {
            *coordinate = coordinate.plus(step.scaled(entry));
        };
        let [along_x, along_y, along_z] = steps;
        let [cos, sin] = match rotation {
            Rotation::None => [R::ONE, R::ZERO],
            Rotation::Planar(direction) => *direction,
            Rotation::Tilted(rows) => {
                for (coordinate, row) in [x, y, z].into_iter().zip(rows) {
                    for (step, entry) in steps.iter().zip(row) {
                        if let Some(step) = step {
                            add(coordinate, *step, *entry);
                        }
                    }
                }
                return;
            }
        };
        if let Some(step) = along_x {
            add(x, step, cos);
            add(y, step, sin);
        }
        if let Some(step) = along_y {
            add(x, step, -sin);
            add(y, step, cos);
        }
        if let Some(step) = along_z {
            *z = z.plus(step);
        }
    }

    /// The quantity of each member that the instance has.
    pub(super) fn of_members(&self, quantity: Quantity) -> impl Iterator<Item = Quantity> + '_ {
        let members = self.domain.of_members(quantity);
        let present = members.filter(|(member, _)| member.is_present(self.instance));
        present.map(|(_, quantity)| quantity)
    }

    /// The value of a term whose value is given; NaN for any other term.
    pub(super) fn given(&self, term: &Node) -> R {
        match *term {
            Node::Number(value) => R::from_f64(value),
            Node::Constant(i) => {
                let constant = self.domain.constants().get(usize::from(i));
                constant.map_or(R::ZERO, |c| R::from_f64(c.value))
            }
            Node::Area(shape) => self.area(shape),
            Node::Quantity(quantity) => quantity.slot().map_or(R::NAN, |slot| self.slot(slot)),
            Node::Parameter(_)
            | Node::Extreme(..)
            | Node::Sum(..)
            | Node::Difference(..)
            | Node::Product(..)
            | Node::Quotient(..) => R::NAN,
        }
    }

    fn area(&self, shape: u8) -> R {
        let size = |id| self.offset_term::<R>(Some(id), &[]);
        match self.domain.shapes().get(usize::from(shape)) {
            Some((_, Shape::Circle { radius })) => {
                let radius = size(*radius);
                R::from_f64(core::f64::consts::PI) * radius * radius
            }
            Some((_, Shape::Rectangle { width, height })) => size(*width) * size(*height),
            None => R::unknown(),
        }
    }
}

/// Whether an offset or turn is none.
pub(super) fn is_zero(terms: &[Option<NodeId>; 3]) -> bool {
    terms.iter().all(Option::is_none)
}

pub(super) fn parameter<R: Real, A: Algebra<R>>(theta: &[A], index: u8) -> A {
    let value = theta.get(usize::from(index)).copied();
    value.unwrap_or_else(A::unknown)
}
