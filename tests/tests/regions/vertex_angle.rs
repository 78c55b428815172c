//! Angles at a point, `angle(a, vertex, b)`: approaching one of several obstacles from a
//! direction in which no other one stands.

use critreg::Error;
use critreg::domain::Domain;
use critreg::random::{generator, uniform_in};
use critreg::region::Region;
use critreg_tests::text;
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_4, PI};

const DOMAIN: &str = "object can { x: length, y: length }
    object other[6] { x: length, y: length }
    parameter sx in [0, 1]: length
    parameter sy in [0, 1]: length
    point start = world + (sx, sy)";
/// An angle of 45 degrees.
const CONE: &str = "min(angle(start, can, other)) >= 0.25 * pi";

/// The bearing of a point from another one.
fn bearing(from: [f64; 2], to: [f64; 2]) -> f64 {
    (to[1] - from[1]).atan2(to[0] - from[0])
}

/// The difference of two bearings, in `[0, pi]`.
fn apart(a: f64, b: f64) -> f64 {
    let turn = (a - b).rem_euclid(2.0 * PI);
    turn.min(2.0 * PI - turn)
}

/// The can, the others, and the numbers of the instance.
fn instance(seed: u64, others: usize) -> ([f64; 2], Vec<[f64; 2]>, Vec<f64>) {
    let mut rng = generator(seed);
    let mut place = || [0.25, 0.75].map(|_| uniform_in(&mut rng, 0.25, 0.75));
    let can = place();
    let others: Vec<_> = (0..others).map(|_| place()).collect();
    let mut numbers = can.to_vec();
    numbers.extend(others.iter().flatten());
    numbers.resize(14, f64::NAN);
    (can, others, numbers)
}

/// How wide the widest gap between the directions to the others is.
fn widest_gap(can: [f64; 2], others: &[[f64; 2]]) -> f64 {
    let mut bearings: Vec<f64> = others.iter().map(|other| bearing(can, *other)).collect();
    bearings.sort_by(f64::total_cmp);
    let next = bearings.iter().cycle().skip(1);
    let gaps = bearings
        .iter()
        .zip(next)
        .map(|(a, b)| (b - a).rem_euclid(2.0 * PI));
    match bearings.len() {
        0 | 1 => 2.0 * PI,
        _ => gaps.fold(0.0, f64::max),
    }
}

proptest! {
    #[test]
    fn membership_is_that_of_bearings(seed: u64, others in 0..=6_usize) {
        let domain = Domain::parse(DOMAIN).unwrap();
        let region = Region::parse(&domain, CONE).unwrap();
        let (can, others, numbers) = instance(seed, others);
        let grounded = region.ground::<f64>(&domain, &numbers).unwrap();
        let mut rng = generator(seed ^ 1);
        for _ in 0..50 {
            let start = [0, 1].map(|_| uniform_in(&mut rng, 0.0, 1.0));
            let way = bearing(can, start);
            let nearest = others.iter().map(|other| apart(way, bearing(can, *other)));
            let nearest = nearest.fold(f64::INFINITY, f64::min);
            prop_assume!((nearest - FRAC_PI_4).abs() > 1e-9);
            prop_assert_eq!(grounded.contains(&start).unwrap(), nearest >= FRAC_PI_4);
        }
    }

    /// However narrow the gap, a start is found in it; and it is found out that there is
    /// none.
    #[test]
    fn draws_find_every_gap(seed: u64, others in 1..=6_usize) {
        let domain = Domain::parse(DOMAIN).unwrap();
        let region = Region::parse(&domain, CONE).unwrap();
        let (can, others, numbers) = instance(seed, others);
        let grounded = region.ground::<f64>(&domain, &numbers).unwrap();
        let gap = widest_gap(can, &others) - PI / 2.0;
        prop_assume!(gap.abs() > 0.01);
        let drawn = grounded.sample(&mut generator(seed));
        if gap > 0.0 {
            let start = drawn.unwrap();
            let way = bearing(can, [start[0], start[1]]);
            let nearest = others.iter().map(|other| apart(way, bearing(can, *other)));
            prop_assert!(nearest.fold(f64::INFINITY, f64::min) >= FRAC_PI_4 - 1e-9);
        } else {
            // Where all is close to the can nothing can be told apart, so that the proof
            // may be missing.
            let none = matches!(drawn, Err(Error::EmptyRegion | Error::NoSample));
            prop_assert!(none, "{:?}", drawn);
        }
    }
}

#[test]
fn the_text_reads_back() {
    let domain = Domain::parse(DOMAIN).unwrap();
    let text = "angle(start, can, start) < 1 and min(angle(can, start, other)) > 2";
    let region = Region::parse(&domain, text).unwrap();
    assert_eq!(text::of_region(&domain, &region), text);
}
