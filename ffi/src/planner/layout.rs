//! Where the parts of a planner lie in its memory.

use crate::boundary::limits::CRITREG_REASON_MAX;
use crate::boundary::memory::{self, Packer, Part, append, parts};
use crate::boundary::status::Fallible;
use crate::planner::callbacks::critreg_ground;
use crate::planner::config::PlannerCapacity;
use crate::planner::handle::critreg_planner;
use crate::planner::names::Names;
use crate::planner::tables::{Numbers, Ranges, SetTables, Sets, Tables};
use core::cell::Cell;
use critreg_core::Error;
use critreg_core::pddl::{Domain, Fact, Grounding, MAX_ACTIONS, Problem};
use critreg_core::plan::{self, Cached, Progress, SearchNode, Step, Waiting};
use critreg_core::task::GroundOperator;

/// What there is, or leaves the function with `None` (`?` is not const).
macro_rules! some {
    ($option:expr) => {
        match $option {
            Some(value) => value,
            None => return None,
        }
    };
}

parts! {
    /// The parts of a planner, apart from sets of atoms.
    PlannerParts with capacity: PlannerCapacity;
    handle: critreg_planner, 1;
    domain: Domain<'static>, 1;
    problem: Problem<'static>, 1;
    names: Names, 1;
    ranges: Ranges, MAX_ACTIONS;
    states: f64, capacity.numbers();
    open: Waiting, capacity.nodes;
    visited: u32, capacity.nodes;
    sequence: Cell<critreg_ground>, capacity.length;
    failures: u32, MAX_ACTIONS;
    reasons: u32, capacity.reasons();
    words: Cell<u8>, CRITREG_REASON_MAX;
    progress: Progress, capacity.operators;
    facts: Fact, capacity.facts;
    links: u16, capacity.links();
    texts: u8, capacity.pddl_bytes;
    name_bytes: u8, capacity.pddl_bytes;
}

parts! {
    /// The parts with sets of atoms, which have `N` words.
    SetParts[N] with capacity: PlannerCapacity;
    grounding: Grounding<'static, 'static, N>, 1;
    operators: GroundOperator<N>, capacity.operators;
    estimates: Cached<N>, capacity.estimates();
    nodes: SearchNode<N>, capacity.nodes;
    steps: Step<Numbers, N>, capacity.length;
}

/// The same of any size.
enum AnySetParts {
    Small(SetParts<2>),
    Medium(SetParts<8>),
    Large(SetParts<16>),
}

impl AnySetParts {
    const fn new(packer: &mut Packer, capacity: PlannerCapacity) -> Option<AnySetParts> {
        Some(match capacity.atoms {
            0..=128 => AnySetParts::Small(some!(SetParts::new(packer, capacity))),
            129..=512 => AnySetParts::Medium(some!(SetParts::new(packer, capacity))),
            _ => AnySetParts::Large(some!(SetParts::new(packer, capacity))),
        })
    }
}

/// Where the parts of a planner lie, and how long they are together.
pub(crate) struct PlannerLayout {
    pub(crate) parts: PlannerParts,
    sets: AnySetParts,
    capacity: PlannerCapacity,
    pub(crate) size: usize,
}

impl PlannerLayout {
    pub(crate) const fn new(capacity: PlannerCapacity) -> Option<PlannerLayout> {
        if capacity.numbers() == usize::MAX || capacity.links() == usize::MAX {
            return None;
        }
        let mut packer = Packer { size: 0 };
        let parts = some!(PlannerParts::new(&mut packer, capacity));
        let sets = some!(AnySetParts::new(&mut packer, capacity));
        Some(PlannerLayout {
            parts,
            sets,
            capacity,
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
            let name_bytes = self.parts.name_bytes.fill(memory, 0);
            let names = self.parts.names.place(memory);
            names.write(Names::new(problem, name_bytes)?);
            let mut states = self.parts.states.fill(memory, 0.0);
            let initial = take(&mut states, self.capacity.state_len);
            let (capacity, states) = (self.capacity, &mut states);
            let sets = match &self.sets {
                AnySetParts::Small(parts) => {
                    Sets::Small(parts.make(memory, problem, capacity, states)?)
                }
                AnySetParts::Medium(parts) => {
                    Sets::Medium(parts.make(memory, problem, capacity, states)?)
                }
                AnySetParts::Large(parts) => {
                    Sets::Large(parts.make(memory, problem, capacity, states)?)
                }
            };
            Ok(Tables {
                problem,
                names: &*names,
                ranges: self.parts.ranges.fill(memory, Ranges::default()),
                progress: self.parts.progress.fill(memory, Progress::default()),
                links: self.parts.links.fill(memory, 0),
                open: self.parts.open.fill(memory, Waiting::default()),
                visited: self.parts.visited.fill(memory, 0),
                initial,
                sequence: self
                    .parts
                    .sequence
                    .fill_with(memory, || Cell::new(critreg_ground::NONE)),
                failures: self.parts.failures.fill(memory, 0),
                reasons: self.parts.reasons.fill(memory, 0),
                sets,
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
        const FULL: Error =
            Error::CapacityExceeded("bytes of the PDDL texts: set config.pddl_bytes");
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
            let facts = self.parts.facts.fill(memory, Fact::default());
            let place = self.parts.problem.place(memory);
            place.write(Problem::parse(&*domain, problem_text, facts)?);
            Ok(&*place)
        }
    }
}

impl<const N: usize> SetParts<N> {
    /// Grounds a problem and prepares all tables with sets.
    ///
    /// # Safety
    /// As for [`Part::fill`].
    unsafe fn make(
        &self,
        memory: *mut u8,
        problem: &'static Problem<'static>,
        capacity: PlannerCapacity,
        states: &mut Numbers,
    ) -> Fallible<SetTables<N>> {
        // SAFETY: by this function's contract; the parts do not overlap.
        unsafe {
            let grounding = self.grounding.put(memory, Grounding::new(problem)?);
            if grounding.atoms().as_slice().len() > capacity.atoms {
                return Err(Error::CapacityExceeded("ground atoms: set config.atoms").into());
            }
            let operators = self.operators.fill(memory, GroundOperator::NONE);
            let operators = ground(grounding, operators, capacity)?;
            // That it is too much work to say is no reason to refuse the texts.
            let missing = grounding.missing().unwrap_or(None);
            Ok(SetTables {
                missing,
                grounding,
                operators,
                estimates: self.estimates.fill(memory, Cached::default()),
                nodes: self.nodes.fill(memory, SearchNode::default()),
                steps: self
                    .steps
                    .fill_with(memory, || step(take(states, capacity.state_len))),
            })
        }
    }
}

/// The ground operators, in a room for them.
fn ground<const N: usize>(
    grounding: &mut Grounding<'_, '_, N>,
    room: &'static mut [GroundOperator<N>],
    capacity: PlannerCapacity,
) -> Fallible<&'static [GroundOperator<N>]> {
    const FULL: Error = Error::CapacityExceeded("ground operators: set config.operators");
    let mut count = 0;
    grounding.operators(&mut |operator| {
        *room.get_mut(count).ok_or(FULL)? = operator;
        count += 1;
        Ok(())
    })?;
    let operators = room.get(..count).unwrap_or(&[]);
    if plan::links(operators) > capacity.links() {
        return Err(FULL.into());
    }
    Ok(operators)
}

/// Takes the first numbers; fewer if there are not so many.
fn take(numbers: &mut Numbers, count: usize) -> Numbers {
    let all = core::mem::take(numbers);
    let (first, rest) = all.split_at_mut(count.min(all.len()));
    *numbers = rest;
    first
}

fn step<const N: usize>(state: Numbers) -> Step<Numbers, N> {
    let mut step = Step::default();
    step.state = state;
    step
}

/// The macro CRITREG_PLANNER_WORDS_OF of the header, in bytes.
const fn promised(capacity: PlannerCapacity) -> usize {
    use crate::boundary::limits::*;
    const POINTER: usize = size_of::<*const u8>();
    let more = match capacity.atoms {
        0..=128 => 0,
        129..=512 => 6,
        _ => 14,
    };
    CRITREG_PLANNER_FIXED_BYTES
        + CRITREG_PLANNER_POINTERS * POINTER
        + CRITREG_PLANNER_WORD_BYTES * more
        + 2 * capacity.pddl_bytes
        + capacity.operators * (CRITREG_OPERATOR_BYTES + 24 * more)
        + capacity.nodes * (CRITREG_NODE_BYTES + 9 * more)
        + capacity.facts * CRITREG_FACT_BYTES
        + capacity.length
            * (CRITREG_PLAN_STEP_BYTES + CRITREG_PLAN_STEP_POINTERS * POINTER + 8 * more)
        + 8 * (capacity.length + 1) * capacity.state_len
}

// It promises enough memory; on every target that is built.
#[expect(clippy::indexing_slicing, reason = "runs while compiling only")]
const _: () = {
    const MOST: PlannerCapacity = PlannerCapacity {
        pddl_bytes: 65_536,
        operators: 65_535,
        nodes: 1 << 20,
        atoms: 1024,
        facts: 65_536,
        length: 128,
        state_len: 4096,
    };
    const SHARES: [usize; 5] = [1 << 20, 4099, 256, 17, 1];
    const ATOMS: [usize; 3] = [1, 2, 8];
    let mut at = 0;
    while at < SHARES.len() * SHARES.len() * ATOMS.len() {
        let (first, second) = (SHARES[at % 5], SHARES[at / 5 % 5]);
        let capacity = PlannerCapacity {
            pddl_bytes: MOST.pddl_bytes / first,
            operators: MOST.operators / second,
            nodes: MOST.nodes / first,
            atoms: MOST.atoms / ATOMS[at / 25],
            facts: MOST.facts / second,
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
