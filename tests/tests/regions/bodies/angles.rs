//! Angles to and between bodies: `off(a, b)`, and `angle(a, b, symmetry)`.

use super::check::{check_draws, check_ranges};
use critreg::domain::Domain;
use critreg::random::{below, generator, uniform_in};
use critreg::region::Region;
use critreg_tests::text;
use std::f64::consts::{FRAC_PI_2, PI};

type Vector = [f64; 3];

/// The difference of two headings, in `[0, pi]`.
fn apart(a: f64, b: f64) -> f64 {
    let turn = (a - b).rem_euclid(2.0 * PI);
    turn.min(2.0 * PI - turn)
}

/// A heading, which is a right angle half of the time.
fn heading(rng: &mut critreg::random::Generator) -> f64 {
    match below(rng, 2) {
        0 => FRAC_PI_2 * (below(rng, 4) as f64 - 1.0),
        _ => uniform_in(rng, -PI, PI),
    }
}

const CAMERAS: &str = "
    object eye { x: length, y: length, theta: angle }
    object mark[3] { x: length, y: length }
    parameter p in [-1, 1]: length
    point hand = world + (p, 0.25)
    point cam = hand turned 0.5
";

#[test]
fn being_off_reads_back_as_it_is_written() {
    let domain = Domain::parse(CAMERAS).unwrap();
    for text in [
        "off(hand, eye) <= 0.5",
        "max(off(mark, cam)) <= 1.5 and min(off(hand, mark)) >= 0",
    ] {
        let region = Region::parse(&domain, text).expect(text);
        assert_eq!(text::of_region(&domain, &region), text);
    }
    let error = Region::parse(&domain, "off(hand, eye) <= eye.x").unwrap_err();
    assert!(error.to_string().contains("dimension"), "{error}");
}

#[test]
fn intervals_of_cones_are_exact() {
    let domain = Domain::parse(CAMERAS).unwrap();
    let mut rng = generator(1);
    type Case = (&'static str, fn(&[f64], f64) -> f64);
    let cases: [Case; 3] = [
        ("off(hand, eye)", |n, p| {
            apart((0.25 - n[1]).atan2(p - n[0]), n[2])
        }),
        ("off(eye, cam)", |n, p| {
            apart((n[1] - 0.25).atan2(n[0] - p), 0.5)
        }),
        ("max(off(mark, cam))", |n, p| {
            let marks = n[3..].chunks(2).filter(|mark| !mark[0].is_nan());
            let angles = marks.map(|mark| apart((mark[1] - 0.25).atan2(mark[0] - p), 0.5));
            angles.fold(f64::NEG_INFINITY, f64::max)
        }),
    ];
    for (relation, value) in cases {
        for bound in [0.3, FRAC_PI_2, 2.5] {
            for sign in ["<=", ">"] {
                let text = format!("{relation} {sign} {bound}");
                let region = Region::parse(&domain, &text).unwrap();
                for _ in 0..30 {
                    let mut place = || [0, 1].map(|_| uniform_in(&mut rng, -1.0, 1.0));
                    let mut numbers = place().to_vec();
                    let marks = [place(), place()];
                    numbers.push(heading(&mut rng));
                    numbers.extend(marks.into_iter().flatten());
                    numbers.extend([f64::NAN; 2]);
                    let grounded = region.ground::<f64>(&domain, &numbers).unwrap();
                    let set = grounded.intervals().unwrap();
                    assert!(set.is_exact(), "{text}");
                    for step in -200..=200 {
                        let p = f64::from(step) / 200.0;
                        let found = value(&numbers, p);
                        if (found - bound).abs() > 1e-6 {
                            let what = format!("{text} at {p}, {found}: {numbers:?}, {set:?}");
                            assert_eq!(
                                set.contains(p),
                                (found <= bound) == (sign == "<="),
                                "{what}"
                            );
                        }
                    }
                    check_draws(&grounded, &text, &mut rng);
                }
            }
        }
    }
}

/// In space the cone is about an axis that is tilted.
#[test]
fn cones_in_space_are_exact() {
    let text = "
        object eye { x: length, y: length, z: length, yaw: angle, pitch: angle, roll: angle }
        parameter p in [-1, 1]: length
        point hand = world + (p, 0.2 * p, 0.3)
    ";
    let domain = Domain::parse(text).unwrap();
    let mut rng = generator(2);
    for bound in [0.3, FRAC_PI_2, 2.0] {
        let region = Region::parse(&domain, &format!("off(hand, eye) <= {bound}")).unwrap();
        let mut admitted = 0;
        for _ in 0..60 {
            let eye: Vector = [0; 3].map(|_| uniform_in(&mut rng, -0.7, 0.7));
            let [yaw, pitch, roll] = [0; 3].map(|_| heading(&mut rng));
            let axis = [
                yaw.cos() * pitch.cos(),
                yaw.sin() * pitch.cos(),
                -pitch.sin(),
            ];
            let numbers = [eye[0], eye[1], eye[2], yaw, pitch, roll];
            let grounded = region.ground::<f64>(&domain, &numbers).unwrap();
            let set = grounded.intervals().unwrap();
            assert!(set.is_exact());
            for step in -100..=100 {
                let p = f64::from(step) / 100.0;
                let d = [p - eye[0], 0.2 * p - eye[1], 0.3 - eye[2]];
                let dot = |a: Vector, b: Vector| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
                let found = (dot(d, axis) / dot(d, d).sqrt()).clamp(-1.0, 1.0).acos();
                if (found - bound).abs() > 1e-6 {
                    assert_eq!(
                        set.contains(p),
                        found <= bound,
                        "{found} at {p}: {numbers:?}"
                    );
                    admitted += usize::from(found <= bound);
                }
            }
        }
        assert!(admitted > 100, "{bound}: {admitted}");
    }
}

/// At no distance there is no direction: the angle is zero.
#[test]
fn at_no_distance_nothing_is_off() {
    let domain = Domain::parse(CAMERAS).unwrap();
    let numbers = [0.5, 0.25, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let contains = |text: &str, p: f64| {
        let region = Region::parse(&domain, text).unwrap();
        region.contains::<f64>(&domain, &numbers, &[p]).unwrap()
    };
    assert!(contains("off(cam, hand) <= 0 and off(eye, eye) <= 0", 0.3));
    // The hand passes through the eye, where the angle jumps.
    for p in [0.25, 0.499, 0.501, 0.75] {
        assert!(!contains("off(hand, eye) <= 0.9", p));
        assert_eq!(contains("off(hand, eye) <= 1.1", p), p > 0.5);
        assert_eq!(
            contains("max(off(mark, cam)) >= 1.1 and off(hand, eye) > 1.5", p),
            p < 0.5
        );
        assert_eq!(contains("max(angle(hand, eye, mark)) <= 1", p), p < 0.5);
    }
}

#[test]
fn ranges_of_angles_are_never_too_small() {
    let text = "
        object eye { x: length, y: length, theta: angle }
        object mark[2] { x: length, y: length }
        parameter px in [-1, 1]: length
        parameter py in [-1, 1]: length
        parameter yaw in [-3.5, 3.5]: angle
        point hand = world + (px, py)
        point cam = hand turned yaw
        point tip = cam + (0.3, 0)
    ";
    let domain = Domain::parse(text).unwrap();
    let mut rng = generator(3);
    for text in [
        "off(hand, eye)",
        "off(eye, cam)",
        "off(tip, eye)",
        "off(tip, hand)",
        "min(off(mark, cam))",
        "max(off(mark, cam))",
    ] {
        for _ in 0..40 {
            let mut numbers = [0; 7].map(|_| uniform_in(&mut rng, -1.0, 1.0));
            numbers[2] = heading(&mut rng);
            check_ranges(&domain, &numbers, text, |size| PI + size, &mut rng);
        }
    }
}

const NUTS: &str = "
    object bar { x: length, y: length, theta: angle }
    object nut[3] { x: length, y: length, theta: angle }
    constant fifth = 1.2566370614359172: angle
    parameter yaw in [-7, 3.5]: angle
    parameter tilt in [-1, 1]: angle
    point hand = world turned (2 * yaw)
    point tool = bar turned (0.25 - yaw)
    point finger = hand + (1, 0)
    point leaning = world turned (yaw, tilt, 0)
";

/// How far an angle is from the nearest multiple of `2 pi / n`.
fn folded(angle: f64, n: u8) -> f64 {
    let step = 2.0 * PI / f64::from(n);
    let rest = angle.rem_euclid(step);
    rest.min(step - rest)
}

#[test]
fn symmetries_read_back_as_they_are_written() {
    let domain = Domain::parse(NUTS).unwrap();
    let written = |text: &str| {
        let region = Region::parse(&domain, text).expect(text);
        text::of_region(&domain, &region)
    };
    for text in [
        "angle(hand, bar, pi) <= 0.5",
        "min(angle(hand, nut, 0.5*pi)) <= 0.5",
        "angle(finger, tool, symmetry 3) >= 0",
        "max(angle(bar, nut, symmetry 12)) >= 0 and angle(hand, bar) <= 1",
    ] {
        assert_eq!(written(text), text);
    }
    for (said, meant) in [
        ("symmetry 2", "pi"),
        ("pi * 0.5", "0.5*pi"),
        ("2 * pi * 0.5 * 0.5", "0.5*pi"),
        ("0.6666666667 * pi", "symmetry 3"),
        ("fifth", "symmetry 5"),
        ("0.25 * pi", "symmetry 8"),
    ] {
        let [said, meant] = [said, meant].map(|third| format!("angle(hand, bar, {third}) <= 1"));
        assert_eq!(written(&said), meant);
    }
    const WRONG: &str = "line 1, column 18: a symmetry is 2*pi/n for a whole n from 2 to 12: \
                         pi, 0.5*pi, or symmetry 3";
    for third in [
        "2 * pi",
        "0.7 * pi",
        "symmetry 1",
        "symmetry 13",
        "symmetry pi",
        "0",
        "yaw",
    ] {
        let error = Region::parse(&domain, &format!("angle(hand, bar, {third}) <= 1"));
        assert_eq!(error.unwrap_err().to_string(), WRONG, "{third}");
    }
    let unknown = Region::parse(&domain, "angle(hand, bar, nothing) <= 1").unwrap_err();
    assert_eq!(unknown.to_string(), "line 1, column 18: unknown point");
}

/// One parameter turns a thing, by more than a full turn if it has few symmetries, and the set
/// is exact.
#[test]
fn intervals_of_folded_angles_are_exact() {
    let flat = NUTS.replace(
        "parameter tilt in [-1, 1]: angle",
        "constant tilt = 0: angle",
    );
    let mut rng = generator(4);
    for n in 2..=12_u8 {
        type Case = (&'static str, fn(&[f64], f64, u8) -> f64);
        let cases: [Case; 3] = [
            ("angle(hand, bar, symmetry N)", |numbers, yaw, n| {
                folded(2.0 * yaw - numbers[2], n)
            }),
            ("angle(tool, finger, symmetry N)", |numbers, yaw, n| {
                folded(numbers[2] + 0.25 - 3.0 * yaw, n)
            }),
            ("min(angle(hand, nut, symmetry N))", |numbers, yaw, n| {
                folded(2.0 * yaw - numbers[5], n).min(folded(2.0 * yaw - numbers[8], n))
            }),
        ];
        let [low, high] = if n <= 3 { [-7, 2] } else { [-1, 1] };
        let text = flat.replace("[-7, 3.5]", &format!("[{low}, {high}]"));
        let domain = Domain::parse(&text).unwrap();
        for (relation, value) in cases {
            let relation = relation.replace('N', &n.to_string());
            for bound in [0.0, 0.9, 0.25].map(|share| share * PI / f64::from(n)) {
                let region = format!("{relation} >= {bound}");
                let region = Region::parse(&domain, &region).unwrap();
                for _ in 0..6 {
                    let mut numbers = [0.0; 12];
                    for theta in [2, 5, 8] {
                        numbers[theta] = heading(&mut rng);
                    }
                    numbers[9..].fill(f64::NAN);
                    let grounded = region.ground::<f64>(&domain, &numbers).unwrap();
                    let set = grounded.intervals().unwrap();
                    assert!(set.is_exact(), "{relation}");
                    for step in 100 * low..=100 * high {
                        let yaw = f64::from(step) / 100.0;
                        let found = value(&numbers, yaw, n);
                        if (found - bound).abs() > 1e-6 {
                            let what = format!("{relation} >= {bound} at {yaw}: {found}, {set:?}");
                            assert_eq!(set.contains(yaw), found >= bound, "{what}");
                        }
                    }
                }
            }
        }
    }
}

/// Where an x axis is tilted, it is the angle between the axes that is folded.
#[test]
fn folded_angles_of_tilted_axes() {
    let domain = Domain::parse(NUTS).unwrap();
    let mut rng = generator(5);
    for n in [2, 3, 4, 12] {
        let text = format!("angle(leaning, bar, symmetry {n}) <= 0.1");
        let region = Region::parse(&domain, &text).unwrap();
        for _ in 0..400 {
            let mut numbers = [0.0; 12];
            numbers[2] = heading(&mut rng);
            let theta = [
                uniform_in(&mut rng, -7.0, 3.5),
                uniform_in(&mut rng, -1.0, 1.0),
            ];
            let cosine = (theta[0] - numbers[2]).cos() * theta[1].cos();
            let found = folded(cosine.acos(), n);
            if (found - 0.1).abs() > 1e-9 {
                let contained = region.contains::<f64>(&domain, &numbers, &theta).unwrap();
                assert_eq!(contained, found <= 0.1, "{n}: {theta:?}, {numbers:?}");
            }
        }
    }
}

#[test]
fn ranges_of_folded_angles_are_never_too_small() {
    let domain = Domain::parse(NUTS).unwrap();
    let mut rng = generator(6);
    for n in 2..=12 {
        for text in [
            format!("angle(hand, bar, symmetry {n})"),
            format!("angle(tool, hand, symmetry {n})"),
            format!("max(angle(finger, nut, symmetry {n}))"),
            format!("angle(leaning, bar, symmetry {n})"),
        ] {
            for _ in 0..60 {
                let mut numbers = [0.0; 12];
                for theta in [2, 5, 8, 11] {
                    numbers[theta] = heading(&mut rng);
                }
                check_ranges(&domain, &numbers, &text, |size| 3.0 * size + 1e-9, &mut rng);
            }
        }
    }
}
