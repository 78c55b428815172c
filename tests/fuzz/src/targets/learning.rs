//! Learners whose answers come from the input: contradictions, failures of steps that there
//! are none of, what was not asked, configurations at their ends.

use super::hash;
use critreg::domain::Domain;
use critreg::learn::version_space::{Capacity, Config};
use critreg::learn::{Learner, Outcome, Problem, Query, resume, save, saved_len};
use critreg::random::{generator, uniform_in};
use critreg::region::Region;
use critreg_tests::room::VersionSpaceRoom;

const DOMAINS: [&str; 3] = [
    "object cup { x: length, y: length }
     object can[2] { x: length, y: length, radius: length }
     constant margin = 0.25: length
     parameter px in [0, 4]: length
     parameter py in [0, 4]: length
     point hand = world + (px, py)",
    "object cup { x: length, y: length, theta: angle }
     parameter p in [0, 4]: length
     point hand = cup + (p, 0)",
    "object cup { x: length, y: length }
     constant margin = 0.25: length",
];

pub(crate) fn corpus() -> Vec<Vec<u8>> {
    let bytes = |first: u8| (0..90u8).map(move |byte| byte.wrapping_mul(first));
    [1, 7, 30, 77, 120, 201]
        .map(|first| bytes(first).collect())
        .into()
}

/// The first bytes configure, all others are one deed each.
pub(crate) fn answers(input: &[u8]) -> u64 {
    let mut bytes = input.iter().copied().take(120);
    let mut next = || bytes.next().unwrap_or(0);
    let domain = Domain::parse(DOMAINS[usize::from(next()) % 3]).unwrap();
    let mut rng = generator(u64::from(next()));
    let count = 1 + usize::from(next()) % 4;
    let numbers = domain.slots().count() * count;
    let instances: Vec<f64> = (0..numbers)
        .map(|_| uniform_in(&mut rng, 0.0, 4.0))
        .collect();
    let problem = Problem::new(&domain, &instances, count).unwrap();
    let config = Config {
        seed: u64::from(next()),
        calls: u32::from(next()) % 60,
        certifying: u32::from(next()) % 20,
        exploring: f64::from(next()) / 255.0,
        noise: f64::from(next() % 3) / 10.0,
        slack: f64::from(next() % 3) / 10.0,
        ..Config::default()
    };
    let steps = 1 + usize::from(next()) % 3;
    let capacity = Capacity {
        instances: count,
        steps,
        ..Capacity::new(256, 48)
    };
    let mut room = VersionSpaceRoom::<f64>::new(capacity);
    let mut learner = room.learner(&domain, config).unwrap();
    let saved = |learner: &dyn Learner| {
        let mut bytes = vec![0; saved_len(learner, &problem)];
        save(learner, &problem, &mut bytes).unwrap();
        bytes
    };
    for byte in bytes.by_ref() {
        let outcome = match byte % 8 {
            0..3 => Outcome::Feasible,
            3..6 => Outcome::FailedStep(1 + (byte >> 3) % 4),
            6 => Outcome::Unknown,
            _ => Outcome::FailedStep(0),
        };
        if byte < 192 {
            let Ok(query) = learner.ask(&problem) else {
                assert!(learner.is_finished());
                break;
            };
            assert_eq!(learner.ask(&problem), Ok(query));
            let before = saved(&learner);
            if learner.tell(&problem, outcome).is_err() {
                assert_eq!(saved(&learner), before, "a failed call changed something");
            }
        } else {
            let theta = [0; 6].map(|_| f64::from(byte) / 64.0);
            let instance = usize::from(byte) % (count + 1);
            let before = saved(&learner);
            let query = Query { instance, theta };
            if learner.observe(&problem, &query, outcome).is_err() {
                assert_eq!(saved(&learner), before, "a failed call changed something");
            }
        }
    }
    let bytes = saved(&learner);
    let mut other = VersionSpaceRoom::<f64>::new(capacity);
    let mut resumed = other.learner(&domain, config).unwrap();
    resume(&mut resumed, &problem, &bytes).unwrap();
    assert_eq!(saved(&resumed), bytes);
    assert_eq!(resumed.best_region(), learner.best_region());
    assert_eq!(resumed.ask(&problem), learner.ask(&problem));
    let report = learner.report();
    assert!(report.certificate.feasible <= report.certificate.draws);
    let Ok(region) = learner.best_region() else {
        return hash(&format!("{:?}", std::mem::discriminant(&learner.why())));
    };
    let text = region.display(&domain).to_string();
    let again = Region::parse(&domain, &text).expect(&text);
    assert_eq!(&again, region, "{text}");
    hash(&(text.len() / 16, format!("{:?}", learner.quality())))
}
