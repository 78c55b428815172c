//! The stick-button environment against recordings of the Predicators framework.

use critreg::env::stick_button::{
    BUTTON_TYPE, HOLDER_WIDTH, MAX_BUTTONS, PRESSED, ROBOT, STICK, STICK_PRESS_BUTTON, STICK_WIDTH,
    StickButton, UPRIGHT, World, ZONE_HEIGHT,
};
use critreg::geometry::{Circle, Frame2, Intersects, Rectangle, distance};
use critreg::random::generator;
use critreg::task::{
    Atoms, Ending, Environment, GroundAtom, GroundOperator, ObjectId, Operator, State,
    ground_operators, rollout, try_operator,
};
use critreg_tests::data::{self, Shape};

/// The largest difference of two floats that still counts as the same: sine and
/// cosine may differ in their last digit from those of the recording.
const TOLERANCE: f64 = 4e-15;

#[test]
fn every_transition() {
    let (mut count, mut exact, mut largest) = (0, 0, 0.0_f64);
    for t in data::transitions() {
        let mut state = t.before.clone();
        let environment = StickButton { angles: t.angles };
        environment.simulate(&mut state, t.action).unwrap();
        let (ours, theirs) = (World::of(&state).unwrap(), World::of(&t.after).unwrap());
        let what = || format!("step {count}, {}, angles {}", t.kind, t.angles);
        assert_eq!(ours.stick[3], theirs.stick[3], "held: {}", what());
        assert_eq!(ours.buttons, theirs.buttons, "{}", what());
        assert_eq!(ours.holder, theirs.holder, "{}", what());
        for (a, b) in state.values().iter().zip(t.after.values()) {
            largest = largest.max((a - b).abs() / b.abs().max(1.0));
        }
        assert!(largest <= TOLERANCE, "{largest:e}: {}", what());
        exact += usize::from(state == t.after);
        count += 1;
    }
    println!("{count} transitions, {exact} to the last bit, largest difference {largest:e}");
    assert_eq!(count, 2456);
}

#[test]
fn every_predicate() {
    let (mut states, mut atoms) = (0, 0);
    for record in data::abstractions() {
        let environment = StickButton {
            angles: record.angles,
        };
        let all = Atoms::new::<StickButton>(&record.state).unwrap();
        let abstract_state = all.abstract_state(&environment, &record.state);
        let members: Vec<_> = all.members(abstract_state).collect();
        // Recorded in the order of the names, which must be ours too.
        assert_eq!(all.as_slice().len(), record.atoms.len());
        for (atom, (name, truth)) in all.as_slice().iter().zip(&record.atoms) {
            assert_eq!(atom_name(&record.state, atom), *name);
            assert_eq!(atom.holds(&environment, &record.state), *truth, "{name}");
            assert_eq!(members.contains(&atom), *truth, "{name}");
            atoms += 1;
        }
        states += 1;
    }
    println!("{atoms} atoms of {states} states");
    assert_eq!((states, atoms), (250, 3075));
}

fn atom_name(state: &State, atom: &GroundAtom) -> String {
    let name = |object: &ObjectId| state.name(StickButton::TYPES, *object).unwrap().to_string();
    let objects: Vec<_> = atom.objects.as_slice().iter().map(name).collect();
    let predicate = &StickButton::PREDICATES[usize::from(atom.predicate.0)];
    format!("{}({})", predicate.name, objects.join(","))
}

#[test]
fn every_pair_of_shapes() {
    let mut count = 0;
    for (tag, shapes, meet) in data::shape_pairs() {
        let result = match shapes {
            [Shape::Circle(a), Shape::Circle(b)] => symmetric(&a, &b),
            [Shape::Circle(a), Shape::Rectangle(b)] => symmetric(&a, &b),
            [Shape::Rectangle(a), Shape::Rectangle(b)] => symmetric(&a, &b),
            _ => panic!("unknown pair"),
        };
        assert_eq!(result, meet, "pair {count}, {tag}");
        count += 1;
    }
    println!("{count} pairs of shapes");
    assert_eq!(count, 504);
}

fn symmetric<A: Intersects<B>, B: Intersects<A>>(a: &A, b: &B) -> bool {
    assert_eq!(a.intersects(b), b.intersects(a));
    a.intersects(b)
}

#[test]
fn every_pick_and_press() {
    let (mut picks, mut presses) = ([0; 2], [0; 2]);
    for record in data::pick_feasibility() {
        let environment = StickButton {
            angles: record.angles,
        };
        let operator = find("PickStickFromNothing");
        let recorded = record.pick.iter().zip(&record.pick_actions);
        assert_eq!((record.pick.len(), record.pick_actions.len()), (201, 201));
        for (i, (feasible, actions)) in recorded.enumerate() {
            // The environment rounds it, as the framework does.
            let mu = i as f64 / 200.0;
            let outcome = try_operator(
                &environment,
                operator,
                &[ROBOT, STICK],
                &[mu],
                &record.initial,
            );
            assert_eq!(outcome.is_feasible(), *feasible, "task {picks:?}, mu {mu}");
            assert_eq!(outcome.actions, *actions, "task {picks:?}, mu {mu}");
            picks[usize::from(record.angles)] += 1;
            let buttons: Vec<_> = record.initial.of_type(BUTTON_TYPE).collect();
            assert_eq!(buttons.len(), record.press.len());
            for (button, pressed) in buttons.iter().zip(&record.press) {
                assert_eq!(pressed.len(), 201);
                assert_eq!(pressed[i].is_some(), *feasible);
                let Some(pressed) = pressed[i] else { continue };
                let ours = can_press(&environment, &outcome.state, *button);
                assert_eq!(ours, pressed, "task {picks:?}, mu {mu}, {button:?}");
                presses[usize::from(record.angles)] += 1;
            }
        }
    }
    println!("picks {picks:?}, presses {presses:?} (angles off, on)");
    assert_eq!((picks, presses), ([20_100; 2], [22_331, 22_454]));
}

fn can_press(environment: &StickButton, state: &State, button: ObjectId) -> bool {
    let controller = &StickButton::CONTROLLERS[usize::from(STICK_PRESS_BUTTON.0)];
    let run = rollout(environment, controller, &[ROBOT, STICK, button], &[], state);
    let pressed = state_holds_pressed(environment, &run.state, button);
    assert_eq!(pressed, run.ending == Ending::Terminal);
    run.actions > 0 && pressed
}

fn state_holds_pressed(environment: &StickButton, state: &State, button: ObjectId) -> bool {
    let predicate = &StickButton::PREDICATES[usize::from(PRESSED.0)];
    (predicate.classifier)(environment, state, &[button])
}

fn find(name: &str) -> &'static Operator<'static> {
    StickButton::OPERATORS
        .iter()
        .find(|o| o.name == name)
        .unwrap()
}

#[test]
fn every_recorded_task_could_be_generated() {
    let mut counts = [0; 2];
    for task in data::tasks() {
        let (least, most) = task.buttons;
        check_task(&task.initial, task.angles, least..=most);
        counts[usize::from(task.angles)] += 1;
    }
    println!("{counts:?} recorded tasks (angles off, on)");
    assert_eq!(counts, [600, 450]);
}

#[test]
fn generated_tasks_are_as_recorded_ones() {
    for angles in [false, true] {
        let environment = StickButton { angles };
        for (seed, buttons) in (0..400).zip([1..=1, 1..=2, 3..=4, 1..=MAX_BUTTONS].iter().cycle()) {
            let draw = || {
                environment
                    .task(buttons.clone(), &mut generator(seed))
                    .unwrap()
            };
            let task = draw();
            check_task(&task.initial, angles, buttons.clone());
            assert_eq!(
                task.goal.len(),
                World::of(&task.initial).unwrap().buttons.len()
            );
            assert!(!task.is_solved(&environment, &task.initial));
            assert_eq!(draw(), task, "the same seed gives the same task");
        }
    }
}

#[test]
fn tables_are_in_the_order_of_names() {
    let predicates = StickButton::PREDICATES.iter().map(|p| p.name);
    let operators = StickButton::OPERATORS.iter().map(|o| o.name);
    assert!(predicates.is_sorted() && operators.is_sorted());
}

#[test]
fn ground_operators_of_a_task() {
    let environment = StickButton::default();
    let task = environment.task(2..=2, &mut generator(0)).unwrap();
    let atoms = Atoms::new::<StickButton>(&task.initial).unwrap();
    let mut ground: heapless::Vec<GroundOperator, 17> = heapless::Vec::new();
    let operators = StickButton::OPERATORS;
    ground_operators(operators, &task.initial, &atoms, &mut ground).unwrap();
    let names: Vec<_> = ground
        .iter()
        .map(|g| {
            let objects = g.objects.as_slice().iter();
            let name = |o| {
                task.initial
                    .name(StickButton::TYPES, o)
                    .unwrap()
                    .to_string()
            };
            let objects: Vec<_> = objects.map(|o| name(*o)).collect();
            let operator = &operators[usize::from(g.operator.0)];
            format!("{}({})", operator.name, objects.join(","))
        })
        .collect();
    assert_eq!(names.len(), 2 + 1 + 1 + 1 + 4 + 2 + 4 + 2);
    assert!(names.is_sorted(), "{names:?}");
    assert_eq!(
        names[5],
        "RobotPressButtonFromButton(robby,button0,button0,stick)"
    );

    // Deletes come before adds: pressing the button one comes from is possible.
    let start = atoms.abstract_state(&environment, &task.initial);
    let press = ground
        .iter()
        .find(|g| g.is_applicable(start) && g.add_effects.len() == 2);
    let there = press.unwrap().apply(start);
    let again = ground[5].apply(there);
    assert_eq!((ground[5].is_applicable(there), again), (true, there));
    assert!(ground.push(ground[0]).is_err(), "17 is exactly enough");
    let mut small: heapless::Vec<GroundOperator, 16> = heapless::Vec::new();
    assert!(ground_operators(operators, &task.initial, &atoms, &mut small).is_err());
}

#[test]
fn impossible_numbers_of_buttons_are_refused() {
    let environment = StickButton::default();
    #[expect(clippy::reversed_empty_ranges)]
    for buttons in [0..=1, 2..=1, 1..=MAX_BUTTONS + 1] {
        assert!(environment.task(buttons, &mut generator(0)).is_err());
    }
}

/// The promises of the task generator.
fn check_task(state: &State, angles: bool, buttons: std::ops::RangeInclusive<usize>) {
    let within =
        |value: f64, low: f64, high: f64| assert!((low..=high).contains(&value), "{value}");
    let world = World::of(state).unwrap();
    assert!(buttons.contains(&world.buttons.len()));
    let [x, y, robot_theta] = *world.robot;
    within(x, 0.6, 9.4);
    within(y, 0.6, 2.4);
    let mut spaced = vec![[x, y]];
    for [x, y, pressed] in world.buttons {
        within(*x, 0.6, 9.4);
        within(*y, 0.6, 5.4);
        assert_eq!(*pressed, 0.0);
        spaced.push([*x, *y]);
    }
    for (i, a) in spaced.iter().enumerate() {
        assert!(spaced[..i].iter().all(|b| distance(*a, *b) >= 1.2 - 1e-12));
    }
    let [x, y, theta, held] = *world.stick;
    within(x, 0.6, 9.4);
    within(y, 0.6, 1.6);
    assert_eq!(held, 0.0);
    let stick = Rectangle::new([x, y], [3.0, 0.05], theta);
    let apart = |centre| {
        !stick.intersects(&Circle {
            centre,
            radius: 0.6,
        })
    };
    assert!(spaced.into_iter().all(apart));

    let [holder_x, holder_y, holder_theta] = *world.holder;
    assert!((theta - holder_theta).abs() < 1e-12);
    if !angles {
        assert_eq!([robot_theta, theta], [UPRIGHT; 2]);
    }
    let [along, across] = Frame2::new([x, y], theta).to_local([holder_x, holder_y]);
    within(along, -0.3 - 1e-12, 1.5 + 1e-12);
    assert!((across + 0.0375).abs() < 1e-12);
    let highest = world.buttons.iter().map(|b| b[1]).fold(0.0, f64::max);
    let reach = highest - ZONE_HEIGHT;
    let room_above = STICK_WIDTH - (along + HOLDER_WIDTH);
    assert!(reach < 0.0 || along > 0.2 - 1e-12 || room_above > reach - 1e-12);
}
