//! Where the parts of a planner lie in its memory.

use crate::boundary::memory::{self, Packer, Part, append};
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

/// The parts of a planner.
pub(crate) struct PlannerLayout {
    pub(crate) handle: Part<critreg_planner>,
    capacity: PlannerCapacity,
    domain: Part<Domain<'static>>,
    problem: Part<Problem<'static>>,
    grounding: Part<Grounding<'static, 'static>>,
    names: Part<Names>,
    ranges: Part<Ranges>,
    states: Part<f64>,
    operators: Part<GroundOperator>,
    estimates: Part<Cached>,
    nodes: Part<SearchNode>,
    open: Part<Waiting>,
    steps: Part<Step<Numbers>>,
    sequence: Part<Cell<critreg_ground>>,
    failures: Part<u32>,
    reasons: Part<u32>,
    progress: Part<Progress>,
    links: Part<u16>,
    facts: Part<GroundAtom>,
    texts: Part<u8>,
    name_bytes: Part<u8>,
    pub(crate) size: usize,
}

impl PlannerLayout {
    pub(crate) const fn new(capacity: PlannerCapacity) -> Option<PlannerLayout> {
        if capacity.numbers() == usize::MAX || capacity.links() == usize::MAX {
            return None;
        }
        let mut packer = Packer { size: 0 };
        Some(PlannerLayout {
            handle: append!(packer, 1),
            capacity,
            domain: append!(packer, 1),
            problem: append!(packer, 1),
            grounding: append!(packer, 1),
            names: append!(packer, 1),
            ranges: append!(packer, MAX_ACTIONS),
            states: append!(packer, capacity.numbers()),
            operators: append!(packer, capacity.operators),
            estimates: append!(packer, capacity.estimates()),
            nodes: append!(packer, capacity.nodes),
            open: append!(packer, capacity.nodes),
            steps: append!(packer, capacity.length),
            sequence: append!(packer, capacity.length),
            failures: append!(packer, MAX_ACTIONS),
            reasons: append!(packer, CRITREG_MAX_REASONS as usize),
            progress: append!(packer, capacity.operators),
            links: append!(packer, capacity.links()),
            facts: append!(packer, MAX_FACTS),
            texts: append!(packer, capacity.pddl_bytes),
            name_bytes: append!(packer, capacity.pddl_bytes),
            size: packer.size,
        })
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
            let place = self.grounding.place(memory);
            place.write(Grounding::new(problem)?);
            let grounding = &*place;
            let name_bytes = self.name_bytes.fill(memory, 0);
            let names = self.names.place(memory);
            names.write(Names::new(problem, name_bytes)?);
            let mut states = self.states.fill(memory, 0.0);
            let mut state = || take(&mut states, self.capacity.state_len);
            Ok(Tables {
                problem,
                grounding,
                names: &*names,
                ranges: self.ranges.fill(memory, Ranges::default()),
                operators: self.ground(memory, grounding)?,
                progress: self.progress.fill(memory, Progress::default()),
                links: self.links.fill(memory, 0),
                estimates: self.estimates.fill(memory, Cached::default()),
                nodes: self.nodes.fill(memory, SearchNode::default()),
                open: self.open.fill(memory, Waiting::default()),
                initial: state(),
                steps: self.steps.fill_with(memory, || step(state())),
                sequence: self
                    .sequence
                    .fill_with(memory, || Cell::new(critreg_ground::NONE)),
                failures: self.failures.fill(memory, 0),
                reasons: self.reasons.fill(memory, 0),
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
            let room = self.texts.fill(memory, 0);
            let (first, rest) = room.split_at_mut_checked(domain.len() + 1).ok_or(FULL)?;
            let second = rest.get_mut(..=problem.len()).ok_or(FULL)?;
            let domain_text = memory::copy_text(domain, first)?;
            let problem_text = memory::copy_text(problem, second)?;
            let domain = self.domain.place(memory);
            domain.write(Domain::parse(domain_text)?);
            let facts = self.facts.fill(memory, GroundAtom::default());
            let place = self.problem.place(memory);
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
        let room = unsafe { self.operators.fill(memory, none) };
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
