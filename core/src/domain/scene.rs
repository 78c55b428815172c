//! Putting numbers into expressions, in two steps: an instance makes a [`Scene`],
//! parameters make a [`Sample`] of it. What an instance settles (the poses of
//! objects and key points, and all their sines and cosines) is computed once.

use super::algebra::{Algebra, Arithmetic};
use super::expression::{Coordinate, Metric, Node, NodeId, node_at};
use super::schema::{Base, Domain, MAX_POINTS, Point, Shape};
use crate::error::Error;
use crate::geometry::Frame3;
use crate::real::Real;
use heapless::Vec;

/// Most points of a domain that depend on a parameter.
pub const MAX_SAMPLE_POINTS: usize = 8;

/// A set of points of a domain, with the points they are placed in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PointSet(u32);

const _: () = assert!(MAX_POINTS <= 32, "a PointSet has a bit per point");

impl PointSet {
    /// All points of a domain.
    pub fn all(domain: &Domain<'_>) -> PointSet {
        (0u8..)
            .zip(domain.points())
            .fold(PointSet(0), |set, (i, _)| set.with(domain, i))
    }

    /// The points that a list of nodes speaks about.
    pub fn of(domain: &Domain<'_>, nodes: &[Node]) -> PointSet {
        nodes.iter().fold(PointSet(0), |set, node| match node {
            Node::Coordinate(_, p) => set.with(domain, *p),
            Node::Distance(_, a, b) | Node::Angle(a, b) => set.with(domain, *a).with(domain, *b),
            _ => set,
        })
    }

    fn with(mut self, domain: &Domain<'_>, point: u8) -> PointSet {
        let mut next = Some(point);
        while let Some(point) = next {
            self.0 |= 1u32.checked_shl(u32::from(point)).unwrap_or(0);
            next = match domain.points().get(usize::from(point)).map(|p| p.base) {
                Some(Base::Point(base)) => Some(base),
                _ => None,
            };
        }
        self
    }

    fn has(self, point: u8) -> bool {
        self.0.checked_shr(u32::from(point)).unwrap_or(0) & 1 == 1
    }

    /// How many points of the set stand before `point`.
    fn rank(self, point: u8) -> usize {
        let below = 1u32
            .checked_shl(u32::from(point))
            .map_or(u32::MAX, |bit| bit - 1);
        (self.0 & below).count_ones() as usize
    }
}

/// Where a point is: its origin may vary with the parameters. The frame is
/// `None` where its rotation varies and the algebra cannot follow (anything but numbers).
#[derive(Clone, Copy, Debug)]
struct Placed<R, A> {
    origin: [A; 3],
    /// Only its rotation counts.
    frame: Option<Frame3<R>>,
}

/// A domain in one problem instance: every pose that needs no parameters.
#[derive(Clone, Debug)]
pub struct Scene<'a, R> {
    domain: &'a Domain<'a>,
    instance: &'a [f64],
    fixed: PointSet,
    frames: Vec<Frame3<R>, MAX_POINTS>,
    sampled: PointSet,
}

impl<'a, R: Real> Scene<'a, R> {
    /// The domain in `instance`, ready for expressions over `points`.
    ///
    /// # Errors
    /// Those of [`Domain::check_instance`]; [`Error::CapacityExceeded`].
    pub fn new(
        domain: &'a Domain<'a>,
        instance: &'a [f64],
        points: PointSet,
    ) -> Result<Self, Error> {
        domain.check_instance(instance)?;
        let mut scene = Scene {
            domain,
            instance,
            fixed: PointSet(0),
            frames: Vec::new(),
            sampled: PointSet(0),
        };
        let wanted = (0u8..).zip(domain.points()).filter(|(i, _)| points.has(*i));
        for (index, point) in wanted {
            let bit = 1u32.checked_shl(u32::from(index)).unwrap_or(0);
            if point.sampled {
                scene.sampled.0 |= bit;
                continue;
            }
            let frame = scene.fixed_frame(point);
            scene
                .frames
                .push(frame)
                .map_err(|_| Error::CapacityExceeded("points of a domain"))?;
            scene.fixed.0 |= bit;
        }
        Ok(scene)
    }

    /// The scene at a sample; `theta` has one entry per parameter.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] for more than [`MAX_SAMPLE_POINTS`].
    pub fn sample<'s, A: Algebra<R>>(
        &'s self,
        theta: &'s [A],
    ) -> Result<Sample<'s, 'a, R, A>, Error> {
        let mut sample = Sample {
            scene: self,
            theta,
            placed: Vec::new(),
        };
        let points = (0u8..).zip(self.domain.points());
        for (_, point) in points.filter(|(i, _)| self.sampled.has(*i)) {
            let placed = sample.place(point);
            sample
                .placed
                .push(placed)
                .map_err(|_| Error::CapacityExceeded("points that depend on a parameter"))?;
        }
        Ok(sample)
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
            Base::Point(p) => self.frame(p),
        };
        let [yaw, pitch, roll] = point.turn.map(|id| self.offset_term::<R>(id, &[]));
        let [x, y, z] = point.offset.map(|id| self.offset_term::<R>(id, &[]));
        let turned = turned(base, point.turn, [yaw, pitch, roll]);
        if point.offset == [None; 3] {
            return turned;
        }
        turned.compose(&Frame3::new([x, y, z], [R::ZERO; 3]))
    }

    fn object_frame(&self, object: u8) -> Frame3<R> {
        let pose = self.domain.pose_slots(object);
        let read = |slot: Option<u8>| slot.map_or(R::ZERO, |s| self.slot(s));
        Frame3::new(pose.position.map(read), pose.angles.map(read))
    }

    fn frame(&self, point: u8) -> Frame3<R> {
        let frame = self.frames.get(self.fixed.rank(point));
        frame.copied().unwrap_or_else(Frame3::identity)
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
pub struct Sample<'s, 'a, R, A> {
    scene: &'s Scene<'a, R>,
    theta: &'s [A],
    placed: Vec<Placed<R, A>, MAX_SAMPLE_POINTS>,
}

impl<R: Real, A: Algebra<R>> Sample<'_, '_, R, A> {
    /// The value of an expression.
    pub fn measure(&self, nodes: &[Node], id: NodeId) -> A::Measure {
        match node_at(nodes, id) {
            Ok(node) => self.node(node, |id| self.measure(nodes, id)),
            Err(_) => A::Measure::unknown(),
        }
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
            settled => A::Measure::constant(self.scene.settled(settled)),
        }
    }

    fn coordinate(&self, coordinate: Coordinate, point: u8) -> A::Measure {
        let placed = self.placed(point);
        let [x, y, z] = placed.origin;
        match coordinate {
            Coordinate::X => x.measure(),
            Coordinate::Y => y.measure(),
            Coordinate::Z => z.measure(),
            Coordinate::Theta => match heading(&placed) {
                Some([x, y, _]) => A::Measure::constant(y.atan2(x)),
                None => A::Measure::unknown(),
            },
        }
    }

    fn distance(&self, metric: Metric, a: u8, b: u8) -> A::Measure {
        let ([ax, ay, az], [bx, by, bz]) = (self.placed(a).origin, self.placed(b).origin);
        let zero = A::constant(R::ZERO);
        match metric {
            Metric::X => A::norm([ax.minus(bx), zero, zero]),
            Metric::Y => A::norm([ay.minus(by), zero, zero]),
            Metric::Z => A::norm([az.minus(bz), zero, zero]),
            Metric::Straight => A::norm([ax.minus(bx), ay.minus(by), az.minus(bz)]),
        }
    }

    /// Well conditioned for every angle: the arc tangent of the lengths of the
    /// cross and the dot product of the two x axes.
    fn angle(&self, a: u8, b: u8) -> A::Measure {
        let headings = (heading(&self.placed(a)), heading(&self.placed(b)));
        let (Some([ax, ay, az]), Some([bx, by, bz])) = headings else {
            return A::Measure::unknown();
        };
        let cross = [az * by - ay * bz, ax * bz - az * bx, ay * bx - ax * by];
        let dot = ax * bx + ay * by + az * bz;
        A::Measure::constant(R::norm(cross).atan2(dot))
    }

    fn placed(&self, point: u8) -> Placed<R, A> {
        let scene = self.scene;
        if scene.sampled.has(point) {
            let placed = self.placed.get(scene.sampled.rank(point)).copied();
            return placed.unwrap_or(Placed {
                origin: [A::unknown(); 3],
                frame: None,
            });
        }
        fixed(scene.frame(point))
    }

    /// Turns and moves a sample point in the frame it is placed in.
    fn place(&self, point: &Point<'_>) -> Placed<R, A> {
        let base = match point.base {
            Base::World => fixed(Frame3::identity()),
            Base::Object(object) => fixed(self.scene.object_frame(object)),
            Base::Point(p) => self.placed(p),
        };
        let terms = |ids: [Option<NodeId>; 3]| ids.map(|id| self.scene.offset_term(id, self.theta));
        let angles = terms(point.turn).map(A::known);
        let frame = match (base.frame, angles) {
            (Some(frame), [Some(yaw), Some(pitch), Some(roll)]) => {
                Some(turned(frame, point.turn, [yaw, pitch, roll]))
            }
            _ => None,
        };
        let origin = match frame {
            Some(frame) => moved(base.origin, &frame, terms(point.offset), point.offset),
            None if point.offset == [None; 3] => base.origin,
            None => [A::unknown(); 3],
        };
        Placed { origin, frame }
    }
}

fn parameter<R: Real, A: Algebra<R>>(theta: &[A], index: u8) -> A {
    let value = theta.get(usize::from(index)).copied();
    value.unwrap_or_else(A::unknown)
}

fn fixed<R: Real, A: Algebra<R>>(frame: Frame3<R>) -> Placed<R, A> {
    Placed {
        origin: frame.origin().map(A::constant),
        frame: Some(frame),
    }
}

/// The direction of a point's x axis, if it is known.
fn heading<R: Real, A>(placed: &Placed<R, A>) -> Option<[R; 3]> {
    let [[x, ..], [y, ..], [z, ..]] = placed.frame?.rotation();
    Some([x, y, z])
}

/// The frame turned about its own origin, at no cost where nothing turns.
fn turned<R: Real>(frame: Frame3<R>, declared: [Option<NodeId>; 3], angles: [R; 3]) -> Frame3<R> {
    if declared == [None; 3] {
        return frame;
    }
    frame.compose(&Frame3::new([R::ZERO; 3], angles))
}

/// `origin + rotation * offset`, leaving out the components that are zero.
fn moved<R: Real, A: Algebra<R>>(
    mut origin: [A; 3],
    frame: &Frame3<R>,
    offset: [A; 3],
    declared: [Option<NodeId>; 3],
) -> [A; 3] {
    for (coordinate, row) in origin.iter_mut().zip(frame.rotation()) {
        for ((entry, step), declared) in row.into_iter().zip(offset).zip(declared) {
            if declared.is_some() {
                *coordinate = coordinate.plus(A::constant(entry).times(step));
            }
        }
    }
    origin
}
