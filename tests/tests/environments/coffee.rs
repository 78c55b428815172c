//! Coffee against recordings of the Predicators framework and closed forms, and what its
//! task generator promises.

use critreg::env::coffee::{
    CUP_RADIUS, CUP_TYPE, Coffee, GRASP_LIMIT, JUG_TYPE, MAX_CUPS, ROBOT_TYPE, TURN_LIMIT, World,
};
use critreg::geometry::distance;
use critreg::random::{generator, uniform_in};
use critreg::task::{Environment, State, Task};
use critreg_tests::golden::{COFFEE, Counts, replay_within};
use critreg_tests::trying::after;
use std::ops::RangeInclusive;

/// Sine and cosine may differ in their last digit from those of the recording.
const TOLERANCE: f64 = 1e-9;

#[test]
fn every_record() {
    let action = |numbers: &[f32]| numbers.try_into().unwrap();
    let counts = replay_within(&COFFEE, &Coffee, TOLERANCE, action);
    println!("{counts:?}");
    let expected = Counts {
        transitions: 986,
        failures: 0,
        abstractions: 75,
        atoms: 1613,
        feasibility: 10_229,
        chains: 3212,
        feasible: 12_171,
        tasks: 200,
    };
    assert_eq!(counts, expected);
}

#[test]
fn recorded_tasks_could_be_generated() {
    for recorded in COFFEE.tasks::<Coffee>() {
        let count = if recorded.split == "train" {
            1..=2
        } else {
            2..=3
        };
        check(&recorded.task, count);
    }
}

#[test]
fn generated_tasks_are_as_recorded_ones() {
    let counts = [1..=2, 2..=3, MAX_CUPS..=MAX_CUPS];
    for (seed, cups) in (0..300).zip(counts.iter().cycle()) {
        let draw = || Coffee.task(cups.clone(), &mut generator(seed)).unwrap();
        let task = draw();
        check(&task, cups.clone());
        assert_eq!(draw(), task, "the same seed gives the same task");
    }
    #[expect(clippy::reversed_empty_ranges)]
    for cups in [0..=1, 2..=1, 1..=MAX_CUPS + 1] {
        assert!(Coffee.task(cups, &mut generator(0)).is_err());
    }
}

/// The promises of the task generator.
fn check(task: &Task, counts: RangeInclusive<usize>) {
    let world = World::of(&task.initial).unwrap();
    assert!(counts.contains(&world.cups.len()));
    assert_eq!(world.robot, &[5.0, 5.0, 10.0, 0.0, 0.0, 0.4]);
    assert_eq!(world.machine, &[0.0]);
    let [x, y, theta, held, filled] = *world.jug;
    assert!((8.0..=9.0).contains(&x) && (2.4..=4.6).contains(&y));
    assert!(theta.abs() <= TURN_LIMIT);
    assert_eq!([held, filled], [0.0; 2]);
    for (place, [x, y, capacity, wanted, content]) in world.cups.iter().enumerate() {
        assert!((0.74..=6.76).contains(x) && (2.4..=4.6).contains(y));
        assert!((0.75..=1.5).contains(capacity));
        assert_eq!([*wanted, *content], [0.75 * capacity, 0.0]);
        let apart = |[a, b, ..]: &[f64; 5]| distance([*x, *y], [*a, *b]);
        let least = 2.0 * (CUP_RADIUS + 0.5) - 1e-12;
        assert!(world.cups[..place].iter().all(|cup| apart(cup) >= least));
    }
    assert_eq!(task.goal.len(), task.initial.of_type(CUP_TYPE).count());
    assert!(!task.is_solved(&Coffee, &task.initial));
}

/// The module's closed forms: a jug that is turned too far cannot be taken, and can after
/// a turn that leaves it within the limit.
#[test]
fn a_jug_is_taken_as_far_as_it_is_turned_aside() {
    let rng = &mut generator(7);
    let (mut taken, mut turned) = ([0; 2], [0; 2]);
    for _ in 0..300 {
        let start = Coffee.task(1..=2, rng).unwrap().initial;
        let theta = World::of(&start).unwrap().jug[2];
        let works = run("PickJugFromTable", &[], &start).is_some();
        assert_eq!(works, theta.abs() < GRASP_LIMIT, "{theta}");
        taken[usize::from(works)] += 1;

        let share = uniform_in(rng, -1.0, 1.0);
        let ready = run("MoveToTwistJug", &[], &start).unwrap();
        let Some(after) = run("TwistJug", &[share], &ready) else {
            let turn = share * TURN_LIMIT - theta;
            assert!(turn.abs() > 3.2, "the wrist ends only behind pi: {turn}");
            continue;
        };
        let left = World::of(&after).unwrap().jug[2] - share * TURN_LIMIT;
        assert!(left.abs() < 0.1, "{left}");
        let works = run("PickJugFromTable", &[], &after).is_some();
        if (share.abs() - 0.5).abs() > 0.1 / TURN_LIMIT {
            assert_eq!(works, share.abs() < 0.5, "{share} from {theta}");
        }
        turned[usize::from(works)] += 1;
    }
    assert!(taken.iter().chain(&turned).all(|count| *count > 50));
}

fn run(name: &str, parameters: &[f64], state: &State) -> Option<State> {
    after(&Coffee, name, parameters, state)
}

#[test]
fn what_the_preconditions_do_not_see() {
    let mut start = Coffee.task(1..=1, &mut generator(3)).unwrap().initial;
    let jug = start.of_type(JUG_TYPE).next().unwrap();
    start.attributes_mut(jug).unwrap()[2] = 0.0;
    let mut state = start;
    for name in [
        "PickJugFromTable",
        "PlaceJugInMachine",
        "TurnMachineOn",
        "PickJugFromMachine",
        "PourFromNowhere",
    ] {
        state = run(name, &[], &state).unwrap_or_else(|| panic!("{name}"));
    }
    assert!(run("PourFromNowhere", &[], &state).is_none(), "it is full");
    let back = "PlaceJugInMachine";
    assert!(run(back, &[], &state).is_none(), "the jug is tilted");
    let robot = state.of_type(ROBOT_TYPE).next().unwrap();
    state.attributes_mut(robot).unwrap()[3] = 0.0;
    assert!(run(back, &[], &state).is_some());
}

#[test]
fn tables_are_in_the_order_of_names() {
    let predicates = Coffee::PREDICATES.iter().map(|p| p.name);
    let operators = Coffee::OPERATORS.iter().map(|o| o.name);
    assert!(predicates.is_sorted() && operators.is_sorted());
}

#[test]
fn what_has_no_outcome_changes_nothing() {
    let before = Coffee.task(1..=1, &mut generator(0)).unwrap().initial;
    for place in 0..6 {
        let mut after = before.clone();
        let mut action = [0.5; 6];
        action[place] = f32::NAN;
        assert!(Coffee.simulate(&mut after, action).is_err());
        assert_eq!(after, before);
    }
    assert!(Coffee.simulate(&mut State::new(), [0.0; 6]).is_err());
}
