//! Reads a domain; the grammar stands at the head of the parent module.

use super::reader::{Reader, Typed, name, variable};
use super::schema::{
    Action, Domain, Literal, OBJECT, Object, Part, Predicate, Relation, Span, Term, Type, Variable,
    index_of,
};
use crate::error::Error;
use crate::task::{MAX_ARGUMENTS, PredicateId, TypeId};
use heapless::Vec;

const DECLARED_TWICE: &str = "this name is declared already";
const TOO_MANY_ARGUMENTS: &str = "no room left: too many arguments of one predicate or action";

/// The terms of a literal.
type Terms = Vec<Term, MAX_ARGUMENTS, u8>;

impl<'t> Domain<'t> {
    /// Reads a domain from its text; the grammar stands at the head of the
    /// [module](super#the-language).
    ///
    /// # Errors
    /// [`Error::Syntax`] with line and column, also where one of the `MAX_`
    /// constants of this module or [`MAX_ARGUMENTS`] is exceeded.
    pub fn parse(text: &'t str) -> Result<Self, Error> {
        let (mut reader, name) =
            Reader::begin(text, "domain", "expected `(define (domain`, a name and `)`")?;
        let mut domain = Domain {
            name,
            types: Vec::new(),
            constants: Vec::new(),
            predicates: Vec::new(),
            actions: Vec::new(),
            variables: Vec::new(),
            literals: Vec::new(),
        };
        domain.push_type(&reader, "object", OBJECT)?;
        reader.requirements()?;
        if reader.section(":types") {
            domain.read_types(&mut reader)?;
        }
        if reader.section(":constants") {
            domain.read_constants(&mut reader)?;
        }
        if reader.section(":predicates") {
            domain.read_predicates(&mut reader)?;
        }
        while reader.section(":action") {
            domain.read_action(&mut reader)?;
        }
        reader.end(
            "expected `:requirements`, `:types`, `:constants` and `:predicates` in this \
             order, then each `:action`, then `)`",
        )?;
        Ok(domain)
    }

    /// Types may stand before their supertypes, so the section is read twice:
    /// first all names, then what each is a subtype of.
    fn read_types(&mut self, reader: &mut Reader<'t>) -> Result<(), Error> {
        const WHAT: &str = "expected the name of a type or `)`";
        let mut again = reader.clone();
        while let Some(entry) = reader.typed(name, WHAT)? {
            if self.find_type(entry.name).is_some() {
                return Err(entry.at.error(DECLARED_TWICE));
            }
            self.push_type(&entry.at, entry.name, OBJECT)?;
        }
        while let Some(entry) = again.typed(name, WHAT)? {
            let parent = self.type_of(&entry)?;
            let (Some(type_at), Some(own)) = (entry.type_at, self.find_type(entry.name)) else {
                continue;
            };
            if self.is_subtype(parent, own) {
                return Err(type_at.error("a type cannot be a subtype of itself"));
            }
            if let Some(own) = self.types.get_mut(usize::from(own.0)) {
                own.parent = parent;
            }
        }
        Ok(())
    }

    fn push_type(&mut self, at: &Reader<'t>, name: &'t str, parent: TypeId) -> Result<(), Error> {
        self.types
            .push(Type { name, parent })
            .map_err(|_| at.error("no room left: too many types"))
    }

    fn read_constants(&mut self, reader: &mut Reader<'t>) -> Result<(), Error> {
        while let Some(entry) = reader.typed(name, "expected the name of a constant or `)`")? {
            if self.find_constant(entry.name).is_some() {
                return Err(entry.at.error(DECLARED_TWICE));
            }
            let constant = Object {
                name: entry.name,
                type_id: self.type_of(&entry)?,
            };
            self.constants
                .push(constant)
                .map_err(|_| entry.at.error("no room left: too many constants"))?;
        }
        Ok(())
    }

    fn read_predicates(&mut self, reader: &mut Reader<'t>) -> Result<(), Error> {
        while !reader.accept(")") {
            reader.expect("(", "expected `(` and a predicate, or `)`")?;
            let at = reader.clone();
            let name = reader.expect_word(name, "expected the name of a predicate")?;
            if ["and", "not"].iter().any(|w| w.eq_ignore_ascii_case(name)) {
                return Err(at.error("this is a word of the language"));
            }
            if self.find_predicate(name).is_some() {
                return Err(at.error(DECLARED_TWICE));
            }
            let predicate = Predicate {
                name,
                is_static: true,
                arguments: self.read_variables(reader)?,
            };
            self.predicates
                .push(predicate)
                .map_err(|_| at.error("no room left: too many predicates"))?;
        }
        Ok(())
    }

    /// A typed list of variables and the bracket behind it.
    fn read_variables(&mut self, reader: &mut Reader<'t>) -> Result<Span, Error> {
        let first = self.variables.len();
        while let Some(entry) = reader.typed(variable, "expected a variable, as `?x`, or `)`")? {
            let own = Span::since(first, &self.variables).of(&self.variables);
            if index_of(own.iter().map(|v| v.name), entry.name).is_some() {
                return Err(entry.at.error(DECLARED_TWICE));
            }
            if own.len() == MAX_ARGUMENTS {
                return Err(entry.at.error(TOO_MANY_ARGUMENTS));
            }
            let variable = Variable {
                name: entry.name,
                type_id: self.type_of(&entry)?,
            };
            self.variables.push(variable).map_err(|_| {
                entry
                    .at
                    .error("no room left: too many arguments of all predicates and actions")
            })?;
        }
        Ok(Span::since(first, &self.variables))
    }

    fn read_action(&mut self, reader: &mut Reader<'t>) -> Result<(), Error> {
        let at = reader.clone();
        let name = reader.expect_word(name, "expected the name of an action")?;
        if self.find_action(name).is_some() {
            return Err(at.error(DECLARED_TWICE));
        }
        for word in [":parameters", "("] {
            reader.expect(word, "expected `:parameters (`")?;
        }
        let parameters = self.read_variables(reader)?;
        let first = self.literals.len();
        for (keyword, part) in [
            (":precondition", Part::Precondition),
            (":effect", Part::Effect),
        ] {
            if reader.accept(keyword) {
                reader.conjunction(|reader| self.read_literal(reader, parameters, part))?;
            }
        }
        reader.expect(")", "expected `:precondition`, then `:effect`, then `)`")?;
        let action = Action {
            name,
            parameters,
            literals: Span::since(first, &self.literals),
        };
        self.actions
            .push(action)
            .map_err(|_| at.error("no room left: too many actions"))
    }

    fn read_literal(
        &mut self,
        reader: &mut Reader<'t>,
        scope: Span,
        part: Part,
    ) -> Result<(), Error> {
        let negated = reader.accept("not");
        if negated {
            reader.expect("(", "expected `(` behind `not`")?;
        }
        let at = reader.clone();
        let (relation, terms) = self.read_relation(reader, scope, part)?;
        if negated {
            reader.expect(")", "expected `)` behind what is negated")?;
        }
        if let Relation::Predicate(predicate) = relation {
            match self.predicates.get_mut(usize::from(predicate.0)) {
                Some(changed) if part == Part::Effect => changed.is_static = false,
                _ if negated => {
                    let what = "a negative precondition is not supported, except of `=`";
                    return Err(at.error(what));
                }
                _ => {}
            }
        }
        let literal = Literal {
            part,
            negated,
            relation,
            terms,
        };
        self.literals
            .push(literal)
            .map_err(|_| at.error("no room left: too many preconditions and effects"))
    }

    /// A predicate or, in a precondition, an equality, and the closing bracket.
    fn read_relation(
        &self,
        reader: &mut Reader<'t>,
        scope: Span,
        part: Part,
    ) -> Result<(Relation, Terms), Error> {
        if part == Part::Precondition && reader.accept("=") {
            let (left, _) = self.read_term(reader, scope)?;
            let (right, _) = self.read_term(reader, scope)?;
            reader.expect(")", "expected `)` behind two terms")?;
            return Ok((Relation::Equality, Vec::from_array([left, right])));
        }
        let (predicate, terms) =
            self.read_application(reader, |reader| self.read_term(reader, scope))?;
        Ok((Relation::Predicate(predicate), terms))
    }

    /// A predicate, its arguments as `argument` reads them, each with its type, and
    /// the closing bracket.
    pub(super) fn read_application<T>(
        &self,
        reader: &mut Reader<'t>,
        mut argument: impl FnMut(&mut Reader<'t>) -> Result<(T, TypeId), Error>,
    ) -> Result<(PredicateId, Vec<T, MAX_ARGUMENTS, u8>), Error> {
        let at = reader.clone();
        let name = reader.expect_word(name, "expected the name of a predicate")?;
        let id = self.find_predicate(name);
        let id = id.ok_or_else(|| at.unexpected("unknown predicate"))?;
        let declared = self.predicates.get(usize::from(id.0));
        let mut arguments = Vec::new();
        for declared in declared.map_or(&[][..], |p| self.arguments(p)) {
            let at = reader.clone();
            let (value, type_id) = argument(reader)?;
            if !self.is_subtype(type_id, declared.type_id) {
                return Err(at.error("this is not of the type that the predicate declares"));
            }
            // There is room: a predicate has at most as many arguments.
            arguments
                .push(value)
                .map_err(|_| at.error(TOO_MANY_ARGUMENTS))?;
        }
        reader.expect(")", "expected `)`: the predicate has no more arguments")?;
        Ok((id, arguments))
    }

    /// A parameter of the action or a constant, with its type.
    fn read_term(&self, reader: &mut Reader<'t>, scope: Span) -> Result<(Term, TypeId), Error> {
        let at = reader.clone();
        let scope = scope.of(&self.variables);
        if let Some(name) = reader.accept_word(variable) {
            let place = index_of(scope.iter().map(|v| v.name), name);
            let found = place.and_then(|p| Some((p, scope.get(usize::from(p))?)));
            let (place, variable) = found.ok_or_else(|| at.error("unknown variable"))?;
            return Ok((Term::Parameter(place), variable.type_id));
        }
        let name = reader.expect_word(name, "expected a variable or a constant")?;
        let found = self.find_constant(name);
        let (place, constant) = found.ok_or_else(|| at.error("unknown constant"))?;
        Ok((Term::Constant(place), constant.type_id))
    }

    /// The type of an entry of a typed list.
    pub(super) fn type_of(&self, entry: &Typed<'t>) -> Result<TypeId, Error> {
        let Some(type_at) = &entry.type_at else {
            return Ok(OBJECT);
        };
        let name = type_at
            .clone()
            .expect_word(name, "expected the name of a type")?;
        self.find_type(name)
            .ok_or_else(|| type_at.error("unknown type"))
    }
}
