//! The refinement of a plan skeleton.

use super::config::Config;
use super::metrics::Metrics;
use super::skeleton::Skeleton;
use super::world::{Draw, Drawn, Sampler, World};
use crate::task::{AtomSet, Parameters};
use rand_core::Rng;

/// A step of a plan.
#[derive(Clone, Debug, Default)]
pub struct Step<S, const N: usize = 2> {
    /// The place of its operator among those of the task.
    pub operator: u16,
    /// The parameters of its controller.
    pub parameters: Parameters,
    /// How many actions the controller took.
    pub actions: u32,
    /// The state afterwards.
    pub state: S,
    /// The atoms that must hold afterwards.
    necessary: AtomSet<N>,
    /// How often it was tried since the step before changed.
    tries: u32,
    max_tries: u32,
}

/// What came of a refinement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refinement {
    /// All steps work: the first steps of the memory are the plan.
    Done,
    /// The tries of all steps are spent.
    Failed,
    /// The samples are spent: [`Config::max_samples`].
    SamplesSpent,
    /// It is time to plan without advice: [`Config::patience`].
    PatienceSpent,
    /// The skeleton has more operators than the memory has steps.
    TooLong,
}

/// Looks for the parameters of plan skeletons by chronological backtracking.
///
/// A try of a step works if its controller takes an action, the plan so far has at
/// most [`Config::max_actions`], and the *necessary atoms* hold: the goal,
/// regressed through the rest of the skeleton. A step whose tries are spent begins
/// anew when the step before was tried again.
#[derive(Debug)]
pub struct Refiner<'a, W: World<N>, S, const N: usize = 2> {
    /// Where the steps are tried.
    pub world: &'a mut W,
    /// Where their parameters come from.
    pub sampler: &'a mut S,
    /// The state to begin in.
    pub initial: &'a W::State,
    /// What shall hold in the end.
    pub goal: AtomSet<N>,
    /// The limits.
    pub config: &'a Config,
    /// If a skeleton failed at a step without parameters, after none but such, whose
    /// controller took no action: how many steps these are. No skeleton that begins with
    /// them can be refined.
    pub dead: Option<usize>,
    /// How many steps of the memory are still what they were when they worked, none of them
    /// with parameters: a skeleton that begins with them need not run them again. Zero in
    /// the beginning.
    pub done: usize,
}

/// What came of a try of a step.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Tried {
    Works,
    Fails,
    /// Its controller took no action.
    NoAction,
}

impl<W: World<N>, S: Sampler<W, N>, const N: usize> Refiner<'_, W, S, N> {
    /// Refines a plan skeleton. `steps` becomes the plan if this is
    /// [`Refinement::Done`].
    ///
    /// # Errors
    /// Those of the world and the sampler.
    pub fn refine<R: Rng>(
        &mut self,
        skeleton: Skeleton<'_, N>,
        rng: &mut R,
        steps: &mut [Step<W::State, N>],
        metrics: &mut Metrics<'_>,
    ) -> Result<Refinement, W::Error> {
        let Some(steps) = steps.get_mut(..skeleton.len()) else {
            return Ok(Refinement::TooLong);
        };
        self.done = self.still_done(skeleton, steps);
        self.prepare(skeleton, steps)?;
        self.dead = None;
        let (mut at, mut tried_out) = (self.done, false);
        for (step, operator) in steps.iter_mut().zip(skeleton.iter()).take(self.done) {
            step.tries = step.max_tries;
            if !self.is_good(step)? {
                metrics.fail(operator.operator);
                return Ok(Refinement::Failed);
            }
        }
        while let Some(operator) = skeleton.get(at) {
            let Some((done, [step, ..])) = steps.split_at_mut_checked(at) else {
                break;
            };
            if metrics.is_patience_spent(self.config) {
                return Ok(Refinement::PatienceSpent);
            }
            if metrics.spent().samples >= self.config.max_samples {
                return Ok(Refinement::SamplesSpent);
            }
            let draw = Draw {
                skeleton,
                step: at,
                operator,
                state: done.last().map_or(self.initial, |step| &step.state),
                attempt: step.tries + 1,
                advised: metrics.advised.is_none(),
            };
            let actions = done.iter().map(|step| u64::from(step.actions)).sum();
            let is_fixed = |step: &Step<W::State, N>| step.max_tries == 1;
            let tried = self.try_step(&draw, step, actions, rng, metrics)?;
            if tried == Tried::Works {
                if self.done == at && is_fixed(step) {
                    self.done += 1;
                }
                at += 1;
                continue;
            }
            if tried == Tried::NoAction && is_fixed(step) && done.iter().all(is_fixed) {
                self.dead = Some(at + 1);
            }
            metrics.fail(operator.operator);
            // More tries of a step with parameters might have helped.
            tried_out |= step.max_tries > 1;
            match step_back(steps, at) {
                Some(earlier) => at = earlier,
                None => {
                    metrics.tries_spent += u32::from(tried_out);
                    return Ok(Refinement::Failed);
                }
            }
        }
        Ok(Refinement::Done)
    }

    /// How many steps are done already, and are the first ones of this skeleton. None if
    /// sequences to an abstract state have no bound, so that refinement stays as it was
    /// recorded.
    fn still_done(&self, skeleton: Skeleton<'_, N>, steps: &[Step<W::State, N>]) -> usize {
        if self.config.skeletons_per_state == u32::MAX {
            return 0;
        }
        let known = steps.iter().zip(skeleton.places()).take(self.done);
        known
            .take_while(|(step, place)| step.operator == **place)
            .count()
    }

    /// Sets up the steps: their operators and tries, and from behind their
    /// necessary atoms.
    fn prepare(
        &self,
        skeleton: Skeleton<'_, N>,
        steps: &mut [Step<W::State, N>],
    ) -> Result<(), W::Error> {
        let mut necessary = self.goal;
        let places = steps.iter_mut().zip(skeleton.places());
        for (at, (step, place)) in places.enumerate().rev() {
            let Some(operator) = skeleton.get(at) else {
                continue;
            };
            let sampled = self.world.parameters(operator)? > 0;
            step.operator = *place;
            step.necessary = necessary;
            step.tries = 0;
            step.max_tries = if sampled { self.config.max_tries } else { 1 };
            necessary = operator.regress(necessary);
        }
        Ok(())
    }

    /// Draws parameters of a step and tries them, after so many actions.
    fn try_step<R: Rng>(
        &mut self,
        draw: &Draw<'_, W::State, N>,
        step: &mut Step<W::State, N>,
        actions_before: u64,
        rng: &mut R,
        metrics: &mut Metrics<'_>,
    ) -> Result<Tried, W::Error> {
        step.tries = draw.attempt;
        step.parameters = match self.sampler.sample(draw, rng)? {
            Drawn::Parameters(parameters) => parameters,
            Drawn::Informed(parameters) => {
                metrics.informed_draws += 1;
                parameters
            }
            Drawn::Empty(reason) => {
                step.tries = step.max_tries;
                metrics.empty_draws += 1;
                metrics.blame(reason);
                return Ok(Tried::Fails);
            }
            Drawn::Nothing => {
                // It counts, so that tries without parameters end, too.
                metrics.samples += 1;
                return Ok(Tried::Fails);
            }
        };
        metrics.samples += 1;
        let (operator, before) = (draw.operator, draw.state);
        let after = &mut step.state;
        step.actions = self
            .world
            .execute(operator, &step.parameters, before, after)?;
        let actions = u64::from(step.actions);
        metrics.actions += actions;
        if actions == 0 {
            return Ok(Tried::NoAction);
        }
        if actions_before + actions > u64::from(self.config.max_actions) {
            return Ok(Tried::Fails);
        }
        Ok(match self.is_good(step)? {
            true => Tried::Works,
            false => Tried::Fails,
        })
    }

    /// Whether the necessary atoms hold after a step.
    fn is_good(&mut self, step: &Step<W::State, N>) -> Result<bool, W::Error> {
        for atom in step.necessary.places() {
            if !self.world.holds(atom, &step.state)? {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

/// Where to go on after a try of the step `at` failed: there, or at the last step
/// before that has tries left; those of the steps between begin anew.
fn step_back<S, const N: usize>(steps: &mut [Step<S, N>], at: usize) -> Option<usize> {
    for (place, step) in steps.iter_mut().enumerate().take(at + 1).rev() {
        if step.tries < step.max_tries {
            return Some(place);
        }
        step.tries = 0;
    }
    None
}
