//! Texts in a world of symbols: states that are recognised, costs, goals with alternatives.

use crate::pddl::{GRIPPER, operators};
use critreg::Error;
use critreg::pddl::{Domain, Fact, Grounding, Problem};
use critreg::plan::{
    AbstractTask, Advice, Conclusion, Config, Draw, Drawn, Guide, Planner, ReasonId, Room, Sampler,
    Skeleton, Unguided, World,
};
use critreg::random::generator;
use critreg::task::{AtomSet, GroundOperator, OperatorId};
use critreg_tests::plan::symbols::Symbols;
use rand_core::Rng;

/// What came of planning: how it ended, the plan, its cost, and nodes of the search.
struct Planned {
    conclusion: Conclusion,
    plan: Vec<String>,
    cost: u32,
    nodes: u32,
    repeated: u32,
    /// Whether it was given up to follow the guide.
    unadvised: bool,
}

fn plan(texts: [&str; 2], parameters: usize, skeletons_per_state: u32) -> Planned {
    plan_with(texts, parameters, skeletons_per_state, &mut Unguided)
}

fn plan_with(
    [domain, problem]: [&str; 2],
    parameters: usize,
    skeletons_per_state: u32,
    guide: &mut impl Guide<2>,
) -> Planned {
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
        guide,
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
        unadvised: planned.metrics.advised.is_some(),
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

/// Postpones the first whole sequence it is asked about.
#[derive(Default)]
struct NotTheFirst(Vec<u16>);

impl Guide for NotTheFirst {
    fn judge(&mut self, prefix: Skeleton<'_>) -> Advice {
        if self.0.is_empty() && prefix.len() == 3 {
            self.0 = prefix.places().to_vec();
        }
        match prefix.places() == self.0 {
            true => Advice::Postpone(ReasonId(0)),
            false => Advice::Keep,
        }
    }
}

/// A guide speaks of the way: where the first way to a state is postponed, the next one is tried
/// before advice is given up.
#[test]
fn another_way_to_a_state_is_tried_with_advice() {
    let domain = "(define (domain doors) (:predicates (left) (right) (through))
        (:action open-left :effect (left)) (:action open-right :effect (right))
        (:action pass :precondition (and (left) (right)) :effect (through)))";
    let problem = "(define (problem p) (:domain doors) (:init) (:goal (through)))";
    let mut guide = NotTheFirst::default();
    let planned = plan_with([domain, problem], 1, 1, &mut guide);
    assert_eq!(planned.conclusion, Conclusion::Solved);
    assert_eq!((guide.0.len(), planned.plan.len()), (3, 3));
    assert!(!planned.unadvised && planned.repeated > 0);
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

/// The deepest cause is named: what no action adds, or what a text leaves out.
#[test]
fn what_is_missing_for_the_goal() {
    let domain = "(define (domain roofs) (:predicates (at ?x) (ladder ?x ?y) (lit ?x) (dry ?x))
        (:action climb :parameters (?x ?y) :precondition (and (at ?x) (ladder ?x ?y))
          :effect (and (at ?y) (not (at ?x))))
        (:action light :parameters (?x) :precondition (and (at ?x) (not (lit ?x)))
          :effect (lit ?x)))";
    let cases = [
        ("(lit floor)", None),
        (
            "(lit roof)",
            Some("nothing reaches (at roof), as climb needs (ladder ?x roof)"),
        ),
        (
            "(and (dry floor) (lit floor))",
            Some("nothing reaches (dry floor), as no action adds it"),
        ),
        (
            "(at top)",
            Some("nothing reaches (at roof), as climb needs (ladder ?x roof)"),
        ),
    ];
    let domain = Domain::parse(domain).unwrap();
    for (goal, expected) in cases {
        let text = format!(
            "(define (problem p) (:domain roofs) (:objects floor roof top)
             (:init (at floor) (ladder roof top)) (:goal {goal}))"
        );
        let mut facts = [Fact::default(); 8];
        let problem = Problem::parse(&domain, &text, &mut facts).unwrap();
        let mut grounding = Grounding::<2>::new(&problem).unwrap();
        let missing = grounding.missing().unwrap();
        let words = missing.map(|missing| problem.missing_text(missing).to_string());
        assert_eq!(words.as_deref(), expected, "{goal}");
    }
}

/// A world in which one action never works, whatever its text says.
struct Stuck(OperatorId, u32);

impl World for Stuck {
    type State = AtomSet;
    type Error = Error;

    fn parameters(&self, _: &GroundOperator) -> Result<usize, Error> {
        Ok(0)
    }

    fn holds(&mut self, atom: u32, state: &AtomSet) -> Result<bool, Error> {
        Ok(state.contains(atom))
    }

    fn execute(
        &mut self,
        operator: &GroundOperator,
        _: &[f64],
        before: &AtomSet,
        after: &mut AtomSet,
    ) -> Result<u32, Error> {
        let works = operator.operator != self.0;
        self.1 += u32::from(!works);
        *after = operator.apply(*before);
        Ok(u32::from(works))
    }
}

impl Sampler<Stuck> for Symbols {
    fn sample<R: Rng>(&mut self, _: &Draw<'_, AtomSet>, _: &mut R) -> Result<Drawn, Error> {
        Ok(Drawn::Parameters(Default::default()))
    }
}

/// What failed without a choice is not tried again in another skeleton.
#[test]
fn a_dead_beginning_is_tried_once() {
    let domain = "(define (domain d) (:predicates (a) (b) (c) (done))
        (:action short :effect (a))
        (:action long1 :effect (b)) (:action long2 :precondition (b) :effect (a))
        (:action x :precondition (a) :effect (c)) (:action y :precondition (a) :effect (c))
        (:action z :precondition (c) :effect (done)))";
    let problem = "(define (problem p) (:domain d) (:init) (:goal (done)))";
    let domain = Domain::parse(domain).unwrap();
    let mut facts = [];
    let problem = Problem::parse(&domain, problem, &mut facts).unwrap();
    let mut grounding = Grounding::<2>::new(&problem).unwrap();
    let operators = operators(&mut grounding).unwrap();
    let short = domain.find_action("short").unwrap();
    let mut world = Stuck(short, 0);
    let mut planner = Planner {
        world: &mut world,
        sampler: &mut Symbols { parameters: 0 },
        guide: &mut Unguided,
        config: Config::default(),
    };
    let initial = grounding.initial();
    let task = AbstractTask {
        operators: &operators,
        initial,
        goal: grounding.goal(),
    };
    let mut room = Box::<Room<AtomSet, 128, 1024, 32>>::default();
    let planned = planner.plan(task, &initial, generator(1), || generator(1), room.lend());
    let planned = planned.unwrap();
    assert_eq!(planned.conclusion, Conclusion::Solved);
    assert_eq!(planned.steps.len(), 4);
    assert_eq!(planned.metrics.failures().iter().sum::<u32>(), 1);
    assert!(planned.metrics.dead > 0);
}
