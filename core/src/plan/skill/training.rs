//! Learning the region of a skill.

use super::settings::collect;
use super::{Describe, Setting, Skills};
use crate::domain::{GroundOperator, Operator, State, Task, try_operator};
use crate::error::Error;
use crate::learn::version_space::{Capacity, Config, Memory, VersionSpace};
use crate::learn::{Answer, Learner, Problem, learn_region};
use crate::region::Region;
use crate::table::gather;
use heapless::VecView;

/// How much is tried to learn a skill.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Training {
    /// What the learner is given; its calls are those for each step.
    pub learner: Config,
    /// Instances in which parameters are tried.
    pub instances: usize,
    /// Instances in which a controller without parameters is tried, each once.
    pub states: usize,
}

impl Default for Training {
    fn default() -> Self {
        Training {
            learner: Config::default(),
            instances: 20,
            states: 150,
        }
    }
}

/// The memory of learning a skill. All of it can be used again for the next.
#[derive(Debug)]
pub struct TrainingMemory<'m> {
    /// One for each instance.
    pub settings: &'m mut [Option<Setting>],
    /// The numbers of all instances.
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
    /// Instances that were found.
    pub instances: usize,
    /// Controllers that were run, those on the way to an instance included.
    pub calls: u32,
}

impl Skills<'_> {
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
        const NO_SKILL: Error = Error::InvalidArgument("there is no skill with this index");
        let skill = self.get_mut(index).ok_or(NO_SKILL)?;
        let (description, domain) = (skill.description, skill.domain.clone());
        let sampled = !domain.parameters().is_empty();
        let wanted = if sampled {
            training.instances
        } else {
            training.states
        };
        let wanted = wanted.min(memory.capacity.instances);
        let (count, mut calls) =
            collect(environment, self, &description, tasks, wanted, &mut memory)?;
        if count == 0 {
            return Ok(Learned::default());
        }
        let settings = memory.settings.get(..count).unwrap_or_default();
        let instances = self.instances(index, environment, settings, memory.instances)?;
        let problem = Problem::new(&domain, instances, count)?;
        let steps = 1 + usize::from(description.later.is_some());
        let config = Config {
            calls: training.learner.calls.saturating_mul(steps as u32),
            ..training.learner
        };
        let capacity = Capacity {
            steps,
            ..memory.capacity
        };
        let mut learner = VersionSpace::new(&domain, config, capacity, memory.learner)?;
        let learned = learn_region(&mut learner, &problem, |_, query| {
            let setting = settings.get(query.instance).and_then(Option::as_ref);
            let setting = setting.ok_or(Error::InvalidArgument("no such instance"))?;
            let (answer, runs) = self.attempt(environment, setting, &query.theta);
            calls += runs;
            Ok::<_, Error>(answer)
        });
        let region = match learned {
            Ok(_) => last_step(&learner, &domain, steps)?,
            Err(Error::NoRegion) => None,
            Err(error) => return Err(error),
        };
        let learned = Learned {
            region: region.is_some(),
            instances: count,
            calls,
        };
        self.get_mut(index).ok_or(NO_SKILL)?.set_region(region);
        Ok(learned)
    }

    /// The numbers of the instances of all settings.
    fn instances<'n, E: Describe>(
        &self,
        index: usize,
        environment: &E,
        settings: &[Option<Setting>],
        numbers: &'n mut [f64],
    ) -> Result<&'n [f64], Error> {
        const FULL: Error = Error::CapacityExceeded("numbers of training instances");
        let skill = self.skills.get(index).and_then(Option::as_ref);
        let binding = &skill.ok_or(FULL)?.binding;
        let numbers = numbers
            .get_mut(..settings.len() * binding.len())
            .ok_or(FULL)?;
        let objects = |ground: &GroundOperator| {
            let operator = operator(environment, ground)?;
            operator.controller_objects(ground.objects.as_slice())
        };
        let places = numbers.chunks_exact_mut(binding.len().max(1));
        for (setting, numbers) in settings.iter().flatten().zip(places) {
            let own = objects(&setting.own)?;
            let later = setting
                .later
                .as_ref()
                .map(objects)
                .transpose()?
                .unwrap_or_default();
            binding.instance(&setting.state, own.as_slice(), later.as_slice(), numbers)?;
        }
        Ok(numbers)
    }

    /// Tries parameters in a setting. Returns also how many controllers were run.
    fn attempt<E: Describe>(
        &mut self,
        environment: &E,
        setting: &Setting,
        theta: &[f64],
    ) -> (Answer, u32) {
        let mut state = setting.state.clone();
        let steps = (1..).zip([Some(&setting.own), setting.later.as_ref()]);
        let mut runs = 0;
        for (step, ground) in steps {
            let Some(ground) = ground else { break };
            runs = step;
            match self.run(environment, ground, theta, &state) {
                Some(after) => state = after,
                None => return (Answer::FailedStep(step), runs),
            }
        }
        (Answer::Feasible, runs)
    }

    /// Runs an operator and notes what it changes; the state afterwards if it works.
    fn run<E: Describe>(
        &mut self,
        environment: &E,
        ground: &GroundOperator,
        theta: &[f64],
        before: &State,
    ) -> Option<State> {
        let operator = operator(environment, ground).ok()?;
        let objects = ground.objects.as_slice();
        let controller = environment
            .controllers()
            .get(usize::from(operator.controller.0))?;
        let theta = theta.iter().take(controller.parameters.len());
        let parameters: crate::domain::Parameters = gather(theta.map(|value| *value as f32));
        let outcome = try_operator(environment, operator, objects, &parameters, before);
        let arguments = operator.controller_objects(objects).ok()?;
        let changes = self.changes_mut(operator.controller)?;
        let feasible = outcome.is_feasible();
        feasible.then(|| {
            changes.observe(arguments.as_slice(), before, &outcome.state);
            outcome.state
        })
    }
}

fn operator<E: Describe>(
    environment: &E,
    ground: &GroundOperator,
) -> Result<&'static Operator<'static>, Error> {
    let operators = environment.operators();
    let operator = operators.get(usize::from(ground.operator.0));
    operator.ok_or(Error::Mismatch("an operator is not of this environment"))
}

/// What was learned of the last of so many steps.
fn last_step(
    learner: &VersionSpace<'_, f64>,
    domain: &crate::domain::Domain<'_>,
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
