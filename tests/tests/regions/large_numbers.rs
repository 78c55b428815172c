//! Numbers near the largest there are: what overflows proves nothing.

use critreg::domain::Domain;
use critreg::random::generator;
use critreg::real::Real;
use critreg::region::Region;
use proptest::prelude::*;

/// Whether what is told about a region agrees with a sample that lies in it.
fn agree<R: Real>(domain: &str, region: &str, instance: &[f64], theta: &[f64]) {
    let domain = Domain::parse(domain).unwrap();
    let region = Region::parse(&domain, region).unwrap();
    let grounded = region.ground::<R>(&domain, instance).unwrap();
    assert_eq!(grounded.contains(theta), Ok(true), "{theta:?}");
    assert_eq!(grounded.is_proven_empty(), Ok(false), "{theta:?}");
    let drawn = grounded.sample(&mut generator(7));
    if let Ok(drawn) = drawn {
        let drawn = drawn.get(..theta.len()).unwrap();
        assert_eq!(grounded.contains(drawn), Ok(true), "{drawn:?}");
    } else {
        assert_eq!(drawn, Err(critreg::Error::NoSample));
    }
}

#[test]
fn a_range_as_wide_as_numbers_go_is_halved_where_its_middle_is() {
    let wide = "parameter x in [-1e308, 1e308] parameter y in [-1e308, 1e308]";
    agree::<f64>(wide, "x >= 0 and y >= 0", &[], &[1.0, 1.0]);
    agree::<f64>(wide, "x <= -1e307 and y >= 1e307", &[], &[-5e307, 5e307]);
    agree::<f64>(wide, "x - y >= 1e300", &[], &[1e307, -1e307]);
    let single = "parameter x in [-1e308, 1e308]";
    agree::<f64>(single, "x >= -1e307 and x <= 1e307", &[], &[0.0]);
    agree::<f64>(single, "x <= -1e307 or x >= 1e307", &[], &[5e307]);
    let float = "parameter x in [-3e38, 3e38] parameter y in [-3e38, 3e38]";
    agree::<f32>(float, "x >= 0 and y >= 0", &[], &[1.0, 1.0]);
}

#[test]
fn draws_from_a_range_as_wide_as_numbers_go_are_spread_over_it() {
    let domain = Domain::parse("parameter x in [-1e308, 1e308]").unwrap();
    let region = Region::parse(&domain, "true").unwrap();
    let grounded = region.ground::<f64>(&domain, &[]).unwrap();
    let mut rng = generator(7);
    let mut draw = || grounded.sample(&mut rng).unwrap()[0];
    let below = (0..200).filter(|_| draw() < -5e307).count();
    assert!(
        (30..=70).contains(&below),
        "{below} of 200 in the first quarter"
    );
}

#[test]
fn a_distance_whose_square_overflows_is_a_number() {
    let domain = "object wall { x: length, y: length }
                  parameter a in [0, 1e200]: length
                  parameter b in [0, 1e200]: length
                  point hand = world + (a, b)";
    agree::<f64>(
        domain,
        "dist(hand, wall) <= 1e190",
        &[5e199, 5e199],
        &[5e199, 5e199],
    );
    agree::<f64>(
        domain,
        "dist(hand, wall) <= 9e199",
        &[0.0, 0.0],
        &[6e199, 6e199],
    );
    let single = "object wall { x: length, y: length }
                  parameter a in [0, 1e200]: length
                  point hand = world + (a, 0)";
    agree::<f64>(
        single,
        "dist(hand, wall) >= 1.2e200",
        &[0.0, 1e200],
        &[9e199],
    );
    agree::<f64>(
        single,
        "dist(hand, wall) <= 1.1e200",
        &[0.0, 1e200],
        &[1e199],
    );
}

proptest! {
    /// What is inside is not proven to be empty, of whatever size the numbers are.
    #[test]
    fn what_is_inside_is_not_proven_empty(
        exponent in 0..308i32,
        instance in prop::array::uniform3(-9.0..9.0f64),
        ends in prop::array::uniform4(-9.0..9.0f64),
        shares in prop::array::uniform2(0.0..1.0f64),
        bounds in prop::array::uniform2(-9.0..9.0f64),
        which in prop::array::uniform2(0..10usize),
        upper in prop::array::uniform2(any::<bool>()),
        both in any::<bool>(),
    ) {
        // All of one size: what is absorbed in a sum is no overflow.
        let scale = 10f64.powi(exponent - 1);
        let [x, y, theta] = instance;
        let instance = [x * scale, y * scale, theta];
        let bounds = bounds.map(|bound| bound * scale);
        let [a, b, c, d] = ends.map(|end| end * scale);
        prop_assume!(a != b && c != d);
        let (low, high) = (Real::min(a, b), Real::max(a, b));
        let (left, right) = (Real::min(c, d), Real::max(c, d));
        let second = if both {
            format!("parameter v in [{left:e}, {right:e}]: length\n")
        } else {
            format!("constant v = {left:e}: length\n")
        };
        let domain = format!(
            "object wall {{ x: length, y: length, theta: angle }}
             constant size = 2: length
             parameter u in [{low:e}, {high:e}]: length
             {second}
             point hand = wall + (u, 0)
             point foot = world + (u, v)"
        );
        let terms = [
            "u", "u + v", "u - wall.x", "dist(hand, wall)", "dist(foot, wall)", "hand.y",
            "dist_x(foot, hand)", "dist(foot, hand)", "2*u - v", "dist(foot, wall) + hand.x",
        ];
        let bound = |own: usize| {
            let sign = if upper[own] { "<=" } else { ">=" };
            format!("{} {sign} {:e}", terms[which[own]], bounds[own])
        };
        let text = format!("{} and {}", bound(0), bound(1));
        let domain = Domain::parse(&domain).unwrap();
        let region = Region::parse(&domain, &text).unwrap();
        let grounded = region.ground::<f64>(&domain, &instance).unwrap();
        let mut theta = vec![low.towards(high, shares[0])];
        if both {
            theta.push(left.towards(right, shares[1]));
        }
        if grounded.contains(&theta).unwrap() {
            prop_assert_eq!(grounded.is_proven_empty(), Ok(false), "{}", text);
        }
        if let Ok(drawn) = grounded.sample(&mut generator(7)) {
            prop_assert_eq!(grounded.contains(&drawn[..theta.len()]), Ok(true), "{}", text);
        }
    }
}
