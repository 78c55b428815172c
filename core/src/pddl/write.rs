//! Writes domains, problems and what is ground as PDDL.

use super::problem::Problem;
use super::schema::{Action, Domain, Literal, Object, Part, Relation, Term};
use crate::task::{Arguments, GroundAtom, GroundOperator, PredicateId, TypeId};
use core::fmt::{Display, Formatter, Result};

/// A ground atom or operator as text, such as `(on a b)`; `Display` writes it.
#[derive(Clone, Copy, Debug)]
pub struct GroundText<'a, 't> {
    name: &'a str,
    problem: &'a Problem<'t>,
    objects: Arguments,
}

impl<'t> Problem<'t> {
    /// A ground atom of this problem as text.
    pub fn atom_text(&self, atom: &GroundAtom) -> GroundText<'_, 't> {
        self.ground_text(self.domain().predicate_name(atom.predicate), atom.objects)
    }

    /// A ground operator of this problem as text.
    pub fn operator_text(&self, operator: &GroundOperator) -> GroundText<'_, 't> {
        let actions = self.domain().actions();
        let action = actions.get(usize::from(operator.operator.0));
        self.ground_text(action.map_or(NAMELESS, |a| a.name), operator.objects)
    }

    fn ground_text<'a>(&'a self, name: &'a str, objects: Arguments) -> GroundText<'a, 't> {
        GroundText {
            name,
            problem: self,
            objects,
        }
    }
}

/// Stands for what the tables do not have; nothing that was read is without name.
const NAMELESS: &str = "?";

impl Display for GroundText<'_, '_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "({}", self.name)?;
        for id in self.objects.as_slice() {
            let object = self.problem.objects().get(usize::from(id.0));
            write!(f, " {}", object.map_or(NAMELESS, |o| o.name))?;
        }
        f.write_str(")")
    }
}

impl Display for Problem<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let domain = self.domain();
        writeln!(f, "(define (problem {})", self.name())?;
        write!(f, "  (:domain {})", domain.name())?;
        let own = |o: &&Object<'_>| domain.find_constant(o.name).is_none();
        domain.write_objects(f, "  (:objects", self.objects().iter().filter(own))?;
        f.write_str("\n  (:init")?;
        for atom in self.initial() {
            write!(f, "\n    {}", self.atom_text(atom))?;
        }
        f.write_str(")\n  (:goal (and")?;
        for atom in self.goal() {
            write!(f, "\n    {}", self.atom_text(atom))?;
        }
        f.write_str(")))\n")
    }
}

impl Display for Domain<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        writeln!(f, "(define (domain {})", self.name())?;
        f.write_str("  (:requirements :strips :typing")?;
        if self
            .literals
            .iter()
            .any(|l| l.relation == Relation::Equality)
        {
            f.write_str(" :equality :negative-preconditions")?;
        }
        f.write_str(")")?;
        // The first type is `object`, which is not declared.
        write_section(f, "  (:types", self.types().iter().skip(1), |f, t| {
            self.write_typed(f, t.name, t.parent)
        })?;
        self.write_objects(f, "  (:constants", self.constants().iter())?;
        write_section(f, "  (:predicates", self.predicates().iter(), |f, p| {
            write!(f, "({}", p.name)?;
            for argument in self.arguments(p) {
                f.write_str(" ")?;
                self.write_typed(f, argument.name, argument.type_id)?;
            }
            f.write_str(")")
        })?;
        for action in self.actions() {
            self.write_action(f, action)?;
        }
        f.write_str(")\n")
    }
}

impl Domain<'_> {
    fn write_typed(&self, f: &mut Formatter<'_>, name: &str, type_id: TypeId) -> Result {
        let declared = self.types().get(usize::from(type_id.0));
        write!(f, "{name} - {}", declared.map_or(NAMELESS, |t| t.name))
    }

    fn write_objects<'o>(
        &self,
        f: &mut Formatter<'_>,
        open: &str,
        objects: impl Iterator<Item = &'o Object<'o>>,
    ) -> Result {
        write_section(f, open, objects, |f, o| {
            self.write_typed(f, o.name, o.type_id)
        })
    }

    fn write_action(&self, f: &mut Formatter<'_>, action: &Action<'_>) -> Result {
        write!(f, "\n  (:action {}\n    :parameters (", action.name)?;
        for (i, parameter) in self.parameters(action).iter().enumerate() {
            f.write_str(if i == 0 { "" } else { " " })?;
            self.write_typed(f, parameter.name, parameter.type_id)?;
        }
        f.write_str(")")?;
        for (open, part) in [
            ("    :precondition (and", Part::Precondition),
            ("    :effect (and", Part::Effect),
        ] {
            let literals = self.literals(action).iter().filter(|l| l.part == part);
            write_section(f, open, literals, |f, l| self.write_literal(f, action, l))?;
        }
        f.write_str(")")
    }

    fn write_literal(&self, f: &mut Formatter<'_>, action: &Action<'_>, l: &Literal) -> Result {
        let head = match l.relation {
            Relation::Equality => "=",
            Relation::Predicate(predicate) => self.predicate_name(predicate),
        };
        write!(f, "{}({head}", if l.negated { "(not " } else { "" })?;
        for term in &l.terms {
            let name = match term {
                Term::Parameter(place) => {
                    let parameter = self.parameters(action).get(usize::from(*place));
                    parameter.map(|p| p.name)
                }
                Term::Constant(place) => {
                    let constant = self.constants().get(usize::from(*place));
                    constant.map(|c| c.name)
                }
            };
            write!(f, " {}", name.unwrap_or(NAMELESS))?;
        }
        f.write_str(if l.negated { "))" } else { ")" })
    }

    fn predicate_name(&self, predicate: PredicateId) -> &str {
        let predicate = self.predicates().get(usize::from(predicate.0));
        predicate.map_or(NAMELESS, |p| p.name)
    }
}

/// A bracket with one item a line; nothing at all without items.
fn write_section<T>(
    f: &mut Formatter<'_>,
    open: &str,
    items: impl Iterator<Item = T>,
    write: impl Fn(&mut Formatter<'_>, T) -> Result,
) -> Result {
    let mut empty = true;
    for item in items {
        if empty {
            write!(f, "\n{open}")?;
        }
        empty = false;
        f.write_str("\n      ")?;
        write(f, item)?;
    }
    f.write_str(if empty { "" } else { ")" })
}
