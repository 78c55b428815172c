//! Bytes of regions and learners, damaged but for their checksum.

use super::hash;
use super::texts::{REGIONS, said};
use critreg::domain::Domain;
use critreg::learn::version_space::{Capacity, Config};
use critreg::learn::{
    Learner, Outcome, Problem, journal, journal_len, resume, resume_journal, save, saved_len,
};
use critreg::region::{Region, SavedRegion};
use critreg_tests::room::VersionSpaceRoom;
use std::sync::OnceLock;

const SHELF: &str = "
    object cup { x: length, y: length }
    parameter px in [0, 4]: length
    parameter py in [0, 4]: length
    point hand = world + (px, py)";

const INSTANCES: [f64; 4] = [1.0, 2.0, 2.0, 3.0];

/// CRC-32 as in zip files.
fn checksum(bytes: &[u8]) -> u32 {
    let shift = |crc: u32| (crc >> 1) ^ (0xEDB8_8320 & (crc & 1).wrapping_neg());
    !bytes.iter().fold(!0, |crc, byte| {
        (0..8).fold(crc ^ u32::from(*byte), |crc, _| shift(crc))
    })
}

/// The same with a checksum that is right.
fn sealed(bytes: &[u8]) -> Vec<u8> {
    let body = bytes.get(..bytes.len().saturating_sub(4)).unwrap_or(&[]);
    [body, &checksum(body).to_le_bytes()].concat()
}

pub(crate) fn regions() -> Vec<Vec<u8>> {
    let bytes = |(domain, region): (&str, &str)| {
        let domain = Domain::parse(domain).unwrap();
        let region = Region::parse(&domain, region).unwrap();
        let mut bytes = vec![0; region.saved_len(&domain)];
        region.save::<f64>(&domain, &mut bytes).unwrap();
        bytes
    };
    REGIONS.map(bytes).into()
}

pub(crate) fn region(input: &[u8]) -> u64 {
    let _ = SavedRegion::read(input);
    let input = sealed(input);
    let saved = match SavedRegion::read(&input) {
        Ok(saved) => saved,
        Err(error) => return said(&error),
    };
    let domain = match Domain::parse(saved.domain_text) {
        Ok(domain) => domain,
        Err(error) => return said(&error),
    };
    let region = match Region::parse(&domain, saved.region_text) {
        Ok(region) => region,
        Err(error) => return said(&error),
    };
    let mut again = vec![0; region.saved_len(&domain)];
    region.save::<f64>(&domain, &mut again).unwrap();
    let same = SavedRegion::read(&again).unwrap();
    assert_eq!(Region::parse(&domain, same.region_text), Ok(region.clone()));
    hash(&region.formula().steps().len())
}

fn tell<L: Learner>(learner: &mut L, problem: &Problem<'_>, calls: usize) {
    for _ in 0..calls {
        let Ok(query) = learner.ask(problem) else {
            break;
        };
        let works = query.theta[0] <= INSTANCES[2 * query.instance];
        learner
            .tell(problem, Outcome::from_feasible(works))
            .unwrap();
    }
}

fn room() -> VersionSpaceRoom {
    VersionSpaceRoom::new(Capacity::new(64, 32))
}

fn config() -> Config {
    Config {
        calls: 16,
        certifying: 4,
        ..Config::default()
    }
}

pub(crate) fn learners() -> Vec<Vec<u8>> {
    let domain = Domain::parse(SHELF).unwrap();
    let problem = Problem::new(&domain, &INSTANCES, 2).unwrap();
    let mut corpus = Vec::new();
    for calls in [1, 9, 16] {
        let mut room = room();
        let mut learner = room.learner(&domain, config()).unwrap();
        tell(&mut learner, &problem, calls);
        let mut bytes = vec![0; saved_len(&learner, &problem)];
        save(&learner, &problem, &mut bytes).unwrap();
        corpus.push(bytes);
        let mut bytes = vec![0; journal_len(&learner, &problem, 0)];
        journal(&learner, &problem, 0, &mut bytes).unwrap();
        corpus.push(bytes);
    }
    corpus
}

pub(crate) fn learner(input: &[u8]) -> u64 {
    let domain = Domain::parse(SHELF).unwrap();
    let problem = Problem::new(&domain, &INSTANCES, 2).unwrap();
    let mut room = room();
    let mut learner = room.learner(&domain, config()).unwrap();
    let resumed = match input.starts_with(b"CRLJ") {
        true => {
            // Every record has a checksum.
            let record = 4 + 2 + 4 * 4 + 8 + 16 + 4;
            let records = input.chunks(record).map(sealed);
            let stands = resume_journal(
                &mut learner,
                &problem,
                &records.flatten().collect::<Vec<_>>(),
            );
            stands.map(|_| ())
        }
        false => resume(&mut learner, &problem, &sealed(input)),
    };
    if let Err(error) = resumed {
        assert!(
            learner.observations().is_empty(),
            "a refused resume has told a part"
        );
        static GOOD: OnceLock<Vec<u8>> = OnceLock::new();
        let mut good = GOOD.get_or_init(|| learners().swap_remove(0)).clone();
        resume(&mut learner, &problem, &good).unwrap();
        let before = good.clone();
        save(&learner, &problem, &mut good).unwrap();
        assert_eq!(before, good);
        return said(&error);
    }
    let told = learner.observations().len();
    tell(&mut learner, &problem, 3);
    hash(&(told, learner.region().is_ok()))
}
