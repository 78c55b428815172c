//! PDDL: domains, problems and what they are grounded to.

use super::halves;
use super::hash;
use super::texts::said;
use critreg::Error;
use critreg::pddl::{Domain, Fact, Grounding, Problem};

const WALK: &str = "(define (domain walk)
  (:types place - object robot)
  (:constants home - place)
  (:predicates (At ?r - robot ?p - place) (Lit ?p - place) (Near ?a ?b - place))
  (:action Walk :parameters (?r - robot ?from ?to - place)
    :precondition (and (At ?r ?from) (not (= ?from ?to)) (or (Near ?from ?to) (Lit ?to)))
    :effect (and (At ?r ?to) (not (At ?r ?from))
      (forall (?p - place) (when (and (Lit ?p) (Near ?p ?to)) (not (Lit ?p))))))
  (:action Light :parameters (?r - robot ?p - place)
    :precondition (and (At ?r ?p) (exists (?q - place) (Near ?p ?q))) :effect (Lit ?p)))";

const PROBLEM: &str = "(define (problem p) (:domain walk)
  (:objects a b c d - place r s - robot)
  (:init (At r a) (At s b) (Near a b) (Near b c) (Near c d) (Near d home))
  (:goal (and (Lit d) (imply (Lit a) (Lit b)) (forall (?p - place) (or (Lit ?p) (At r a))))))";

pub(crate) fn texts() -> Vec<Vec<u8>> {
    vec![format!("{WALK}\n---\n{PROBLEM}").into_bytes()]
}

pub(crate) fn ground(input: &[u8]) -> u64 {
    let (domain, problem) = halves(input);
    let domain = match Domain::parse(&domain) {
        Ok(domain) => domain,
        Err(error) => return said(&error),
    };
    let mut facts = [Fact::default(); 256];
    let problem = match Problem::parse(&domain, &problem, &mut facts) {
        Ok(problem) => problem,
        Err(error) => return said(&error),
    };
    let mut grounding = match Grounding::<16>::new(&problem) {
        Ok(grounding) => grounding,
        Err(error) => return said(&error),
    };
    let mut count = 0u32;
    let ended = grounding.operators(&mut |_| {
        count += 1;
        match count < 1 << 16 {
            true => Ok(()),
            false => Err(Error::CapacityExceeded("operators")),
        }
    });
    let atoms = grounding.atoms().as_slice().len();
    assert!(atoms <= 1024);
    hash(&(atoms, count.min(64), ended.is_ok()))
}
