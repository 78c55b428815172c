//! How far micromath's `Fast32` deviates from exact functions, and by how much that
//! shifts what is learned.

use critreg::Error;
use critreg::domain::Domain;
use critreg::learn::version_space::{Capacity, Config, VersionSpace};
use critreg::learn::{Outcome, Problem, learn_region};
use critreg::random::{generator, uniform_in};
use critreg::real::{Fast32, Real};
use critreg_tests::room::VersionSpaceRoom;
use critreg_tests::text;
use proptest::prelude::*;

/// An angle within three turns.
fn angle() -> impl Strategy<Value = f32> {
    -18.9f32..18.9
}

/// A number of either sign between 1e-6 and 1e6.
fn magnitude() -> impl Strategy<Value = f32> {
    (-6.0f32..6.0).prop_map(|power| 10f32.powf(power))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn a_square_root_is_off_by_4e_6(x in magnitude()) {
        let exact = Real::sqrt(f64::from(x));
        prop_assert!((Fast32(x).sqrt().to_f64() / exact - 1.0).abs() < 4e-6);
    }

    #[test]
    fn sine_and_cosine_are_off_by_0_0012(x in angle()) {
        let (sine, cosine) = Fast32(x).sin_cos();
        let (exact_sine, exact_cosine) = Real::sin_cos(f64::from(x));
        prop_assert!((sine.to_f64() - exact_sine).abs() < 0.0012);
        prop_assert!((cosine.to_f64() - exact_cosine).abs() < 0.0012);
    }

    #[test]
    fn an_arc_tangent_is_off_by_0_003(length in magnitude(), x in angle()) {
        let (y, x) = (length * x.sin(), length * x.cos());
        let turned = Fast32(y).atan2(Fast32(x)).to_f64() - Real::atan2(f64::from(y), f64::from(x));
        prop_assert!(turned.wrap_angle().abs() < 0.003);
    }

    #[test]
    fn the_rest_is_exact(x in -1e6f32..1e6) {
        prop_assert_eq!(Fast32(x).floor().0, x.floor());
        prop_assert_eq!(Real::abs(Fast32(x)).0, x.abs());
    }
}

/// An arm may not come closer to the tip of a peg than this, which no constant says.
const CLEARANCE: f64 = 0.7371;
/// How far the tip is from the peg.
const LENGTH: f64 = 0.5;

const DOMAIN: &str = "
    object peg { x: length, y: length, theta: angle }
    constant peg.length = 0.5: length
    parameter x in [-2, 2]: length
    parameter y in [-2, 2]: length
    point hand    = world + (x, y)
    point peg.tip = peg + (peg.length, 0)
";

/// The clearance that a learner finds with some numbers: S and G of its constraint.
fn learned<R: Real>(seed: u64) -> Result<(f64, f64), Error> {
    let capacity = Capacity {
        forms: 1024,
        observations: 200,
        instances: 4,
        steps: 1,
        tracked: 1024,
        sums: usize::MAX,
        questions: 16,
    };
    let mut rng = generator(seed);
    let instances: Vec<_> = (0..12).map(|_| uniform_in(&mut rng, -1.0, 1.0)).collect();
    let domain = Domain::parse(DOMAIN)?;
    let problem = Problem::new(&domain, &instances, 4)?;
    let mut room = VersionSpaceRoom::<R>::new(capacity);
    let config = Config {
        seed,
        calls: 200,
        ..Config::default()
    };
    let mut learner = VersionSpace::new(&domain, config, capacity, room.lend())?;
    let region = learn_region(
        &mut learner,
        &problem,
        |_, query| -> Result<Outcome, Error> {
            let [x, y, theta] = problem.instance(query.instance)? else {
                return Err(Error::NoSample);
            };
            let (sine, cosine) = Real::sin_cos(*theta);
            let [hand_x, hand_y, ..] = query.theta;
            let (dx, dy) = (x + LENGTH * cosine - hand_x, y + LENGTH * sine - hand_y);
            Ok(match Real::sqrt(dx * dx + dy * dy) >= CLEARANCE {
                true => Outcome::Feasible,
                false => Outcome::FailedStep(1),
            })
        },
    )?;
    let text = text::of_region(&domain, region);
    assert!(text.starts_with("dist(hand, peg.tip) >= "), "{text}");
    let [evidence] = learner.evidence() else {
        panic!("one constraint, not {text}");
    };
    Ok((evidence.feasible, evidence.infeasible))
}

/// With exact numbers the clearance lies between S and G. Fast ones shift both, by what
/// sine and cosine are off and a little more.
#[test]
fn thresholds_shift_by_less_than_two_thousandths() {
    for seed in 0..10 {
        let [exact, single, fast] = [learned::<f64>, learned::<f32>, learned::<Fast32>]
            .map(|learned| learned(seed).unwrap());
        for ((feasible, infeasible), shift) in [(exact, 0.0), (single, 1e-6), (fast, 0.002)] {
            assert!(feasible >= CLEARANCE - shift, "{seed}: {feasible}");
            assert!(infeasible <= CLEARANCE + shift, "{seed}: {infeasible}");
            assert!(
                feasible - infeasible < 0.1,
                "{seed}: {feasible} {infeasible}"
            );
        }
    }
}
