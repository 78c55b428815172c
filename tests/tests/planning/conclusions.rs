//! How planning ends, and what it tells of that.

use crate::planner::{plan, tasks};
use critreg::Error;
use critreg::env::stick_button::{FIRST_BUTTON, StickButton};
use critreg::plan::{
    self, AbstractTask, Conclusion, Config, Draw, Drawn, Planner, Sampler, Simulated, Unguided,
    World,
};
use critreg::random::generator;
use critreg::task::{Arguments, AtomSet, GroundOperator, OperatorId, Parameters, State, Task};
use critreg_tests::pick::ENVIRONMENT;
use critreg_tests::plan::ideal::{Ideal, NO_GRASP, OUT_OF_REACH};
use critreg_tests::plan::{Grounding, Room};
use rand_core::Rng;

#[test]
fn every_conclusion_tells_what_it_cost() {
    let task = tasks(1..=1, 100)
        .into_iter()
        .find(|task| {
            // Only the stick reaches the button, so that several samples are needed.
            let grounding = Grounding::new(&ENVIRONMENT, task).unwrap();
            let hooks = (&mut grounding.simulated(), &mut Unguided);
            let mut room = Room::new(1000);
            let planned = plan(
                &task.initial,
                &grounding,
                hooks,
                Config::default(),
                &mut room,
            );
            planned.metrics.samples > 5 && planned.metrics.skeletons == 2
        })
        .unwrap();
    let grounding = Grounding::new(&ENVIRONMENT, &task).unwrap();
    let default = Config::default();
    let cases = [
        (default, 1000, Conclusion::Solved),
        (
            Config {
                max_samples: 3,
                ..default
            },
            1000,
            Conclusion::SamplesSpent,
        ),
        (
            Config {
                max_skeletons: 1,
                ..default
            },
            1000,
            Conclusion::SkeletonsSpent,
        ),
        (
            Config {
                max_actions: 1,
                max_skeletons: 9,
                ..default
            },
            1000,
            Conclusion::SkeletonsSpent,
        ),
        (default, 4, Conclusion::Full("nodes of the search")),
        (default, 0, Conclusion::Full("nodes of the search")),
    ];
    for (config, nodes, conclusion) in cases {
        let mut room = Room::new(nodes);
        let hooks = (&mut grounding.simulated(), &mut Unguided);
        let planned = plan(&task.initial, &grounding, hooks, config, &mut room);
        assert_eq!(planned.conclusion, conclusion);
        let metrics = &planned.metrics;
        assert_eq!(planned.steps.is_empty(), conclusion != Conclusion::Solved);
        assert!(metrics.samples <= config.max_samples);
        assert!(metrics.skeletons <= config.max_skeletons);
        assert_eq!(metrics.nodes_created == 1, nodes == 0);
        let failed = metrics.most_failed();
        assert_eq!(failed.is_none(), metrics.samples == 0);
        assert_eq!(metrics.main_reason(), None);
    }
}

#[test]
fn why_no_plan_was_found() {
    // A button that neither hand nor stick reaches.
    let mut task = tasks(1..=1, 1).remove(0);
    let button = task.initial.attributes_mut(FIRST_BUTTON).unwrap();
    button[1] = 5.95;
    let grounding = Grounding::new(&ENVIRONMENT, &task).unwrap();
    let initial = &task.initial;
    let mut ideal = Ideal { initial };
    let mut room = Room::new(10_000);
    let config = Config {
        max_length: 4,
        ..Config::default()
    };
    let hooks = (&mut ideal.clone(), &mut ideal);
    let planned = plan(&task.initial, &grounding, hooks, config, &mut room);
    assert_eq!(planned.conclusion, Conclusion::LengthSpent);
    let metrics = planned.metrics;
    assert!(metrics.empty_draws > 0);
    let [by_hand, by_stick] = [OUT_OF_REACH, NO_GRASP].map(|r| metrics.reasons()[usize::from(r.0)]);
    assert!(by_hand > 0 && by_stick > 0);
    let main = if by_hand >= by_stick {
        OUT_OF_REACH
    } else {
        NO_GRASP
    };
    assert_eq!(metrics.main_reason(), Some(main));
    let most = metrics.failures().iter().max().unwrap();
    let OperatorId(failed) = metrics.most_failed().unwrap();
    assert!(*most > 0 && metrics.failures()[usize::from(failed)] == *most);
}

#[test]
fn a_goal_that_holds_needs_no_step_and_one_out_of_reach_ends_the_search() {
    let task = tasks(1..=1, 1).remove(0);
    let solved = Task {
        goal: Default::default(),
        ..task.clone()
    };
    let outcomes = [(&solved, true), (&task, false)].map(|(task, press)| {
        let mut grounding = Grounding::new(&ENVIRONMENT, task).unwrap();
        if !press {
            // The first four pick and place.
            grounding.operators.truncate(4);
        }
        let mut room = Room::new(100);
        let hooks = (&mut grounding.simulated(), &mut Unguided);
        let planned = plan(
            &task.initial,
            &grounding,
            hooks,
            Config::default(),
            &mut room,
        );
        assert_eq!(planned.steps.len(), 0);
        assert_eq!(planned.metrics.nodes_created, 1);
        planned.conclusion
    });
    assert_eq!(outcomes, [Conclusion::Solved, Conclusion::Exhausted]);
}

/// A sampler that breaks down after some draws.
struct Fragile<'a> {
    original: Simulated<'a, StickButton>,
    draws: u32,
}

impl<'a> Sampler<Simulated<'a, StickButton>> for Fragile<'a> {
    fn sample<R: Rng>(&mut self, draw: &Draw<'_, State>, rng: &mut R) -> Result<Drawn, Error> {
        let left = self.draws.checked_sub(1);
        self.draws = left.ok_or(Error::OutOfSequence("broken"))?;
        self.original.sample(draw, rng)
    }
}

#[test]
fn an_error_is_passed_on_and_the_memory_stays_usable() {
    let task = tasks(1..=1, 1).remove(0);
    let grounding = Grounding::new(&ENVIRONMENT, &task).unwrap();
    let mut room = Room::new(1000);
    let mut results = vec![];
    for draws in [1000, 0, 1000] {
        let mut planner = Planner {
            world: &mut grounding.simulated(),
            sampler: &mut Fragile {
                original: grounding.simulated(),
                draws,
            },
            guide: &mut Unguided,
            config: Config::default(),
        };
        let (task, initial) = (grounding.task(), &task.initial);
        let samples = || generator(2);
        let planned = planner.plan(task, initial, generator(1), samples, room.lend());
        results.push(planned.map(|a| (a.conclusion, a.metrics.samples, a.metrics.nodes_created)));
    }
    assert_eq!(results[1], Err(Error::OutOfSequence("broken")));
    assert!(matches!(results[0], Ok((Conclusion::Solved, ..))));
    assert_eq!(results[0], results[2]);
}

/// A world in which every operator takes this many actions and works.
struct Slow(u32);

impl World for Slow {
    type State = ();
    type Error = Error;

    fn parameters(&self, _: &GroundOperator) -> Result<usize, Error> {
        Ok(0)
    }

    fn holds(&mut self, _: u32, (): &()) -> Result<bool, Error> {
        Ok(true)
    }

    fn execute(
        &mut self,
        _: &GroundOperator,
        _: &[f64],
        (): &(),
        (): &mut (),
    ) -> Result<u32, Error> {
        Ok(self.0)
    }
}

struct NoParameters;

impl Sampler<Slow> for NoParameters {
    fn sample<R: Rng>(&mut self, _: &Draw<'_, ()>, _: &mut R) -> Result<Drawn, Error> {
        Ok(Drawn::Parameters(Parameters::new()))
    }
}

/// Two operators of half of all actions that can be counted still are a plan, three are
/// too many, as are two that take all of them.
#[test]
fn a_plan_has_no_more_actions_than_can_be_counted() {
    let operators = [0, 1, 2].map(|place: u32| GroundOperator {
        operator: OperatorId(0),
        objects: Arguments::default(),
        cost: 1,
        preconditions: place.checked_sub(1).map_or(AtomSet::EMPTY, AtomSet::single),
        add_effects: AtomSet::single(place),
        delete_effects: AtomSet::EMPTY,
    });
    let (half, all) = (u32::MAX / 2, u32::MAX);
    let cases = [
        (half, 2, true),
        (half, 3, false),
        (all, 1, true),
        (all, 2, false),
        (all, 3, false),
    ];
    for (actions, length, solved) in cases {
        let mut room = plan::Room::<(), 3, 64, 3>::default();
        let task = AbstractTask {
            operators: &operators,
            initial: AtomSet::EMPTY,
            goal: AtomSet::single(length - 1),
        };
        let mut planner = Planner {
            world: &mut Slow(actions),
            sampler: &mut NoParameters,
            guide: &mut Unguided,
            config: Config {
                max_actions: u32::MAX,
                max_length: 3,
                ..Config::default()
            },
        };
        let numbers = || generator(1);
        let planned = planner
            .plan(task, &(), numbers(), numbers, room.lend())
            .unwrap();
        let is_solved = planned.conclusion == Conclusion::Solved;
        assert_eq!(is_solved, solved, "{length} steps of {actions} actions");
    }
}
