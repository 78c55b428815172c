//! Several bodies under one name, `shape gripper = left + right`: what is said of it is said of
//! each part.

use super::check::{check_draws, check_ranges};
use super::plane::{Rectangle, least};
use critreg::domain::Domain;
use critreg::random::{Generator, below, generator, uniform_in};
use critreg::region::Region;
use critreg_tests::text;
use std::f64::consts::{FRAC_PI_2, PI};

/// A gripper over a tray with two walls, and cans.
const SCENE: &str = "
    object tray { x: length, y: length, theta: angle, width: length }
    object can[3] { x: length, y: length, radius: length }
    object bar { x: length, y: length, theta: angle }
    point near = tray + (0, -0.3)
    point far = tray + (0, 0.3)
    shape tray = rectangle(tray.width, 0.6) centred
    shape can = circle(can.radius)
    shape near = rectangle(tray.width, 0.02) centred
    shape far = rectangle(tray.width, 0.02) centred
    shape walls = near + far
";
const SLIDING: &str = "
    parameter p in [-0.6, 0.6]: length
    point grip = bar + (p, 0)
";
const FREE: &str = "
    parameter px in [-0.6, 0.6]: length
    parameter py in [-0.6, 0.6]: length
    parameter yaw in [-3, 3]: angle
    point place = world + (px, py)
    point grip = place turned yaw
";
const GRIPPER: &str = "
    point left = grip + (0, 0.1)
    point right = grip + (0, -0.1)
    shape left = rectangle(0.06, 0.03) centred
    shape right = rectangle(0.06, 0.03) centred
    shape gripper = left + right
    shape grip = none
";

fn scene(moving: &str) -> String {
    format!("{SCENE}{moving}{GRIPPER}")
}

/// The numbers of an instance, and where its things are.
struct Instance {
    numbers: Vec<f64>,
    cans: Vec<([f64; 2], f64)>,
    bar: Rectangle,
}

fn instance(rng: &mut Generator, is_aligned: bool) -> Instance {
    let turn = |rng: &mut Generator| match is_aligned {
        true => [0.0, FRAC_PI_2][below(rng, 2)],
        false => uniform_in(rng, -PI, PI),
    };
    let place = |rng: &mut Generator| [0, 1].map(|_| uniform_in(rng, -0.3, 0.3));
    let [x, y] = place(rng);
    let mut numbers = vec![x, y, turn(rng), uniform_in(rng, 0.4, 1.0)];
    let cans: Vec<_> = (0..below(rng, 4))
        .map(|_| (place(rng), uniform_in(rng, 0.02, 0.1)))
        .collect();
    for ([x, y], radius) in &cans {
        numbers.extend([x, y, radius]);
    }
    numbers.resize(13, f64::NAN);
    let bar = Rectangle::new(place(rng), turn(rng), [0.0; 2]);
    numbers.extend([bar.centre[0], bar.centre[1], bar.turn]);
    Instance { numbers, cans, bar }
}

#[test]
fn compounds_read_back_as_they_are_written() {
    let text = scene(SLIDING);
    let domain = Domain::parse(&text).unwrap();
    for text in [
        "clear(gripper, walls) >= 0 and inside(gripper, tray) >= 0",
        "clear(bar, gripper) >= 0.01",
        "min(clear(gripper, can)) >= 0 or corner(gripper, tray) >= 0",
        "clear(line(grip, tray), walls) < 0",
    ] {
        let region = Region::parse(&domain, text).expect(text);
        assert_eq!(text::of_region(&domain, &region), text);
    }
    let names = domain.compounds().iter().map(|compound| compound.name);
    assert_eq!(names.collect::<Vec<_>>(), ["walls", "gripper"]);
}

/// A relation of a compound, and those of which it is the least.
const LEAST: [(&str, &[&str]); 8] = [
    (
        "clear(gripper, tray)",
        &["clear(left, tray)", "clear(right, tray)"],
    ),
    (
        "clear(bar, walls)",
        &["clear(bar, near)", "clear(bar, far)"],
    ),
    (
        "clear(gripper, walls)",
        &[
            "clear(left, near)",
            "clear(left, far)",
            "clear(right, near)",
            "clear(right, far)",
        ],
    ),
    (
        "inside(gripper, tray)",
        &["inside(left, tray)", "inside(right, tray)"],
    ),
    (
        "inside_y(gripper, tray)",
        &["inside_y(left, tray)", "inside_y(right, tray)"],
    ),
    (
        "corner(gripper, tray)",
        &["corner(left, tray)", "corner(right, tray)"],
    ),
    (
        "min(clear(gripper, can))",
        &["min(clear(left, can))", "min(clear(right, can))"],
    ),
    (
        "clear(line(grip, bar), walls)",
        &[
            "clear(line(grip, bar), near)",
            "clear(line(grip, bar), far)",
        ],
    ),
];

#[test]
fn intervals_of_compounds_are_those_of_all_parts() {
    let domain_text = scene(SLIDING);
    let domain = Domain::parse(&domain_text).unwrap();
    let mut rng = generator(1);
    for (whole, parts) in LEAST {
        for (sign, word) in [(">= 0.01", " and "), ("< 0", " or ")] {
            let text = format!("{whole} {sign}");
            let of_parts: Vec<_> = parts.iter().map(|part| format!("{part} {sign}")).collect();
            let [whole, of_parts] = [text.clone(), of_parts.join(word)]
                .map(|text| Region::parse(&domain, &text).unwrap());
            for index in 0..60 {
                let instance = instance(&mut rng, index % 2 == 0);
                let [whole, of_parts] = [&whole, &of_parts]
                    .map(|region| region.ground::<f64>(&domain, &instance.numbers).unwrap());
                let [set, expected] = [&whole, &of_parts].map(|region| region.intervals().unwrap());
                assert!(set.is_exact());
                let off = (set.length() - expected.length()).abs();
                assert!(off < 1e-6, "{text}: {set:?}, {expected:?}");
                for step in -30..=30 {
                    let p = f64::from(step) / 50.0;
                    let ends = expected.intervals().iter().flat_map(|i| [i.low, i.high]);
                    if ends.map(|end| (end - p).abs()).all(|off| off > 1e-6) {
                        assert_eq!(set.contains(p), expected.contains(p), "{text} at {p}");
                    }
                }
                check_draws(&whole, &text, &mut rng);
            }
        }
    }
}

/// The greatest over a group is that of the least over the parts.
#[test]
fn the_can_that_is_farthest_from_both_fingers() {
    let domain_text = scene(SLIDING);
    let domain = Domain::parse(&domain_text).unwrap();
    let region = Region::parse(&domain, "max(clear(gripper, can)) >= 0.2").unwrap();
    let mut rng = generator(2);
    let mut admitted = 0;
    for index in 0..100 {
        let instance = instance(&mut rng, index % 2 == 0);
        let grounded = region.ground::<f64>(&domain, &instance.numbers).unwrap();
        for step in -60..=60 {
            let p = f64::from(step) / 100.0;
            let fingers = [0.1, -0.1].map(|side| {
                let centre = instance.bar.world([p, side]);
                Rectangle::new(centre, instance.bar.turn, [0.06, 0.03])
            });
            let of = |(can, radius): &([f64; 2], f64)| {
                least(fingers.iter().map(|finger| finger.distance(*can) - radius))
            };
            let found = instance
                .cans
                .iter()
                .map(of)
                .fold(f64::NEG_INFINITY, f64::max);
            if (found - 0.2).abs() > 1e-6 {
                assert_eq!(
                    grounded.contains(&[p]).unwrap(),
                    found >= 0.2,
                    "{found} at {p}"
                );
                admitted += usize::from(found >= 0.2);
            }
        }
    }
    assert!(admitted > 1000, "{admitted}");
}

#[test]
fn ranges_of_compounds_are_never_too_small() {
    let domain_text = scene(FREE);
    let domain = Domain::parse(&domain_text).unwrap();
    let mut rng = generator(3);
    for (whole, _) in LEAST {
        for index in 0..40 {
            let numbers = instance(&mut rng, index % 2 == 0).numbers;
            check_ranges(&domain, &numbers, whole, |size| 12.0 * size, &mut rng);
        }
    }
}

#[test]
fn absent_parts_are_passed_over() {
    let text = "object a { x: length, y: length, size: length }
        object b { x: length, y: length, size: length }
        shape a = circle(a.size) shape b = circle(b.size) shape both = a + b
        parameter p in [-1, 1]: length point hand = world + (p, 0)";
    let domain = Domain::parse(text).unwrap();
    let intervals = |text: &str, sizes: [f64; 2]| {
        let region = Region::parse(&domain, text).unwrap();
        let numbers = [-0.5, 0.0, sizes[0], 0.5, 0.0, sizes[1]];
        let grounded = region.ground::<f64>(&domain, &numbers).unwrap();
        let set = grounded.intervals().unwrap();
        set.intervals()
            .iter()
            .map(|i| [i.low, i.high])
            .collect::<Vec<_>>()
    };
    let clear = "clear(hand, both) >= 0";
    assert_eq!(
        intervals(clear, [0.25, 0.25]),
        [[-1.0, -0.75], [-0.25, 0.25], [0.75, 1.0]]
    );
    assert_eq!(
        intervals(clear, [0.25, -1.0]),
        [[-1.0, -0.75], [-0.25, 1.0]]
    );
    assert_eq!(intervals(clear, [-1.0, -1.0]), [[0.0; 2]; 0]);
}

#[test]
fn errors_of_compounds_say_what_is_wrong() {
    let domain_text = scene(SLIDING);
    let domain = Domain::parse(&domain_text).unwrap();
    const SINGLE: &str = "this is said of a single body, and here are several";
    for (text, column) in [
        ("inside(grip, gripper) >= 0", 14),
        ("dist(gripper, tray) >= 0", 6),
        ("x_in(gripper, tray) >= 0", 6),
        ("clear(line(gripper, bar), walls) >= 0", 12),
    ] {
        let error = Region::parse(&domain, text).unwrap_err().to_string();
        assert_eq!(
            error,
            format!("line 1, column {column}: {SINGLE}"),
            "{text}"
        );
    }
    let no_part = "this is no kind of shape with its sizes in brackets, and no name of something \
                   with a shape";
    for (statement, column, what) in [
        (
            "shape gripper = left + right",
            7,
            "this name is declared already",
        ),
        (
            "shape bar = left + right",
            7,
            "this name is declared already",
        ),
        (
            "shape clear = left + right",
            7,
            "this is a word of the language",
        ),
        ("shape all = left + bar", 20, no_part),
        ("shape all = rectangle", 13, no_part),
        ("shape all = gripper + near", 13, no_part),
        (
            "shape all = left + can",
            20,
            "a part is a single body, not a group",
        ),
        ("shape left = none", 7, "this name has a shape already"),
        ("shape grip = circle(1)", 7, "this name has a shape already"),
        (
            "shape nothing = none",
            7,
            "no object and no earlier point has this name",
        ),
    ] {
        let text = format!("{domain_text}\n{statement}");
        let line = text.lines().count();
        let error = Domain::parse(&text).unwrap_err().to_string();
        assert_eq!(
            error,
            format!("line {line}, column {column}: {what}"),
            "{statement}"
        );
    }
    let more = |count: usize| {
        let compounds = (0..count).map(|i| format!(" shape c{i} = left + right"));
        format!("{domain_text}{}", compounds.collect::<String>())
    };
    assert_eq!(Domain::parse(&more(2)).unwrap().compounds().len(), 4);
    let error = Domain::parse(&more(3)).unwrap_err().to_string();
    assert_eq!(error, "no room left: compounds of a domain");
    let parts = |count: usize| {
        format!(
            "{domain_text} shape c = left{}",
            " + right".repeat(count - 1)
        )
    };
    assert_eq!(Domain::parse(&parts(6)).unwrap().compounds().len(), 3);
    let error = Domain::parse(&parts(7)).unwrap_err().to_string();
    assert_eq!(error, "no room left: parts of a compound");
}
