//! Picking the stick, the learning problem of the thesis (6.3), for host programs.

use critreg::Error;
use critreg::domain::Domain;
use critreg::env::stick_button::{ROBOT, STICK, StickButton};
use critreg::learn::algorithm1::Config;
use critreg::learn::{Algorithm1, Learner, Outcome, Problem, learn_region};
use critreg::random::generator;
use critreg::region::Theta;
use critreg::skill::Context;
use critreg::task::State;

use crate::room::Algorithm1Room;

/// The environment of the thesis: angles off.
pub const ENVIRONMENT: StickButton = StickButton { angles: false };

/// The domain of picking.
pub fn domain() -> Domain<'static> {
    Domain::parse(StickButton::PICK_DOMAIN).expect("the built-in domain text is valid")
}

/// The numbers of `count` random instances with one button.
pub fn instances(seed: u64, count: usize) -> Vec<f64> {
    let mut rng = generator(seed);
    let mut all = Vec::new();
    for _ in 0..count {
        let task = ENVIRONMENT.task(1..=1, &mut rng);
        all.extend_from_slice(task.expect("one button finds room").initial.values());
    }
    all
}

/// The parameters of an action that has one.
pub fn theta(mu: f64) -> Theta {
    [mu, 0.0, 0.0, 0.0, 0.0, 0.0]
}

/// The thesis's set-up: z- = 0.95, z+ = 0.5, K = 100.
pub fn config(seed: u64) -> Config {
    Config {
        seed,
        iterations: 100,
        negative: Some(theta(0.95)),
        positive: Some(theta(0.5)),
    }
}

/// A learner with the thesis's set-up.
pub fn learner<'m>(
    domain: &Domain<'_>,
    seed: u64,
    room: &'m mut Algorithm1Room,
) -> Result<Algorithm1<'m, f64>, Error> {
    let capacity = room.capacity;
    Algorithm1::new(domain, config(seed), capacity, room.lend())
}

/// Asks and tells until the learner is finished, by the simulator.
pub fn run<L: Learner>(learner: &mut L, problem: &Problem<'_>) -> Result<(), Error> {
    let learned = learn_region(learner, problem, |_, query| -> Result<Outcome, Error> {
        ENVIRONMENT.try_pick(problem.instance(query.instance)?, &query.theta)
    });
    match learned {
        Ok(_) | Err(Error::NoRegion) => Ok(()),
        Err(error) => Err(error),
    }
}

/// Who fills the roles of PickStick in a state.
pub fn context(state: &State) -> Context<'_, StickButton> {
    Context {
        environment: &ENVIRONMENT,
        state,
        objects: &[ROBOT, STICK],
        later_objects: &[],
        members: &[],
    }
}
