//! Parameters reach a controller as they were drawn: doubles, within their ranges.

use critreg::Error;
use critreg::domain::{Attribute, Dimension};
use critreg::plan::{
    Conclusion, Config, Draw, Drawn, Planned, Planner, Sampler, Simulated, Unguided,
};
use critreg::random::generator;
use critreg::task::{
    Arguments, Controller, ControllerId, Environment, Failure, GroundAtom, LiftedAtom, Naming,
    ObjectId, ObjectType, Operator, Predicate, PredicateId, State, Task, Terminal, TypeId, always,
};
use critreg_tests::plan::{Grounding, Room};
use rand_core::Rng;
use std::cell::RefCell;
use std::f64::consts::PI;

const ROVER: TypeId = TypeId(0);
/// The only object, and the only atom over it.
const THE_ROVER: [ObjectId; 1] = [ObjectId(0)];
const ARRIVED: PredicateId = PredicateId(0);

/// A rover on a survey grid (UTM): its northing is a number of metres from the equator.
/// At that size single precision knows quarters of a metre.
struct Site;

const START: f64 = 3_948_000.0;
const MARK: f64 = 3_948_996.125;
const TOLERANCE: f64 = 0.1;

static ROVER_TYPE: [ObjectType; 1] = [ObjectType {
    name: "rover",
    attributes: &[Attribute::new("north", Dimension::Length)],
    naming: Naming::Single("rover"),
}];

const HAS_ARRIVED: LiftedAtom<'static> = LiftedAtom {
    predicate: ARRIVED,
    variables: &[0],
};

const fn operator(name: &'static str) -> Operator<'static> {
    Operator {
        name,
        parameters: &[ROVER],
        preconditions: &[],
        add_effects: &[HAS_ARRIVED],
        delete_effects: &[],
        controller: ControllerId(0),
        controller_arguments: &[0],
    }
}

fn north(state: &State) -> f64 {
    state.values()[0]
}

impl Environment for Site {
    type Action = f64;

    const TYPES: &'static [ObjectType] = &ROVER_TYPE;
    const PREDICATES: &'static [Predicate<Self>] = &[Predicate {
        name: "AtMark",
        arguments: &[ROVER],
        classifier: |_, state, _| (north(state) - MARK).abs() <= TOLERANCE,
    }];
    const CONTROLLERS: &'static [Controller<Self>] = &[Controller {
        name: "Drive",
        arguments: &[ROVER],
        parameters: &[[3_948_990.0, 3_949_000.0]],
        initiable: always,
        policy: |_, _, _, parameters| parameters[0],
        terminal: Terminal::FirstAction,
    }];
    const OPERATORS: &'static [Operator<'static>] = &[operator("Drive")];

    fn simulate(&self, state: &mut State, to: f64) -> Result<(), Failure> {
        state.values_mut()[0] = to;
        Ok(())
    }
}

/// A dial that is turned and pressed, and notes by how much; it never arrives.
#[derive(Default)]
struct Dial {
    got: RefCell<Vec<[f64; 2]>>,
}

impl Environment for Dial {
    type Action = ();

    const TYPES: &'static [ObjectType] = &ROVER_TYPE;
    const PREDICATES: &'static [Predicate<Self>] = &[Predicate {
        name: "Open",
        arguments: &[ROVER],
        classifier: |_, _, _| false,
    }];
    const CONTROLLERS: &'static [Controller<Self>] = &[Controller {
        name: "Turn",
        arguments: &[ROVER],
        parameters: &[[-PI, PI], [0.0, 0.1]],
        initiable: always,
        policy: |dial, _, _, parameters| {
            let parameters = parameters.try_into().unwrap();
            dial.got.borrow_mut().push(parameters);
        },
        terminal: Terminal::FirstAction,
    }];
    const OPERATORS: &'static [Operator<'static>] = &[operator("Turn")];

    fn simulate(&self, _: &mut State, (): ()) -> Result<(), Failure> {
        Ok(())
    }
}

/// The original sampler, but the corners of the parameter space come first.
struct CornersFirst<'a> {
    original: Simulated<'a, Dial>,
    drawn: Vec<[f64; 2]>,
}

impl Sampler<Simulated<'_, Dial>> for CornersFirst<'_> {
    fn sample<R: Rng>(&mut self, draw: &Draw<'_, State>, rng: &mut R) -> Result<Drawn, Error> {
        let corners = [[-PI, 0.0], [-PI, 0.1], [PI, 0.0], [PI, 0.1]];
        let drawn = match corners.get(self.drawn.len()) {
            Some(corner) => Drawn::Parameters(corner.iter().copied().collect()),
            None => self.original.sample(draw, rng)?,
        };
        if let Drawn::Parameters(parameters) = &drawn {
            self.drawn.push(parameters[..].try_into().unwrap());
        }
        Ok(drawn)
    }
}

/// A task with the rover somewhere, which shall arrive.
fn task() -> Task {
    let mut initial = State::new();
    initial.add(&ROVER_TYPE, ROVER, &[START]).unwrap();
    let arrived = GroundAtom {
        predicate: ARRIVED,
        objects: Arguments::new(THE_ROVER).unwrap(),
    };
    Task {
        initial,
        goal: [arrived].into_iter().collect(),
    }
}

fn plan<'m, E: Environment, S: Sampler<Simulated<'m, E>>>(
    grounding: &'m Grounding<'m, E>,
    initial: &State,
    sampler: &mut S,
    seed: u64,
    room: &'m mut Room,
) -> Planned<'m, State> {
    let mut planner = Planner {
        world: &mut grounding.simulated(),
        sampler,
        guide: &mut Unguided,
        config: Config {
            max_length: 1,
            max_tries: 1000,
            ..Config::default()
        },
    };
    let (lots, samples) = (generator(seed), || generator(seed));
    let planned = planner.plan(grounding.task(), initial, lots, samples, room.lend());
    planned.unwrap()
}

#[test]
fn a_goal_of_centimetres_is_reached_thousands_of_kilometres_from_the_origin() {
    let single = f64::from(MARK as f32);
    assert!((single - MARK).abs() > TOLERANCE, "too coarse");
    let task = task();
    let grounding = Grounding::new(&Site, &task).unwrap();
    let mut room = Room::new(100);
    for seed in 0..10 {
        let sampler = &mut grounding.simulated();
        let planned = plan(&grounding, &task.initial, sampler, seed, &mut room);
        assert_eq!(planned.conclusion, Conclusion::Solved, "seed {seed}");
        let [step] = planned.steps else {
            panic!("one step arrives")
        };
        assert_eq!(step.parameters, [north(&step.state)], "seed {seed}");
        assert!(task.is_solved(&Site, &step.state), "seed {seed}");
    }
}

#[test]
fn what_a_controller_gets_is_what_was_drawn_and_within_its_range() {
    let (task, dial) = (task(), Dial::default());
    let grounding = Grounding::new(&dial, &task).unwrap();
    let (original, mut room) = (grounding.simulated(), Room::new(100));
    let mut sampler = CornersFirst {
        original,
        drawn: vec![],
    };
    let planned = plan(&grounding, &task.initial, &mut sampler, 1, &mut room);
    assert_eq!(planned.metrics.samples, 1000);
    let got = dial.got.borrow();
    let bits =
        |all: &[[f64; 2]]| -> Vec<_> { all.as_flattened().iter().map(|x| x.to_bits()).collect() };
    assert_eq!(bits(&got), bits(&sampler.drawn));
    let ranges = Dial::CONTROLLERS[0].parameters;
    for parameters in got.iter() {
        let mut pairs = parameters.iter().zip(ranges);
        assert!(
            pairs.all(|(x, [low, high])| (low..=high).contains(&x)),
            "{parameters:?}"
        );
    }
}
