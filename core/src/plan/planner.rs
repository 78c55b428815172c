//! The planner: search, then sample.

use super::config::Config;
use super::guide::Guide;
use super::heuristic::HeuristicMemory;
use super::metrics::Metrics;
use super::refine::{Refinement, Refiner, Step};
use super::search::{Search, SearchMemory};
use super::task::AbstractTask;
use super::world::{Sampler, World};
use crate::error::Error;
use rand_core::Rng;

/// The memory of one planning. All of it can be used again for the next.
#[derive(Debug)]
pub struct Memory<'m, S, const N: usize = 2> {
    /// For the search.
    pub search: SearchMemory<'m, N>,
    /// One for each operator of the longest skeleton to be refined.
    pub steps: &'m mut [Step<S, N>],
    /// A counter for each operator; see [`Metrics::failures`].
    pub failures: &'m mut [u32],
    /// A counter for each reason that guide and sampler give; see
    /// [`Metrics::reasons`].
    pub reasons: &'m mut [u32],
}

impl<S, const N: usize> Memory<'_, S, N> {
    /// The same memory, lent for a shorter time.
    pub fn reborrow(&mut self) -> Memory<'_, S, N> {
        let heuristic = &mut self.search.heuristic;
        Memory {
            search: SearchMemory {
                heuristic: HeuristicMemory {
                    operators: heuristic.operators,
                    links: heuristic.links,
                    cache: heuristic.cache,
                },
                nodes: self.search.nodes,
                open: self.search.open,
                visited: self.search.visited,
            },
            steps: self.steps,
            failures: self.failures,
            reasons: self.reasons,
        }
    }
}

/// How planning ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Conclusion {
    /// There is a plan.
    Solved,
    /// No further sequence of operators reaches the goal: there is no plan, or it
    /// was pruned, or it needs other samples.
    Exhausted,
    /// Likewise, but some sequences were not extended beyond
    /// [`Config::max_length`] or the steps of the memory: [`Metrics::cut_off`].
    LengthSpent,
    /// [`Config::max_skeletons`] were refined in vain.
    SkeletonsSpent,
    /// [`Config::max_samples`] were drawn.
    SamplesSpent,
    /// The memory is full; which.
    Full(&'static str),
}

/// What came of planning.
#[derive(Debug)]
pub struct Planned<'m, S, const N: usize = 2> {
    /// How it ended.
    pub conclusion: Conclusion,
    /// What it cost, and what stood in the way.
    pub metrics: Metrics<'m>,
    /// The plan; empty unless solved.
    pub steps: &'m [Step<S, N>],
}

/// A bilevel planner. See the [module](super).
#[derive(Debug)]
pub struct Planner<'a, W, S, G> {
    /// What is planned in.
    pub world: &'a mut W,
    /// Where parameters come from.
    pub sampler: &'a mut S,
    /// Who advises the search.
    pub guide: &'a mut G,
    /// How to plan, and how long.
    pub config: Config,
}

impl<W, S, G> Planner<'_, W, S, G> {
    /// Plans from a state, of which `task.initial` is the abstraction.
    ///
    /// `lots` breaks ties in the search, from the beginning again if patience ends.
    /// `samples` makes the generator that the
    /// sampler draws from, anew for each skeleton: what is drawn for one does not
    /// depend on how many were refined before.
    ///
    /// # Errors
    /// Those of the world and the sampler. That there is no plan is no error.
    pub fn plan<'m, R: Rng, const N: usize>(
        &mut self,
        task: AbstractTask<'m, N>,
        initial: &W::State,
        lots: impl Rng + Clone,
        samples: impl FnMut() -> R,
        memory: Memory<'m, W::State, N>,
    ) -> Result<Planned<'m, W::State, N>, W::Error>
    where
        W: World<N>,
        S: Sampler<W, N>,
        G: Guide<N>,
    {
        let mut metrics = Metrics::new(memory.failures, memory.reasons);
        let steps = memory.steps;
        let config = Config {
            max_length: self.config.max_length.min(steps.len()),
            skeletons_per_state: self.skeletons_per_state(task)?,
            ..self.config
        };
        let search = Search::new(task, &config, lots, memory.search, &mut metrics);
        let conclusion = match search {
            Ok(mut search) => {
                self.search_then_sample(&mut search, initial, samples, steps, &mut metrics)?
            }
            Err(error) => full(error)?,
        };
        let plan = steps.get(..metrics.plan_length as usize);
        Ok(Planned {
            conclusion,
            metrics,
            steps: plan.unwrap_or_default(),
        })
    }

    /// One, if no operator has parameters: then there is nothing to choose on the way.
    fn skeletons_per_state<const N: usize>(
        &self,
        task: AbstractTask<'_, N>,
    ) -> Result<u32, W::Error>
    where
        W: World<N>,
    {
        for operator in task.operators.iter().filter(|o| !o.is_goal()) {
            if self.world.parameters(operator)? > 0 {
                return Ok(self.config.skeletons_per_state.max(1));
            }
        }
        Ok(1)
    }

    fn search_then_sample<R: Rng, const N: usize>(
        &mut self,
        search: &mut Search<'_, impl Rng + Clone, N>,
        initial: &W::State,
        mut samples: impl FnMut() -> R,
        steps: &mut [Step<W::State, N>],
        metrics: &mut Metrics<'_>,
    ) -> Result<Conclusion, W::Error>
    where
        W: World<N>,
        S: Sampler<W, N>,
        G: Guide<N>,
    {
        let task = search.task();
        let mut refiner = Refiner {
            world: &mut *self.world,
            sampler: &mut *self.sampler,
            initial,
            goal: task.goal,
            config: &self.config,
            dead: None,
            done: 0,
        };
        loop {
            let spent = metrics.spent().skeletons >= self.config.max_skeletons;
            if spent && !metrics.is_advised() {
                return Ok(Conclusion::SkeletonsSpent);
            }
            let skeleton = match search.next_skeleton(self.guide, metrics) {
                Ok(Some(skeleton)) => skeleton,
                Ok(None) if metrics.cut_off > 0 => return Ok(Conclusion::LengthSpent),
                Ok(None) => return Ok(Conclusion::Exhausted),
                Err(error) => return full(error),
            };
            metrics.skeletons += 1;
            let end = skeleton
                .iter()
                .fold(task.initial, |state, o| o.apply(state));
            refiner.goal = task.reached(end).unwrap_or(task.goal);
            match refiner.refine(skeleton, &mut samples(), steps, metrics)? {
                Refinement::Failed => {
                    if let Some(length) = refiner.dead {
                        search.bury(length);
                    }
                    search.widen();
                }
                Refinement::PatienceSpent => {}
                Refinement::SamplesSpent => return Ok(Conclusion::SamplesSpent),
                Refinement::TooLong => return Ok(Conclusion::Full("steps of a plan")),
                Refinement::Done => {
                    metrics.plan_length = skeleton.len() as u32;
                    return Ok(Conclusion::Solved);
                }
            }
        }
    }
}

/// That the memory is full is a conclusion of planning, anything else an error.
fn full<E: From<Error>>(error: Error) -> Result<Conclusion, E> {
    match error {
        Error::CapacityExceeded(what) => Ok(Conclusion::Full(what)),
        error => Err(error.into()),
    }
}
