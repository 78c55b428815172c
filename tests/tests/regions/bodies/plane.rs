//! Geometry in the plane, by a few lines of code: what relations are held against.

pub(super) type Point = [f64; 2];

/// A rectangle in the plane.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rectangle {
    pub(super) centre: Point,
    pub(super) turn: f64,
    pub(super) half: Point,
}

impl Rectangle {
    pub(super) fn new(centre: Point, turn: f64, size: Point) -> Rectangle {
        let half = size.map(|whole| whole / 2.0);
        Rectangle { centre, turn, half }
    }

    /// A point of its own frame, in the world.
    pub(super) fn world(&self, [x, y]: Point) -> Point {
        let (sin, cos) = self.turn.sin_cos();
        let [cx, cy] = self.centre;
        [cx + cos * x - sin * y, cy + sin * x + cos * y]
    }

    /// A point of the world, in its own frame.
    pub(super) fn own(&self, [x, y]: Point) -> Point {
        let (sin, cos) = self.turn.sin_cos();
        let [x, y] = [x - self.centre[0], y - self.centre[1]];
        [cos * x + sin * y, cos * y - sin * x]
    }

    pub(super) fn corners(&self) -> [Point; 4] {
        let [x, y] = self.half;
        [[x, y], [-x, y], [-x, -y], [x, -y]].map(|corner| self.world(corner))
    }

    fn edges(&self) -> [[Point; 2]; 4] {
        let [a, b, c, d] = self.corners();
        [[a, b], [b, c], [c, d], [d, a]]
    }

    /// How far inside of it a point is, along each of its axes.
    pub(super) fn room(&self, point: Point) -> Point {
        let [x, y] = self.own(point);
        [self.half[0] - x.abs(), self.half[1] - y.abs()]
    }

    /// The distance of a point; below zero inside of it.
    pub(super) fn distance(&self, point: Point) -> f64 {
        let [x, y] = self.room(point);
        match x.min(y) {
            depth if depth >= 0.0 => -depth,
            _ => x.min(0.0).hypot(y.min(0.0)),
        }
    }

    /// The distance of another one; -1 if they have a point in common.
    pub(super) fn gap(&self, other: &Rectangle) -> f64 {
        let crossing = |a: [Point; 2]| other.edges().into_iter().any(|b| cross(a, b));
        let corners = [
            self.corners().map(|corner| other.distance(corner)),
            other.corners().map(|corner| self.distance(corner)),
        ];
        match corners.into_iter().flatten().fold(f64::INFINITY, f64::min) {
            least if least < 0.0 || self.edges().into_iter().any(crossing) => -1.0,
            least => least,
        }
    }
}

/// Whether two segments cross.
fn cross([a, b]: [Point; 2], [c, d]: [Point; 2]) -> bool {
    let side = |[from, to]: [Point; 2], p: Point| {
        (to[0] - from[0]) * (p[1] - from[1]) - (to[1] - from[1]) * (p[0] - from[0])
    };
    side([a, b], c) * side([a, b], d) < 0.0 && side([c, d], a) * side([c, d], b) < 0.0
}

/// A thing at the origin of whose frame a corner of it is, as one that is not centred.
pub(super) fn from_corner(corner: Point, turn: f64, size: Point) -> Rectangle {
    let frame = Rectangle::new(corner, turn, size);
    Rectangle {
        centre: frame.world(frame.half),
        ..frame
    }
}

/// The distance of a point from a segment.
pub(super) fn from_segment([a, b]: [Point; 2], p: Point) -> f64 {
    let along = [b[0] - a[0], b[1] - a[1]];
    let part = (p[0] - a[0]) * along[0] + (p[1] - a[1]) * along[1];
    let t = (part / (along[0].powi(2) + along[1].powi(2))).clamp(0.0, 1.0);
    (p[0] - a[0] - t * along[0]).hypot(p[1] - a[1] - t * along[1])
}

pub(super) fn least(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(f64::INFINITY, f64::min)
}
