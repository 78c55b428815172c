//! Regions that are proven to imply a specification, and those that do not.

use critreg::domain::Domain;
use critreg::env::stick_button::StickButton;
use critreg::region::{Implication, ProofConfig, Region, Verdict};
use std::f64::consts::{FRAC_PI_2, PI};

/// Asks, and checks a counterexample.
fn ask(text: &str, region: &str, specification: &str, ranges: &[[f64; 2]]) -> Implication {
    let domain = Domain::parse(text).unwrap();
    let region = Region::parse(&domain, region).unwrap();
    let specification = Region::parse(&domain, specification).unwrap();
    let mut instance = vec![0.0; domain.instance_len()];
    let config = ProofConfig::default();
    let start = std::time::Instant::now();
    let answer = region
        .implies(&specification, &domain, ranges, config, &mut instance)
        .unwrap();
    println!("{answer:?} {:?} {instance:?}", start.elapsed());
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

#[test]
fn upright() {
    let ranges = pick_ranges([FRAC_PI_2, FRAC_PI_2]);
    let region = "grasp.y <= 2.9 and dist_y(grasp, holder.centre) >= 0.25";
    let answer = ask(
        StickButton::PICK_DOMAIN,
        region,
        "dist(grasp, holder.centre) >= 0.25",
        &ranges,
    );
    assert!(is_proven(answer));
}
