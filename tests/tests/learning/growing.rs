//! Runs that grow: more calls, a larger memory, more instances.

use crate::shelf::{SHELF, go_on, room, saved, shelves};
use critreg::Error;
use critreg::domain::Domain;
use critreg::learn::version_space::{Capacity, Config, Quality};
use critreg::learn::{
    Learner, Problem, VersionSpace, journal, journal_len, resume, resume_journal,
};
use critreg_tests::room::VersionSpaceRoom;
use proptest::prelude::*;

const INSTANCES: usize = 12;

fn config(seed: u64, calls: u32) -> Config {
    Config {
        seed,
        calls,
        ..Config::default()
    }
}

/// The problem of the first so many instances.
fn problem<'p>(domain: &'p Domain<'p>, shelves: &'p [f64], count: usize) -> Problem<'p> {
    Problem::new(domain, &shelves[..4 * count], count).unwrap()
}

#[test]
fn a_run_goes_on_with_more_calls_in_a_larger_memory() {
    let domain = Domain::parse(SHELF).unwrap();
    let shelves = shelves(1, INSTANCES);
    let problem = problem(&domain, &shelves, 8);
    let (mut small, mut large) = (room(20), room(100));
    let capacity = small.capacity;
    let mut short = VersionSpace::new(&domain, config(1, 20), capacity, small.lend()).unwrap();
    go_on(&mut short, &problem, 20);
    assert!(short.is_finished());
    assert_ne!(short.quality(), Quality::Exact);
    let bytes = saved(&short, &problem);

    let capacity = large.capacity;
    let mut long = VersionSpace::new(&domain, config(1, 100), capacity, large.lend()).unwrap();
    resume(&mut long, &problem, &bytes).unwrap();
    let told = |learner: &VersionSpace<'_, f64>| {
        let all = learner.observations().iter();
        all.map(|o| (o.query(), o.outcome)).collect::<Vec<_>>()
    };
    assert_eq!(told(&long), told(&short));
    go_on(&mut long, &problem, 80);
    assert!(long.is_finished());
    assert_eq!(long.quality(), Quality::Exact);
    assert_eq!(long.report().calls, 100);
}

#[test]
fn only_appended_instances_are_the_same_problem() {
    let domain = Domain::parse(SHELF).unwrap();
    let shelves = shelves(1, INSTANCES);
    let mut room = VersionSpaceRoom::<f64>::new(Capacity {
        instances: 8,
        ..Capacity::new(4096, 100)
    });
    let capacity = room.capacity;
    let mut learner = VersionSpace::new(&domain, config(1, 100), capacity, room.lend()).unwrap();
    let begun = problem(&domain, &shelves, 4);
    go_on(&mut learner, &begun, 30);
    let bytes = saved(&learner, &begun);
    let mut others = shelves.clone();
    others[0] += 0.1;
    for changed in [problem(&domain, &others, 8), problem(&domain, &shelves, 3)] {
        assert!(matches!(learner.ask(&changed), Err(Error::Mismatch(_))));
        assert!(matches!(
            learner.conclude(&changed),
            Err(Error::Mismatch(_))
        ));
    }
    let many = problem(&domain, &shelves, 9);
    assert_eq!(
        learner.ask(&many),
        Err(Error::CapacityExceeded("problem instances"))
    );
    assert_eq!(saved(&learner, &begun), bytes);
    let more = problem(&domain, &shelves, 8);
    go_on(&mut learner, &more, 70);
    assert_eq!(learner.quality(), Quality::Exact);
    assert!(matches!(learner.ask(&begun), Err(Error::Mismatch(_))));
}

fn appended(learner: &VersionSpace<'_, f64>, problem: &Problem<'_>, from: usize) -> Vec<u8> {
    let mut bytes = vec![0; journal_len(learner, problem, from)];
    journal(learner, problem, from, &mut bytes).unwrap();
    bytes
}

#[test]
fn a_journal_is_checked() {
    let domain = Domain::parse(SHELF).unwrap();
    let shelves = shelves(1, INSTANCES);
    let problem = problem(&domain, &shelves, 4);
    let (mut first, mut second) = (room(100), room(100));
    let capacity = first.capacity;
    let mut learner = VersionSpace::new(&domain, config(1, 100), capacity, first.lend()).unwrap();
    go_on(&mut learner, &problem, 3);
    let bytes = appended(&learner, &problem, 0);
    let record = bytes.len() / 3;
    assert_eq!(appended(&learner, &problem, 2), bytes[2 * record..]);
    assert!(journal(&learner, &problem, 0, &mut [0; 8]).is_err());
    let used = resume_journal(&mut learner, &problem, &bytes);
    assert!(matches!(used, Err(Error::OutOfSequence(_))));
    let mut resumed = |seed: u64, bytes: &[u8]| {
        let mut fresh =
            VersionSpace::new(&domain, config(seed, 100), capacity, second.lend()).unwrap();
        let stands = resume_journal(&mut fresh, &problem, bytes);
        (stands, fresh.observations().len())
    };
    // Whatever is torn or damaged, what is before it stands.
    for at in 0..bytes.len() {
        let whole = at / record;
        assert_eq!(resumed(1, &bytes[..at]), (Ok(whole * record), whole));
        let mut damaged = bytes.clone();
        damaged[at] ^= 0x10;
        assert_eq!(resumed(1, &damaged), (Ok(whole * record), whole));
    }
    assert_eq!(resumed(1, &bytes), (Ok(3 * record), 3));
    assert!(matches!(resumed(2, &bytes), (Err(Error::Mismatch(_)), 0)));
    assert!(matches!(
        resumed(1, &bytes[record..]),
        (Err(Error::Corrupt(_)), 0)
    ));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn a_journal_and_a_saved_run_resume_the_same(
        seed in any::<u64>(), few in 0usize..30, before in 0usize..30, after in 0usize..30,
    ) {
        let domain = Domain::parse(SHELF).unwrap();
        let shelves = shelves(seed, INSTANCES);
        let mut written = Vec::new();
        let (mut first, mut second) = (room(100), room(100));
        let capacity = first.capacity;
        let mut going =
            VersionSpace::new(&domain, config(seed, 100), capacity, first.lend()).unwrap();
        let more = problem(&domain, &shelves, INSTANCES);
        for (count, calls) in [(3, few), (INSTANCES, before)] {
            let problem = problem(&domain, &shelves, count);
            for _ in 0..calls {
                let told = going.observations().len();
                go_on(&mut going, &problem, 1);
                written.extend(appended(&going, &problem, told));
            }
        }
        let mut resumed =
            VersionSpace::new(&domain, config(seed, 100), capacity, second.lend()).unwrap();
        prop_assert_eq!(resume_journal(&mut resumed, &more, &written), Ok(written.len()));
        go_on(&mut going, &more, after);
        go_on(&mut resumed, &more, after);
        prop_assert_eq!(going.observations(), resumed.observations());
        prop_assert_eq!(going.region(), resumed.region());
    }

    /// A learner knows what follows from what was told and the instances there are.
    #[test]
    fn it_makes_no_difference_when_instances_arrive(
        seed in any::<u64>(), before in 0usize..50, asked in any::<bool>(), after in 1usize..40,
    ) {
        let domain = Domain::parse(SHELF).unwrap();
        let shelves = shelves(seed, INSTANCES);
        let few = problem(&domain, &shelves, 3);
        let more = problem(&domain, &shelves, INSTANCES);
        let (mut first, mut second) = (room(100), room(100));
        let capacity = first.capacity;
        let mut going =
            VersionSpace::new(&domain, config(seed, 100), capacity, first.lend()).unwrap();
        go_on(&mut going, &few, before);
        if asked {
            going.ask(&few).unwrap();
        }
        let bytes = saved(&going, &few);
        let mut resumed =
            VersionSpace::new(&domain, config(seed, 100), capacity, second.lend()).unwrap();
        resume(&mut resumed, &more, &bytes).unwrap();
        go_on(&mut going, &more, after);
        go_on(&mut resumed, &more, after);
        prop_assert_eq!(going.observations(), resumed.observations());
        prop_assert_eq!(going.region(), resumed.region());
        prop_assert_eq!(going.report(), resumed.report());
    }
}
