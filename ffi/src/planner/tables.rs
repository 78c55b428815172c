//! What lies in the memory of a planner.

use crate::boundary::pointer;
use crate::boundary::status::{Failure, Fallible};
use crate::planner::callbacks::critreg_ground;
use crate::planner::config::CRITREG_PDDL_TEXT_MAX;
use crate::planner::names::Names;
use core::cell::Cell;
use core::ffi::c_char;
use critreg_core::Error;
use critreg_core::domain::MAX_PARAMETERS;
use critreg_core::pddl::{Grounding, Missing, Problem};
use critreg_core::plan::{Cached, Progress, SearchNode, Step, Waiting};
use critreg_core::task::GroundOperator;

/// The numbers of a state, in the caller's memory.
pub(crate) type Numbers = &'static mut [f64];

/// The ranges of an operator's parameters.
#[derive(Clone, Copy, Default)]
pub(crate) struct Ranges {
    ranges: [[f64; 2]; MAX_PARAMETERS],
    count: usize,
}

impl Ranges {
    /// These ranges; those beyond the last parameter are left out.
    pub(crate) fn new(ranges: &[[f64; 2]]) -> Ranges {
        let mut own = Ranges::default();
        for (slot, range) in own.ranges.iter_mut().zip(ranges) {
            *slot = *range;
            own.count += 1;
        }
        own
    }

    /// The ranges of so many parameters.
    ///
    /// # Safety
    /// If not NULL and aligned, `ranges` is readable for both ends of each.
    pub(crate) unsafe fn read(ranges: *const f64, count: usize) -> Fallible<Ranges> {
        if count > MAX_PARAMETERS {
            return Err(Error::CapacityExceeded("parameters of an operator").into());
        }
        // SAFETY: by this function's contract.
        let numbers = unsafe { pointer::slice(ranges, 2 * count, "ranges")? };
        if !numbers.iter().all(|number| number.is_finite()) {
            return Err(Error::NotFinite("an end of a range").into());
        }
        let (ranges, _) = numbers.as_chunks();
        if ranges.iter().any(|[low, high]| low > high) {
            return Err(Failure::invalid("a range ends below its beginning"));
        }
        Ok(Ranges::new(ranges))
    }

    pub(crate) fn as_slice(&self) -> &[[f64; 2]] {
        self.ranges.get(..self.count).unwrap_or(&[])
    }
}

/// The parts of a planner, filled.
pub(crate) struct Tables {
    pub(crate) problem: &'static Problem<'static>,
    pub(crate) names: &'static Names,
    /// The ranges of each action.
    pub(crate) ranges: &'static mut [Ranges],
    pub(crate) progress: &'static mut [Progress],
    pub(crate) links: &'static mut [u16],
    pub(crate) open: &'static mut [Waiting],
    pub(crate) visited: &'static mut [u32],
    pub(crate) initial: Numbers,
    pub(crate) sequence: &'static [Cell<critreg_ground>],
    pub(crate) failures: &'static mut [u32],
    pub(crate) reasons: &'static mut [u32],
    pub(crate) sets: Sets,
}

/// What holds sets of atoms with `N` words.
pub(crate) struct SetTables<const N: usize> {
    pub(crate) grounding: &'static Grounding<'static, 'static, N>,
    pub(crate) operators: &'static [GroundOperator<N>],
    /// What is missing for the goal, if it cannot be reached.
    pub(crate) missing: Option<Missing>,
    pub(crate) estimates: &'static mut [Cached<N>],
    pub(crate) nodes: &'static mut [SearchNode<N>],
    pub(crate) steps: &'static mut [Step<Numbers, N>],
}

/// The same with as many words as are needed for 128, 512 or 1024 atoms. Sets are values
/// all over the planner, which makes small ones as fast as numbers; so there is one planner
/// for each of these sizes, and not one that asks how long they are.
pub(crate) enum Sets {
    Small(SetTables<2>),
    Medium(SetTables<8>),
    Large(SetTables<16>),
}

/// Does the same with the tables of any size.
macro_rules! with_sets {
    ($sets:expr, $tables:ident => $body:expr) => {
        match $sets {
            $crate::planner::tables::Sets::Small($tables) => $body,
            $crate::planner::tables::Sets::Medium($tables) => $body,
            $crate::planner::tables::Sets::Large($tables) => $body,
        }
    };
}
pub(crate) use with_sets;

pub(crate) const NO_ACTION: Failure =
    Failure::invalid("the PDDL domain has no action of this name");

impl Tables {
    /// The place of the action with a name.
    ///
    /// # Safety
    /// If not NULL, the name can be read up to its NUL.
    pub(crate) unsafe fn action(&self, name: *const c_char) -> Fallible<usize> {
        // SAFETY: by this function's contract.
        let name = unsafe { pointer::text(name, CRITREG_PDDL_TEXT_MAX, "name")? };
        let found = self.problem.domain().find_action(name);
        Ok(usize::from(found.ok_or(NO_ACTION)?.0))
    }
}
