//! Texts that are short and would take for ever: grounding them ends at a bound.

use critreg::pddl::{Domain, Fact, Grounding, Problem};
use std::time::{Duration, Instant};

/// What grounding and listing the operators of some actions over 64 objects ends with, and
/// how long it takes.
fn ground(actions: &str) -> (Result<usize, String>, Duration) {
    let chain: String = (0..21).map(|i| format!("(c{i})")).collect();
    let domain = format!("(define (domain d) (:predicates (p ?x) (e) {chain}) {actions})");
    let objects: String = (0..64).map(|i| format!("o{i} ")).collect();
    let goal = "(:init) (:goal (p o1))";
    let problem = format!("(define (problem p) (:domain d) (:objects {objects}) {goal})");
    assert!(domain.len() + problem.len() < 3000);
    let domain = Domain::parse(&domain).unwrap();
    let mut facts = [Fact::default(); 64];
    let problem = Problem::parse(&domain, &problem, &mut facts).unwrap();
    let (start, mut count) = (Instant::now(), 0);
    let operators = Grounding::<16>::new(&problem).and_then(|mut grounding| {
        grounding.operators(&mut |_| {
            count += 1;
            Ok(())
        })
    });
    let ended = operators.map(|()| count).map_err(|e| e.to_string());
    (ended, start.elapsed())
}

/// Actions with four parameters have 17 million choices of objects each.
#[test]
fn grounding_ends_at_a_bound() {
    let action = |name: &str, condition: &str, effect: &str| {
        format!(
            "(:action {name} :parameters (?a ?b ?c ?d)
              :precondition (and {condition}) :effect {effect})"
        )
    };
    let several: String = (0..10)
        .map(|i| action(&format!("a{i}"), "", "(p ?a)"))
        .collect();
    // Each pass over all actions reaches one atom more.
    let chain = (0..20)
        .rev()
        .map(|i| format!("(:action z{i} :precondition (c{i}) :effect (c{}))", i + 1));
    let chain: String = chain.collect();
    let compared: String = (0..20).map(|_| "(not (= ?a ?b))".to_string()).collect();
    for actions in [
        action("a", "", "(p ?a)"),
        several,
        format!("{chain}{}", action("a", "", "(and (p ?a) (c0))")),
        action("a", "(not (p ?a))", "(p ?a)"),
        action("a", &compared, "(p ?a)"),
        action("a", "(forall (?x ?y) (or (e) (= ?x ?y)))", "(p ?a)"),
        action("a", "", "(forall (?x ?y) (p ?x))"),
        action("a", "", "(when (forall (?x ?y) (or (e) (p ?x))) (p ?a))"),
    ] {
        let (ended, took) = ground(&actions);
        let error = ended.unwrap_err();
        assert!(error.contains("work of grounding"), "{actions}: {error}");
        assert!(took < Duration::from_secs(3), "{actions}: {took:?}");
    }
    let few = "(:action a :parameters (?a ?b) :effect (p ?a))";
    assert_eq!(ground(few).0, Ok(64 * 64));
}
