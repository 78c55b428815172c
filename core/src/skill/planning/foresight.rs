//! Looking ahead: whether the rest of a skeleton can work, as far as can be told.

use super::expectation::Expectation;
use super::knowledge::Knowledge;
use crate::error::Error;
use crate::plan::Skeleton;
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
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Reach {
    /// To its end.
    End,
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
        let mut drawn = false;
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
            let count = joint.parameters();
            drawn |= count > 0;
            let theta = theta.get(..count).filter(|_| count > 0);
            now.advance(self.knowledge, self.changes, &own, theta);
        }
        Ok(Reach::End)
    }

    /// Whether the steps after the first can work if that one is given these parameters, as
    /// far as can be told: the step that cannot, if there is one.
    ///
    /// # Errors
    /// Those of the regions.
    pub(super) fn obstacle<R: Rng, const N: usize>(
        &self,
        skeleton: Skeleton<'_, N>,
        mut now: Expectation,
        theta: &Theta,
        rng: &mut R,
    ) -> Result<Option<usize>, Error> {
        match skeleton
            .get(0)
            .and_then(|own| self.knowledge.controller(own))
        {
            Some(own) => now.advance(self.knowledge, self.changes, &own, Some(theta)),
            None => now.forget(),
        }
        Ok(match self.follow(skeleton.from(1), now, rng)? {
            Reach::End => None,
            Reach::Step(step) | Reach::Never(step) => Some(step + 1),
        })
    }
}
