//! Several regions at once, against each of them alone and brute force on a grid.

use critreg::Error;
use critreg::domain::Domain;
use critreg::random::generator;
use critreg::region::{Intersection, Part, Region};
use critreg_tests::{arm, pick};
use proptest::prelude::*;

/// A region of picking, sometimes one without a closed form for the whole of it.
fn region() -> impl Strategy<Value = String> {
    let side = || prop_oneof![Just("<"), Just("<="), Just(">="), Just(">")];
    let constraint = prop_oneof![
        3 => (side(), -0.2..1.2f64).prop_map(|(c, k)| format!("mu {c} {k}")),
        3 => (side(), 0.5..4.5f64).prop_map(|(c, k)| format!("grasp.y {c} {k}")),
        3 => (side(), 0.0..2.0f64).prop_map(|(c, k)| format!("dist(grasp, holder.centre) {c} {k}")),
        1 => (side(), 1.0..5.0f64)
            .prop_map(|(c, k)| format!("dist(grasp, button) + dist(grasp, robot) {c} {k}")),
    ];
    let literal =
        prop_oneof![3 => constraint.clone(), 1 => constraint.prop_map(|c| format!("not {c}"))];
    let join = prop_oneof![Just(" and "), Just(" or ")];
    (literal.clone(), join, literal).prop_map(|(a, j, b)| format!("{a}{j}{b}"))
}

fn regions(domain: &Domain<'_>, texts: &[String]) -> Vec<Region> {
    let parse = |text: &String| Region::parse(domain, text).expect(text);
    texts.iter().map(parse).collect()
}

fn parts<'a>(domain: &'a Domain<'a>, regions: &'a [Region], instances: &'a [f64]) -> Vec<Part<'a>> {
    let instances = instances.chunks_exact(domain.instance_len()).cycle();
    let part = |(region, instance)| Part {
        region,
        domain,
        instance,
    };
    regions.iter().zip(instances).map(part).collect()
}

/// Whether each region alone admits the parameters.
fn all_contain(parts: &[Part<'_>], theta: &[f64]) -> bool {
    let inside = |p: &Part<'_>| p.region.contains::<f64>(p.domain, p.instance, theta);
    parts.iter().all(|part| inside(part).unwrap())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn one_parameter(texts in prop::collection::vec(region(), 1..5), seed in 0u64..500) {
        let domain = pick::domain();
        let regions = regions(&domain, &texts);
        let instances = pick::instances(seed, 3);
        let parts = parts(&domain, &regions, &instances);
        let whole = Intersection::<f64>::new(&parts).unwrap();
        let grid = || (0..=1000).map(|i| [f64::from(i) / 1000.0]);
        for mu in grid() {
            prop_assert_eq!(whole.contains(&mu).unwrap(), all_contain(&parts, &mu), "{:?}", mu);
        }
        let some = grid().any(|mu| all_contain(&parts, &mu));
        prop_assert!(!(some && whole.is_proven_empty().unwrap()));
        let mut rng = generator(seed);
        for _ in 0..5 {
            match whole.sample(&mut rng) {
                Ok([mu, ..]) => prop_assert!(all_contain(&parts, &[mu]), "{texts:?} at {mu}"),
                Err(Error::EmptyRegion) => prop_assert!(!some, "{texts:?}"),
                // Without a closed form nothing needs to be found.
                Err(error) => prop_assert_eq!(error, Error::NoSample),
            }
        }
    }

    #[test]
    fn regions_in_one_instance_are_their_conjunction(
        texts in prop::collection::vec(region(), 1..5), seed in 0u64..500,
    ) {
        let domain = pick::domain();
        let instance = pick::instances(seed, 1);
        let regions = regions(&domain, &texts);
        let parts = parts(&domain, &regions, &instance);
        let whole = Intersection::<f64>::new(&parts).unwrap();
        let conjunction = texts.iter().map(|text| format!("({text})"));
        let conjunction = conjunction.collect::<Vec<_>>().join(" and ");
        let one = Region::parse(&domain, &conjunction).unwrap();
        let grounded = one.ground::<f64>(&domain, &instance).unwrap();
        if !grounded.intervals().unwrap().is_exact() {
            return Ok(());
        }
        prop_assert_eq!(whole.is_proven_empty(), grounded.is_proven_empty());
        let draws = [whole.sample(&mut generator(seed)), grounded.sample(&mut generator(seed))];
        match draws {
            [Ok([a, ..]), Ok([b, ..])] => prop_assert!((a - b).abs() < 1e-9, "{a} {b}"),
            [a, b] => prop_assert_eq!(a, b),
        }
    }

    #[test]
    fn several_parameters(
        wall in -2.0..2.0f64, radius in 0.1..2.0f64, gap in 0.0..1.0f64, at in -1.0..1.0f64,
        seed in any::<u64>(),
    ) {
        let domain = arm::domain();
        let regions = regions(&domain, &[
            format!("dist(hand, base) <= {radius}"),
            format!("hand.x <= {wall} or dist_y(hand, box.top) > {gap}"),
            format!("dist(hand, box) <= {radius} and elbow.x >= {at}"),
        ]);
        let instances = [
            0.1, -0.2, 0.5, 0.5, 0.3,
            -0.2, 0.3, at, 0.2, -0.3,
            0.0, 0.0, wall, 0.1, 0.0,
        ];
        let parts = parts(&domain, &regions, &instances);
        let whole = Intersection::<f64>::new(&parts).unwrap();
        match whole.sample(&mut generator(seed)) {
            Ok(theta) => prop_assert!(all_contain(&parts, &theta[..3])),
            Err(Error::EmptyRegion) => {
                let steps = |n: i32| (-n..=n).map(move |i| f64::from(i) / f64::from(n));
                for (x, y) in steps(20).flat_map(|x| steps(20).map(move |y| (x, y))) {
                    for q in steps(8) {
                        let theta = [2.0 * x, 2.0 * y, q * std::f64::consts::PI];
                        prop_assert!(!all_contain(&parts, &theta), "{theta:?}");
                    }
                }
            }
            Err(error) => prop_assert_eq!(error, Error::NoSample),
        }
    }
}

#[test]
fn a_lens_of_two_discs_is_filled_evenly() {
    let domain = arm::domain();
    let regions = regions(&domain, &["dist(hand, box) < 0.03".into()]);
    let regions = [regions[0].clone(), regions[0].clone()];
    let instances = [0.0, 0.0, 0.99, 0.5, 0.0, 0.0, 0.0, 1.01, 0.5, 0.0];
    let parts = parts(&domain, &regions, &instances);
    let whole = Intersection::<f64>::new(&parts).unwrap();
    let mut rng = generator(3);
    let draws: Vec<_> = (0..2000).map(|_| whole.sample(&mut rng).unwrap()).collect();
    let share = |inside: &dyn Fn(f64, f64) -> bool| {
        let count = draws
            .iter()
            .filter(|t| inside(t[0] - 1.0, t[1] - 0.5))
            .count();
        count as f64 / draws.len() as f64
    };
    assert_eq!(
        share(&|x, y| all_contain(&parts, &[x + 1.0, y + 0.5, 0.0])),
        1.0
    );
    for half in [share(&|x, _| x > 0.0), share(&|_, y| y > 0.0)] {
        assert!((half - 0.5).abs() < 0.05, "{half}");
    }
}

#[test]
fn ends_that_touch_share_a_point_only_if_both_have_it() {
    let domain = pick::domain();
    let instance = pick::instances(1, 1);
    let cases = [
        ("mu <= 0.5", "mu >= 0.5", Some(0.5)),
        ("mu < 0.5", "mu >= 0.5", None),
        ("mu <= 0.5", "mu > 0.5", None),
        (
            "mu <= 0.25 or mu >= 0.75",
            "mu >= 0.25 and mu < 0.75",
            Some(0.25),
        ),
    ];
    for (a, b, point) in cases {
        for texts in [
            [a.to_string(), b.to_string()],
            [b.to_string(), a.to_string()],
        ] {
            let regions = regions(&domain, &texts);
            let parts = parts(&domain, &regions, &instance);
            let whole = Intersection::<f64>::new(&parts).unwrap();
            let drawn = whole.sample(&mut generator(1)).map(|[mu, ..]| mu);
            assert_eq!(drawn, point.ok_or(Error::EmptyRegion), "{a}, {b}");
        }
    }
}

#[test]
fn without_parameters_all_regions_hold_or_the_intersection_is_empty() {
    let domain = Domain::parse("object button { x: length, y: length }").unwrap();
    let regions = regions(&domain, &["button.y <= 3".into(), "button.x >= 1".into()]);
    for (button, drawn) in [
        ([2.0, 2.0], Ok([0.0; 6])),
        ([0.5, 2.0], Err(Error::EmptyRegion)),
    ] {
        let parts = parts(&domain, &regions, &button);
        let whole = Intersection::<f64>::new(&parts).unwrap();
        assert_eq!(whole.sample(&mut generator(1)), drawn);
        assert_eq!(whole.is_proven_empty(), Ok(drawn.is_err()));
    }
}

#[test]
fn regions_of_different_parameters_do_not_intersect() {
    let (one, three) = (pick::domain(), arm::domain());
    let regions = [
        Region::parse(&one, "mu < 1").unwrap(),
        Region::parse(&three, "px < 1").unwrap(),
    ];
    let instance = pick::instances(1, 1);
    let mixed = [
        Part {
            region: &regions[0],
            domain: &one,
            instance: &instance,
        },
        Part {
            region: &regions[1],
            domain: &three,
            instance: &[0.0; 5],
        },
    ];
    assert!(matches!(
        Intersection::<f64>::new(&mixed),
        Err(Error::Mismatch(_))
    ));
    assert!(matches!(
        Intersection::<f64>::new(&[]),
        Err(Error::InvalidArgument(_))
    ));
}
