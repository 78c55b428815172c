//! Looking ahead: whether the rest of a skeleton can work, as far as can be told.

use super::expectation::Expectation;
use super::knowledge::{GroundController, Knowledge};
use crate::error::Error;
use crate::plan::Skeleton;
use crate::random::uniform_in;
use crate::region::Theta;
use crate::skill::changes::Changes;
use crate::skill::setting::Setting;
use rand_core::Rng;

/// What is needed to follow the steps of a skeleton in thought.
pub(super) struct Foresight<'k, 'a, E> {
    pub(super) knowledge: &'k Knowledge<'a, E>,
    pub(super) changes: &'a [Changes],
}

/// How far a skeleton was followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Reach {
    /// To its end, so far within the regions of states on the way, at the nearest.
    End(f64),
    /// Up to this step, which is not expected to work; with other draws it may.
    Step(usize),
    /// Up to this step, which does not depend on draws.
    Never(usize),
}

impl<E: Setting> Foresight<'_, '_, E> {
    /// Follows the steps of a skeleton: parameters are drawn from what is known of each step
    /// and of those after it, and each leaves the state that is expected of it.
    ///
    /// # Errors
    /// Those of the regions.
    pub(super) fn follow<R: Rng, const N: usize>(
        &self,
        skeleton: Skeleton<'_, N>,
        mut now: Expectation,
        rng: &mut R,
    ) -> Result<Reach, Error> {
        let (mut drawn, mut robustness) = (false, f64::INFINITY);
        for (step, ground) in skeleton.iter().enumerate() {
            let Some(own) = self.knowledge.controller(ground) else {
                now.forget();
                continue;
            };
            let joint =
                self.knowledge
                    .joint_region(skeleton.from(step), &now.state, |skill, context| {
                        now.tells_region(skill, context)
                    });
            let theta = match joint.sample(0.0, rng) {
                Ok(theta) => theta,
                Err(Error::EmptyRegion) if !drawn => return Ok(Reach::Never(step)),
                Err(Error::EmptyRegion | Error::NoSample) => return Ok(Reach::Step(step)),
                Err(error) => return Err(error),
            };
            robustness = robustness.min(joint.robustness()?);
            let theta = match joint.parameters() {
                0 => self.anything(&own, rng),
                _ => Some(theta),
            };
            drawn |= theta.is_some();
            let theta = theta.as_ref().map(|theta| theta.as_slice());
            now.advance(self.knowledge, self.changes, &own, theta);
        }
        Ok(Reach::End(robustness))
    }

    /// Parameters of a controller of which no region is known, but where it leaves things:
    /// from all of their ranges. The original sampler knows no states that are thought of.
    fn anything<R: Rng>(&self, own: &GroundController, rng: &mut R) -> Option<Theta> {
        let mut known = self.knowledge.about(own);
        let skill = known.find(|skill| !skill.effects().is_empty() && skill.has_parameters())?;
        let mut theta = Theta::default();
        for (slot, range) in theta.iter_mut().zip(skill.domain().parameters()) {
            *slot = uniform_in(rng, range.low, range.high);
        }
        Some(theta)
    }

    /// Whether the steps after the first can work if that one is given these parameters, as
    /// far as can be told: how far the states on the way are within the regions that speak of
    /// them, or the step that cannot.
    ///
    /// # Errors
    /// Those of the regions.
    pub(super) fn prospect<R: Rng, const N: usize>(
        &self,
        skeleton: Skeleton<'_, N>,
        mut now: Expectation,
        theta: &[f64],
        rng: &mut R,
    ) -> Result<Result<f64, usize>, Error> {
        match skeleton
            .get(0)
            .and_then(|own| self.knowledge.controller(own))
        {
            Some(own) => now.advance(self.knowledge, self.changes, &own, Some(theta)),
            None => now.forget(),
        }
        Ok(match self.follow(skeleton.from(1), now, rng)? {
            Reach::End(robustness) => Ok(robustness),
            Reach::Step(step) | Reach::Never(step) => Err(step + 1),
        })
    }
}
