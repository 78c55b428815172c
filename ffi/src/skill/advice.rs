//! Skills as the sampler and the guide of a planner.

use crate::boundary::status::{Failure, Fallible};
use crate::planner::callbacks::CRITREG_MAX_REASONS;
use crate::planner::tables::Numbers;
use crate::planner::world::Program;
use crate::skill::arrangement::arranged;
use crate::skill::facts::Facts;
use crate::skill::practice::{original, write_name};
use core::cell::Cell;
use core::fmt::{self, Write};
use critreg_core::Error;
use critreg_core::pddl::Problem;
use critreg_core::plan::{Advice, Draw, Drawn, Guide, ReasonId, Skeleton};
use critreg_core::skill::{RegionGuide, RegionSampler, Setting, Signature, Skills};
use critreg_core::task::{
    Arguments, ControllerId, GroundAtom, GroundOperator, ObjectId, ObjectType, OperatorId,
    Parameters, PredicateId, State, TypeId,
};
use rand_core::Rng;

/// The problem of a planner as what skills are used in.
pub(crate) struct Planned<'a> {
    pub(crate) facts: Facts,
    pub(crate) program: Program<'a>,
    pub(crate) problem: &'a Problem<'static>,
    /// The first failure of a callback: the core knows none.
    pub(crate) failure: Cell<Option<Failure>>,
}

impl Planned<'_> {
    /// The state that these numbers are.
    pub(crate) fn state(&self, numbers: &[f64]) -> Fallible<State> {
        Ok(arranged(&self.facts, self.problem, 0, numbers)?)
    }

    fn noted<T>(&self, result: Fallible<T>) -> Option<T> {
        result
            .map_err(|failure| self.failure.set(Some(failure)))
            .ok()
    }

    /// What the core says, unless a callback failed.
    fn unless_failed<T>(&self, result: Result<T, Error>) -> Fallible<T> {
        match self.failure.get() {
            Some(failure) => Err(failure),
            None => Ok(result?),
        }
    }
}

impl Setting for Planned<'_> {
    fn types(&self) -> &'static [ObjectType] {
        self.facts.types
    }

    fn signature(&self, id: ControllerId) -> Result<Signature, Error> {
        self.facts.signature(id)
    }

    fn call(
        &self,
        action: OperatorId,
        objects: &[ObjectId],
    ) -> Result<(ControllerId, Arguments), Error> {
        self.facts.call(action, objects)
    }

    fn draw<R: Rng>(
        &self,
        action: OperatorId,
        state: &State,
        objects: &[ObjectId],
        rng: &mut R,
    ) -> Parameters {
        let (facts, numbers) = (&self.facts, state.values());
        let drawn = original(facts, &self.program, (action, objects), numbers, rng);
        self.noted(drawn).unwrap_or_default()
    }

    fn narrows(&self, predicate: PredicateId, kind: TypeId) -> bool {
        self.facts.narrows(predicate, kind)
    }

    fn holds_of(&self, predicate: PredicateId, state: &State, object: ObjectId) -> bool {
        let Ok(objects) = Arguments::new([object]) else {
            return false;
        };
        let atom = GroundAtom { predicate, objects };
        self.noted(self.program.holds(&atom, state.values()))
            .unwrap_or(false)
    }

    fn write_name(&self, _: &State, object: ObjectId, out: &mut dyn Write) -> fmt::Result {
        write_name(&self.facts, self.problem, object, out)
    }
}

/// Skills as the sampler of a planner.
pub(crate) struct SkillDraws<'a> {
    setting: &'a Planned<'a>,
    sampler: RegionSampler<'a, Planned<'a>>,
    /// The state to draw in.
    state: State,
}

impl<'a> SkillDraws<'a> {
    /// Of these skills, in states like this one.
    pub(crate) fn new(
        setting: &'a Planned<'a>,
        skills: &'a Skills<'_>,
        state: &State,
        lookahead: u32,
    ) -> Self {
        let mut sampler = RegionSampler::new(setting, skills);
        sampler.lookahead = lookahead;
        SkillDraws {
            setting,
            sampler,
            state: state.clone(),
        }
    }

    /// Draws parameters; `None` if nothing is known.
    pub(crate) fn draw<R: Rng, const N: usize>(
        &mut self,
        draw: &Draw<'_, Numbers, N>,
        rng: &mut R,
    ) -> Fallible<Option<Drawn>> {
        let numbers = self.state.values_mut().iter_mut();
        for (slot, own) in numbers.zip(draw.state.iter()) {
            *slot = *own;
        }
        let own = Draw {
            skeleton: draw.skeleton,
            step: draw.step,
            operator: draw.operator,
            state: &self.state,
            attempt: draw.attempt,
            advised: draw.advised,
        };
        let drawn = self.sampler.advise(&own, rng);
        let drawn = self.setting.unless_failed(drawn)?;
        Ok(drawn.map(|drawn| match drawn {
            Drawn::Empty(reason) => Drawn::Empty(shifted(reason)),
            other => other,
        }))
    }
}

/// Skills as the guide of a planner. Their reasons are numbered behind those of the program.
pub(crate) struct SkillGuide<'a> {
    setting: &'a Planned<'a>,
    guide: RegionGuide<'a, Planned<'a>>,
}

impl<'a> SkillGuide<'a> {
    /// Of these skills, for a task that begins in this state.
    pub(crate) fn new(
        setting: &'a Planned<'a>,
        skills: &'a Skills<'_>,
        initial: &'a State,
        (prune, lookahead): (bool, u32),
    ) -> Self {
        let mut guide = RegionGuide::new(setting, skills, initial);
        (guide.prune, guide.lookahead) = (prune, lookahead);
        SkillGuide { setting, guide }
    }

    /// What to do with a sequence of operators.
    pub(crate) fn judge<const N: usize>(&mut self, prefix: Skeleton<'_, N>) -> Fallible<Advice> {
        let advice = self.guide.judge(prefix);
        self.setting.unless_failed(Ok(match advice {
            Advice::Keep => Advice::Keep,
            Advice::Postpone(reason) => Advice::Postpone(shifted(reason)),
            Advice::Prune(reason) => Advice::Prune(shifted(reason)),
        }))
    }

    /// Writes what a reason says, if it is one of the skills.
    pub(crate) fn explain<const N: usize>(
        &self,
        operators: &[GroundOperator<N>],
        ReasonId(reason): ReasonId,
        out: &mut dyn Write,
    ) -> fmt::Result {
        let place = u32::from(reason).checked_sub(CRITREG_MAX_REASONS);
        let place = place
            .and_then(|place| u16::try_from(place).ok())
            .ok_or(fmt::Error)?;
        self.guide.explain(operators, ReasonId(place), out)
    }
}

/// A reason of skills among those of a planner.
fn shifted(ReasonId(place): ReasonId) -> ReasonId {
    ReasonId(place.saturating_add(CRITREG_MAX_REASONS as u16))
}
