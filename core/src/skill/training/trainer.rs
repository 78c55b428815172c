//! Learning the region of a skill.

use super::candidates::{self, distinct_tasks, take_tasks};
use super::config::{Learned, Training};
use super::memory::TrainingMemory;
use super::oracle::Oracle;
use super::realise::RestrictedTask;
use super::selection::select_differing;
use super::situation::Situation;
use crate::domain::Domain;
use crate::error::Error;
use crate::learn::version_space::Why;
use crate::learn::{Capacity, Config, Learner, Outcome, Problem, VersionSpace, learn_region};
use crate::random::{Generator, generator};
use crate::region::Region;
use crate::skill::effects::Runs;
use crate::skill::setting::Practice;
use crate::skill::skills::{Known, Library, Skill, Skills};
use crate::skill::tuning::ROUNDS;
use crate::table::swap_rows;

const NO_SKILL: Error = Error::InvalidArgument("there is no skill with this index");
const NO_SITUATION: Error = Error::InvalidArgument("there is no situation with this index");

/// Learns the regions of skills from training tasks (RegionLearningApproach, thesis 5.2),
/// in memory that is lent to it.
///
/// To learn a skill it collects situations from the tasks, selects those that differ, tries
/// them with an [`Oracle`], and learns a region from the answers.
#[derive(Debug)]
pub struct Trainer<'t, 'm, E> {
    environment: &'t E,
    training: Training,
    memory: TrainingMemory<'m>,
}

/// A skill that is to be learned, and what from.
struct Lesson<'s, T> {
    skill: &'s Skill,
    /// What is known so far.
    known: Known<'s>,
    tasks: &'s [T],
}

/// By which criteria situations are selected.
#[derive(Clone, Copy)]
struct Criteria {
    /// From so many tasks at most.
    tasks: usize,
    /// So many at most.
    situations: usize,
    /// Such that they differ; otherwise in the order of the tasks.
    differing: bool,
    /// Only such as take no way, if there are enough.
    direct: bool,
}

impl<'t, 'm, E: Practice> Trainer<'t, 'm, E> {
    /// A trainer for an environment that tries so much.
    pub fn new(environment: &'t E, training: Training, memory: TrainingMemory<'m>) -> Self {
        Trainer {
            environment,
            training,
            memory,
        }
    }

    /// Learns the skill at an index of the descriptions from training tasks, with the
    /// skills learned so far. That there is no region is no error.
    ///
    /// Two controllers give the region of the later one alone: which parameters of the
    /// first make it work, where the first works. What the controllers change is noted.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] if there is no such skill, if the learner's configuration
    /// is out of range, or if its tables are smaller than its capacity;
    /// [`Error::CapacityExceeded`] if a task or the features of a text find no room;
    /// [`Error::Mismatch`] if the skills are not of this environment.
    pub fn learn(
        &mut self,
        skills: &mut Skills<'_>,
        index: usize,
        tasks: &[E::Task],
    ) -> Result<Learned, Error> {
        let (library, changes) = skills.known_mut();
        let skill = library.get(index).ok_or(NO_SKILL)?;
        let lesson = Lesson {
            skill,
            known: (library, &*changes),
            tasks,
        };
        let mut learned = self.collect(&lesson, self.criteria(skill))?;
        let mut oracle = Oracle::from_known(self.environment, (library, changes));
        let mut seen = Runs::default();
        if skill.description().later.is_none() {
            oracle.watch(skill, &mut seen);
        }
        let mut rng = generator(self.training.learner.seed ^ index as u64);
        if !skill.has_parameters() {
            let found = self.memory.situations.get_mut(..learned.situations);
            let found = found.unwrap_or_default();
            learned.situations = try_states(skill, found, &mut oracle, &mut rng)?;
        }
        if learned.situations == 0 {
            learned.runs += oracle.runs();
            return Ok(learned);
        }
        let config = Config {
            calls: self.questions(library, skill, learned.runs + oracle.runs()),
            ..self.training.learner
        };
        let region = self.fit(skill, &mut learned, config, &mut oracle, &mut rng)?;
        learned.runs += oracle.runs();
        learned.region = region.is_some();
        let effects = seen.effects(skill.domain());
        let skill = skills.get_mut(index).ok_or(NO_SKILL)?;
        skill.set_region(region);
        skill.set_effects(effects);
        Ok(learned)
    }

    /// Situations of the skill at an index, from tasks in their order, up to so many: to
    /// judge what was learned.
    ///
    /// # Errors
    /// Those of [`Trainer::learn`].
    pub fn situations(
        &mut self,
        skills: &Skills<'_>,
        index: usize,
        tasks: &[E::Task],
        most: usize,
    ) -> Result<&[Option<Situation>], Error> {
        let skill = skills.get(index).ok_or(NO_SKILL)?;
        let lesson = Lesson {
            skill,
            known: skills.known(),
            tasks,
        };
        let criteria = Criteria {
            tasks: tasks.len(),
            situations: most,
            differing: false,
            direct: false,
        };
        let count = self.collect(&lesson, criteria)?.situations;
        Ok(self.memory.situations.get(..count).unwrap_or_default())
    }

    /// By which criteria the situations of a skill are selected.
    fn criteria(&self, skill: &Skill) -> Criteria {
        let Training {
            tasks,
            situations,
            states,
            ..
        } = self.training;
        let sampled = skill.has_parameters();
        let most = if sampled { situations } else { states };
        Criteria {
            tasks,
            situations: most.min(self.memory.capacity.instances),
            differing: sampled,
            // What comes before only matters to what is learned of a controller alone.
            direct: !sampled || skill.description().later.is_some(),
        }
    }

    /// Collects situations of a skill. Tells how many there are, from how many tasks, and
    /// how many controllers were run to get there.
    fn collect(
        &mut self,
        lesson: &Lesson<'_, E::Task>,
        criteria: Criteria,
    ) -> Result<Learned, Error> {
        let room = criteria.situations.min(self.memory.situations.len());
        let candidates = self.select(lesson, room, criteria)?;
        let used = self.memory.candidates.get(..candidates).unwrap_or_default();
        let tasks = distinct_tasks(used);
        let (situations, runs) = self.realise(lesson, candidates, room)?;
        Ok(Learned {
            tasks,
            situations,
            runs,
            why: Why::NothingTold,
            ..Learned::default()
        })
    }

    /// Selects candidates for so many situations. Returns how many there are.
    fn select(
        &mut self,
        Lesson { skill, tasks, .. }: &Lesson<'_, E::Task>,
        room: usize,
        criteria: Criteria,
    ) -> Result<usize, Error> {
        let (environment, memory) = (self.environment, &mut self.memory);
        let most = self.training.candidates();
        let list = |direct, memory: &mut _| {
            candidates::list(environment, skill, tasks, (most, direct), memory)
        };
        let mut count = list(criteria.direct, memory)?;
        if count < room && criteria.direct {
            count = list(false, memory)?;
        }
        if criteria.differing {
            select_differing(skill, memory, count, room)?;
        }
        let all = memory.candidates.get_mut(..count).unwrap_or_default();
        Ok(take_tasks(all, criteria.tasks))
    }

    /// Makes situations of the first candidates, as long as there is room. Returns how many
    /// there are, and how many controllers were run.
    ///
    /// Where an operator is not applicable in the initial state it is planned for, with
    /// the skills learned so far (the thesis's single-operator task plans); and if there
    /// are not enough situations yet, again with other parameters on the way.
    fn realise(
        &mut self,
        Lesson {
            skill,
            known,
            tasks,
        }: &Lesson<'_, E::Task>,
        candidates: usize,
        room: usize,
    ) -> Result<(usize, u32), Error> {
        let (environment, memory) = (self.environment, &mut self.memory);
        let (mut count, mut runs) = (0, 0);
        for round in 0..ROUNDS {
            let candidates = memory.candidates.iter().take(candidates);
            for (index, candidate) in (0..).zip(candidates) {
                let task = tasks.get(usize::from(candidate.task));
                let (Some(task), true) = (task, count < room) else {
                    break;
                };
                let operators = &mut *memory.operators;
                let mut task =
                    RestrictedTask::new(environment, *known, task, *candidate, operators)?;
                task.way = self.training.way;
                let (seed, planner) = ((round << 16 | index) << 32, memory.planner.reborrow());
                let (situation, more) = task.realise(skill.description(), seed, planner)?;
                runs += more;
                // What takes no way would be the same again.
                let situation = situation.filter(|_| round == 0 || more > 0);
                if let (Some(_), Some(place)) = (&situation, memory.situations.get_mut(count)) {
                    *place = situation;
                    count += 1;
                }
            }
        }
        Ok((count, runs))
    }

    /// How many questions a learner may ask after so many runs of controllers.
    fn questions(&self, library: Library<'_>, skill: &Skill, runs: u32) -> u32 {
        let about = skill.description();
        if about.later.is_some() {
            return self.training.chained;
        }
        let same = |other: &&Skill| other.description().controller == about.controller;
        let is_only = library.iter().filter(same).count() == 1;
        let left = self.training.budget.saturating_sub(runs);
        let calls = self.training.learner.calls;
        if is_only { left.max(calls) } else { calls }
    }

    /// Learns a region from the situations that were found, and notes how that went. `None`
    /// if nothing explains the answers.
    fn fit(
        &mut self,
        skill: &Skill,
        learned: &mut Learned,
        config: Config,
        oracle: &mut Oracle<'_, E>,
        rng: &mut Generator,
    ) -> Result<Option<Region>, Error> {
        let situations = learned.situations;
        self.write_instances(skill, situations)?;
        let (domain, memory) = (skill.domain(), &mut self.memory);
        let numbers = situations * skill.binding().len();
        let numbers = memory.instances.get(..numbers).unwrap_or_default();
        let proposals = memory.proposals.get(..situations).unwrap_or_default();
        let problem = Problem::new(domain, numbers, situations)?.with_proposals(proposals)?;
        let steps = 1 + usize::from(skill.description().later.is_some());
        let capacity = Capacity {
            steps,
            ..memory.capacity
        };
        let tables = memory.learner.reborrow();
        let mut learner = VersionSpace::new(domain, config, capacity, tables)?;
        let outcome = learn_region(&mut learner, &problem, |_, query| {
            let situation = memory.situations.get(query.instance);
            let situation = situation.and_then(Option::as_ref).ok_or(NO_SITUATION)?;
            match situation.outcome {
                Some(outcome) => Ok(outcome),
                None => {
                    let theta = query.theta.get(..domain.parameters().len());
                    oracle.answer(situation, theta, rng)
                }
            }
        })
        .map(|_| ());
        learned.report = learner.report();
        (learned.quality, learned.why) = (learner.quality(), learner.why());
        match outcome {
            Ok(()) => last_step(&learner, domain, steps),
            Err(Error::NoRegion) => Ok(None),
            Err(error) => Err(error),
        }
    }

    /// Writes the instances of the first situations, and proposals of the original sampler.
    fn write_instances(&mut self, skill: &Skill, situations: usize) -> Result<(), Error> {
        const FULL: Error = Error::CapacityExceeded("numbers of training instances");
        let (memory, length) = (&mut self.memory, skill.binding().len());
        let situations = memory.situations.iter().flatten().take(situations);
        for (index, (situation, proposal)) in
            situations.zip(memory.proposals.iter_mut()).enumerate()
        {
            let numbers = memory
                .instances
                .get_mut(index * length..(index + 1) * length);
            situation.instance(self.environment, skill, numbers.ok_or(FULL)?)?;
            *proposal = situation.proposal(self.environment, &mut generator(index as u64));
        }
        Ok(())
    }
}

/// Tries situations without parameters, and moves to the front those that say something:
/// of two controllers, those in which the first one works. Returns how many they are.
fn try_states<E: Practice>(
    skill: &Skill,
    situations: &mut [Option<Situation>],
    oracle: &mut Oracle<'_, E>,
    rng: &mut Generator,
) -> Result<usize, Error> {
    let chained = skill.description().later.is_some();
    let mut kept = 0;
    for index in 0..situations.len() {
        let Some(Some(situation)) = situations.get_mut(index) else {
            break;
        };
        let outcome = oracle.answer(situation, None, rng)?;
        situation.outcome = Some(outcome);
        if !(chained && outcome == Outcome::FailedStep(1)) {
            swap_rows(situations, 1, kept, index);
            kept += 1;
        }
    }
    Ok(kept)
}

/// What was learned of the last of so many steps.
fn last_step(
    learner: &VersionSpace<'_, f64>,
    domain: &Domain<'_>,
    steps: usize,
) -> Result<Option<Region>, Error> {
    let evidence = learner.evidence();
    let formula = learner.region()?.formula().select(|conjunct| {
        let own = evidence.get(conjunct.constraints.start);
        own.is_some_and(|evidence| evidence.step as usize == steps)
    })?;
    let speaks = formula.conjunct_count() > 0;
    Ok(speaks.then(|| Region::new(domain, formula)))
}
