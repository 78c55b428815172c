//! The planner against recordings of the Predicators framework and brute force.

use critreg::Error;
use critreg::domain::{GroundOperator, State};
use critreg::env::stick_button::{BUTTON_TYPE, FIRST_BUTTON, StickButton};
use critreg::plan::{Config, Draw, Drawn, Outcome, Planner, Sampler, Simulated, Unguided};
use critreg::random::uniform;
use critreg_tests::pick::ENVIRONMENT;
use critreg_tests::plan::record::{self, Run};
use critreg_tests::plan::{Grounding, Room};
use rand_core::Rng;
use rand_pcg::Pcg64;

#[test]
fn the_framework_s_generator() {
    let mut count = 0;
    for mut stream in record::streams() {
        for expected in &stream.uniforms {
            assert_eq!(uniform(&mut stream.generator), *expected);
        }
        count += 1;
    }
    assert_eq!(count, 61);
}

/// The original sampler, writing down which skeleton is sampled how often.
struct Tracing<'a> {
    original: Simulated<'a, StickButton>,
    skeletons: Vec<(Vec<u16>, u32)>,
}

impl Sampler<Simulated<'_, StickButton>> for Tracing<'_> {
    fn sample<R: Rng>(&mut self, draw: &Draw<'_, State>, rng: &mut R) -> Result<Drawn, Error> {
        let places = draw.skeleton.places();
        match self.skeletons.last_mut() {
            Some((last, samples)) if last == places => *samples += 1,
            _ => self.skeletons.push((places.to_vec(), 1)),
        }
        self.original.sample(draw, rng)
    }
}

/// The digits of an operator and of its buttons, as recorded.
fn digits(operator: &GroundOperator, state: &State) -> String {
    let objects = operator.objects.as_slice().iter();
    let buttons = objects.filter(|o| state.type_of(**o) == Some(BUTTON_TYPE));
    let digits = buttons.map(|button| (button.0 - FIRST_BUTTON.0).to_string());
    std::iter::once(operator.operator.0.to_string())
        .chain(digits)
        .collect()
}

#[test]
fn every_recorded_run() {
    let generators: Vec<Pcg64> = record::streams().map(|s| s.generator).collect();
    let mut room = Room::new(10_000);
    let (mut counts, mut samples) = ([0; 2], 0);
    for run in record::runs() {
        samples += replay(&run, &generators[run.planner_seed as usize], &mut room);
        counts[usize::from(run.solved)] += 1;
    }
    let [failed, solved] = counts;
    println!("{solved} solved and {failed} failed runs with {samples} samples");
    assert_eq!((solved, failed), (442, 7));
}

/// Plans the task of a run with the framework's streams of random numbers, and
/// returns the number of samples.
fn replay(run: &Run, generator: &Pcg64, room: &mut Room) -> u32 {
    let grounding = Grounding::new(&run.task).unwrap();
    let mut world = grounding.simulated();
    let mut sampler = Tracing {
        original: world,
        skeletons: vec![],
    };
    let mut planner = Planner {
        world: &mut world,
        sampler: &mut sampler,
        guide: &mut Unguided,
        config: Config::default(),
    };
    let task = grounding.task();
    let restart = || generator.clone();
    let answer = planner
        .plan(task, &run.task.initial, restart(), restart, room.lend())
        .unwrap();
    let (metrics, name) = (&answer.metrics, &run.name);
    let expected = [Outcome::SkeletonsSpent, Outcome::Solved][usize::from(run.solved)];
    assert_eq!(answer.outcome, expected, "{name}");
    let counts = [
        metrics.samples,
        metrics.skeletons,
        metrics.nodes_expanded,
        metrics.nodes_created,
    ];
    assert_eq!(counts, run.counts, "{name}");

    let word = |place: u16| digits(&task.operators[usize::from(place)], &run.task.initial);
    let plan: Vec<_> = answer
        .steps
        .iter()
        .map(|step| (word(step.operator), step.parameters.to_vec()))
        .collect();
    assert_eq!(plan, run.plan, "{name}");
    let actions: u32 = answer.steps.iter().map(|step| step.actions).sum();
    assert_eq!(actions, run.actions, "{name}");
    assert_eq!(metrics.plan_length as usize, run.plan.len(), "{name}");
    if let Some(last) = answer.steps.last() {
        assert_eq!(last.state, run.end, "{name}: to the last bit");
        assert!(run.task.is_solved(&ENVIRONMENT, &last.state), "{name}");
    }
    assert_eq!(sampler.skeletons.len() as u32, run.counts[1], "{name}");
    for ((places, samples), recorded) in sampler.skeletons.iter().zip(&run.skeletons) {
        let words: Vec<_> = places.iter().map(|place| word(*place)).collect();
        assert_eq!((&words, samples), (&recorded.0, &recorded.1), "{name}");
    }
    metrics.samples
}
