//! Planning with regions.

use super::tail::Tail;
use super::{Describe, Skill, Skills};
use crate::domain::{Arguments, Controller, ControllerId, GroundOperator, State};
use crate::error::Error;
use crate::plan::{Advice, Draw, Drawn, Guide, ReasonId, Sampler, Simulated, Skeleton};
use crate::random::uniform;
use crate::table::gather;
use rand_core::Rng;

/// An environment's sampler and guide that know its skills.
///
/// As a sampler it draws the parameters of a step where its region, in the state before
/// it, and those of the later steps meet: of all up to the next one with parameters,
/// which decides anew. Where nothing is known it is the original sampler.
///
/// As a guide it judges a sequence of operators whose last one does not work in the
/// initial state, or with no parameters of the last step before that has some. It does so
/// only as far as the regions read nothing that the steps before them change.
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
        let operators = self.environment.operators();
        let operator = operators.get(usize::from(ground.operator.0))?;
        let controllers = self.environment.controllers();
        Some(Run {
            id: operator.controller,
            controller: controllers.get(usize::from(operator.controller.0))?,
            objects: operator
                .controller_objects(ground.objects.as_slice())
                .ok()?,
        })
    }

    /// The regions of a step, and those of later steps, in a state before the first; only
    /// those of which `counts` is true.
    pub(super) fn tail(
        &self,
        skeleton: Skeleton<'_>,
        state: &State,
        counts: impl Fn(&Skill, &Arguments, &Arguments) -> bool,
    ) -> Tail<'a> {
        let mut tail = Tail::default();
        let mut runs = skeleton.iter().map_while(|ground| self.run(ground));
        let Some(own) = runs.next() else {
            return tail;
        };
        let none = Arguments::default();
        let later = runs.take_while(|run| run.controller.parameters.is_empty());
        let later = later.map(|run| (Some(run.id), run.objects));
        let all = core::iter::once((None, none)).chain(later);
        let has_parameters = !own.controller.parameters.is_empty();
        let all = all.take(if has_parameters { usize::MAX } else { 1 });
        for (step, (id, objects)) in all.enumerate() {
            let known = self.skills.find(own.id, id);
            let Some(skill) = known.filter(|skill| skill.region.is_some()) else {
                continue;
            };
            if counts(skill, &own.objects, &objects) {
                tail.add(skill, step, |out| {
                    let (own, later) = (own.objects.as_slice(), objects.as_slice());
                    skill.binding.instance(state, own, later, out)
                });
            }
        }
        tail
    }

    /// Whether a region reads in the initial state what it would read after these steps.
    fn is_settled(
        &self,
        before: Skeleton<'_>,
        skill: &Skill,
        own: &Arguments,
        later: &Arguments,
    ) -> bool {
        let read = (0..skill.binding.len()).filter(|slot| skill.reads >> slot & 1 == 1);
        let (own, later) = (own.as_slice(), later.as_slice());
        let mut sources = read.filter_map(|s| skill.binding.source(s, self.initial, own, later));
        !sources.any(|(object, attribute)| {
            before.iter().any(|ground| {
                self.run(ground).is_none_or(|run| {
                    let changes = self.skills.changes(run.id);
                    changes.affect(run.objects.as_slice(), self.initial, object, attribute)
                })
            })
        })
    }

    /// Whether the last operator of a sequence cannot work.
    fn is_blocked(&self, prefix: Skeleton<'_>) -> Result<bool, Error> {
        let decides = |step: &usize| {
            let run = prefix.get(*step).and_then(|ground| self.run(ground));
            run.is_some_and(|run| !run.controller.parameters.is_empty())
        };
        let Some(last) = prefix.len().checked_sub(1) else {
            return Ok(false);
        };
        let deciding = (0..prefix.len()).rev().find(decides);
        for own in deciding.into_iter().chain([last]) {
            let before = prefix.until(own);
            let tail = self.tail(prefix.from(own), self.initial, |skill, own, later| {
                self.is_settled(before, skill, own, later)
            });
            if tail.are_apart(tail.skills.len())? {
                return Ok(true);
            }
            if own == last {
                break;
            }
        }
        Ok(false)
    }
}

/// A controller that is run.
pub(super) struct Run<E: Describe> {
    pub(super) id: ControllerId,
    pub(super) controller: &'static Controller<E>,
    pub(super) objects: Arguments,
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
            let tail = self.tail(draw.skeleton.from(draw.step), draw.state, |_, _, _| true);
            if let Some(drawn) = self.draw(&tail, draw, rng)? {
                return Ok(drawn);
            }
        }
        let GroundOperator {
            operator, objects, ..
        } = draw.operator;
        let objects = objects.as_slice();
        let drawn = self.environment.sample(*operator, draw.state, objects, rng);
        Ok(Drawn::Parameters(drawn))
    }
}

impl<E: Describe> Informed<'_, E> {
    /// Draws where the regions meet; `None` if nothing is known.
    fn draw<R: Rng>(
        &self,
        tail: &Tail<'_>,
        draw: &Draw<'_, State>,
        rng: &mut R,
    ) -> Result<Option<Drawn>, Error> {
        if tail.skills.is_empty() {
            return Ok(None);
        }
        if draw.attempt > self.tries {
            return Ok(Some(Drawn::Empty(reason(draw.skeleton, draw.step))));
        }
        let margin = if draw.attempt > 1 { 0.0 } else { self.margin };
        let run = self.run(draw.operator);
        let count = run.map_or(0, |run| run.controller.parameters.len());
        match tail.sample(margin, rng) {
            Ok(theta) => {
                let parameters = theta.into_iter().take(count).map(|value| value as f32);
                Ok(Some(Drawn::Informed(gather(parameters))))
            }
            Err(Error::EmptyRegion) => self.blame(tail, draw).map(Some),
            Err(Error::NoSample) => Ok(None),
            Err(error) => Err(error),
        }
    }

    /// Blames the first step with which the regions have nothing in common.
    fn blame(&self, tail: &Tail<'_>, draw: &Draw<'_, State>) -> Result<Drawn, Error> {
        let mut step = 0;
        for (count, (.., own)) in (1..).zip(&tail.skills) {
            step = *own;
            if tail.are_apart(count)? {
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
