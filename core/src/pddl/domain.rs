//! Reads a domain; the grammar stands at the head of the parent module.

use super::formula::{FormulaReader, Formulas, Part, Term};
use super::reader::{Reader, Section, name, variable};
use super::schema::{
    Action, DECLARED_TWICE, Declarations, Domain, Object, Predicate, Span, Variable, index_of,
};
use super::types::{Types, push_variable};
use crate::error::Error;
use heapless::Vec;

const SECTIONS: &str = "expected `(:types`, `(:constants`, `(:predicates`, `(:functions`, \
    `(:action` or `)`";

/// Words that are no names of predicates.
const WORDS: [&str; 7] = ["and", "or", "not", "imply", "forall", "exists", "when"];

impl<'t> Domain<'t> {
    /// Reads a domain from its text; the grammar stands at the head of the
    /// [module](super#the-language).
    ///
    /// # Errors
    /// [`Error::Syntax`] with line and column, also where one of the `MAX_`
    /// constants of this module or [`MAX_ARGUMENTS`](crate::task::MAX_ARGUMENTS) is exceeded.
    pub fn parse(text: &'t str) -> Result<Self, Error> {
        let (reader, name) =
            Reader::begin(text, "domain", "expected `(define (domain`, a name and `)`")?;
        let mut domain = Domain {
            name,
            types: Types::new(&reader)?,
            declared: Declarations::default(),
            actions: Vec::new(),
            formulas: Formulas::default(),
        };
        domain.read_declarations(&reader)?;
        reader.sections(SECTIONS, |keyword, reader| {
            if !keyword.eq_ignore_ascii_case(":action") {
                return Ok(Section::Skip);
            }
            domain.read_action(reader)?;
            Ok(Section::Read)
        })?;
        Ok(domain)
    }

    /// Reads everything but actions. Sections may stand in any order, so those are read
    /// first that others need.
    fn read_declarations(&mut self, reader: &Reader<'t>) -> Result<(), Error> {
        for wanted in [":types", ":constants", ":predicates", ":functions"] {
            reader.sections(SECTIONS, |keyword, reader| {
                if !keyword.eq_ignore_ascii_case(wanted) {
                    return Ok(other_section(keyword));
                }
                let (types, declared) = (&mut self.types, &mut self.declared);
                match wanted {
                    ":types" => types.read(reader)?,
                    ":constants" => declared.read_constants(types, reader)?,
                    ":predicates" => declared.read_predicates(types, reader)?,
                    _ => declared.read_functions(types, reader)?,
                }
                Ok(Section::Read)
            })?;
        }
        Ok(())
    }

    fn read_action(&mut self, reader: &mut Reader<'t>) -> Result<(), Error> {
        let at = reader.clone();
        let name = reader.expect_word(name, "expected the name of an action")?;
        if self.find_action(name).is_some() {
            return Err(at.error(DECLARED_TWICE));
        }
        let parts = ActionParts::read(reader)?;
        let declared = &self.declared;
        let named = |name: &str| {
            let (place, constant) = declared.find_constant(name)?;
            Some((Term::Constant(place), constant.type_id))
        };
        let sheet = self.formulas.sheet();
        let parameters = match parts.parameters {
            Some(mut reader) => self.types.read_variables(&mut reader, sheet.variables)?,
            None => Span::default(),
        };
        let mut formulas = FormulaReader {
            scope: Vec::from_slice(parameters.of(sheet.variables)).unwrap_or_default(),
            types: &mut self.types,
            declared,
            sheet,
            names: &named,
            changed: 0,
        };
        let mut read = |part: Option<Reader<'t>>, kind| match part {
            Some(mut reader) => formulas.read(&mut reader, kind, 0),
            None => formulas.nothing(&at),
        };
        let action = Action {
            name,
            parameters,
            precondition: read(parts.precondition, Part::Condition)?,
            effect: read(parts.effect, Part::Effect)?,
        };
        let changed = formulas.changed;
        for (place, predicate) in (0..).zip(&mut self.declared.predicates) {
            predicate.is_static &= changed.wrapping_shr(place) & 1 == 0;
        }
        self.actions
            .push(action)
            .map_err(|_| at.error("no room left: too many actions"))
    }
}

/// What to do with a section that is not wanted now.
fn other_section(keyword: &str) -> Section {
    const KNOWN: [&str; 6] = [
        ":requirements",
        ":types",
        ":constants",
        ":predicates",
        ":functions",
        ":action",
    ];
    match KNOWN
        .iter()
        .any(|known| known.eq_ignore_ascii_case(keyword))
    {
        true => Section::Skip,
        false => Section::Unknown,
    }
}

/// Where the parts of an action stand, in any order.
#[derive(Default)]
struct ActionParts<'t> {
    /// Behind the opening bracket.
    parameters: Option<Reader<'t>>,
    precondition: Option<Reader<'t>>,
    effect: Option<Reader<'t>>,
}

impl<'t> ActionParts<'t> {
    /// Finds the parts, and moves on behind the action.
    fn read(reader: &mut Reader<'t>) -> Result<Self, Error> {
        const WHAT: &str = "expected `:parameters`, `:precondition`, `:effect` or `)`";
        let mut parts = ActionParts::default();
        while !reader.accept(")") {
            let at = reader.clone();
            let keyword = reader.accept_keyword().ok_or_else(|| at.unexpected(WHAT))?;
            let mut inside = reader.clone();
            if keyword.eq_ignore_ascii_case(":parameters") {
                inside.expect("(", "expected `(` behind `:parameters`")?;
                parts.parameters = Some(inside);
            } else if keyword.eq_ignore_ascii_case(":precondition") {
                parts.precondition = Some(inside);
            } else if keyword.eq_ignore_ascii_case(":effect") {
                parts.effect = Some(inside);
            } else {
                return Err(at.refuse(keyword, WHAT));
            }
            reader.skip()?;
        }
        Ok(parts)
    }
}

impl<'t> Declarations<'t> {
    fn read_constants(
        &mut self,
        types: &mut Types<'t>,
        reader: &mut Reader<'t>,
    ) -> Result<(), Error> {
        while let Some(entry) = reader.typed(name, "expected the name of a constant or `)`")? {
            if self.find_constant(entry.name).is_some() {
                return Err(entry.at.error(DECLARED_TWICE));
            }
            let constant = Object {
                name: entry.name,
                type_id: types.of(&entry)?,
            };
            self.constants
                .push(constant)
                .map_err(|_| entry.at.error("no room left: too many constants"))?;
        }
        Ok(())
    }

    fn read_predicates(
        &mut self,
        types: &mut Types<'t>,
        reader: &mut Reader<'t>,
    ) -> Result<(), Error> {
        while !reader.accept(")") {
            reader.expect("(", "expected `(` and a predicate, or `)`")?;
            let at = reader.clone();
            let name = reader.expect_word(name, "expected the name of a predicate")?;
            if WORDS.iter().any(|w| w.eq_ignore_ascii_case(name)) {
                return Err(at.error("this is a word of the language"));
            }
            let known = self.predicates.iter().map(|p| p.name);
            if index_of(known, name).is_some() {
                return Err(at.error(DECLARED_TWICE));
            }
            let predicate = self.read_predicate(types, reader, name)?;
            self.predicates
                .push(predicate)
                .map_err(|_| at.error("no room left: too many predicates"))?;
        }
        Ok(())
    }

    /// Functions, each with the type that may stand behind it.
    fn read_functions(
        &mut self,
        types: &mut Types<'t>,
        reader: &mut Reader<'t>,
    ) -> Result<(), Error> {
        while !reader.accept(")") {
            reader.expect("(", "expected `(` and a function, or `)`")?;
            let at = reader.clone();
            let name = reader.expect_word(name, "expected the name of a function")?;
            let function = self.read_predicate(types, reader, name)?;
            if reader.accept("-") {
                reader.skip_type()?;
            }
            self.functions
                .push(function)
                .map_err(|_| at.error("no room left: too many functions"))?;
        }
        Ok(())
    }

    fn read_predicate(
        &mut self,
        types: &mut Types<'t>,
        reader: &mut Reader<'t>,
        name: &'t str,
    ) -> Result<Predicate<'t>, Error> {
        let first = self.variables.len();
        while let Some(entry) = reader.typed(variable, "expected a variable, as `?x`, or `)`")? {
            let variable = Variable {
                name: entry.name,
                type_id: types.of(&entry)?,
            };
            push_variable(&entry, first, variable, &mut self.variables)?;
        }
        Ok(Predicate {
            name,
            is_static: true,
            arguments: Span::since(first, &self.variables),
        })
    }
}
