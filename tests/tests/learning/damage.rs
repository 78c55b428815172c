//! Saved bytes that are damaged, and such that only seem not to be: a learner takes all of
//! them or nothing.

use crate::shelf::saved;
use critreg::Error;
use critreg::domain::Domain;
use critreg::learn::version_space::{Capacity, Config};
use critreg::learn::{
    Algorithm1, Learner, Outcome, Problem, algorithm1, journal, journal_len, resume, resume_journal,
};
use critreg::region::{Region, SavedRegion};
use critreg_tests::room::{Algorithm1Room, VersionSpaceRoom};

const SHELF: &str = "
    object cup { x: length, y: length }
    parameter px in [0, 4]: length
    parameter py in [0, 4]: length
    point hand = world + (px, py)
";

const INSTANCES: [f64; 4] = [1.0, 2.0, 2.0, 3.0];

/// CRC-32 as in zip files, bit by bit.
fn checksum(bytes: &[u8]) -> u32 {
    let shift = |crc: u32| (crc >> 1) ^ (0xEDB8_8320 & (crc & 1).wrapping_neg());
    !bytes.iter().fold(!0, |crc, byte| {
        (0..8).fold(crc ^ u32::from(*byte), |crc, _| shift(crc))
    })
}

/// The same bytes with a checksum that is right.
fn sealed(bytes: &[u8]) -> Vec<u8> {
    let (body, _) = bytes.split_at(bytes.len() - 4);
    [body, &checksum(body).to_le_bytes()].concat()
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

/// That damaged bytes change nothing: those of a run that a learner is put through, with
/// every bit flipped and every end cut off, with a checksum that does not fit and with one
/// that does.
fn survives<L: Learner>(learner: &mut L, problem: &Problem<'_>) {
    tell(learner, problem, 9);
    learner.ask_more(problem).unwrap();
    let good = saved(learner, problem);
    assert_eq!(sealed(&good), good);
    let mut written = vec![0; journal_len(learner, problem, 0)];
    journal(learner, problem, 0, &mut written).unwrap();
    let last = written.len() - written.len() / learner.observations().len();
    learner.restart(problem.domain());
    // Nothing was told: the good bytes are taken, and make the same learner.
    let is_fresh = |learner: &mut L| {
        assert!(learner.observations().is_empty());
        resume(learner, problem, &good).unwrap();
        assert_eq!(saved(learner, problem), good);
        learner.restart(problem.domain());
    };
    for length in 0..good.len() {
        assert!(resume(learner, problem, &good[..length]).is_err());
    }
    is_fresh(learner);
    let (mut refused, mut taken) = (0, 0);
    let mut counted = |learner: &mut L, ended: bool| {
        if ended {
            taken += 1;
            // It is a learner like any other.
            tell(learner, problem, 3);
            learner.restart(problem.domain());
        } else {
            refused += 1;
            is_fresh(learner);
        }
    };
    for bit in 0..8 * good.len() {
        let damaged = flipped(&good, bit);
        let corrupt = resume(learner, problem, &damaged);
        assert!(matches!(corrupt, Err(Error::Corrupt(_))), "bit {bit}");
        if bit / 8 + 4 < good.len() {
            let ended = resume(learner, problem, &sealed(&damaged)).is_ok();
            counted(learner, ended);
        }
    }
    // In the last record, so that those before it were told.
    for bit in 8 * last..8 * (written.len() - 4) {
        let damaged = flipped(&written, bit);
        let (before, record) = damaged.split_at(last);
        let damaged = [before, &sealed(record)].concat();
        let ended = resume_journal(learner, problem, &damaged).is_ok();
        counted(learner, ended);
    }
    assert!(refused > 100 && taken > 0, "{refused} {taken}");
}

fn flipped(bytes: &[u8], bit: usize) -> Vec<u8> {
    let mut damaged = bytes.to_vec();
    damaged[bit / 8] ^= 1 << (bit % 8);
    damaged
}

#[test]
fn a_version_space_survives_damaged_bytes() {
    let domain = Domain::parse(SHELF).unwrap();
    let problem = Problem::new(&domain, &INSTANCES, 2).unwrap();
    let mut room = VersionSpaceRoom::<f64>::new(Capacity::new(64, 32));
    let config = Config {
        calls: 16,
        certifying: 4,
        ..Config::default()
    };
    survives(&mut room.learner(&domain, config).unwrap(), &problem);
}

#[test]
fn algorithm_1_survives_damaged_bytes() {
    let domain = Domain::parse(SHELF).unwrap();
    let problem = Problem::new(&domain, &INSTANCES, 2).unwrap();
    let mut room = Algorithm1Room::new(256, 32);
    let config = algorithm1::Config {
        iterations: 16,
        ..algorithm1::Config::default()
    };
    let capacity = room.capacity;
    let learner = Algorithm1::<f64>::new(&domain, config, capacity, room.lend());
    survives(&mut learner.unwrap(), &problem);
}

#[test]
fn a_region_survives_damaged_bytes() {
    let domain = Domain::parse(SHELF).unwrap();
    let region = Region::parse(&domain, "hand.x <= cup.x and dist(hand, cup) >= 0.25").unwrap();
    let mut good = vec![0; region.saved_len(&domain)];
    region.save::<f64>(&domain, &mut good).unwrap();
    let read = |bytes: &[u8]| -> Result<(), Error> {
        let saved = SavedRegion::read(bytes)?;
        let domain = Domain::parse(saved.domain_text)?;
        let region = Region::parse(&domain, saved.region_text)?;
        // What is taken can be saved and read again.
        let mut again = vec![0; region.saved_len(&domain)];
        let used = region.save::<f64>(&domain, &mut again)?;
        let same = SavedRegion::read(&again[..used])?;
        assert_eq!(Region::parse(&domain, same.region_text), Ok(region));
        Ok(())
    };
    assert_eq!(read(&good), Ok(()));
    for length in 0..good.len() {
        assert!(matches!(read(&good[..length]), Err(Error::Corrupt(_))));
    }
    for bit in 0..8 * good.len() {
        let mut damaged = good.clone();
        damaged[bit / 8] ^= 1 << (bit % 8);
        assert!(
            matches!(read(&damaged), Err(Error::Corrupt(_))),
            "bit {bit}"
        );
        let _ = read(&sealed(&damaged));
    }
}
