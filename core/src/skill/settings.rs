//! Where a skill is tried: states in which its operators are applicable.

use super::selection::{spread, swap_rows};
use super::training::TrainingMemory;
use super::{Describe, Informed, Scope, Skill, Skills};
use crate::error::Error;
use crate::learn::Outcome;
use crate::plan::{AbstractTask, Conclusion, Config, Planner, Simulated};
use crate::random::generator;
use crate::task::{
    Arguments, AtomSet, Atoms, ControllerId, GroundOperator, ObjectId, PredicateId, State, Task,
    ground_operators,
};
use heapless::Vec;

/// Most operators that are tried in a row: two, and what they need in between.
pub const MAX_CHAIN: usize = 4;
/// How often settings are looked for in the same tasks.
const ROUNDS: u64 = 4;

/// A state, and the operators to try from it, one after the other.
#[derive(Clone, Debug)]
pub struct Setting {
    /// The state.
    pub state: State,
    /// The operator, and then those up to the later one, if there is one.
    pub steps: Vec<GroundOperator, MAX_CHAIN>,
    /// What came of trying it, where that is tried once.
    pub(super) answer: Option<Outcome>,
}

impl Setting {
    /// Calls `body` with who fills the roles of a skill.
    pub(super) fn with_scope<E: Describe, T>(
        &self,
        environment: &E,
        among: &[PredicateId],
        body: impl FnOnce(&Scope<'_, E>) -> Result<T, Error>,
    ) -> Result<T, Error> {
        let arguments = |ground: Option<&GroundOperator>| match ground {
            Some(ground) => controller_objects(environment, ground),
            None => Ok(Arguments::default()),
        };
        let own = arguments(self.steps.first())?;
        let later = arguments(self.steps.get(1..).and_then(<[_]>::last))?;
        body(&Scope {
            environment,
            state: &self.state,
            own: own.as_slice(),
            later: later.as_slice(),
            among,
        })
    }
}

/// Objects of a task for the controllers of a skill: a setting that could be made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Candidate {
    pub(super) task: u16,
    /// The objects of the controller and those of the later one.
    pub(super) own: Arguments,
    pub(super) later: Arguments,
}

/// A task with those operators that handle no objects but a candidate's: what happens to
/// others on the way would be a reason of its own why something fails.
struct Grounded<'t, 'o, E> {
    environment: &'t E,
    skills: &'t Skills<'t>,
    initial: &'t State,
    atoms: Atoms,
    operators: &'o [GroundOperator],
    /// Of the parameters on the way to an operator: other ones in each setting.
    seed: u64,
}

/// Which settings are wanted.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wanted {
    /// From so many tasks at most.
    pub(super) tasks: usize,
    /// So many at most.
    pub(super) settings: usize,
    /// Such that they differ; otherwise in the order of the tasks.
    pub(super) differing: bool,
    /// Only such as take no way, if there are enough.
    pub(super) direct: bool,
}

impl Skills<'_> {
    /// Collects settings of a skill. Returns how many there are, from how many tasks, and
    /// how many controllers were run to get there.
    ///
    /// Where an operator is not applicable in the initial state it is planned for, with
    /// the skills learned so far (the thesis's single-operator task plans); and if there
    /// are not enough settings yet, again with other parameters on the way.
    pub(super) fn collect<E: Describe>(
        &self,
        skill: &Skill,
        environment: &E,
        tasks: &[Task],
        wanted: Wanted,
        memory: &mut TrainingMemory<'_>,
    ) -> Result<(usize, usize, u32), Error> {
        let room = wanted.settings.min(memory.settings.len());
        let mut candidates = enumerate(environment, skill, tasks, wanted.direct, memory)?;
        if candidates < room && wanted.direct {
            candidates = enumerate(environment, skill, tasks, false, memory)?;
        }
        if wanted.differing {
            let swap = |memory: &mut TrainingMemory<'_>, a, b| {
                swap_rows(memory.candidates, 1, a, b);
            };
            spread(skill, memory, candidates, room, swap)?;
        }
        let candidates = take_tasks(memory.candidates, candidates, wanted.tasks);
        let (mut count, mut calls) = (0, 0);
        for round in 0..ROUNDS {
            for index in 0..candidates {
                let candidate = memory.candidates.get(index).copied().unwrap_or_default();
                let task = tasks.get(usize::from(candidate.task));
                let (Some(task), true) = (task, count < room) else {
                    break;
                };
                let planner = memory.planner.reborrow();
                let seed = (round << 16 | index as u64) << 32;
                let grounded =
                    Grounded::new(environment, self, task, memory.operators, &candidate, seed)?;
                let (setting, runs) = grounded.realise(skill, &candidate, planner)?;
                calls += runs;
                // What takes no way would be the same again.
                let setting = setting.filter(|_| round == 0 || runs > 0);
                if let (Some(setting), Some(place)) = (setting, memory.settings.get_mut(count)) {
                    *place = Some(setting);
                    count += 1;
                }
            }
        }
        let used = memory.candidates.get(..candidates).unwrap_or_default();
        Ok((count, distinct_tasks(used), calls))
    }
}

/// Moves the candidates of the first `most` tasks to the front, in their order. Returns
/// how many there are.
fn take_tasks(candidates: &mut [Candidate], count: usize, most: usize) -> usize {
    let mut kept = 0;
    for index in 0..count {
        let Some((before, [own, ..])) = candidates.split_at_mut_checked(index) else {
            break;
        };
        let before = before.get(..kept).unwrap_or_default();
        let known = before.iter().any(|other| other.task == own.task);
        if known || distinct_tasks(before) < most {
            if kept < index {
                swap_rows(candidates, 1, kept, index);
            }
            kept += 1;
        }
    }
    kept
}

/// From how many tasks candidates are.
fn distinct_tasks(candidates: &[Candidate]) -> usize {
    let all = candidates.iter().enumerate();
    let first = all.filter(|(index, own)| {
        let mut before = candidates.iter().take(*index);
        !before.any(|other| other.task == own.task)
    });
    first.count()
}

/// Writes the instances of so many settings, and parameters of the original sampler.
pub(super) fn survey<E: Describe>(
    skill: &Skill,
    environment: &E,
    count: usize,
    memory: &mut TrainingMemory<'_>,
) -> Result<(), Error> {
    const FULL: Error = Error::CapacityExceeded("numbers of training instances");
    let length = skill.binding.len();
    let settings = memory.settings.iter().flatten().take(count);
    for (index, (setting, proposal)) in settings.zip(memory.proposals.iter_mut()).enumerate() {
        let numbers = memory
            .instances
            .get_mut(index * length..(index + 1) * length);
        skill.instance(environment, setting, numbers.ok_or(FULL)?)?;
        if let Some(own) = setting.steps.first() {
            let mut rng = generator(index as u64);
            *proposal = own.propose(environment, &setting.state, &mut rng);
        }
    }
    Ok(())
}

/// Lists candidates in the order of the tasks, as many as there is room for, with the
/// numbers of their instances and parameters of the original sampler; `direct` leaves out
/// those whose operator is not applicable in the initial state.
fn enumerate<E: Describe>(
    environment: &E,
    skill: &Skill,
    tasks: &[Task],
    direct: bool,
    memory: &mut TrainingMemory<'_>,
) -> Result<usize, Error> {
    let mut count = 0;
    for (index, task) in (0..).zip(tasks) {
        let atoms = Atoms::new::<E>(&task.initial)?;
        memory.operators.clear();
        let lifted = E::OPERATORS;
        ground_operators(lifted, &task.initial, &atoms, memory.operators)?;
        let (of_task, initial) = (count, atoms.abstract_state(environment, &task.initial));
        let own = of_controller(environment, memory.operators, skill.description.own);
        for (own, arguments) in own.filter(|(own, _)| !direct || own.is_applicable(initial)) {
            let later = skill.description.later;
            let later = later.map(|id| of_controller(environment, memory.operators, id));
            let none = later.is_none().then(Arguments::default);
            let later = later.into_iter().flatten().map(|(_, arguments)| arguments);
            for later in none.into_iter().chain(later) {
                let candidate = Candidate {
                    task: index,
                    own: arguments,
                    later,
                };
                let known = memory.candidates.get(of_task..count).unwrap_or_default();
                if known.contains(&candidate) {
                    continue;
                }
                let length = skill.binding.len();
                let room = memory
                    .instances
                    .get_mut(count * length..(count + 1) * length);
                let (Some(room), Some(place), Some(proposal)) = (
                    room,
                    memory.candidates.get_mut(count),
                    memory.proposals.get_mut(count),
                ) else {
                    return Ok(count);
                };
                let scope = candidate.scope(environment, skill, &task.initial);
                if skill.binding.instance(&scope, room).is_err() {
                    continue;
                }
                let mut rng = generator(count as u64);
                *proposal = own.propose(environment, &task.initial, &mut rng);
                *place = candidate;
                count += 1;
            }
        }
    }
    Ok(count)
}

/// The ground operators of a controller, with its objects.
fn of_controller<'o, E: Describe>(
    environment: &E,
    operators: &'o [GroundOperator],
    controller: ControllerId,
) -> impl Iterator<Item = (&'o GroundOperator, Arguments)> {
    operators.iter().filter_map(move |ground| {
        let operator = environment.operator(ground).ok()?;
        let own = operator.controller == controller;
        let arguments = operator.controller_objects(ground.objects.as_slice());
        own.then_some((ground, arguments.ok()?))
    })
}

fn controller_objects<E: Describe>(
    environment: &E,
    ground: &GroundOperator,
) -> Result<Arguments, Error> {
    let operator = environment.operator(ground)?;
    operator.controller_objects(ground.objects.as_slice())
}

impl Candidate {
    /// Whether an object is one of those it is about.
    fn has(&self, object: ObjectId) -> bool {
        self.own.as_slice().contains(&object) || self.later.as_slice().contains(&object)
    }

    /// Who fills the roles of a skill in a state.
    pub(super) fn scope<'s, E>(
        &'s self,
        environment: &'s E,
        skill: &Skill,
        state: &'s State,
    ) -> Scope<'s, E> {
        Scope {
            environment,
            state,
            own: self.own.as_slice(),
            later: self.later.as_slice(),
            among: skill.description.among,
        }
    }
}

impl<'t, 'o, E: Describe> Grounded<'t, 'o, E> {
    fn new(
        environment: &'t E,
        skills: &'t Skills<'t>,
        task: &'t Task,
        operators: &'o mut heapless::VecView<GroundOperator>,
        candidate: &Candidate,
        seed: u64,
    ) -> Result<Self, Error> {
        let atoms = Atoms::new::<E>(&task.initial)?;
        operators.clear();
        ground_operators(E::OPERATORS, &task.initial, &atoms, operators)?;
        operators.retain(|ground| {
            let own = controller_objects(environment, ground);
            own.is_ok_and(|own| own.as_slice().iter().all(|object| candidate.has(*object)))
        });
        Ok(Grounded {
            environment,
            skills,
            initial: &task.initial,
            atoms,
            operators,
            seed,
        })
    }

    /// The setting of a candidate, if there is a way to it, and how many controllers
    /// were run to find it.
    fn realise(
        &self,
        skill: &Skill,
        candidate: &Candidate,
        planner: crate::plan::Memory<'_, State>,
    ) -> Result<(Option<Setting>, u32), Error> {
        let own = || self.of(skill.description.own, &candidate.own);
        let (state, calls) = self.reach(own, planner)?;
        let Some(state) = state else {
            return Ok((None, calls));
        };
        let before = self.atoms.abstract_state(self.environment, &state);
        let applicable = own().filter(|own| own.is_applicable(before));
        let chains = applicable.filter_map(|own| match skill.description.later {
            Some(later) => self.chain(before, own, (later, &candidate.later)),
            None => Vec::from_slice(&[*own]).ok(),
        });
        let steps = chains.min_by_key(|steps| steps.len());
        Ok((
            steps.map(|steps| Setting {
                state,
                steps,
                answer: None,
            }),
            calls,
        ))
    }

    /// The ground operators of a controller with these objects.
    fn of(
        &self,
        controller: ControllerId,
        arguments: &Arguments,
    ) -> impl Iterator<Item = &'o GroundOperator> {
        let all = of_controller(self.environment, self.operators, controller);
        all.filter(move |(_, own)| own == arguments)
            .map(|(ground, _)| ground)
    }

    /// A state in which one of these operators is applicable, and how many controllers
    /// were run to find it.
    fn reach<I: Iterator<Item = &'o GroundOperator>>(
        &self,
        own: impl Fn() -> I,
        mut memory: crate::plan::Memory<'_, State>,
    ) -> Result<(Option<State>, u32), Error> {
        let initial = self.atoms.abstract_state(self.environment, self.initial);
        if own().any(|ground| ground.is_applicable(initial)) {
            return Ok((Some(self.initial.clone()), 0));
        }
        let mut calls = 0;
        for ground in own() {
            let world = Simulated {
                environment: self.environment,
                atoms: &self.atoms,
            };
            let informed = Informed::new(self.environment, self.skills, self.initial);
            let mut planner = Planner {
                world: &mut { world },
                sampler: &mut { informed },
                guide: &mut { informed },
                config: Config::default(),
            };
            let task = AbstractTask {
                operators: self.operators,
                initial,
                goal: ground.preconditions,
            };
            let seed = || generator(self.seed ^ u64::from(calls));
            let memory = memory.reborrow();
            let planned = planner.plan(task, self.initial, seed(), seed, memory)?;
            calls += planned.metrics.samples;
            if planned.conclusion == Conclusion::Solved {
                return Ok((planned.steps.last().map(|step| step.state.clone()), calls));
            }
        }
        Ok((None, calls))
    }

    /// The shortest sequence from an operator to one of a later controller, with what it
    /// needs in between. What comes in between leaves the operator's objects alone, so
    /// that its parameters still matter in the end.
    fn chain(
        &self,
        before: AtomSet,
        own: &GroundOperator,
        (later, arguments): (ControllerId, &Arguments),
    ) -> Option<Vec<GroundOperator, MAX_CHAIN>> {
        let start = own.apply(before);
        let last = |state: AtomSet| {
            self.of(later, arguments)
                .find(move |l| l.is_applicable(state))
        };
        let between = |state: AtomSet| {
            let apart = move |ground: &&GroundOperator| {
                ground.is_applicable(state) && !self.handles(ground, own)
            };
            self.operators.iter().filter(apart)
        };
        if let Some(last) = last(start) {
            return Vec::from_slice(&[*own, *last]).ok();
        }
        let one = between(start).find_map(|first| {
            let last = last(first.apply(start))?;
            Vec::from_slice(&[*own, *first, *last]).ok()
        });
        one.or_else(|| {
            between(start).find_map(|first| {
                let state = first.apply(start);
                between(state).find_map(|second| {
                    let last = last(second.apply(state))?;
                    Vec::from_slice(&[*own, *first, *second, *last]).ok()
                })
            })
        })
    }

    /// Whether the controller of an operator has an object of another one's.
    fn handles(&self, ground: &GroundOperator, other: &GroundOperator) -> bool {
        let arguments = |ground| controller_objects(self.environment, ground);
        let (Ok(own), Ok(other)) = (arguments(ground), arguments(other)) else {
            return true;
        };
        own.as_slice()
            .iter()
            .any(|object| other.as_slice().contains(object))
    }
}
