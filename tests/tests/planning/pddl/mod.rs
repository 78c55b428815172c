//! PDDL: grounding against the built-in environment and a naive oracle, writing
//! against reading, and what is said about wrong texts.

mod adl;
mod effort;
mod full;
mod oracle;
mod random;
mod wrong;

use critreg::Error;
use critreg::env::stick_button::StickButton;
use critreg::pddl;
use critreg::random::generator;
use critreg::task::{
    AtomSet, Atoms, Environment, GroundAtom, GroundOperator, OperatorId, State, ground_operators,
};
use std::collections::BTreeSet;

const STICK_BUTTON: [&str; 2] = [
    include_str!("../../../data/pddl/stick_button.pddl"),
    include_str!("../../../data/pddl/stick_button_problem.pddl"),
];
pub(crate) const BLOCKS: [&str; 2] = [
    include_str!("../../../data/pddl/blocks.pddl"),
    include_str!("../../../data/pddl/blocks_problem.pddl"),
];
pub(crate) const GRIPPER: [&str; 2] = [
    include_str!("../../../data/pddl/gripper.pddl"),
    include_str!("../../../data/pddl/gripper_problem.pddl"),
];
pub(crate) const DELIVERY: [&str; 2] = [
    include_str!("../../../data/pddl/delivery.pddl"),
    include_str!("../../../data/pddl/delivery_problem.pddl"),
];
pub(crate) const ALL: [[&str; 2]; 4] = [STICK_BUTTON, BLOCKS, GRIPPER, DELIVERY];

/// The ground operators, one after the other.
pub(crate) fn operators<const N: usize>(
    grounding: &mut pddl::Grounding<'_, '_, N>,
) -> Result<Vec<GroundOperator<N>>, Error> {
    let mut operators = vec![];
    grounding.operators(&mut |operator| {
        operators.push(operator);
        Ok(())
    })?;
    Ok(operators)
}

/// Grounds a problem, describes it in the words of the oracle, and tells how many
/// atoms it has.
pub(crate) fn ground([domain, problem]: [&str; 2]) -> Result<(oracle::Ground, usize), Error> {
    let domain = pddl::Domain::parse(domain)?;
    let mut memory = [pddl::Fact::default(); 256];
    let problem = pddl::Problem::parse(&domain, problem, &mut memory)?;
    let mut grounding = pddl::Grounding::<2>::new(&problem)?;
    let operators = operators(&mut grounding)?;
    let words = |set: AtomSet| -> BTreeSet<String> {
        let atoms = grounding.atoms().members(set);
        atoms
            .map(|atom| problem.atom_text(atom).to_string())
            .collect()
    };
    let operators = operators.iter().map(|operator| oracle::Operator {
        name: problem.operator_text(operator).to_string(),
        preconditions: words(operator.preconditions),
        adds: words(operator.add_effects),
        deletes: words(operator.delete_effects),
    });
    let described = oracle::Ground {
        operators: operators.collect(),
        initial: words(grounding.initial()),
        goal: words(grounding.goal()),
    };
    Ok((described, grounding.atoms().as_slice().len()))
}

/// As the built-in environment describes a task.
fn ground_built_in(buttons: usize) -> oracle::Ground {
    let environment = StickButton::default();
    let task = environment
        .task(buttons..=buttons, &mut generator(1))
        .unwrap();
    let atoms = Atoms::new::<StickButton>(&task.initial).unwrap();
    let mut operators: heapless::Vec<GroundOperator, 64> = heapless::Vec::new();
    ground_operators(
        StickButton::OPERATORS,
        &task.initial,
        &atoms,
        &mut operators,
    )
    .unwrap();
    let text = |name: &str, objects: &[_]| {
        let object = |o| State::name(&task.initial, StickButton::TYPES, o).unwrap();
        let objects: String = objects.iter().map(|o| format!(" {}", object(*o))).collect();
        format!("({name}{objects})")
    };
    let words = |set: AtomSet| -> BTreeSet<String> {
        let name = |a: &GroundAtom| StickButton::PREDICATES[usize::from(a.predicate.0)].name;
        atoms
            .members(set)
            .map(|a| text(name(a), a.objects.as_slice()))
            .collect()
    };
    let name = |id: OperatorId| StickButton::OPERATORS[usize::from(id.0)].name;
    let described = operators.iter().map(|o| oracle::Operator {
        name: text(name(o.operator), o.objects.as_slice()),
        preconditions: words(o.preconditions),
        adds: words(o.add_effects),
        deletes: words(o.delete_effects),
    });
    oracle::Ground {
        operators: described.collect(),
        initial: words(atoms.abstract_state(&environment, &task.initial)),
        goal: words(atoms.set(task.goal.iter().copied()).unwrap()),
    }
    .reachable()
}

#[test]
fn stick_button_is_the_built_in_environment() {
    for buttons in 1..=4 {
        let expected = ground_built_in(buttons);
        let names: String = (0..buttons).map(|i| format!(" button{i}")).collect();
        let join = |atoms: &BTreeSet<String>| atoms.iter().cloned().collect::<String>();
        let problem = format!(
            "(define (problem p) (:domain Stick-Button)
               (:objects{names} - button robby - robot stick - stick holder - holder)
               (:init {}) (:goal (and {})))",
            join(&expected.initial),
            join(&expected.goal),
        );
        let (found, _) = ground([STICK_BUTTON[0], &problem]).unwrap();
        assert_eq!(found, expected);
        // From nothing: 1 + 1 + 1 + 2 n; from a button: n + 2 n n.
        let n = buttons;
        assert_eq!(found.operators.len(), 3 + 3 * n + 2 * n * n);
    }
}

/// Counted by hand: the operators and the atoms.
#[test]
fn counts() {
    let cases = [
        // Buttons are two: operators as above; atoms: 2 of the hand, nothing below,
        // and three for each button.
        (STICK_BUTTON, 3 + 6 + 8, 3 + 6),
        // Blocks are three: two ways to the table and from it for each block, and
        // for each pair onto each other and off; atoms: three for each block, one
        // for each pair, the hand.
        (BLOCKS, 2 * 3 + 2 * 6, 3 * 3 + 6 + 1),
        // Two rooms and hands, four balls: moves, picks and drops.
        (GRIPPER, 4 + 2 * 16, 2 + 8 + 2 + 8),
        // Two parcels into three vehicles and out again at two places, two trucks
        // on four roads, one drone from its truck to three places, nothing. Atoms:
        // where two parcels and three vehicles are, what is in which, carried out.
        (DELIVERY, 6 + 12 + 8 + 3 + 1, 6 + 9 + 6 + 2),
    ];
    for (texts, operators, atoms) in cases {
        let (found, found_atoms) = ground(texts).unwrap();
        assert_eq!((found.operators.len(), found_atoms), (operators, atoms));
    }
}

#[test]
fn grounding_is_as_the_oracle_says() {
    for texts in ALL {
        let lower = texts.map(str::to_lowercase);
        let (found, _) = ground([&lower[0], &lower[1]]).unwrap();
        assert_eq!(found, oracle::ground(texts[0], texts[1]));
    }
}

#[test]
fn order_and_spelling_of_names() {
    let domain = "(define (domain d) (:predicates (P ?x))
        (:action b :parameters (?x) :effect (p ?X)) (:ACTION A :parameters (?x ?y) :effect ()))";
    let domain = pddl::Domain::parse(domain).unwrap();
    let text = "(define (problem p) (:domain D) (:objects z Y) (:init (p y)) (:goal (p Z)))";
    let mut memory = [pddl::Fact::default(); 1];
    let problem = pddl::Problem::parse(&domain, text, &mut memory).unwrap();
    let mut grounding = pddl::Grounding::<2>::new(&problem).unwrap();
    let operators = operators(&mut grounding).unwrap();
    let names = operators
        .iter()
        .map(|o| problem.operator_text(o).to_string());
    let expected = ["(A Y Y)", "(A Y z)", "(A z Y)", "(A z z)", "(b Y)", "(b z)"];
    assert_eq!(names.collect::<Vec<_>>(), expected);
    let ids: Vec<_> = operators.iter().map(|o| o.operator.0).collect();
    assert_eq!(ids, [1, 1, 1, 1, 0, 0], "as declared");
    let atoms = grounding.atoms().as_slice().iter();
    let atoms: Vec<_> = atoms.map(|a| problem.atom_text(a).to_string()).collect();
    assert_eq!(atoms, ["(P Y)", "(P z)"]);
}

/// Length of a shortest plan by breadth-first search; `None` if there is no plan.
fn shortest_plan([domain, problem]: [&str; 2]) -> Option<usize> {
    let domain = pddl::Domain::parse(domain).unwrap();
    let mut memory = [pddl::Fact::default(); 64];
    let problem = pddl::Problem::parse(&domain, problem, &mut memory).unwrap();
    let mut grounding = pddl::Grounding::<2>::new(&problem).unwrap();
    let operators = operators(&mut grounding).unwrap();
    let mut layer = BTreeSet::from([grounding.initial()]);
    let mut seen = layer.clone();
    for length in 0.. {
        if layer.iter().any(|state| grounding.goal().is_subset(*state)) {
            return Some(length);
        }
        let after = |state: &AtomSet| {
            let applicable = operators.iter().filter(|o| o.is_applicable(*state));
            applicable.map(|o| o.apply(*state)).collect::<Vec<_>>()
        };
        let next = layer.iter().flat_map(after);
        layer = next.filter(|state| seen.insert(*state)).collect();
        if layer.is_empty() {
            break;
        }
    }
    None
}

#[test]
fn known_shortest_plans() {
    // Two presses; Sussman's anomaly; two ways there and one back, with two balls in
    // two hands; both parcels in and out of the drone, which flies once.
    for (texts, length) in ALL.into_iter().zip([2, 6, 3 + 4 * 2, 5]) {
        assert_eq!(shortest_plan(texts), Some(length));
    }
    let never = DELIVERY[1].replace("(docked bee van))))", "(docked bee lorry))))");
    assert_ne!(never, DELIVERY[1]);
    assert_eq!(
        shortest_plan([DELIVERY[0], &never]),
        None,
        "no action docks"
    );
}
