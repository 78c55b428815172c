//! Planning with regions.

use super::joint_region::JointRegion;
use crate::error::Error;
use crate::plan::{Advice, Draw, Drawn, Guide, ReasonId, Sampler, Simulated, Skeleton};
use crate::random::uniform;
use crate::skill::training::completed;
use crate::skill::{Context, Describe, Skill, Skills};
use crate::task::{Arguments, Controller, ControllerId, GroundOperator, State};
use rand_core::Rng;

/// An environment's sampler and guide that know its skills.
///
/// As a sampler it draws the parameters of a step where its region, in the state before
/// it, and those of later steps meet: of all up to one with parameters that handles its
/// objects again, which decides anew. Where nothing is known it is the original sampler.
///
/// As a guide it judges a sequence of operators whose last one does not work, or with no
/// parameters of some step before, in the state that is expected there: the initial one,
/// with what the steps before are known to change. It does so only as far as regions
/// read nothing that cannot be told.
///
/// The reason that it gives is the place of the ground operator that cannot work;
/// [`Informed::explain`] has the text.
#[derive(Debug)]
pub struct Informed<'a, E> {
    /// The environment.
    pub environment: &'a E,
    /// What is known of it.
    pub skills: &'a Skills<'a>,
    /// The initial state of the task.
    pub initial: &'a State,
    /// Whether to prune what cannot work, and not only to postpone it.
    pub prune: bool,
    /// The share of an interval that is left out at both ends in the first try of a
    /// step, in `[0, 0.5]`: an action may fail close to the boundary.
    pub margin: f64,
    /// Tries of a step that are drawn from regions. If none of them works, it is not the
    /// parameters that are wrong.
    pub tries: u32,
    /// The share of draws that are from everything, in `[0, 1]`, so that no parameters
    /// are out of reach. Without any they are until patience ends: see
    /// [`Config::patience`](crate::plan::Config::patience).
    pub everywhere: f64,
}

impl<E> Clone for Informed<'_, E> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<E> Copy for Informed<'_, E> {}

impl<'a, E: Describe> Informed<'a, E> {
    /// What is known of an environment, for a task with this initial state.
    pub fn new(environment: &'a E, skills: &'a Skills<'a>, initial: &'a State) -> Self {
        Informed {
            environment,
            skills,
            initial,
            prune: false,
            margin: 0.1,
            tries: 3,
            everywhere: 0.0,
        }
    }

    /// The controller of a ground operator and its objects.
    pub(super) fn run(&self, ground: &GroundOperator) -> Option<Run<E>> {
        let operator = self.environment.operator(ground).ok()?;
        Some(Run {
            id: operator.controller,
            controller: self.environment.controller(operator.controller).ok()?,
            objects: operator
                .controller_objects(ground.objects.as_slice())
                .ok()?,
        })
    }

    /// The regions of a step, and those of later steps, in a state before the first; only
    /// those of which `counts` is true.
    pub(super) fn joint(
        &self,
        skeleton: Skeleton<'_>,
        state: &State,
        counts: impl Fn(&Skill, &Context<'_, E>) -> bool,
    ) -> JointRegion<'a> {
        let mut joint = JointRegion::default();
        let mut runs = skeleton.iter().map_while(|ground| self.run(ground));
        let Some(own) = runs.next() else {
            return joint;
        };
        let none = Arguments::default();
        self.add(&mut joint, (&own, 0), (None, &none), state, &counts);
        if own.controller.parameters.is_empty() {
            return joint;
        }
        for (step, later) in (1..).zip(runs) {
            let about = (Some(later.id), &later.objects);
            self.add(&mut joint, (&own, step), about, state, &counts);
            if later.decides_anew(&own) {
                break;
            }
        }
        joint
    }

    /// Adds what is known of a controller, or of it and a later one.
    fn add(
        &self,
        joint: &mut JointRegion<'a>,
        (own, step): (&Run<E>, usize),
        (id, later): (Option<ControllerId>, &Arguments),
        state: &State,
        counts: impl Fn(&Skill, &Context<'_, E>) -> bool,
    ) {
        let known = self.skills.about(own.id, id);
        for skill in known.filter(|skill| skill.region.is_some()) {
            let context = Context {
                environment: self.environment,
                state,
                own: own.objects.as_slice(),
                later: later.as_slice(),
                among: skill.description.among,
            };
            if counts(skill, &context) {
                joint.add(skill, step, |out| skill.binding.instance(&context, out));
            }
        }
    }

    /// The state that is expected after these steps, and a bit for each number of it that
    /// cannot be told.
    fn expected(&self, before: Skeleton<'_>) -> (State, u64) {
        let (mut state, mut unknown) = (self.initial.clone(), 0);
        for ground in before.iter() {
            match self.run(ground) {
                Some(run) => {
                    let changes = self.skills.changes(run.id);
                    changes.predict(run.objects.as_slice(), &mut state, &mut unknown);
                }
                None => unknown = u64::MAX,
            }
        }
        (state, unknown)
    }

    /// Whether the last operator of a sequence cannot work.
    fn is_blocked(&self, prefix: Skeleton<'_>) -> Result<bool, Error> {
        let Some(last) = prefix.len().checked_sub(1) else {
            return Ok(false);
        };
        for own in 0..=last {
            if !self.is_known(prefix, own) {
                continue;
            }
            let (state, unknown) = self.expected(prefix.until(own));
            let joint = self.joint(prefix.from(own), &state, |skill, context| {
                skill.is_settled(context, unknown)
            });
            if joint.are_apart(joint.skills.len())? {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Whether something is known of a step and the last one of a sequence, or of that
    /// one alone.
    fn is_known(&self, prefix: Skeleton<'_>, step: usize) -> bool {
        let run = |ground: Option<_>| ground.and_then(|ground| self.run(ground));
        let (Some(own), later) = (run(prefix.get(step)), prefix.from(step + 1)) else {
            return false;
        };
        let last = run(later.iter().next_back()).map(|last| last.id);
        let mut known = self.skills.about(own.id, last);
        known.any(|skill| skill.region.is_some())
    }
}

impl Skill {
    /// Whether all that its region reads can be told; `unknown` has a bit for each number
    /// of the state that cannot.
    fn is_settled<E: Describe>(&self, context: &Context<'_, E>, unknown: u64) -> bool {
        let is_unknown = |object, attribute| {
            let number = context
                .state
                .place(object)
                .map_or(63, |first| first + attribute);
            unknown >> number.min(63) & 1 == 1
        };
        let mut read = (0..self.binding.len()).filter(|slot| self.reads >> slot & 1 == 1);
        unknown == 0
            || read.all(|slot| {
                let source = self.binding.source(slot, context);
                let own = source.is_none_or(|(object, attribute)| !is_unknown(object, attribute));
                // Who is a member at all may depend on anything.
                let kind = self.binding.kind_of_members(slot);
                let kind = kind.filter(|kind| context.is_narrowed(*kind));
                let mut members = kind
                    .into_iter()
                    .flat_map(|kind| context.state.of_type(kind));
                own && !members.any(|object| {
                    let count = context.state.attributes(object).map_or(0, <[f64]>::len);
                    (0..count).any(|attribute| is_unknown(object, attribute))
                })
            })
    }
}

/// A controller that is run.
pub(super) struct Run<E: Describe> {
    pub(super) id: ControllerId,
    pub(super) controller: &'static Controller<E>,
    pub(super) objects: Arguments,
}

impl<E: Describe> Run<E> {
    /// Whether its parameters count from now on, instead of those of an earlier one.
    fn decides_anew(&self, earlier: &Run<E>) -> bool {
        let mut objects = self.objects.as_slice().iter();
        !self.controller.parameters.is_empty()
            && objects.any(|object| earlier.objects.as_slice().contains(object))
    }
}

impl<E: Describe> Guide for Informed<'_, E> {
    fn judge(&mut self, prefix: Skeleton<'_>) -> Advice {
        // What cannot be evaluated is no reason to drop anything.
        if !self.is_blocked(prefix).unwrap_or(false) {
            return Advice::Keep;
        }
        let reason = reason(prefix, prefix.len().saturating_sub(1));
        if self.prune {
            Advice::Prune(reason)
        } else {
            Advice::Postpone(reason)
        }
    }
}

impl<E: Describe> Sampler<Simulated<'_, E>> for Informed<'_, E> {
    fn sample<R: Rng>(&mut self, draw: &Draw<'_, State>, rng: &mut R) -> Result<Drawn, Error> {
        let everywhere = self.everywhere > 0.0 && uniform(rng) < self.everywhere;
        if draw.advised && !everywhere {
            let joint = self.joint(draw.skeleton.from(draw.step), draw.state, |_, _| true);
            if let Some(drawn) = self.draw(&joint, draw, rng)? {
                return Ok(drawn);
            }
        }
        let drawn = completed(self.environment, draw.operator, draw.state, &[], rng);
        Ok(Drawn::Parameters(drawn))
    }
}

impl<E: Describe> Informed<'_, E> {
    /// Draws where the regions meet; `None` if nothing is known.
    fn draw<R: Rng>(
        &self,
        joint: &JointRegion<'_>,
        draw: &Draw<'_, State>,
        rng: &mut R,
    ) -> Result<Option<Drawn>, Error> {
        let run = self.run(draw.operator);
        let sampled = run.is_some_and(|run| !run.controller.parameters.is_empty());
        if joint.skills.is_empty() {
            return Ok(None);
        }
        if sampled && joint.parameters() == 0 {
            // What is known is about the state, and leaves the parameters free.
            let apart = joint.are_apart(joint.skills.len())?;
            return apart.then(|| self.blame(joint, draw)).transpose();
        }
        if draw.attempt > self.tries {
            return Ok(Some(Drawn::Empty(reason(draw.skeleton, draw.step))));
        }
        let margin = if draw.attempt > 1 { 0.0 } else { self.margin };
        match joint.sample(margin, rng) {
            Ok(theta) => {
                let theta = theta.get(..joint.parameters()).unwrap_or_default();
                let (ground, state) = (draw.operator, draw.state);
                let parameters = completed(self.environment, ground, state, theta, rng);
                Ok(Some(Drawn::Informed(parameters)))
            }
            // That nothing was found is no proof, but this is advice, and ends.
            Err(Error::EmptyRegion | Error::NoSample) => self.blame(joint, draw).map(Some),
            Err(error) => Err(error),
        }
    }

    /// Blames the first step with which the regions have nothing in common.
    fn blame(&self, joint: &JointRegion<'_>, draw: &Draw<'_, State>) -> Result<Drawn, Error> {
        let mut step = 0;
        for (count, (.., own)) in (1..).zip(&joint.skills) {
            step = *own;
            if joint.are_apart(count)? {
                break;
            }
        }
        Ok(Drawn::Empty(reason(draw.skeleton, draw.step + step)))
    }
}

/// The step of a sequence as the reason why something cannot work.
fn reason(sequence: Skeleton<'_>, step: usize) -> ReasonId {
    let place = sequence.places().get(step);
    ReasonId(place.copied().unwrap_or(u16::MAX))
}
