//! Planning, and what comes of it.

use crate::boundary::handle;
use crate::boundary::pointer::{self, Output};
use crate::boundary::status::{Failure, Fallible, critreg_status};
use crate::planner::callbacks::critreg_callbacks;
use crate::planner::config::Settings;
use crate::planner::handle::{Inner, critreg_planner, with_planner};
use crate::planner::metrics::{critreg_metrics, verdict};
use crate::planner::tables::{Numbers, Ranges, SetTables, Sets, Tables, with_sets};
use crate::planner::why::Reason;
use crate::planner::world::{Advisor, Draws, Program, Sequence};
use crate::skill;
use crate::skill::advice::{Planned, SkillDraws, SkillGuide};
use core::cell::Cell;
use core::ffi::c_void;
use critreg_core::Error;
use critreg_core::pddl::MAX_ACTIONS;
use critreg_core::plan::{
    AbstractTask, Conclusion, HeuristicMemory, Memory, Planner, Progress, SearchMemory, Waiting,
};
use critreg_core::random::generator;
use critreg_core::task::{AtomSet, GroundAtom, OperatorId};

/// Plans from a state: first which operators, then with which parameters.
///
/// The search goes through sequences of operators that reach the goal in the
/// abstract, from shorter to longer ones. Such a plan skeleton is refined step by
/// step: parameters are drawn and execute() is called. A step works if it took an
/// action and whatever the rest of the skeleton and the goal need of it holds; if
/// its tries are spent, an earlier step is tried again. A skeleton that cannot be
/// refined is followed by another one.
///
/// The state is the program's own: the planner copies it and passes it on, and
/// never looks into it.
///
/// @param planner The planner.
/// @param callbacks What the planner may ask, from critreg_callbacks_init().
/// @param initial The state to begin in: critreg_planner_config.state_len numbers.
/// In it those atoms must hold that the problem's :init names, and no others.
/// @param seed Seed of all random choices. The same seed, texts, configuration and
/// answers of the callbacks give the same plan on every machine.
/// @param user_data Passed to the callbacks.
/// @param length NULL, or receives how many steps the plan has; read them with
/// critreg_planner_step().
/// @return CRITREG_NO_PLAN if none was found: critreg_planner_metrics() tells how
/// planning ended and what stood in the way; CRITREG_CAPACITY_EXCEEDED if the memory
/// is full; CRITREG_MISMATCH if the initial state does not agree with :init
/// (critreg_planner_message() names the atom); the status of a callback that was
/// not CRITREG_OK; CRITREG_INVALID_ARGUMENT or CRITREG_NOT_FINITE for an answer of a
/// callback that is none; CRITREG_BUSY from a callback; CRITREG_NULL_POINTER, also
/// if execute or holds are not set, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE. In all
/// cases the planner can be used again.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_plan(
    planner: *mut critreg_planner,
    callbacks: *const critreg_callbacks,
    initial: *const f64,
    seed: u64,
    user_data: *mut c_void,
    length: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_planner(planner, |handle, inner| {
            inner.plan_length = 0;
            handle.culprit.set(None);
            handle.metrics.set(critreg_metrics::NONE);
            handle.reason.set(Reason::Nothing);
            handle.words.begin();
            let callbacks = critreg_callbacks::read(callbacks)?;
            let tables = &mut inner.tables;
            let state_len = tables.initial.len();
            let initial = pointer::slice(initial, state_len, "initial")?;
            let length = Output::optional(length, "length")?;
            for (slot, number) in tables.initial.iter_mut().zip(initial) {
                *slot = *number;
            }
            let result = plan(handle, inner, &callbacks, user_data, seed);
            if let Err(Failure::Stopped(..)) = result {
                handle.metrics.set(critreg_metrics::STOPPED);
                handle.reason.set(Reason::Stopped);
            }
            result?;
            if let Some(length) = length {
                length.write(inner.plan_length);
            }
            Ok(())
        })
    }
}

/// Makes a planner usable again that answers CRITREG_BUSY because a callback was left by
/// longjmp(), which it must not be. It has no plan then; plan again. A planner that is not
/// busy stays as it is.
///
/// @param planner The planner. No call on it may be running, so this is not for callbacks.
/// @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_planner_recover(planner: *mut critreg_planner) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for both.
    unsafe {
        handle::read(planner.cast_const(), |handle: &critreg_planner| {
            handle.inner.recover();
            Ok(())
        })
    }
}

fn plan(
    handle: &critreg_planner,
    inner: &mut Inner,
    callbacks: &critreg_callbacks,
    user_data: *mut c_void,
    seed: u64,
) -> Fallible {
    let Tables {
        names,
        ranges,
        progress,
        links,
        open,
        visited,
        initial,
        sequence,
        failures,
        reasons,
        sets,
        ..
    } = &mut inner.tables;
    let call = Call {
        handle,
        program: Program {
            callbacks,
            user_data,
            names,
            ranges,
            atoms: &[],
        },
        initial,
        sequence,
        settings: inner.settings,
        seed,
    };
    let shared = Shared {
        progress,
        links,
        open,
        visited,
        failures,
        reasons,
    };
    let (conclusion, length) = match callbacks.skills.is_null() {
        true => with_sets!(sets, sets => call.plan(sets, shared, None, None))?,
        // SAFETY: the header makes it the caller's promise.
        false => unsafe { handle::open(callbacks.skills)? }
            .lend(|skills| call.plan_with(skills, sets, shared))?,
    };
    inner.plan_length = length;
    verdict(conclusion)
}

/// What a planning needs of the tables, apart from sets.
struct Shared<'a> {
    progress: &'a mut [Progress],
    links: &'a mut [u16],
    open: &'a mut [Waiting],
    visited: &'a mut [u32],
    failures: &'a mut [u32],
    reasons: &'a mut [u32],
}

/// A call of critreg_plan().
struct Call<'a> {
    handle: &'a critreg_planner,
    program: Program<'a>,
    initial: &'a Numbers,
    sequence: Sequence<'a>,
    settings: Settings,
    seed: u64,
}

impl Call<'_> {
    /// As [`Call::plan`], with skills.
    #[inline(never)]
    fn plan_with(
        &self,
        known: &mut skill::handle::Inner,
        sets: &mut Sets,
        shared: Shared<'_>,
    ) -> Fallible<(Conclusion, usize)> {
        let problem = self.handle.problem();
        if known.facts.pddl != problem.domain() {
            return Err(Error::Mismatch("the skills are of another PDDL domain").into());
        }
        let mut ranges = [Ranges::default(); MAX_ACTIONS];
        for (place, (slot, own)) in (0..).zip(ranges.iter_mut().zip(self.program.ranges)) {
            let learned = known.facts.ranges(OperatorId(place));
            let learned = learned.filter(|ranges| !ranges.as_slice().is_empty());
            *slot = *learned.unwrap_or(own);
        }
        let program = Program {
            ranges: &ranges,
            ..self.program
        };
        let setting = Planned {
            facts: known.facts,
            program,
            problem,
            failure: Cell::new(None),
        };
        let skills = known.known();
        let initial = setting.state(self.initial)?;
        let lookahead = self.settings.lookahead;
        let draws = SkillDraws::new(&setting, &skills, &initial, lookahead);
        let guide = SkillGuide::new(
            &setting,
            &skills,
            &initial,
            (program.callbacks.prune != 0, lookahead),
        );
        let call = Call { program, ..*self };
        with_sets!(sets, sets => call.plan(sets, shared, Some(draws), Some(guide)))
    }

    /// How planning ended, and how long the plan is.
    fn plan<const N: usize>(
        &self,
        sets: &mut SetTables<N>,
        shared: Shared<'_>,
        draws: Option<SkillDraws<'_>>,
        guide: Option<SkillGuide<'_>>,
    ) -> Fallible<(Conclusion, usize)> {
        let program = Program {
            atoms: sets.grounding.atoms().as_slice(),
            ..self.program
        };
        program.callbacks.execute.ok_or(Failure::Null("execute"))?;
        check_initial(
            self.handle,
            &program,
            sets.grounding.initial(),
            self.initial,
        )?;
        let task = AbstractTask {
            operators: sets.operators,
            initial: sets.grounding.initial(),
            goal: sets.grounding.goal(),
        };
        let memory = Memory {
            search: SearchMemory {
                heuristic: HeuristicMemory {
                    operators: shared.progress,
                    links: shared.links,
                    cache: sets.estimates,
                },
                nodes: sets.nodes,
                open: shared.open,
                visited: shared.visited,
            },
            steps: sets.steps,
            failures: shared.failures,
            reasons: shared.reasons,
        };
        let mut guide = Advisor {
            program,
            skills: guide,
            sequence: self.sequence,
            initial: self.initial,
            stopped: None,
        };
        let mut planner = Planner {
            world: &mut { program },
            sampler: &mut Draws {
                program,
                sequence: self.sequence,
                skills: draws,
            },
            guide: &mut guide,
            config: self.settings.plan,
        };
        let (lots, samples) = (generator(self.seed), || generator(self.seed));
        let planned = planner.plan(task, self.initial, lots, samples, memory)?;
        if let Some(failure) = guide.stopped {
            return Err(failure);
        }
        let metrics = critreg_metrics::new(planned.conclusion, &planned.metrics, program.names);
        self.handle.metrics.set(metrics);
        if let (Some(skills), Some(main)) = (&guide.skills, planned.metrics.main_reason()) {
            let mut words = self.handle.words.begin();
            // What is not a reason of the skills has no words.
            let _ = skills.explain(sets.operators, main, &mut words);
        }
        let reason = Reason::new(&planned, sets.missing, &self.settings.plan);
        self.handle.reason.set(reason);
        Ok((planned.conclusion, planned.steps.len()))
    }
}

/// Checks that those atoms hold in the initial state that the problem says.
fn check_initial<const N: usize>(
    handle: &critreg_planner,
    program: &Program<'_>,
    expected: AtomSet<N>,
    initial: &[f64],
) -> Fallible {
    let asked = |atom: &&GroundAtom| !atom.is_goal() && !atom.predicate.is_negation();
    for (place, atom) in (0..).zip(program.atoms).filter(|(_, atom)| asked(atom)) {
        if program.holds(atom, initial)? != expected.contains(place) {
            handle.culprit.set(Some(*atom));
            let what = "initial state and :init do not agree about an atom";
            return Err(Error::Mismatch(what).into());
        }
    }
    Ok(())
}
