//! Pick and Place work where their closed forms say.

use super::{drawn, pick, place, tasks};
use critreg::env::shelf::{
    BOX_DEPTH, BOX_WIDTH, FINGER_LENGTH, HAND_LENGTH, HAND_THICKNESS, HAND_WIDTH, OPENING,
    SHELF_DEPTH, SHELF_TOP, SWIVEL, Shelf, World,
};
use critreg::random::generator;
use critreg::task::{State, Task, Trial};
use std::f64::consts::FRAC_PI_2;

/// How far inside of a feasible set parameters are, or outside if negative: the least of
/// the gaps of its inequalities.
fn least<const N: usize>(gaps: [f64; N]) -> f64 {
    gaps.into_iter().fold(f64::INFINITY, f64::min)
}

/// The gap of [`Shelf`]'s closed form for Pick.
fn pick_gap(world: &World, [pitch, yaw]: [f64; 2]) -> f64 {
    let [_, _, _, box_yaw, height, _] = world.item;
    let heel = 0.5 * height + FINGER_LENGTH * pitch.sin() - 0.5 * HAND_THICKNESS * pitch.cos();
    least([SWIVEL - (yaw - box_yaw).abs(), heel])
}

/// That for Place, with the pitch that the box is held with.
fn place_gap(world: &World, pitch: f64, [x, y]: [f64; 2]) -> f64 {
    let [.., height, _] = world.item;
    let [_, _, floor, width] = world.shelf;
    let half = 0.5 * HAND_THICKNESS;
    least([
        0.5 * width - 0.5 * HAND_WIDTH - y.abs(),
        x - 0.5 * BOX_DEPTH,
        SHELF_DEPTH - 0.5 * BOX_DEPTH - x,
        SHELF_TOP - (floor + 0.5 * height + HAND_LENGTH * pitch.sin() + half * pitch.cos()),
    ])
}

/// Compares the simulator with the gap of a closed form, unless that is a matter of
/// rounding; counts what works and what does not.
fn compare(outcome: &Trial, gap: f64, counts: &mut [u32; 2], what: &str) {
    if gap.abs() > 1e-9 {
        assert_eq!(outcome.is_feasible(), gap > 0.0, "{what}, gap {gap}");
        counts[usize::from(gap > 0.0)] += 1;
    }
}

#[test]
fn pick_works_where_its_closed_form_says() {
    let mut rng = generator(1);
    let mut counts = [0; 2];
    for task in tasks(1, 500) {
        let world = World::of(&task.initial).unwrap();
        for _ in 0..40 {
            let theta = drawn(0, &task.initial, &mut rng);
            let outcome = pick(&task.initial, theta);
            let what = format!("{world:?} {theta:?}");
            compare(&outcome, pick_gap(&world, theta), &mut counts, &what);
        }
    }
    let [fails, works] = counts;
    assert_eq!(fails + works, 20_000);
    assert!((3_000..6_000).contains(&works), "{counts:?}");
}

#[test]
fn the_swivel_is_where_the_box_fills_the_opening() {
    let extent = BOX_WIDTH * SWIVEL.cos() + BOX_DEPTH * SWIVEL.sin();
    assert!((extent - OPENING).abs() < 1e-15);
    assert!((SWIVEL - (7.0_f64 / 24.0).atan()).abs() < 1e-15);
}

/// States in which the box is held, each with the pitch.
fn holding(seed: u64, count: usize) -> Vec<(State, f64)> {
    let mut rng = generator(seed);
    let held = tasks(seed, count).into_iter().map(|task| {
        loop {
            let theta = drawn(0, &task.initial, &mut rng);
            let outcome = pick(&task.initial, theta);
            if outcome.is_feasible() {
                return (outcome.state, theta[0]);
            }
        }
    });
    held.collect()
}

#[test]
fn place_works_where_its_closed_form_says() {
    let mut rng = generator(2);
    let (mut counts, mut too_steep) = ([0; 2], 0);
    for (state, pitch) in holding(2, 1000) {
        let world = World::of(&state).unwrap();
        too_steep += u32::from(place_gap(&world, pitch, [0.1, 0.0]) < 0.0);
        for _ in 0..20 {
            let theta = drawn(1, &state, &mut rng);
            let what = format!("{world:?} {theta:?}");
            let gap = place_gap(&world, pitch, theta);
            compare(&place(&state, theta), gap, &mut counts, &what);
        }
    }
    let [fails, works] = counts;
    assert_eq!(fails + works, 20_000);
    assert!((2_000..8_000).contains(&works), "{counts:?}");
    assert!((200..800).contains(&too_steep), "{too_steep}");
}

#[test]
fn every_inequality_decides_somewhere() {
    // Places next to each boundary, found by moving along one number of a state that is
    // feasible in every other respect.
    let (state, _) = &holding(3, 1)[0];
    let mut world = World::of(state).unwrap();
    let (height, half) = (0.1, 0.5 * HAND_THICKNESS);
    world.item[4] = height;
    let near = 1e-6;
    let try_at = |pitch: f64, clearance: f64, theta: [f64; 2]| {
        let mut world = world;
        world.robot[4] = pitch;
        (world.shelf[2], world.shelf[3]) = (SHELF_TOP - clearance, 0.4);
        place(&world.to_state().unwrap(), theta).is_feasible()
    };
    let side = 0.2 - 0.5 * HAND_WIDTH;
    let pitch: f64 = 1.0;
    let top = 0.5 * height + HAND_LENGTH * pitch.sin() + half * pitch.cos();
    for (inside, by) in [(true, near), (false, -near)] {
        assert_eq!(try_at(0.5, 1.0, [0.1, side - by]), inside, "left wall");
        assert_eq!(try_at(0.5, 1.0, [0.1, by - side]), inside, "right wall");
        assert_eq!(try_at(0.5, 1.0, [0.04 + by, 0.0]), inside, "front edge");
        assert_eq!(try_at(0.5, 1.0, [0.26 - by, 0.0]), inside, "rear edge");
        assert_eq!(try_at(pitch, top + by, [0.1, 0.0]), inside, "board above");
    }
}

#[test]
fn boxes_taller_than_those_of_tasks_collide_themselves() {
    let mut world = World::of(&tasks(3, 1)[0].initial).unwrap();
    let (height, yaw) = (0.3, world.item[3]);
    (world.item[2], world.item[4]) = (0.5 * height, height);
    let try_with = |clearance: f64, pitch: f64| {
        let mut world = world;
        world.shelf[2] = SHELF_TOP - clearance;
        let picked = pick(&world.to_state().unwrap(), [pitch, yaw]);
        let placed = place(&picked.state, [0.15, 0.0]);
        [picked.is_feasible(), placed.is_feasible()]
    };
    assert_eq!(try_with(0.6, 1.5), [false, false], "the hand in the box");
    assert_eq!(try_with(0.31, 0.1), [true, true]);
    assert_eq!(
        try_with(0.29, 0.1),
        [true, false],
        "the box in the board above"
    );
}

/// The pitches between which Pick then Place works at the best place, in steps.
fn pitches(world: &World) -> Vec<f64> {
    let yaw = world.item[3];
    let steps = (0..=1000).map(|i| FRAC_PI_2 * f64::from(i) / 1000.0);
    let works = steps.filter(|pitch| {
        let gap = pick_gap(world, [*pitch, yaw]);
        gap.min(place_gap(world, *pitch, [0.1, 0.0])) > 1e-6
    });
    works.collect()
}

#[test]
fn every_task_has_a_plan_of_two_steps_whose_pitches_depend_on_the_task() {
    let (mut shallow_only, mut any_steep, mut least_share) = (0, 0, 1.0_f64);
    for task in tasks(4, 500) {
        let world = World::of(&task.initial).unwrap();
        assert!(!task.is_solved(&Shelf, &task.initial));
        let pitches = pitches(&world);
        least_share = least_share.min(pitches.len() as f64 / 1001.0);
        let steepest = *pitches.last().expect("some pitch works");
        for pitch in [pitches[0], pitches[pitches.len() / 2], steepest] {
            let picked = pick(&task.initial, [pitch, world.item[3]]);
            let placed = place(&picked.state, [0.1, 0.0]);
            assert!(picked.is_feasible() && placed.is_feasible(), "{world:?}");
            assert!(task.is_solved(&Shelf, &placed.state));
        }
        shallow_only += u32::from(steepest < 1.0);
        any_steep += u32::from(steepest > 1.55);
    }
    assert!(
        shallow_only > 250 && any_steep > 50,
        "{shallow_only} {any_steep}"
    );
    assert!((0.05..0.2).contains(&least_share), "{least_share}");
}

#[test]
fn top_down_grasps_collide_below_a_low_board() {
    let mut rng = generator(5);
    for task in tasks(5, 100) {
        let mut world = World::of(&task.initial).unwrap();
        let yaw = world.item[3];
        let mut solved = |clearance: f64| {
            world.shelf[2] = SHELF_TOP - clearance;
            let picked = pick(&world.to_state().unwrap(), [1.5, yaw]);
            assert!(picked.is_feasible(), "a steep grasp is fine for picking");
            let placed = (0..200).map(|_| place(&picked.state, drawn(1, &picked.state, &mut rng)));
            placed.filter(Trial::is_feasible).count()
        };
        let low = half_height(&task) + HAND_LENGTH * 1.5_f64.sin();
        assert_eq!(solved(low), 0);
        assert!(solved(low + 0.5 * HAND_THICKNESS) > 0);
    }
}

/// Half the height of the task's box.
fn half_height(task: &Task) -> f64 {
    0.5 * World::of(&task.initial).unwrap().item[4]
}
