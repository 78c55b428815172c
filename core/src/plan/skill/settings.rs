//! Where a skill is tried: states in which its operators are applicable.

use super::training::TrainingMemory;
use super::{Describe, Description, Informed, Skills};
use crate::domain::{AtomSet, Atoms, ControllerId, GroundOperator, State, Task, ground_operators};
use crate::error::Error;
use crate::plan::{AbstractTask, Conclusion, Config, Planner, Simulated};
use crate::random::generator;

/// A state, and the operators to try from it.
#[derive(Clone, Debug)]
pub struct Setting {
    /// The state.
    pub state: State,
    /// The operator.
    pub own: GroundOperator,
    /// The one that is tried after it.
    pub later: Option<GroundOperator>,
}

/// A task with its operators.
struct Grounded<'t> {
    initial: &'t State,
    atoms: Atoms,
    operators: &'t [GroundOperator],
}

/// Collects settings from training tasks, in their order, until there are enough or the
/// table is full: in each task those with other objects for the controllers. Returns how
/// many there are, and how many controllers were run to get there.
///
/// Where no operator of the controller is applicable in the initial state, the first one
/// for which that is possible is planned for, with the skills learned so far (the
/// thesis's single-operator task plans).
pub(super) fn collect<E: Describe>(
    environment: &E,
    skills: &Skills<'_>,
    description: &Description,
    tasks: &[Task],
    wanted: usize,
    memory: &mut TrainingMemory<'_>,
) -> Result<(usize, u32), Error> {
    let (mut count, mut calls) = (0, 0);
    for task in tasks {
        if count >= wanted.min(memory.settings.len()) {
            break;
        }
        let atoms = Atoms::new(environment, &task.initial)?;
        memory.operators.clear();
        ground_operators(
            environment.operators(),
            &task.initial,
            &atoms,
            memory.operators,
        )?;
        let (operators, planner) = (memory.operators.as_slice(), memory.planner.reborrow());
        let grounded = Grounded {
            initial: &task.initial,
            atoms,
            operators,
        };
        let (state, runs) = grounded.reach(environment, skills, description.own, planner)?;
        calls += runs;
        let room = memory
            .settings
            .get_mut(count..wanted.min(memory.settings.len()));
        if let (Some(state), Some(room)) = (state, room) {
            count += grounded.fill(environment, description, &state, room)?;
        }
    }
    Ok((count, calls))
}

impl Grounded<'_> {
    fn abstracted<E: Describe>(&self, environment: &E, state: &State) -> AtomSet {
        self.atoms.abstract_state(environment, state)
    }

    /// The ground operators of a controller.
    fn of<E: Describe>(
        &self,
        environment: &E,
        controller: ControllerId,
    ) -> impl Iterator<Item = &GroundOperator> {
        let lifted = environment.operators();
        self.operators.iter().filter(move |ground| {
            let operator = lifted.get(usize::from(ground.operator.0));
            operator.is_some_and(|o| o.controller == controller)
        })
    }

    /// A state in which an operator of the controller is applicable, and how many
    /// controllers were run to find it.
    fn reach<E: Describe>(
        &self,
        environment: &E,
        skills: &Skills<'_>,
        controller: ControllerId,
        mut memory: crate::plan::Memory<'_, State>,
    ) -> Result<(Option<State>, u32), Error> {
        let initial = self.abstracted(environment, self.initial);
        let mut own = self.of(environment, controller);
        if own.any(|ground| ground.is_applicable(initial)) {
            return Ok((Some(self.initial.clone()), 0));
        }
        let mut calls = 0;
        for ground in self.of(environment, controller) {
            let world = Simulated {
                environment,
                atoms: &self.atoms,
            };
            let informed = Informed::new(environment, skills, self.initial);
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
            let seed = || generator(u64::from(calls));
            let memory = memory.reborrow();
            let planned = planner.plan(task, self.initial, seed(), seed, memory)?;
            calls += planned.metrics.samples;
            if planned.conclusion == Conclusion::Solved {
                return Ok((planned.steps.last().map(|step| step.state.clone()), calls));
            }
        }
        Ok((None, calls))
    }

    /// Fills in the settings of a state; returns how many.
    fn fill<E: Describe>(
        &self,
        environment: &E,
        description: &Description,
        state: &State,
        room: &mut [Option<Setting>],
    ) -> Result<usize, Error> {
        let before = self.abstracted(environment, state);
        let mut count = 0;
        let mut add = |own: &GroundOperator, later: Option<&GroundOperator>| {
            let setting = Setting {
                state: state.clone(),
                own: *own,
                later: later.copied(),
            };
            let (filled, rest) = room.split_at_mut_checked(count).unwrap_or_default();
            let known = filled
                .iter()
                .flatten()
                .any(|s| s.is_alike(environment, &setting));
            if let ([place, ..], false) = (rest, known) {
                *place = Some(setting);
                count += 1;
            }
        };
        let own = self.of(environment, description.own);
        for own in own.filter(|own| own.is_applicable(before)) {
            let Some(later) = description.later else {
                add(own, None);
                continue;
            };
            let between = own.apply(before);
            let later = self.of(environment, later);
            for later in later.filter(|later| later.is_applicable(between)) {
                add(own, Some(later));
            }
        }
        Ok(count)
    }
}

impl Setting {
    /// Whether two settings in one state have the same objects for their controllers.
    fn is_alike<E: Describe>(&self, environment: &E, other: &Setting) -> bool {
        let objects = |ground: &GroundOperator| {
            let operator = environment.operators().get(usize::from(ground.operator.0));
            operator.map(|o| o.controller_objects(ground.objects.as_slice()))
        };
        let all = |s: &Setting| (objects(&s.own), s.later.as_ref().map(objects));
        all(self) == all(other)
    }
}
