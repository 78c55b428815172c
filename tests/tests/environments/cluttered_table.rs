//! The cluttered tables against recordings of the Predicators framework, and what
//! their task generators and samplers promise.

use critreg::env::cluttered_table::{
    Action, CAN_RADIUS, CAN_TYPE, ClutteredTable, ClutteredTablePlace, FIRST_CAN, HOLDING,
    MAX_CANS, TRASH, cans,
};
use critreg::geometry::distance;
use critreg::random::generator;
use critreg::task::{
    Environment, Failure, GroundAtom, ObjectId, OperatorId, State, Task, Verdict, try_operator,
};
use critreg_tests::golden::{CLUTTERED_TABLE, CLUTTERED_TABLE_PLACE, Counts, replay};

const SECOND_CAN: ObjectId = ObjectId(1);

fn action(numbers: &[f32]) -> Action {
    numbers.try_into().unwrap()
}

#[test]
fn every_record_of_cluttered_table() {
    let counts = replay(&CLUTTERED_TABLE, &ClutteredTable, action);
    println!("{counts:?}");
    let expected = Counts {
        transitions: 720,
        failures: 173,
        abstractions: 75,
        atoms: 1235,
        feasibility: 5500,
        chains: 1000,
        feasible: 1217 + 271,
        tasks: 200,
    };
    assert_eq!(counts, expected);
}

#[test]
fn every_record_of_cluttered_table_place() {
    let counts = replay(&CLUTTERED_TABLE_PLACE, &ClutteredTablePlace, action);
    println!("{counts:?}");
    let expected = Counts {
        transitions: 895,
        failures: 364,
        abstractions: 75,
        atoms: 419,
        feasibility: 7700,
        chains: 1618,
        feasible: 4355 + 859,
        tasks: 200,
    };
    assert_eq!(counts, expected);
}

#[test]
fn recorded_tasks_could_be_generated() {
    for recorded in CLUTTERED_TABLE.tasks::<ClutteredTable>() {
        let count = if recorded.split == "train" { 5 } else { 10 };
        check_clutter(&recorded.task, count);
    }
    let generated = both_tasks();
    for recorded in CLUTTERED_TABLE_PLACE.tasks::<ClutteredTablePlace>() {
        assert!(generated.contains(&recorded.task));
    }
}

#[test]
fn generated_tasks_are_as_recorded_ones() {
    let (mut least, mut most) = (f64::MAX, f64::MIN);
    for (seed, count) in (0..400).zip((1..=MAX_CANS).cycle()) {
        let draw = || ClutteredTable.task(count, &mut generator(seed)).unwrap();
        let task = draw();
        check_clutter(&task, count);
        assert!(!task.is_solved(&ClutteredTable, &task.initial));
        assert_eq!(draw(), task, "the same seed gives the same task");
        for [x, y, ..] in cans(&task.initial).unwrap() {
            least = least.min(x.min(*y));
            most = most.max(x.max(*y));
        }
    }
    assert!(least < 0.26 && most > 0.74, "cans stand everywhere");
    assert!(ClutteredTable.task(0, &mut generator(0)).is_err());
    assert!(
        ClutteredTable
            .task(MAX_CANS + 1, &mut generator(0))
            .is_err()
    );

    let [right, left] = both_tasks();
    let draw = |seed| ClutteredTablePlace.task(&mut generator(seed)).unwrap();
    let rights = (0..1000).filter(|seed| {
        let task = draw(*seed);
        assert!(task == right || task == left);
        task == right
    });
    assert!((440..=560).contains(&rights.count()));
}

/// The promises of the task generator.
fn check_clutter(task: &Task, count: usize) {
    let cans = cans(&task.initial).unwrap();
    assert_eq!(cans.len(), count);
    for (i, [x, y, radius, grasped, trashed]) in cans.iter().enumerate() {
        assert_eq!([*radius, *grasped, *trashed], [CAN_RADIUS, 0.0, 0.0]);
        for number in [*x, *y] {
            assert!((0.25..=0.75).contains(&number));
            assert_eq!(number, f64::from(number as f32), "single precision");
        }
        let apart = |other: &[f64; 5]| distance([*x, *y], [other[0], other[1]]) > 0.02;
        assert!(cans[..i].iter().all(apart));
    }
    assert_eq!(task.goal, [hold_the_first()]);
}

fn hold_the_first() -> GroundAtom {
    GroundAtom {
        predicate: HOLDING,
        objects: critreg::task::Arguments::new([FIRST_CAN]).unwrap(),
    }
}

/// The tasks with the first can to the right and to the left.
fn both_tasks() -> [Task; 2] {
    [0.3, 0.1].map(|x| Task {
        initial: state(&[[x, 0.8, 0.01, 0.0, 0.0], [0.2, 0.6, 0.01, 0.0, 0.0]]),
        goal: [hold_the_first()].into_iter().collect(),
    })
}

fn state(cans: &[[f64; 5]]) -> State {
    let mut state = State::new();
    for can in cans {
        state.add(ClutteredTable::TYPES, CAN_TYPE, can).unwrap();
    }
    state
}

#[test]
fn tables_are_in_the_order_of_names() {
    fn check<E: Environment>() {
        let predicates = E::PREDICATES.iter().map(|p| p.name);
        let operators = E::OPERATORS.iter().map(|o| o.name);
        assert!(predicates.is_sorted() && operators.is_sorted());
    }
    check::<ClutteredTable>();
    check::<ClutteredTablePlace>();
}

#[test]
fn a_sampled_grasp_starts_anywhere_and_ends_at_the_can() {
    let [dump, grasp] = ClutteredTable::OPERATORS else {
        panic!()
    };
    assert_eq!([dump.name, grasp.name], ["Dump", "Grasp"]);
    let task = ClutteredTable.task(10, &mut generator(5)).unwrap();
    let rng = &mut generator(6);
    let mut sums = [0.0; 2];
    for can in (0..10).map(ObjectId).cycle().take(1000) {
        let parameters = ClutteredTable.sample(OperatorId(1), &task.initial, &[can], rng);
        let [x, y, end_x, end_y] = parameters[..] else {
            panic!()
        };
        assert!([x, y].iter().all(|start| (0.0..=1.0).contains(start)));
        let [can_x, can_y, ..] = *task.initial.get::<5>(can).unwrap();
        assert_eq!([end_x, end_y], [can_x, can_y]);
        sums = [sums[0] + x, sums[1] + y];
    }
    assert!(sums.iter().all(|sum| (450.0..=550.0).contains(sum)));
    let none = ClutteredTable.sample(OperatorId(0), &task.initial, &[FIRST_CAN], rng);
    assert!(none.is_empty());
}

/// In the recording every plan has these three steps with these parameters, after the
/// last one was tried in vain.
#[test]
fn sampled_parameters_solve_every_task_of_cluttered_table_place() {
    let environment = ClutteredTablePlace;
    let recorded: [[[f32; 4]; 3]; 2] = [
        [
            [0.2, 0.1, 0.2, 0.6],
            [0.2, 0.1, 0.1, 0.88],
            [0.2, 0.1, 0.3, 0.8],
        ],
        [
            [0.2, 0.1, 0.2, 0.6],
            [0.2, 0.1, 0.3, 0.88],
            [0.2, 0.1, 0.1, 0.8],
        ],
    ];
    let plan = [(0, SECOND_CAN), (1, SECOND_CAN), (0, FIRST_CAN)];
    for (task, recorded) in both_tasks().into_iter().zip(recorded) {
        let mut state = task.initial.clone();
        let step = |state: &State, operator: u8, can| {
            let sampled =
                environment.sample(OperatorId(operator), state, &[can], &mut generator(0));
            let operator = &ClutteredTablePlace::OPERATORS[usize::from(operator)];
            let outcome = try_operator(&environment, operator, &[can], &sampled, state);
            (sampled, outcome)
        };
        let culprit = Some(SECOND_CAN);
        let (_, in_vain) = step(&state, 0, FIRST_CAN);
        assert_eq!(in_vain.verdict, Verdict::Failed(Failure { culprit }));
        for ((operator, can), expected) in plan.into_iter().zip(recorded) {
            let (sampled, outcome) = step(&state, operator, can);
            assert_eq!(sampled, expected.map(f64::from));
            assert!(outcome.is_feasible());
            state = outcome.state;
        }
        assert!(task.is_solved(&environment, &state));
    }
}

#[test]
fn what_has_no_outcome_changes_nothing() {
    let free = [0.5, 0.5, 0.01, 0.0, 0.0];
    let held = [0.2, 0.2, 0.01, 1.0, 0.0];
    let held_in_the_trash = [TRASH, TRASH, 0.01, 1.0, 1.0];
    let grasp = [0.0, 0.0, 0.5, 0.5];
    let cases: [(&[[f64; 5]], Action); 5] = [
        (&[free], [0.0, 0.0, f32::NAN, 0.5]),
        (&[free], [f32::INFINITY, 0.0, 0.5, 0.5]),
        (&[held, held], grasp),
        (&[held_in_the_trash, free], grasp),
        (&[free, free], grasp),
    ];
    for (cans, action) in cases {
        let before = state(cans);
        let mut after = before.clone();
        let nobody = Err(Failure { culprit: None });
        assert_eq!(ClutteredTable.simulate(&mut after, action), nobody);
        assert_eq!(ClutteredTablePlace.simulate(&mut after, action), nobody);
        assert_eq!(after, before);
    }
}

#[test]
fn the_farthest_can_is_to_blame_then_the_first() {
    let can = |x: f64, y: f64| [x, y, 0.01, 0.0, 0.0];
    let approach = [0.5, 0.0, 0.5, 0.5];
    let target = can(0.5, 0.5);
    for (cans, culprit) in [
        ([can(0.5, 0.25), can(0.5, 0.125), target], 1),
        ([can(0.625, 0.25), can(0.375, 0.25), target], 0),
        ([can(0.5, 0.25), [TRASH, TRASH, 0.01, 0.0, 1.0], target], 0),
    ] {
        let mut state = state(&cans);
        let failure = ClutteredTable.simulate(&mut state, approach).unwrap_err();
        assert_eq!(failure.culprit, Some(ObjectId(culprit)));
    }
}

/// Approaches so close to a collision that the differences and the length of the
/// command decide by their single precision; in double precision each would turn out
/// the other way.
#[test]
fn single_precision_decides_at_the_boundary() {
    let cases: [(Action, [f64; 2], bool); 4] = [
        (
            [0.134, 0.847, 0.764, 0.255],
            [0.4641449426841932, 0.2456755402863564],
            false,
        ),
        (
            [0.025, 0.541, 0.939, 0.381],
            [0.6934669518884085, 0.20862392004230723],
            false,
        ),
        (
            [0.495, 0.449, 0.652, 0.789],
            [0.7556591050715412, 0.5074776985011042],
            true,
        ),
        (
            [0.762, 0.002, 0.445, 0.722],
            [0.7246266935232961, 0.6133312020526186],
            true,
        ),
    ];
    for (approach, [x, y], collides) in cases {
        let [_, _, end_x, end_y] = approach.map(f64::from);
        let mut state = state(&[[x, y, 0.01, 0.0, 0.0], [end_x, end_y, 0.01, 0.0, 0.0]]);
        let result = ClutteredTable.simulate(&mut state, approach);
        assert_eq!(result.is_err(), collides, "{approach:?}");
    }
}
