//! Bodies in domain texts, and relations between them in region texts: they read back, they
//! mean what a few lines of geometry say, and draws and proofs of emptiness follow.

use critreg::Error;
use critreg::domain::{Domain, Node, PointSet, Range, Scene};
use critreg::random::{Generator, below, generator, uniform, uniform_in};
use critreg::region::{Grounded, Region};
use critreg::text::Lexer;
use critreg_tests::text;
use std::f64::consts::{FRAC_PI_2, PI};

type Point = [f64; 2];

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

    fn corners(&self) -> [Point; 4] {
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
    fn gap(&self, other: &Rectangle) -> f64 {
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
fn from_corner(corner: Point, turn: f64, size: Point) -> Rectangle {
    let frame = Rectangle::new(corner, turn, size);
    Rectangle {
        centre: frame.world(frame.half),
        ..frame
    }
}

/// The distance of a point from a segment.
fn from_segment([a, b]: [Point; 2], p: Point) -> f64 {
    let along = [b[0] - a[0], b[1] - a[1]];
    let part = (p[0] - a[0]) * along[0] + (p[1] - a[1]) * along[1];
    let t = (part / (along[0].powi(2) + along[1].powi(2))).clamp(0.0, 1.0);
    (p[0] - a[0] - t * along[0]).hypot(p[1] - a[1] - t * along[1])
}

pub(super) fn least(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(f64::INFINITY, f64::min)
}

/// The sizes of what is placed.
const PLACED: Point = [0.3, 0.2];

/// What stands on the table, whatever moves over it.
const TABLE: &str = "
    object tray { x: length, y: length, theta: angle, width: length, depth: length }
    object mat { x: length, y: length, theta: angle, width: length, depth: length }
    object can[4] { x: length, y: length, radius: length }
    object rail { x: length, y: length, theta: angle }
    shape tray = rectangle(tray.width, tray.depth) centred
    shape mat = rectangle(mat.width, mat.depth)
    shape can = circle(can.radius)
";

/// What moves and turns freely.
const FREE: &str = "
    parameter px in [-1, 1]: length
    parameter py in [-1, 1]: length
    parameter yaw in [-3.5, 3.5]: angle
    point hand = world + (px, py)
    point place = hand turned yaw
    shape place = rectangle(0.3, 0.2) centred
";

/// What moves along a line.
const SLIDING: &str = "
    parameter p in [-1, 1]: length
    point hand = rail + (p, 0)
    point place = rail turned (0.5 * pi) + (0, -p)
    shape place = rectangle(0.3, 0.2) centred
";

/// What moves along a line and turns.
const SLIDING_AND_TURNING: &str = "
    parameter p in [-1, 1]: length
    parameter yaw in [-3.5, 3.5]: angle
    point hand = rail + (p, 0)
    point place = hand turned yaw
    shape place = rectangle(0.3, 0.2) centred
";

fn domain_text(moving: &str) -> String {
    format!("{TABLE}{moving}")
}

/// What stands on the table in one instance.
#[derive(Clone, Debug)]
struct Table {
    tray: Rectangle,
    /// Where its corner is, how it is turned, and its sizes.
    mat: (Point, f64, Point),
    cans: Vec<(Point, f64)>,
    rail: (Point, f64),
}

impl Table {
    /// Either everything is aligned with the axes, or nothing is.
    fn draw(rng: &mut Generator, is_aligned: bool) -> Table {
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

    fn numbers(&self) -> Vec<f64> {
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

    fn mat(&self) -> Rectangle {
        let (corner, turn, size) = self.mat;
        from_corner(corner, turn, size)
    }

    /// Where a point on the rail is.
    fn on_rail(&self, p: f64) -> Point {
        let ([x, y], turn) = self.rail;
        [x + p * turn.cos(), y + p * turn.sin()]
    }
}

/// A relation as text, and what it is of what is placed and what stands there. Where two
/// things overlap the distance is -1.
type Relation = (&'static str, fn(&Rectangle, &Table) -> f64);

const RELATIONS: [Relation; 18] = [
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

#[test]
fn relations_read_back_as_they_are_written() {
    let domain_text = domain_text(FREE);
    let domain = Domain::parse(&domain_text).unwrap();
    for (relation, _) in RELATIONS {
        for text in [
            format!("{relation} >= 0"),
            format!("{relation} < 0.125 and yaw <= 1"),
        ] {
            let region = Region::parse(&domain, &text).expect(&text);
            assert_eq!(text::of_region(&domain, &region), text);
        }
    }
}

#[test]
fn membership_is_that_of_plane_geometry() {
    let domain_text = domain_text(FREE);
    let domain = Domain::parse(&domain_text).unwrap();
    let mut rng = generator(1);
    for (relation, value) in RELATIONS {
        let bounds = [0.0, 0.05];
        let regions = bounds.map(|k| Region::parse(&domain, &format!("{relation} >= {k}")));
        let mut admitted = [0; 2];
        for instance in 0..240 {
            let is_aligned = instance % 2 == 0;
            let table = Table::draw(&mut rng, is_aligned);
            let numbers = table.numbers();
            let grounded = regions.each_ref().map(|region| {
                let region = region.as_ref().unwrap();
                region.ground::<f64>(&domain, &numbers).unwrap()
            });
            for sample in 0..20 {
                let yaw = match is_aligned && sample % 2 == 0 {
                    true => f64::from(sample / 2 % 4 - 2) * FRAC_PI_2,
                    false => uniform_in(&mut rng, -3.5, 3.5),
                };
                let centre = [0, 1].map(|_| uniform_in(&mut rng, -1.0, 1.0));
                let found = value(&Rectangle::new(centre, yaw, PLACED), &table);
                for ((grounded, bound), count) in grounded.iter().zip(bounds).zip(&mut admitted) {
                    // There rounding decides.
                    if (found - bound).abs() < 1e-9 {
                        continue;
                    }
                    let contained = grounded.contains(&[centre[0], centre[1], yaw]).unwrap();
                    let what = format!("{relation} >= {bound} at {centre:?}, {yaw}: {table:?}");
                    assert_eq!(contained, found >= bound, "{what} is {found}");
                    *count += usize::from(contained);
                }
            }
        }
        assert!(admitted.iter().all(|count| *count > 50), "{relation}");
    }
}

/// In space: a stack on a table with a yaw, and a ball.
#[test]
fn relations_in_space_know_heights() {
    let text = "
        object crate { x: length, y: length, z: length, theta: angle, width: length }
        shape crate = box(crate.width, 0.4, 0.3) centred
        parameter px in [-1, 1]: length
        parameter py in [-1, 1]: length
        parameter pz in [-1, 1]: length
        point ball = world + (px, py, pz)
        shape ball = circle(0.05)
    ";
    let domain = Domain::parse(text).unwrap();
    let mut rng = generator(2);
    type InSpace = (&'static str, fn(&Rectangle, [f64; 3], f64) -> f64);
    let relations: [InSpace; 8] = [
        ("clear(ball, crate)", |outline, [x, y, _], up| {
            let [a, b] = outline.room([x, y]).map(|room| room.min(0.0));
            match a.hypot(b).hypot((0.15 - up.abs()).min(0.0)) {
                0.0 => -1.0,
                far => far - 0.05,
            }
        }),
        ("inside(ball, crate)", |outline, [x, y, _], up| {
            least(outline.room([x, y])).min(0.15 - up.abs()) - 0.05
        }),
        ("inside_x(ball, crate)", |outline, [x, y, _], _| {
            outline.room([x, y])[0] - 0.05
        }),
        ("inside_z(ball, crate)", |_, _, up| 0.1 - up.abs()),
        ("over(ball, crate)", |outline, [x, y, _], _| {
            least(outline.room([x, y]))
        }),
        ("y_in(ball, crate)", |outline, [x, y, _], _| {
            outline.own([x, y])[1]
        }),
        ("z_in(ball, crate)", |_, _, up| up),
        ("abs_z_in(ball, crate)", |_, _, up| up.abs()),
    ];
    for (relation, value) in relations {
        let text = format!("{relation} >= 0.0625");
        let region = Region::parse(&domain, &text).unwrap();
        assert_eq!(text::of_region(&domain, &region), text);
        for instance in 0..200 {
            let [x, y, z] = [0; 3].map(|_| uniform_in(&mut rng, -0.5, 0.5));
            let turn = if instance % 2 == 0 {
                0.0
            } else {
                uniform_in(&mut rng, -PI, PI)
            };
            let width = uniform_in(&mut rng, 0.3, 1.0);
            let outline = Rectangle::new([x, y], turn, [width, 0.4]);
            let numbers = [x, y, z, turn, width];
            let grounded = region.ground::<f64>(&domain, &numbers).unwrap();
            for _ in 0..20 {
                let ball = [x, y, z].map(|middle| middle + uniform_in(&mut rng, -0.4, 0.4));
                let ball = ball.map(|at| at.clamp(-1.0, 1.0));
                let found = value(&outline, ball, ball[2] - z);
                if (found - 0.0625).abs() > 1e-9 {
                    let contained = grounded.contains(&ball).unwrap();
                    assert_eq!(
                        contained,
                        found >= 0.0625,
                        "{relation} {ball:?} {numbers:?}"
                    );
                }
            }
        }
    }
}

/// Each kind of shape, from its end or its corner on, and centred.
#[test]
fn every_shape_is_where_it_is_said_to_be() {
    type Kind = (&'static str, fn(&Rectangle, Point) -> f64);
    // The frame of the thing, with half its length and half its width.
    let kinds: [Kind; 10] = [
        ("circle(0.2)", |frame, p| {
            (p[0] - frame.centre[0]).hypot(p[1] - frame.centre[1]) - 0.2
        }),
        ("rectangle(thing.long, 0.4) centred", |frame, p| {
            frame.distance(p)
        }),
        ("rectangle(thing.long, 0.4)", |frame, p| {
            let centre = frame.world(frame.half);
            Rectangle { centre, ..*frame }.distance(p)
        }),
        ("box(thing.long, 0.4, 0.1) centred", |frame, p| {
            frame.distance(p)
        }),
        ("rectangle(thing.long, 0.4) rounded 0.1", |frame, p| {
            let centre = frame.world(frame.half);
            Rectangle { centre, ..*frame }.distance(p) - 0.1
        }),
        (
            "rectangle(thing.long, 0.4) rounded 0.1 centred",
            |frame, p| frame.distance(p) - 0.1,
        ),
        ("capsule(thing.long, 0.1)", |frame, p| {
            let end = frame.world([2.0 * frame.half[0], 0.0]);
            from_segment([frame.centre, end], p) - 0.1
        }),
        ("capsule(thing.long, 0.1) centred", |frame, p| {
            let ends = [-1.0, 1.0].map(|side| frame.world([side * frame.half[0], 0.0]));
            from_segment(ends, p) - 0.1
        }),
        ("segment(thing.long)", |frame, p| {
            let end = frame.world([2.0 * frame.half[0], 0.0]);
            from_segment([frame.centre, end], p)
        }),
        (
            "segment(thing.long) rounded (0.25 * thing.long) centred",
            |frame, p| {
                let ends = [-1.0, 1.0].map(|side| frame.world([side * frame.half[0], 0.0]));
                from_segment(ends, p) - 0.5 * frame.half[0]
            },
        ),
    ];
    let mut rng = generator(3);
    for (shape, value) in kinds {
        let text = format!(
            "object thing {{ x: length, y: length, theta: angle, long: length }}
             shape thing = {shape}
             parameter px in [-1, 1]: length parameter py in [-1, 1]: length
             point hand = world + (px, py)"
        );
        let domain = Domain::parse(&text).unwrap();
        let region = Region::parse(&domain, "clear(hand, thing) >= 0.0625").unwrap();
        let mut admitted = 0;
        for _ in 0..200 {
            let centre = [0, 1].map(|_| uniform_in(&mut rng, -0.4, 0.4));
            let (turn, long) = (
                uniform_in(&mut rng, -PI, PI),
                uniform_in(&mut rng, 0.2, 0.8),
            );
            let frame = Rectangle::new(centre, turn, [long, 0.4]);
            let numbers = [centre[0], centre[1], turn, long];
            for _ in 0..20 {
                let hand = [0, 1].map(|_| uniform_in(&mut rng, -1.0, 1.0));
                let found = value(&frame, hand);
                if (found - 0.0625).abs() > 1e-9 {
                    let contained = region.contains::<f64>(&domain, &numbers, &hand).unwrap();
                    assert_eq!(contained, found >= 0.0625, "{shape}: {hand:?}, {numbers:?}");
                    admitted += usize::from(contained);
                }
            }
        }
        assert!((1000..3990).contains(&admitted), "{shape}: {admitted}");
    }
}

/// Draws succeed and are inside, or there is next to nothing to draw.
pub(super) fn check_draws(grounded: &Grounded<'_, f64>, text: &str, rng: &mut Generator) {
    let length = grounded.intervals().unwrap().length();
    for _ in 0..5 {
        match grounded.sample(rng) {
            Ok(theta) => assert!(grounded.contains(&theta[..1]).unwrap(), "{text}"),
            Err(error) => assert!(length < 1e-6, "{text}: {error}, but {length} is admitted"),
        }
    }
}

/// The bounds of an expression over boxes of parameters are beyond its values in them, and no
/// farther apart than it is said for the size of a box.
pub(super) fn check_ranges(
    domain: &Domain,
    numbers: &[f64],
    text: &str,
    widest: fn(f64) -> f64,
    rng: &mut Generator,
) {
    let mut nodes: heapless::Vec<Node, 16> = heapless::Vec::new();
    let id = domain
        .parse_expression(&mut Lexer::new(text), &mut nodes)
        .expect(text);
    let scene = Scene::<f64>::new(domain, numbers, PointSet::of(domain, &nodes)).unwrap();
    for size in [0.01, 0.1, 0.5] {
        let boxed: Vec<_> = domain
            .parameters()
            .iter()
            .map(|parameter| {
                let low = uniform_in(rng, parameter.low, parameter.high - size);
                let high = low + uniform_in(rng, 0.0, size);
                Range { low, high }
            })
            .collect();
        let bounds = scene.sample(&boxed).measure(&nodes, id);
        assert!(bounds.low <= bounds.high, "{text}: {bounds:?}");
        for _ in 0..40 {
            let theta: Vec<_> = boxed
                .iter()
                .map(|range| match below(rng, 4) {
                    0 => range.low,
                    1 => range.high,
                    _ => uniform_in(rng, range.low, range.high),
                })
                .collect();
            let value = scene.sample(&theta).measure(&nodes, id);
            let bounded = bounds.low - 1e-9 <= value && value <= bounds.high + 1e-9;
            assert!(
                bounded,
                "{text}: {value} at {theta:?}, {bounds:?} over {boxed:?}"
            );
        }
        assert!(
            bounds.high - bounds.low <= widest(size) || bounds.low == f64::INFINITY,
            "{text}: {bounds:?} over {boxed:?}"
        );
    }
}

#[test]
fn intervals_of_relations_are_exact() {
    let domain_text = domain_text(SLIDING);
    let domain = Domain::parse(&domain_text).unwrap();
    let mut rng = generator(4);
    for (relation, value) in RELATIONS {
        let texts = [
            format!("{relation} >= 0"),
            format!("{relation} >= 0.05"),
            format!("{relation} < 0.05"),
        ];
        let regions = texts.each_ref().map(|text| Region::parse(&domain, text));
        for instance in 0..40 {
            let table = Table::draw(&mut rng, instance % 2 == 0);
            let numbers = table.numbers();
            for ((region, text), index) in regions.iter().zip(&texts).zip(0..) {
                let region = region.as_ref().unwrap();
                let grounded = region.ground::<f64>(&domain, &numbers).unwrap();
                let set = grounded.intervals().unwrap();
                assert!(set.is_exact(), "{text}");
                let ends = || set.intervals().iter().flat_map(|i| [i.low, i.high]);
                for step in -1000..=1000 {
                    let p = f64::from(step) / 1000.0;
                    if ends().any(|end| (p - end).abs() <= 1e-6) {
                        continue;
                    }
                    let turn = table.rail.1 + FRAC_PI_2;
                    let placed = Rectangle::new(table.on_rail(p), turn, PLACED);
                    let found = value(&placed, &table);
                    let bound = if index == 0 { 0.0 } else { 0.05 };
                    let expected = (found >= bound) != (index == 2);
                    let what = format!("{text} at {p}, {found}: {table:?}, {:?}", set.intervals());
                    assert_eq!(set.contains(p), expected, "{what}");
                    assert_eq!(grounded.contains(&[p]).unwrap(), expected, "{what}");
                }
                check_draws(&grounded, text, &mut rng);
            }
        }
    }
}

/// A table with a tray that holds what is placed with room to spare, or is too small for it.
fn table_with_tray(rng: &mut Generator, scale: [f64; 2], moving: &str) -> (Table, Vec<f64>) {
    let mut table = Table::draw(rng, false);
    // Each size of the tray is a multiple of the longest or the shortest size placed.
    let [long, short] = PLACED;
    let [low, high] = scale;
    let placed = if low > 1.0 { long } else { short };
    table.tray.half = [0, 1].map(|_| uniform_in(rng, low, high) * placed / 2.0);
    if moving != FREE {
        // What slides along the rail must get there.
        let near = uniform_in(rng, -0.5, 0.5);
        table.tray.centre = table.on_rail(near);
    }
    let numbers = table.numbers();
    (table, numbers)
}

/// What is placed by some parameters.
fn placed_at(table: &Table, theta: &[f64]) -> Rectangle {
    match *theta {
        [x, y, yaw] => Rectangle::new([x, y], yaw, PLACED),
        // The hand is turned as the rail is.
        [p, yaw] => Rectangle::new(table.on_rail(p), table.rail.1 + yaw, PLACED),
        _ => panic!("two or three parameters"),
    }
}

fn room_in_tray(table: &Table, theta: &[f64]) -> f64 {
    let corners = placed_at(table, theta).corners().into_iter();
    least(corners.flat_map(|corner| table.tray.room(corner)))
}

const TURNING: [&str; 2] = [SLIDING_AND_TURNING, FREE];

#[test]
fn draws_of_what_turns_are_inside() {
    for moving in TURNING {
        let domain_text = domain_text(moving);
        let domain = Domain::parse(&domain_text).unwrap();
        let region = Region::parse(&domain, "inside(place, tray) >= 0").unwrap();
        let count = domain.parameters().len();
        let mut rng = generator(5);
        for _ in 0..40 {
            let (table, numbers) = table_with_tray(&mut rng, [1.3, 2.5], moving);
            let grounded = region.ground::<f64>(&domain, &numbers).unwrap();
            assert_eq!(grounded.is_proven_empty(), Ok(false));
            for _ in 0..5 {
                let theta = grounded.sample(&mut rng).expect("there is room");
                let room = room_in_tray(&table, &theta[..count]);
                assert!(room >= -1e-9, "{room} at {theta:?}: {table:?}");
            }
        }
    }
}

#[test]
fn what_does_not_fit_is_proven_not_to() {
    for moving in TURNING {
        let domain_text = domain_text(moving);
        let domain = Domain::parse(&domain_text).unwrap();
        let region = Region::parse(&domain, "inside(place, tray) >= 0").unwrap();
        let mut rng = generator(6);
        let mut proven = 0;
        for _ in 0..20 {
            let (_, numbers) = table_with_tray(&mut rng, [0.5, 0.9], moving);
            let grounded = region.ground::<f64>(&domain, &numbers).unwrap();
            let drawn = grounded.sample(&mut rng);
            let empty = drawn == Err(Error::EmptyRegion);
            assert!(empty || drawn == Err(Error::NoSample), "{drawn:?}");
            proven += usize::from(empty || grounded.is_proven_empty() == Ok(true));
        }
        let count = domain.parameters().len();
        assert!(proven >= 18, "{proven} of 20 with {count} parameters");
    }
}

#[test]
fn nothing_that_can_be_met_is_called_empty() {
    const TEXTS: [&str; 4] = [
        "inside(place, tray) >= 0",
        "inside(place, tray) >= 0 and min(clear(place, can)) >= 0.01",
        "inside_x(place, tray) >= 0.02 and corner(place, mat) >= 0",
        "over(place, tray) >= 0.1 and clear(place, mat) >= 0",
    ];
    for moving in TURNING {
        let domain_text = domain_text(moving);
        let domain = Domain::parse(&domain_text).unwrap();
        let count = domain.parameters().len();
        let mut rng = generator(7);
        let mut called_empty = 0;
        for text in TEXTS {
            let region = Region::parse(&domain, text).unwrap();
            for _ in 0..20 {
                // About as large as what is placed.
                let (table, numbers) = table_with_tray(&mut rng, [1.0001, 1.3], moving);
                let mut numbers = numbers;
                numbers[4] = uniform_in(&mut rng, 0.15, 0.3);
                let grounded = region.ground::<f64>(&domain, &numbers).unwrap();
                let drawn = grounded.sample(&mut rng);
                if let Ok(theta) = drawn {
                    assert!(grounded.contains(&theta[..count]).unwrap());
                }
                if drawn != Err(Error::EmptyRegion) && grounded.is_proven_empty() != Ok(true) {
                    continue;
                }
                called_empty += 1;
                for sample in 0..2000 {
                    let mut theta: Vec<f64> = (0..count)
                        .map(|_| uniform_in(&mut rng, -1.0, 1.0))
                        .collect();
                    theta[count - 1] *= 3.5;
                    // Half of them close to where the region is, if it is anywhere.
                    if sample % 2 == 0 {
                        let base = if count == 2 { table.rail.1 } else { 0.0 };
                        let yaw = table.tray.turn - base + 0.02 * theta[count - 1];
                        theta[count - 1] = (yaw + PI).rem_euclid(2.0 * PI) - PI;
                        if let [x, y, _] = &mut theta[..] {
                            *x = table.tray.centre[0] + 0.1 * *x;
                            *y = table.tray.centre[1] + 0.1 * *y;
                        }
                    }
                    let contained = grounded.contains(&theta).unwrap();
                    assert!(!contained, "{text} at {theta:?}: {numbers:?}");
                }
            }
        }
        assert!(
            called_empty >= 10,
            "{called_empty} of 80 with {count} parameters"
        );
    }
}

#[test]
fn a_negative_size_is_no_body() {
    let domain_text = domain_text(SLIDING);
    let domain = Domain::parse(&domain_text).unwrap();
    let mut rng = generator(8);
    for _ in 0..50 {
        let table = Table::draw(&mut rng, false);
        for slot in [3, 4] {
            let mut numbers = table.numbers();
            numbers[slot] = -0.1;
            for text in [
                "inside(place, tray) >= 0",
                "inside(place, tray) < 0",
                "clear(place, tray) >= 0",
                "clear(hand, tray) <= 0",
                "over(hand, tray) >= -10",
            ] {
                let region = Region::parse(&domain, text).unwrap();
                let grounded = region.ground::<f64>(&domain, &numbers).unwrap();
                for step in -10..=10 {
                    let p = f64::from(step) / 10.0;
                    assert_eq!(grounded.contains(&[p]), Ok(false), "{text} at {p}");
                }
                let drawn = grounded.sample(&mut rng);
                let none = matches!(drawn, Err(Error::EmptyRegion | Error::NoSample));
                assert!(none, "{text}: {drawn:?}");
            }
        }
    }
}

#[test]
fn a_member_with_a_negative_size_is_as_one_that_is_absent() {
    let domain_text = domain_text(SLIDING);
    let domain = Domain::parse(&domain_text).unwrap();
    let regions = [
        "min(clear(hand, can)) >= 0",
        "min(clear(place, can)) >= 0.1",
    ]
    .map(|text| Region::parse(&domain, text).unwrap());
    let mut rng = generator(9);
    let mut compared = 0;
    for _ in 0..100 {
        let table = Table::draw(&mut rng, false);
        if table.cans.len() < 2 {
            continue;
        }
        compared += 1;
        let mut without = table.clone();
        let without_it = below(&mut rng, table.cans.len());
        without.cans.remove(without_it);
        let mut numbers = table.numbers();
        numbers[10 + 3 * without_it + 2] = -uniform(&mut rng) - 0.01;
        for region in &regions {
            let [with, without] = [numbers.clone(), without.numbers()].map(|numbers| {
                region
                    .ground::<f64>(&domain, &numbers)
                    .unwrap()
                    .intervals()
                    .cloned()
            });
            assert_eq!(with, without, "{numbers:?}");
            for step in -50..=50 {
                let p = [f64::from(step) / 50.0];
                let inside = region.contains::<f64>(&domain, &numbers, &p).unwrap();
                let set = with.as_ref().unwrap();
                let mut ends = set.intervals().iter().flat_map(|i| [i.low, i.high]);
                let near = ends.any(|end| (p[0] - end).abs() < 1e-6);
                assert!(near || inside == set.contains(p[0]), "{numbers:?} at {p:?}");
            }
        }
    }
    assert!(compared > 30);
}

/// A gripper that opens: its own size is a parameter.
#[test]
fn a_size_may_depend_on_a_parameter() {
    let text = format!(
        "{TABLE}
        parameter px in [-1, 1]: length
        parameter py in [-1, 1]: length
        parameter opening in [0.02, 0.6]: length
        point hand = world + (px, py)
        shape hand = rectangle(opening, 0.02) centred"
    );
    let domain = Domain::parse(&text).unwrap();
    let mut rng = generator(10);
    for (relation, value) in RELATIONS {
        // Others take the hand for a point.
        if !relation.contains("place") {
            continue;
        }
        let relation = relation.replace("place", "hand");
        let region = Region::parse(&domain, &format!("{relation} >= 0.01")).unwrap();
        for instance in 0..100 {
            let table = Table::draw(&mut rng, instance % 2 == 0);
            let numbers = table.numbers();
            let grounded = region.ground::<f64>(&domain, &numbers).unwrap();
            for _ in 0..20 {
                let [x, y] = [0, 1].map(|_| uniform_in(&mut rng, -1.0, 1.0));
                let opening = uniform_in(&mut rng, 0.02, 0.6);
                let hand = Rectangle::new([x, y], 0.0, [opening, 0.02]);
                let found = value(&hand, &table);
                if (found - 0.01).abs() > 1e-9 {
                    let contained = grounded.contains(&[x, y, opening]).unwrap();
                    let what = format!("{relation} at {hand:?}: {table:?}");
                    assert_eq!(contained, found >= 0.01, "{what}");
                }
            }
            if let Ok(theta) = grounded.sample(&mut rng) {
                let [x, y, opening, ..] = theta;
                let hand = Rectangle::new([x, y], 0.0, [opening, 0.02]);
                let found = value(&hand, &table);
                assert!(found >= 0.01 - 1e-9, "{relation} at {hand:?}: {table:?}");
            }
        }
    }
}

fn error_of(text: &str) -> String {
    match Domain::parse(text) {
        Ok(_) => panic!("accepted: {text}"),
        Err(error) => error.to_string(),
    }
}

#[test]
fn errors_of_shapes_say_what_is_wrong() {
    const TRAY: &str = "object tray { x: length, y: length, theta: angle, width: length }";
    let cases = [
        (
            "shape lid = circle(1)",
            "line 2, column 7: no object and no earlier point has this name",
        ),
        (
            "shape tray = circle(1) shape tray = circle(2)",
            "line 2, column 30: this name has a shape already",
        ),
        (
            "shape tray = circle(tray.theta)",
            "line 2, column 21: a size is a length",
        ),
        (
            "shape tray = rectangle(tray.width, 2 * tray.theta) centred",
            "line 2, column 36: a size is a length",
        ),
        (
            "shape tray = rectangle(tray.width, 1) rounded tray.theta",
            "line 2, column 47: a size is a length",
        ),
        (
            "object lid { x: length } shape lid = circle(1)",
            "line 2, column 32: an object with a shape needs the attributes x and y",
        ),
    ];
    for (statement, message) in cases {
        assert_eq!(error_of(&format!("{TRAY}\n{statement}")), message);
    }
}

#[test]
fn there_is_room_for_24_bodies() {
    let groups = |count: usize| {
        (0..count)
            .map(|i| {
                format!(
                    "object can{i}[6] {{ x: length, y: length, radius: length }}
                     shape can{i} = circle(can{i}.radius) "
                )
            })
            .collect::<String>()
    };
    assert_eq!(Domain::parse(&groups(4)).unwrap().bodies().len(), 24);
    let one_more = "object tray { x: length, y: length } point lid = tray + (1, 1) ";
    let text = format!("{}{one_more} shape lid = circle(1)", groups(4));
    assert_eq!(
        error_of(&text),
        "no room left: bodies of a domain, those of every member counted"
    );
}
