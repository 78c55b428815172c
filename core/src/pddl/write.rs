//! Writes domains, problems and what is ground as PDDL.

use super::formula::{Kind, MAX_BOUND, Term, View};
use super::ground::Missing;
use super::problem::Problem;
use super::schema::{Action, Domain, Object, Variable};
use super::types::Type;
use crate::task::{Arguments, GroundAtom, GroundOperator, PredicateId, TypeId};
use core::fmt::{Display, Formatter, Result};
use heapless::Vec;

/// A ground atom or operator as text, such as `(on a b)` or `(not (on a b))`; `Display` writes it.
#[derive(Clone, Copy, Debug)]
pub struct GroundText<'a, 't> {
    name: &'a str,
    negated: bool,
    problem: &'a Problem<'t>,
    objects: Arguments,
}

impl<'t> Problem<'t> {
    /// A ground atom of this problem as text.
    pub fn atom_text(&self, atom: &GroundAtom) -> GroundText<'_, 't> {
        let negated = atom.predicate.is_negation();
        let atom = if negated { atom.negation() } else { *atom };
        GroundText {
            name: self.domain().predicate_name(atom.predicate),
            negated,
            problem: self,
            objects: atom.objects,
        }
    }

    /// A ground operator of this problem as text.
    pub fn operator_text<const N: usize>(
        &self,
        operator: &GroundOperator<N>,
    ) -> GroundText<'_, 't> {
        let actions = self.domain().actions();
        let action = actions.get(usize::from(operator.operator.0));
        GroundText {
            name: action.map_or(NAMELESS, |a| a.name),
            negated: false,
            problem: self,
            objects: operator.objects,
        }
    }
}

/// Why an atom of a goal cannot be reached, in words; `Display` writes it.
#[derive(Clone, Copy, Debug)]
pub struct MissingText<'a, 't> {
    missing: Missing,
    problem: &'a Problem<'t>,
}

impl<'t> Problem<'t> {
    /// Why an atom of the goal cannot be reached, as "nothing reaches (at a roof): Climb
    /// needs (ladder ?from roof)".
    pub fn missing_text(&self, missing: Missing) -> MissingText<'_, 't> {
        MissingText {
            missing,
            problem: self,
        }
    }
}

impl Display for MissingText<'_, '_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let domain = self.problem.domain();
        write!(
            f,
            "nothing reaches {}",
            self.problem.atom_text(&self.missing.atom)
        )?;
        let action = self.missing.action;
        let action = action.and_then(|id| domain.actions().get(usize::from(id.0)));
        let Some(action) = action else {
            return f.write_str(", as no action adds it");
        };
        let Some((place, binding)) = self.missing.condition else {
            return write!(f, ", as {} never becomes possible", action.name);
        };
        write!(f, ", as {} needs", action.name)?;
        let mut scope = Vec::new();
        for (index, parameter) in (0..).zip(domain.parameters(action)) {
            let object = binding.get(index);
            let object = object.and_then(|id| self.problem.objects().get(usize::from(id.0)));
            // A scope has room for all parameters of an action.
            let _ = scope.push(Variable {
                name: object.map_or(parameter.name, |object| object.name),
                ..*parameter
            });
        }
        domain.writer().write(f, place, &mut scope)
    }
}

/// Stands for what the tables do not have; nothing that was read is without name.
const NAMELESS: &str = "?";

impl Display for GroundText<'_, '_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(
            f,
            "{}({}",
            if self.negated { "(not " } else { "" },
            self.name
        )?;
        for id in self.objects.as_slice() {
            let object = self.problem.objects().get(usize::from(id.0));
            write!(f, " {}", object.map_or(NAMELESS, |o| o.name))?;
        }
        f.write_str(if self.negated { "))" } else { ")" })
    }
}

impl Display for Problem<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let domain = self.domain();
        writeln!(f, "(define (problem {})", self.name())?;
        write!(f, "  (:domain {})", domain.name())?;
        let own = |o: &&Object<'_>| domain.declared.find_constant(o.name).is_none();
        let objects = self.objects().iter().filter(own);
        write_section(f, "  (:objects", objects, |f, object| {
            let kind = self.type_name(object.type_id);
            write!(f, "{} - {}", object.name, kind.unwrap_or(NAMELESS))
        })?;
        f.write_str("\n  (:init")?;
        for atom in self.initial() {
            write!(f, "\n    {}", self.atom_text(atom))?;
        }
        let functions = self.facts().iter().skip(self.initial().count());
        for fact in functions {
            write!(f, "\n    (= {} ", self.atom_text(&fact.atom))?;
            match fact.number {
                Some(number) => write!(f, "{number})")?,
                None => f.write_str("-1)")?,
            }
        }
        f.write_str(")\n  (:goal")?;
        let writer = Writer {
            view: self.goal(),
            domain,
            problem: Some(self),
        };
        writer.write(f, 0, &mut Vec::new())?;
        f.write_str(if self.minimizes_cost() {
            ")\n  (:metric minimize (total-cost)))\n"
        } else {
            "))\n"
        })
    }
}

impl Display for Domain<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        writeln!(f, "(define (domain {})", self.name())?;
        f.write_str("  (:requirements :adl :action-costs)")?;
        // The first type is `object`, which is not declared.
        let declared = self.types().iter().enumerate().skip(1);
        let declared = declared.filter(|(_, t)| !t.is_either());
        write_section(f, "  (:types", declared, |f, (place, own)| {
            self.write_supertypes(f, TypeId(place as u8), own)
        })?;
        write_section(f, "  (:constants", self.constants().iter(), |f, o| {
            self.write_typed(f, o.name, o.type_id)
        })?;
        for (open, table) in [
            ("  (:predicates", &self.declared.predicates[..]),
            ("  (:functions", &self.declared.functions[..]),
        ] {
            write_section(f, open, table.iter(), |f, p| {
                write!(f, "({}", p.name)?;
                for argument in self.arguments(p) {
                    f.write_str(" ")?;
                    self.write_typed(f, argument.name, argument.type_id)?;
                }
                f.write_str(")")
            })?;
        }
        for action in self.actions() {
            self.write_action(f, action)?;
        }
        f.write_str(")\n")
    }
}

impl<'t> Domain<'t> {
    fn writer(&self) -> Writer<'_, 't> {
        Writer {
            view: self.view(),
            domain: self,
            problem: None,
        }
    }

    fn type_name(&self, TypeId(place): TypeId) -> &str {
        let declared = self.types().get(usize::from(place));
        declared.map_or(NAMELESS, |t| t.name)
    }

    fn write_typed(&self, f: &mut Formatter<'_>, name: &str, type_id: TypeId) -> Result {
        write!(f, "{name} - {}", self.type_name(type_id))
    }

    /// A type, and first of all the supertype that was declared first.
    fn write_supertypes(&self, f: &mut Formatter<'_>, id: TypeId, own: &Type<'_>) -> Result {
        self.write_typed(f, own.name, own.parent)?;
        let all = (0..).map(TypeId).zip(self.types());
        for (above, other) in all.skip(1) {
            let also = self.is_subtype(id, above) && !self.is_subtype(own.parent, above);
            if also && above != id && !other.is_either() {
                write!(f, " {} - {}", own.name, other.name)?;
            }
        }
        Ok(())
    }

    fn write_action(&self, f: &mut Formatter<'_>, action: &Action<'_>) -> Result {
        write!(f, "\n  (:action {}\n    :parameters (", action.name)?;
        for (i, parameter) in self.parameters(action).iter().enumerate() {
            f.write_str(if i == 0 { "" } else { " " })?;
            self.write_typed(f, parameter.name, parameter.type_id)?;
        }
        f.write_str(")")?;
        for (keyword, place) in [
            (":precondition", action.precondition),
            (":effect", action.effect),
        ] {
            write!(f, "\n    {keyword}")?;
            let mut scope = Vec::new();
            for parameter in self.parameters(action) {
                // A scope has room for all parameters of an action.
                let _ = scope.push(*parameter);
            }
            self.writer().write(f, place, &mut scope)?;
        }
        f.write_str(")")
    }

    /// The name of a predicate or a function.
    fn predicate_name(&self, predicate: PredicateId) -> &str {
        let place = usize::from(predicate.0);
        let functions = place.checked_sub(super::schema::MAX_PREDICATES);
        let found = match functions {
            Some(function) => self.declared.functions.get(function),
            None => self.predicates().get(place),
        };
        found.map_or(NAMELESS, |p| p.name)
    }
}

/// Writes formulas, of a domain or of a problem.
struct Writer<'a, 't> {
    view: View<'a, 't>,
    domain: &'a Domain<'t>,
    problem: Option<&'a Problem<'t>>,
}

impl<'t> Writer<'_, 't> {
    fn type_name(&self, type_id: TypeId) -> &str {
        match self.problem {
            Some(problem) => problem.type_name(type_id).unwrap_or(NAMELESS),
            None => self.domain.type_name(type_id),
        }
    }

    fn object(&self, term: Term) -> Option<&str> {
        let object = match term {
            Term::Constant(place) => self.domain.constants().get(usize::from(place)),
            Term::Object(id) => self.problem?.objects().get(usize::from(id.0)),
            Term::Variable(_) => None,
        };
        object.map(|object| object.name)
    }

    fn write(
        &self,
        f: &mut Formatter<'_>,
        place: u16,
        scope: &mut Vec<Variable<'t>, MAX_BOUND>,
    ) -> Result {
        let Some(node) = self.view.node(place) else {
            return Ok(());
        };
        let outside = scope.len();
        f.write_str(" (")?;
        match node.kind {
            Kind::And => f.write_str("and")?,
            Kind::Or => f.write_str("or")?,
            Kind::Not => f.write_str("not")?,
            Kind::Imply => f.write_str("imply")?,
            Kind::When => f.write_str("when")?,
            Kind::Forall | Kind::Exists => {
                let word = if node.kind == Kind::Forall {
                    "forall"
                } else {
                    "exists"
                };
                write!(f, "{word} (")?;
                for variable in self.view.variables(node) {
                    write!(
                        f,
                        "{} - {} ",
                        variable.name,
                        self.type_name(variable.type_id)
                    )?;
                    let _ = scope.push(*variable);
                }
                f.write_str(")")?;
            }
            Kind::Atom(predicate) => {
                self.write_words(f, self.domain.predicate_name(predicate), place, scope)?
            }
            Kind::Equal => self.write_words(f, "=", place, scope)?,
            Kind::Increase(amount) => write!(f, "increase (total-cost) {amount}")?,
            Kind::IncreaseBy(function) => {
                f.write_str("increase (total-cost) (")?;
                self.write_words(f, self.domain.predicate_name(function), place, scope)?;
                f.write_str(")")?;
            }
        }
        for child in self.view.children(place) {
            self.write(f, child, scope)?;
        }
        scope.truncate(outside);
        f.write_str(")")
    }

    fn write_words(
        &self,
        f: &mut Formatter<'_>,
        head: &str,
        place: u16,
        scope: &Vec<Variable<'t>, MAX_BOUND>,
    ) -> Result {
        f.write_str(head)?;
        let node = self.view.node(place);
        for term in node.map_or(&[][..], |node| self.view.terms(node)) {
            let name = match term {
                Term::Variable(place) => scope.get(usize::from(*place)).map(|v| v.name),
                term => self.object(*term),
            };
            write!(f, " {}", name.unwrap_or(NAMELESS))?;
        }
        Ok(())
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
