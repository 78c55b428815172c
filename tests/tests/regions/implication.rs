//! Regions that are proven to imply a specification, and those that do not.

use critreg::Error;
use critreg::domain::Domain;
use critreg::env::stick_button::StickButton;
use critreg::random::{generator, uniform_in};
use critreg::region::{Implication, Limit, ProofConfig, Region, Verdict};
use critreg_tests::report::Claim;
use std::f64::consts::PI;

/// Asks, and checks a counterexample.
fn ask(text: &str, region: &str, specification: &str, ranges: &[[f64; 2]]) -> Implication {
    let domain = Domain::parse(text).unwrap();
    let region = Region::parse(&domain, region).unwrap();
    let specification = Region::parse(&domain, specification).unwrap();
    let mut instance = vec![0.0; domain.instance_len()];
    let config = ProofConfig::default();
    let answer = region
        .implies(&specification, &domain, ranges, config, &mut instance)
        .unwrap();
    if let Verdict::Refuted { theta } = answer.verdict {
        let theta = &theta[..domain.parameters().len()];
        assert!(region.contains::<f64>(&domain, &instance, theta).unwrap());
        assert!(
            !specification
                .contains::<f64>(&domain, &instance, theta)
                .unwrap()
        );
        for (number, [low, high]) in instance.iter().zip(ranges) {
            assert!(number.is_nan() || low <= number && number <= high);
        }
    }
    answer
}

fn is_proven(answer: Implication) -> bool {
    answer.verdict == Verdict::Proven
}

fn is_refuted(answer: Implication) -> bool {
    matches!(answer.verdict, Verdict::Refuted { .. })
}

/// Robot, stick, holder, button: anywhere on the table.
fn pick_ranges(theta: [f64; 2]) -> Vec<[f64; 2]> {
    let (x, y) = ([0.0, 10.0], [0.0, 6.0]);
    vec![
        x,
        y,
        theta,
        x,
        y,
        theta,
        [0.0, 1.0],
        x,
        y,
        theta,
        x,
        y,
        [0.0, 1.0],
    ]
}

#[test]
fn a_bound_implies_a_wider_one_whatever_it_is_of() {
    let ranges = pick_ranges([-PI, PI]);
    for (region, specification, holds) in [
        ("grasp.y <= 2.9", "grasp.y <= 3.0", true),
        ("grasp.y <= 2.9", "grasp.y + robot.radius <= zone.top", true),
        ("grasp.y <= 3.0", "grasp.y <= 2.9", false),
        (
            "dist(grasp, holder.centre) >= 0.3",
            "dist(grasp, holder.centre) > 0.29",
            true,
        ),
        (
            "dist_y(grasp, holder.centre) >= 0.3",
            "dist(grasp, holder.centre) >= 0.3",
            true,
        ),
        (
            "dist(grasp, holder.centre) >= 0.3",
            "dist_y(grasp, holder.centre) >= 0.3",
            false,
        ),
        (
            "dist(grasp, holder.centre) <= 0.3",
            "dist_y(grasp, holder.centre) <= 0.3",
            true,
        ),
        (
            "grasp.y <= 2.9 and mu < 0.5 or mu < 0.25",
            "mu <= 0.5",
            true,
        ),
        (
            "grasp.y <= 2.9 or mu < 0.5",
            "mu <= 0.5 and grasp.y <= 2.9",
            false,
        ),
        (
            "not (grasp.y > 2.9 or mu > 0.5)",
            "grasp.y <= 2.9 and mu <= 0.5",
            true,
        ),
    ] {
        let answer = ask(StickButton::PICK_DOMAIN, region, specification, &ranges);
        assert_eq!(is_proven(answer), holds, "{region} => {specification}");
        assert_eq!(is_refuted(answer), !holds, "{region} => {specification}");
    }
}

/// What the library does not decide: where a counterexample has to be within a millimetre.
const OPEN: [(&str, &str); 1] = [("fingers", "wrong")];

#[test]
fn claims_are_proven_and_wrong_ones_refuted() {
    for claim in Claim::all() {
        for section in ["region", "wrong"] {
            let (name, is_wrong) = (claim.name.as_str(), section == "wrong");
            if OPEN.contains(&(name, section)) {
                continue;
            }
            let (verdict, took) = claim.verdict(section);
            let refuted = matches!(verdict, Verdict::Refuted { .. });
            assert_eq!(refuted, is_wrong, "{name} {section}: {verdict:?}, {took:?}");
            assert_eq!(
                verdict == Verdict::Proven,
                !is_wrong,
                "{name} {section}: {verdict:?}"
            );
        }
    }
}

#[test]
fn members_may_be_there_or_not() {
    let text = "object post[3] { x: length, y: length }
                parameter px in [0, 2]: length
                point hand = world + (px, 0)";
    let all = [[0.0, 2.0], [0.0, 1.0]].repeat(3);
    let clear = "min(dist(hand, post)) >= 0.2";
    assert!(is_proven(ask(
        text,
        "min(dist(hand, post)) >= 0.3",
        clear,
        &all
    )));
    // Where no post is there, the nearest one is as far as one likes.
    assert!(is_refuted(ask(
        text,
        "px >= 0.5",
        "min(dist(hand, post)) <= 9",
        &all
    )));
    assert!(is_proven(ask(
        text,
        "min(dist(hand, post)) <= 0.3",
        "min(dist(hand, post)) <= 0.4",
        &all
    )));
    // One that is never there is not in the way.
    let mut one = all.clone();
    one[2..].fill([f64::NAN; 2]);
    one[0] = [1.5, 2.0];
    assert!(is_proven(ask(text, "px <= 1", clear, &one)));
    assert!(is_refuted(ask(text, "px <= 1", clear, &all)));
}

#[test]
fn what_is_asked_wrongly_is_refused() {
    let domain = Domain::parse("object wall { x: length } parameter px in [0, 1]: length").unwrap();
    let region = Region::parse(&domain, "px <= wall.x").unwrap();
    let other = Domain::parse("parameter px in [0, 1]: length").unwrap();
    let foreign = Region::parse(&other, "px <= 1").unwrap();
    let config = ProofConfig::default();
    let ask = |own: &Region, ranges: &[[f64; 2]], config| {
        region.implies(own, &domain, ranges, config, &mut [0.0])
    };
    assert!(matches!(
        ask(&foreign, &[[0.0, 1.0]], config),
        Err(Error::Mismatch(_))
    ));
    assert!(matches!(
        ask(&region, &[], config),
        Err(Error::InvalidArgument(_))
    ));
    assert!(matches!(
        ask(&region, &[[1.0, 0.0]], config),
        Err(Error::InvalidArgument(_))
    ));
    assert!(matches!(
        ask(&region, &[[0.0, f64::NAN]], config),
        Err(Error::NotFinite(_))
    ));
    let exact = ProofConfig {
        tolerance: 0.0,
        ..config
    };
    assert!(matches!(
        ask(&region, &[[0.0, 1.0]], exact),
        Err(Error::InvalidArgument(_))
    ));
    let none = ProofConfig { boxes: 0, ..config };
    let answer = ask(&region, &[[0.0, 1.0]], none).unwrap();
    let limit = Limit::Boxes;
    assert_eq!(answer.verdict, Verdict::Undecided { open: 1.0, limit });
}

/// Everything that a proof can be about, in one domain.
const RICH: &str = "object stick { x: length, y: length, theta: angle, width: length }
    object post[2] { x: length, y: length, radius: length }
    object tray { x: length, y: length, theta: angle }
    parameter mu in [0, 1]
    parameter turn in [-1, 1]: angle
    point grasp = stick turned turn + (mu * stick.width, 0.1)
    point hand = grasp
    shape hand = rectangle(0.2, 0.1) centred
    shape tray = rectangle(1, 0.6)
    shape post = circle(post.radius)";
const FORMS: [&str; 12] = [
    "grasp.y",
    "dist(grasp, tray)",
    "dist_x(grasp, tray)",
    "min(dist(grasp, post))",
    "max(dist_y(grasp, post))",
    "min(clear(hand, post))",
    "inside(hand, tray)",
    "x_in(hand, tray)",
    "corner(hand, tray)",
    "angle(grasp, tray)",
    "off(grasp, tray)",
    "mu * stick.width - 0.3 * grasp.x",
];

/// The same in space.
const SPACE: &str = "object shelf { x: length, y: length, z: length, theta: angle }
    object item { x: length, y: length, z: length, yaw: angle, pitch: angle, roll: angle }
    parameter px in [0, 1]: length
    parameter turn in [-1, 1]: angle
    point hand = world turned (turn, 0.3, 0) + (px, 0.1, 0.2)
    shape hand = circle(0.1)
    shape shelf = box(1, 0.6, 0.4) centred
    shape item = box(0.3, 0.2, 0.1)";
const SPACE_FORMS: [&str; 12] = [
    "clear(hand, shelf)",
    "clear(hand, item)",
    "inside(hand, shelf)",
    "over(hand, shelf)",
    "over(item, shelf)",
    "inside(item, shelf)",
    "inside_z(item, shelf)",
    "corner(item, shelf)",
    "abs_z_in(hand, item)",
    "dist(hand, item)",
    "off(item, hand)",
    "hand.z - item.z",
];

#[test]
fn what_is_proven_has_no_counterexample_among_samples() {
    let plane = [
        [[-1.0, 1.0], [-1.0, 1.0], [-2.0, 2.0], [0.5, 1.0]].as_slice(),
        &[[-1.0, 1.0], [-1.0, 1.0], [0.1, 0.3]].repeat(2),
        &[[-0.5, 0.5], [-0.5, 0.5], [-1.0, 1.0]],
    ];
    let [proven, refuted] = check_samples(RICH, &FORMS, &plane.concat());
    assert!(proven > 30 && refuted > 15, "{proven} {refuted}");
    let space = [[-0.5, 0.5]].repeat(10);
    let [proven, refuted] = check_samples(SPACE, &SPACE_FORMS, &space);
    assert!(proven > 30 && refuted > 15, "{proven} {refuted}");
}

/// How many random claims are proven and refuted; no sample may refute what is proven.
fn check_samples(text: &str, forms: &[&str; 12], ranges: &[[f64; 2]]) -> [usize; 2] {
    let domain = Domain::parse(text).unwrap();
    let groups = domain.groups().len();
    let mut rng = generator(11);
    let mut verdicts = [0; 2];
    for _ in 0..150 {
        let mut constraint = || {
            let form = forms[(uniform_in(&mut rng, 0.0, 12.0) as usize).min(11)];
            let sign = [" <= ", " >= "][usize::from(uniform_in(&mut rng, 0.0, 1.0) < 0.5)];
            format!("{form}{sign}{:.2}", uniform_in(&mut rng, -0.3, 1.2))
        };
        let (one, other, third) = (constraint(), constraint(), constraint());
        let text = format!("({one} or {other}) and {third}");
        let region = Region::parse(&domain, &text).unwrap();
        // The same forms again, so that some of it is implied.
        let loose = third
            .replace("<= ", "<= 0.2 + ")
            .replace(">= ", ">= -0.2 + ");
        let specification = [format!("{loose} and ({one} or {other})"), constraint()];
        let pick = usize::from(uniform_in(&mut rng, 0.0, 1.0) < 0.4);
        let specification = Region::parse(&domain, &specification[pick]).unwrap();
        let mut instance = vec![0.0; ranges.len()];
        let config = ProofConfig {
            boxes: 200,
            ..ProofConfig::default()
        };
        let answer = region.implies(&specification, &domain, ranges, config, &mut instance);
        // Corners of boxes in space are many terms.
        if matches!(answer, Err(Error::CapacityExceeded(_))) {
            continue;
        }
        match answer.unwrap().verdict {
            Verdict::Proven => verdicts[0] += 1,
            Verdict::Refuted { theta } => {
                verdicts[1] += 1;
                let admits = |own: &Region| own.contains::<f64>(&domain, &instance, &theta[..2]);
                assert_eq!(
                    (admits(&region), admits(&specification)),
                    (Ok(true), Ok(false))
                );
                continue;
            }
            Verdict::Undecided { .. } => continue,
        }
        for _ in 0..2000 {
            let mut draw = |[low, high]: [f64; 2]| uniform_in(&mut rng, low, high);
            let mut sample: Vec<f64> = ranges.iter().map(|own| draw(*own)).collect();
            let theta = [draw([0.0, 1.0]), draw([-1.0, 1.0])];
            if groups > 0 && draw([0.0, 1.0]) < 0.3 {
                sample[7..10].fill(f64::NAN);
            }
            let admits = |own: &Region| own.contains::<f64>(&domain, &sample, &theta).unwrap();
            let holds = !admits(&region) || admits(&specification);
            assert!(holds, "{text}: {sample:?} {theta:?}");
        }
    }
    verdicts
}
