//! Putting numbers into expressions, in two steps: an instance makes a [`Scene`],
//! parameters make a [`Sample`] of it. What an instance settles (the poses of
//! objects and key points, and all their sines and cosines) is computed once.

use super::algebra::{Algebra, Arithmetic, Measure};
use super::expression::{Coordinate, Metric, Node, NodeId};
use super::group::{Extreme, Relation};
use super::point_set::PointSet;
use super::schema::{Base, Domain, MAX_OBJECTS, MAX_POINTS, Point, Shape};
use super::turns::Turn;
use crate::error::Error;
use crate::geometry::Rotation;
use crate::real::Real;
use heapless::Vec;

/// Most points of a domain that depend on a parameter.
pub const MAX_SAMPLE_POINTS: usize = 6;

/// Most numbers for the rotations of a scene: two for each object or turned point, if
/// it is turned about the z axis, nine if it is tilted. Points that are turned as what
/// they are placed in need none.
const MAX_TURN_NUMBERS: usize = 3 * MAX_OBJECTS;

/// Where a sample point is: its origin may vary with the parameters.
#[derive(Clone, Copy, Debug)]
struct Placed<A> {
    origin: [A; 3],
    turn: Turn,
    /// Whether its rotation is one of the sample, and not of the scene.
    turns_itself: bool,
}

/// A domain in one problem instance: every pose that needs no parameters.
#[derive(Clone, Debug)]
pub struct Scene<'a, R> {
    domain: &'a Domain<'a>,
    instance: &'a [f64],
    points: PointSet,
    /// Of the points that do not depend on the parameters.
    origins: Vec<[R; 3], MAX_POINTS>,
    /// An index each and no rotation: the usual point is turned like its base.
    turns: Vec<Turn, MAX_POINTS>,
    rotations: Vec<R, MAX_TURN_NUMBERS>,
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
        scene.settle()?;
        Ok(scene)
    }

    /// As [`Scene::new`], to be completed in place by [`Scene::settle`], which saves
    /// moving the points.
    pub(crate) fn blank(domain: &'a Domain<'a>, instance: &'a [f64], points: PointSet) -> Self {
        Scene {
            domain,
            instance,
            points,
            origins: Vec::new(),
            turns: Vec::new(),
            rotations: Vec::new(),
        }
    }

    pub(crate) fn settle(&mut self) -> Result<(), Error> {
        self.domain.check_instance(self.instance)?;
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

    /// The scene at a sample; `theta` has one entry per parameter.
    pub fn sample<'s, A: Algebra<R>>(&'s self, theta: &'s [A]) -> Sample<'s, 'a, R, A> {
        let mut sample = Sample::blank(self, theta);
        sample.settle();
        sample
    }

    fn slot(&self, slot: u8) -> R {
        self.instance
            .get(usize::from(slot))
            .map_or(R::ZERO, |value| R::from_f64(*value))
    }

    fn object_origin(&self, object: u8) -> [R; 3] {
        let mut origin = [R::ZERO; 3];
        let pose = self.domain.pose_slots(object);
        for (coordinate, slot) in origin.iter_mut().zip(&pose.position) {
            if let Some(slot) = slot {
                *coordinate = self.slot(*slot);
            }
        }
        origin
    }

    fn object_rotation(&self, object: u8) -> Rotation<R> {
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

    /// How the object of a point is turned. The points of its shape are turned as it is
    /// itself, which needs no second rotation.
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
    fn placed(&self, point: u8) -> ([R; 3], Turn) {
        let rank = self.points.fixed.rank(point);
        match (self.origins.get(rank), self.turns.get(rank)) {
            (Some(origin), Some(turn)) => (*origin, *turn),
            _ => ([R::NAN; 3], Turn::Unknown),
        }
    }

    /// The value of an offset or turn; these never speak about points.
    fn offset_term<A: Algebra<R>>(&self, id: Option<NodeId>, theta: &[A]) -> A {
        let Some(id) = id else {
            return A::constant(R::ZERO);
        };
        let term = |id| self.offset_term(Some(id), theta);
        match self.domain.nodes().get(usize::from(id.0)) {
            Some(Node::Sum(a, b)) => term(*a).plus(term(*b)),
            Some(Node::Difference(a, b)) => term(*a).minus(term(*b)),
            Some(Node::Product(a, b)) => term(*a).times(term(*b)),
            Some(Node::Parameter(p)) => parameter(theta, *p),
            Some(leaf) => A::constant(self.settled(leaf)),
            None => A::unknown(),
        }
    }

    /// Moves a point along the axes of a rotation, leaving out what is zero.
    fn advance<A: Algebra<R>>(
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

    /// What a relation is for each member of its group that the instance has.
    fn terms(&self, relation: Relation) -> impl Iterator<Item = Node> + '_ {
        let members = self.domain.terms(relation);
        let present = members.filter(|(member, _)| member.is_present(self.instance));
        present.map(|(_, term)| term)
    }

    /// The value of a leaf that needs no sample and no pose.
    fn settled(&self, leaf: &Node) -> R {
        match *leaf {
            Node::Number(value) => R::from_f64(value),
            Node::Attribute(slot) => self.slot(slot),
            Node::Constant(i) => {
                let constant = self.domain.constants().get(usize::from(i));
                constant.map_or(R::ZERO, |c| R::from_f64(c.value))
            }
            Node::Area(shape) => self.area(shape),
            _ => R::unknown(),
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

/// A scene at one sample: the sample points have their places.
#[derive(Clone, Debug)]
pub struct Sample<'s, 'a, R, A> {
    scene: &'s Scene<'a, R>,
    theta: &'s [A],
    placed: Vec<Placed<A>, MAX_SAMPLE_POINTS>,
    /// Of the points that are turned.
    rotations: Vec<R, { 9 * MAX_SAMPLE_POINTS }>,
}

impl<'s, 'a, R: Real, A: Algebra<R>> Sample<'s, 'a, R, A> {
    /// As [`Scene::sample`], to be completed in place by [`Sample::settle`], which saves
    /// moving the points.
    pub(crate) fn blank(scene: &'s Scene<'a, R>, theta: &'s [A]) -> Self {
        Sample {
            scene,
            theta,
            placed: Vec::new(),
            rotations: Vec::new(),
        }
    }

    #[inline(never)]
    pub(crate) fn settle(&mut self) {
        for index in self.scene.points.sampled.iter() {
            if let Some(point) = self.scene.domain.points().get(usize::from(index)) {
                let placed = self.place(point);
                // There is room: the scene counted the points.
                let _ = self.placed.push(placed);
            }
        }
    }

    /// The value of an expression.
    pub fn measure(&self, nodes: &[Node], id: NodeId) -> A::Measure {
        match nodes.get(usize::from(id.0)) {
            Some(node) => self.node(*node, |id| self.measure(nodes, id)),
            None => A::Measure::unknown(),
        }
    }

    /// The first of two expressions minus the second, which mostly is a mere number.
    #[inline(never)]
    pub(crate) fn difference(&self, nodes: &[Node], [left, right]: [NodeId; 2]) -> A::Measure {
        let mut left = self.measure(nodes, left);
        match nodes.get(usize::from(right.0)) {
            Some(term @ (Node::Number(_) | Node::Constant(_) | Node::Attribute(_))) => {
                left.lower(self.scene.settled(term));
                left
            }
            _ => left.minus(self.measure(nodes, right)),
        }
    }

    /// As [`Sample::measure`], with one member of a group in place of all where
    /// `chosen` has one for an extreme: by its place among those the instance has.
    pub(crate) fn measure_choosing(
        &self,
        nodes: &[Node],
        id: NodeId,
        chosen: &impl Fn(NodeId) -> Option<usize>,
    ) -> A::Measure {
        let term = match (nodes.get(usize::from(id.0)), chosen(id)) {
            (Some(Node::Extreme(_, relation)), Some(place)) => {
                self.scene.terms(*relation).nth(place)
            }
            (node, _) => node.copied(),
        };
        term.map_or_else(A::Measure::unknown, |node| {
            self.node(node, |id| self.measure_choosing(nodes, id, chosen))
        })
    }

    /// How many members of its group the instance has for a relation.
    pub(crate) fn member_count(&self, relation: Relation) -> usize {
        self.scene.terms(relation).count()
    }

    /// The value of a node whose operands are known.
    #[inline]
    pub fn node(&self, node: Node, operand: impl Fn(NodeId) -> A::Measure) -> A::Measure {
        match node {
            Node::Sum(a, b) => operand(a).plus(operand(b)),
            Node::Difference(a, b) => operand(a).minus(operand(b)),
            Node::Product(a, b) => operand(a).times(operand(b)),
            leaf => self.leaf(leaf),
        }
    }

    fn leaf(&self, leaf: Node) -> A::Measure {
        match leaf {
            Node::Parameter(p) => parameter(self.theta, p).measure(),
            Node::Coordinate(coordinate, p) => self.coordinate(coordinate, p),
            Node::Distance(metric, a, b) => self.distance(metric, a, b),
            Node::Angle(a, b) => self.angle(a, b),
            Node::VertexAngle(a, vertex, b) => self.vertex_angle(a, vertex, b),
            Node::Extreme(extreme, relation) => self.extreme(extreme, relation),
            settled => A::Measure::constant(self.scene.settled(&settled)),
        }
    }

    #[inline(never)]
    fn extreme(&self, extreme: Extreme, relation: Relation) -> A::Measure {
        let values = self.scene.terms(relation).map(|term| self.leaf(term));
        values
            .reduce(|a, b| a.extreme(extreme, b))
            .unwrap_or_else(|| A::Measure::constant(extreme.of_nothing()))
    }

    fn coordinate(&self, coordinate: Coordinate, point: u8) -> A::Measure {
        match coordinate {
            Coordinate::X => self.along(0, point).measure(),
            Coordinate::Y => self.along(1, point).measure(),
            Coordinate::Z => self.along(2, point).measure(),
            Coordinate::Theta => match self.heading(point) {
                Some([x, y, _]) => A::Measure::constant(y.atan2(x)),
                None => A::Measure::unknown(),
            },
        }
    }

    fn distance(&self, metric: Metric, a: u8, b: u8) -> A::Measure {
        let zero = A::constant(R::ZERO);
        let axis = match metric {
            Metric::X => 0,
            Metric::Y => 1,
            Metric::Z => 2,
            Metric::Straight => {
                let ([ax, ay, az], [bx, by, bz]) = (self.origin(a), self.origin(b));
                return A::norm([ax.minus(bx), ay.minus(by), az.minus(bz)]);
            }
        };
        A::norm([self.along(axis, a).minus(self.along(axis, b)), zero, zero])
    }

    fn angle(&self, a: u8, b: u8) -> A::Measure {
        let headings = (self.heading(a), self.heading(b));
        match headings {
            (Some(a), Some(b)) => A::Measure::constant(R::angle(a, b)),
            _ => A::Measure::unknown(),
        }
    }

    #[inline(never)]
    fn vertex_angle(&self, a: u8, vertex: u8, b: u8) -> A::Measure {
        let at = self.origin(vertex);
        let [to_a, to_b] = [a, b].map(|point| {
            let [[x, y, z], [ox, oy, oz]] = [self.origin(point), at];
            [x.minus(ox), y.minus(oy), z.minus(oz)]
        });
        A::angle(to_a, to_b)
    }

    /// Where a sample point is; `None` for a point that is none.
    fn placed(&self, point: u8) -> Option<&Placed<A>> {
        let sampled = self.scene.points.sampled;
        sampled
            .has(point)
            .then(|| self.placed.get(sampled.rank(point)))?
    }

    fn origin(&self, point: u8) -> [A; 3] {
        match self.placed(point) {
            Some(placed) => placed.origin,
            None => self.scene.placed(point).0.map(A::constant),
        }
    }

    /// One coordinate of a point, by the number of the axis.
    fn along(&self, axis: usize, point: u8) -> A {
        let known = match self.placed(point) {
            Some(placed) => placed.origin.get(axis).copied(),
            None => {
                let origin = self.scene.origins.get(self.scene.points.fixed.rank(point));
                let known = origin.and_then(|origin| origin.get(axis));
                known.map(|value| A::constant(*value))
            }
        };
        known.unwrap_or_else(A::unknown)
    }

    /// A point that others are placed in.
    fn base(&self, point: u8) -> Placed<A> {
        match self.placed(point) {
            Some(placed) => *placed,
            None => {
                let (origin, turn) = self.scene.placed(point);
                Placed {
                    origin: origin.map(A::constant),
                    turn,
                    turns_itself: false,
                }
            }
        }
    }

    /// The list that a turn is one of.
    fn list(&self, own: bool) -> &[R] {
        if own {
            &self.rotations
        } else {
            &self.scene.rotations
        }
    }

    /// The rotation of a point, if it is known.
    fn rotation(&self, placed: &Placed<A>) -> Option<Rotation<R>> {
        placed.turn.rotation(self.list(placed.turns_itself))
    }

    /// The direction of a point's x axis, if it is known.
    fn heading(&self, point: u8) -> Option<[R; 3]> {
        Some(self.rotation(&self.base(point))?.heading())
    }

    /// Turns and moves a sample point in the frame it is placed in.
    #[inline(never)]
    fn place(&mut self, point: &Point<'_>) -> Placed<A> {
        let mut placed = match point.base {
            Base::World => Placed {
                origin: [A::constant(R::ZERO); 3],
                turn: Turn::World,
                turns_itself: false,
            },
            Base::Object(object) => Placed {
                origin: self.scene.object_origin(object).map(A::constant),
                turn: self.keep(&self.scene.object_rotation(object)),
                turns_itself: true,
            },
            Base::Point(p) => self.base(p),
        };
        if !is_zero(&point.turn) {
            placed.turn = self.turned(&placed, point.turn);
            placed.turns_itself = true;
        }
        if !is_zero(&point.offset) {
            match self.rotation(&placed) {
                Some(rotation) => {
                    let origin = &mut placed.origin;
                    self.scene
                        .advance(origin, &rotation, &point.offset, self.theta);
                }
                None => placed.origin = [A::unknown(); 3],
            }
        }
        placed
    }

    /// A turn that varies is unknown, unless the algebra is that of numbers.
    fn turned(&mut self, base: &Placed<A>, turn: [Option<NodeId>; 3]) -> Turn {
        let angles = turn.map(|id| self.scene.offset_term(id, self.theta).known());
        match (self.rotation(base), angles) {
            (Some(base), [Some(yaw), Some(pitch), Some(roll)]) => {
                self.keep(&base.compose(&Rotation::new([yaw, pitch, roll])))
            }
            _ => Turn::Unknown,
        }
    }

    /// Keeps a rotation; there is room for one of each sample point.
    fn keep(&mut self, rotation: &Rotation<R>) -> Turn {
        Turn::keep(rotation, &mut self.rotations).unwrap_or(Turn::Unknown)
    }
}

/// Whether an offset or turn is none.
fn is_zero(terms: &[Option<NodeId>; 3]) -> bool {
    terms.iter().all(Option::is_none)
}

fn parameter<R: Real, A: Algebra<R>>(theta: &[A], index: u8) -> A {
    let value = theta.get(usize::from(index)).copied();
    value.unwrap_or_else(A::unknown)
}
