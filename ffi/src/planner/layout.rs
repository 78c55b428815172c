//! Where the parts of a planner lie in its memory.

use crate::boundary::memory::{self, Packer, Part, append, parts};
use crate::boundary::status::Fallible;
use crate::planner::callbacks::{CRITREG_MAX_REASONS, critreg_ground};
use crate::planner::config::PlannerCapacity;
use crate::planner::handle::critreg_planner;
use crate::planner::names::Names;
use crate::planner::tables::{Numbers, Ranges, Tables};
use core::cell::Cell;
use critreg_core::Error;
use critreg_core::pddl::{Domain, Grounding, MAX_ACTIONS, Problem};
use critreg_core::plan::{self, Cached, Progress, SearchNode, Step, Waiting};
use critreg_core::task::{Arguments, AtomSet, GroundAtom, GroundOperator, OperatorId};

/// Most atoms of `:init`.
pub(crate) const MAX_FACTS: usize = 512;

parts! {
    /// The parts of a planner.
    PlannerParts with capacity: PlannerCapacity;
    handle: critreg_planner, 1;
    domain: Domain<'static>, 1;
    problem: Problem<'static>, 1;
    grounding: Grounding<'static, 'static>, 1;
    names: Names, 1;
    ranges: Ranges, MAX_ACTIONS;
    states: f64, capacity.numbers();
    operators: GroundOperator, capacity.operators;
    estimates: Cached, capacity.estimates();
    nodes: SearchNode, capacity.nodes;
    open: Waiting, capacity.nodes;
    steps: Step<Numbers>, capacity.length;
    sequence: Cell<critreg_ground>, capacity.length;
    failures: u32, MAX_ACTIONS;
    reasons: u32, CRITREG_MAX_REASONS as usize;
    progress: Progress, capacity.operators;
    links: u16, capacity.links();
    facts: GroundAtom, MAX_FACTS;
    texts: u8, capacity.pddl_bytes;
    name_bytes: u8, capacity.pddl_bytes;
}

/// Where the parts of a planner lie, and how long they are together.
pub(crate) struct PlannerLayout {
    pub(crate) parts: PlannerParts,
    capacity: PlannerCapacity,
    pub(crate) size: usize,
}

impl PlannerLayout {
    pub(crate) const fn new(capacity: PlannerCapacity) -> Option<PlannerLayout> {
        if capacity.numbers() == usize::MAX || capacity.links() == usize::MAX {
            return None;
        }
        let mut packer = Packer { size: 0 };
        match PlannerParts::new(&mut packer, capacity) {
            Some(parts) => Some(PlannerLayout {
                parts,
                capacity,
                size: packer.size,
            }),
            None => None,
        }
    }

    /// Reads the texts and prepares everything for planning.
    ///
    /// # Safety
    /// As for [`Part::fill`]; the texts do not lie in the memory.
    pub(crate) unsafe fn make(
        &self,
        memory: *mut u8,
        domain: &str,
        problem: &str,
    ) -> Fallible<Tables> {
        // SAFETY: by this function's contract; the parts do not overlap.
        unsafe {
            let problem = self.read(memory, domain, problem)?;
            let place = self.parts.grounding.place(memory);
            place.write(Grounding::new(problem)?);
            let grounding = &*place;
            let name_bytes = self.parts.name_bytes.fill(memory, 0);
            let names = self.parts.names.place(memory);
            names.write(Names::new(problem, name_bytes)?);
            let mut states = self.parts.states.fill(memory, 0.0);
            let mut state = || take(&mut states, self.capacity.state_len);
            Ok(Tables {
                problem,
                grounding,
                names: &*names,
                ranges: self.parts.ranges.fill(memory, Ranges::default()),
                operators: self.ground(memory, grounding)?,
                progress: self.parts.progress.fill(memory, Progress::default()),
                links: self.parts.links.fill(memory, 0),
                estimates: self.parts.estimates.fill(memory, Cached::default()),
                nodes: self.parts.nodes.fill(memory, SearchNode::default()),
                open: self.parts.open.fill(memory, Waiting::default()),
                initial: state(),
                steps: self.parts.steps.fill_with(memory, || step(state())),
                sequence: self
                    .parts
                    .sequence
                    .fill_with(memory, || Cell::new(critreg_ground::NONE)),
                failures: self.parts.failures.fill(memory, 0),
                reasons: self.parts.reasons.fill(memory, 0),
            })
        }
    }

    /// Copies the texts and reads the problem from the copies.
    ///
    /// # Safety
    /// As for [`PlannerLayout::make`].
    unsafe fn read(
        &self,
        memory: *mut u8,
        domain: &str,
        problem: &str,
    ) -> Fallible<&'static Problem<'static>> {
        const FULL: Error = Error::CapacityExceeded("bytes of the PDDL texts");
        // SAFETY: by this function's contract; the parts do not overlap. What they
        // hold needs no drop, so what was there may be lost.
        unsafe {
            let room = self.parts.texts.fill(memory, 0);
            let (first, rest) = room.split_at_mut_checked(domain.len() + 1).ok_or(FULL)?;
            let second = rest.get_mut(..=problem.len()).ok_or(FULL)?;
            let domain_text = memory::copy_text(domain, first)?;
            let problem_text = memory::copy_text(problem, second)?;
            let domain = self.parts.domain.place(memory);
            domain.write(Domain::parse(domain_text)?);
            let facts = self.parts.facts.fill(memory, GroundAtom::default());
            let place = self.parts.problem.place(memory);
            place.write(Problem::parse(&*domain, problem_text, facts)?);
            Ok(&*place)
        }
    }

    /// The ground operators.
    ///
    /// # Safety
    /// As for [`Part::fill`].
    unsafe fn ground(
        &self,
        memory: *mut u8,
        grounding: &Grounding<'_, '_>,
    ) -> Fallible<&'static [GroundOperator]> {
        const FULL: Error = Error::CapacityExceeded("ground operators");
        let none = GroundOperator {
            operator: OperatorId(0),
            objects: Arguments::default(),
            preconditions: AtomSet::EMPTY,
            add_effects: AtomSet::EMPTY,
            delete_effects: AtomSet::EMPTY,
        };
        // SAFETY: by this function's contract.
        let room = unsafe { self.parts.operators.fill(memory, none) };
        let mut count = 0;
        for operator in grounding.operators() {
            *room.get_mut(count).ok_or(FULL)? = operator;
            count += 1;
        }
        let operators = room.get(..count).unwrap_or(&[]);
        if plan::links(operators) > self.capacity.links() {
            return Err(FULL.into());
        }
        Ok(operators)
    }
}

/// Takes the first numbers; fewer if there are not so many.
fn take(numbers: &mut Numbers, count: usize) -> Numbers {
    let all = core::mem::take(numbers);
    let (first, rest) = all.split_at_mut(count.min(all.len()));
    *numbers = rest;
    first
}

fn step(state: Numbers) -> Step<Numbers> {
    let mut step = Step::default();
    step.state = state;
    step
}

/// The macro CRITREG_PLANNER_WORDS_FOR of the header, in bytes.
const fn promised(capacity: PlannerCapacity) -> usize {
    use crate::boundary::limits::*;
    const POINTER: usize = size_of::<*const u8>();
    CRITREG_PLANNER_FIXED_BYTES
        + CRITREG_PLANNER_POINTERS * POINTER
        + 2 * capacity.pddl_bytes
        + capacity.operators * CRITREG_OPERATOR_BYTES
        + capacity.nodes * CRITREG_NODE_BYTES
        + capacity.length * (CRITREG_PLAN_STEP_BYTES + CRITREG_PLAN_STEP_POINTERS * POINTER)
        + 8 * (capacity.length + 1) * capacity.state_len
}

// It promises enough memory; on every target that is built.
#[expect(clippy::indexing_slicing, reason = "runs while compiling only")]
const _: () = {
    const MOST: PlannerCapacity = PlannerCapacity {
        pddl_bytes: 65_536,
        operators: 65_535,
        nodes: 1 << 20,
        length: 128,
        state_len: 4096,
    };
    const SHARES: [usize; 5] = [1 << 20, 4099, 256, 17, 1];
    let mut at = 0;
    while at < SHARES.len() * SHARES.len() {
        let (first, second) = (SHARES[at % SHARES.len()], SHARES[at / SHARES.len()]);
        let capacity = PlannerCapacity {
            pddl_bytes: MOST.pddl_bytes / first,
            operators: MOST.operators / second,
            nodes: MOST.nodes / first,
            length: MOST.length / second + 1,
            state_len: MOST.state_len / first + 1,
        };
        match PlannerLayout::new(capacity) {
            Some(layout) => assert!(layout.size <= promised(capacity)),
            None => panic!(),
        }
        at += 1;
    }
};
