//! The blocks against recordings of the Predicators framework, and what their task
//! generator promises.

use critreg::env::blocks::{
    Action, BLOCK_SIZE, BLOCK_TYPE, Block, Blocks, MAX_BLOCKS, ON, ON_TABLE, REACH_X, REACH_Y,
    SPACING, TABLE_HEIGHT, World,
};
use critreg::random::generator;
use critreg::task::{Environment, Failure, ObjectId, State, Task};
use critreg_tests::golden::{BLOCKS, Counts, replay};
use std::ops::RangeInclusive;

#[test]
fn every_record() {
    let action = |numbers: &[f32]| numbers.try_into().unwrap();
    let counts = replay(&BLOCKS, &Blocks, action);
    println!("{counts:?}");
    let expected = Counts {
        transitions: 952,
        failures: 0,
        abstractions: 75,
        atoms: 2737,
        feasibility: 6550,
        chains: 1375,
        feasible: 3193 + 503,
        tasks: 200,
    };
    assert_eq!(counts, expected);
}

#[test]
fn recorded_tasks_could_be_generated() {
    for recorded in BLOCKS.tasks::<Blocks>() {
        let count = if recorded.split == "train" {
            3..=4
        } else {
            5..=6
        };
        check(&recorded.task, count);
    }
}

#[test]
fn generated_tasks_are_as_recorded_ones() {
    let counts = [3..=4, 5..=6, 2..=2, 2..=5];
    for (seed, blocks) in (0..400).zip(counts.iter().cycle()) {
        let draw = || Blocks.task(blocks.clone(), &mut generator(seed)).unwrap();
        let task = draw();
        check(&task, blocks.clone());
        assert_eq!(draw(), task, "the same seed gives the same task");
    }
}

#[test]
fn piles_are_as_frequent_as_they_should_be() {
    let rng = &mut generator(0);
    let (mut initial, mut goal, mut three) = (0, 0, 0);
    for _ in 0..2000 {
        let task = Blocks.task(3..=4, rng).unwrap();
        let blocks = World::of(&task.initial).unwrap().blocks;
        if blocks.len() == 3 {
            three += 1;
            initial += blocks.iter().filter(|block| is_lowest(block)).count();
            goal += task
                .goal
                .iter()
                .filter(|atom| atom.predicate == ON_TABLE)
                .count();
        }
    }
    assert!((930..=1070).contains(&three), "{three}");
    // One pile, and two blocks more that each begin one with a probability of 1/5.
    let mean = initial as f64 / three as f64;
    assert!((1.35..=1.45).contains(&mean), "{mean}");
    // There are four ways to pile three blocks, with probabilities p of 16, 4, 4 and 1
    // in 25 and with n piles. The goal is another way than the initial one.
    let structures = [(16.0, 1.0), (4.0, 2.0), (4.0, 2.0), (1.0, 3.0)];
    let weigh = |f: fn(f64, f64) -> f64| -> f64 { structures.iter().map(|(p, n)| f(*p, *n)).sum() };
    let (all, piles) = (weigh(|p, _| p), weigh(|p, n| p * n));
    let others = structures
        .iter()
        .map(|(p, n)| p / all * (piles - p * n) / (all - p));
    let (expected, mean) = (others.sum::<f64>(), goal as f64 / three as f64);
    assert!(
        (mean - expected).abs() < 0.08,
        "{mean}, expected {expected}"
    );
}

#[test]
fn impossible_numbers_of_blocks_are_refused() {
    #[expect(clippy::reversed_empty_ranges)]
    for blocks in [0..=3, 1..=1, 4..=3, 2..=MAX_BLOCKS + 1] {
        assert!(Blocks.task(blocks, &mut generator(0)).is_err());
    }
}

#[test]
fn tables_are_in_the_order_of_names() {
    let predicates = Blocks::PREDICATES.iter().map(|p| p.name);
    let operators = Blocks::OPERATORS.iter().map(|o| o.name);
    assert!(predicates.is_sorted() && operators.is_sorted());
}

#[test]
fn what_has_no_outcome_changes_nothing() {
    const ROBOT: [f64; 4] = [1.35, 0.75, 0.7, 1.0];
    let block = [1.35, 0.6, 0.2225, 0.0, 0.1, 0.2, 0.3];
    let stack: Action = [1.35, 0.6, 0.3, 1.0];
    for (fingers, action) in [
        (1.0, [f32::NAN, 0.6, 0.2225, 0.0]),
        (0.0, [1.35, f32::INFINITY, 0.3, 1.0]),
        (0.5, stack),
        // Closed, with no block held.
        (0.0, stack),
    ] {
        let world = World {
            blocks: &[block],
            robot: &[ROBOT[0], ROBOT[1], ROBOT[2], fingers],
        };
        let before = world.to_state().unwrap();
        let mut after = before.clone();
        let nobody = Err(Failure { culprit: None });
        assert_eq!(Blocks.simulate(&mut after, action), nobody, "{action:?}");
        assert_eq!(after, before);
    }
    let mut empty = State::new();
    assert!(Blocks.simulate(&mut empty, stack).is_err());
}

fn is_lowest([_, _, z, ..]: &Block) -> bool {
    *z == TABLE_HEIGHT + BLOCK_SIZE * 0.5
}

/// The promises of the task generator.
fn check(task: &Task, counts: RangeInclusive<usize>) {
    let world = World::of(&task.initial).unwrap();
    assert!(counts.contains(&world.blocks.len()));
    assert_eq!(
        world.robot,
        &[1.35, 0.75, 0.7, 1.0].map(|n: f64| f64::from(n as f32))
    );
    let mut piles: Vec<[f64; 2]> = Vec::new();
    let mut level = 0.0;
    for [x, y, z, held, colour @ ..] in world.blocks {
        assert_eq!(*held, 0.0);
        assert!(colour.iter().all(|part| (0.0..1.0).contains(part)));
        if *z == TABLE_HEIGHT + BLOCK_SIZE * 0.5 {
            assert!((REACH_X[0]..=REACH_X[1]).contains(x));
            assert!((REACH_Y[0]..=REACH_Y[1]).contains(y));
            assert!(piles.iter().all(|[_, other]| (y - other).abs() > SPACING));
            piles.push([*x, *y]);
            level = 0.0;
        } else {
            level += 1.0;
            assert_eq!(Some(&[*x, *y]), piles.last());
            assert_eq!(*z, TABLE_HEIGHT + BLOCK_SIZE * (0.5 + level));
        }
    }
    check_goal(task);
    assert!(!task.is_solved(&Blocks, &task.initial));
}

/// Every block has its place: on the table, or on the block before.
fn check_goal(task: &Task) {
    let mut before = None;
    for block in task.initial.of_type(BLOCK_TYPE) {
        let places = task.goal.iter().filter(|atom| {
            let objects: &[ObjectId] = atom.objects.as_slice();
            let on_table = atom.predicate == ON_TABLE && objects == [block];
            let on = |lower| atom.predicate == ON && objects == [block, lower];
            on_table || before.is_some_and(on)
        });
        assert_eq!(places.count(), 1);
        before = Some(block);
    }
    assert_eq!(task.goal.len(), task.initial.of_type(BLOCK_TYPE).count());
}
