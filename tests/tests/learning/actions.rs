//! The actions of `ACTIONS.md` are learned from the texts that stand there, and the regions
//! that stand there are right. What is true of each is said here once more, in plain geometry.

use critreg::Error;
use critreg::domain::Domain;
use critreg::learn::version_space::{Capacity, Config};
use critreg::learn::{Outcome, Problem, learn_region};
use critreg::random::{Generator, below, generator, uniform_in};
use critreg::region::Region;
use critreg_tests::actions::section;
use critreg_tests::room::VersionSpaceRoom;
use critreg_tests::text;
use std::f64::consts::PI;

/// What the library has room for by default.
const FORMS: usize = 4096;
/// The page prints what is learned with this one.
const SEED: u64 = 4;
const INSTANCES: usize = 16;
const FRESH: usize = 40;
const SAMPLES: usize = 200;

/// A random scene of an action: an instance of its text.
type Draw = fn(&mut Generator) -> Vec<f64>;

/// Whether the action works in a scene, with a sample of its parameters.
type Works = fn(&[f64], &[f64]) -> bool;

/// The region that is learned from the text of the page with so many answers, and the one that
/// stands there, agree with the truth in fresh scenes.
fn check(heading: &str, calls: u32, draw: Draw, works: Works) {
    let [text, printed] = section(heading);
    let domain = Domain::parse(text).unwrap();
    let printed = Region::parse(&domain, printed).unwrap();
    let mut rng = generator(SEED);
    let instances: Vec<f64> = (0..INSTANCES).flat_map(|_| draw(&mut rng)).collect();
    let problem = Problem::new(&domain, &instances, INSTANCES).unwrap();
    let mut room = VersionSpaceRoom::<f64>::new(Capacity {
        forms: FORMS,
        tracked: usize::MAX,
        sums: usize::MAX,
        questions: 16,
        observations: calls as usize,
        instances: INSTANCES,
        steps: 1,
    });
    let config = Config {
        seed: SEED,
        calls,
        ..Config::default()
    };
    let mut learner = room.learner(&domain, config).unwrap();
    let count = domain.parameters().len();
    let learned = learn_region(&mut learner, &problem, |_, query| {
        let instance = problem.instance(query.instance)?;
        let is_feasible = works(instance, &query.theta[..count]);
        Ok::<_, Error>(Outcome::from_feasible(is_feasible))
    });
    let learned = learned.unwrap();
    for (whose, region) in [("learned", learned), ("printed", &printed)] {
        let [precision, recall] = judge(&domain, region, draw, works);
        let words = text::of_region(&domain, region);
        assert!(
            precision >= 0.995 && recall >= 0.98,
            "{whose}: {words}: precision {precision}, recall {recall}"
        );
    }
}

/// Precision and recall in scenes that nothing was learned from.
fn judge(domain: &Domain<'_>, region: &Region, draw: Draw, works: Works) -> [f64; 2] {
    let mut rng = generator(1000 + SEED);
    let [mut both, mut admitted, mut working] = [0u32; 3];
    for _ in 0..FRESH {
        let instance = draw(&mut rng);
        let grounded = region.ground::<f64>(domain, &instance).unwrap();
        for _ in 0..SAMPLES {
            let within = |p: &critreg::domain::Parameter<'_>| uniform_in(&mut rng, p.low, p.high);
            let theta: Vec<f64> = domain.parameters().iter().map(within).collect();
            let inside = grounded.contains(&theta).unwrap();
            let feasible = works(&instance, &theta);
            both += u32::from(inside && feasible);
            admitted += u32::from(inside);
            working += u32::from(feasible);
        }
    }
    assert!(
        working >= 200,
        "only {working} samples work: too few to judge by"
    );
    let share = |of: u32| f64::from(both) / f64::from(of.max(1));
    [share(admitted), share(working)]
}

type Point = [f64; 2];

/// A place with a heading: x, y, theta.
type Frame = [f64; 3];

fn distance([ax, ay]: Point, [bx, by]: Point) -> f64 {
    (ax - bx).hypot(ay - by)
}

/// The place that has these coordinates in a frame.
fn at([x, y, theta]: Frame, [along, across]: Point) -> Point {
    let (sin, cos) = theta.sin_cos();
    [
        x + cos * along - sin * across,
        y + sin * along + cos * across,
    ]
}

/// The coordinates in a frame of a place.
fn seen_from([x, y, theta]: Frame, [px, py]: Point) -> Point {
    at([0.0, 0.0, -theta], [px - x, py - y])
}

/// How far a place is from a rectangle that is centred in a frame; zero within it.
fn from_rectangle(frame: Frame, [width, depth]: Point, place: Point) -> f64 {
    let [along, across] = seen_from(frame, place);
    let beyond = |off: f64, size: f64| f64::max(off.abs() - 0.5 * size, 0.0);
    beyond(along, width).hypot(beyond(across, depth))
}

/// Whether a rectangle is in another one that is smaller by some play on all sides.
fn is_in(inner: (Frame, Point), outer: (Frame, Point), play: f64) -> bool {
    let (frame, [width, depth]) = inner;
    let signs = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
    signs.into_iter().all(|(along, across)| {
        let corner = at(frame, [0.5 * along * width, 0.5 * across * depth]);
        let [u, v] = seen_from(outer.0, corner);
        2.0 * (u.abs() + play) <= outer.1[0] && 2.0 * (v.abs() + play) <= outer.1[1]
    })
}

/// A frame within a square around the origin.
fn frame(rng: &mut Generator, within: f64) -> Frame {
    let [x, y] = [0; 2].map(|_| uniform_in(rng, -within, within));
    [x, y, uniform_in(rng, -PI, PI)]
}

/// Several numbers between two others.
fn several<const N: usize>(rng: &mut Generator, low: f64, high: f64) -> [f64; N] {
    [0; N].map(|_| uniform_in(rng, low, high))
}

/// The numbers of a group: of some members, and then of absent ones.
fn group<const N: usize>(
    rng: &mut Generator,
    capacity: usize,
    member: impl Fn(&mut Generator) -> [f64; N],
) -> Vec<f64> {
    let count = below(rng, capacity + 1);
    let mut numbers: Vec<f64> = (0..count).flat_map(|_| member(rng)).collect();
    numbers.resize(capacity * N, f64::NAN);
    numbers
}

/// The members of a group that are there.
fn members<const N: usize>(numbers: &[f64]) -> impl Iterator<Item = [f64; N]> {
    let (members, rest) = numbers.as_chunks();
    assert!(rest.is_empty(), "all members have {N} numbers");
    members.iter().copied().filter(|member| !member[0].is_nan())
}

/// The first numbers of an instance, and the others.
fn split<const N: usize>(instance: &[f64]) -> ([f64; N], &[f64]) {
    let (first, others) = instance.split_first_chunk().expect("as the text says");
    (*first, others)
}

/// All numbers of an instance or of a sample.
fn all<const N: usize>(numbers: &[f64]) -> [f64; N] {
    numbers.try_into().expect("as the text says")
}

#[test]
fn grasp() {
    const FINGER: Point = [0.02, 0.015];
    let draw = |rng: &mut Generator| {
        let bar = frame(rng, 0.2);
        let [length, width] = [uniform_in(rng, 0.15, 0.4), uniform_in(rng, 0.02, 0.05)];
        // Cans beside the bar, where fingers come.
        let cans = group(rng, 3, |rng| {
            let radius = uniform_in(rng, 0.01, 0.04);
            let side = [-1.0, 1.0][below(rng, 2)];
            let across = side * (0.5 * width + radius + uniform_in(rng, 0.005, 0.03));
            let [x, y] = at(bar, [uniform_in(rng, -0.2, 0.2), across]);
            [x, y, radius]
        });
        [bar.to_vec(), vec![length, width], cans].concat()
    };
    let works = |instance: &[f64], theta: &[f64]| {
        let ([x, y, heading, length, _], cans) = split(instance);
        let [s] = all(theta);
        let is_clear = |across| {
            let [fx, fy] = at([x, y, heading], [s, across]);
            members(cans).all(|[cx, cy, radius]| {
                from_rectangle([fx, fy, heading], FINGER, [cx, cy]) >= radius
            })
        };
        s.abs() + 0.5 * FINGER[0] <= 0.5 * length && is_clear(0.04) && is_clear(-0.04)
    };
    check("Grasp", 120, draw, works);
}

#[test]
fn place() {
    let draw = |rng: &mut Generator| {
        let board = frame(rng, 0.1);
        let [width, depth] = several(rng, 0.3, 0.6);
        let item: [f64; 2] = several(rng, 0.05, 0.15);
        let cups = group(rng, 3, |rng| {
            let [u, v] = several(rng, -0.5, 0.5);
            let [x, y] = at(board, [u * width, v * depth]);
            [x, y, uniform_in(rng, 0.03, 0.06)]
        });
        [board.to_vec(), vec![width, depth], item.to_vec(), cups].concat()
    };
    let works = |instance: &[f64], theta: &[f64]| {
        let ([x, y, heading, width, depth, item @ ..], cups) = split::<7>(instance);
        let place = all(theta);
        is_in((place, item), ([x, y, heading], [width, depth]), 0.0)
            && members(cups).all(|[x, y, radius]| from_rectangle(place, item, [x, y]) >= radius)
    };
    check("Place", 120, draw, works);
}

#[test]
fn stack() {
    let draw = |rng: &mut Generator| {
        let lower = frame(rng, 0.5);
        let [lower_size, upper_size]: [[f64; 2]; 2] =
            [several(rng, 0.1, 0.3), several(rng, 0.05, 0.2)];
        [lower.to_vec(), lower_size.to_vec(), upper_size.to_vec()].concat()
    };
    let works = |instance: &[f64], theta: &[f64]| {
        let [_, _, _, width, depth, _, _] = all(instance);
        let [dx, dy] = all(theta);
        2.0 * dx.abs() <= width && 2.0 * dy.abs() <= depth
    };
    check("Stack", 60, draw, works);
}

#[test]
fn insert() {
    let draw = |rng: &mut Generator| {
        let slot = frame(rng, 0.5);
        let peg = [uniform_in(rng, 0.02, 0.06), uniform_in(rng, 0.01, 0.03)];
        let room = [uniform_in(rng, 0.01, 0.03), uniform_in(rng, 0.01, 0.02)];
        let slot_size = [peg[0] + room[0], peg[1] + room[1]];
        [slot.to_vec(), slot_size.to_vec(), peg.to_vec()].concat()
    };
    let works = |instance: &[f64], theta: &[f64]| {
        let [_, _, _, width, depth, peg @ ..] = all::<7>(instance);
        // In the frame of the slot.
        is_in((all(theta), peg), ([0.0; 3], [width, depth]), 0.001)
    };
    check("Insert", 100, draw, works);
}

#[test]
fn push() {
    const RADIUS: f64 = 0.05;
    let draw = |rng: &mut Generator| {
        let place = frame(rng, 0.2);
        let size: [f64; 2] = several(rng, 0.1, 0.4);
        [place.to_vec(), size.to_vec()].concat()
    };
    let works = |instance: &[f64], theta: &[f64]| {
        let [x, y, heading, size @ ..] = all::<5>(instance);
        let from_box = |place| from_rectangle([x, y, heading], size, place);
        let start = all(theta);
        from_box(at(start, [0.0, 0.0])) >= RADIUS && from_box(at(start, [0.2, 0.0])) <= RADIUS
    };
    check("Push", 100, draw, works);
}

#[test]
fn pour() {
    let draw = |rng: &mut Generator| {
        let cup = [uniform_in(rng, -0.3, 0.3), uniform_in(rng, 0.0, 0.15)];
        let width = uniform_in(rng, 0.1, 0.4);
        let [length, spills] = [uniform_in(rng, 0.1, 0.2), uniform_in(rng, 0.3, 1.2)];
        vec![cup[0], cup[1], width, length, spills]
    };
    let works = |instance: &[f64], theta: &[f64]| {
        let [cup_x, rim, width, length, spills] = all(instance);
        let [px, pz, tilt] = all(theta);
        let [x, z] = at([px, pz, -tilt], [length, 0.0]);
        2.0 * (x - cup_x).abs() <= width && z >= rim && (spills..=2.2).contains(&tilt)
    };
    check("Pour", 200, draw, works);
}

#[test]
fn look() {
    let draw = |rng: &mut Generator| {
        let sign = frame(rng, 0.5);
        [sign.to_vec(), vec![uniform_in(rng, 0.5, 1.3)]].concat()
    };
    let works = |instance: &[f64], theta: &[f64]| {
        let [_, _, _, readable] = all(instance);
        let [away, around] = all(theta);
        (0.3..=readable).contains(&away) && around.abs() <= 1.0
    };
    check("Look", 200, draw, works);
}

#[test]
fn reach() {
    let draw = |rng: &mut Generator| {
        let cup: [f64; 2] = several(rng, -0.3, 0.3);
        let crates = group(rng, 4, |rng| {
            let [x, y, theta] = frame(rng, 0.8);
            let [width, depth] = several(rng, 0.1, 0.5);
            [x, y, theta, width, depth]
        });
        [cup.to_vec(), crates].concat()
    };
    let works = |instance: &[f64], theta: &[f64]| {
        let (cup, crates) = split(instance);
        let base = all(theta);
        let is_clear = |[x, y, theta, width, depth]: [f64; 5]| {
            from_rectangle([x, y, theta], [width, depth], base) >= 0.2
        };
        (0.35..=0.9).contains(&distance(base, cup)) && members(crates).all(is_clear)
    };
    check("Reach", 150, draw, works);
}

#[test]
fn open_a_drawer() {
    let draw = |rng: &mut Generator| {
        let handle = frame(rng, 1.0);
        let [length, thick] = [uniform_in(rng, 0.2, 0.5), uniform_in(rng, 0.02, 0.07)];
        let depth = uniform_in(rng, 0.3, 0.6);
        [handle.to_vec(), vec![length, thick, depth]].concat()
    };
    let works = |instance: &[f64], theta: &[f64]| {
        let [_, _, _, length, thick, depth] = all(instance);
        let [along, pull] = all(theta);
        2.0 * along.abs() + 0.09 <= length && thick <= 0.05 && pull <= depth - 0.12
    };
    check("Open a drawer", 200, draw, works);
}

#[test]
fn hand_over() {
    let draw = |rng: &mut Generator| {
        let [x, y, bearing] = frame(rng, 0.3);
        let [taker_x, taker_y] = at([x, y, bearing], [uniform_in(rng, 0.6, 1.3), 0.0]);
        let [reach, taker_reach] = several(rng, 0.6, 1.0);
        let length = uniform_in(rng, 0.2, 0.6);
        vec![x, y, reach, taker_x, taker_y, taker_reach, length]
    };
    let works = |instance: &[f64], theta: &[f64]| {
        let [x, y, reach, taker_x, taker_y, taker_reach, length] = all(instance);
        let end = |share: f64| at(all(theta), [share * length, 0.0]);
        distance(end(-0.5), [x, y]) <= reach
            && distance(end(0.5), [taker_x, taker_y]) <= taker_reach
    };
    check("Hand over", 100, draw, works);
}
