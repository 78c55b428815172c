//! Where a skill is tried, and where it could be.

use crate::error::Error;
use crate::learn::Outcome;
use crate::region::Theta;
use crate::skill::context::Context;
use crate::skill::planning::proposal;
use crate::skill::setting::Setting;
use crate::skill::skills::Skill;
use crate::task::{Arguments, GroundOperator, ObjectId, State};
use heapless::Vec;
use rand_core::Rng;

/// Most operators that are tried in a row: two, and what they need in between.
pub const MAX_CHAIN: usize = 4;

/// A state, and the operators to try from it, one after the other: a problem instance p
/// of a skill (thesis 4.3) that can be run.
#[derive(Clone, Debug)]
pub struct Situation {
    /// The state.
    pub state: State,
    /// The operator, and then those up to the later one, if there is one.
    pub steps: Vec<GroundOperator, MAX_CHAIN>,
    /// What came of trying it, where that is tried once.
    pub(super) outcome: Option<Outcome>,
}

impl Situation {
    /// Writes the instance that it is of a skill to `out`, which has a place for each
    /// number.
    ///
    /// # Errors
    /// [`Error::Mismatch`] if it is not a situation of this skill and environment.
    pub fn instance(
        &self,
        environment: &impl Setting,
        skill: &Skill,
        out: &mut [f64],
    ) -> Result<(), Error> {
        let objects = |ground: Option<&GroundOperator>| match ground {
            Some(ground) => controller_objects(environment, ground),
            None => Ok(Arguments::default()),
        };
        let own = objects(self.steps.first())?;
        let later = objects(self.steps.get(1..).and_then(<[_]>::last))?;
        let context = Context {
            environment,
            state: &self.state,
            objects: own.as_slice(),
            later_objects: later.as_slice(),
            members: skill.description().members,
        };
        skill.binding().instance(&context, out)
    }

    /// Parameters that the original sampler draws for the first operator.
    pub fn proposal(&self, environment: &impl Setting, rng: &mut impl Rng) -> Theta {
        let own = self.steps.first();
        own.map_or(Theta::default(), |own| {
            proposal(environment, own, &self.state, rng)
        })
    }
}

/// Objects of a task for the controllers of a skill: a situation that could be made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Candidate {
    /// The task, by its place.
    pub(super) task: u16,
    /// The objects of the controller.
    pub(super) objects: Arguments,
    /// Those of the later one.
    pub(super) later_objects: Arguments,
}

impl Candidate {
    /// Whether an object is one of those it is about.
    pub(super) fn has(&self, object: ObjectId) -> bool {
        let all = [&self.objects, &self.later_objects];
        all.iter().any(|own| own.as_slice().contains(&object))
    }
}

/// The objects of the controller of an operator.
pub(super) fn controller_objects(
    environment: &impl Setting,
    ground: &GroundOperator,
) -> Result<Arguments, Error> {
    let (_, objects) = environment.call(ground.operator, ground.objects.as_slice())?;
    Ok(objects)
}
