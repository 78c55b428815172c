//! Planning, and what comes of it.

use crate::boundary::pointer::{self, Output};
use crate::boundary::status::{Failure, Fallible, critreg_status};
use crate::planner::callbacks::critreg_callbacks;
use crate::planner::handle::{Inner, critreg_planner, with_planner};
use crate::planner::metrics::{critreg_metrics, verdict};
use crate::planner::tables::Tables;
use crate::planner::world::{Advisor, Draws, Program};
use core::ffi::c_void;
use critreg_core::Error;
use critreg_core::plan::{AbstractTask, HeuristicMemory, Memory, Planner, SearchMemory};
use critreg_core::random::generator;
use critreg_core::task::AtomSet;

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
            }
            result?;
            if let Some(length) = length {
                length.write(inner.plan_length);
            }
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
        grounding,
        names,
        ranges,
        operators,
        progress,
        links,
        estimates,
        nodes,
        open,
        initial,
        steps,
        sequence,
        failures,
        reasons,
        ..
    } = &mut inner.tables;
    let program = Program {
        callbacks,
        user_data,
        names,
        ranges,
        atoms: grounding.atoms(),
    };
    callbacks.execute.ok_or(Failure::Null("execute"))?;
    check_initial(handle, &program, grounding.initial(), initial)?;
    let task = AbstractTask {
        operators,
        initial: grounding.initial(),
        goal: grounding.goal(),
    };
    let memory = Memory {
        search: SearchMemory {
            heuristic: HeuristicMemory {
                operators: progress,
                links,
                cache: estimates,
            },
            nodes,
            open,
        },
        steps,
        failures,
        reasons,
    };
    let mut guide = Advisor {
        program,
        sequence,
        initial,
        stopped: None,
    };
    let mut planner = Planner {
        world: &mut { program },
        sampler: &mut Draws { program, sequence },
        guide: &mut guide,
        config: inner.settings,
    };
    let planned = planner.plan(task, initial, generator(seed), || generator(seed), memory)?;
    if let Some(failure) = guide.stopped {
        return Err(failure);
    }
    let metrics = critreg_metrics::new(planned.conclusion, &planned.metrics, names);
    handle.metrics.set(metrics);
    inner.plan_length = planned.steps.len();
    verdict(planned.conclusion)
}

/// Checks that those atoms hold in the initial state that the problem says.
fn check_initial(
    handle: &critreg_planner,
    program: &Program<'_>,
    expected: AtomSet,
    initial: &[f64],
) -> Fallible {
    for (place, atom) in (0..).zip(program.atoms.as_slice()) {
        if program.holds(atom, initial)? != expected.contains(place) {
            handle.culprit.set(Some(*atom));
            let what = "initial state and :init do not agree about an atom";
            return Err(Error::Mismatch(what).into());
        }
    }
    Ok(())
}
