//! What the tests of runs learn about: a hand left of a cup and above a shelf.

use critreg::learn::version_space::Capacity;
use critreg::learn::{Learner, Outcome, Problem, Query, save, saved_len};
use critreg::random::{generator, uniform_in};
use critreg_tests::room::VersionSpaceRoom;

pub(crate) const SHELF: &str = "
    object cup   { x: length, y: length }
    object shelf { x: length, y: length }
    constant margin = 0.25: length
    parameter px in [0, 4]: length
    parameter py in [0, 4]: length
    point hand = world + (px, py)
";

pub(crate) fn room(observations: usize) -> VersionSpaceRoom {
    VersionSpaceRoom::new(Capacity {
        instances: 16,
        ..Capacity::new(4096, observations)
    })
}

/// The numbers of so many instances.
pub(crate) fn shelves(seed: u64, count: usize) -> Vec<f64> {
    let mut rng = generator(seed);
    let numbers = 0..4 * count;
    numbers.map(|_| uniform_in(&mut rng, 0.5, 3.5)).collect()
}

/// Left of the cup, and above the shelf.
pub(crate) fn fits(problem: &Problem<'_>, query: &Query) -> Outcome {
    let [cup_x, _, _, shelf_y] = *problem.instance(query.instance).unwrap() else {
        panic!("four numbers")
    };
    let [x, y, ..] = query.theta;
    Outcome::from_feasible(x <= cup_x - 0.25 && y >= shelf_y + 0.25)
}

pub(crate) fn saved(learner: &impl Learner, problem: &Problem<'_>) -> Vec<u8> {
    let mut bytes = vec![0; saved_len(learner, problem)];
    assert_eq!(save(learner, problem, &mut bytes).unwrap(), bytes.len());
    bytes
}

/// Asks and tells so often.
pub(crate) fn go_on(learner: &mut impl Learner, problem: &Problem<'_>, calls: usize) {
    for _ in 0..calls {
        let query = learner.ask(problem).unwrap();
        learner.tell(problem, fits(problem, &query)).unwrap();
    }
}
