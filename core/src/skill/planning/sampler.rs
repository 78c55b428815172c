//! The region-guided sampler.

use super::expectation::Expectation;
use super::foresight::Foresight;
use super::joint_region::JointRegion;
use super::knowledge::{Knowledge, reason};
use super::original::completed;
use crate::error::Error;
use crate::plan::{Draw, Drawn, Sampler, World};
use crate::random::uniform;
use crate::skill::changes::Changes;
use crate::skill::setting::Setting;
use crate::skill::skills::{Library, Skills};
use crate::skill::tuning::{FORESEEN_DRAWS, MARGIN, REGION_DRAWS};
use crate::task::State;
use rand_core::Rng;

/// A region-guided sampler: it draws the parameters of a step from what was learned
/// (thesis 5.2), in place of the original sampler of a bilevel planner.
///
/// It draws where the region of the step, in the state before it, and those of later
/// steps meet: of all up to one with parameters that handles its objects again, which
/// decides anew. Where nothing is known it is the original sampler.
///
/// The reason that it gives is the place of the ground operator that cannot work;
/// [`RegionGuide::explain`](super::RegionGuide::explain) has the text.
#[derive(Debug)]
pub struct RegionSampler<'a, E> {
    knowledge: Knowledge<'a, E>,
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
    /// How many draws of a step are followed to the end of the skeleton, in what is expected
    /// of the steps after it, before it is taken for impossible; 0, the default: none is.
    pub lookahead: u32,
    changes: &'a [Changes],
}

impl<'a, E: Setting> RegionSampler<'a, E> {
    /// The sampler that draws from what is known of an environment.
    pub fn new(environment: &'a E, skills: &'a Skills<'_>) -> Self {
        let (library, changes) = skills.known();
        RegionSampler {
            changes,
            ..RegionSampler::from_library(environment, library)
        }
    }

    pub(in crate::skill) fn from_library(environment: &'a E, library: Library<'a>) -> Self {
        RegionSampler {
            knowledge: Knowledge {
                environment,
                library,
            },
            margin: MARGIN,
            tries: REGION_DRAWS,
            everywhere: 0.0,
            lookahead: 0,
            changes: &[],
        }
    }

    /// Draws parameters as far as something is known, for planners whose states are others;
    /// `None` if nothing is, or if advice does not count.
    ///
    /// # Errors
    /// Those of the regions.
    pub fn advise<R: Rng, const N: usize>(
        &self,
        draw: &Draw<'_, State, N>,
        rng: &mut R,
    ) -> Result<Option<Drawn>, Error> {
        let everywhere = self.everywhere > 0.0 && uniform(rng) < self.everywhere;
        if !draw.advised || everywhere {
            return Ok(None);
        }
        let steps = draw.skeleton.from(draw.step);
        let joint = self.knowledge.joint_region(steps, draw.state, |_, _| true);
        self.draw(&joint, draw, rng)
    }

    /// Draws where the regions meet; `None` if nothing is known.
    fn draw<R: Rng, const N: usize>(
        &self,
        joint: &JointRegion<'_>,
        draw: &Draw<'_, State, N>,
        rng: &mut R,
    ) -> Result<Option<Drawn>, Error> {
        let own = self.knowledge.controller(draw.operator);
        let sampled = own
            .as_ref()
            .is_some_and(|own| own.controller.parameters > 0);
        if sampled && joint.parameters() == 0 {
            // What is known is about the state, and leaves the parameters free.
            let empty = joint.is_proven_empty()?;
            if empty {
                return blame(joint, draw).map(Some);
            }
            let mut known = own.iter().flat_map(|own| self.knowledge.about(own));
            let foreseen = self.lookahead > 0 && known.any(|skill| !skill.effects().is_empty());
            if !foreseen {
                return Ok(None);
            }
            let environment = self.knowledge.environment;
            let original =
                |rng: &mut R| Ok(completed(environment, draw.operator, draw.state, &[], rng));
            return Ok(Some(match self.foreseen(draw, rng, original)? {
                Ok(parameters) => Drawn::Informed(parameters),
                Err(step) => Drawn::Empty(reason(draw.skeleton, step)),
            }));
        }
        if joint.regions().is_empty() {
            return Ok(None);
        }
        if draw.attempt > self.tries {
            return Ok(Some(Drawn::Empty(reason(draw.skeleton, draw.step))));
        }
        let margin = if draw.attempt > 1 { 0.0 } else { self.margin };
        let drawn = if self.lookahead > 0 && joint.parameters() > 0 {
            self.foreseen(draw, rng, |rng: &mut R| joint.sample(margin, rng))
        } else {
            joint.sample(margin, rng).map(Ok)
        };
        match drawn {
            Ok(Err(step)) => Ok(Some(Drawn::Empty(reason(draw.skeleton, step)))),
            Ok(Ok(theta)) => {
                let theta = theta.get(..joint.parameters()).unwrap_or_default();
                let (ground, state) = (draw.operator, draw.state);
                let parameters = completed(self.knowledge.environment, ground, state, theta, rng);
                Ok(Some(Drawn::Informed(parameters)))
            }
            // That nothing was found is no proof, but this is advice, and ends.
            Err(Error::EmptyRegion | Error::NoSample) => blame(joint, draw).map(Some),
            Err(error) => Err(error),
        }
    }
}

impl<'a, E: Setting> RegionSampler<'a, E> {
    /// Of some draws with which the steps after this one can work the one that keeps farthest
    /// from where they could not, in the first try of a step; the first of them later, as it
    /// was not that. Or the step that cannot work with any draw.
    fn foreseen<R: Rng, P: AsRef<[f64]>, const N: usize>(
        &self,
        draw: &Draw<'_, State, N>,
        rng: &mut R,
        mut next: impl FnMut(&mut R) -> Result<P, Error>,
    ) -> Result<Result<P, usize>, Error> {
        let (foresight, steps) = (self.foresight(), draw.skeleton.from(draw.step));
        let wanted = if draw.attempt > 1 { 1 } else { FORESEEN_DRAWS };
        let (mut best, mut found, mut farthest) = (None::<(f64, P)>, 0, 0);
        for _ in 0..self.lookahead {
            let parameters = next(rng)?;
            let now = Expectation::of(draw.state);
            match foresight.prospect(steps, now, parameters.as_ref(), rng)? {
                Ok(robustness) => {
                    found += 1;
                    if best.as_ref().is_none_or(|(most, _)| robustness > *most) {
                        best = Some((robustness, parameters));
                    }
                    // Where nothing is known of states, one is as good as another.
                    if found == wanted || robustness == f64::INFINITY {
                        break;
                    }
                }
                Err(step) => farthest = farthest.max(step),
            }
        }
        Ok(best
            .map(|(_, parameters)| parameters)
            .ok_or(draw.step + farthest))
    }

    fn foresight(&self) -> Foresight<'_, 'a, E> {
        Foresight {
            knowledge: &self.knowledge,
            changes: self.changes,
        }
    }
}

/// Blames the first step with which the regions have nothing in common.
fn blame<const N: usize>(
    joint: &JointRegion<'_>,
    draw: &Draw<'_, State, N>,
) -> Result<Drawn, Error> {
    let step = draw.step + joint.blocking_step()?;
    Ok(Drawn::Empty(reason(draw.skeleton, step)))
}

impl<E, W, const N: usize> Sampler<W, N> for RegionSampler<'_, E>
where
    E: Setting,
    W: World<N, State = State>,
{
    fn sample<R: Rng>(
        &mut self,
        draw: &Draw<'_, State, N>,
        rng: &mut R,
    ) -> Result<Drawn, W::Error> {
        if let Some(drawn) = self.advise(draw, rng)? {
            return Ok(drawn);
        }
        let environment = self.knowledge.environment;
        let drawn = completed(environment, draw.operator, draw.state, &[], rng);
        Ok(Drawn::Parameters(drawn))
    }
}
