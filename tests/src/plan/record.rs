//! The recorded runs of the planner.

use crate::data::{self, lines, next};
use critreg::env::stick_button::{BUTTON_TYPE, PRESSED};
use critreg::task::{Arguments, GroundAtom, State, Task};
use rand_pcg::Pcg64;
use std::collections::HashMap;

/// A run of the framework's planner with the original samplers, upright.
pub struct Run {
    /// The range the number of buttons was drawn from, the seed of the experiment,
    /// the place among its test tasks.
    pub name: String,
    /// The seed of the planner.
    pub planner_seed: u64,
    /// The task.
    pub task: Task,
    /// Whether a plan was found; else the skeletons were spent.
    pub solved: bool,
    /// Samples, skeletons, nodes expanded, nodes created.
    pub counts: [u32; 4],
    /// The first skeletons in the form of [`Run::plan`], each with its samples.
    pub skeletons: Vec<(Vec<String>, u32)>,
    /// Actions in the plan.
    pub actions: u32,
    /// For each step the digits of its operator and its buttons, and its parameters.
    pub plan: Vec<(String, Vec<f64>)>,
    /// The state after the plan.
    pub end: State,
}

/// All recorded runs.
pub fn runs() -> impl Iterator<Item = Run> {
    let tasks: HashMap<_, _> = data::tasks()
        .filter(|task| !task.angles && task.split == "test")
        .map(|task| ((task.buttons, task.seed, task.index), task.initial))
        .collect();
    lines(include_str!("../../data/plans.txt")).map(move |mut words| {
        let buttons = words.next().unwrap();
        let (least, most) = buttons.split_once('-').unwrap();
        let (seed, index) = (next(&mut words), next(&mut words));
        let key = ((least.parse().unwrap(), most.parse().unwrap()), seed, index);
        let initial = tasks[&key].clone();
        let solved = words.next() == Some("solved");
        let counts = std::array::from_fn(|_| next(&mut words));
        let skeletons = words.next().unwrap().split(',').map(skeleton).collect();
        let actions = words.next().map_or(0, |word| word.parse().unwrap());
        let plan = words
            .next()
            .map_or(vec![], |w| w.split(',').map(step).collect());
        let mut end = initial.clone();
        for change in words {
            let (place, value) = change.split_once(':').unwrap();
            end.values_mut()[place.parse::<usize>().unwrap()] = value.parse().unwrap();
        }
        Run {
            name: format!("{buttons} buttons, seed {seed}, task {index}"),
            planner_seed: seed + 1 + index,
            task: press_all(initial),
            solved,
            counts,
            skeletons,
            actions,
            plan,
            end,
        }
    })
}

/// Those with the tasks of the thesis's table (6.1).
pub fn runs_of_the_thesis() -> impl Iterator<Item = Run> {
    runs().filter(|run| run.name.starts_with("1-1 buttons, seed 0,"))
}

fn skeleton(word: &str) -> (Vec<String>, u32) {
    let (operators, samples) = word.split_once('=').unwrap();
    let operators = operators.split('.').map(str::to_string).collect();
    (operators, samples.parse().unwrap())
}

fn step(word: &str) -> (String, Vec<f64>) {
    let mut words = word.split(':');
    let operator = words.next().unwrap().to_string();
    (operator, words.map(|w| w.parse().unwrap()).collect())
}

/// The task to press all buttons.
pub fn press_all(initial: State) -> Task {
    let goal = initial.of_type(BUTTON_TYPE).map(|button| GroundAtom {
        predicate: PRESSED,
        objects: Arguments::new([button]).unwrap(),
    });
    Task {
        goal: goal.collect(),
        initial,
    }
}

/// The framework's generator for a seed, and the first numbers uniform in [0, 1)
/// that it gave.
pub struct Stream {
    /// The seed.
    pub seed: u64,
    /// The generator, before its first number.
    pub generator: Pcg64,
    /// Those numbers.
    pub uniforms: Vec<f64>,
}

/// The streams of all recorded seeds.
pub fn streams() -> impl Iterator<Item = Stream> {
    lines(include_str!("../../data/pcg64_seeds.txt")).map(|mut words| {
        let seed = next(&mut words);
        let mut hexadecimal = || u128::from_str_radix(words.next().unwrap(), 16).unwrap();
        let (state, stream) = (hexadecimal(), hexadecimal());
        Stream {
            seed,
            generator: Pcg64::new(state, stream),
            uniforms: words.map(|word| word.parse().unwrap()).collect(),
        }
    })
}
