//! The oracle that the learner of a skill asks.

use super::situation::{MAX_CHAIN, Situation, controller_objects};
use crate::error::Error;
use crate::learn::Outcome;
use crate::plan::{Draw, Drawn, Skeleton};
use crate::random::Generator;
use crate::skill::changes::Changes;
use crate::skill::context::Context;
use crate::skill::effects::{Runs, terms};
use crate::skill::planning::{RegionSampler, completed};
use crate::skill::setting::{Practice, Said, Setting};
use crate::skill::skills::{Library, Skill, Skills};
use crate::skill::tuning::TRIES;
use crate::task::{GroundOperator, MAX_STATE_VALUES, State};

/// Answers whether parameters are feasible in a situation, by running controllers (the
/// simulator of thesis 4.3). What they change is noted.
#[derive(Debug)]
pub struct Oracle<'a, E> {
    environment: &'a E,
    library: Library<'a>,
    changes: &'a mut [Changes],
    watched: Option<Watched<'a>>,
    runs: u32,
}

/// A skill whose runs are noted, to see where its controller leaves things.
#[derive(Debug)]
struct Watched<'a> {
    skill: &'a Skill,
    runs: &'a mut Runs,
}

/// What came of operators.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Tried {
    /// They work.
    Works,
    /// They do not, with the parameters that were drawn.
    Fails,
    /// They do not with any: so one need not run.
    Impossible,
}

impl<'a, E: Practice> Oracle<'a, E> {
    /// An oracle that draws parameters that are free from what is known so far.
    pub fn new(environment: &'a E, skills: &'a mut Skills<'_>) -> Self {
        Oracle::from_known(environment, skills.known_mut())
    }

    pub(super) fn from_known(
        environment: &'a E,
        (library, changes): (Library<'a>, &'a mut [Changes]),
    ) -> Self {
        Oracle {
            environment,
            library,
            changes,
            watched: None,
            runs: 0,
        }
    }

    /// Notes the runs of a skill's controller from now on.
    pub(super) fn watch(&mut self, skill: &'a Skill, runs: &'a mut Runs) {
        self.watched = Some(Watched { skill, runs });
    }

    /// How many controllers were run.
    pub fn runs(&self) -> u32 {
        self.runs
    }

    /// Tries parameters of the first operator of a situation; those of the operators after
    /// it are drawn from what is known, and so are its own if there are none.
    ///
    /// Of a failure it tells that the first step failed, or the second one if any operator
    /// after it did.
    ///
    /// # Errors
    /// [`Error::Mismatch`] if an operator is not of this environment, and those of
    /// [`RegionSampler`].
    pub fn answer(
        &mut self,
        situation: &Situation,
        theta: Option<&[f64]>,
        rng: &mut Generator,
    ) -> Result<Outcome, Error> {
        let (mut outcome, mut first) = (Outcome::FailedStep(1), Tried::Fails);
        let mut after = situation.state.clone();
        let mut free = theta.is_some();
        for ground in &situation.steps {
            free |= is_sampled(self.environment, ground)?;
        }
        // Without parameters it would be the same again.
        for attempt in 1..=if free { TRIES } else { 1 } {
            // Given parameters need no second run.
            if theta.is_none() || attempt == 1 {
                after.clone_from(&situation.state);
                first = self.step(situation, (0, &mut after), theta, attempt, rng)?;
            }
            if first != Tried::Works {
                continue;
            }
            outcome = Outcome::FailedStep(2);
            match self.rest(situation, after.clone(), attempt, rng)? {
                Tried::Works => return Ok(Outcome::Feasible),
                Tried::Impossible if theta.is_some() => break,
                Tried::Fails | Tried::Impossible => {}
            }
        }
        Ok(outcome)
    }

    /// Tries the operators after the first.
    fn rest(
        &mut self,
        situation: &Situation,
        mut state: State,
        attempt: u32,
        rng: &mut Generator,
    ) -> Result<Tried, Error> {
        let mut drawn = false;
        for (step, ground) in situation.steps.iter().enumerate().skip(1) {
            let tried = self.step(situation, (step, &mut state), None, attempt, rng)?;
            drawn |= tried != Tried::Impossible && is_sampled(self.environment, ground)?;
            if tried != Tried::Works {
                return Ok(if drawn {
                    Tried::Fails
                } else {
                    Tried::Impossible
                });
            }
        }
        Ok(Tried::Works)
    }

    /// Runs an operator of a situation and notes what it changes. If it works the state
    /// becomes the one afterwards.
    fn step(
        &mut self,
        situation: &Situation,
        (step, state): (usize, &mut State),
        theta: Option<&[f64]>,
        attempt: u32,
        rng: &mut Generator,
    ) -> Result<Tried, Error> {
        let (environment, Some(ground)) = (self.environment, situation.steps.get(step)) else {
            return Ok(Tried::Impossible);
        };
        let parameters = match theta {
            Some(theta) => completed(environment, ground, state, theta, rng),
            None => match self.draw(situation, (step, state), attempt, rng)? {
                Drawn::Parameters(drawn) | Drawn::Informed(drawn) => drawn,
                Drawn::Empty(_) | Drawn::Nothing => return Ok(Tried::Impossible),
            },
        };
        let mut after = state.clone();
        let works = environment.try_operator(ground, &parameters, &mut after)?;
        self.runs += 1;
        if !works {
            return Ok(Tried::Fails);
        }
        let (controller, objects) = environment.call(ground.operator, ground.objects.as_slice())?;
        if let Some(changes) = self.changes.get_mut(usize::from(controller.0)) {
            changes.observe(objects.as_slice(), state, &after);
            observe_atoms(environment, ground, &after, changes)?;
        }
        if let Some(watched) = self.watched.as_mut().filter(|_| step == 0) {
            watched.note(environment, situation, &parameters, &after)?;
        }
        *state = after;
        Ok(Tried::Works)
    }

    /// Draws parameters of a step, with those of the steps after it in view.
    fn draw(
        &self,
        situation: &Situation,
        (step, state): (usize, &State),
        attempt: u32,
        rng: &mut Generator,
    ) -> Result<Drawn, Error> {
        let places: [u16; MAX_CHAIN] = core::array::from_fn(|place| place as u16);
        let places = places.get(..situation.steps.len()).unwrap_or_default();
        let skeleton = Skeleton::new(&situation.steps, places);
        let Some(operator) = skeleton.get(step) else {
            return Err(Error::InvalidArgument("a situation has no such step"));
        };
        let draw = Draw {
            skeleton,
            step,
            operator,
            state,
            attempt,
            advised: true,
        };
        let sampler = RegionSampler::from_library(self.environment, self.library);
        match sampler.advise(&draw, rng)? {
            Some(drawn) => Ok(drawn),
            None => {
                let original = completed(self.environment, operator, state, &[], rng);
                Ok(Drawn::Parameters(original))
            }
        }
    }
}

/// Notes which atoms that an operator needs still hold after it, of those that it does not
/// say to end.
fn observe_atoms(
    environment: &impl Practice,
    ground: &GroundOperator,
    after: &State,
    changes: &mut Changes,
) -> Result<(), Error> {
    let mut result = Ok(());
    environment.visit_atoms(
        ground.operator,
        ground.objects.as_slice(),
        &mut |said, atom| {
            if said == Said::Stays && result.is_ok() {
                let holds = environment.holds(&atom, after);
                result = holds.map(|holds| changes.observe_atom(atom.predicate, holds));
            }
        },
    );
    result
}

/// Whether the controller of an operator has parameters.
fn is_sampled(environment: &impl Setting, ground: &GroundOperator) -> Result<bool, Error> {
    let (controller, _) = environment.call(ground.operator, ground.objects.as_slice())?;
    Ok(environment.signature(controller)?.parameters > 0)
}

impl Watched<'_> {
    /// Notes a run of the first operator of a situation.
    fn note(
        &mut self,
        environment: &impl Setting,
        situation: &Situation,
        parameters: &[f64],
        after: &State,
    ) -> Result<(), Error> {
        let mut numbers = [0.0; MAX_STATE_VALUES];
        let (Some(instance), Some(ground)) = (
            numbers.get_mut(..self.skill.binding().len()),
            situation.steps.first(),
        ) else {
            return Ok(());
        };
        situation.instance(environment, self.skill, instance)?;
        let terms = terms(self.skill.domain(), instance, parameters)?;
        let objects = controller_objects(environment, ground)?;
        let context = Context {
            environment,
            state: after,
            objects: objects.as_slice(),
            later_objects: &[],
            members: self.skill.description().members,
        };
        self.skill.binding().instance(&context, instance)?;
        self.runs.note(terms, instance);
        Ok(())
    }
}
