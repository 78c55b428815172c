//! The recorded data under `tests/data`; its README describes the columns.
//!
//! The readers panic on damaged data: they serve tests only.

use critreg::env::stick_button::World;
use critreg::geometry::{Circle, Rectangle};
use critreg::task::State;
use std::str::{FromStr, SplitWhitespace};

/// One recorded step.
pub struct Transition {
    /// Whether angles were on.
    pub angles: bool,
    /// What happened.
    pub kind: &'static str,
    /// The state before.
    pub before: State,
    /// The action.
    pub action: [f32; 4],
    /// The state afterwards.
    pub after: State,
}

/// All recorded steps.
pub fn transitions() -> impl Iterator<Item = Transition> {
    let upright = include_str!("../data/transitions_upright.txt");
    let turning = include_str!("../data/transitions_angles.txt");
    let mut previous = Vec::new();
    let lines = upright.lines().map(|line| (false, line));
    lines
        .chain(turning.lines().map(|line| (true, line)))
        .map(move |(angles, line)| {
            let mut words = line.split_whitespace();
            let kind = words.next().unwrap();
            let values = state_values(&mut words, &previous);
            let action = std::array::from_fn(|_| next(&mut words));
            let mut after = values.clone();
            for change in words {
                let (place, value) = change.split_once(':').unwrap();
                after[place.parse::<usize>().unwrap()] = value.parse().unwrap();
            }
            let transition = Transition {
                angles,
                kind,
                before: to_state(&values),
                action,
                after: to_state(&after),
            };
            previous = values;
            transition
        })
}

/// A state with the truth of all ground atoms.
pub struct Abstraction {
    /// Whether angles were on.
    pub angles: bool,
    /// The state.
    pub state: State,
    /// Each atom, such as `Pressed(button0)`, and whether it holds.
    pub atoms: Vec<(&'static str, bool)>,
}

/// All recorded states with their atoms.
pub fn abstractions() -> impl Iterator<Item = Abstraction> {
    lines(include_str!("../data/predicates.txt")).map(|mut words| Abstraction {
        angles: angles(&mut words),
        state: state(&mut words),
        atoms: words
            .map(|word| word.rsplit_once('=').unwrap())
            .map(|(atom, truth)| (atom, truth == "1"))
            .collect(),
    })
}

/// A shape of a recorded pair.
pub enum Shape {
    /// A circle.
    Circle(Circle<f64>),
    /// A rectangle.
    Rectangle(Rectangle<f64>),
}

/// All recorded pairs of shapes: how each was made, the shapes, and whether they
/// meet.
pub fn shape_pairs() -> impl Iterator<Item = (&'static str, [Shape; 2], bool)> {
    lines(include_str!("../data/geometry.txt")).map(|mut words| {
        let tag = words.next().unwrap();
        let meet = words.next() == Some("1");
        let shapes = std::array::from_fn(|_| {
            let kind = words.next().unwrap();
            let mut number = || next(&mut words);
            let corner = [number(), number()];
            match kind {
                "circle" => Shape::Circle(Circle {
                    centre: corner,
                    radius: number(),
                }),
                "rect" => {
                    let size = [number(), number()];
                    Shape::Rectangle(Rectangle::new(corner, size, number()))
                }
                _ => panic!("unknown shape {kind}"),
            }
        });
        (tag, shapes, meet)
    })
}

/// How each grasp of one task went.
pub struct PickFeasibility {
    /// Whether angles were on.
    pub angles: bool,
    /// The initial state.
    pub initial: State,
    /// Whether the pick succeeds, for `mu = i / 200`.
    pub pick: Vec<bool>,
    /// The number of its actions, zero if it was stuck.
    pub pick_actions: Vec<u32>,
    /// For each button: whether it can be pressed with the stick after the pick;
    /// `None` where the pick failed.
    pub press: Vec<Vec<Option<bool>>>,
}

/// The recorded grasps of all tasks.
pub fn pick_feasibility() -> impl Iterator<Item = PickFeasibility> {
    lines(include_str!("../data/pick_feasibility.txt")).map(|mut words| {
        let angles = angles(&mut words);
        let mut words = words.skip(3);
        let words = words.by_ref();
        let initial = to_state(&state_values(words, &[]));
        let run = |word| unroll(word).collect::<Vec<_>>();
        PickFeasibility {
            angles,
            initial,
            pick: run(words.next().unwrap())
                .iter()
                .map(|w| *w == "1")
                .collect(),
            pick_actions: run(words.next().unwrap())
                .iter()
                .map(|w| w.parse().unwrap())
                .collect(),
            press: words
                .map(|word| {
                    unroll(word)
                        .map(|w| (w != "-").then_some(w == "1"))
                        .collect()
                })
                .collect(),
        }
    })
}

/// A recorded task; its goal is to press all buttons.
pub struct RecordedTask {
    /// The range its number of buttons was drawn from.
    pub buttons: (usize, usize),
    /// Whether angles were on.
    pub angles: bool,
    /// The seed of the experiment.
    pub seed: u64,
    /// `train` or `test`.
    pub split: &'static str,
    /// Its place among the tasks of the seed.
    pub index: u64,
    /// The initial state.
    pub initial: State,
}

/// All recorded tasks.
pub fn tasks() -> impl Iterator<Item = RecordedTask> {
    lines(include_str!("../data/tasks.txt")).map(|mut words| {
        let (least, most) = words.next().unwrap().split_once('-').unwrap();
        RecordedTask {
            buttons: (least.parse().unwrap(), most.parse().unwrap()),
            angles: angles(&mut words),
            seed: next(&mut words),
            split: words.next().unwrap(),
            index: next(&mut words),
            initial: state(&mut words),
        }
    })
}

pub(crate) fn lines(text: &'static str) -> impl Iterator<Item = SplitWhitespace<'static>> {
    text.lines().map(str::split_whitespace)
}

pub(crate) fn next<T: FromStr>(words: &mut impl Iterator<Item = &'static str>) -> T {
    let word = words.next().expect("a line is too short");
    word.parse()
        .ok()
        .unwrap_or_else(|| panic!("bad word {word}"))
}

fn angles(words: &mut impl Iterator<Item = &'static str>) -> bool {
    match words.next() {
        Some("angles") => true,
        Some("upright") => false,
        other => panic!("bad angles {other:?}"),
    }
}

fn unroll(run: &'static str) -> impl Iterator<Item = &'static str> {
    run.split(',').flat_map(|part| {
        let (count, word) = part.split_once('*').unwrap();
        std::iter::repeat_n(word, count.parse().unwrap())
    })
}

fn state(words: &mut impl Iterator<Item = &'static str>) -> State {
    to_state(&state_values(words, &[]))
}

fn state_values(words: &mut impl Iterator<Item = &'static str>, previous: &[f64]) -> Vec<f64> {
    let buttons: usize = next(words);
    (0..10 + 3 * buttons)
        .map(|place| match words.next().expect("a state is too short") {
            "=" => previous[place],
            word => word.parse().unwrap(),
        })
        .collect()
}

/// The state with these numbers, in the order of the environment's objects.
pub fn to_state(values: &[f64]) -> State {
    let (robot, rest) = values.split_first_chunk().unwrap();
    let (stick, rest) = rest.split_first_chunk().unwrap();
    let (holder, rest) = rest.split_first_chunk().unwrap();
    let world = World {
        robot,
        stick,
        holder,
        buttons: rest.as_chunks().0,
    };
    world.to_state().unwrap()
}
