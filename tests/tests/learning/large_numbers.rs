//! Numbers that are too large for what is computed with: refused where they come in, and no
//! bound is infinite.

use critreg::Error;
use critreg::domain::Domain;
use critreg::learn::version_space::{Capacity, Config};
use critreg::learn::{Learner, Outcome, Problem, Query, VersionSpace};
use critreg::random::{generator, uniform_in};
use critreg::real::Real;
use critreg::region::{Region, SavedRegion};
use critreg_tests::room::VersionSpaceRoom;
use proptest::prelude::*;

const SHELF: &str = "
    object cup { x: length, y: length }
    object crate[2] { x: length, y: length, width: length }
    constant margin = 0.25: length
    parameter px in [0, 4]: length
    parameter py in [0, 4]: length
    point hand = world + (px, py)
";

const INSTANCES: usize = 6;

/// Learns left of the cup with numbers so many times as large, and returns the region as text,
/// which must be the same after it was saved.
fn learn<R: Real>(seed: u64, scale: f64, crates: [bool; 2]) -> Result<Option<String>, Error> {
    let text = SHELF
        .replace("0.25", &format!("{:e}", 0.25 * scale))
        .replace("4]", &format!("{:e}]", 4.0 * scale));
    // What nothing in the text explains makes the region an approximate one.
    let odd = seed % 2 == 1;
    let domain = Domain::parse(&text)?;
    let mut rng = generator(seed);
    let mut instances = Vec::new();
    for index in 0..INSTANCES {
        let mut number = || uniform_in(&mut rng, 0.5, 3.5) * scale;
        instances.extend([number(), number()]);
        for own in crates {
            // Some instances have a crate, where the cup is out of reach.
            let there = own && index > 2;
            instances.extend([(); 3].map(|()| if there { number() } else { f64::NAN }));
        }
    }
    let problem = Problem::new(&domain, &instances, INSTANCES)?;
    let mut room = VersionSpaceRoom::<R>::new(Capacity::new(512, 96));
    let capacity = room.capacity;
    let config = Config {
        seed,
        calls: 80,
        ..Config::default()
    };
    let mut learner = VersionSpace::<R>::new(&domain, config, capacity, room.lend())?;
    while !learner.is_finished() {
        let Query { instance, theta } = learner.ask(&problem)?;
        let own = problem.instance(instance)?;
        let works = theta[0] <= own[0] - 0.25 * scale && own[2].is_nan();
        let works = works && !(odd && (7.0 * theta[0] / scale) % 1.0 < 0.2);
        learner.tell(&problem, Outcome::from_feasible(works))?;
    }
    let Ok(region) = learner.best_region() else {
        return Ok(None);
    };
    let mut bytes = vec![0; region.saved_len(&domain)];
    region.save::<R>(&domain, &mut bytes).unwrap();
    let saved = SavedRegion::read(&bytes).unwrap();
    let again = Region::parse(&domain, saved.region_text).expect(saved.region_text);
    assert_eq!(&again, region);
    Ok(Some(saved.region_text.into()))
}

#[test]
fn a_float_learner_refuses_what_a_float_cannot_hold() {
    let refused = |error: Error| matches!(error, Error::NotFinite(_));
    assert!(learn::<f32>(7, 1e39, [true; 2]).is_err_and(refused));
    let domain = Domain::parse(SHELF).unwrap();
    let absent = [f64::NAN; 6];
    let instance = |x: f64| [&[x, 1.0][..], &absent].concat();
    let mut room = VersionSpaceRoom::<f32>::new(Capacity::new(512, 96));
    let mut learner = room.learner(&domain, Config::default()).unwrap();
    let instances = instance(1e39);
    let problem = Problem::new(&domain, &instances, 1).unwrap();
    assert!(learner.ask(&problem).is_err_and(refused));
    // Nothing was begun: other instances are taken.
    let instances = instance(1.0);
    let problem = Problem::new(&domain, &instances, 1).unwrap();
    let query = learner.ask(&problem).unwrap();
    let mut far = query;
    far.theta[0] = 1e39;
    let observed = learner.observe(&problem, &far, Outcome::Feasible);
    assert!(observed.is_err_and(refused));
    assert!(learner.observations().is_empty());
    let region = Region::parse(&domain, "hand.x <= cup.x").unwrap();
    let far = instance(1e39);
    assert!(region.ground::<f32>(&domain, &far).is_err_and(refused));
    assert!(region.ground::<f64>(&domain, &far).is_ok());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn what_is_learned_can_be_saved_and_read(
        seed in any::<u64>(), exponent in -300..308i32, crates in any::<[bool; 2]>(),
    ) {
        learn::<f64>(seed, 10f64.powi(exponent), crates).unwrap();
        let single = learn::<f32>(seed, 10f64.powi(exponent / 8), crates);
        prop_assert_eq!(single.is_err(), exponent / 8 >= 38);
    }
}
