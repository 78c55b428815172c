//! Where the parts of skills lie in their memory.

use crate::boundary::memory::{Packer, Part, append, copy_text, parts};
use crate::boundary::status::Fallible;
use crate::learner::tables::{VersionSpaceTables, is_countable};
use crate::planner::names::Names;
use crate::skill::config::{CRITREG_MAX_TRAINING_OPERATORS, Settings, SkillsCapacity};
use crate::skill::facts::{ActionCall, ControllerEntry, Facts};
use crate::skill::handle::{Fingerprint, Inner, critreg_skills};
use crate::skill::learning::Progress;
use crate::skill::practice::{Desk, TaskEntry};
use core::cell::OnceCell;
use critreg_core::Error;
use critreg_core::domain::{Domain, MAX_TYPES};
use critreg_core::learn::{Capacity, Memory};
use critreg_core::pddl::{self, Fact, Grounding, MAX_ACTIONS, Problem};
use critreg_core::plan::{
    self, Cached, HeuristicMemory, Progress as Reached, SearchMemory, SearchNode, Step, Waiting,
};
use critreg_core::region::Theta;
use critreg_core::skill::{Candidate, Changes, Journal, Learned, Situation, Skill, TrainingMemory};
use critreg_core::task::{GroundOperator, Naming, ObjectType, PredicateId, State};

const OPERATORS: usize = CRITREG_MAX_TRAINING_OPERATORS as usize;

/// The ground operators of a training task.
type Operators = heapless::Vec<GroundOperator, OPERATORS>;

/// Links between atoms and operators, eight for each on the average at most.
const LINKS: usize = 8 * OPERATORS;

/// Most predicates that narrow the groups of one skill.
pub(crate) const MAX_NARROWING: usize = 8;

/// Most operators on the way to a situation.
const WAY: usize = 16;

parts! {
    /// The parts of skills, apart from the tables of the learner.
    SkillParts with capacity: SkillsCapacity;
    handle: critreg_skills, 1;
    pddl: pddl::Domain<'static>, 1;
    layout: Domain<'static>, 1;
    problem: Problem<'static>, 1;
    names: Names, 1;
    grounding: Grounding<'static, 'static>, 1;
    facts: Fact, capacity.facts;
    types: ObjectType, MAX_TYPES;
    controllers: OnceCell<ControllerEntry>, capacity.controllers;
    calls: OnceCell<ActionCall>, MAX_ACTIONS;
    tasks: OnceCell<TaskEntry>, capacity.tasks;
    skills: Option<Skill>, capacity.skills;
    learned: Learned, capacity.skills;
    changes: Changes, capacity.controllers;
    changes_before: Changes, capacity.controllers;
    journal: f64, capacity.journal();
    situations: Option<Situation>, capacity.situations;
    candidates: Candidate, capacity.candidates();
    proposals: Theta, capacity.candidates();
    instances: f64, capacity.instance_numbers();
    operators: Operators, 1;
    progress: Reached, OPERATORS;
    estimates: Cached, capacity.nodes / 16 + 1;
    nodes: SearchNode, capacity.nodes;
    open: Waiting, capacity.nodes;
    visited: u32, capacity.nodes;
    steps: Step<State>, WAY;
    failures: u32, MAX_ACTIONS;
    reasons: u32, OPERATORS;
    links: u16, LINKS;
    narrowing: PredicateId, capacity.narrowing();
    texts: u8, capacity.texts;
    name_bytes: u8, capacity.texts;
}

/// Where the parts lie, and how long they are together.
pub(crate) struct SkillsLayout {
    pub(crate) parts: SkillParts,
    learner: VersionSpaceTables<f64>,
    capacity: Capacity,
    pub(crate) size: usize,
}

impl SkillsLayout {
    pub(crate) fn new(capacity: SkillsCapacity) -> Option<SkillsLayout> {
        if !is_countable(capacity.learner) {
            return None;
        }
        let mut packer = Packer { size: 0 };
        let parts = SkillParts::new(&mut packer, capacity)?;
        Some(SkillsLayout {
            parts,
            learner: VersionSpaceTables::new(&mut packer, capacity.learner)?,
            capacity: capacity.learner,
            size: packer.size,
        })
    }

    /// Reads the texts and prepares everything to be told of controllers, skills and tasks.
    ///
    /// # Safety
    /// As for [`Part::fill`]; the texts do not lie in the memory.
    pub(crate) unsafe fn make(
        &self,
        memory: *mut u8,
        [domain, layout]: [&str; 2],
        settings: Settings,
    ) -> Fallible<Inner> {
        let parts = &self.parts;
        // SAFETY: by this function's contract; the parts do not overlap. What they hold needs
        // no drop, so what was there may be lost.
        unsafe {
            let mut texts = Pool::new(parts.texts.fill(memory, 0));
            let pddl = parts
                .pddl
                .put(memory, pddl::Domain::parse(texts.copy(domain)?)?);
            let place = parts.layout.put(memory, Domain::empty());
            place.read(texts.copy(layout)?)?;
            let (pddl, layout): (&'static _, &'static _) = (pddl, place);
            let types = parts.types.fill(memory, NO_TYPE);
            let facts = Facts {
                pddl,
                layout,
                types: name_types(layout, types),
                controllers: parts.controllers.fill_with(memory, OnceCell::new),
                calls: parts.calls.fill_with(memory, OnceCell::new),
            };
            let mut fingerprint = Fingerprint::NOTHING;
            fingerprint.text(domain);
            fingerprint.text(layout.text());
            let tasks = &*parts.tasks.fill_with(memory, OnceCell::new);
            Ok(Inner {
                facts,
                texts,
                narrowing: parts.narrowing.fill(memory, PredicateId::default()),
                fingerprint,
                skills: parts.skills.fill_with(memory, || None),
                learned: parts.learned.fill(memory, Learned::default()),
                changes: parts.changes.fill(memory, Changes::default()),
                changes_before: parts.changes_before.fill(memory, Changes::default()),
                tasks,
                controller_count: 0,
                skill_count: 0,
                task_count: 0,
                learned_count: 0,
                begun: false,
                desk: Desk {
                    pddl,
                    tasks,
                    at: None,
                    problem: parts.problem.place(memory),
                    names: parts.names.place(memory),
                    grounding: parts.grounding.place(memory),
                    facts: parts.facts.fill(memory, Fact::default()),
                    name_bytes: parts.name_bytes.fill(memory, 0),
                },
                journal: Journal::new(parts.journal.fill(memory, 0.0)),
                training: self.tables(memory),
                settings,
                progress: Progress {
                    callback: settings.progress,
                    data: settings.progress_data,
                },
            })
        }
    }

    /// The tables of learning.
    ///
    /// # Safety
    /// As for [`SkillsLayout::make`].
    unsafe fn tables(&self, memory: *mut u8) -> TrainingTables {
        let parts = &self.parts;
        // SAFETY: by this function's contract; the parts do not overlap.
        unsafe {
            TrainingTables {
                situations: parts.situations.fill_with(memory, || None),
                candidates: parts.candidates.fill(memory, Candidate::default()),
                proposals: parts.proposals.fill(memory, Theta::default()),
                instances: parts.instances.fill(memory, 0.0),
                operators: parts.operators.put(memory, Operators::new()),
                progress: parts.progress.fill(memory, Reached::default()),
                links: parts.links.fill(memory, 0),
                estimates: parts.estimates.fill(memory, Cached::default()),
                nodes: parts.nodes.fill(memory, SearchNode::default()),
                open: parts.open.fill(memory, Waiting::default()),
                visited: parts.visited.fill(memory, 0),
                steps: parts.steps.fill_with(memory, Step::default),
                failures: parts.failures.fill(memory, 0),
                reasons: parts.reasons.fill(memory, 0),
                learner: self.learner.lend(memory),
                capacity: self.capacity,
            }
        }
    }
}

const NO_TYPE: ObjectType = ObjectType {
    name: "",
    attributes: &[],
    naming: Naming::Numbered(""),
};

/// The types of the layout, as those of an environment.
fn name_types(
    layout: &'static Domain<'static>,
    types: &'static mut [ObjectType],
) -> &'static [ObjectType] {
    for (index, (own, kind)) in (0..).zip(types.iter_mut().zip(layout.types())) {
        *own = ObjectType {
            name: kind.name,
            attributes: layout.attributes_of(index),
            naming: Naming::Numbered(kind.name),
        };
    }
    types.get(..layout.types().len()).unwrap_or_default()
}

/// The memory of learning, all of which is used again for the next skill.
pub(crate) struct TrainingTables {
    situations: &'static mut [Option<Situation>],
    candidates: &'static mut [Candidate],
    proposals: &'static mut [Theta],
    instances: &'static mut [f64],
    operators: &'static mut Operators,
    progress: &'static mut [Reached],
    links: &'static mut [u16],
    estimates: &'static mut [Cached],
    nodes: &'static mut [SearchNode],
    open: &'static mut [Waiting],
    visited: &'static mut [u32],
    steps: &'static mut [Step<State>],
    failures: &'static mut [u32],
    reasons: &'static mut [u32],
    learner: Memory<'static, f64>,
    capacity: Capacity,
}

impl TrainingTables {
    pub(crate) fn lend(&mut self) -> TrainingMemory<'_> {
        TrainingMemory {
            situations: self.situations,
            candidates: self.candidates,
            proposals: self.proposals,
            instances: self.instances,
            operators: self.operators,
            planner: plan::Memory {
                search: SearchMemory {
                    heuristic: HeuristicMemory {
                        operators: self.progress,
                        links: self.links,
                        cache: self.estimates,
                    },
                    nodes: self.nodes,
                    open: self.open,
                    visited: self.visited,
                },
                steps: self.steps,
                failures: self.failures,
                reasons: self.reasons,
            },
            learner: self.learner.reborrow(),
            capacity: self.capacity,
        }
    }
}

/// Room for texts, which are copied one behind the other.
pub(crate) struct Pool {
    first: *mut u8,
    length: usize,
    used: usize,
}

impl Pool {
    fn new(room: &'static mut [u8]) -> Pool {
        Pool {
            length: room.len(),
            first: room.as_mut_ptr(),
            used: 0,
        }
    }

    /// Copies a text.
    pub(crate) fn copy(&mut self, text: &str) -> Fallible<&'static str> {
        const FULL: Error = Error::CapacityExceeded("bytes of texts: set config.texts");
        let end = self.used.checked_add(text.len() + 1);
        let end = end.filter(|end| *end <= self.length).ok_or(FULL)?;
        // SAFETY: these bytes lie in the room, and are lent to nobody else.
        let own =
            unsafe { core::slice::from_raw_parts_mut(self.first.add(self.used), text.len() + 1) };
        self.used = end;
        copy_text(text, own)
    }

    /// Gives back the room of the last text that was copied.
    ///
    /// # Safety
    /// Nothing refers to the copy any more.
    pub(crate) unsafe fn forget_last(&mut self, text: &str) {
        self.used = self.used.saturating_sub(text.len() + 1);
    }
}
