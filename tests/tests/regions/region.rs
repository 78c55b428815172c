//! Properties of formulas and regions: text, membership, intervals, sampling.

use critreg::Error;
use critreg::domain::{Domain, PointSet, Sample, Scene};
use critreg::grammar::Formula;
use critreg::random::generator;
use critreg::region::{Intersection, Part, Region, SavedRegion};
use critreg_tests::{arm, pick, text};
use proptest::prelude::*;
use std::f64::consts::PI;

/// The text of a length over the pick domain.
fn length() -> impl Strategy<Value = String> {
    let leaf = prop_oneof![
        Just("grasp.x".to_string()),
        Just("grasp.y".to_string()),
        Just("stick.y".to_string()),
        Just("holder.centre.y".to_string()),
        Just("zone.top".to_string()),
        Just("dist(grasp, holder.centre)".to_string()),
        Just("dist_y(grasp, holder.centre)".to_string()),
        Just("dist_x(stick.tip, button)".to_string()),
        Just("dist(grasp, robot)".to_string()),
        (-5.0..5.0f64).prop_map(|x| x.to_string()),
    ];
    leaf.prop_recursive(3, 12, 2, |inner| {
        prop_oneof![
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("{a} + {b}")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("{a} - ({b})")),
            (inner.clone(), -2.0..2.0f64).prop_map(|(a, k)| format!("{k}*({a})")),
            (inner, Just("mu")).prop_map(|(a, mu)| format!("({a})*{mu}")),
            Just("-stick.height".to_string()),
        ]
    })
}

fn comparison() -> impl Strategy<Value = &'static str> {
    prop_oneof![Just("<"), Just("<="), Just(">="), Just(">")]
}

fn constraint() -> impl Strategy<Value = String> {
    prop_oneof![
        (length(), comparison(), length()).prop_map(|(a, c, b)| format!("{a} {c} {b}")),
        (comparison(), -0.5..1.5f64).prop_map(|(c, k)| format!("mu {c} {k}")),
        (comparison(), 0.0..4.0f64).prop_map(|(c, k)| format!("grasp.y {c} {k}")),
        (comparison(), 0.0..2.0f64)
            .prop_map(|(c, k)| format!("dist(grasp, holder.centre) {c} {k} (0.5*holder.width)")),
    ]
}

fn formula() -> impl Strategy<Value = String> {
    let leaf = prop_oneof![8 => constraint(), 1 => Just("true".to_string())];
    leaf.prop_recursive(3, 8, 2, |inner| {
        prop_oneof![
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("{a} and ({b})")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("({a}) and {b}")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("({a}) or {b}")),
            inner.prop_map(|a| format!("not ({a})")),
        ]
    })
}

/// Reads a region; texts that need more room than there is are left out.
fn read(domain: &Domain<'_>, text: &str) -> Option<Region> {
    match Region::parse(domain, text) {
        Ok(region) => Some(region),
        Err(Error::CapacityExceeded(_)) => None,
        Err(Error::Syntax(at)) if skipped(at.what) => None,
        Err(error) => panic!("{text}: {error}"),
    }
}

/// The generator does not know of limits and dimensions.
fn skipped(what: &str) -> bool {
    ["nested", "product", "dimension"]
        .iter()
        .any(|word| what.contains(word))
}

/// Membership by evaluating every constraint at the sample.
fn evaluate(domain: &Domain<'_>, region: &Region, instance: &[f64], mu: f64) -> bool {
    let scene: Scene<'_, f64> = Scene::new(domain, instance, PointSet::all(domain)).unwrap();
    let theta = pick::theta(mu);
    let sample: Sample<'_, '_, f64, f64> = scene.sample(&theta);
    let formula = region.formula();
    formula.holds(|c| {
        let [lhs, rhs] = [c.lhs, c.rhs].map(|id| sample.measure(formula.nodes(), id));
        c.comparison.holds(&lhs, &rhs)
    })
}

/// Values of mu close together, and those at which rounding decides left out.
fn grid(set: &critreg::region::IntervalSet<f64>) -> Vec<f64> {
    let near_end = |mu: f64| {
        let ends = set.intervals().iter().flat_map(|i| [i.low, i.high]);
        ends.into_iter().any(|end| (mu - end).abs() < 1e-7)
    };
    let all = (0..=2000).map(|i| f64::from(i) / 2000.0);
    all.filter(|mu| !near_end(*mu)).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn what_is_written_reads_back_the_same(text in formula()) {
        let domain = pick::domain();
        if let Some(region) = read(&domain, &text) {
            let written = text::of_region(&domain, &region);
            let again = Region::parse(&domain, &written).expect(&written);
            prop_assert_eq!(&again, &region, "{} became {}", text, written);
            prop_assert_eq!(text::of_region(&domain, &again), written);
        }
    }

    #[test]
    fn saved_bytes_read_back_and_damage_is_seen(text in formula(), flip in any::<(u16, u8)>()) {
        let domain = pick::domain();
        if let Some(region) = read(&domain, &text) {
            let mut bytes = vec![0; region.saved_len(&domain)];
            let used = region.save::<f64>(&domain, &mut bytes).unwrap();
            prop_assert_eq!(used, bytes.len());
            let saved = SavedRegion::read(&bytes).unwrap();
            let other = Domain::parse(saved.domain_text).unwrap();
            prop_assert_eq!(&Region::parse(&other, saved.region_text).unwrap(), &region);
            drop(other);
            let short = bytes.len() - 1;
            prop_assert!(region.save::<f64>(&domain, &mut bytes.clone()[..short]).is_err());
            prop_assert!(SavedRegion::read(&bytes[..short]).is_err());
            let at = usize::from(flip.0) % bytes.len();
            bytes[at] ^= flip.1.max(1);
            prop_assert!(SavedRegion::read(&bytes).is_err());
        }
    }

    #[test]
    fn intervals_agree_with_membership_on_a_grid(text in formula(), seed in 0u64..500) {
        let domain = pick::domain();
        let instance = pick::instances(seed, 1);
        if let Some(region) = read(&domain, &text) {
            let grounded = region.ground::<f64>(&domain, &instance).unwrap();
            let set = grounded.intervals().unwrap();
            for mu in grid(set) {
                let inside = evaluate(&domain, &region, &instance, mu);
                prop_assert_eq!(grounded.contains(&[mu]).unwrap(), inside);
                if set.is_exact() {
                    prop_assert_eq!(set.contains(mu), inside, "{} at {}: {:?}", text, mu, set);
                } else {
                    prop_assert!(set.contains(mu) || !inside, "{} at {}", text, mu);
                }
            }
            for pair in set.intervals().windows(2) {
                prop_assert!(pair[0].high <= pair[1].low);
            }
        }
    }

    #[test]
    fn a_sample_satisfies_its_region(text in formula(), seed in 0u64..500) {
        let domain = pick::domain();
        let instance = pick::instances(seed, 1);
        if let Some(region) = read(&domain, &text) {
            let mut rng = generator(seed);
            for _ in 0..10 {
                match region.sample::<f64>(&domain, &instance, &mut rng) {
                    Ok(theta) => prop_assert!(
                        region.contains::<f64>(&domain, &instance, &theta[..1]).unwrap(),
                        "{} at {:?}", text, theta
                    ),
                    Err(Error::EmptyRegion) => {
                        let inside = |i: i32| {
                            region.contains::<f64>(&domain, &instance, &[f64::from(i) / 500.0])
                        };
                        prop_assert!(!(0..=500).any(|i| inside(i).unwrap()), "{}", text);
                    }
                    // Single points that rounding hides, or no closed form.
                    Err(Error::NoSample) => {
                        let grounded = region.ground::<f64>(&domain, &instance).unwrap();
                        let set = grounded.intervals().unwrap();
                        prop_assert!(!set.is_exact() || set.length() < 1e-9, "{}", text);
                    }
                    Err(error) => panic!("{text}: {error}"),
                }
            }
        }
    }

    #[test]
    fn several_parameters_sample_inside(
        wall in -2.0..2.0f64, radius in 0.05..2.5f64, gap in 0.0..1.0f64,
        turn in -3.0..3.0f64, seed in any::<u64>(),
    ) {
        let domain = arm::domain();
        let text = format!(
            "hand.x <= {wall} and dist(hand, base) <= {radius} \
             and (dist_x(hand, box) > {gap} or dist_y(hand, box.top) > {gap}) \
             and elbow.x >= {turn} * upper"
        );
        let region = Region::parse(&domain, &text).unwrap();
        let instance = [0.1, -0.2, 0.5, 0.5, 0.3];
        let grounded = region.ground::<f64>(&domain, &instance).unwrap();
        match grounded.sample(&mut generator(seed)) {
            Ok(theta) => prop_assert!(grounded.contains(&theta[..3]).unwrap(), "{text}"),
            Err(Error::EmptyRegion) => {
                let steps = |n: i32| (-n..=n).map(move |i| f64::from(i) / f64::from(n));
                for (x, y) in steps(20).flat_map(|x| steps(20).map(move |y| (x, y))) {
                    for q in steps(16) {
                        let theta = [2.0 * x, 2.0 * y, q * std::f64::consts::PI];
                        prop_assert!(!grounded.contains(&theta).unwrap(), "{text} at {theta:?}");
                    }
                }
            }
            Err(error) => prop_assert_eq!(error, Error::NoSample),
        }
    }

    #[test]
    fn no_text_is_too_strange(text in "\\PC{0,80}", cut in 0usize..600, insert in "\\PC{0,3}") {
        let domain = pick::domain();
        let _ = Domain::parse(&text);
        let _ = Formula::parse(&domain, &text);
        let mut damaged = domain.text().to_string();
        let at = (0..=cut).rev().find(|i| damaged.is_char_boundary(*i)).unwrap();
        damaged.insert_str(at, &insert);
        let _ = Domain::parse(&damaged);
        let _ = Domain::parse(&domain.text()[..at]);
    }
}

#[test]
fn a_distance_that_touches_its_bound_admits_one_point() {
    let text = "object post { x: length, y: length } parameter x in [0, 4]: length
                point hand = world + (x, 0)";
    let line = Domain::parse(text).unwrap();
    for (region, instance) in [
        ("dist_x(hand, post) <= 0", [1.0, 3.0]),
        ("dist(hand, post) <= 0", [1.0, 0.0]),
        ("dist(hand, post) <= 3", [1.0, 3.0]),
    ] {
        let region = Region::parse(&line, region).unwrap();
        let grounded = region.ground::<f64>(&line, &instance).unwrap();
        let set = grounded.intervals().unwrap();
        let ends: Vec<_> = set.intervals().iter().map(|i| [i.low, i.high]).collect();
        assert_eq!(ends, [[1.0, 1.0]], "{}", text::of_region(&line, &region));
    }
}

#[test]
fn sampling_is_uniform_over_pieces() {
    let domain = pick::domain();
    let text = "mu <= 0.2 or mu >= 0.7 and mu < 0.9";
    let region = Region::parse(&domain, text).unwrap();
    let instance = pick::instances(1, 1);
    let grounded = region.ground::<f64>(&domain, &instance).unwrap();
    let mut rng = generator(5);
    let draws: Vec<f64> = (0..40_000)
        .map(|_| grounded.sample(&mut rng).unwrap()[0])
        .collect();
    for (low, high) in [(0.0, 0.1), (0.1, 0.2), (0.7, 0.8), (0.8, 0.9)] {
        let count = draws.iter().filter(|mu| low <= **mu && **mu < high).count();
        assert!(count.abs_diff(10_000) < 400, "{count} in [{low}, {high})");
    }
}

#[test]
fn hit_and_run_fills_a_small_region_evenly() {
    let domain = arm::domain();
    // A disc of about one ten-thousandth of the table: rejection will not find it.
    let region = Region::parse(&domain, "dist(hand, box) < 0.02").unwrap();
    let instance = [0.0, 0.0, 1.0, 0.5, 0.0];
    let grounded = region.ground::<f64>(&domain, &instance).unwrap();
    let mut rng = generator(11);
    let draws: Vec<_> = (0..4000)
        .map(|_| grounded.sample(&mut rng).unwrap())
        .collect();
    let share = |inside: &dyn Fn(f64, f64) -> bool| {
        let count = draws
            .iter()
            .filter(|t| inside(t[0] - 1.0, t[1] - 0.5))
            .count();
        count as f64 / draws.len() as f64
    };
    for quarter in [
        share(&|x, y| x > 0.0 && y > 0.0),
        share(&|x, y| x < 0.0 && y > 0.0),
        share(&|x, y| x < 0.0 && y < 0.0),
        share(&|x, y| x * x + y * y < 1e-4),
    ] {
        assert!((quarter - 0.25).abs() < 0.03, "{quarter}");
    }
}

#[test]
fn emptiness_of_several_parameters_is_proven() {
    let domain = arm::domain();
    let instance = [0.0, 0.0, 1.0, 0.5, 0.0];
    for text in [
        "hand.x > 3",
        "dist(hand, base) < 0.5 and hand.x > 0.6",
        "not true",
        "hand.x > 1 and hand.x < 0.5 or hand.y > 2.5",
    ] {
        let region = Region::parse(&domain, text).unwrap();
        let drawn = region.sample::<f64>(&domain, &instance, &mut generator(1));
        assert_eq!(drawn, Err(Error::EmptyRegion), "{text}");
    }
}

#[test]
fn a_region_refuses_another_domain() {
    let region = Region::parse(&pick::domain(), "mu < 0.5").unwrap();
    let domain = arm::domain();
    let drawn = region.sample::<f64>(&domain, &[0.0; 5], &mut generator(1));
    assert!(matches!(drawn, Err(Error::Mismatch(_))));
}

/// In single precision pi and a tenth are beyond themselves; what is drawn is not.
#[test]
fn draws_in_single_precision_stay_within_their_ranges() {
    let ranges = "object mark { angle: angle } parameter yaw in [-pi, pi]: angle";
    let texts = [
        ranges.to_string(),
        format!("{ranges} parameter r in [0, 0.1]: length"),
    ];
    for text in texts {
        let domain = Domain::parse(&text).unwrap();
        for (text, angle) in [
            ("yaw >= mark.angle", PI - 6e-8),
            ("yaw <= mark.angle", 6e-8 - PI),
        ] {
            let region = Region::parse(&domain, text).unwrap();
            let part = Part {
                region: &region,
                domain: &domain,
                instance: &[angle],
            };
            let intersection = [part, part];
            let intersection = Intersection::<f32>::new(&intersection).unwrap();
            for seed in 0..200 {
                let alone = region.sample::<f32>(&domain, &[angle], &mut generator(seed));
                let both = intersection.sample(&mut generator(seed));
                for drawn in [alone, both] {
                    let theta = &drawn.unwrap()[..domain.parameters().len()];
                    let inside = region.contains::<f32>(&domain, &[angle], theta);
                    assert_eq!(inside, Ok(true), "{text}: {theta:?}");
                }
            }
        }
    }
}
