//! Adding training tasks.

use crate::boundary::pointer;
use crate::boundary::status::{Fallible, critreg_status};
use crate::planner::config::CRITREG_PDDL_TEXT_MAX;
use crate::skill::arrangement::arranged;
use crate::skill::handle::{Inner, critreg_skills, with_skills};
use crate::skill::practice::TaskEntry;
use core::ffi::c_char;
use critreg_core::Error;

/// Adds a training task. Several dozens of them, with different numbers of objects, are a
/// good beginning: what is never tried is never learned.
///
/// @param skills The skills.
/// @param problem A problem of the PDDL domain, ended by NUL; its goal does not matter.
/// Copied.
/// @param initial The state that it begins in. Copied.
/// @param len How many numbers it has.
/// @return CRITREG_SYNTAX_ERROR (ask critreg_check_pddl() where); CRITREG_MISMATCH if the
/// state is shorter than the layout says; CRITREG_CAPACITY_EXCEEDED if there is no room for
/// another task, its objects or its numbers; CRITREG_OUT_OF_SEQUENCE after
/// critreg_skills_learn() or critreg_skills_resume(); CRITREG_NOT_FINITE, CRITREG_BUSY,
/// CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_skills_add_task(
    skills: *mut critreg_skills,
    problem: *const c_char,
    initial: *const f64,
    len: usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_skills(skills, |inner| {
            let problem = pointer::text(problem, CRITREG_PDDL_TEXT_MAX, "problem")?;
            let initial = pointer::slice(initial, len, "initial")?;
            inner.add_task(problem, initial)
        })
    }
}

impl Inner {
    fn add_task(&mut self, problem: &str, initial: &[f64]) -> Fallible {
        self.expect_open()?;
        const FULL: Error = Error::CapacityExceeded("training tasks: set config.tasks");
        let cell = self.tasks.get(self.task_count).ok_or(FULL)?;
        let mark = u16::try_from(self.task_count).map_err(|_| FULL)?;
        if initial.len() > self.settings.capacity.state_len {
            return Err(Error::CapacityExceeded("numbers of a state: set config.state_len").into());
        }
        if !initial.iter().all(|number| number.is_finite()) {
            return Err(Error::NotFinite("a number of the state").into());
        }
        let text = self.texts.copy(problem)?;
        let facts = self.facts;
        let read = self.desk.read(text);
        let state = read.and_then(|problem| Ok(arranged(&facts, problem, mark, initial)?));
        if state.is_err() {
            // SAFETY: only what lies on the desk refers to the copy, and that is read anew
            // before it is looked at again.
            unsafe { self.texts.forget_last(text) };
        }
        let _ = cell.set(TaskEntry {
            problem: text,
            state: state?,
        });
        self.task_count += 1;
        self.fingerprint.text(text);
        self.fingerprint.numbers(initial.iter().copied());
        Ok(())
    }
}
