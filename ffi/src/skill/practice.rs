//! A program's callbacks as what skills are learned in.

use crate::boundary::status::{Failure, Fallible};
use crate::planner::callbacks::{critreg_callbacks, critreg_draw};
use crate::planner::names::Names;
use crate::planner::world::{Program, uniform};
use crate::skill::facts::Facts;
use crate::skill::learning::{Progress, critreg_training};
use core::cell::{Cell, OnceCell, RefCell};
use core::ffi::c_void;
use core::fmt::{self, Write};
use critreg_core::Error;
use critreg_core::pddl::{self, Fact, Grounding, Problem};
use critreg_core::plan::Drawn;
use critreg_core::skill::{Journal, Practice, Setting, Signature};
use critreg_core::task::{
    Arguments, AtomSet, Atoms, ControllerId, GroundAtom, GroundOperator, ObjectId, ObjectType,
    OperatorId, Parameters, PredicateId, State, TypeId,
};
use heapless::VecView;
use rand_core::Rng;

/// A training task: a problem, and the state it begins in, whose mark is its place.
pub(crate) struct TaskEntry {
    pub(crate) problem: &'static str,
    pub(crate) state: State,
}

/// The problem at hand: read, named and grounded in memory of the skills, anew whenever
/// another one is asked about.
pub(crate) struct Desk {
    pub(crate) pddl: &'static pddl::Domain<'static>,
    pub(crate) tasks: &'static [OnceCell<TaskEntry>],
    /// The task whose problem lies there.
    pub(crate) at: Option<u16>,
    pub(crate) problem: *mut Problem<'static>,
    pub(crate) names: *mut Names,
    pub(crate) grounding: *mut Grounding<'static, 'static>,
    pub(crate) facts: *mut [Fact],
    pub(crate) name_bytes: *mut [u8],
}

/// What lies on the desk.
pub(crate) struct Task<'d> {
    problem: &'d Problem<'static>,
    names: &'d Names,
    grounding: &'d mut Grounding<'static, 'static>,
}

impl Desk {
    /// Reads a problem. What lay there before is lost.
    pub(crate) fn read(&mut self, text: &'static str) -> Fallible<&Problem<'static>> {
        self.at = None;
        // SAFETY: the parts are the desk's alone, aligned and long enough; what is made of
        // them is lent for as long as the desk is, so nothing refers to what is overwritten.
        // It needs no drop.
        unsafe {
            let (facts, bytes) = (&mut *self.facts, &mut *self.name_bytes);
            self.problem.write(Problem::parse(self.pddl, text, facts)?);
            self.names.write(Names::new(&*self.problem, bytes)?);
            Ok(&*self.problem)
        }
    }

    /// The task with a mark.
    fn turn_to(&mut self, mark: u16) -> Fallible<Task<'_>> {
        const NO_TASK: Error = Error::Mismatch("a state is of no training task");
        if self.at != Some(mark) {
            let task = self.tasks.get(usize::from(mark)).and_then(OnceCell::get);
            self.read(task.ok_or(NO_TASK)?.problem)?;
            // SAFETY: as above; the problem was just read, and stays until the next one is.
            unsafe { self.grounding.write(Grounding::new(&*self.problem)?) };
            self.at = Some(mark);
        }
        // SAFETY: as above; all three were written.
        unsafe {
            Ok(Task {
                problem: &*self.problem,
                names: &*self.names,
                grounding: &mut *self.grounding,
            })
        }
    }
}

/// What the callbacks are asked while a skill is learned.
pub(crate) struct Trainee<'a> {
    pub(crate) facts: Facts,
    pub(crate) callbacks: &'a critreg_callbacks,
    pub(crate) user_data: *mut c_void,
    pub(crate) desk: RefCell<&'a mut Desk>,
    pub(crate) journal: RefCell<&'a mut Journal<'static>>,
    pub(crate) progress: Progress,
    /// What is told of learning.
    pub(crate) training: Cell<critreg_training>,
    /// Why learning is to stop. The core knows no failures of callbacks.
    pub(crate) failure: Cell<Option<Failure>>,
}

/// Ends learning; the failure says why.
const STOPPED: Error = Error::OutOfSequence("learning was stopped");

impl Trainee<'_> {
    /// Does something with the task of a state. Its failure, or an earlier one, ends learning.
    fn at<T>(
        &self,
        mark: u16,
        body: impl FnOnce(&Program<'_>, &mut Task<'_>) -> Fallible<T>,
    ) -> Result<T, Error> {
        if self.failure.get().is_some() {
            return Err(STOPPED);
        }
        let mut desk = self.desk.try_borrow_mut().map_err(|_| STOPPED)?;
        let done = desk.turn_to(mark).and_then(|mut task| {
            let program = Program {
                callbacks: self.callbacks,
                user_data: self.user_data,
                names: task.names,
                ranges: &[],
                atoms: &[],
            };
            body(&program, &mut task)
        });
        done.map_err(|failure| {
            self.failure.set(Some(failure));
            STOPPED
        })
    }

    /// Runs an operator, or takes what came of it before.
    fn run(
        &self,
        program: &Program<'_>,
        ground: &GroundOperator,
        parameters: &[f64],
        state: &mut State,
    ) -> Fallible<u32> {
        let mut journal = self.journal.try_borrow_mut().map_err(|_| STOPPED)?;
        let mut training = self.training.get();
        if let Some(actions) = journal.replay(state.values_mut()) {
            training.runs += 1;
            self.training.set(training);
            return Ok(actions);
        }
        let before = state.clone();
        let called = program.names.operator(ground);
        let actions = program.run(&called, parameters, before.values(), state.values_mut())?;
        if !state.values().iter().all(|number| number.is_finite()) {
            if actions > 0 {
                return Err(Error::NotFinite("a number of the state that execute wrote").into());
            }
            state.clone_from(&before);
        }
        journal.record(actions, state.values());
        training.runs += 1;
        self.training.set(training);
        self.progress.tell(&training)?;
        Ok(actions)
    }
}

impl Setting for Trainee<'_> {
    fn types(&self) -> &'static [ObjectType] {
        self.facts.types
    }

    fn signature(&self, id: ControllerId) -> Result<Signature, Error> {
        self.facts.signature(id)
    }

    fn call(
        &self,
        action: OperatorId,
        objects: &[ObjectId],
    ) -> Result<(ControllerId, Arguments), Error> {
        self.facts.call(action, objects)
    }

    fn draw<R: Rng>(
        &self,
        action: OperatorId,
        state: &State,
        objects: &[ObjectId],
        rng: &mut R,
    ) -> Parameters {
        let drawn = self.at(state.mark(), |program, _| {
            original(&self.facts, program, (action, objects), state.values(), rng)
        });
        drawn.unwrap_or_default()
    }

    fn narrows(&self, predicate: PredicateId, kind: TypeId) -> bool {
        self.facts.narrows(predicate, kind)
    }

    fn holds_of(&self, predicate: PredicateId, state: &State, object: ObjectId) -> bool {
        let holds = Arguments::new([object]).and_then(|objects| {
            let atom = GroundAtom { predicate, objects };
            self.holds(&atom, state)
        });
        holds.unwrap_or(false)
    }

    fn write_name(&self, state: &State, object: ObjectId, out: &mut dyn Write) -> fmt::Result {
        let named = self.at(state.mark(), |_, task| {
            Ok(write_name(&self.facts, task.problem, object, out))
        });
        named.unwrap_or(Err(fmt::Error))
    }
}

impl Practice for Trainee<'_> {
    type Task = OnceCell<TaskEntry>;

    fn initial<'t>(&self, task: &'t Self::Task) -> &'t State {
        static NOTHING: State = State::new();
        task.get().map_or(&NOTHING, |task| &task.state)
    }

    fn ground(
        &self,
        task: &Self::Task,
        operators: &mut VecView<GroundOperator>,
    ) -> Result<(Atoms, AtomSet), Error> {
        const FULL: Error = Error::CapacityExceeded(
            "ground operators of a training task: at most CRITREG_MAX_TRAINING_OPERATORS",
        );
        self.at(self.initial(task).mark(), |_, task| {
            task.grounding.operators(&mut |operator| {
                if operator.is_goal() {
                    return Ok(());
                }
                operators.push(operator).map_err(|_| FULL)
            })?;
            Ok((task.grounding.atoms().clone(), task.grounding.initial()))
        })
    }

    fn holds(&self, atom: &GroundAtom, state: &State) -> Result<bool, Error> {
        if atom.is_goal() {
            return Ok(false);
        }
        self.at(state.mark(), |program, _| {
            program.holds(atom, state.values())
        })
    }

    fn execute(
        &self,
        ground: &GroundOperator,
        parameters: &[f64],
        state: &mut State,
    ) -> Result<u32, Error> {
        self.at(state.mark(), |program, _| {
            self.run(program, ground, parameters, state)
        })
    }

    fn try_operator(
        &self,
        ground: &GroundOperator,
        parameters: &[f64],
        state: &mut State,
    ) -> Result<bool, Error> {
        self.at(state.mark(), |program, task| {
            if self.run(program, ground, parameters, state)? == 0 {
                return Ok(false);
            }
            let atoms = task.grounding.atoms();
            for atom in atoms.members(ground.add_effects) {
                if !program.holds(atom, state.values())? {
                    return Ok(false);
                }
            }
            let gone = ground.delete_effects.difference(ground.add_effects);
            for atom in atoms.members(gone) {
                if program.holds(atom, state.values())? {
                    return Ok(false);
                }
            }
            Ok(true)
        })
    }
}

/// Parameters of the program's own sampler, which is asked as if nothing came later.
pub(crate) fn original<R: Rng>(
    facts: &Facts,
    program: &Program<'_>,
    (action, objects): (OperatorId, &[ObjectId]),
    numbers: &[f64],
    rng: &mut R,
) -> Fallible<Parameters> {
    let ranges = facts
        .ranges(action)
        .map_or(&[][..], |ranges| ranges.as_slice());
    let ground = program.names.call(action.0, objects);
    let told = critreg_draw {
        skeleton: &ground,
        length: 1,
        step: 0,
        state: numbers.as_ptr(),
        state_len: numbers.len(),
        parameter_count: ranges.len(),
        attempt: 1,
        advised: 0,
    };
    match program.sample(&told, ranges, rng)? {
        Drawn::Parameters(drawn) | Drawn::Informed(drawn) => Ok(drawn),
        Drawn::Empty(_) | Drawn::Nothing => uniform(ranges, rng),
    }
}

/// Writes the name of an object of a problem, or of the layout.
pub(crate) fn write_name(
    facts: &Facts,
    problem: &Problem<'_>,
    ObjectId(object): ObjectId,
    out: &mut dyn Write,
) -> fmt::Result {
    let objects = problem.objects();
    if let Some(own) = objects.get(usize::from(object)) {
        return out.write_str(own.name);
    }
    let layout = facts.layout.objects().iter();
    let mut others =
        layout.filter(|own| own.member.is_none() && problem.find_object(own.name).is_none());
    let other = others.nth(usize::from(object).saturating_sub(objects.len()));
    out.write_str(other.ok_or(fmt::Error)?.name)
}
