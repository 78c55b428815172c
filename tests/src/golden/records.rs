//! The records of a recording, as they are written.

use super::Recording;
use crate::data::{lines, next};
use critreg::task::{Arguments, Environment, GroundAtom, ObjectId, PredicateId, State, TypeId};
use std::str::{FromStr, SplitWhitespace};

/// One recorded step.
pub(super) struct Step {
    /// What happened.
    pub(super) what: &'static str,
    /// The place of the state before.
    pub(super) before: usize,
    pub(super) action: Vec<f32>,
    pub(super) outcome: StepOutcome,
}

pub(super) enum StepOutcome {
    /// The numbers that changed, with their places.
    Changed(Vec<(usize, f64)>),
    /// No outcome; and the object that is to blame, if it is one.
    Failed(Option<&'static str>),
}

/// A state with the truth of ground atoms.
pub(super) struct Abstraction {
    /// The place of the state.
    pub(super) state: usize,
    pub(super) atoms: Vec<(&'static str, bool)>,
}

/// An operator that was tried with several parameters.
pub(super) struct Trial {
    pub(super) start: Start,
    pub(super) operator: &'static str,
    pub(super) objects: Vec<&'static str>,
    /// The parameters and what came of them.
    pub(super) cases: Vec<(Vec<f64>, char)>,
}

/// The code of a step between others whose outcome was not recorded.
pub(super) const NOT_RECORDED: char = '-';

/// Where a trial starts.
#[derive(Clone, Copy)]
pub(super) enum Start {
    /// In the state at this place.
    State(usize),
    /// Where the trial before it in the chain ended, which is that many steps into
    /// it.
    After(usize),
}

impl Recording {
    /// The states that the records refer to.
    pub(super) fn states<E: Environment>(&self) -> Vec<State> {
        let mut states = States::default();
        lines(self.states)
            .map(|mut words| states.read::<E>(&mut words))
            .collect()
    }

    pub(super) fn transitions(&self) -> impl Iterator<Item = Step> {
        lines(self.transitions).map(|mut words| {
            let what = words.next().expect("what happened");
            let before = next(&mut words);
            let mut words = words.peekable();
            let number = |word: &&'static str| word.parse().ok();
            let action = std::iter::from_fn(|| {
                let number = words.peek().and_then(number)?;
                words.next();
                Some(number)
            });
            let action = action.collect();
            let outcome = match words.peek().map(|word| word.strip_prefix("fails")) {
                Some(Some(culprit)) => StepOutcome::Failed(culprit.strip_prefix(':')),
                _ => StepOutcome::Changed(words.map(change).collect()),
            };
            Step {
                what,
                before,
                action,
                outcome,
            }
        })
    }

    pub(super) fn abstractions(&self) -> impl Iterator<Item = Abstraction> {
        lines(self.atoms).map(|mut words| Abstraction {
            state: next(&mut words),
            atoms: words.map(truth).collect(),
        })
    }

    pub(super) fn feasibility(&self) -> Vec<Trial> {
        trials(self.feasibility)
    }

    pub(super) fn chains(&self) -> Vec<Trial> {
        trials(self.chains)
    }
}

fn change(word: &'static str) -> (usize, f64) {
    let (place, value) = word.split_once(':').expect("place:value");
    (place.parse().unwrap(), value.parse().unwrap())
}

fn truth(word: &'static str) -> (&'static str, bool) {
    match word.rsplit_once('=') {
        Some((atom, "1")) => (atom, true),
        Some((atom, "0")) => (atom, false),
        _ => panic!("bad truth of an atom: {word}"),
    }
}

fn trials(text: &'static str) -> Vec<Trial> {
    let mut previous = Vec::new();
    let trial = |mut words: SplitWhitespace<'static>| {
        let start = words.next().expect("a start");
        let operator = words.next().expect("an operator");
        let objects = words.next().expect("objects").split(',').collect();
        let codes = words.next().expect("codes");
        let words: Vec<_> = words.collect();
        let size = words.len() / codes.len();
        assert_eq!(words.len(), size * codes.len(), "parameters of {operator}");
        let cases = codes.chars().enumerate().map(|(case, code)| {
            let words = &words[case * size..][..size];
            previous = repeated(words, &previous);
            (previous.clone(), code)
        });
        Trial {
            start: if start.starts_with('>') {
                Start::After(start.len())
            } else {
                Start::State(start.parse().expect("a state"))
            },
            operator,
            objects,
            cases: cases.collect(),
        }
    };
    lines(text).map(trial).collect()
}

/// Numbers, where `=` repeats the one at this place of those before.
fn repeated<T: FromStr + Copy>(words: &[&'static str], previous: &[T]) -> Vec<T> {
    let number = |(place, word): (usize, &&'static str)| match *word {
        "=" => previous[place],
        word => next(&mut [word].into_iter()),
    };
    words.iter().enumerate().map(number).collect()
}

/// Reads states, of which each may repeat what the one before has.
#[derive(Default)]
pub(super) struct States {
    objects: &'static str,
    values: Vec<f64>,
}

impl States {
    /// Reads a state from the rest of a line.
    pub(super) fn read<E: Environment>(
        &mut self,
        words: &mut impl Iterator<Item = &'static str>,
    ) -> State {
        match words.next().expect("the objects of a state") {
            "=" => {}
            objects => self.objects = objects,
        }
        let words: Vec<_> = words.collect();
        self.values = repeated(&words, &self.values);
        let mut values = &*self.values;
        let types = E::TYPES;
        let mut state = State::new();
        for group in self.objects.split(',') {
            let (name, count) = group.split_once('*').expect("type*count");
            let place = types.iter().position(|t| t.name == name).unwrap();
            for _ in 0..count.parse().unwrap() {
                let (object, rest) = values.split_at(types[place].attributes.len());
                state.add(types, TypeId(place as u8), object).unwrap();
                values = rest;
            }
        }
        assert!(values.is_empty(), "too many numbers for the objects");
        state
    }
}

/// The object of this name.
pub(super) fn object<E: Environment>(state: &State, name: &str) -> ObjectId {
    let types = E::TYPES;
    let is_named = |object: &ObjectId| state.name(types, *object).unwrap().to_string() == name;
    let found = state.objects().map(|(object, _)| object).find(is_named);
    found.unwrap_or_else(|| panic!("no object {name}"))
}

/// The atom with this text, such as `On(block1,block0)`.
pub(super) fn ground_atom<E: Environment>(state: &State, text: &str) -> GroundAtom {
    let (name, objects) = text.strip_suffix(')').unwrap().split_once('(').unwrap();
    let mut predicates = E::PREDICATES.iter();
    let predicate = predicates.position(|p| p.name == name);
    let predicate = predicate.unwrap_or_else(|| panic!("no predicate {name}"));
    let names = objects.split(',').filter(|name| !name.is_empty());
    let objects = names.map(|name| object::<E>(state, name));
    GroundAtom {
        predicate: PredicateId(predicate as u8),
        objects: Arguments::new(objects).unwrap(),
    }
}
