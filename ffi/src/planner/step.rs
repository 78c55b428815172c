//! The steps of a plan.

use crate::boundary::limits::CRITREG_MAX_PARAMETERS;
use crate::boundary::status::{Failure, Fallible, critreg_status, status_of};
use crate::boundary::structs::{self, Versioned};
use crate::planner::callbacks::critreg_ground;
use crate::planner::handle::{Inner, critreg_planner, with_planner};
use crate::planner::names::Names;
use crate::planner::tables::{SetTables, with_sets};

/// A step of a plan.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct critreg_step {
    /// Size of this struct in bytes, from critreg_step_init().
    pub struct_size: u32,
    /// How many low-level actions it takes.
    pub actions: u32,
    /// The operator and its objects.
    pub ground: critreg_ground,
    /// How many parameters it has.
    pub parameter_count: usize,
    /// Its parameters, as execute got them; 0 beyond the last.
    pub parameters: [f64; CRITREG_MAX_PARAMETERS],
    /// The state afterwards. It belongs to the planner and stays until the next
    /// critreg_plan().
    pub state: *const f64,
}

// SAFETY: it is repr(C) and starts with struct_size.
unsafe impl Versioned for critreg_step {
    const FIRST: usize = size_of::<critreg_step>();
}

const NO_STEP: critreg_step = critreg_step {
    struct_size: size_of::<critreg_step>() as u32,
    actions: 0,
    ground: critreg_ground::NONE,
    parameter_count: 0,
    parameters: [0.0; CRITREG_MAX_PARAMETERS],
    state: core::ptr::null(),
};

/// Fills a step, so that critreg_planner_step() knows its size.
///
/// @param step The step.
/// @param size sizeof *step, as for critreg_config_init().
/// @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED; CRITREG_INVALID_ARGUMENT if
/// size is smaller than the struct ever was, or larger than this library knows.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_step_init(step: *mut critreg_step, size: usize) -> critreg_status {
    // SAFETY: the header makes it the caller's promise.
    status_of(unsafe { structs::init(step, size, NO_STEP) })
}

/// A step of the plan that the last critreg_plan() found.
///
/// @param planner The planner.
/// @param index The step, from 0.
/// @param step A step from critreg_step_init(), to be filled.
/// @return CRITREG_INVALID_ARGUMENT if the plan has no such step or the struct was
/// not initialised; CRITREG_BUSY, CRITREG_NULL_POINTER, CRITREG_MISALIGNED,
/// CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_planner_step(
    planner: *mut critreg_planner,
    index: usize,
    step: *mut critreg_step,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for both.
    unsafe {
        with_planner(planner, |_, inner| {
            structs::write(inner.step(index)?, step, "step")
        })
    }
}

impl Inner {
    fn step(&self, index: usize) -> Fallible<critreg_step> {
        let index = Some(index).filter(|index| *index < self.plan_length);
        let found = with_sets!(&self.tables.sets, sets => sets.step(index, self.tables.names));
        found.ok_or(Failure::invalid("the plan has no such step"))
    }
}

impl<const N: usize> SetTables<N> {
    fn step(&self, index: Option<usize>, names: &Names) -> Option<critreg_step> {
        let found = self.steps.get(index?)?;
        let operator = self.operators.get(usize::from(found.operator))?;
        let mut step = critreg_step {
            actions: found.actions,
            ground: names.operator(operator),
            parameter_count: found.parameters.len(),
            state: found.state.as_ptr(),
            ..NO_STEP
        };
        for (value, own) in step.parameters.iter_mut().zip(&found.parameters) {
            *value = *own;
        }
        Some(step)
    }
}
