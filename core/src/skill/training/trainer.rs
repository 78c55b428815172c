//! Learning the region of a skill.

use super::selection::swap_rows;
use super::situations::{Wanted, survey};
use crate::domain::Domain;
use crate::error::Error;
use crate::learn::version_space::{Capacity, Config, Memory, VersionSpace};
use crate::learn::{Answer, Learner, Problem, learn_region};
use crate::random::{Generator, generator};
use crate::region::{Region, Theta};
use crate::skill::{Candidate, Describe, Situation, Skill, Skills};
use crate::task::{GroundOperator, State, Task};
use heapless::VecView;

/// How much is tried to learn a skill.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Training {
    /// What the learner is given about a controller alone.
    pub learner: Config,
    /// Questions about two controllers.
    pub chained: u32,
    /// Controllers that are run for one about which there is a single text: what the ways
    /// to the instances leave of them are its questions, if these are more.
    pub budget: u32,
    /// Tasks that instances are taken from.
    pub tasks: usize,
    /// Instances in which parameters are tried.
    pub instances: usize,
    /// Instances of a text without parameters, each of which is tried once.
    pub states: usize,
}

impl Default for Training {
    fn default() -> Self {
        Training {
            learner: Config::default(),
            chained: 200,
            budget: 0,
            tasks: 150,
            instances: 20,
            states: 150,
        }
    }
}

const NO_SKILL: Error = Error::InvalidArgument("there is no skill with this index");

/// The memory of learning a skill. All of it can be used again for the next.
#[derive(Debug)]
pub struct TrainingMemory<'m> {
    /// One for each instance.
    pub situations: &'m mut [Option<Situation>],
    /// Situations to choose from; the more there are, the more those that are chosen
    /// differ.
    pub candidates: &'m mut [Candidate],
    /// One for each candidate.
    pub proposals: &'m mut [Theta],
    /// The numbers of the instances of all candidates.
    pub instances: &'m mut [f64],
    /// For the ground operators of a task.
    pub operators: &'m mut VecView<GroundOperator>,
    /// For planning to where an operator is applicable.
    pub planner: crate::plan::Memory<'m, State>,
    /// For the learner, with this capacity; two steps are needed for two controllers.
    pub learner: Memory<'m, f64>,
    /// Its capacity.
    pub capacity: Capacity,
}

/// What it took to learn a skill.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Learned {
    /// Whether there is a region.
    pub region: bool,
    /// Tasks that instances were taken from.
    pub tasks: usize,
    /// Instances that were found.
    pub instances: usize,
    /// Controllers that were run, those on the way to an instance included.
    pub calls: u32,
}

impl Skills<'_> {
    /// Collects situations of the skill at an index from tasks, in their order, into
    /// `memory.situations`, up to so many: to judge what was learned. Returns how many
    /// there are.
    ///
    /// # Errors
    /// Those of [`Skills::learn`].
    pub fn situations<E: Describe>(
        &self,
        index: usize,
        environment: &E,
        tasks: &[Task],
        wanted: usize,
        mut memory: TrainingMemory<'_>,
    ) -> Result<usize, Error> {
        let skill = self.get(index).ok_or(NO_SKILL)?;
        let wanted = Wanted {
            tasks: tasks.len(),
            situations: wanted,
            differing: false,
            direct: false,
        };
        let (count, ..) = self.collect(skill, environment, tasks, wanted, &mut memory)?;
        Ok(count)
    }

    /// Learns the skill at an index of the descriptions from training tasks, with the
    /// skills learned so far. That there is no region is no error.
    ///
    /// Two controllers give the region of the later one alone: which parameters of the
    /// first make it work, where the first works. What the controllers change is noted.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] if there is no such skill, [`Error::CapacityExceeded`]
    /// if the memory is too small, and those of the learner.
    pub fn learn<E: Describe>(
        &mut self,
        index: usize,
        environment: &E,
        tasks: &[Task],
        training: &Training,
        mut memory: TrainingMemory<'_>,
    ) -> Result<Learned, Error> {
        let skill = self.get(index).ok_or(NO_SKILL)?;
        let (later, domain) = (skill.description.later, skill.domain.clone());
        let sampled = !domain.parameters().is_empty();
        let situations = match sampled {
            true => training.instances,
            false => training.states,
        };
        let wanted = Wanted {
            tasks: training.tasks,
            situations: situations.min(memory.capacity.instances),
            differing: sampled,
            // What comes before only matters to what is learned of a controller alone.
            direct: !sampled || later.is_some(),
        };
        let (mut count, tasks, mut calls) =
            self.collect(skill, environment, tasks, wanted, &mut memory)?;
        let mut rng = generator(training.learner.seed ^ index as u64);
        if !sampled {
            let situations = memory.situations.get_mut(..count).unwrap_or_default();
            let (kept, runs) = self.try_once(environment, situations, later.is_some(), &mut rng)?;
            (count, calls) = (kept, calls + runs);
        }
        let mut learned = Learned {
            region: false,
            tasks,
            instances: count,
            calls,
        };
        if count == 0 {
            return Ok(learned);
        }
        let skill = self.get(index).ok_or(NO_SKILL)?;
        survey(skill, environment, count, &mut memory)?;
        let numbers = count * skill.binding.len();
        let situations = memory.situations.get(..count).unwrap_or_default();
        let proposals = memory.proposals.get(..count).unwrap_or_default();
        let instances = memory.instances.get(..numbers).unwrap_or_default();
        let problem = Problem::new(&domain, instances, count)?.with_proposals(proposals)?;
        let steps = 1 + usize::from(later.is_some());
        let config = Config {
            calls: match later {
                Some(_) => training.chained,
                None if self.is_only(index) => {
                    let left = training.budget.saturating_sub(calls);
                    left.max(training.learner.calls)
                }
                None => training.learner.calls,
            },
            ..training.learner
        };
        let capacity = Capacity {
            steps,
            ..memory.capacity
        };
        let mut learner = VersionSpace::new(&domain, config, capacity, memory.learner)?;
        let outcome = learn_region(&mut learner, &problem, |_, query| {
            let situation = situations.get(query.instance).and_then(Option::as_ref);
            let situation = situation.ok_or(Error::InvalidArgument("no such instance"))?;
            if let Some(answer) = situation.answer {
                return Ok(answer);
            }
            let theta = query.theta.get(..domain.parameters().len());
            let (answer, runs) = self.attempt(environment, situation, theta, &mut rng)?;
            learned.calls += runs;
            Ok::<_, Error>(answer)
        });
        let region = match outcome {
            Ok(_) => last_step(&learner, &domain, steps)?,
            Err(Error::NoRegion) => None,
            Err(error) => return Err(error),
        };
        learned.region = region.is_some();
        self.get_mut(index).ok_or(NO_SKILL)?.set_region(region);
        Ok(learned)
    }

    /// Whether a skill is all that there is to know about its controller.
    fn is_only(&self, index: usize) -> bool {
        let own = |skill: &Skill| skill.description.own;
        let same = |skill: &&Skill| self.get(index).is_some_and(|only| own(only) == own(skill));
        self.iter().filter(same).count() == 1
    }

    /// Tries situations without parameters, and leaves out those of two controllers of
    /// which already the first one fails: they say nothing. Returns how many are left and
    /// how many controllers were run.
    fn try_once<E: Describe>(
        &mut self,
        environment: &E,
        situations: &mut [Option<Situation>],
        chained: bool,
        rng: &mut Generator,
    ) -> Result<(usize, u32), Error> {
        let (mut kept, mut calls) = (0, 0);
        for index in 0..situations.len() {
            let Some(Some(situation)) = situations.get_mut(index) else {
                break;
            };
            let (answer, runs) = self.attempt(environment, situation, None, rng)?;
            situation.answer = Some(answer);
            calls += runs;
            if !(chained && answer == Answer::FailedStep(1)) {
                if kept < index {
                    swap_rows(situations, 1, kept, index);
                }
                kept += 1;
            }
        }
        Ok((kept, calls))
    }
}

impl Skill {
    /// Writes the instance of a situation to `out`, which has a place for each number.
    ///
    /// # Errors
    /// [`Error::Mismatch`] if the situation is not one of this skill.
    pub fn instance<E: Describe>(
        &self,
        environment: &E,
        situation: &Situation,
        out: &mut [f64],
    ) -> Result<(), Error> {
        situation.with_context(environment, self.description.among, |context| {
            self.binding.instance(context, out)
        })
    }
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
