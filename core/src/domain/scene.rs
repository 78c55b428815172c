//! Putting numbers into expressions, in two steps: an instance makes a [`Scene`],
//! parameters make a [`Sample`] of it. What an instance settles (the poses of
//! objects and key points, and all their sines and cosines) is computed once.

use super::algebra::{Algebra, Arithmetic, Measure};
use super::expression::{Coordinate, Metric, Node, NodeId, node_at};
use super::group::{Extreme, Relation};
use super::point_set::PointSet;
use super::schema::{Base, Domain, MAX_POINTS, Point, Shape};
use crate::error::Error;
use crate::geometry::Frame3;
use crate::real::Real;
use heapless::Vec;

/// Most points of a domain that depend on a parameter.
pub const MAX_SAMPLE_POINTS: usize = 6;

/// Where a sample point is: its origin may vary with the parameters.
#[derive(Clone, Copy, Debug)]
struct Placed<A> {
    origin: [A; 3],
    turn: Turn,
}

/// How a sample point is turned. An index and no frame: the usual point is turned
/// like its base, and copying frames would cost more than all the rest.
#[derive(Clone, Copy, Debug)]
enum Turn {
    /// As the world.
    World,
    /// As a point that does not depend on the parameters.
    As(u8),
    /// In its own way, by the index of its frame in the sample.
    Own(u8),
    /// In a way that varies and that the algebra cannot follow: it can with
    /// numbers only.
    Unknown,
}

/// A domain in one problem instance: every pose that needs no parameters.
#[derive(Clone, Debug)]
pub struct Scene<'a, R, const POINTS: usize = MAX_POINTS> {
    domain: &'a Domain<'a>,
    instance: &'a [f64],
    points: PointSet,
    /// Of the points that do not depend on the parameters.
    frames: Vec<Frame3<R>, POINTS>,
}

impl<'a, R: Real, const POINTS: usize> Scene<'a, R, POINTS> {
    /// The domain in `instance`, ready for expressions over `points`.
    ///
    /// # Errors
    /// Those of [`Domain::check_instance`]; [`Error::CapacityExceeded`] for more
    /// points than `POINTS`, or more sample points than [`MAX_SAMPLE_POINTS`].
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
    /// moving the frames.
    pub(crate) fn blank(domain: &'a Domain<'a>, instance: &'a [f64], points: PointSet) -> Self {
        Scene {
            domain,
            instance,
            points,
            frames: Vec::new(),
        }
    }

    pub(crate) fn settle(&mut self) -> Result<(), Error> {
        self.domain.check_instance(self.instance)?;
        if self.points.sampled.len() > MAX_SAMPLE_POINTS {
            return Err(Error::CapacityExceeded("points that depend on a parameter"));
        }
        for index in self.points.fixed.iter() {
            if let Some(point) = self.domain.points().get(usize::from(index)) {
                let frame = self.fixed_frame(point);
                self.frames
                    .push(frame)
                    .map_err(|_| Error::CapacityExceeded("points of a region or domain"))?;
            }
        }
        Ok(())
    }

    /// The scene at a sample; `theta` has one entry per parameter.
    pub fn sample<'s, A: Algebra<R>>(&'s self, theta: &'s [A]) -> Sample<'s, 'a, R, A, POINTS> {
        let mut sample = Sample {
            scene: self,
            theta,
            placed: Vec::new(),
            frames: Vec::new(),
        };
        for index in self.points.sampled.iter() {
            if let Some(point) = self.domain.points().get(usize::from(index)) {
                let placed = sample.place(point);
                // There is room: the scene counted the points.
                let _ = sample.placed.push(placed);
            }
        }
        sample
    }

    fn slot(&self, slot: u8) -> R {
        self.instance
            .get(usize::from(slot))
            .map_or(R::ZERO, |value| R::from_f64(*value))
    }

    fn fixed_frame(&self, point: &Point<'_>) -> Frame3<R> {
        let base = match point.base {
            Base::World => Frame3::identity(),
            Base::Object(object) => self.object_frame(object),
            Base::Point(p) => self.frame(p).copied().unwrap_or_else(Frame3::identity),
        };
        let terms = |ids: [Option<NodeId>; 3]| ids.map(|id| self.offset_term::<R>(id, &[]));
        let turned = turned(base, point.turn, terms(point.turn));
        if point.offset == [None; 3] {
            return turned;
        }
        turned.shifted(terms(point.offset))
    }

    fn object_frame(&self, object: u8) -> Frame3<R> {
        let pose = self.domain.pose_slots(object);
        let read = |slot: Option<u8>| slot.map_or(R::ZERO, |s| self.slot(s));
        Frame3::new(pose.position.map(read), pose.angles.map(read))
    }

    fn frame(&self, point: u8) -> Option<&Frame3<R>> {
        self.frames.get(self.points.fixed.rank(point))
    }

    /// The value of an offset or turn; these never speak about points.
    fn offset_term<A: Algebra<R>>(&self, id: Option<NodeId>, theta: &[A]) -> A {
        let Some(id) = id else {
            return A::constant(R::ZERO);
        };
        let term = |id| self.offset_term(Some(id), theta);
        match node_at(self.domain.nodes(), id) {
            Ok(Node::Sum(a, b)) => term(a).plus(term(b)),
            Ok(Node::Difference(a, b)) => term(a).minus(term(b)),
            Ok(Node::Product(a, b)) => term(a).times(term(b)),
            Ok(Node::Parameter(p)) => parameter(theta, p),
            Ok(leaf) => A::constant(self.settled(leaf)),
            Err(_) => A::unknown(),
        }
    }

    /// What a relation is for each member of its group that the instance has.
    fn terms(&self, relation: Relation) -> impl Iterator<Item = Node> + '_ {
        let members = self.domain.terms(relation);
        let present = members.filter(|(member, _)| member.is_present(self.instance));
        present.map(|(_, term)| term)
    }

    /// The value of a leaf that needs no sample and no pose.
    fn settled(&self, leaf: Node) -> R {
        match leaf {
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
pub struct Sample<'s, 'a, R, A, const POINTS: usize = MAX_POINTS> {
    scene: &'s Scene<'a, R, POINTS>,
    theta: &'s [A],
    placed: Vec<Placed<A>, MAX_SAMPLE_POINTS>,
    /// Of the points that are turned; only their rotation counts.
    frames: Vec<Frame3<R>, MAX_SAMPLE_POINTS>,
}

impl<R: Real, A: Algebra<R>, const POINTS: usize> Sample<'_, '_, R, A, POINTS> {
    /// The value of an expression.
    pub fn measure(&self, nodes: &[Node], id: NodeId) -> A::Measure {
        match node_at(nodes, id) {
            Ok(node) => self.node(node, |id| self.measure(nodes, id)),
            Err(_) => A::Measure::unknown(),
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
        let term = match (node_at(nodes, id), chosen(id)) {
            (Ok(Node::Extreme(_, relation)), Some(place)) => self.scene.terms(relation).nth(place),
            (Ok(node), _) => Some(node),
            (Err(_), _) => None,
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
            settled => A::Measure::constant(self.scene.settled(settled)),
        }
    }

    fn extreme(&self, extreme: Extreme, relation: Relation) -> A::Measure {
        let values = self.scene.terms(relation).map(|term| self.leaf(term));
        values
            .reduce(|a, b| a.extreme(extreme, b))
            .unwrap_or_else(|| A::Measure::constant(extreme.of_nothing()))
    }

    fn coordinate(&self, coordinate: Coordinate, point: u8) -> A::Measure {
        let [x, y, z] = self.origin(point);
        match coordinate {
            Coordinate::X => x.measure(),
            Coordinate::Y => y.measure(),
            Coordinate::Z => z.measure(),
            Coordinate::Theta => match self.heading(point) {
                Some([x, y, _]) => A::Measure::constant(y.atan2(x)),
                None => A::Measure::unknown(),
            },
        }
    }

    fn distance(&self, metric: Metric, a: u8, b: u8) -> A::Measure {
        let ([ax, ay, az], [bx, by, bz]) = (self.origin(a), self.origin(b));
        let zero = A::constant(R::ZERO);
        match metric {
            Metric::X => A::norm([ax.minus(bx), zero, zero]),
            Metric::Y => A::norm([ay.minus(by), zero, zero]),
            Metric::Z => A::norm([az.minus(bz), zero, zero]),
            Metric::Straight => A::norm([ax.minus(bx), ay.minus(by), az.minus(bz)]),
        }
    }

    fn angle(&self, a: u8, b: u8) -> A::Measure {
        let headings = (self.heading(a), self.heading(b));
        match headings {
            (Some(a), Some(b)) => A::Measure::constant(R::angle(a, b)),
            _ => A::Measure::unknown(),
        }
    }

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
            None => {
                let frame = self.scene.frame(point);
                frame.map_or([A::unknown(); 3], |f| f.origin().map(A::constant))
            }
        }
    }

    /// The direction of a point's x axis, if it is known.
    fn heading(&self, point: u8) -> Option<[R; 3]> {
        let turn = self.placed(point).map_or(Turn::As(point), |p| p.turn);
        let world = Frame3::identity();
        let [[x, ..], [y, ..], [z, ..]] = self.frame_of(turn, &world)?.rotation();
        Some([x, y, z])
    }

    /// The frame whose rotation a turn names.
    fn frame_of<'f>(&'f self, turn: Turn, world: &'f Frame3<R>) -> Option<&'f Frame3<R>> {
        match turn {
            Turn::World => Some(world),
            Turn::As(point) => self.scene.frame(point),
            Turn::Own(index) => self.frames.get(usize::from(index)),
            Turn::Unknown => None,
        }
    }

    /// Turns and moves a sample point in the frame it is placed in.
    fn place(&mut self, point: &Point<'_>) -> Placed<A> {
        let (origin, base_turn) = match point.base {
            Base::World => ([A::constant(R::ZERO); 3], Turn::World),
            Base::Object(object) => {
                let frame = self.scene.object_frame(object);
                (frame.origin().map(A::constant), self.own(frame))
            }
            Base::Point(p) => {
                let turn = self.placed(p).map_or(Turn::As(p), |placed| placed.turn);
                (self.origin(p), turn)
            }
        };
        let turn = if point.turn == [None; 3] {
            base_turn
        } else {
            self.turned(base_turn, point.turn)
        };
        if point.offset == [None; 3] {
            return Placed { origin, turn };
        }
        let world = Frame3::identity();
        let origin = match self.frame_of(turn, &world) {
            Some(frame) => self.moved(origin, frame, point.offset),
            None => [A::unknown(); 3],
        };
        Placed { origin, turn }
    }

    fn turned(&mut self, base: Turn, turn: [Option<NodeId>; 3]) -> Turn {
        let angles = turn.map(|id| self.scene.offset_term(id, self.theta).known());
        let world = Frame3::identity();
        match (self.frame_of(base, &world), angles) {
            (Some(frame), [Some(yaw), Some(pitch), Some(roll)]) => {
                let inner = Frame3::new([R::ZERO; 3], [yaw, pitch, roll]);
                let frame = frame.compose(&inner);
                self.own(frame)
            }
            _ => Turn::Unknown,
        }
    }

    /// Keeps a frame; there is room for one of each sample point.
    fn own(&mut self, frame: Frame3<R>) -> Turn {
        let index = self.frames.len();
        match (self.frames.push(frame), u8::try_from(index)) {
            (Ok(()), Ok(index)) => Turn::Own(index),
            _ => Turn::Unknown,
        }
    }

    /// `origin + rotation * offset`, leaving out the components that are zero.
    fn moved(&self, mut origin: [A; 3], frame: &Frame3<R>, offset: [Option<NodeId>; 3]) -> [A; 3] {
        for (axis, term) in frame.axes().into_iter().zip(offset) {
            if term.is_none() {
                continue;
            }
            let step = self.scene.offset_term(term, self.theta);
            for (coordinate, entry) in origin.iter_mut().zip(axis) {
                *coordinate = coordinate.plus(A::constant(entry).times(step));
            }
        }
        origin
    }
}

fn parameter<R: Real, A: Algebra<R>>(theta: &[A], index: u8) -> A {
    let value = theta.get(usize::from(index)).copied();
    value.unwrap_or_else(A::unknown)
}

/// The frame turned about its own origin, at no cost where nothing turns.
fn turned<R: Real>(frame: Frame3<R>, declared: [Option<NodeId>; 3], angles: [R; 3]) -> Frame3<R> {
    if declared == [None; 3] {
        return frame;
    }
    frame.compose(&Frame3::new([R::ZERO; 3], angles))
}
