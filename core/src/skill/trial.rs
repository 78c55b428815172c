//! Trying a setting: the question that the learner of a skill asks.

use super::{Describe, Informed, MAX_CHAIN, Setting, Skills};
use crate::domain::MAX_PARAMETERS;
use crate::error::Error;
use crate::learn::Outcome;
use crate::plan::{Draw, Drawn, Sampler, Skeleton};
use crate::random::Generator;
use crate::region::Theta;
use crate::task::{GroundOperator, Parameters, State, try_operator};

/// How often operators whose parameters are free are tried before they count as
/// impossible.
const TRIES: u32 = 2;

/// What came of an operator.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Tried {
    /// It works.
    Works,
    /// It does not.
    Fails,
    /// It is known that no parameters work; it was not run.
    Impossible,
}

impl GroundOperator {
    /// Parameters of the original sampler.
    pub(super) fn propose<E: Describe>(
        &self,
        environment: &E,
        state: &State,
        rng: &mut Generator,
    ) -> Theta {
        let drawn = completed(environment, self, state, &[], rng);
        let mut theta = [0.0; MAX_PARAMETERS];
        for (value, drawn) in theta.iter_mut().zip(&drawn) {
            *value = *drawn;
        }
        theta
    }
}

impl Skills<'_> {
    /// Tries a setting with parameters of its operator; those of the operators after it
    /// are drawn from what is known, and so are its own if there are none. Returns also
    /// how many controllers were run.
    ///
    /// # Errors
    /// [`Error::Mismatch`] if an operator is not of this environment, and those of
    /// [`Informed`].
    pub fn attempt<E: Describe>(
        &mut self,
        environment: &E,
        setting: &Setting,
        theta: Option<&[f64]>,
        rng: &mut Generator,
    ) -> Result<(Outcome, u32), Error> {
        let (mut answer, mut runs) = (Outcome::FailedStep(1), 0);
        let (mut after, mut tried) = (setting.state.clone(), Tried::Fails);
        for attempt in 1..=TRIES {
            // Given parameters need no second run.
            if theta.is_none() || attempt == 1 {
                after.clone_from(&setting.state);
                tried = self.step(environment, setting, (0, &mut after), theta, attempt, rng)?;
                runs += u32::from(tried != Tried::Impossible);
            }
            if tried != Tried::Works {
                continue;
            }
            answer = Outcome::FailedStep(2);
            let (works, more, decided) = self.rest(environment, setting, &after, attempt, rng)?;
            runs += more;
            if works {
                return Ok((Outcome::Feasible, runs));
            }
            if decided && theta.is_some() {
                break;
            }
        }
        Ok((answer, runs))
    }

    /// Tries the operators after the first. Returns whether all work, how many
    /// controllers were run, and whether another try can only fail again.
    fn rest<E: Describe>(
        &mut self,
        environment: &E,
        setting: &Setting,
        state: &State,
        attempt: u32,
        rng: &mut Generator,
    ) -> Result<(bool, u32, bool), Error> {
        let (mut state, mut runs, mut decided) = (state.clone(), 0, true);
        for (step, ground) in setting.steps.iter().enumerate().skip(1) {
            match self.step(environment, setting, (step, &mut state), None, attempt, rng)? {
                Tried::Works => {}
                Tried::Fails => {
                    decided &= !is_sampled(environment, ground)?;
                    return Ok((false, runs + 1, decided));
                }
                Tried::Impossible => return Ok((false, runs, decided)),
            }
            runs += 1;
            decided &= !is_sampled(environment, ground)?;
        }
        Ok((true, runs, true))
    }

    /// Runs an operator of a setting and notes what it changes. If it works the state
    /// becomes the one afterwards.
    fn step<E: Describe>(
        &mut self,
        environment: &E,
        setting: &Setting,
        (step, state): (usize, &mut State),
        theta: Option<&[f64]>,
        attempt: u32,
        rng: &mut Generator,
    ) -> Result<Tried, Error> {
        let Some(ground) = setting.steps.get(step) else {
            return Ok(Tried::Impossible);
        };
        let parameters = match theta {
            Some(theta) => completed(environment, ground, state, theta, rng),
            None => {
                let places: [u16; MAX_CHAIN] = core::array::from_fn(|place| place as u16);
                let places = places.get(..setting.steps.len()).unwrap_or_default();
                let draw = Draw {
                    skeleton: Skeleton::new(&setting.steps, places),
                    step,
                    operator: ground,
                    state,
                    attempt,
                    advised: true,
                };
                let mut informed = Informed::new(environment, self, &setting.state);
                match informed.sample(&draw, rng)? {
                    Drawn::Parameters(drawn) | Drawn::Informed(drawn) => drawn,
                    Drawn::Empty(_) => return Ok(Tried::Impossible),
                }
            }
        };
        let (operator, objects) = (environment.operator(ground)?, ground.objects.as_slice());
        let outcome = try_operator(environment, operator, objects, &parameters, state);
        if !outcome.is_feasible() {
            return Ok(Tried::Fails);
        }
        let arguments = operator.controller_objects(objects)?;
        if let Some(changes) = self.changes_mut(operator.controller) {
            changes.observe(arguments.as_slice(), state, &outcome.state);
        }
        *state = outcome.state;
        Ok(Tried::Works)
    }
}

/// The first parameters, and behind them those of the original sampler.
pub(super) fn completed<E: Describe, R: rand_core::Rng>(
    environment: &E,
    ground: &GroundOperator,
    state: &State,
    first: &[f64],
    rng: &mut R,
) -> Parameters {
    let objects = ground.objects.as_slice();
    let mut parameters = environment.sample(ground.operator, state, objects, rng);
    for (value, given) in parameters.iter_mut().zip(first) {
        *value = *given;
    }
    parameters
}

fn is_sampled<E: Describe>(environment: &E, ground: &GroundOperator) -> Result<bool, Error> {
    let operator = environment.operator(ground)?;
    let controller = environment.controller(operator.controller)?;
    Ok(!controller.parameters.is_empty())
}
