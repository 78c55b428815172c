//! What a planner is told to do, and what it has room for.

use crate::boundary::status::{Failure, Fallible, critreg_status, status_of};
use crate::boundary::structs::{self, Versioned};
use crate::planner::callbacks::CRITREG_MAX_REASONS;
use critreg_core::plan::{self, Heuristic, MAX_SKELETON};
use critreg_core::task::MAX_ARGUMENTS;

/// For critreg_planner_config.heuristic: LM-cut (Helmert and Domshlak 2009), the
/// default. Never too high, so that shorter sequences come before longer ones.
pub const CRITREG_LM_CUT: u32 = 1;

/// For critreg_planner_config.heuristic: h-max (Bonet and Geffner 2001), never
/// above LM-cut.
pub const CRITREG_H_MAX: u32 = 2;

/// For critreg_planner_config.heuristic: h-add (Bonet and Geffner 2001). It may be
/// too high, so that longer sequences can come before shorter ones.
pub const CRITREG_H_ADD: u32 = 3;

/// For critreg_planner_config.heuristic: none. The search is breadth first.
pub const CRITREG_BLIND: u32 = 4;

/// Most objects of an atom, and most parameters of a PDDL action.
pub const CRITREG_MAX_ARGUMENTS: usize = 10;

/// Most operators in a plan, and in a sequence of them.
pub const CRITREG_MAX_PLAN_LENGTH: u32 = 128;

/// Operators in the longest plan unless the configuration tells.
pub const CRITREG_DEFAULT_PLAN_LENGTH: u32 = 32;

/// Bytes for PDDL texts that a planner has room for unless the configuration
/// tells.
pub const CRITREG_DEFAULT_PDDL_BYTES: u32 = 8192;

/// Ground operators that a planner has room for unless the configuration tells.
pub const CRITREG_DEFAULT_OPERATORS: u32 = 256;

/// Nodes of the search that a planner has room for unless the configuration tells.
pub const CRITREG_DEFAULT_NODES: u32 = 4096;

/// Ground atoms that a planner has room for unless the configuration tells.
pub const CRITREG_DEFAULT_ATOMS: u32 = 128;

/// Most ground atoms of a planner.
pub const CRITREG_MAX_ATOMS: u32 = 1024;

/// Atoms and numbers of :init that a planner has room for unless the configuration tells.
pub const CRITREG_DEFAULT_FACTS: u32 = 512;

/// Longest domain or problem text of a planner in bytes, with its NUL.
pub const CRITREG_PDDL_TEXT_MAX: usize = 65_536;

const _: () = assert!(CRITREG_MAX_ARGUMENTS == MAX_ARGUMENTS);
const _: () = assert!(CRITREG_MAX_PLAN_LENGTH as usize == MAX_SKELETON);

/// How to plan, how long, and with how much memory. Fill it with
/// critreg_planner_config_init(), set state_len, and change what you like. Nothing
/// in it is kept after critreg_planner_init() returns.
///
/// Budgets are counts, not times: the same inputs end in the same way on every
/// machine.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct critreg_planner_config {
    /// Size of this struct in bytes, from critreg_planner_config_init().
    pub struct_size: u32,
    /// What guides the search: CRITREG_LM_CUT, the default, CRITREG_H_MAX,
    /// CRITREG_H_ADD or CRITREG_BLIND.
    pub heuristic: u32,
    /// Numbers of a state, at least 1. Default 0, which is refused: say how many.
    pub state_len: u32,
    /// Most plan skeletons to refine. Default 1000.
    pub max_skeletons: u32,
    /// Tries of a step with parameters before an earlier one is tried again; a
    /// step without any has one. Default 10.
    pub max_tries: u32,
    /// Most operators in a plan, from 1 to CRITREG_MAX_PLAN_LENGTH; each takes
    /// memory for a state. Default CRITREG_DEFAULT_PLAN_LENGTH.
    pub max_length: u32,
    /// Most low-level actions in a plan, as execute counts them. Default 100.
    pub max_actions: u32,
    /// Most calls of execute, with tries for which sample found nothing. Default 10000.
    pub max_samples: u32,
    /// How many nodes are expanded and samples drawn with advice: what advise
    /// postpones, what sample draws from a region or finds to be empty. If there is
    /// no plan by then, planning begins anew without any, and so do the limits
    /// above. So wrong advice costs at most so much, but never a plan. Default 256.
    pub patience: u32,
    /// Bytes to have room for in the domain and problem text together, their NULs
    /// included. Default CRITREG_DEFAULT_PDDL_BYTES.
    pub pddl_bytes: u32,
    /// Ground operators to have room for: every choice of objects for every PDDL
    /// action that the static preconditions admit. One with more than eight
    /// preconditions and add effects counts for several. Default
    /// CRITREG_DEFAULT_OPERATORS.
    pub operators: u32,
    /// Nodes of the search to have room for: sequences of operators that are
    /// created. Default CRITREG_DEFAULT_NODES.
    pub nodes: u32,
    /// Ground atoms to have room for that can change, and negations that preconditions
    /// ask for. Sets of them have room for 128, 512 or 1024, so that is what each operator
    /// and node takes memory for. Default CRITREG_DEFAULT_ATOMS, at most
    /// CRITREG_MAX_ATOMS.
    pub atoms: u32,
    /// Atoms and numbers of :init to have room for. Default CRITREG_DEFAULT_FACTS.
    pub facts: u32,
    /// How many sequences that lead to one abstract state are extended before all others
    /// are; more only if a skeleton cannot be refined, or nothing else is left. Where no
    /// action has parameters it is 1. Default 4. 0 is no bound: then a beginning of a
    /// skeleton that cannot work is tried again in others, too.
    pub skeletons_per_state: u32,
    /// With skills: how many draws of the parameters of a step are followed, in the states
    /// that are expected of the steps after it, before the step is taken for impossible; and
    /// likewise the steps of a sequence before it is postponed. In the first try of a step, of
    /// up to 8 draws with which all steps can work the one is taken that keeps later states
    /// farthest from the bounds of their regions. Default 0: none are followed, and only what
    /// holds with all parameters counts.
    pub lookahead: u32,
}

// SAFETY: it is repr(C) and starts with struct_size.
unsafe impl Versioned for critreg_planner_config {
    const FIRST: usize = size_of::<critreg_planner_config>();
}

/// A configuration that was read.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Settings {
    pub(crate) plan: plan::Config,
    /// Draws that skills follow.
    pub(crate) lookahead: u32,
}

/// Links between atoms and an operator, on the average at most.
pub(crate) const LINKS_OF_OPERATOR: usize = 8;

/// What a planner has room for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PlannerCapacity {
    pub(crate) pddl_bytes: usize,
    pub(crate) operators: usize,
    pub(crate) nodes: usize,
    pub(crate) atoms: usize,
    pub(crate) facts: usize,
    pub(crate) length: usize,
    pub(crate) state_len: usize,
}

impl PlannerCapacity {
    /// Links between atoms and operators.
    pub(crate) const fn links(self) -> usize {
        self.operators.saturating_mul(LINKS_OF_OPERATOR)
    }

    /// Counters of reasons: of the program's, and of each operator.
    pub(crate) const fn reasons(self) -> usize {
        self.operators.saturating_add(CRITREG_MAX_REASONS as usize)
    }

    /// Estimates of the heuristic to remember.
    pub(crate) const fn estimates(self) -> usize {
        self.nodes / 16 + 1
    }

    /// Numbers of the states after each step, and of the initial one.
    pub(crate) const fn numbers(self) -> usize {
        self.length.saturating_add(1).saturating_mul(self.state_len)
    }
}

fn defaults() -> critreg_planner_config {
    let settings = plan::Config::default();
    critreg_planner_config {
        struct_size: size_of::<critreg_planner_config>() as u32,
        heuristic: CRITREG_LM_CUT,
        state_len: 0,
        max_skeletons: settings.max_skeletons,
        max_tries: settings.max_tries,
        max_length: CRITREG_DEFAULT_PLAN_LENGTH,
        max_actions: settings.max_actions,
        max_samples: settings.max_samples,
        patience: settings.patience,
        pddl_bytes: CRITREG_DEFAULT_PDDL_BYTES,
        operators: CRITREG_DEFAULT_OPERATORS,
        nodes: CRITREG_DEFAULT_NODES,
        atoms: CRITREG_DEFAULT_ATOMS,
        facts: CRITREG_DEFAULT_FACTS,
        skeletons_per_state: 4,
        lookahead: 0,
    }
}

/// Reads a configuration.
///
/// # Safety
/// If the pointer is not NULL and aligned, its `struct_size` is readable and as
/// many bytes are.
pub(crate) unsafe fn read(
    config: *const critreg_planner_config,
) -> Fallible<critreg_planner_config> {
    // SAFETY: by this function's contract; every bit pattern is a value of each
    // field.
    unsafe { structs::read(config, defaults(), "config") }
}

impl critreg_planner_config {
    /// What it asks to have room for.
    pub(crate) fn capacity(&self) -> Fallible<PlannerCapacity> {
        if self.state_len == 0 {
            return Err(Failure::invalid("config.state_len is to be set"));
        }
        if !(1..=CRITREG_MAX_PLAN_LENGTH).contains(&self.max_length) {
            return Err(Failure::invalid("config.max_length is from 1 to 128"));
        }
        if self.max_tries == 0 {
            return Err(Failure::invalid("config.max_tries is at least 1"));
        }
        if self.atoms > CRITREG_MAX_ATOMS {
            return Err(Failure::invalid("config.atoms is at most 1024"));
        }
        Ok(PlannerCapacity {
            pddl_bytes: self.pddl_bytes as usize,
            operators: self.operators as usize,
            nodes: self.nodes as usize,
            atoms: self.atoms as usize,
            facts: self.facts as usize,
            length: self.max_length as usize,
            state_len: self.state_len as usize,
        })
    }

    /// How to plan.
    pub(crate) fn settings(&self) -> Fallible<Settings> {
        let heuristic = match self.heuristic {
            CRITREG_LM_CUT => Heuristic::LandmarkCut,
            CRITREG_H_MAX => Heuristic::Max,
            CRITREG_H_ADD => Heuristic::Additive,
            CRITREG_BLIND => Heuristic::Blind,
            _ => return Err(Failure::invalid("there is no heuristic with this number")),
        };
        let plan = plan::Config {
            heuristic,
            max_skeletons: self.max_skeletons,
            max_tries: self.max_tries,
            max_length: self.max_length as usize,
            max_actions: self.max_actions,
            max_samples: self.max_samples,
            skeletons_per_state: match self.skeletons_per_state {
                0 => u32::MAX,
                bound => bound,
            },
            patience: self.patience,
        };
        Ok(Settings {
            plan,
            lookahead: self.lookahead,
        })
    }
}

/// Fills a configuration with the defaults.
///
/// @param config The configuration.
/// @param size sizeof *config, as for critreg_config_init().
/// @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED; CRITREG_INVALID_ARGUMENT if
/// size is smaller than the struct ever was, or larger than this library knows.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_planner_config_init(
    config: *mut critreg_planner_config,
    size: usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise.
    status_of(unsafe { structs::init(config, size, defaults()) })
}
