//! Shapes: each is where it is said to be, a negative size is none, and what is wrong with
//! one is said.

use super::plane::{Point, Rectangle, from_segment};
use super::table::{SLIDING, Table, domain_text};
use critreg::Error;
use critreg::domain::Domain;
use critreg::random::{below, generator, uniform, uniform_in};
use critreg::region::Region;
use std::f64::consts::PI;

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
