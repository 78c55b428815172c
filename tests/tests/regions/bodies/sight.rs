//! Lines of sight and straight motions, `clear(line(a, b), c)` and `clear(sweep(a, b), c)`: what
//! they say is what many points of the line say.

use super::check::{check_draws, check_intervals, check_ranges};
use super::plane::{Rectangle, least};
use critreg::Error;
use critreg::domain::Domain;
use critreg::random::{Generator, below, generator, uniform_in};
use critreg::region::Region;
use critreg_tests::text;
use std::f64::consts::{FRAC_PI_2, PI};

type Space = [f64; 3];

/// What stands on the ground, up to some height, and what moves along a rail or freely.
const WORLD: &str = "
    object wall { x: length, y: length, theta: angle, width: length }
    object post[3] { x: length, y: length, radius: length }
    object sign { x: length, y: length }
    object rail { x: length, y: length, theta: angle }
    shape wall = rectangle(wall.width, 0.2) centred
    shape post = circle(post.radius)
";
const SLIDING: &str = "
    parameter p in [-1, 1]: length
    point hand = rail + (p, 0)
    point tip = rail + (p, 0.4)
    point slow = rail + (0.5 * p, 0)
    shape hand = circle(0.07)
";
const FREE: &str = "
    parameter px in [-1, 1]: length
    parameter py in [-1, 1]: length
    parameter yaw in [-3.5, 3.5]: angle
    point hand = world + (px, py)
    point frame = hand turned yaw
    point tip = frame + (0.4, 0)
    point cart = rail turned yaw
    shape hand = circle(0.07)
    shape cart = rectangle(0.5, 0.2) centred
";

#[derive(Clone, Debug)]
struct World {
    wall: Rectangle,
    posts: Vec<([f64; 2], f64)>,
    sign: [f64; 2],
    rail: ([f64; 2], f64),
}

impl World {
    fn draw(rng: &mut Generator, is_aligned: bool) -> World {
        let turn = |rng: &mut Generator| match is_aligned {
            true => [0.0, FRAC_PI_2][below(rng, 2)],
            false => uniform_in(rng, -PI, PI),
        };
        let place = |rng: &mut Generator| [0, 1].map(|_| uniform_in(rng, -0.6, 0.6));
        let count = below(rng, 4);
        World {
            wall: Rectangle::new(place(rng), turn(rng), [uniform_in(rng, 0.1, 0.8), 0.2]),
            posts: (0..count)
                .map(|_| (place(rng), uniform_in(rng, 0.02, 0.2)))
                .collect(),
            sign: place(rng),
            rail: (place(rng), turn(rng)),
        }
    }

    fn numbers(&self) -> Vec<f64> {
        let wall = &self.wall;
        let mut numbers = vec![
            wall.centre[0],
            wall.centre[1],
            wall.turn,
            2.0 * wall.half[0],
        ];
        for ([x, y], radius) in &self.posts {
            numbers.extend([x, y, radius]);
        }
        numbers.resize(13, f64::NAN);
        let ([x, y], turn) = self.rail;
        numbers.extend(self.sign.into_iter().chain([x, y, turn]));
        numbers
    }

    /// A point in the frame of the rail.
    fn on_rail(&self, point: [f64; 2]) -> [f64; 2] {
        let (centre, turn) = self.rail;
        Rectangle::new(centre, turn, [0.0; 2]).world(point)
    }

    fn past_posts(&self, ends: [[f64; 2]; 2]) -> f64 {
        let of = |(post, radius): &([f64; 2], f64)| {
            nearest(ends, |[x, y]| (x - post[0]).hypot(y - post[1])) - radius
        };
        least(self.posts.iter().map(of))
    }
}

/// The least of a function that is convex along a line.
fn nearest<const N: usize>(ends: [[f64; N]; 2], of: impl Fn([f64; N]) -> f64) -> f64 {
    let [start, end] = ends;
    let along = |share: f64| {
        let mut point = start;
        for (own, end) in point.iter_mut().zip(end) {
            *own += share * (end - *own);
        }
        of(point)
    };
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..90 {
        let third = (high - low) / 3.0;
        match along(low + third) < along(high - third) {
            true => high -= third,
            false => low += third,
        }
    }
    along(low).min(along(0.0)).min(along(1.0))
}

/// A relation as text, and what it is where the hand is at `p`; -1 where the line goes
/// through what it is to be clear of.
type Relation = (&'static str, fn(&World, f64) -> f64);

const RELATIONS: [Relation; 8] = [
    ("clear(line(hand, sign), wall)", |world, p| {
        from_wall(world, [world.on_rail([p, 0.0]), world.sign])
    }),
    ("clear(line(sign, hand), wall)", |world, p| {
        from_wall(world, [world.sign, world.on_rail([p, 0.0])])
    }),
    ("clear(sweep(hand, sign), wall)", |world, p| {
        from_wall(world, [world.on_rail([p, 0.0]), world.sign]) - 0.07
    }),
    ("min(clear(line(hand, sign), post))", |world, p| {
        world.past_posts([world.on_rail([p, 0.0]), world.sign])
    }),
    ("min(clear(sweep(hand, sign), post))", |world, p| {
        world.past_posts([world.on_rail([p, 0.0]), world.sign]) - 0.07
    }),
    // Both ends move alike.
    ("clear(line(hand, tip), wall)", |world, p| {
        from_wall(world, [world.on_rail([p, 0.0]), world.on_rail([p, 0.4])])
    }),
    // The end that moves goes straight to the other one, or away from it.
    ("clear(line(hand, rail), wall)", |world, p| {
        from_wall(world, [world.on_rail([p, 0.0]), world.on_rail([0.0, 0.0])])
    }),
    // The third thing moves, and the line stands.
    ("clear(line(rail, sign), hand)", |world, p| {
        let hand = world.on_rail([p, 0.0]);
        let ends = [world.on_rail([0.0, 0.0]), world.sign];
        nearest(ends, |[x, y]| (x - hand[0]).hypot(y - hand[1])) - 0.07
    }),
];

fn from_wall(world: &World, ends: [[f64; 2]; 2]) -> f64 {
    match nearest(ends, |point| world.wall.distance(point)) {
        through if through < 0.0 => -1.0,
        apart => apart,
    }
}

#[test]
fn lines_read_back_as_they_are_written() {
    let domain_text = format!("{WORLD}{SLIDING}");
    let domain = Domain::parse(&domain_text).unwrap();
    for (relation, _) in RELATIONS {
        let text = format!("{relation} >= 0 and p <= 0.5");
        let region = Region::parse(&domain, &text).expect(&text);
        assert_eq!(text::of_region(&domain, &region), text);
    }
}

#[test]
fn errors_of_lines_say_what_is_wrong() {
    let domain_text = format!("{WORLD}{SLIDING}");
    let domain = Domain::parse(&domain_text).unwrap();
    let cases = [
        (
            "inside(line(hand, sign), wall) >= 0",
            "line 1, column 8: only clear(...) is about line(...) or sweep(...)",
        ),
        (
            "clear(path(hand, sign), wall) >= 0",
            "line 1, column 7: only clear(...) is about line(...) or sweep(...)",
        ),
        (
            "clear(sweep(sign, hand), wall) >= 0",
            "line 1, column 13: only what has the shape of a circle can be swept",
        ),
        (
            "clear(line(hand), wall) >= 0",
            "line 1, column 16: expected `,` and a second point",
        ),
        (
            "clear(line(hand, sign)) >= 0",
            "line 1, column 23: expected `,` and what the line is clear of",
        ),
        (
            "clear(line(hand, sign), post) >= 0",
            "line 1, column 1: only min(...) or max(...) can be about a group",
        ),
    ];
    for (text, message) in cases {
        let error = Region::parse(&domain, text).unwrap_err();
        assert_eq!(error.to_string(), message, "{text}");
    }
    // No point has such a name, so that this can mean one thing only.
    let named = format!("{domain_text} point line = world + (p, 1)");
    assert!(Domain::parse(&named).is_err());
}

#[test]
fn intervals_of_lines_are_exact() {
    let domain_text = format!("{WORLD}{SLIDING}");
    let domain = Domain::parse(&domain_text).unwrap();
    let mut rng = generator(1);
    for (relation, value) in RELATIONS {
        let texts = [">= 0", ">= 0.05", "< 0.05"].map(|bound| format!("{relation} {bound}"));
        let regions = texts.each_ref().map(|text| Region::parse(&domain, text));
        let mut admitted = 0;
        for instance in 0..40 {
            let world = World::draw(&mut rng, instance % 2 == 0);
            let numbers = world.numbers();
            for ((region, text), index) in regions.iter().zip(&texts).zip(0..) {
                let region = region.as_ref().unwrap();
                let grounded = region.ground::<f64>(&domain, &numbers).unwrap();
                let bound = if index == 0 { 0.0 } else { 0.05 };
                let expected = |p: f64| {
                    let found = value(&world, p);
                    // A line that only touches is on neither side.
                    let touches = (found - bound).abs() < 1e-9;
                    (!touches).then_some((found >= bound) != (index == 2))
                };
                let what = || format!("{text}: {world:?}");
                admitted += check_intervals(&grounded, 200, &what, &expected);
                check_draws(&grounded, text, &mut rng);
            }
        }
        assert!(admitted > 1000, "{relation}: {admitted}");
    }
}

/// Where both ends move, each in its own way, there is no closed form: the set is too large,
/// and draws are checked.
#[test]
fn what_moves_in_two_ways_is_drawn_rightly() {
    let domain_text = format!("{WORLD}{SLIDING}");
    let domain = Domain::parse(&domain_text).unwrap();
    let region = Region::parse(&domain, "clear(line(slow, tip), wall) >= 0.01").unwrap();
    let mut rng = generator(2);
    let mut drawn = 0;
    for _ in 0..60 {
        let world = World::draw(&mut rng, false);
        let numbers = world.numbers();
        let grounded = region.ground::<f64>(&domain, &numbers).unwrap();
        for _ in 0..5 {
            let Ok(theta) = grounded.sample(&mut rng) else {
                continue;
            };
            let p = theta[0];
            let ends = [world.on_rail([0.5 * p, 0.0]), world.on_rail([p, 0.4])];
            assert!(from_wall(&world, ends) >= 0.01 - 1e-9, "{p}: {world:?}");
            drawn += 1;
        }
    }
    assert!(drawn > 150, "{drawn}");
}

#[test]
fn ranges_of_lines_are_never_too_small() {
    let domain_text = format!("{WORLD}{FREE}");
    let domain = Domain::parse(&domain_text).unwrap();
    let mut rng = generator(3);
    for text in [
        "clear(line(hand, sign), wall)",
        "clear(line(tip, sign), wall)",
        "clear(line(tip, hand), wall)",
        "clear(sweep(hand, sign), wall)",
        "clear(line(rail, sign), cart)",
        "clear(line(sign, tip), cart)",
        "min(clear(sweep(hand, tip), post))",
    ] {
        for instance in 0..40 {
            let world = World::draw(&mut rng, instance % 2 == 0);
            check_ranges(
                &domain,
                &world.numbers(),
                text,
                |size| 12.0 * size,
                &mut rng,
            );
        }
    }
}

/// What is behind a wall is seen from nowhere before it.
#[test]
fn what_is_hidden_is_proven_to_be() {
    let text = format!(
        "{WORLD} parameter px in [-0.5, 0.5]: length parameter py in [-1, -0.3]: length
         point hand = world + (px, py)"
    );
    let domain = Domain::parse(&text).unwrap();
    let region = Region::parse(&domain, "clear(line(hand, sign), wall) >= 0").unwrap();
    let mut rng = generator(4);
    let mut world = World::draw(&mut rng, false);
    world.wall = Rectangle::new([0.0, 0.0], 0.0, [3.0, 0.2]);
    world.sign = [0.1, 0.5];
    let numbers = world.numbers();
    let grounded = region.ground::<f64>(&domain, &numbers).unwrap();
    assert_eq!(grounded.sample(&mut rng), Err(Error::EmptyRegion));
    assert_eq!(grounded.is_proven_empty(), Ok(true));
    world.wall = Rectangle::new([0.6, 0.0], 0.0, [1.0, 0.2]);
    let numbers = world.numbers();
    let grounded = region.ground::<f64>(&domain, &numbers).unwrap();
    assert_eq!(grounded.is_proven_empty(), Ok(false));
    let theta = grounded.sample(&mut rng).unwrap();
    let ends = [[theta[0], theta[1]], world.sign];
    assert!(from_wall(&world, ends) >= -1e-9);
}

/// In space: past a crate with a yaw, and past balls.
#[test]
fn lines_in_space_pass_above() {
    let text = "
        object crate { x: length, y: length, z: length, theta: angle, width: length }
        object ball[2] { x: length, y: length, z: length, radius: length }
        object sign { x: length, y: length, z: length }
        shape crate = box(crate.width, 0.4, 0.3) centred
        shape ball = circle(ball.radius)
        parameter p in [-1, 1]: length
        point hand = world + (0.1, p, 0.5 * p)
        shape hand = circle(0.05)
    ";
    let domain = Domain::parse(text).unwrap();
    let mut rng = generator(5);
    let hand = |p: f64| [0.1, p, 0.5 * p];
    for (relation, radius) in [("line", 0.0), ("sweep", 0.05)] {
        for bound in [0.0, 0.0625] {
            let of_crate = format!("clear({relation}(hand, sign), crate) >= {bound}");
            let of_balls = format!("min(clear({relation}(hand, sign), ball)) >= {bound}");
            let [of_crate, of_balls] =
                [of_crate, of_balls].map(|text| Region::parse(&domain, &text).unwrap());
            for instance in 0..60 {
                let mut within = |size: f64| [0; 3].map(|_| uniform_in(&mut rng, -size, size));
                let (middle, sign, balls) = (within(0.3), within(1.0), [within(0.5), within(0.5)]);
                let turn = if instance % 2 == 0 { 0.0 } else { sign[0] * PI };
                let outline = Rectangle::new([middle[0], middle[1]], turn, [0.5, 0.4]);
                let mut numbers = vec![middle[0], middle[1], middle[2], turn, 0.5];
                for [x, y, z] in balls {
                    numbers.extend([x, y, z, 0.15]);
                }
                numbers.extend(sign);
                let from_crate = |[x, y, z]: Space| {
                    let [a, b] = outline.room([x, y]);
                    let c = 0.15 - (z - middle[2]).abs();
                    match a.min(b).min(c) {
                        depth if depth >= 0.0 => -depth,
                        _ => a.min(0.0).hypot(b.min(0.0)).hypot(c.min(0.0)),
                    }
                };
                let from_ball = |ball: Space, [x, y, z]: Space| {
                    (x - ball[0]).hypot(y - ball[1]).hypot(z - ball[2]) - 0.15
                };
                let to_crate = of_crate.ground::<f64>(&domain, &numbers).unwrap();
                let to_balls = of_balls.ground::<f64>(&domain, &numbers).unwrap();
                assert!(to_crate.intervals().unwrap().is_exact());
                assert!(to_balls.intervals().unwrap().is_exact());
                for step in -100..=100 {
                    let p = f64::from(step) / 100.0;
                    let ends = [hand(p), sign];
                    let past_crate = nearest(ends, from_crate);
                    let past_balls =
                        least(balls.map(|ball| nearest(ends, |point| from_ball(ball, point))));
                    for (found, grounded) in [(past_crate, &to_crate), (past_balls, &to_balls)] {
                        let found = found - radius;
                        // A line through a crate is deeper in it than its points are.
                        if (found - bound).abs() > 1e-6 {
                            let contained = grounded.contains(&[p]).unwrap();
                            assert_eq!(contained, found >= bound, "{found} at {p}: {numbers:?}");
                        }
                    }
                }
            }
        }
    }
}

/// A line of no length is a point; a body that is absent blocks nothing of a group.
#[test]
fn degenerate_lines() {
    let domain_text = format!("{WORLD}{SLIDING}");
    let domain = Domain::parse(&domain_text).unwrap();
    let mut rng = generator(6);
    for _ in 0..50 {
        let world = World::draw(&mut rng, false);
        let mut numbers = world.numbers();
        let intervals = |text: &str, numbers: &[f64]| {
            let region = Region::parse(&domain, text).unwrap();
            let grounded = region.ground::<f64>(&domain, numbers).unwrap();
            grounded.intervals().unwrap().clone()
        };
        let same = |a: &str, b: &str, numbers: &[f64]| {
            let [a, b] = [a, b].map(|text| intervals(text, numbers));
            assert!((a.length() - b.length()).abs() < 1e-9, "{a:?} {b:?}");
        };
        same(
            "clear(line(hand, hand), wall) >= 0.01",
            "clear(tip, tip) >= 0 and 0.01 <= clear(line(hand, hand), wall)",
            &numbers,
        );
        same(
            "min(clear(sweep(hand, hand), post)) >= 0.01",
            "min(clear(hand, post)) >= 0.01",
            &numbers,
        );
        numbers[3] = -1.0;
        assert_eq!(
            intervals("clear(line(hand, sign), wall) >= -9", &numbers).length(),
            0.0
        );
        for post in 0..world.posts.len() {
            numbers[4 + 3 * post + 2] = -1.0;
        }
        let all = intervals("min(clear(line(hand, sign), post)) >= 9", &numbers);
        assert_eq!(all.length(), 2.0);
    }
}
