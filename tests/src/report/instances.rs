//! What more problem instances teach, with the same number of calls.

use super::interval;
use super::judge::Truth;
use super::runs::{for_seeds, is_exact_in};
use super::scenario::{Scenario, angles, chain, pick};
use crate::room::VersionSpaceRoom;
use critreg::Error;
use critreg::learn::Problem;

/// How many instances are offered.
const OFFERED: [usize; 6] = [4, 8, 16, 64, 256, 1000];
/// Of how many there is room for.
const ROOM: usize = 64;

/// Prints for some scenarios how many regions are exact where a source makes so many instances,
/// of which the learner chooses as many as it has room for.
pub fn print(seeds: usize, first: u64, only: &str) {
    println!("report: instances\nseeds: {seeds}\nroom: {ROOM}");
    let all = [pick(), chain(), interval(), angles()];
    for scenario in all.into_iter().filter(|own| own.name.contains(only)) {
        for offered in OFFERED {
            let exact = for_seeds(seeds, 100, |index| {
                is_exact(&scenario, first + index as u64, offered)
            });
            let exact = exact.iter().filter(|own| **own).count();
            println!("{}_{offered}: {exact}", scenario.name);
        }
    }
}

fn is_exact(scenario: &Scenario, seed: u64, offered: usize) -> bool {
    let truth = Truth::new(scenario, seed);
    let domain = &scenario.domain;
    let source = scenario.draw(seed, offered);
    let length = domain.instance_len();
    let mut chosen = vec![0.0; ROOM.min(offered) * length];
    let mut capacity = scenario.capacity();
    capacity.instances = ROOM;
    let mut room = VersionSpaceRoom::<f64>::new(capacity);
    let mut learner = room
        .learner(domain, scenario.config(seed))
        .expect("enough room");
    let make = |number: usize, instance: &mut [f64]| {
        instance.copy_from_slice(&source[number * length..][..length]);
        Ok::<_, Error>(())
    };
    let count = learner
        .choose_instances(domain, offered, make, &mut chosen)
        .expect("instances");
    let problem = Problem::new(domain, &chosen, count).expect("valid instances");
    is_exact_in(&mut learner, scenario, &truth, seed, &problem)
}
