//! Texts in a world of symbols: states that are recognised, costs, goals with alternatives.

use crate::pddl::{GRIPPER, operators};
use critreg::pddl::{Domain, Fact, Grounding, Problem};
use critreg::plan::{AbstractTask, Conclusion, Config, Planner, Room, Unguided};
use critreg::random::generator;
use critreg::task::AtomSet;
use critreg_tests::plan::symbols::Symbols;

/// What came of planning: how it ended, the plan, its cost, and nodes of the search.
struct Planned {
    conclusion: Conclusion,
    plan: Vec<String>,
    cost: u32,
    nodes: u32,
    repeated: u32,
}

fn plan([domain, problem]: [&str; 2], parameters: usize, skeletons_per_state: u32) -> Planned {
    let domain = Domain::parse(domain).unwrap();
    let mut facts = [Fact::default(); 64];
    let problem = Problem::parse(&domain, problem, &mut facts).unwrap();
    let mut grounding = Grounding::<2>::new(&problem).unwrap();
    let operators = operators(&mut grounding).unwrap();
    let initial = grounding.initial();
    let task = AbstractTask {
        operators: &operators,
        initial,
        goal: grounding.goal(),
    };
    let mut planner = Planner {
        world: &mut Symbols { parameters },
        sampler: &mut Symbols { parameters },
        guide: &mut Unguided,
        config: Config {
            skeletons_per_state,
            ..Config::default()
        },
    };
    let mut room = Box::<Room<AtomSet, 128, 16_384, 32>>::default();
    let planned = planner.plan(task, &initial, generator(1), || generator(1), room.lend());
    let planned = planned.unwrap();
    let steps = planned.steps.iter();
    let plan: Vec<_> = steps
        .map(|step| &operators[usize::from(step.operator)])
        .collect();
    Planned {
        conclusion: planned.conclusion,
        plan: plan
            .iter()
            .map(|o| problem.operator_text(o).to_string())
            .collect(),
        cost: plan.iter().map(|o| o.cost).sum(),
        nodes: planned.metrics.nodes_created,
        repeated: planned.metrics.repeated,
    }
}

/// Balls are carried in any order, which is the same in the end.
#[test]
fn four_balls_are_a_graph() {
    let tree = plan(GRIPPER, 1, u32::MAX);
    let few = plan(GRIPPER, 1, 4);
    let graph = plan(GRIPPER, 0, u32::MAX);
    for planned in [&few, &graph] {
        assert_eq!(
            (planned.conclusion, planned.plan.len()),
            (Conclusion::Solved, 11)
        );
        assert!(planned.repeated > 0);
    }
    assert_eq!(tree.repeated, 0);
    assert!(
        2 * graph.nodes < few.nodes && 2 * few.nodes < tree.nodes,
        "{} {} {}",
        graph.nodes,
        few.nodes,
        tree.nodes
    );
}

/// No action brings the drone back, though nothing in the text says so at once.
#[test]
fn that_there_is_no_plan_is_found_out() {
    let domain = "(define (domain pegs) (:predicates (at ?x) (free ?x) (next ?x ?y))
        (:action swap :parameters (?a ?b) :precondition (and (at ?a) (free ?b) (next ?a ?b))
          :effect (and (at ?b) (free ?a) (not (at ?a)) (not (free ?b)))))";
    let problem = "(define (problem p) (:domain pegs) (:objects a b c) (:init (at a) (free b)
        (free c) (next a b) (next b a) (next b c) (next c b)) (:goal (and (at a) (at c))))";
    for parameters in [0, 1] {
        let planned = plan([domain, problem], parameters, 1);
        assert_eq!(planned.conclusion, Conclusion::Exhausted);
        assert!(planned.plan.is_empty() && planned.nodes < 20);
    }
}

#[test]
fn the_cheapest_plan_may_be_longer() {
    let domain = "(define (domain roads) (:predicates (at ?x) (road ?x ?y))
        (:functions (length ?x ?y) (total-cost))
        (:action drive :parameters (?x ?y) :precondition (and (at ?x) (road ?x ?y))
          :effect (and (not (at ?x)) (at ?y) (increase (total-cost) (length ?x ?y)))))";
    let problem = |metric: &str| {
        format!(
            "(define (problem p) (:domain roads) (:objects a b c d) (:init (at a)
             (road a d) (road a b) (road b c) (road c d) (= (length a d) 9)
             (= (length a b) 2) (= (length b c) 0) (= (length c d) 3)) (:goal (at d)) {metric})"
        )
    };
    for (metric, length, cost) in [("", 1, 1), ("(:metric minimize (total-cost))", 3, 5)] {
        let planned = plan([domain, &problem(metric)], 0, 1);
        assert_eq!(
            (planned.plan.len(), planned.cost),
            (length, cost),
            "{metric}"
        );
    }
}

#[test]
fn one_of_several_goals_is_enough() {
    let domain = "(define (domain d) (:predicates (p ?x) (q ?x))
        (:action one :parameters (?x) :effect (p ?x))
        (:action two :parameters (?x) :precondition (p ?x) :effect (and (q ?x) (not (p ?x)))))";
    let problem = "(define (problem p) (:domain d) (:objects a b) (:init)
        (:goal (or (and (q a) (p a)) (exists (?x) (and (q ?x) (not (p ?x)))))))";
    let planned = plan([domain, problem], 0, 1);
    assert_eq!(planned.conclusion, Conclusion::Solved);
    assert_eq!(planned.plan.len(), 2);
    assert!(planned.plan[1].starts_with("(two "), "{:?}", planned.plan);
}
