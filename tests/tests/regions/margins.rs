//! Margins: their signs are what membership says, and their gradients what differences
//! tend to.

use critreg::Error;
use critreg::domain::Domain;
use critreg::random::{generator, uniform_in};
use critreg::region::Region;

/// Every quantity of the grammar that a parameter can move; in space, with a turn, a group
/// and bodies.
const DOMAIN: &str = "
    object stick { x: length, y: length, theta: angle }
    object post[3] { x: length, y: length, z: length, r: length }
    object tray { x: length, y: length, z: length, yaw: angle, pitch: angle, roll: angle }
    constant width = 2: length
    parameter mu in [0, 1]
    parameter lift in [-1, 1]: length
    parameter turn in [-1, 1]: angle
    point tip = stick + (mu * width, 0, lift)
    point hand = tray turned (turn, 0.5*turn, 0.25) + (mu * width, lift, 0.25)
    shape post = circle(post.r)
    shape tray = box(1, 2, 0.5) centred
    shape hand = box(0.5, 0.25, 0.125) centred
    shape tip = circle(0.25)";

const REGION: &str = "tip.x <= 2.5 and mu * lift > 0.1 and dist(tip, tray) >= 1
    and min(dist(tip, post)) < 2 and angle(hand, stick) <= 1 and off(tray, tip) >= 0.5
    and angle(stick, tip, tray) <= 2 and dist_y(hand, stick) - dist_z(hand, tip) <= 1
    and min(clear(hand, post)) >= 0.1 and inside(hand, tray) >= 0.125
    and clear(sweep(tip, hand), tray) >= 0 and abs_y_in(hand, tray) <= 0.5
    and hand.theta <= 1 and max(off(post, hand)) <= 2";

fn margins(domain: &Domain<'_>, region: &Region, instance: &[f64], theta: &[f64]) -> [Vec<f64>; 2] {
    let count = region.formula().constraints().len();
    let (mut values, mut gradients) = (vec![0.0; count], vec![0.0; count * theta.len()]);
    let done = region.margins::<f64>(domain, instance, theta, &mut values, &mut gradients);
    done.unwrap();
    [values, gradients]
}

#[test]
fn gradients_are_what_differences_tend_to() {
    const STEP: f64 = 1e-6;
    let domain = Domain::parse(DOMAIN).unwrap();
    let region = Region::parse(&domain, REGION).unwrap();
    let mut rng = generator(3);
    let (mut compared, mut kinks) = (0, 0);
    for trial in 0..300 {
        let mut draw = |size: f64| uniform_in(&mut rng, -size, size);
        let mut instance: Vec<_> = (0..domain.instance_len()).map(|_| draw(2.0)).collect();
        for slot in [6, 10, 14] {
            instance[slot] = 0.5 + 0.25 * draw(1.0);
        }
        if trial % 3 == 0 {
            instance[7..11].fill(f64::NAN);
        }
        let theta = [0.5 + 0.5 * draw(1.0), draw(1.0), draw(1.0)];
        let [values, gradients] = margins(&domain, &region, &instance, &theta);
        for parameter in 0..3 {
            let [before, after] = [-STEP, STEP].map(|step| {
                let mut moved = theta;
                moved[parameter] += step;
                margins(&domain, &region, &instance, &moved)
            });
            for (index, value) in values.iter().enumerate() {
                let place = 3 * index + parameter;
                // Where the derivative jumps there is no other to compare it with.
                if (after[1][place] - before[1][place]).abs() > 1e-2 {
                    kinks += 1;
                    continue;
                }
                let difference = (after[0][index] - before[0][index]) / (2.0 * STEP);
                let error = (gradients[place] - difference).abs();
                assert!(
                    error < 1e-6 * (1.0 + difference.abs()),
                    "trial {trial}, constraint {index} of value {value}, parameter \
                     {parameter}: {} and not {difference}",
                    gradients[place]
                );
                compared += 1;
            }
        }
    }
    assert!(compared > 12_000 && kinks < 20, "{compared}, {kinks}");
}

#[test]
fn a_sample_is_inside_where_no_margin_is_positive() {
    let domain = Domain::parse(DOMAIN).unwrap();
    let text = "tip.x <= 1 and min(clear(tip, post)) >= 0 and dist(hand, stick) < 2";
    let region = Region::parse(&domain, text).unwrap();
    let mut rng = generator(4);
    let mut inside = 0;
    for _ in 0..500 {
        let mut draw = |size: f64| uniform_in(&mut rng, -size, size);
        let mut instance: Vec<_> = (0..domain.instance_len()).map(|_| draw(2.0)).collect();
        for slot in [6, 10, 14] {
            instance[slot] = 0.5 + 0.25 * draw(1.0);
        }
        let theta = [0.5 + 0.5 * draw(1.0), draw(1.0), draw(1.0)];
        let [values, _] = margins(&domain, &region, &instance, &theta);
        let admitted = region.contains::<f64>(&domain, &instance, &theta);
        let admitted = admitted.unwrap();
        assert_eq!(admitted, values.iter().all(|g| *g <= 0.0), "{values:?}");
        inside += u32::from(admitted);
    }
    assert!((25..475).contains(&inside), "{inside}");
}

#[test]
fn over_nothing_and_of_nothing_margins_are_infinite() {
    let text = "object post[2] { x: length, y: length, r: length }
                parameter x in [0, 1]: length
                point hand = world + (x, 0)
                shape post = circle(post.r)
                shape hand = circle(0.5*x - 0.25)";
    let domain = Domain::parse(text).unwrap();
    let region = "min(dist(hand, post)) >= 1 and max(dist(hand, post)) <= 1 and x > 0.5";
    let region = Region::parse(&domain, region).unwrap();
    let [values, gradients] = margins(&domain, &region, &[f64::NAN; 6], &[0.25]);
    let inf = f64::INFINITY;
    assert_eq!(values, [-inf, -inf, 0.25]);
    assert_eq!(gradients, [0.0, 0.0, -1.0]);
    let text = "object post { x: length, y: length, r: length }
                parameter x in [0, 1]: length
                point hand = world + (x, 0)
                shape post = circle(post.r)
                shape hand = circle(0.5)";
    let domain = Domain::parse(text).unwrap();
    let region = Region::parse(&domain, "clear(hand, post) >= 0").unwrap();
    let [values, gradients] = margins(&domain, &region, &[0.0, 0.0, -1.0], &[0.25]);
    assert_eq!((values, gradients), (vec![inf], vec![0.0]));
    let admitted = region.contains::<f64>(&domain, &[0.0, 0.0, -1.0], &[0.25]);
    assert_eq!(admitted, Ok(false));
}

#[test]
fn arrays_of_other_lengths_are_refused() {
    let domain = Domain::parse("parameter x in [0, 1]").unwrap();
    let region = Region::parse(&domain, "x <= 0.5").unwrap();
    let ask = |values: &mut [f64], gradients: &mut [f64]| {
        region.margins::<f64>(&domain, &[], &[0.25], values, gradients)
    };
    assert_eq!(ask(&mut [0.0], &mut []), Ok(()));
    for (values, gradients) in [(0, 0), (2, 0), (1, 2)] {
        let refused = ask(&mut vec![0.0; values], &mut vec![0.0; gradients]);
        assert!(matches!(refused, Err(Error::InvalidArgument(_))));
    }
    let other = Domain::parse("parameter x in [0, 2]").unwrap();
    let refused = region.margins::<f64>(&other, &[], &[0.25], &mut [0.0], &mut []);
    assert!(matches!(refused, Err(Error::Mismatch(_))));
}
