//! Operators and problems as PDDL text: the planning language's typed STRIPS.
//!
//! A [`Domain`] is read once, a [`Problem`] for each task, and a [`Grounding`] turns
//! both into what a search takes: [`Atoms`](crate::task::Atoms), initial and goal
//! [`AtomSet`](crate::task::AtomSet)s and [`GroundOperator`](crate::task::GroundOperator)s. The
//! continuous parameters of an action are no part of PDDL; they belong to its
//! controller.
//!
//! ```
//! use critreg::task::GroundAtom;
//! use critreg::pddl;
//!
//! let domain = pddl::Domain::parse(
//!     "(define (domain switches)
//!        (:types switch)
//!        (:predicates (On ?s - switch) (Wired ?a ?b - switch))
//!        (:action Flip :parameters (?a ?b - switch)
//!          :precondition (and (On ?a) (Wired ?a ?b)) :effect (On ?b)))",
//! )?;
//! let mut memory = [GroundAtom::default(); 8];
//! let problem = pddl::Problem::parse(
//!     &domain,
//!     "(define (problem two) (:domain switches) (:objects left right - switch)
//!        (:init (On left) (Wired left right)) (:goal (On right)))",
//!     &mut memory,
//! )?;
//! let grounding = pddl::Grounding::new(&problem)?;
//! let flips: Vec<_> = grounding.operators().collect();
//! assert_eq!(flips.len(), 1, "no other pair is wired");
//! assert_eq!(problem.operator_text(&flips[0]).to_string(), "(Flip left right)");
//! assert!(grounding.goal().is_subset(flips[0].apply(grounding.initial())));
//! # Ok::<(), critreg::Error>(())
//! ```
//!
//! # The language
//!
//! ```text
//! domain     = "(" "define" "(" "domain" name ")" [ requires ]
//!              [ "(" ":types" { typed-name } ")" ]
//!              [ "(" ":constants" { typed-name } ")" ]
//!              [ "(" ":predicates" { "(" name { typed-var } ")" } ")" ]
//!              { action } ")" ;                              (* ";" starts a comment *)
//! action     = "(" ":action" name ":parameters" "(" { typed-var } ")"
//!              [ ":precondition" condition ] [ ":effect" effect ] ")" ;
//! problem    = "(" "define" "(" "problem" name ")" "(" ":domain" name ")" [ requires ]
//!              [ "(" ":objects" { typed-name } ")" ]
//!              "(" ":init" { atom } ")" "(" ":goal" goal ")" ")" ;
//! requires   = "(" ":requirements" { ":strips" | ":typing" | ":equality"
//!                                  | ":negative-preconditions" } ")" ;
//! condition  = "(" ")" | "(" "and" { condition } ")" | atom | equal | "(" "not" equal ")" ;
//! effect     = "(" ")" | "(" "and" { effect } ")" | atom | "(" "not" atom ")" ;
//! goal       = "(" ")" | "(" "and" { goal } ")" | atom ;
//! atom       = "(" name { term } ")" ;
//! equal      = "(" "=" term term ")" ;
//! term       = name | variable ;                             (* names only in problems *)
//! typed-name = name [ "-" name ] ;                           (* `a b - c`: both are c *)
//! typed-var  = variable [ "-" name ] ;
//! ```
//!
//! Case does not matter; names keep the spelling of their declaration. What has no
//! type is an `object`. A supertype is declared like every type. Everything else of
//! PDDL is refused by name: `either`, other negative preconditions, quantifiers,
//! conditional effects, numbers and costs.
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
mod ground;
mod problem;
mod reader;
mod schema;
mod write;

pub use ground::Grounding;
pub use problem::{MAX_OBJECTS, Problem};
pub use schema::{
    Action, Domain, MAX_ACTIONS, MAX_CONSTANTS, MAX_LITERALS, MAX_PREDICATES, MAX_TYPES,
    MAX_VARIABLES, Object, Predicate, Type, Variable,
};
pub use write::GroundText;
