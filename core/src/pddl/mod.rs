//! Operators and problems as PDDL text: what classical planning texts are written in
//! (STRIPS, ADL and the costs of actions).
//!
//! A [`Domain`] is read once, a [`Problem`] for each task, and a [`Grounding`] turns
//! both into what a search takes: [`Atoms`](crate::task::Atoms), initial and goal
//! [`AtomSet`](crate::task::AtomSet)s and [`GroundOperator`](crate::task::GroundOperator)s. The
//! continuous parameters of an action are no part of PDDL; they belong to its
//! controller.
//!
//! ```
//! use critreg::pddl;
//!
//! let domain = pddl::Domain::parse(
//!     "(define (domain switches)
//!        (:types switch)
//!        (:predicates (On ?s - switch) (Wired ?a ?b - switch))
//!        (:action Flip :parameters (?a ?b - switch)
//!          :precondition (and (On ?a) (Wired ?a ?b)) :effect (On ?b)))",
//! )?;
//! let mut memory = [pddl::Fact::default(); 8];
//! let problem = pddl::Problem::parse(
//!     &domain,
//!     "(define (problem two) (:domain switches) (:objects left right - switch)
//!        (:init (On left) (Wired left right)) (:goal (On right)))",
//!     &mut memory,
//! )?;
//! let mut grounding = pddl::Grounding::<2>::new(&problem)?;
//! let mut flips = vec![];
//! grounding.operators(&mut |flip| {
//!     flips.push(flip);
//!     Ok(())
//! })?;
//! assert_eq!(flips.len(), 1, "no other pair is wired");
//! assert_eq!(problem.operator_text(&flips[0]).to_string(), "(Flip left right)");
//! assert!(grounding.goal().is_subset(flips[0].apply(grounding.initial())));
//! # Ok::<(), critreg::Error>(())
//! ```
//!
//! # The language
//!
//! ```text
//! domain     = "(" "define" "(" "domain" name ")" { section | action } ")" ;
//! section    = "(" ":requirements" { keyword } ")" | "(" ":types" { typed-name } ")"
//!            | "(" ":constants" { typed-name } ")"
//!            | "(" ":predicates" { "(" name { typed-var } ")" } ")"
//!            | "(" ":functions" { "(" name { typed-var } ")" [ "-" type ] } ")" ;
//! action     = "(" ":action" name { ":parameters" "(" { typed-var } ")"
//!            | ":precondition" condition | ":effect" effect } ")" ;
//! problem    = "(" "define" "(" "problem" name ")" { part } ")" ;
//! part       = "(" ":domain" name ")" | "(" ":requirements" { keyword } ")"
//!            | "(" ":objects" { typed-name } ")" | "(" ":init" { fact } ")"
//!            | "(" ":goal" condition ")"
//!            | "(" ":metric" "minimize" "(" "total-cost" | "total-time" ")" ")" ;
//! fact       = atom | "(" "not" atom ")" | "(" "=" atom number ")" ;
//! condition  = "(" ")" | "(" "and" { condition } ")" | "(" "or" { condition } ")"
//!            | "(" "not" condition ")" | "(" "imply" condition condition ")"
//!            | "(" "forall" "(" { typed-var } ")" condition ")"
//!            | "(" "exists" "(" { typed-var } ")" condition ")"
//!            | "(" "=" term term ")" | atom ;
//! effect     = "(" ")" | "(" "and" { effect } ")" | "(" "not" atom ")" | atom
//!            | "(" "forall" "(" { typed-var } ")" effect ")"
//!            | "(" "when" condition effect ")"
//!            | "(" "increase" "(" "total-cost" ")" ( number | atom ) ")" ;
//! atom       = "(" name { term } ")" ;
//! term       = name | variable ;                             (* names only in problems *)
//! typed-name = name [ "-" type ] ;                           (* `a b - c`: both are c *)
//! typed-var  = variable [ "-" type ] ;
//! type       = name | "(" "either" { name } ")" ;
//! ```
//!
//! `;` starts a comment. Sections and parts may stand in any order. Case does not matter;
//! names keep the spelling of their declaration, begin with a letter, a digit, `_` or `@`,
//! and may have `-`, `.` and `#` in them. What has no type is an `object`. A type may have
//! several supertypes; a constant may be listed among the objects again; any requirement
//! may be declared.
//!
//! Numbers are costs: whole ones that a text says, by which plans are compared if the
//! problem has `(:metric minimize (total-cost))`, and otherwise read over. Everything else
//! of PDDL is refused by name, with what to write instead: durations, other numbers,
//! derived predicates, preferences.
//!
//! # From text to sets
//!
//! A search takes conjunctions of atoms. So quantifiers are written out over the objects,
//! an atom that shall not hold gets another that stands for its negation, and an action
//! with alternatives in its precondition or with conditional effects becomes several
//! operators of the same name, at most 64. What no action changes is decided on the way,
//! which leaves one of them mostly. Objects are chosen by a join on what holds, and
//! atoms and operators that cannot be reached are left out.
//!
//! # Orders
//!
//! Types, predicates and actions are numbered as they are declared, so that a
//! [`PredicateId`](crate::task::PredicateId) or [`OperatorId`](crate::task::OperatorId) is a
//! place in the text; [`TypeId`](crate::task::TypeId) 0 is `object`. Objects, the domain's
//! constants among them, are numbered in the order of their names.
//! Ground operators come in the order of the names of their actions, then of their
//! objects, the last parameter changing fastest. Names are ordered by ASCII code
//! without regard to case.

mod domain;
mod formula;
mod ground;
mod problem;
mod reader;
mod schema;
mod types;
mod write;

pub use formula::MAX_BOUND;
pub use ground::{Grounding, Missing};
pub use problem::{Fact, MAX_GOAL, MAX_OBJECTS, Problem};
pub use schema::{
    Action, Domain, MAX_ACTIONS, MAX_CONSTANTS, MAX_FUNCTIONS, MAX_LITERALS, MAX_PARAMETERS,
    MAX_PREDICATES, MAX_TERMS, MAX_TYPES, MAX_VARIABLES, Object, Predicate, Variable,
};
pub use types::Type;
pub use write::{GroundText, MissingText};
