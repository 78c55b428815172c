//! What holds in states, what changes them, and which ones tasks begin in.

use super::{pick, place, tasks};
use critreg::env::shelf::{BOX, HAND_EMPTY, HOLDING, IN_SHELF, ON_TABLE, SHELF, Shelf, World};
use critreg::task::{Environment, PredicateId, State, Verdict};

#[test]
fn what_does_not_work_changes_nothing() {
    let task = &tasks(6, 1)[0];
    let yaw = World::of(&task.initial).unwrap().item[3];
    let across = pick(&task.initial, [0.6, yaw + 0.5]);
    assert_eq!(across.verdict, Verdict::AddEffectMissing);
    assert_eq!(across.state, task.initial);
    let empty = place(&task.initial, [0.1, 0.0]);
    assert_eq!(empty.verdict, Verdict::AddEffectMissing);
    assert_eq!(empty.state, task.initial);

    let held = pick(&task.initial, [0.6, yaw]).state;
    assert_eq!(pick(&held, [0.7, yaw]).state, held);
    assert_eq!(place(&held, [0.02, 0.0]).state, held, "beyond the edge");
}

#[test]
fn what_holds_before_between_and_after() {
    let mut task = tasks(7, 1).remove(0);
    task.initial.attributes_mut(SHELF).unwrap()[2] = 0.4;
    let holds = |state: &State| {
        let all = [HAND_EMPTY, HOLDING, IN_SHELF, ON_TABLE];
        all.map(|PredicateId(id)| {
            let predicate = &Shelf::PREDICATES[usize::from(id)];
            let of_type = |kind: &critreg::task::TypeId| state.of_type(*kind).next().unwrap();
            let objects: Vec<_> = predicate.arguments.iter().map(of_type).collect();
            (predicate.classifier)(&Shelf, state, &objects)
        })
    };
    let yaw = task.initial.attributes(BOX).unwrap()[3] + 0.1;
    let picked = pick(&task.initial, [0.5, yaw]);
    let placed = place(&picked.state, [0.1, 0.03125]);
    assert_eq!(holds(&task.initial), [true, false, false, true]);
    assert_eq!(holds(&picked.state), [false, true, false, false]);
    assert_eq!(holds(&placed.state), [true, false, true, false]);

    let [before, between, after] =
        [&task.initial, &picked.state, &placed.state].map(|state| World::of(state).unwrap());
    let [x, y, z, ..] = before.item;
    assert_eq!(between.robot, [x, y, z, yaw, 0.5]);
    assert_eq!(between.item[3], yaw, "turned between the fingers");
    let [x, y, z, ..] = after.item;
    assert_eq!(after.robot, [x, y, z, 0.0, 0.5]);
    assert_eq!(after.item[3..], [0.0, before.item[4], 0.0]);
    assert_eq!(after.shelf, before.shelf);
    let floor = [after.shelf[0], after.shelf[1], after.shelf[2]];
    assert_eq!(
        [x - floor[0], y - floor[1]].map(|d| (d * 1e6).round()),
        [1e5, 31_250.0]
    );
    assert!((z - 0.5 * before.item[4] - floor[2]).abs() < 1e-12);
}

#[test]
fn tasks_are_as_the_generator_says_and_always_the_same() {
    assert_eq!(tasks(8, 20), tasks(8, 20));
    let all: Vec<Vec<f64>> = tasks(8, 2000)
        .iter()
        .map(|task| task.initial.values().to_vec())
        .collect();
    // In the order of a state: robot, box, shelf.
    let fixed = |value| (value, value);
    let ranges = [
        [0.0, 0.0, 0.5, 0.0, 0.0].map(fixed).to_vec(),
        vec![
            (-0.25, 0.25),
            (-0.25, 0.25),
            (0.04, 0.08),
            (-0.35, 0.35),
            (0.08, 0.16),
            fixed(0.0),
        ],
        vec![(1.0, 1.2), (-0.2, 0.2), (0.43, 0.55), (0.3, 0.6)],
    ]
    .concat();
    for (place, (low, high)) in ranges.into_iter().enumerate() {
        let least = all.iter().map(|v| v[place]).fold(f64::INFINITY, f64::min);
        let most = all
            .iter()
            .map(|v| v[place])
            .fold(f64::NEG_INFINITY, f64::max);
        let tail = 0.01 * (high - low);
        assert!((low..=low + tail).contains(&least), "{place}: {least}");
        assert!((high - tail..=high).contains(&most), "{place}: {most}");
    }
    for values in &all {
        assert_eq!(values[7], 0.5 * values[9], "the box stands on the table");
    }
}
