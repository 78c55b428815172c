//! A scene at one sample: points that depend on parameters, and values of expressions.

mod bodies;
mod body_pair;
mod curves;
mod places;
mod sight;

use super::algebra::{Algebra, Arithmetic, Measure};
use super::declarations::{Base, Point};
use super::node::{Coordinate, Extreme, Metric, Node, NodeId, Quantity, Share, period};
use super::scene::{MAX_SAMPLE_POINTS, Scene, is_zero, parameter};
use super::turns::Turn;
use crate::geometry::Rotation;
use crate::real::Real;
use bodies::between;
use heapless::Vec;

/// Where a sample point is: its origin may vary with the parameters.
#[derive(Clone, Copy, Debug)]
struct Placed<R, A> {
    origin: [A; 3],
    turn: Turn,
    /// Whether its rotation is in the list of the sample, and not in that of the scene.
    turns_itself: bool,
    /// By how much its rotation may be another one, as an angle.
    slack: R,
}

/// A scene at one sample: the sample points have their places.
#[derive(Clone, Debug)]
pub struct Sample<'s, 'a, R, A> {
    scene: &'s Scene<'a, R>,
    theta: &'s [A],
    placed: Vec<Placed<R, A>, MAX_SAMPLE_POINTS>,
    /// Of the points that are turned.
    rotations: Vec<R, { 9 * MAX_SAMPLE_POINTS }>,
}

impl<'a, R: Real> Scene<'a, R> {
    /// The scene at a sample; `theta` has one entry per parameter.
    pub fn sample<'s, A: Algebra<R>>(&'s self, theta: &'s [A]) -> Sample<'s, 'a, R, A> {
        let mut sample = Sample::blank(self, theta);
        sample.place_points();
        sample
    }
}

impl<'s, 'a, R: Real, A: Algebra<R>> Sample<'s, 'a, R, A> {
    /// As [`Scene::sample`], still without points: [`Sample::place_points`] adds them in
    /// place, so that nothing large is moved.
    pub(crate) fn blank(scene: &'s Scene<'a, R>, theta: &'s [A]) -> Self {
        Sample {
            scene,
            theta,
            placed: Vec::new(),
            rotations: Vec::new(),
        }
    }

    #[inline(never)]
    pub(crate) fn place_points(&mut self) {
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

    /// The first of two expressions minus the second, which is mostly given.
    #[inline(never)]
    pub(crate) fn difference(&self, nodes: &[Node], [left, right]: [NodeId; 2]) -> A::Measure {
        let mut left = self.measure(nodes, left);
        match nodes.get(usize::from(right.0)) {
            Some(term) if term.is_given() => {
                left.lower(self.scene.given(term));
                left
            }
            _ => left.minus(self.measure(nodes, right)),
        }
    }

    /// The value of a node whose operands are known.
    #[inline]
    pub fn node(&self, node: Node, operand: impl Fn(NodeId) -> A::Measure) -> A::Measure {
        match node {
            Node::Sum(a, b) => operand(a).plus(operand(b)),
            Node::Difference(a, b) => operand(a).minus(operand(b)),
            Node::Product(a, b) => operand(a).times(operand(b)),
            Node::Quotient(a, b) => operand(a).over(operand(b)),
            Node::Number(_)
            | Node::Constant(_)
            | Node::Parameter(_)
            | Node::Area(_)
            | Node::Quantity(_)
            | Node::Extreme(..) => self.leaf(node),
        }
    }

    /// The value of a node without operands.
    fn leaf(&self, leaf: Node) -> A::Measure {
        match leaf {
            Node::Parameter(p) => parameter(self.theta, p).measure(),
            Node::Quantity(Quantity::Coordinate(coordinate, p)) => self.coordinate(coordinate, p),
            Node::Quantity(Quantity::Distance(metric, a, b)) => self.distance(metric, a, b),
            Node::Quantity(Quantity::Gap(share, a, b, slot)) => self.gap(share, [a, b], slot),
            Node::Quantity(Quantity::Angle(a, b)) => self.angle(a, b),
            Node::Quantity(Quantity::FoldedAngle(n, a, b)) => self.folded_angle(n, [a, b]),
            Node::Quantity(Quantity::Off(a, b)) => self.off(a, b),
            Node::Quantity(Quantity::VertexAngle(a, vertex, b)) => self.vertex_angle(a, vertex, b),
            Node::Quantity(quantity @ (Quantity::Relation(..) | Quantity::Sight(..))) => {
                self.between_bodies(quantity)
            }
            Node::Extreme(extreme, quantity) => self.extreme(extreme, quantity),
            Node::Number(_)
            | Node::Constant(_)
            | Node::Area(_)
            | Node::Quantity(Quantity::Attribute(_)) => {
                A::Measure::constant(self.scene.given(&leaf))
            }
            Node::Sum(..) | Node::Difference(..) | Node::Product(..) | Node::Quotient(..) => {
                A::Measure::unknown()
            }
        }
    }

    #[inline(never)]
    fn extreme(&self, extreme: Extreme, quantity: Quantity) -> A::Measure {
        let members = self.scene.of_members(quantity);
        members
            .filter_map(|own| self.of_member(own))
            .reduce(|a, b| a.extreme(extreme, b))
            .unwrap_or_else(|| A::Measure::constant(extreme.of_nothing()))
    }

    fn coordinate(&self, coordinate: Coordinate, point: u8) -> A::Measure {
        match coordinate {
            Coordinate::X => self.along(0, point).measure(),
            Coordinate::Y => self.along(1, point).measure(),
            Coordinate::Z => self.along(2, point).measure(),
            Coordinate::Theta => match self.heading(point) {
                Some(([x, y, _], slack)) => {
                    let heading = y.atan2(x);
                    // Beyond pi it would begin anew at -pi.
                    let half_turn = R::from_f64(core::f64::consts::PI);
                    match slack > R::ZERO && heading.abs() + slack > half_turn {
                        true => A::Measure::unknown(),
                        false => A::constant(heading).widened(slack).measure(),
                    }
                }
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

    fn gap(&self, share: Share, [a, b]: [u8; 2], slot: u8) -> A::Measure {
        let mut distance = self.distance(Metric::Straight, a, b);
        let size = self.scene.given(&Node::Quantity(Quantity::Attribute(slot)));
        distance.lower(size * R::from_f64(share.factor()));
        distance
    }

    fn angle(&self, a: u8, b: u8) -> A::Measure {
        let angle = self.angle_of_axes([a, b]);
        angle.map_or_else(A::Measure::unknown, A::measure)
    }

    /// The angle between the x axes of two points.
    fn angle_of_axes(&self, points: [u8; 2]) -> Option<A> {
        let [(a, first), (b, second)] = both(points.map(|point| self.heading(point)))?;
        Some(A::constant(R::angle(a, b)).widened(first + second))
    }

    #[inline(never)]
    fn folded_angle(&self, symmetry: u8, points: [u8; 2]) -> A::Measure {
        let turned = self.scene.turned(points, self.theta);
        let angle = turned.or_else(|| self.angle_of_axes(points));
        let period = R::from_f64(period(symmetry));
        angle.map_or_else(A::Measure::unknown, |angle| angle.folded(period))
    }

    fn off(&self, a: u8, b: u8) -> A::Measure {
        let direction = between(self.origin(b), self.origin(a));
        match self.heading(b) {
            Some((heading, slack)) => A::angle(direction, heading.map(A::constant)).widened(slack),
            None => A::Measure::unknown(),
        }
    }

    #[inline(never)]
    fn vertex_angle(&self, a: u8, vertex: u8, b: u8) -> A::Measure {
        let at = self.origin(vertex);
        let [to_a, to_b] = [a, b].map(|point| between(at, self.origin(point)));
        A::angle(to_a, to_b)
    }

    /// Where a sample point is; `None` for any other point.
    fn placed(&self, point: u8) -> Option<&Placed<R, A>> {
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
    fn base(&self, point: u8) -> Placed<R, A> {
        match self.placed(point) {
            Some(placed) => *placed,
            None => {
                let (origin, turn) = self.scene.placed(point);
                Placed {
                    origin: origin.map(A::constant),
                    turn,
                    turns_itself: false,
                    slack: R::ZERO,
                }
            }
        }
    }

    /// The list of rotations that a turn refers to.
    fn list(&self, own: bool) -> &[R] {
        if own {
            &self.rotations
        } else {
            &self.scene.rotations
        }
    }

    /// The rotation of a point, if it is known.
    fn rotation(&self, placed: &Placed<R, A>) -> Option<Rotation<R>> {
        placed.turn.rotation(self.list(placed.turns_itself))
    }

    /// The direction of a point's x axis, if it is known, and by how much it may be off.
    fn heading(&self, point: u8) -> Option<([R; 3], R)> {
        let placed = self.base(point);
        Some((self.rotation(&placed)?.heading(), placed.slack))
    }

    /// Turns and moves a sample point in the frame it is placed in.
    #[inline(never)]
    fn place(&mut self, point: &Point<'_>) -> Placed<R, A> {
        let mut placed = match point.base {
            Base::World => Placed {
                origin: [A::constant(R::ZERO); 3],
                turn: Turn::World,
                turns_itself: false,
                slack: R::ZERO,
            },
            Base::Object(object) => Placed {
                origin: self.scene.object_origin(object).map(A::constant),
                turn: self.keep(&self.scene.object_rotation(object)),
                turns_itself: true,
                slack: R::ZERO,
            },
            Base::Point(p) => self.base(p),
        };
        if !is_zero(&point.turn) {
            self.turn(&mut placed, point.turn);
        }
        if !is_zero(&point.offset) {
            match self.rotation(&placed) {
                Some(rotation) => {
                    let origin = &mut placed.origin;
                    self.scene
                        .advance(origin, &rotation, &point.offset, self.theta);
                    if placed.slack > R::ZERO {
                        let by = chord(placed.slack) * self.reach(&point.offset);
                        placed.origin = placed.origin.map(|own| own.widened(by));
                    }
                }
                None => placed.origin = [A::unknown(); 3],
            }
        }
        placed
    }

    /// Turns a point further. Where its angles vary, the rotation is the middle one, with
    /// some slack; along a line of parameters it is unknown.
    fn turn(&mut self, placed: &mut Placed<R, A>, turn: [Option<NodeId>; 3]) {
        let angles = turn.map(|id| self.scene.offset_term::<A>(id, self.theta).about());
        placed.turn = match (self.rotation(placed), angles) {
            (Some(base), [Some((yaw, a)), Some((pitch, b)), Some((roll, c))]) => {
                placed.slack += a + b + c;
                self.keep(&base.compose(&Rotation::new([yaw, pitch, roll])))
            }
            _ => Turn::Unknown,
        };
        placed.turns_itself = true;
    }

    /// How far an offset reaches at most.
    fn reach(&self, offset: &[Option<NodeId>; 3]) -> R {
        R::norm(offset.map(|id| {
            let step = self.scene.offset_term::<A>(id, self.theta).about();
            step.map_or(R::INFINITY, |(middle, slack)| middle.abs() + slack)
        }))
    }

    /// Keeps a rotation; there is room for one of each sample point.
    fn keep(&mut self, rotation: &Rotation<R>) -> Turn {
        Turn::keep(rotation, &mut self.rotations).unwrap_or(Turn::Unknown)
    }
}

fn both<T>([a, b]: [Option<T>; 2]) -> Option<[T; 2]> {
    Some([a?, b?])
}

/// How far apart the ends of a unit vector are that is turned by at most an angle.
fn chord<R: Real>(angle: R) -> R {
    let half = angle * R::from_f64(0.5);
    let right = R::from_f64(core::f64::consts::FRAC_PI_2);
    let (sine, _) = half.min(right).sin_cos();
    sine + sine
}
