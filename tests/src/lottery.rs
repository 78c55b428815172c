//! An environment in which nothing can be learned: whether a lot wins is a matter of
//! chance.

use critreg::Error;
use critreg::domain::{Attribute, Dimension};
use critreg::random::uniform_in;
use critreg::skill::{Describe, Description};
use critreg::task::{
    Arguments, Controller, ControllerId, Environment, Failure, GroundAtom, LiftedAtom, Naming,
    ObjectId, ObjectType, Operator, Predicate, PredicateId, State, Task, Terminal, TypeId, always,
};
use rand_core::Rng;

/// A lot is drawn from an urn with a number, the seed. Whether it wins follows from a
/// hash of the seed and of where the lot and the urn are: always the same, and no rule.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lottery {
    /// The share of seeds that win.
    pub winning: f64,
}

const LOT: TypeId = TypeId(0);
const URN: TypeId = TypeId(1);
/// The lot of every task, and the urn behind it.
const THE_LOT: ObjectId = ObjectId(0);

/// `Won(lot)`.
const WON: PredicateId = PredicateId(0);
/// `Draw(lot, urn; seed)`.
const DRAW: ControllerId = ControllerId(0);

const fn length(name: &'static str) -> Attribute<'static> {
    Attribute::new(name, Dimension::Length)
}

static TYPES: [ObjectType; 2] = [
    ObjectType {
        name: "lot",
        attributes: &[
            length("x"),
            length("y"),
            Attribute::new("won", Dimension::Flag),
        ],
        naming: Naming::Numbered("lot"),
    },
    ObjectType {
        name: "urn",
        attributes: &[length("x"), length("y")],
        naming: Naming::Single("urn"),
    },
];

static PREDICATES: [Predicate<Lottery>; 1] = [Predicate {
    name: "Won",
    arguments: &[LOT],
    classifier: |_, state, lots| {
        let won = lots.first().and_then(|lot| state.get(*lot));
        won.is_some_and(|[_, _, won]| *won == 1.0)
    },
}];

static CONTROLLERS: [Controller<Lottery>; 1] = [Controller {
    name: "Draw",
    arguments: &[LOT, URN],
    parameters: &[[0.0, 1.0]],
    initiable: always,
    policy: |_, _, _, parameters| parameters[0],
    terminal: Terminal::FirstAction,
}];

static OPERATORS: [Operator<'static>; 1] = [Operator {
    name: "Draw",
    parameters: &[LOT, URN],
    preconditions: &[],
    add_effects: &[LiftedAtom {
        predicate: WON,
        variables: &[0],
    }],
    delete_effects: &[],
    controller: DRAW,
    controller_arguments: &[0, 1],
}];

/// A text with which much could be said, if there were anything to say.
static DESCRIPTIONS: [Description; 1] = [Description {
    controller: DRAW,
    later: None,
    members: &[],
    text: "
        object lot { x: length, y: length }
        object urn { x: length, y: length }
        parameter seed in [0, 1]: length
        point drawn     = world + (seed, 0)
        point lot.place = world + (lot.x, lot.y)
        point urn.place = world + (urn.x, urn.y)
    ",
}];

impl Lottery {
    /// A random task: the lot and the urn lie anywhere in the unit square, and the lot
    /// shall win.
    ///
    /// # Errors
    /// None: there is room for two objects and an atom.
    pub fn task(&self, rng: &mut impl Rng) -> Result<Task, Error> {
        let mut initial = State::new();
        let mut number = || uniform_in(rng, 0.0, 1.0);
        initial.add(&TYPES, LOT, &[number(), number(), 0.0])?;
        initial.add(&TYPES, URN, &[number(), number()])?;
        let won = GroundAtom {
            predicate: WON,
            objects: Arguments::new([THE_LOT])?,
        };
        Ok(Task {
            initial,
            goal: [won].into_iter().collect(),
        })
    }
}

impl Environment for Lottery {
    type Action = f64;

    const TYPES: &'static [ObjectType] = &TYPES;
    const PREDICATES: &'static [Predicate<Self>] = &PREDICATES;
    const CONTROLLERS: &'static [Controller<Self>] = &CONTROLLERS;
    const OPERATORS: &'static [Operator<'static>] = &OPERATORS;

    fn simulate(&self, state: &mut State, seed: f64) -> Result<(), Failure> {
        if chance(state, seed) < self.winning {
            let lot = state.attributes_mut(THE_LOT).ok_or(Failure::default())?;
            lot[2] = 1.0;
        }
        Ok(())
    }
}

impl Describe for Lottery {
    const DESCRIPTIONS: &'static [Description] = &DESCRIPTIONS;
}

/// A number in [0, 1) that depends on every bit, and on none in a way that can be told:
/// the mixing function of SplitMix64 (Steele, Lea and Flood 2014), number by number.
fn chance(state: &State, seed: f64) -> f64 {
    let mix = |hash: u64, number: f64| {
        let hash = (hash ^ number.to_bits()).wrapping_add(0x9E37_79B9_7F4A_7C15);
        let hash = (hash ^ hash >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let hash = (hash ^ hash >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        hash ^ hash >> 31
    };
    let numbers = state.values().iter().copied().chain([seed]);
    (numbers.fold(0, mix) >> 11) as f64 / (1u64 << 53) as f64
}
