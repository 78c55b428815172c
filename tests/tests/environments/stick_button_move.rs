//! The stick-button environment with motions of their own against recordings of the
//! Predicators framework and closed forms, and what its task generator promises.

use critreg::env::stick_button::{UPRIGHT, ZONE_HEIGHT};
use critreg::env::stick_button_move::{BUTTON_TYPE, StickButtonMove, World};
use critreg::geometry::{Circle, Intersects, Rectangle, distance};
use critreg::random::{generator, uniform};
use critreg::task::{Environment, ObjectId, State, Task};
use critreg_tests::golden::{Counts, STICK_BUTTON_MOVE, replay_within};
use critreg_tests::trying::after;
use std::ops::RangeInclusive;

/// Sine and cosine may differ in their last digit from those of the recording.
const TOLERANCE: f64 = 1e-9;

#[test]
fn every_record() {
    let action = |numbers: &[f32]| numbers.try_into().unwrap();
    let counts = replay_within(&STICK_BUTTON_MOVE, &StickButtonMove, TOLERANCE, action);
    println!("{counts:?}");
    let expected = Counts {
        transitions: 931,
        failures: 0,
        abstractions: 75,
        atoms: 846,
        feasibility: 17_490,
        chains: 3106,
        feasible: 10_308,
        tasks: 200,
    };
    assert_eq!(counts, expected);
}

#[test]
fn recorded_tasks_could_be_generated() {
    for recorded in STICK_BUTTON_MOVE.tasks::<StickButtonMove>() {
        let count = if recorded.split == "train" {
            1..=2
        } else {
            3..=4
        };
        check(&recorded.task, count);
    }
}

#[test]
fn generated_tasks_are_as_recorded_ones() {
    for (seed, buttons) in (0..300).zip([1..=1, 1..=2, 3..=4].iter().cycle()) {
        let draw = || StickButtonMove.task(buttons.clone(), &mut generator(seed));
        let task = draw().unwrap();
        check(&task, buttons.clone());
        assert_eq!(draw().unwrap(), task, "the same seed gives the same task");
    }
    assert!(StickButtonMove.task(0..=1, &mut generator(0)).is_err());
}

/// The promises of the task generator.
fn check(task: &Task, counts: RangeInclusive<usize>) {
    let within = |value: f64, low, high| assert!((low..=high).contains(&value), "{value}");
    let world = World::of(&task.initial).unwrap();
    assert!(counts.contains(&world.buttons.len()));
    let [x, y, theta, fingers] = *world.robot;
    within(x, 0.6, 5.4);
    within(y, 0.6, 2.4);
    assert_eq!([theta, fingers], [UPRIGHT, 1.0]);
    let mut spaced = vec![[x, y]];
    for [x, y, pressed] in world.buttons {
        within(*x, 0.6, 5.4);
        within(*y, 0.6, 5.4);
        assert!((y - ZONE_HEIGHT).abs() > 0.6 && *pressed == 0.0);
        spaced.push([*x, *y]);
    }
    let [x, y, tip_x, tip_y, theta, held] = *world.stick;
    within(x, 0.6, 5.4);
    within(y, 0.6, 1.6);
    assert!((tip_x - x).abs() < 1e-9 && (tip_y - y - 2.95).abs() < 1e-9);
    assert_eq!([theta, held], [UPRIGHT, 0.0]);
    let stick = Rectangle::new([x, y], [3.0, 0.05], theta);
    for (place, centre) in spaced.iter().enumerate() {
        let others = &spaced[..place];
        let (centre, radius) = (*centre, 0.6);
        assert!(
            others
                .iter()
                .all(|other| distance(centre, *other) >= 1.2 - 1e-12)
        );
        assert!(!stick.intersects(&Circle { centre, radius }));
    }
    let [holder_x, holder_y, _] = *world.holder;
    assert!((holder_x - x - 0.0375).abs() < 1e-12);
    within(holder_y - y, -0.3 - 1e-12, 1.5 + 1e-12);
    assert_eq!(task.goal.len(), world.buttons.len());
    assert!(!task.is_solved(&StickButtonMove, &task.initial));
}

/// The module's closed forms of the pick and of what comes after it. What lies so near to
/// a boundary that a step decides is left out.
#[test]
fn a_grasp_decides_what_the_tip_can_press() {
    let rng = &mut generator(11);
    let (mut picks, mut presses) = ([0; 2], [0; 2]);
    for _ in 0..1500 {
        let start = StickButtonMove.task(1..=1, rng).unwrap().initial;
        let world = World::of(&start).unwrap();
        let mu = uniform(rng);
        let ([_, y, ..], [_, holder, _]) = (*world.stick, *world.holder);
        let grasp = y + 3.0 * mu;
        let room = (holder - 0.1 - grasp).max(grasp - holder - 0.4);
        if (grasp - 2.9).abs() < 0.04 || room.abs() < 0.04 {
            continue;
        }
        let picked = run("PickStickFromNothing", &[mu], &start);
        assert_eq!(picked.is_some(), grasp < 2.9 && room > 0.0, "{mu}");
        picks[usize::from(picked.is_some())] += 1;

        let (Some(picked), [[_, button, _]]) = (picked, world.buttons) else {
            continue;
        };
        // Where the hand is when the tip is at the button.
        let hand = button + 3.0 * mu - 2.95;
        if *button < ZONE_HEIGHT || (hand - 2.9).abs() < 0.15 {
            continue;
        }
        let moved = run("StickMoveToButtonFromNothing", &[], &picked);
        let pressed = moved.and_then(|moved| run("StickPressButton", &[], &moved));
        assert_eq!(pressed.is_some(), hand < 2.9, "{mu}");
        presses[usize::from(pressed.is_some())] += 1;
    }
    let enough = picks.iter().chain(&presses).all(|count| *count > 20);
    assert!(enough, "{picks:?}, {presses:?}");
}

fn run(name: &str, parameters: &[f64], state: &State) -> Option<State> {
    after(&StickButtonMove, name, parameters, state)
}

/// The oddity of the framework: the hand presses what a stick at its place would touch.
#[test]
fn a_hand_beside_or_above_a_button_does_not_press_it() {
    let mut start = StickButtonMove
        .task(1..=1, &mut generator(1))
        .unwrap()
        .initial;
    let button = start.of_type(BUTTON_TYPE).next().unwrap();
    start.attributes_mut(button).unwrap()[..2].copy_from_slice(&[2.0, 1.0]);
    for (from, presses) in [
        ([2.0, 1.0], true),
        ([2.0, 0.85], true),
        ([2.0, 1.15], false),
        ([1.85, 1.0], false),
        ([2.12, 1.0], true),
        ([2.18, 1.0], false),
    ] {
        let mut state = start.clone();
        let robot = state.objects().count() - 2;
        let robot = state.attributes_mut(ObjectId(robot as u8)).unwrap();
        robot[..2].copy_from_slice(&from);
        let pressed = run("RobotPressButton", &[], &state).is_some();
        assert_eq!(pressed, presses, "{from:?}");
    }
}

#[test]
fn tables_are_in_the_order_of_names() {
    let predicates = StickButtonMove::PREDICATES.iter().map(|p| p.name);
    let operators = StickButtonMove::OPERATORS.iter().map(|o| o.name);
    assert!(predicates.is_sorted() && operators.is_sorted());
}
