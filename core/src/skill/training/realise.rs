//! Making situations of candidates: the way to a state in which an operator is
//! applicable, and what a later operator needs in between.

use super::candidates::of_controller;
use super::situation::{Candidate, MAX_CHAIN, Situation, controller_objects};
use crate::error::Error;
use crate::plan::{AbstractTask, Conclusion, Config, Memory, Planner, World};
use crate::random::generator;
use crate::skill::description::Description;
use crate::skill::planning::{RegionGuide, RegionSampler};
use crate::skill::setting::Practice;
use crate::skill::skills::Known;
use crate::task::{Arguments, AtomSet, Atoms, ControllerId, GroundOperator, State};
use heapless::{Vec, VecView};

/// The operators to try, one after the other.
type Chain = Vec<GroundOperator, MAX_CHAIN>;

/// A task with those operators that handle no objects but a candidate's: what happens to
/// others on the way would be a reason of its own why something fails.
pub(super) struct RestrictedTask<'t, 'o, E> {
    environment: &'t E,
    /// What is known so far.
    known: Known<'t>,
    initial: &'t State,
    /// What holds in the beginning.
    holding: AtomSet,
    atoms: Atoms,
    operators: &'o [GroundOperator],
    candidate: Candidate,
    /// Controllers that may be run on the way.
    pub(super) way: u32,
}

impl<'t, 'o, E: Practice> RestrictedTask<'t, 'o, E> {
    /// A task as a candidate sees it. The ground operators are put into `operators`.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] if the atoms or ground operators find no room.
    pub(super) fn new(
        environment: &'t E,
        known: Known<'t>,
        task: &'t E::Task,
        candidate: Candidate,
        operators: &'o mut VecView<GroundOperator>,
    ) -> Result<Self, Error> {
        operators.clear();
        let (atoms, holding) = environment.ground(task, operators)?;
        operators.retain(|ground| {
            let own = controller_objects(environment, ground);
            own.is_ok_and(|own| own.as_slice().iter().all(|object| candidate.has(*object)))
        });
        Ok(RestrictedTask {
            environment,
            known,
            initial: environment.initial(task),
            holding,
            atoms,
            operators,
            candidate,
            way: Config::default().max_samples,
        })
    }

    /// The situation of the candidate, if there is a way to it, and how many controllers
    /// were run to find it. The parameters on the way are those of a seed.
    ///
    /// # Errors
    /// Those of [`Planner::plan`].
    pub(super) fn realise(
        &self,
        about: &Description,
        seed: u64,
        planner: Memory<'_, State>,
    ) -> Result<(Option<Situation>, u32), Error> {
        let own = || self.of(about.controller, self.candidate.objects);
        let (state, runs) = self.reach(own, seed, planner)?;
        let Some(state) = state else {
            return Ok((None, runs));
        };
        let before = self.world().abstraction(&state)?;
        let applicable = own().filter(|own| own.is_applicable(before));
        let chains = applicable.filter_map(|own| match about.later {
            Some(later) => self.chain(before, own, later),
            None => chain_of([own]),
        });
        let steps = chains.min_by_key(|steps| steps.len());
        let situation = steps.map(|steps| Situation {
            state,
            steps,
            outcome: None,
        });
        Ok((situation, runs))
    }

    /// The ground operators of a controller with these objects.
    fn of(
        &self,
        controller: ControllerId,
        objects: Arguments,
    ) -> impl Iterator<Item = &'o GroundOperator> {
        let all = of_controller(self.environment, self.operators, controller);
        let same = all.filter(move |(_, own)| *own == objects);
        same.map(|(ground, _)| ground)
    }

    /// A state in which one of these operators is applicable, and how many controllers
    /// were run to find it.
    fn reach<I: Iterator<Item = &'o GroundOperator>>(
        &self,
        own: impl Fn() -> I,
        seed: u64,
        mut memory: Memory<'_, State>,
    ) -> Result<(Option<State>, u32), Error> {
        let initial = self.holding;
        if own().any(|ground| ground.is_applicable(initial)) {
            return Ok((Some(self.initial.clone()), 0));
        }
        // What lacks least is the shortest way, and shows the controller in its plainest use.
        let lacking = |ground: &GroundOperator| ground.preconditions.difference(initial).len();
        let most = own().map(lacking).max().unwrap_or(0);
        let nearest_first = (1..=most).flat_map(|count| own().filter(move |g| lacking(g) == count));
        let mut runs = 0;
        for ground in nearest_first {
            let left = self.way.saturating_sub(runs);
            if left == 0 {
                break;
            }
            let mut planner = Planner {
                world: &mut self.world(),
                sampler: &mut RegionSampler::from_library(self.environment, self.known.0),
                guide: &mut RegionGuide::from_known(self.environment, self.known, self.initial),
                config: Config {
                    max_samples: left,
                    ..Config::default()
                },
            };
            let task = AbstractTask {
                operators: self.operators,
                initial,
                goal: ground.preconditions,
            };
            let numbers = || generator(seed ^ u64::from(runs));
            let memory = memory.reborrow();
            let planned = planner.plan(task, self.initial, numbers(), numbers, memory)?;
            runs += planned.metrics.samples;
            if planned.conclusion == Conclusion::Solved {
                return Ok((planned.steps.last().map(|step| step.state.clone()), runs));
            }
        }
        Ok((None, runs))
    }

    /// The shortest sequence from an operator to one of a later controller, with what it
    /// needs in between. What comes in between leaves the operator's objects alone or has no
    /// parameters, so that those of the operator still matter in the end.
    fn chain(&self, before: AtomSet, own: &GroundOperator, later: ControllerId) -> Option<Chain> {
        let last = |state: AtomSet| {
            let mut all = self.of(later, self.candidate.later_objects);
            all.find(|last| last.is_applicable(state))
        };
        let between = |state: AtomSet| {
            let follows = move |ground: &&GroundOperator| {
                ground.is_applicable(state) && !self.decides_anew(ground, own)
            };
            self.operators.iter().filter(follows)
        };
        let start = own.apply(before);
        if let Some(last) = last(start) {
            return chain_of([own, last]);
        }
        let one = between(start).find_map(|first| {
            let last = last(first.apply(start))?;
            chain_of([own, first, last])
        });
        one.or_else(|| {
            between(start).find_map(|first| {
                let state = first.apply(start);
                between(state).find_map(|second| {
                    let last = last(second.apply(state))?;
                    chain_of([own, first, second, last])
                })
            })
        })
    }

    /// The environment as a world to plan in.
    fn world(&self) -> TaskWorld<'_, E> {
        TaskWorld {
            environment: self.environment,
            atoms: &self.atoms,
        }
    }

    /// Whether the parameters of an operator count instead of those of an earlier one, as it
    /// handles an object of that one.
    fn decides_anew(&self, later: &GroundOperator, earlier: &GroundOperator) -> bool {
        let (Ok(parameters), Ok(later), Ok(earlier)) = (
            self.world().parameters(later),
            controller_objects(self.environment, later),
            controller_objects(self.environment, earlier),
        ) else {
            return true;
        };
        let mut all = later.as_slice().iter();
        parameters > 0 && all.any(|object| earlier.as_slice().contains(object))
    }
}

/// What skills are learned in, as a world to plan in.
struct TaskWorld<'a, E> {
    environment: &'a E,
    atoms: &'a Atoms,
}

impl<E: Practice> TaskWorld<'_, E> {
    /// The atoms that hold in a state.
    fn abstraction(&mut self, state: &State) -> Result<AtomSet, Error> {
        let mut holding = AtomSet::EMPTY;
        for (place, atom) in (0..).zip(self.atoms.as_slice()) {
            if self.environment.holds(atom, state)? {
                holding = holding.union(AtomSet::single(place));
            }
        }
        Ok(holding)
    }
}

impl<E: Practice> World for TaskWorld<'_, E> {
    type State = State;
    type Error = Error;

    fn parameters(&self, ground: &GroundOperator) -> Result<usize, Error> {
        let (controller, _) = self
            .environment
            .call(ground.operator, ground.objects.as_slice())?;
        Ok(self.environment.signature(controller)?.parameters)
    }

    fn holds(&mut self, atom: u32, state: &State) -> Result<bool, Error> {
        let atom = self.atoms.as_slice().get(atom as usize);
        let atom = atom.ok_or(Error::Mismatch("an atom is not of this task"))?;
        self.environment.holds(atom, state)
    }

    fn execute(
        &mut self,
        ground: &GroundOperator,
        parameters: &[f64],
        before: &State,
        after: &mut State,
    ) -> Result<u32, Error> {
        after.clone_from(before);
        self.environment.execute(ground, parameters, after)
    }
}

fn chain_of<const N: usize>(steps: [&GroundOperator; N]) -> Option<Chain> {
    Vec::from_slice(&steps.map(|step| *step)).ok()
}
