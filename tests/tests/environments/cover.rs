//! The cover environments against recordings of the Predicators framework, and what
//! their task generators and samplers promise.

use critreg::env::cover::{
    BLOCKS, BUMPY_REGION, Block, Cover, CoverRegrasp, RegionalBumpyCover, TARGETS, Target, blocks,
    targets,
};
use critreg::random::{Generator, generator};
use critreg::task::{
    Environment, Failure, ObjectId, Operator, OperatorId, Parameters, State, Task, Verdict,
    try_operator,
};
use critreg_tests::golden::{self, Counts, Recording, replay};

#[test]
fn cover_is_as_recorded() {
    let counts = replay(&golden::COVER, &Cover, |action| action[0]);
    let expected = Counts {
        transitions: 895,
        failures: 0,
        abstractions: 75,
        atoms: 825,
        feasibility: 7500,
        chains: 5740,
        feasible: 3027,
        tasks: 200,
    };
    assert_eq!(counts, expected);
}

#[test]
fn cover_regrasp_is_as_recorded() {
    let counts = replay(&golden::COVER_REGRASP, &CoverRegrasp, |action| action[0]);
    let expected = Counts {
        transitions: 778,
        failures: 0,
        abstractions: 75,
        atoms: 975,
        feasibility: 7500,
        chains: 3340,
        feasible: 3371,
        tasks: 200,
    };
    assert_eq!(counts, expected);
}

#[test]
fn regional_bumpy_cover_is_as_recorded() {
    let recording = &golden::REGIONAL_BUMPY_COVER;
    let counts = replay(recording, &RegionalBumpyCover, |action| action[0]);
    let expected = Counts {
        transitions: 820,
        failures: 0,
        abstractions: 75,
        atoms: 1275,
        feasibility: 7500,
        chains: 4940,
        feasible: 6456,
        tasks: 200,
    };
    assert_eq!(counts, expected);
}

#[test]
fn tables_are_in_the_order_of_names() {
    fn check<E: Environment>() {
        let predicates = E::PREDICATES.iter().map(|p| p.name);
        let operators = E::OPERATORS.iter().map(|o| o.name);
        let controllers = E::CONTROLLERS.iter().map(|c| c.name);
        assert!(predicates.is_sorted() && operators.is_sorted() && controllers.is_sorted());
        for operator in E::OPERATORS {
            let controller = &E::CONTROLLERS[usize::from(operator.controller.0)];
            assert_eq!(controller.name, operator.name);
            assert_eq!(controller.arguments, operator.parameters);
        }
    }
    check::<Cover>();
    check::<CoverRegrasp>();
    check::<RegionalBumpyCover>();
}

#[test]
fn what_is_no_click_or_no_state_of_the_environment() {
    let mut state = cover_tasks()[0].initial.clone();
    let before = state.clone();
    assert_eq!(Cover.simulate(&mut state, f32::NAN), Ok(()));
    assert_eq!(state, before);
    let [pick, _] = Cover::OPERATORS else {
        panic!()
    };
    let outcome = try_operator(&Cover, pick, &[BLOCKS[0]], &[], &state);
    assert_eq!(outcome.verdict, Verdict::AddEffectMissing);

    // Two blocks at one place.
    let values: [f64; 5] = *state.get(BLOCKS[0]).unwrap();
    state
        .attributes_mut(BLOCKS[1])
        .unwrap()
        .copy_from_slice(&values);
    let before = state.clone();
    let click = values[3] as f32;
    assert_eq!(Cover.simulate(&mut state, click), Err(Failure::default()));
    assert_eq!(state, before);
}

/// How many tasks are generated of each environment.
const SERIES: usize = 600;

/// A series of tasks, checked like the recorded ones.
fn series<E: Environment>(
    environment: &E,
    recording: &Recording,
    draw: impl Fn(usize, &mut Generator) -> Task,
    check: impl Fn(&State),
) -> Vec<Task> {
    let recorded = recording.tasks::<E>();
    for task in &recorded {
        check(&task.task.initial);
        assert_eq!(task.task.goal, recorded[task.index % 3].task.goal);
    }
    let generate = |index| {
        let task = draw(index, &mut generator(index as u64));
        assert_eq!(draw(index, &mut generator(index as u64)), task);
        check(&task.initial);
        assert_eq!(task.goal, recorded[index % 3].task.goal);
        assert!(!task.is_solved(environment, &task.initial));
        task
    };
    (0..SERIES).map(generate).collect()
}

fn cover_tasks() -> Vec<Task> {
    let draw = |index, rng: &mut _| Cover.task(index, rng).unwrap();
    series(&Cover, &golden::COVER, draw, check_far_apart)
}

fn cover_regrasp_tasks() -> Vec<Task> {
    let draw = |index, rng: &mut _| CoverRegrasp.task(index, rng).unwrap();
    series(&CoverRegrasp, &golden::COVER_REGRASP, draw, check_far_apart)
}

fn regional_bumpy_cover_tasks() -> Vec<Task> {
    let draw = |index, rng: &mut _| RegionalBumpyCover.task(index, rng).unwrap();
    let recording = &golden::REGIONAL_BUMPY_COVER;
    series(&RegionalBumpyCover, recording, draw, check_regions)
}

/// Widths and poses of the blocks, then of the targets, which are within the table.
fn objects(state: &State) -> Vec<(f64, f64)> {
    let blocks = blocks(state).map(|b| (b.width, b.pose));
    let objects: Vec<_> = blocks
        .chain(targets(state).map(|t| (t.width, t.pose)))
        .collect();
    let widths: Vec<_> = objects.iter().map(|(width, _)| *width).collect();
    assert_eq!(widths, [0.1, 0.07, 0.05, 0.03]);
    for (width, pose) in &objects {
        assert!((width / 2.0..=1.0 - width / 2.0).contains(pose));
    }
    objects
}

fn keep_apart((width_a, a): (f64, f64), (width_b, b): (f64, f64), factor: f64) -> bool {
    (a - b).abs() > (width_a + width_b) * factor
}

fn check_far_apart(state: &State) {
    let [block0, block1, target0, target1] = objects(state)[..] else {
        panic!()
    };
    assert!(keep_apart(block0, block1, 0.5) && keep_apart(target0, target1, 1.5));
    for target in [target0, target1] {
        assert!(keep_apart(target, block0, 1.5) && keep_apart(target, block1, 1.5));
    }
    let held: Vec<_> = blocks(state).filter(|block| block.is_held()).collect();
    let hand = state.values()[10];
    match held[..] {
        [] => assert_eq!(hand, 0.5),
        [block] => assert_eq!(hand, block.pose + block.grasp),
        _ => panic!("two blocks are held"),
    }
}

fn check_regions(state: &State) {
    let [block0, block1, target0, target1] = objects(state)[..] else {
        panic!()
    };
    assert!(keep_apart(block0, block1, 0.5) && keep_apart(target0, target1, 1.5));
    for target in [target0, target1] {
        assert!(keep_apart(target, block0, 0.5) && keep_apart(target, block1, 0.5));
        assert!(target.1 <= BUMPY_REGION - target.0);
    }
    let is_smooth = |(width, pose): (f64, f64)| pose <= BUMPY_REGION - width / 2.0;
    assert!(is_smooth(block1) && (is_smooth(block0) || block0.1 >= BUMPY_REGION));
    assert!(!blocks(state).any(|block| block.is_held()));
    let [.., bumpy0] = state.get::<6>(BLOCKS[0]).unwrap();
    let [.., bumpy1] = state.get::<6>(BLOCKS[1]).unwrap();
    assert_eq!((state.values()[12], *bumpy0, *bumpy1), (0.5, 1.0, 0.0));
}

/// Whether about this part of a series has a property.
fn is_about(part: f64, tasks: &[Task], property: impl Fn(&State) -> bool) -> bool {
    let count = tasks.iter().filter(|task| property(&task.initial)).count();
    (count as f64 / tasks.len() as f64 - part).abs() < 0.05
}

/// Whether a block is held at this part of half its width.
fn is_held_at(state: &State, block: ObjectId, part: f64) -> bool {
    let is_it = |b: &Block| b.object == block && b.is_held();
    let held = blocks(state).find(is_it);
    held.is_some_and(|b| (b.grasp - part * b.width / 2.0).abs() < 1e-12)
}

#[test]
fn generated_tasks_are_as_recorded_ones() {
    let (plain, regrasp) = (cover_tasks(), cover_regrasp_tasks());
    for block in BLOCKS {
        assert!(is_about(0.375, &plain, |s| is_held_at(s, block, 0.0)));
        for part in [-0.95, 0.0, 0.95] {
            assert!(is_about(0.125, &regrasp, |s| is_held_at(s, block, part)));
        }
    }
    let bumpy = regional_bumpy_cover_tasks();
    let is_rough = |state: &State| blocks(state).any(|block| block.pose > BUMPY_REGION);
    assert!(is_about(0.25, &bumpy, is_rough));
}

/// The parameters of an operator, and it.
fn sample<E: Environment>(
    environment: &E,
    name: &str,
    state: &State,
    objects: &[ObjectId],
    rng: &mut Generator,
) -> (&'static Operator<'static>, Parameters) {
    let operators = E::OPERATORS;
    let place = operators.iter().position(|o| o.name == name).unwrap();
    let id = OperatorId(place as u8);
    (
        &operators[place],
        environment.sample(id, state, objects, rng),
    )
}

#[test]
fn samples_of_cover() {
    let rng = &mut generator(1);
    let (mut picks, mut clicks) = (0, Vec::new());
    for task in cover_tasks() {
        let target = targets(&task.initial).last().unwrap();
        let objects = [BLOCKS[0], TARGETS[1]];
        let (_, place) = sample(&Cover, "Place", &task.initial, &objects, rng);
        clicks.push((place[0] - target.pose) / target.width);
        let mut free = blocks(&task.initial).filter(|_| task.initial.values()[10] == 0.5);
        if let Some(block) = free.next() {
            let (pick, click) = sample(&Cover, "Pick", &task.initial, &[block.object], rng);
            let outcome = try_operator(&Cover, pick, &[block.object], &click, &task.initial);
            assert!(outcome.is_feasible(), "the sampler is exact");
            picks += 1;
        }
    }
    assert!(picks > SERIES / 5);
    assert_fills(&clicks, [-0.1, 0.1]);
}

/// Whether numbers fill a range and nothing else, but for single precision.
fn assert_fills(numbers: &[f64], [low, high]: [f64; 2]) {
    let least = numbers.iter().copied().fold(f64::INFINITY, f64::min);
    let greatest = numbers.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let margin = (high - low) / 50.0;
    assert!(low - 1e-5 <= least && least < low + margin, "{least}");
    assert!(
        high - margin < greatest && greatest <= high + 1e-5,
        "{greatest}"
    );
}

#[test]
fn samples_of_cover_regrasp() {
    let rng = &mut generator(2);
    for task in cover_regrasp_tasks() {
        for block in blocks(&task.initial).filter(|block| block.is_held()) {
            let objects = &[block.object];
            let (_, click) = sample(&CoverRegrasp, "PlaceOnTable", &task.initial, objects, rng);
            assert_eq!(click[..], [f64::from((block.pose + block.grasp) as f32)]);
        }
    }
}

#[test]
fn samples_of_regional_bumpy_cover() {
    let (environment, rng) = (RegionalBumpyCover, &mut generator(3));
    let (mut offsets, mut poses) = (Vec::new(), Vec::new());
    for task in regional_bumpy_cover_tasks() {
        let block = blocks(&task.initial).next().unwrap();
        let is_rough = block.pose > BUMPY_REGION;
        let name = if is_rough {
            "PickFromBumpy"
        } else {
            "PickFromSmooth"
        };
        let (pick, click) = sample(&environment, name, &task.initial, &[block.object], rng);
        offsets.push(click[0] - block.pose);
        let outcome = try_operator(&environment, pick, &[block.object], &click, &task.initial);
        let is_middle = is_rough && offsets[offsets.len() - 1].abs() < block.width / 6.0;
        assert_eq!(outcome.is_feasible(), !is_middle);
        if is_middle {
            continue;
        }
        let (mut held, target) = (outcome.state, TARGETS[0]);
        let objects = [block.object, target];
        let (_, click) = sample(&environment, "PlaceOnTarget", &held, &objects, rng);
        let grasp = blocks(&held).next().unwrap().grasp;
        let centred = Target::read(&held, target).unwrap().pose + grasp;
        assert_eq!(click[..], [f64::from(centred.clamp(0.0, 1.0) as f32)]);
        // The other block leaves less of the bumpy region free.
        held.attributes_mut(BLOCKS[1]).unwrap()[3] = 0.79;
        let (_, click) = sample(&environment, "PlaceOnBumpy", &held, &[block.object], rng);
        poses.push(click[0]);
    }
    assert_fills(&offsets, [-0.05, 0.05]);
    assert_fills(&poses, [0.79 + (0.1 + 0.07) / 2.0, 0.95]);
}
