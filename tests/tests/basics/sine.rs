//! The sine of single precision against that of double precision.

use critreg::real::Real;
use proptest::prelude::*;

/// How many units in the last place a number is off.
fn units_off(value: f32, exact: f64) -> f64 {
    let nearest = exact as f32;
    let unit = f64::from(nearest.abs().next_up()) - f64::from(nearest.abs());
    (f64::from(value) - exact).abs() / unit
}

fn check(angle: f32) -> Result<(), TestCaseError> {
    let exact = Real::sin_cos(f64::from(angle));
    let (sine, cosine) = Real::sin_cos(angle);
    for (value, exact) in [(sine, exact.0), (cosine, exact.1)] {
        let off = units_off(value, exact);
        prop_assert!(off < 2.5, "{angle}: {value} is {off} units off {exact}");
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200_000))]

    #[test]
    fn sines_are_within_two_and_a_half_units(angle in prop_oneof![-7.0_f32..7.0, -500.0_f32..500.0]) {
        check(angle)?;
    }
}

/// Where most digits cancel: the numbers next to each quarter turn.
#[test]
fn sines_are_good_next_to_quarter_turns() {
    for quarter in -300..=300 {
        let angle = (f64::from(quarter) * std::f64::consts::FRAC_PI_2) as f32;
        for angle in [angle.next_down(), angle, angle.next_up()] {
            check(angle).unwrap();
        }
    }
}

#[test]
fn sines_of_what_is_no_angle_are_no_numbers() {
    for angle in [f32::NAN, f32::INFINITY, -f32::INFINITY] {
        let (sine, cosine) = Real::sin_cos(angle);
        assert!(sine.is_nan() && cosine.is_nan());
    }
    assert_eq!(Real::sin_cos(0.0_f32), (0.0, 1.0));
}
