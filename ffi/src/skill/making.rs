//! Making skills in memory of the program. Controllers, skills and training tasks are then added
//! one by one, until learning begins.

use crate::boundary::handle;
use crate::boundary::limits::CRITREG_DOMAIN_TEXT_MAX;
use crate::boundary::memory::ALIGNMENT;
use crate::boundary::pointer::{self, Output};
use crate::boundary::status::{Failure, Fallible, critreg_status, status_of};
use crate::boundary::text;
use crate::planner::config::CRITREG_PDDL_TEXT_MAX;
use crate::skill::config::{self, critreg_skills_config};
use crate::skill::handle::{Inner, critreg_skills};
use crate::skill::layout::SkillsLayout;
use core::ffi::{c_char, c_void};
use critreg_core::Error;

/// How many bytes of memory skills take.
///
/// @param config How much is tried, with the capacities.
/// @return The number of bytes; 0 if the configuration is wrong or memory cannot be that
/// large.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_skills_size(config: *const critreg_skills_config) -> usize {
    // SAFETY: the header makes it the caller's promise.
    let settings = unsafe { config::read(config) };
    let layout = settings
        .ok()
        .and_then(|own| SkillsLayout::new(own.capacity));
    layout.map_or(0, |layout| layout.size)
}

/// The alignment in bytes that the memory of skills needs. An array of uint64_t and what
/// malloc() returns have it.
#[unsafe(no_mangle)]
pub extern "C" fn critreg_skills_align() -> usize {
    ALIGNMENT
}

/// Makes skills in memory of the program; nothing is known of them yet. Add controllers,
/// skills and training tasks, see SKILLS above.
///
/// @param memory Memory for the skills, aligned to critreg_skills_align(). From now on it
/// belongs to them: do not write to it, move it or copy it.
/// @param memory_len Its length in bytes, at least critreg_skills_size().
/// @param domain The PDDL domain, ended by NUL. Copied.
/// @param layout Which numbers of a state belong to which object, ended by NUL: a domain
/// text that declares objects, and groups of those whose names differ from problem to
/// problem. Copied.
/// @param config How much is tried, with the length of a state.
/// @param skills Receives the handle, which lies at the start of the memory.
/// @return CRITREG_TOO_SMALL if the memory is too short for the capacities;
/// CRITREG_SYNTAX_ERROR (ask critreg_check_pddl() or critreg_check_domain() where);
/// CRITREG_CAPACITY_EXCEEDED if the texts find no room; CRITREG_INVALID_ARGUMENT for a wrong
/// configuration or a text that is not UTF-8; CRITREG_NULL_POINTER, CRITREG_MISALIGNED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_skills_init(
    memory: *mut c_void,
    memory_len: usize,
    domain: *const c_char,
    layout: *const c_char,
    config: *const critreg_skills_config,
    skills: *mut *mut critreg_skills,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise.
    status_of(unsafe { init(memory.cast(), memory_len, [domain, layout], config, skills) })
}

/// # Safety
/// The contract of [`critreg_skills_init`].
unsafe fn init(
    memory: *mut u8,
    memory_len: usize,
    [domain, layout]: [*const c_char; 2],
    config: *const critreg_skills_config,
    skills: *mut *mut critreg_skills,
) -> Fallible {
    pointer::check(memory.cast::<u64>(), "memory")?;
    // SAFETY: by this function's contract, for all.
    let (texts, settings, output) = unsafe {
        (
            [
                pointer::text(domain, CRITREG_PDDL_TEXT_MAX, "domain")?,
                pointer::text(layout, CRITREG_DOMAIN_TEXT_MAX, "layout")?,
            ],
            config::read(config)?,
            Output::new(skills, "skills")?,
        )
    };
    let layout = SkillsLayout::new(settings.capacity)
        .filter(|layout| layout.size <= memory_len)
        .ok_or(Failure::TooSmall("the memory of the skills"))?;
    // SAFETY: the memory was checked for NULL, alignment and length; the caller lends it to
    // these skills alone, and the parts of a layout do not overlap.
    unsafe {
        let place = layout.parts.handle.place(memory);
        // If this fails, skills that were here before are none any more.
        handle::retire(place);
        critreg_skills::put(place, layout.make(memory, texts, settings)?);
        output.write(place);
    }
    Ok(())
}

/// Why the last call on these skills failed that did fail, in words, as
/// critreg_learner_message().
///
/// @param skills The skills; may be called from their callbacks.
/// @param text Receives the words, ended by NUL.
/// @param len Length of text in bytes; 0 to ask for the length only.
/// @param needed NULL, or receives the length of the words with their NUL, also if the buffer
/// is too small.
/// @return CRITREG_TOO_SMALL (nothing but needed is written); CRITREG_NULL_POINTER,
/// CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_skills_message(
    skills: *const critreg_skills,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for both.
    unsafe {
        handle::read(skills, |handle| {
            text::write(&handle.message(), text, len, needed)
        })
    }
}

impl Inner {
    pub(super) fn expect_open(&self) -> Fallible {
        match self.begun {
            true => Err(Error::OutOfSequence("learning has begun: nothing can be added").into()),
            false => Ok(()),
        }
    }

    /// Begins learning: from here on everything is as it is.
    pub(crate) fn begin(&mut self) -> Fallible {
        if self.begun {
            return Ok(());
        }
        if self.task_count == 0 {
            return Err(Error::OutOfSequence("add training tasks before learning").into());
        }
        self.add_other_actions()?;
        let training = &self.settings.training;
        let learner = &training.learner;
        let counts = [
            training.chained,
            training.budget,
            training.tasks as u32,
            training.situations as u32,
            training.states as u32,
            training.way,
            learner.calls,
            learner.certifying,
            self.settings.capacity.learner.forms as u32,
        ];
        let shares = [
            learner.exploring,
            learner.noise,
            learner.slack,
            learner.precision_wanted,
            learner.confidence,
        ];
        self.fingerprint.bytes(&learner.seed.to_le_bytes());
        self.fingerprint
            .numbers(counts.map(f64::from).into_iter().chain(shares));
        self.begun = true;
        Ok(())
    }
}
