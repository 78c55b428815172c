//! How much is tried to learn skills, and what they have room for.

use crate::boundary::status::{Failure, Fallible, critreg_status, status_of};
use crate::boundary::structs::{self, Versioned};
use crate::learner::any::Capacity;
use crate::learner::config::{self as learner, CRITREG_DEFAULT_FORMS, critreg_config};
use crate::skill::layout::MAX_NARROWING;
use crate::skill::learning::critreg_training_progress;
use core::ffi::c_void;
use critreg_core::learn::version_space;
use critreg_core::skill::Training;
use critreg_core::task::MAX_STATE_VALUES;

/// Most numbers of a state that skills are learned or used in.
pub const CRITREG_MAX_STATE_NUMBERS: u32 = 64;

/// Most objects of a task that skills are learned or used in.
pub const CRITREG_MAX_STATE_OBJECTS: u32 = 32;

/// Most ground operators of a task that skills are learned from, and most ground atoms.
/// A planner that uses the skills may have more.
pub const CRITREG_MAX_TRAINING_OPERATORS: u32 = 512;

/// Bytes for texts that skills have room for unless the configuration tells.
pub const CRITREG_DEFAULT_SKILL_TEXTS: u32 = 65_536;

const _: () = assert!(CRITREG_MAX_STATE_NUMBERS as usize == MAX_STATE_VALUES);

/// How much is tried to learn skills, and what there is room for. Fill it with
/// critreg_skills_config_init(), set state_len, and change what you like. Nothing in it is
/// kept after critreg_skills_init() returns, except the progress callback and its data.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct critreg_skills_config {
    /// Size of this struct in bytes, from critreg_skills_config_init().
    pub struct_size: u32,
    /// Most numbers of a state, from 1 to CRITREG_MAX_STATE_NUMBERS. Default 0, which is
    /// refused: say how many.
    pub state_len: u32,
    /// What the learner of a skill is told: seed, calls, slack and so on, and how many forms
    /// it has room for. Its learner, precision, instances, steps and progress do not count.
    /// Default NULL: the defaults of critreg_config, with CRITREG_DEFAULT_FORMS.
    pub learner: *const critreg_config,
    /// Questions about two controllers. Default 200.
    pub chained: u32,
    /// How many controllers may be run to learn one about which there is a single skill: its
    /// questions are what the ways to situations leave of them, if that is more than the
    /// calls of the learner. Default 0.
    pub budget: u32,
    /// Situations that a skill with parameters is tried in, chosen to differ. Default 20.
    pub situations: u32,
    /// Situations that a skill without parameters is tried in, each once. Default 150.
    pub states: u32,
    /// Training tasks that situations of one skill are taken from. Default 150.
    pub situation_tasks: u32,
    /// Training tasks to have room for. Default 150.
    pub tasks: u32,
    /// Controllers to have room for; an action that belongs to none is one. Default 16.
    pub controllers: u32,
    /// Skills to have room for. Default 16.
    pub skills: u32,
    /// Bytes to have room for in all texts together, their NULs included: the PDDL domain,
    /// the layout, the skills, the problems of the training tasks. Default
    /// CRITREG_DEFAULT_SKILL_TEXTS.
    pub texts: u32,
    /// Nodes of the search for a way to a situation. Default 1024.
    pub nodes: u32,
    /// Atoms and numbers of :init of a problem to have room for. Default 512.
    pub facts: u32,
    /// Runs of controllers to keep of the skill that is being learned: after a stop they are
    /// not repeated. Default 512.
    pub runs: u32,
    /// Controllers that may be run on the way to one situation, at each attempt. Default
    /// 10000; say less where a run is expensive.
    pub way: u32,
    /// Called after each run of a controller. Default NULL.
    pub progress: critreg_training_progress,
    /// Passed to the progress callback. Default NULL.
    pub progress_data: *mut c_void,
}

// SAFETY: it is repr(C) and starts with struct_size.
unsafe impl Versioned for critreg_skills_config {
    const FIRST: usize = size_of::<critreg_skills_config>();
}

fn defaults() -> critreg_skills_config {
    let training = Training::default();
    critreg_skills_config {
        struct_size: size_of::<critreg_skills_config>() as u32,
        state_len: 0,
        learner: core::ptr::null(),
        chained: training.chained,
        budget: training.budget,
        situations: training.situations as u32,
        states: training.states as u32,
        situation_tasks: training.tasks as u32,
        tasks: 150,
        controllers: 16,
        skills: 16,
        texts: CRITREG_DEFAULT_SKILL_TEXTS,
        nodes: 1024,
        facts: 512,
        runs: 512,
        way: training.way,
        progress: None,
        progress_data: core::ptr::null_mut(),
    }
}

/// What skills have room for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SkillsCapacity {
    pub(crate) state_len: usize,
    pub(crate) situations: usize,
    pub(crate) tasks: usize,
    pub(crate) controllers: usize,
    pub(crate) skills: usize,
    pub(crate) texts: usize,
    pub(crate) nodes: usize,
    pub(crate) facts: usize,
    pub(crate) runs: usize,
    pub(crate) learner: version_space::Capacity,
}

/// Numbers that a kept run takes beside those of the state.
const RUN_HEAD: usize = 2;

impl SkillsCapacity {
    /// Situations to choose from.
    pub(crate) const fn candidates(self) -> usize {
        self.situations.saturating_mul(4)
    }

    /// Numbers of the instances of all of them.
    pub(crate) const fn instance_numbers(self) -> usize {
        self.candidates().saturating_mul(MAX_STATE_VALUES)
    }

    /// Predicates that narrow the groups of all skills.
    pub(crate) const fn narrowing(self) -> usize {
        self.skills.saturating_mul(MAX_NARROWING)
    }

    /// Numbers of the runs that are kept.
    pub(crate) const fn journal(self) -> usize {
        self.runs.saturating_mul(self.state_len + RUN_HEAD)
    }
}

/// A configuration that was read: what to try, and what to have room for.
#[derive(Clone, Copy)]
pub(crate) struct Settings {
    pub(crate) training: Training,
    pub(crate) capacity: SkillsCapacity,
    pub(crate) progress: critreg_training_progress,
    pub(crate) progress_data: *mut c_void,
}

/// Reads a configuration.
///
/// # Safety
/// If not NULL and aligned, its `struct_size` is readable and as many bytes are, and so is
/// the configuration of the learner.
pub(crate) unsafe fn read(config: *const critreg_skills_config) -> Fallible<Settings> {
    // SAFETY: by this function's contract; every bit pattern is a value of each field.
    let (config, mut learner) = unsafe {
        let config = structs::read(config, defaults(), "config")?;
        (config, learner::read(config.learner)?)
    };
    if !(1..=CRITREG_MAX_STATE_NUMBERS).contains(&config.state_len) {
        return Err(Failure::invalid(
            "config.state_len is to be set, from 1 to 64",
        ));
    }
    let situations = config.situations.max(config.states).max(1);
    learner.learner = learner::CRITREG_VERSION_SPACE;
    learner.instances = situations;
    learner.steps = 2;
    if learner.forms == 0 {
        learner.forms = CRITREG_DEFAULT_FORMS;
    }
    let questions = [learner.calls, config.chained, config.budget, situations];
    let questions = questions
        .iter()
        .max()
        .map_or(0, |most| most.saturating_add(2));
    learner.observations = learner.observations.max(questions);
    #[cfg_attr(not(feature = "algorithm1"), expect(irrefutable_let_patterns))]
    let Capacity::VersionSpace(capacity) = learner.capacity()? else {
        return Err(Failure::invalid("skills are learned by one learner"));
    };
    Ok(Settings {
        training: Training {
            learner: learner.version_space()?,
            chained: config.chained,
            budget: config.budget,
            tasks: config.situation_tasks as usize,
            situations: config.situations as usize,
            states: config.states as usize,
            way: config.way,
        },
        capacity: SkillsCapacity {
            state_len: config.state_len as usize,
            situations: situations as usize,
            tasks: config.tasks as usize,
            controllers: config.controllers as usize,
            skills: config.skills as usize,
            texts: config.texts as usize,
            nodes: config.nodes as usize,
            facts: config.facts as usize,
            runs: config.runs as usize,
            learner: capacity,
        },
        progress: config.progress,
        progress_data: config.progress_data,
    })
}

/// Fills a configuration with the defaults.
///
/// @param config The configuration.
/// @param size sizeof *config, as for critreg_config_init().
/// @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED; CRITREG_INVALID_ARGUMENT if
/// size is smaller than the struct ever was, or larger than this library knows.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_skills_config_init(
    config: *mut critreg_skills_config,
    size: usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise.
    status_of(unsafe { structs::init(config, size, defaults()) })
}
