//! Problems: objects, what holds initially, and the goal.

use super::formula::{FormulaReader, Formulas, Part, Term, View, whole_number};
use super::reader::{Reader, Section, name};
use super::schema::{Domain, MAX_CONSTANTS, Object, compare};
use super::types::Types;
use crate::error::Error;
use crate::table::{Table, move_last};
use crate::task::{Arguments, GroundAtom, MAX_ARGUMENTS, ObjectId, PredicateId, TypeId};
use heapless::Vec;

/// Most objects of a problem, the constants of its domain among them.
pub const MAX_OBJECTS: usize = 255;
/// Most atoms of a goal, words such as `and` among them.
pub const MAX_GOAL: usize = 128;

const MAX_GOAL_TERMS: usize = 256;
const MAX_GOAL_VARIABLES: usize = 16;

const SECTIONS: &str = "expected `(:domain`, `(:objects`, `(:init`, `(:goal`, `(:metric` or `)`";

/// What a problem says of the beginning: an atom, or the number of a function.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Fact {
    pub(super) atom: GroundAtom,
    /// The number; `None` if it is no whole one that a cost can be.
    pub(super) number: Option<u32>,
}

/// A problem of a [`Domain`]. Its names are slices of its text; `Display` writes it
/// as PDDL.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem<'t> {
    name: &'t str,
    domain: &'t Domain<'t>,
    /// The types of the domain, and each `(either ...)` of the problem.
    types: Types<'t>,
    objects: Vec<Object<'t>, MAX_OBJECTS>,
    /// The objects that the constants of the domain are.
    constants: Vec<ObjectId, MAX_CONSTANTS>,
    facts: &'t [Fact],
    goal: Formulas<'t, MAX_GOAL, MAX_GOAL_TERMS, MAX_GOAL_VARIABLES>,
    minimizes_cost: bool,
}

impl<'t> Problem<'t> {
    /// Reads a problem from its text; the grammar stands at the head of the
    /// [module](super#the-language). `memory` keeps what holds initially: one slot
    /// for each atom of `:init`, and for each number of a function.
    ///
    /// # Errors
    /// [`Error::Syntax`] with line and column, also where [`MAX_OBJECTS`],
    /// [`MAX_GOAL`] or the memory is exceeded.
    pub fn parse(
        domain: &'t Domain<'t>,
        text: &'t str,
        memory: &'t mut [Fact],
    ) -> Result<Self, Error> {
        let (reader, name) = Reader::begin(
            text,
            "problem",
            "expected `(define (problem`, a name and `)`",
        )?;
        let mut problem = Problem {
            name,
            domain,
            types: domain.types.clone(),
            objects: Vec::new(),
            constants: Vec::new(),
            facts: &[],
            goal: Formulas::default(),
            minimizes_cost: false,
        };
        problem.read_objects(&reader)?;
        let mut facts = Table::new(memory, "atoms that hold initially");
        problem.read_rest(&reader, &mut facts)?;
        problem.facts = facts.into_slice();
        Ok(problem)
    }

    /// Its name.
    pub fn name(&self) -> &'t str {
        self.name
    }

    /// Its domain.
    pub fn domain(&self) -> &'t Domain<'t> {
        self.domain
    }

    /// The objects and the domain's constants in the order of their names; an
    /// [`ObjectId`] is an index.
    pub fn objects(&self) -> &[Object<'t>] {
        &self.objects
    }

    /// The objects of a type or one of its subtypes, in order.
    pub fn of_type(&self, type_id: TypeId) -> impl Iterator<Item = ObjectId> {
        (0..)
            .map(ObjectId)
            .zip(&self.objects)
            .filter(move |(_, object)| self.types.is_subtype(object.type_id, type_id))
            .map(|(id, _)| id)
    }

    /// The object with this name.
    pub fn find_object(&self, name: &str) -> Option<ObjectId> {
        let place = self.search(name).ok()?;
        u8::try_from(place).ok().map(ObjectId)
    }

    /// What holds initially, each atom once and in order.
    pub fn initial(&self) -> impl Iterator<Item = &GroundAtom> {
        let predicates = self.domain.predicates().len();
        let atoms = self.facts.iter().map(|fact| &fact.atom);
        atoms.take_while(move |atom| usize::from(atom.predicate.0) < predicates)
    }

    /// How many [`Fact`]s it takes memory for.
    pub fn fact_count(&self) -> usize {
        self.facts.len()
    }

    /// Whether an atom holds initially.
    pub fn holds_initially(&self, atom: &GroundAtom) -> bool {
        self.fact(atom).is_some()
    }

    /// Whether the costs of actions are to be minimised, and not their number.
    pub fn minimizes_cost(&self) -> bool {
        self.minimizes_cost
    }

    /// The number of a function for some objects.
    pub(super) fn number(&self, atom: &GroundAtom) -> Option<u32> {
        self.fact(atom)?.number
    }

    fn fact(&self, atom: &GroundAtom) -> Option<&Fact> {
        let place = self.facts.binary_search_by(|fact| fact.atom.cmp(atom));
        self.facts.get(place.ok()?)
    }

    /// What is said of the beginning, in order.
    pub(super) fn facts(&self) -> &'t [Fact] {
        self.facts
    }

    /// The formula of the goal; it begins at the first node.
    pub(super) fn goal(&self) -> View<'_, 't> {
        self.goal.view()
    }

    /// The name of a type.
    pub(super) fn type_name(&self, TypeId(place): TypeId) -> Option<&'t str> {
        self.types
            .as_slice()
            .get(usize::from(place))
            .map(|t| t.name)
    }

    /// The object of a constant of the domain.
    pub(super) fn constant(&self, place: u8) -> Option<ObjectId> {
        self.constants.get(usize::from(place)).copied()
    }

    /// All objects, before what is said about them.
    fn read_objects(&mut self, reader: &Reader<'t>) -> Result<(), Error> {
        for constant in self.domain.constants() {
            self.push_object(reader, *constant)?;
        }
        reader.sections(SECTIONS, |keyword, reader| {
            if !keyword.eq_ignore_ascii_case(":objects") {
                return Ok(Section::Skip);
            }
            while let Some(entry) = reader.typed(name, "expected the name of an object or `)`")? {
                let object = Object {
                    name: entry.name,
                    type_id: self.types.of(&entry)?,
                };
                if self.domain.declared.find_constant(object.name).is_none() {
                    self.push_object(&entry.at, object)?;
                }
            }
            Ok(Section::Read)
        })?;
        for constant in self.domain.constants() {
            let id = self.find_object(constant.name).unwrap_or_default();
            // There are as many places as a domain has constants.
            let full = |_| reader.error("no room left: too many constants");
            self.constants.push(id).map_err(full)?;
        }
        Ok(())
    }

    fn push_object(&mut self, at: &Reader<'t>, object: Object<'t>) -> Result<(), Error> {
        let Err(place) = self.search(object.name) else {
            return Err(at.error("this name is declared already"));
        };
        self.objects
            .push(object)
            .map_err(|_| at.error("no room left: too many objects"))?;
        move_last(&mut self.objects, place);
        Ok(())
    }

    /// The place of an object, or where it belongs.
    fn search(&self, name: &str) -> Result<usize, usize> {
        self.objects.binary_search_by(|o| compare(o.name, name))
    }

    fn read_rest(&mut self, reader: &Reader<'t>, facts: &mut Table<'t, Fact>) -> Result<(), Error> {
        let (mut domain, mut initial, mut goal) = (false, false, false);
        reader.sections(SECTIONS, |keyword, reader| {
            let is = |word: &str| keyword.eq_ignore_ascii_case(word);
            if is(":domain") {
                domain = true;
                self.read_domain_name(reader)?;
            } else if is(":init") {
                initial = true;
                self.read_initial(reader, facts)?;
            } else if is(":goal") {
                goal = true;
                self.read_goal(reader)?;
            } else if is(":metric") {
                self.read_metric(reader)?;
            } else if [":objects", ":requirements", ":length", ":situation"]
                .iter()
                .any(|word| is(word))
            {
                return Ok(Section::Skip);
            } else {
                return Ok(Section::Unknown);
            }
            Ok(Section::Read)
        })?;
        let missing = [
            (domain, "the problem has no `(:domain ...)`"),
            (initial, "the problem has no `(:init ...)`"),
            (goal, "the problem has no `(:goal ...)`"),
        ];
        match missing.iter().find(|(found, _)| !found) {
            Some((_, what)) => Err(reader.error(what)),
            None => Ok(()),
        }
    }

    fn read_domain_name(&self, reader: &mut Reader<'t>) -> Result<(), Error> {
        const WHAT: &str = "expected the name of the domain and `)`";
        let at = reader.clone();
        let name = reader.expect_word(name, WHAT)?;
        if !name.eq_ignore_ascii_case(self.domain.name) {
            return Err(at.error("the problem belongs to another domain"));
        }
        reader.expect(")", WHAT)
    }

    /// Costs count, or the number of actions.
    fn read_metric(&mut self, reader: &mut Reader<'t>) -> Result<(), Error> {
        const WHAT: &str = "expected `minimize (total-cost)`, or no metric: then plans are short";
        for word in ["minimize", "("] {
            reader.expect(word, WHAT)?;
        }
        self.minimizes_cost = reader.accept("total-cost");
        if !self.minimizes_cost {
            reader.expect("total-time", WHAT)?;
        }
        for _ in 0..2 {
            reader.expect(")", WHAT)?;
        }
        Ok(())
    }

    fn read_initial(
        &self,
        reader: &mut Reader<'t>,
        facts: &mut Table<'t, Fact>,
    ) -> Result<(), Error> {
        while !reader.accept(")") {
            reader.expect("(", "expected `(` and a predicate, or `)`")?;
            let at = reader.clone();
            let fact = if reader.accept("=") {
                Some(self.read_number(reader)?)
            } else if reader.accept("not") {
                // What is not said does not hold.
                reader.expect("(", "expected `(` behind `not`")?;
                self.read_atom(reader, false)?;
                reader.expect(")", "expected `)` behind what is negated")?;
                None
            } else {
                let (atom, number) = (self.read_atom(reader, false)?, None);
                Some(Fact { atom, number })
            };
            let places = facts.as_slice();
            if let Some(fact) = fact
                && let Err(place) = places.binary_search_by(|known| known.atom.cmp(&fact.atom))
            {
                facts.push(fact).map_err(|_| {
                    at.error("no room left: lend more memory for what holds initially")
                })?;
                move_last(facts.as_mut_slice(), place);
            }
        }
        Ok(())
    }

    /// A function and its number, behind `=`.
    fn read_number(&self, reader: &mut Reader<'t>) -> Result<Fact, Error> {
        const WHAT: &str = "expected a function and a number";
        reader.expect("(", WHAT)?;
        let atom = self.read_atom(reader, true)?;
        let negative = reader.accept("-");
        let word = reader.expect_word(name, WHAT)?;
        reader.expect(")", "expected `)` behind the number")?;
        let number = whole_number(word).filter(|_| !negative);
        Ok(Fact { atom, number })
    }

    fn read_goal(&mut self, reader: &mut Reader<'t>) -> Result<(), Error> {
        let objects = &self.objects;
        let named = |name: &str| {
            let place = objects.binary_search_by(|o| compare(o.name, name)).ok()?;
            let object = objects.get(place)?;
            let id = ObjectId(u8::try_from(place).ok()?);
            Some((Term::Object(id), object.type_id))
        };
        self.goal = Formulas::default();
        let mut formulas = FormulaReader {
            types: &mut self.types,
            declared: &self.domain.declared,
            sheet: self.goal.sheet(),
            names: &named,
            scope: Vec::new(),
            changed: 0,
        };
        formulas.read(reader, Part::Condition, 0)?;
        reader.expect(
            ")",
            "expected `)`: a goal is one condition, or an `and` of several",
        )
    }

    /// An atom, or a function with its arguments.
    fn read_atom(&self, reader: &mut Reader<'t>, function: bool) -> Result<GroundAtom, Error> {
        let mut objects = Vec::<ObjectId, MAX_ARGUMENTS>::new();
        let mut object = |reader: &mut Reader<'t>, declared: TypeId| {
            let at = reader.clone();
            let name = reader.expect_word(name, "expected the name of an object")?;
            let id = self.find_object(name);
            let found = id.and_then(|id| Some((id, self.objects.get(usize::from(id.0))?)));
            let (id, own) = found.ok_or_else(|| at.error("unknown object"))?;
            if !self.types.is_subtype(own.type_id, declared) {
                return Err(at.error("this is not of the type that the predicate declares"));
            }
            let full = |_| at.error("no room left: too many arguments of one predicate");
            objects.push(id).map_err(full)
        };
        let predicate: PredicateId =
            self.domain
                .declared
                .read_application(reader, function, &mut object)?;
        Ok(GroundAtom {
            predicate,
            objects: Arguments::new(objects.iter().copied())?,
        })
    }
}
