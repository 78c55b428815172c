//! A table with things on it, texts in which something moves over it, and the relations
//! between the two.

use super::plane::{Point, Rectangle, from_corner, least};
use critreg::random::{Generator, below, uniform_in};
use std::f64::consts::{FRAC_PI_2, PI};

/// The sizes of what is placed.
pub(super) const PLACED: Point = [0.3, 0.2];

/// What stands on the table, whatever moves over it.
pub(super) const TABLE: &str = "
    object tray { x: length, y: length, theta: angle, width: length, depth: length }
    object mat { x: length, y: length, theta: angle, width: length, depth: length }
    object can[4] { x: length, y: length, radius: length }
    object rail { x: length, y: length, theta: angle }
    shape tray = rectangle(tray.width, tray.depth) centred
    shape mat = rectangle(mat.width, mat.depth)
    shape can = circle(can.radius)
";

/// What moves and turns freely.
pub(super) const FREE: &str = "
    parameter px in [-1, 1]: length
    parameter py in [-1, 1]: length
    parameter yaw in [-3.5, 3.5]: angle
    point hand = world + (px, py)
    point place = hand turned yaw
    shape place = rectangle(0.3, 0.2) centred
";

/// What moves along a line.
pub(super) const SLIDING: &str = "
    parameter p in [-1, 1]: length
    point hand = rail + (p, 0)
    point place = rail turned (0.5 * pi) + (0, -p)
    shape place = rectangle(0.3, 0.2) centred
";

/// What moves along a line and turns.
pub(super) const SLIDING_AND_TURNING: &str = "
    parameter p in [-1, 1]: length
    parameter yaw in [-3.5, 3.5]: angle
    point hand = rail + (p, 0)
    point place = hand turned yaw
    shape place = rectangle(0.3, 0.2) centred
";

pub(super) fn domain_text(moving: &str) -> String {
    format!("{TABLE}{moving}")
}

/// What stands on the table in one instance.
#[derive(Clone, Debug)]
pub(super) struct Table {
    pub(super) tray: Rectangle,
    /// Where its corner is, how it is turned, and its sizes.
    mat: (Point, f64, Point),
    pub(super) cans: Vec<(Point, f64)>,
    pub(super) rail: (Point, f64),
}

impl Table {
    /// Either everything is aligned with the axes, or nothing is.
    pub(super) fn draw(rng: &mut Generator, is_aligned: bool) -> Table {
        let turn = |rng: &mut Generator| match is_aligned {
            true => [0.0, FRAC_PI_2][below(rng, 2)],
            false => uniform_in(rng, -PI, PI),
        };
        let within = |rng: &mut Generator, low, high| [0, 1].map(|_| uniform_in(rng, low, high));
        let count = below(rng, 5);
        Table {
            tray: {
                let centre = within(rng, -0.5, 0.5);
                Rectangle::new(centre, turn(rng), within(rng, 0.4, 1.0))
            },
            mat: (within(rng, -0.5, 0.5), turn(rng), within(rng, 0.4, 1.0)),
            cans: (0..count)
                .map(|_| (within(rng, -0.7, 0.7), uniform_in(rng, 0.02, 0.3)))
                .collect(),
            rail: (within(rng, -0.3, 0.3), turn(rng)),
        }
    }

    pub(super) fn numbers(&self) -> Vec<f64> {
        let tray = &self.tray;
        let (mat, mat_turn, mat_size) = self.mat;
        let (rail, rail_turn) = self.rail;
        let mut numbers = vec![tray.centre[0], tray.centre[1], tray.turn];
        numbers.extend(tray.half.map(|half| 2.0 * half));
        numbers.extend([mat[0], mat[1], mat_turn, mat_size[0], mat_size[1]]);
        for ([x, y], radius) in &self.cans {
            numbers.extend([x, y, radius]);
        }
        numbers.resize(22, f64::NAN);
        numbers.extend([rail[0], rail[1], rail_turn]);
        numbers
    }

    pub(super) fn mat(&self) -> Rectangle {
        let (corner, turn, size) = self.mat;
        from_corner(corner, turn, size)
    }

    /// Where a point on the rail is.
    pub(super) fn on_rail(&self, p: f64) -> Point {
        let ([x, y], turn) = self.rail;
        [x + p * turn.cos(), y + p * turn.sin()]
    }
}

/// A relation as text, and what it is of what is placed and what stands there. Where two
/// things overlap the distance is -1.
pub(super) type Relation = (&'static str, fn(&Rectangle, &Table) -> f64);

pub(super) const RELATIONS: [Relation; 18] = [
    ("clear(place, tray)", |a, table| a.gap(&table.tray)),
    ("clear(place, mat)", |a, table| a.gap(&table.mat())),
    ("clear(hand, mat)", |a, table| {
        table.mat().distance(a.centre)
    }),
    ("inside(place, tray)", |a, table| {
        least(a.corners().into_iter().flat_map(|p| table.tray.room(p)))
    }),
    ("inside(place, mat)", |a, table| {
        least(a.corners().into_iter().flat_map(|p| table.mat().room(p)))
    }),
    ("inside(hand, tray)", |a, table| {
        least(table.tray.room(a.centre))
    }),
    ("inside_x(place, tray)", |a, table| {
        least(a.corners().map(|p| table.tray.room(p)[0]))
    }),
    ("inside_y(place, mat)", |a, table| {
        least(a.corners().map(|p| table.mat().room(p)[1]))
    }),
    ("over(place, tray)", |a, table| {
        least(table.tray.room(a.centre))
    }),
    ("over(place, mat)", |a, table| {
        least(table.mat().room(a.centre))
    }),
    ("corner(place, tray)", |a, table| {
        least(a.corners().map(|p| table.tray.distance(p)))
    }),
    ("x_in(place, tray)", |a, table| table.tray.own(a.centre)[0]),
    ("y_in(place, mat)", |a, table| table.mat().own(a.centre)[1]),
    ("abs_x_in(place, mat)", |a, table| {
        table.mat().own(a.centre)[0].abs()
    }),
    ("abs_y_in(hand, tray)", |a, table| {
        table.tray.own(a.centre)[1].abs()
    }),
    ("min(clear(hand, can))", |a, table| {
        let of = |(can, radius): &(Point, f64)| {
            (a.centre[0] - can[0]).hypot(a.centre[1] - can[1]) - radius
        };
        least(table.cans.iter().map(of))
    }),
    ("min(clear(place, can))", |a, table| {
        let of = |(can, radius): &(Point, f64)| a.distance(*can) - radius;
        least(table.cans.iter().map(of))
    }),
    // A rectangle is inside of a circle if the farthest corner is.
    ("min(inside(place, can))", |a, table| {
        let room = |(can, radius): &(Point, f64)| {
            let far = |p: Point| radius - (p[0] - can[0]).hypot(p[1] - can[1]);
            least(a.corners().map(far))
        };
        least(table.cans.iter().map(room))
    }),
];
