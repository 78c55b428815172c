//! The shelf environment: closed forms of its feasible sets against the simulator, and
//! what its generator promises.

mod feasible_sets;
mod skills;
mod states;

use critreg::env::shelf::{BOX, ROBOT, SHELF, Shelf};
use critreg::random::{Generator, generator};
use critreg::task::{Environment, OperatorId, State, Task, Trial, try_operator};

fn pick(state: &State, theta: [f64; 2]) -> Trial {
    let [operator, _] = Shelf::OPERATORS else {
        panic!()
    };
    try_operator(&Shelf, operator, &[ROBOT, BOX], &theta, state)
}

fn place(state: &State, theta: [f64; 2]) -> Trial {
    let [_, operator] = Shelf::OPERATORS else {
        panic!()
    };
    try_operator(&Shelf, operator, &[ROBOT, BOX, SHELF], &theta, state)
}

fn tasks(seed: u64, count: usize) -> Vec<Task> {
    let mut rng = generator(seed);
    (0..count).map(|_| Shelf.task(&mut rng).unwrap()).collect()
}

/// Parameters from the original sampler.
fn drawn(operator: u8, state: &State, rng: &mut Generator) -> [f64; 2] {
    let objects = [ROBOT, BOX, SHELF];
    let theta = Shelf.sample(OperatorId(operator), state, &objects, rng);
    theta.as_slice().try_into().unwrap()
}
