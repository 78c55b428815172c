//! Choosing instances of a source that makes thousands.

use crate::shelf::{SHELF, go_on, room, shelves};
use critreg::Error;
use critreg::domain::Domain;
use critreg::learn::version_space::Config;
use critreg::learn::{Learner, Problem};

const LENGTH: usize = 4;

/// What a source of these instances does when it is asked for one.
fn source(instances: &[f64]) -> impl FnMut(usize, &mut [f64]) -> Result<(), Error> + '_ {
    |number, instance| {
        instance.copy_from_slice(&instances[LENGTH * number..][..LENGTH]);
        Ok(())
    }
}

fn choose(instances: &[f64], wanted: usize) -> Result<Vec<f64>, Error> {
    let domain = Domain::parse(SHELF).unwrap();
    let mut room = room(64);
    let mut learner = room.learner(&domain, Config::default()).unwrap();
    let mut chosen = vec![0.0; LENGTH * wanted];
    let count = instances.len() / LENGTH;
    let found = learner.choose_instances(&domain, count, source(instances), &mut chosen)?;
    chosen.truncate(LENGTH * found);
    Ok(chosen)
}

#[test]
fn what_stands_out_is_chosen() {
    let mut instances = shelves(1, 400);
    // In one of them, the cup is far above all others.
    instances[LENGTH * 333 + 1] = 9.0;
    let chosen = choose(&instances, 8).unwrap();
    assert_eq!(chosen.len(), LENGTH * 8);
    let each: Vec<_> = chosen.chunks(LENGTH).collect();
    assert!(each.iter().any(|own| own[1] == 9.0));
    for own in &each {
        let mut source = instances.chunks(LENGTH);
        assert!(source.any(|made| made == *own));
        assert_eq!(each.iter().filter(|other| *other == own).count(), 1);
    }
    assert_eq!(choose(&instances, 8).unwrap(), chosen);
}

#[test]
fn all_are_chosen_where_there_is_room() {
    let instances = shelves(2, 5);
    assert_eq!(choose(&instances, 5).unwrap(), instances);
    assert_eq!(choose(&instances, 12).unwrap(), instances);
    // The learner has room for 16.
    assert_eq!(choose(&shelves(2, 100), 40).unwrap().len(), 16 * LENGTH);
}

#[test]
fn misuse_is_refused_and_changes_nothing() {
    assert!(matches!(choose(&[], 4), Err(Error::InvalidArgument(_))));
    let instances = shelves(3, 40);
    assert!(matches!(
        choose(&instances, 0),
        Err(Error::InvalidArgument(_))
    ));
    let mut broken = instances.clone();
    broken[LENGTH * 39] = f64::NAN;
    assert!(matches!(choose(&broken, 4), Err(Error::NotFinite(_))));

    let domain = Domain::parse(SHELF).unwrap();
    let (mut first, mut second) = (room(64), room(64));
    let mut learner = first.learner(&domain, Config::default()).unwrap();
    let mut other = second.learner(&domain, Config::default()).unwrap();
    let mut chosen = [0.0; 4 * LENGTH];
    let stops = |number: usize, _: &mut [f64]| match number {
        0..20 => Ok(()),
        _ => Err(Error::NoSample),
    };
    let stopped = learner.choose_instances(&domain, 40, stops, &mut chosen);
    assert_eq!(stopped, Err(Error::NoSample));
    // It learns as one that never chose.
    let problem = Problem::new(&domain, &instances[..8 * LENGTH], 8).unwrap();
    go_on(&mut learner, &problem, 40);
    go_on(&mut other, &problem, 40);
    assert_eq!(learner.observations(), other.observations());
    let late = learner.choose_instances(&domain, 40, source(&instances), &mut chosen);
    assert!(matches!(late, Err(Error::OutOfSequence(_))));
}
