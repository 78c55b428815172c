//! What is said about wrong texts, and where.

use critreg::pddl;

const DECLARED: &str = "(:types u - t t) (:constants c - u e)\n(:predicates (p ?x - t) (q))";

/// A domain with this in its definition, from line 2 on.
pub(crate) fn domain_with(inside: &str) -> String {
    format!("(define (domain d)\n{inside})")
}

/// A problem with this in its definition, from line 2 on.
pub(crate) fn problem_with(inside: &str) -> String {
    format!("(define (problem p)\n{inside})")
}

/// What is said about a domain.
pub(crate) fn said_of_domain(text: &str) -> String {
    match pddl::Domain::parse(text) {
        Ok(_) => "accepted".into(),
        Err(error) => error.to_string(),
    }
}

/// What is said about a problem, with memory for so many atoms.
pub(crate) fn said_of_problem(domain: &str, text: &str, memory: usize) -> String {
    let domain = pddl::Domain::parse(domain).unwrap();
    let mut memory = vec![pddl::Fact::default(); memory];
    match pddl::Problem::parse(&domain, text, &mut memory) {
        Ok(_) => "accepted".into(),
        Err(error) => error.to_string(),
    }
}

#[test]
fn wrong_domains() {
    const SECTION: &str =
        "expected `(:types`, `(:constants`, `(:predicates`, `(:functions`, `(:action` or `)`";
    let cases: &[(&str, &str)] = &[
        (
            "(:requirements :Typing :fluents :durative-actions)",
            "accepted",
        ),
        ("(:types a - b)", "line 2, column 13: unknown type"),
        ("(:types a b A)", "accepted"),
        ("(:types object)", "accepted"),
        ("(:types a b - object c - a c - b)", "accepted"),
        (
            "(:types a - b b - c\nc - a)",
            "line 3, column 5: a type cannot be a subtype of itself",
        ),
        (
            "(:types a - (either b c))",
            "line 2, column 21: unknown type",
        ),
        (
            "(:types a - )",
            "line 2, column 13: expected the name of a type",
        ),
        (
            "(:types ?a)",
            "line 2, column 9: expected the name of a type or `)`",
        ),
        ("(:constants c - t)", "line 2, column 17: unknown type"),
        (
            "(:constants c C)",
            "line 2, column 15: this name is declared already",
        ),
        (
            "(:predicates (p ?x) (P))",
            "line 2, column 22: this name is declared already",
        ),
        (
            "(:predicates (p x))",
            "line 2, column 17: expected a variable, as `?x`, or `)`",
        ),
        (
            "(:predicates (not ?x))",
            "line 2, column 15: this is a word of the language",
        ),
        ("(:predicates (p ?x ?X))", "accepted"),
        (
            "(:predicates p)",
            "line 2, column 14: expected `(` and a predicate, or `)`",
        ),
        ("(:predicates) ; none\n (:types t)", "accepted"),
        ("(:functions (total-cost) - number (f ?a))", "accepted"),
        ("(:objects a)", &format!("line 2, column 2: {SECTION}")),
        (
            "(:action)",
            "line 2, column 9: expected the name of an action",
        ),
        ("(:action a :precondition ())", "accepted"),
        (
            "(:action a :parameters () :effect (and) :precondition ())",
            "accepted",
        ),
        (
            "(:action a :parameters ?x)",
            "line 2, column 24: expected `(` behind `:parameters`",
        ),
        (
            "(:action a :cost 3)",
            "line 2, column 12: expected `:parameters`, `:precondition`, `:effect` or `)`",
        ),
        (
            "(:durative-action a)",
            "line 2, column 2: `:durative-action` is not supported: write an `:action`; how long it takes is the controller's",
        ),
        (
            "(:action a :parameters ()) (:action A :parameters ())",
            "line 2, column 37: this name is declared already",
        ),
        (
            "(:derived (p) ())",
            "line 2, column 2: `:derived` is not supported: write the effects of the actions that change it, or a predicate that the program decides",
        ),
        (") (", "line 2, column 3: expected the end of the text"),
        ("\u{fc}", &format!("line 2, column 1: {SECTION}")),
    ];
    for (inside, expected) in cases {
        assert_eq!(said_of_domain(&domain_with(inside)), *expected, "{inside}");
    }
    let begin = "expected `(define (domain`, a name and `)`";
    let cases = [
        ("", 1),
        ("(define", 8),
        ("(define (problem p))", 10),
        ("(define (domain ?d))", 17),
    ];
    for (text, column) in cases {
        assert_eq!(
            said_of_domain(text),
            format!("line 1, column {column}: {begin}")
        );
    }
    let open = format!("line 1, column 19: {SECTION}");
    assert_eq!(said_of_domain("(define (domain d)"), open);
}

#[test]
fn wrong_actions() {
    let preconditions = [
        ("(p)", "line 5, column 3: expected a variable or a constant"),
        ("(p ?x)", "accepted"),
        (
            "(p ?y)",
            "line 5, column 4: this is not of the type that the predicate declares",
        ),
        (
            "(p ?x ?x)",
            "line 5, column 7: expected `)`: the predicate has no more arguments",
        ),
        ("(p ?z)", "line 5, column 4: unknown variable"),
        ("(p C)", "accepted"),
        (
            "(p e)",
            "line 5, column 4: this is not of the type that the predicate declares",
        ),
        ("(p f)", "line 5, column 4: unknown object or constant"),
        ("(r)", "line 5, column 2: unknown predicate"),
        ("(and (or (q)))", "accepted"),
        ("(not (p ?x))", "accepted"),
        ("(not (exists (?z) (q)))", "accepted"),
        ("(forall (?x - t) (p ?x))", "accepted"),
        (
            "(forall (?z) (p ?z))",
            "line 5, column 17: this is not of the type that the predicate declares",
        ),
        (
            "(exists ?z (q))",
            "line 5, column 9: expected `(` and variables behind a quantifier",
        ),
        ("(imply (q))", "line 5, column 11: expected `(` or `)`"),
        (
            "(when (q) (q))",
            "line 5, column 2: `when` is not supported here",
        ),
        (
            "(>= (f) 3)",
            "line 5, column 2: `>=` is not supported: a number belongs to the state of the program; write a predicate for what it decides",
        ),
        ("(not (= ?x c))", "accepted"),
        (
            "(not (= ?x))",
            "line 5, column 11: expected a variable or a constant",
        ),
        (
            "(not (= ?x c) (q))",
            "line 5, column 15: expected `)` behind what is negated",
        ),
        (
            "(= ?x ?y ?x)",
            "line 5, column 10: expected `)` behind two terms",
        ),
        ("(= ?x 3)", "line 5, column 7: unknown object or constant"),
        ("(and (and) () (and (q) (and (q))))", "accepted"),
        ("(and (q) q)", "line 5, column 10: expected `(` or `)`"),
        ("q", "line 5, column 1: expected `(`"),
    ];
    let effects = [
        (
            "(= ?x ?x)",
            "line 5, column 2: expected the name of a predicate",
        ),
        ("(not (p ?x))", "accepted"),
        ("(not p)", "line 5, column 6: expected `(` behind `not`"),
        ("(not (not (q)))", "line 5, column 7: unknown predicate"),
        (
            "(not (q) (q))",
            "line 5, column 10: expected `)` behind what is negated",
        ),
        (
            "(and (or (q)))",
            "line 5, column 7: `or` is not supported here",
        ),
        ("(and (forall (?z) (q)))", "accepted"),
        ("(when (or (q)) (and (q) (not (q))))", "accepted"),
        ("(increase (total-cost) 1)", "accepted"),
        (
            "(increase (total-cost) -1)",
            "line 5, column 24: expected a whole number from 0 to 999999999, or a function",
        ),
        (
            "(increase (fuel) 1)",
            "line 5, column 12: only `(total-cost)` can be increased: other numbers belong to the state of the program",
        ),
        (
            "(when (q) (increase (total-cost) 1))",
            "line 5, column 12: `increase` is not supported here: only `(increase (total-cost) ...)` in an effect without condition",
        ),
        (
            "(decrease (fuel) 1)",
            "line 5, column 2: `decrease` is not supported: a number belongs to the state of the program; write a predicate for what it decides",
        ),
    ];
    let preconditions = preconditions.map(|case| (":precondition", case));
    let effects = effects.map(|case| (":effect", case));
    for (part, (inside, expected)) in preconditions.into_iter().chain(effects) {
        let action = format!("(:action a :parameters (?x - u ?y) {part}\n{inside})");
        let domain = domain_with(&format!("{DECLARED}\n{action}"));
        assert_eq!(said_of_domain(&domain), expected, "{part} {inside}");
    }
}

#[test]
fn wrong_problems() {
    let domain = domain_with(DECLARED);
    let cases = [
        (
            "(:domain e)",
            "line 2, column 10: the problem belongs to another domain",
        ),
        (
            "(:objects)",
            "line 2, column 1: the problem has no `(:domain ...)`",
        ),
        (
            "(:domain d) (:objects a - v)",
            "line 2, column 27: unknown type",
        ),
        (
            "(:domain d) (:objects a b A)",
            "line 2, column 27: this name is declared already",
        ),
        ("(:domain d) (:objects C) (:init) (:goal ())", "accepted"),
        (
            "(:domain d) (:goal ()) (:init (p a)) (:objects a - (either t u))",
            "accepted",
        ),
        (
            "(:domain d) (:goal (q))",
            "line 2, column 1: the problem has no `(:init ...)`",
        ),
        (
            "(:domain d) (:init (p c)\n (p a))",
            "line 3, column 5: unknown object",
        ),
        (
            "(:domain d) (:objects a) (:init (p a))",
            "line 2, column 36: this is not of the type that the predicate declares",
        ),
        (
            "(:domain d) (:init (p ?x))",
            "line 2, column 23: expected the name of an object",
        ),
        (
            "(:domain d) (:init (= (cost) 0))",
            "line 2, column 24: unknown function",
        ),
        (
            "(:domain d) (:init (q))",
            "line 2, column 1: the problem has no `(:goal ...)`",
        ),
        (
            "(:domain d) (:init (not (q))) (:goal (not (q)))",
            "accepted",
        ),
        ("(:domain d) (:init) (:goal (exists (?x) (q)))", "accepted"),
        (
            "(:domain d) (:init) (:goal (q) (q))",
            "line 2, column 32: expected `)`: a goal is one condition, or an `and` of several",
        ),
        (
            "(:domain d) (:init) (:goal (q)) (:metric minimize (total-cost))",
            "accepted",
        ),
        (
            "(:domain d) (:init) (:goal (q)) (:metric minimize (fuel))",
            "line 2, column 52: expected `minimize (total-cost)`, or no metric: then plans are short",
        ),
        (
            "(:domain d) (:init) (:goal (q)) (:constraints (q))",
            "line 2, column 34: `:constraints` is not supported: write them as preconditions",
        ),
        (
            "(:domain d) (:init) (:goal)",
            "line 2, column 27: expected `(`",
        ),
        (
            "(:domain d) (:requirements :strips) (:init) (:goal ())",
            "accepted",
        ),
        (
            "(:domain d) (:init) (:goal ()))",
            "line 2, column 32: expected the end of the text",
        ),
    ];
    for (inside, expected) in cases {
        let problem = problem_with(inside);
        assert_eq!(said_of_problem(&domain, &problem, 3), expected, "{inside}");
    }
}
