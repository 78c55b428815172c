//! Situations that could be made of training tasks.

use super::memory::TrainingMemory;
use super::situation::Candidate;
use crate::error::Error;
use crate::random::generator;
use crate::region::Theta;
use crate::skill::context::Context;
use crate::skill::planning::proposal;
use crate::skill::setting::Practice;
use crate::skill::skills::Skill;
use crate::table::swap_rows;
use crate::task::{Arguments, ControllerId, GroundOperator, State};

/// Lists the candidates of a skill in the order of the tasks, so many at most and as many as
/// there is room for, with the numbers of their instances and parameters of the original
/// sampler; `direct` leaves out those whose operator is not applicable in the initial
/// state. Returns how many there are.
///
/// # Errors
/// [`Error::CapacityExceeded`] if the atoms or ground operators of a task find no room.
pub(super) fn list<E: Practice>(
    environment: &E,
    skill: &Skill,
    tasks: &[E::Task],
    (most, direct): (usize, bool),
    memory: &mut TrainingMemory<'_>,
) -> Result<usize, Error> {
    let operators = &mut *memory.operators;
    let most = most.min(memory.candidates.len());
    let mut list = List {
        skill,
        candidates: memory.candidates.get_mut(..most).unwrap_or_default(),
        proposals: memory.proposals,
        instances: memory.instances,
        count: 0,
    };
    let about = skill.description();
    for (index, task) in (0..).zip(tasks) {
        operators.clear();
        let (_, initial) = environment.ground(task, operators)?;
        let own = of_controller(environment, operators, about.controller);
        for (own, objects) in own.filter(|(own, _)| !direct || own.is_applicable(initial)) {
            let later = about
                .later
                .map(|id| of_controller(environment, operators, id));
            let none = later.is_none().then(Arguments::default);
            let later = later.into_iter().flatten().map(|(_, objects)| objects);
            for later_objects in none.into_iter().chain(later) {
                let candidate = Candidate {
                    task: index,
                    objects,
                    later_objects,
                };
                if !list.add(environment, environment.initial(task), own, candidate) {
                    return Ok(list.count);
                }
            }
        }
    }
    Ok(list.count)
}

/// A list that grows.
struct List<'m> {
    skill: &'m Skill,
    candidates: &'m mut [Candidate],
    proposals: &'m mut [Theta],
    instances: &'m mut [f64],
    count: usize,
}

impl List<'_> {
    /// Adds a candidate, unless it is there or somebody is missing for a role. Tells
    /// whether there was room.
    fn add(
        &mut self,
        environment: &impl Practice,
        state: &State,
        own: &GroundOperator,
        candidate: Candidate,
    ) -> bool {
        let (count, length) = (self.count, self.skill.binding().len());
        let known = self.candidates.get(..count).unwrap_or_default();
        if known.contains(&candidate) {
            return true;
        }
        let numbers = self.instances.get_mut(count * length..(count + 1) * length);
        let (Some(numbers), Some(place), Some(theta)) = (
            numbers,
            self.candidates.get_mut(count),
            self.proposals.get_mut(count),
        ) else {
            return false;
        };
        let context = Context {
            environment,
            state,
            objects: candidate.objects.as_slice(),
            later_objects: candidate.later_objects.as_slice(),
            members: self.skill.description().members,
        };
        let is_about = self.skill.is_about(context.objects, context.later_objects);
        if is_about && self.skill.binding().instance(&context, numbers).is_ok() {
            *theta = proposal(environment, own, state, &mut generator(count as u64));
            *place = candidate;
            self.count += 1;
        }
        true
    }
}

/// The ground operators of a controller, with its objects.
pub(super) fn of_controller<'o>(
    environment: &impl Practice,
    operators: &'o [GroundOperator],
    controller: ControllerId,
) -> impl Iterator<Item = (&'o GroundOperator, Arguments)> {
    operators.iter().filter_map(move |ground| {
        let (own, objects) = environment
            .call(ground.operator, ground.objects.as_slice())
            .ok()?;
        (own == controller).then_some((ground, objects))
    })
}

/// Moves the candidates of the first `most` tasks to the front, in their order. Returns
/// how many there are.
pub(super) fn take_tasks(candidates: &mut [Candidate], most: usize) -> usize {
    let mut kept = 0;
    for index in 0..candidates.len() {
        let Some((before, [own, ..])) = candidates.split_at_mut_checked(index) else {
            break;
        };
        let before = before.get(..kept).unwrap_or_default();
        let known = before.iter().any(|other| other.task == own.task);
        if known || distinct_tasks(before) < most {
            swap_rows(candidates, 1, kept, index);
            kept += 1;
        }
    }
    kept
}

/// From how many tasks candidates are.
pub(super) fn distinct_tasks(candidates: &[Candidate]) -> usize {
    let all = candidates.iter().enumerate();
    let first = all.filter(|(index, own)| {
        let mut before = candidates.iter().take(*index);
        !before.any(|other| other.task == own.task)
    });
    first.count()
}
