//! What is said when tables are full, and that they are not full any sooner.

use super::wrong::{domain_with, problem_with, said_of_domain, said_of_problem};
use critreg::Error;
use critreg::pddl;
use critreg::task::MAX_ARGUMENTS;

/// A table that has no room for one more item than it should have.
struct Full {
    room: usize,
    before: &'static str,
    item: fn(usize) -> String,
    after: &'static str,
    /// Where in the item that is too much.
    column: usize,
    what: &'static str,
}

impl Full {
    /// The inside of a definition with so many items, one a line from line 3 on.
    fn with(&self, items: usize) -> String {
        let items: String = (0..items).map(|i| (self.item)(i) + "\n").collect();
        format!("{}\n{items}{}", self.before, self.after)
    }

    fn check(&self, said: impl Fn(&str) -> String) {
        assert_eq!(said(&self.with(self.room)), "accepted", "{}", self.what);
        let (line, column) = (3 + self.room, self.column);
        let expected = format!("line {line}, column {column}: no room left: {}", self.what);
        assert_eq!(said(&self.with(self.room + 1)), expected);
    }
}

#[test]
fn full_tables_of_a_domain() {
    let cases = [
        Full {
            // `object` is a type, too.
            room: pddl::MAX_TYPES - 1,
            before: "(:types",
            item: |i| format!("t{i}"),
            after: ")",
            column: 1,
            what: "too many types",
        },
        Full {
            room: pddl::MAX_CONSTANTS,
            before: "(:constants",
            item: |i| format!("c{i}"),
            after: ")",
            column: 1,
            what: "too many constants",
        },
        Full {
            room: pddl::MAX_PREDICATES,
            before: "(:predicates",
            item: |i| format!("(p{i})"),
            after: ")",
            column: 2,
            what: "too many predicates",
        },
        Full {
            room: MAX_ARGUMENTS,
            before: "(:predicates (p",
            item: |i| format!("?x{i}"),
            after: "))",
            column: 1,
            what: "too many arguments of one predicate or action",
        },
        Full {
            room: pddl::MAX_PARAMETERS / 4,
            before: "",
            item: |i| format!("(:action a{i} :parameters (?a ?b ?c ?d))"),
            after: "",
            column: 27,
            what: "too many arguments of all predicates and actions",
        },
        Full {
            room: pddl::MAX_ACTIONS,
            before: "",
            item: |i| format!("(:action a{i} :parameters ())"),
            after: "",
            column: 10,
            what: "too many actions",
        },
        Full {
            // The empty precondition of the action and the `and` take a place, too.
            room: pddl::MAX_LITERALS - 2,
            before: "(:predicates (p)) (:action a :parameters () :effect (and",
            item: |_| "(p)".into(),
            after: "))",
            column: 2,
            what: "too many preconditions and effects",
        },
    ];
    for case in cases {
        case.check(|inside| said_of_domain(&domain_with(inside)));
    }
}

/// An atom for each number below 25.
fn numbered_atom(i: usize) -> String {
    format!("(r c{} c{})", i / 5, i % 5)
}

#[test]
fn full_tables_of_a_problem() {
    const MEMORY: usize = 20;
    let cases = [
        Full {
            // The domain has five constants.
            room: pddl::MAX_OBJECTS - 5,
            before: "(:domain d) (:objects",
            item: |i| format!("o{i}"),
            after: ") (:init) (:goal ())",
            column: 1,
            what: "too many objects",
        },
        Full {
            // An atom that is there already takes no room.
            room: MEMORY - 1,
            before: "(:domain d) (:init (q) (q)",
            item: numbered_atom,
            after: ") (:goal ())",
            column: 2,
            what: "lend more memory for what holds initially",
        },
        Full {
            room: pddl::MAX_GOAL - 1,
            before: "(:domain d) (:init) (:goal (and",
            item: |i| numbered_atom(i % 25),
            after: "))",
            column: 2,
            what: "too many preconditions and effects",
        },
    ];
    for case in cases {
        let domain = "(:constants c0 c1 c2 c3 c4)\n(:predicates (r ?x ?y) (q))";
        let said =
            |inside: &str| said_of_problem(&domain_with(domain), &problem_with(inside), MEMORY);
        case.check(said);
    }
}

/// An [`AtomSet`](critreg::task::AtomSet) has room for 128.
#[test]
fn too_many_ground_atoms() {
    let domain = "(:predicates (p ?x) (q ?x) (r) (s ?x))
        (:action a :parameters (?x) :precondition (s ?x) :effect (and (p ?x) (q ?x)))
        (:action b :parameters () :effect (r))";
    let domain = domain_with(domain);
    let domain = pddl::Domain::parse(&domain).unwrap();
    let objects: Vec<_> = (0..64).map(|i| format!("o{i}")).collect();
    for (holding, fits) in [(63, true), (64, false)] {
        let initial: String = objects
            .iter()
            .take(holding)
            .map(|o| format!("(s {o})"))
            .collect();
        let objects = objects.join(" ");
        let text = format!("(:domain d) (:objects {objects}) (:init {initial}) (:goal (r))");
        let text = problem_with(&text);
        let mut memory = [pddl::Fact::default(); 64];
        let problem = pddl::Problem::parse(&domain, &text, &mut memory).unwrap();
        match pddl::Grounding::<2>::new(&problem) {
            Ok(grounding) => assert_eq!(grounding.atoms().as_slice().len(), 127),
            Err(error) => assert_eq!(error, Error::CapacityExceeded("ground atoms of a task")),
        }
        assert_eq!(pddl::Grounding::<2>::new(&problem).is_ok(), fits);
        let wider = pddl::Grounding::<3>::new(&problem).unwrap();
        assert_eq!(wider.atoms().as_slice().len(), 2 * holding + 1);
    }
}
