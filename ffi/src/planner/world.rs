//! The program's callbacks as the world, the sampler and the guide of a planning.

use crate::boundary::rng::critreg_rng_seed;
use crate::boundary::status::{
    CRITREG_EMPTY_REGION, CRITREG_NO_SAMPLE, Failure, Fallible, stop_unless_ok,
};
use crate::planner::callbacks::{
    CRITREG_KEEP, CRITREG_MAX_REASONS, CRITREG_NO_REASON, CRITREG_POSTPONE, CRITREG_PRUNE,
    critreg_advise, critreg_callbacks, critreg_draw, critreg_drawn, critreg_ground,
};
use crate::planner::names::Names;
use crate::planner::tables::{Numbers, Ranges};
use crate::skill::advice::{SkillDraws, SkillGuide};
use core::cell::Cell;
use core::ffi::c_void;
use critreg_core::Error;
use critreg_core::domain::MAX_PARAMETERS;
use critreg_core::plan::{Advice, Draw, Drawn, Guide, ReasonId, Sampler, Skeleton, World};
use critreg_core::random::uniform_in;
use critreg_core::task::{GroundAtom, GroundOperator, Parameters};
use rand_core::Rng;

/// The program, with what it is asked in: names and ranges of its PDDL texts.
#[derive(Clone, Copy)]
pub(crate) struct Program<'a> {
    pub(crate) callbacks: &'a critreg_callbacks,
    pub(crate) user_data: *mut c_void,
    pub(crate) names: &'a Names,
    pub(crate) ranges: &'a [Ranges],
    pub(crate) atoms: &'a [GroundAtom],
}

impl Program<'_> {
    fn ranges<const N: usize>(&self, operator: &GroundOperator<N>) -> &[[f64; 2]] {
        let ranges = self.ranges.get(usize::from(operator.operator.0));
        ranges.map_or(&[], Ranges::as_slice)
    }

    /// Whether an atom holds in a state. The program is not asked for negations.
    pub(crate) fn holds(&self, atom: &GroundAtom, state: &[f64]) -> Fallible<bool> {
        if atom.predicate.is_negation() {
            return Ok(!self.holds(&atom.negation(), state)?);
        }
        let ask = self.callbacks.holds.ok_or(Failure::Null("holds"))?;
        let ground = self.names.atom(atom);
        let mut holds = -1;
        // SAFETY: a callback of the program, called as the header promises.
        let status = unsafe {
            ask(
                self.user_data,
                &ground,
                state.as_ptr(),
                state.len(),
                &mut holds,
            )
        };
        stop_unless_ok(status, "holds")?;
        match holds {
            0 => Ok(false),
            1 => Ok(true),
            _ => Err(Failure::invalid("holds wrote neither 0 nor 1")),
        }
    }
}

impl Program<'_> {
    /// Runs an operator. `after` holds a copy of the state before.
    pub(crate) fn run(
        &self,
        ground: &critreg_ground,
        parameters: &[f64],
        before: &[f64],
        after: &mut [f64],
    ) -> Fallible<u32> {
        let run = self.callbacks.execute.ok_or(Failure::Null("execute"))?;
        let mut theta = [0.0; MAX_PARAMETERS];
        for (value, own) in theta.iter_mut().zip(parameters) {
            *value = *own;
        }
        let mut actions = 0;
        // SAFETY: a callback of the program, called as the header promises; the two
        // states do not overlap.
        let status = unsafe {
            run(
                self.user_data,
                ground,
                theta.as_ptr(),
                before.as_ptr(),
                after.as_mut_ptr(),
                after.len(),
                &mut actions,
            )
        };
        stop_unless_ok(status, "execute")?;
        Ok(actions)
    }

    /// Parameters of the program's own sampler for the step that it is told, within these
    /// ranges; uniform in them if it has none.
    pub(crate) fn sample<R: Rng>(
        &self,
        told: &critreg_draw,
        ranges: &[[f64; 2]],
        rng: &mut R,
    ) -> Fallible<Drawn> {
        let Some(sample) = self.callbacks.sample else {
            return uniform(ranges, rng).map(Drawn::Parameters);
        };
        // A C program has generators of one kind; the planner may have any.
        let mut own = critreg_rng_seed(rng.next_u64());
        let mut drawn = critreg_drawn {
            parameters: [f64::NAN; MAX_PARAMETERS],
            informed: 0,
            reason: CRITREG_NO_REASON,
        };
        // SAFETY: a callback of the program, called as the header promises.
        let status = unsafe { sample(self.user_data, told, &mut own, &mut drawn) };
        match status {
            CRITREG_EMPTY_REGION => return Ok(Drawn::Empty(reason_of(drawn.reason))),
            CRITREG_NO_SAMPLE => return Ok(Drawn::Nothing),
            _ => stop_unless_ok(status, "sample")?,
        }
        let parameters = drawn.parameters.iter().zip(ranges);
        let checked = collect(parameters.map(|(value, range)| check(*value, *range)));
        match drawn.informed {
            0 => checked.map(Drawn::Parameters),
            _ => checked.map(Drawn::Informed),
        }
    }
}

/// Parameters uniform in these ranges.
pub(crate) fn uniform<R: Rng>(ranges: &[[f64; 2]], rng: &mut R) -> Fallible<Parameters> {
    collect(
        ranges
            .iter()
            .map(|[low, high]| Ok(uniform_in(rng, *low, *high))),
    )
}

impl<const N: usize> World<N> for Program<'_> {
    type State = Numbers;
    type Error = Failure;

    fn parameters(&self, operator: &GroundOperator<N>) -> Fallible<usize> {
        Ok(self.ranges(operator).len())
    }

    fn holds(&mut self, atom: u32, state: &Numbers) -> Fallible<bool> {
        let atom = self.atoms.get(atom as usize);
        let atom = atom.ok_or(Error::Mismatch("an atom is not of this problem"))?;
        Program::holds(self, atom, state)
    }

    fn execute(
        &mut self,
        operator: &GroundOperator<N>,
        parameters: &[f64],
        before: &Numbers,
        after: &mut Numbers,
    ) -> Fallible<u32> {
        for (value, own) in after.iter_mut().zip(before.iter()) {
            *value = *own;
        }
        self.run(&self.names.operator(operator), parameters, before, after)
    }
}

/// Operators as the program gets them: those of the sequence at hand.
pub(crate) type Sequence<'a> = &'a [Cell<critreg_ground>];

/// Writes a sequence of operators.
fn write<const N: usize>(
    names: &Names,
    skeleton: Skeleton<'_, N>,
    sequence: Sequence<'_>,
) -> Fallible {
    if skeleton.len() > sequence.len() {
        return Err(Error::CapacityExceeded("operators of a sequence").into());
    }
    for (slot, operator) in sequence.iter().zip(skeleton.iter()) {
        slot.set(names.operator(operator));
    }
    Ok(())
}

/// Where the parameters of a program come from.
pub(crate) struct Draws<'a> {
    pub(crate) program: Program<'a>,
    pub(crate) sequence: Sequence<'a>,
    /// What is drawn from where something is known.
    pub(crate) skills: Option<SkillDraws<'a>>,
}

impl<'a, const N: usize> Sampler<Program<'a>, N> for Draws<'_> {
    fn sample<R: Rng>(&mut self, draw: &Draw<'_, Numbers, N>, rng: &mut R) -> Fallible<Drawn> {
        if let Some(skills) = &mut self.skills
            && let Some(drawn) = skills.draw(draw, rng)?
        {
            return Ok(drawn);
        }
        let program = &self.program;
        let ranges = program.ranges(draw.operator);
        if program.callbacks.sample.is_some() {
            write(program.names, draw.skeleton, self.sequence)?;
        }
        let told = critreg_draw {
            skeleton: self.sequence.as_ptr().cast(),
            length: draw.skeleton.len(),
            step: draw.step,
            state: draw.state.as_ptr(),
            state_len: draw.state.len(),
            parameter_count: ranges.len(),
            attempt: draw.attempt,
            advised: i32::from(draw.advised),
        };
        program.sample(&told, ranges, rng)
    }
}

/// The parameters of an operator.
fn collect(values: impl Iterator<Item = Fallible<f64>>) -> Fallible<Parameters> {
    let mut parameters = Parameters::new();
    for value in values {
        let pushed = parameters.push(value?);
        pushed.map_err(|_| Error::CapacityExceeded("parameters of an operator"))?;
    }
    Ok(parameters)
}

/// A parameter, if it is in its range.
fn check(value: f64, [low, high]: [f64; 2]) -> Fallible<f64> {
    if !value.is_finite() {
        return Err(Error::NotFinite("a parameter that sample drew").into());
    }
    if !(low..=high).contains(&value) {
        return Err(Failure::invalid(
            "sample drew a parameter outside of its range",
        ));
    }
    Ok(value)
}

/// A reason of the program; a number that no reason has is counted with those.
fn reason_of(number: u32) -> ReasonId {
    match number < CRITREG_MAX_REASONS {
        true => ReasonId(number as u16),
        false => ReasonId(u16::MAX),
    }
}

/// The program's advice.
pub(crate) struct Advisor<'a> {
    pub(crate) program: Program<'a>,
    /// What is asked first.
    pub(crate) skills: Option<SkillGuide<'a>>,
    pub(crate) sequence: Sequence<'a>,
    pub(crate) initial: &'a [f64],
    /// That advising failed. A guide cannot say so, so everything is pruned from
    /// then on, which ends the search at once.
    pub(crate) stopped: Option<Failure>,
}

impl Advisor<'_> {
    fn ask<const N: usize>(
        &mut self,
        advise: critreg_advise,
        prefix: Skeleton<'_, N>,
    ) -> Fallible<Advice> {
        if let Some(skills) = &mut self.skills {
            match skills.judge(prefix)? {
                Advice::Keep => {}
                other => return Ok(other),
            }
        }
        let Some(advise) = advise else {
            return Ok(Advice::Keep);
        };
        let (mut advice, mut reason) = (CRITREG_KEEP, CRITREG_NO_REASON);
        write(self.program.names, prefix, self.sequence)?;
        // SAFETY: a callback of the program, called as the header promises.
        let status = unsafe {
            advise(
                self.program.user_data,
                self.sequence.as_ptr().cast(),
                prefix.len(),
                self.initial.as_ptr(),
                self.initial.len(),
                &mut advice,
                &mut reason,
            )
        };
        stop_unless_ok(status, "advise")?;
        match advice {
            CRITREG_KEEP => Ok(Advice::Keep),
            CRITREG_POSTPONE => Ok(Advice::Postpone(reason_of(reason))),
            CRITREG_PRUNE => Ok(Advice::Prune(reason_of(reason))),
            _ => Err(Failure::invalid("advise wrote no advice that there is")),
        }
    }
}

impl<const N: usize> Guide<N> for Advisor<'_> {
    fn judge(&mut self, prefix: Skeleton<'_, N>) -> Advice {
        const NOTHING: Advice = Advice::Prune(ReasonId(u16::MAX));
        if self.stopped.is_some() {
            return NOTHING;
        }
        let advice = self.ask(self.program.callbacks.advise, prefix);
        advice.unwrap_or_else(|failure| {
            self.stopped = Some(failure);
            NOTHING
        })
    }
}
