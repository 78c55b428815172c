//! Learning skills.

use crate::boundary::status::{Failure, Fallible, critreg_status, stop_unless_ok};
use crate::planner::callbacks::critreg_callbacks;
use crate::skill::handle::{Inner, critreg_skills, with_skills};
use crate::skill::practice::Trainee;
use core::cell::{Cell, RefCell};
use core::ffi::c_void;
use critreg_core::skill::{Skills, Trainer};

/// How learning goes.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct critreg_training {
    /// Size of this struct in bytes.
    pub struct_size: u32,
    /// Which skill is being learned, from 0.
    pub skill: u32,
    /// How many skills there are.
    pub skills: u32,
    /// Runs of controllers for this skill so far, those that were kept included.
    pub runs: u32,
}

/// Called by critreg_skills_learn() after each run of a controller.
///
/// @param progress_data That of the configuration.
/// @param training How learning goes; valid until the callback returns.
/// @return CRITREG_OK to go on. Anything else stops learning and becomes the status of
/// critreg_skills_learn(): CRITREG_CANCELLED, or CRITREG_USER_STATUS and above.
pub type critreg_training_progress = Option<
    unsafe extern "C" fn(
        progress_data: *mut c_void,
        training: *const critreg_training,
    ) -> critreg_status,
>;

/// Whom to tell.
#[derive(Clone, Copy)]
pub(crate) struct Progress {
    pub(crate) callback: critreg_training_progress,
    pub(crate) data: *mut c_void,
}

impl Progress {
    pub(crate) fn tell(&self, training: &critreg_training) -> Fallible {
        let Some(callback) = self.callback else {
            return Ok(());
        };
        // SAFETY: the header says what the callback may do; what it is told outlives the call.
        stop_unless_ok(unsafe { callback(self.data, training) }, "progress")
    }
}

/// Learns all skills, one after the other, by trying operators in the program's simulator:
/// situations are collected from the training tasks, those that differ most are chosen, and
/// a learner asks with which parameters, or in which states, a controller works. That a
/// skill has no region is no error; critreg_skills_report() tells why.
///
/// If a callback stops it, call it again to go on: skills that were learned stay, and of the
/// one that was being learned the runs that were kept (critreg_skills_config.runs) are not
/// repeated. What is learned is the same as if nothing had happened. Once all is learned it
/// returns at once.
///
/// @param skills The skills.
/// @param callbacks What may be asked, from critreg_callbacks_init(): execute and holds; and
/// sample, if it is set, which proposes where to look for parameters that work, as if nothing
/// came later (one operator, advised 0). Its skills and advise do not count.
/// @param user_data Passed to the callbacks.
/// @return The status of a callback that was not CRITREG_OK; CRITREG_CAPACITY_EXCEEDED if
/// the operators or atoms of a task, or the features of a text, find no room;
/// CRITREG_INVALID_ARGUMENT or CRITREG_NOT_FINITE for an answer of a callback that is none;
/// CRITREG_OUT_OF_SEQUENCE if there is no training task; CRITREG_BUSY from a callback;
/// CRITREG_NULL_POINTER, also if execute or holds are not set, CRITREG_MISALIGNED,
/// CRITREG_NOT_A_HANDLE. In all cases the skills can be used as far as they were learned.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_skills_learn(
    skills: *mut critreg_skills,
    callbacks: *const critreg_callbacks,
    user_data: *mut c_void,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_skills(skills, |inner| {
            let callbacks = critreg_callbacks::read(callbacks)?;
            callbacks.execute.ok_or(Failure::Null("execute"))?;
            callbacks.holds.ok_or(Failure::Null("holds"))?;
            inner.begin()?;
            while inner.learned_count < inner.skill_count {
                inner.learn(&callbacks, user_data)?;
            }
            Ok(())
        })
    }
}

impl Inner {
    /// Learns the next skill.
    fn learn(&mut self, callbacks: &critreg_callbacks, user_data: *mut c_void) -> Fallible {
        let index = self.learned_count;
        for (kept, own) in self.changes_before.iter_mut().zip(&*self.changes) {
            *kept = *own;
        }
        self.journal.rewind();
        let result = self.try_to_learn(index, callbacks, user_data);
        if result.is_err() {
            // The skill begins anew the next time, with the runs that were kept.
            for (own, kept) in self.changes.iter_mut().zip(&*self.changes_before) {
                *own = *kept;
            }
            if let Some(Some(skill)) = self.skills.get_mut(index) {
                skill.set_region(None);
            }
            return result;
        }
        self.journal.clear();
        self.learned_count += 1;
        Ok(())
    }

    fn try_to_learn(
        &mut self,
        index: usize,
        callbacks: &critreg_callbacks,
        user_data: *mut c_void,
    ) -> Fallible {
        let trainee = Trainee {
            facts: self.facts,
            callbacks,
            user_data,
            desk: RefCell::new(&mut self.desk),
            journal: RefCell::new(&mut self.journal),
            progress: self.progress,
            training: Cell::new(critreg_training {
                struct_size: size_of::<critreg_training>() as u32,
                skill: index as u32,
                skills: self.skill_count as u32,
                runs: 0,
            }),
            failure: Cell::new(None),
        };
        let memory = self.training.lend();
        let mut trainer = Trainer::new(&trainee, self.settings.training, memory);
        let mut skills = Skills::resume(self.skills, self.changes);
        let tasks = self.tasks.get(..self.task_count).unwrap_or_default();
        let learned = trainer.learn(&mut skills, index, tasks);
        if let Some(failure) = trainee.failure.get() {
            return Err(failure);
        }
        if let Some(place) = self.learned.get_mut(index) {
            *place = learned?;
        }
        Ok(())
    }
}
