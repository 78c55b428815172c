//! Problems: objects, what holds initially, and the goal.

use super::reader::{Reader, name};
use super::schema::{Domain, Object, compare};
use crate::error::Error;
use crate::table::{Table, move_last};
use crate::task::{Arguments, GroundAtom, MAX_GOAL_ATOMS, ObjectId, TypeId};
use heapless::Vec;

/// Most objects of a problem, the constants of its domain among them.
pub const MAX_OBJECTS: usize = 64;

/// A problem of a [`Domain`]. Its names are slices of its text; `Display` writes it
/// as PDDL.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem<'t> {
    name: &'t str,
    domain: &'t Domain<'t>,
    objects: Vec<Object<'t>, MAX_OBJECTS>,
    initial: &'t [GroundAtom],
    goal: Vec<GroundAtom, MAX_GOAL_ATOMS>,
}

impl<'t> Problem<'t> {
    /// Reads a problem from its text; the grammar stands at the head of the
    /// [module](super#the-language). `memory` keeps what holds initially: one slot
    /// for each atom of `:init`.
    ///
    /// # Errors
    /// [`Error::Syntax`] with line and column, also where [`MAX_OBJECTS`],
    /// [`MAX_GOAL_ATOMS`] or the memory is exceeded.
    pub fn parse(
        domain: &'t Domain<'t>,
        text: &'t str,
        memory: &'t mut [GroundAtom],
    ) -> Result<Self, Error> {
        let (mut reader, name) = Reader::begin(
            text,
            "problem",
            "expected `(define (problem`, a name and `)`",
        )?;
        let mut problem = Problem {
            name,
            domain,
            objects: Vec::new(),
            initial: &[],
            goal: Vec::new(),
        };
        problem.read_domain_name(&mut reader)?;
        reader.requirements()?;
        for constant in &domain.constants {
            problem.push_object(&reader, *constant)?;
        }
        if reader.section(":objects") {
            problem.read_objects(&mut reader)?;
        }
        let mut initial = Table::new(memory, "atoms that hold initially");
        problem.read_initial(&mut reader, &mut initial)?;
        problem.initial = initial.into_slice();
        problem.read_goal(&mut reader)?;
        reader.end("expected `)` behind the goal")?;
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
            .filter(move |(_, object)| self.domain.is_subtype(object.type_id, type_id))
            .map(|(id, _)| id)
    }

    /// The object with this name.
    pub fn find_object(&self, name: &str) -> Option<ObjectId> {
        let place = self.search(name).ok()?;
        u8::try_from(place).ok().map(ObjectId)
    }

    /// What holds initially, each atom once and in order.
    pub fn initial(&self) -> &[GroundAtom] {
        self.initial
    }

    /// Whether an atom holds initially.
    pub fn holds_initially(&self, atom: &GroundAtom) -> bool {
        self.initial.binary_search(atom).is_ok()
    }

    /// What shall hold in the end, each atom once.
    pub fn goal(&self) -> &[GroundAtom] {
        &self.goal
    }

    fn read_domain_name(&mut self, reader: &mut Reader<'t>) -> Result<(), Error> {
        const WHAT: &str = "expected `(:domain`, the name of the domain and `)`";
        for word in ["(", ":domain"] {
            reader.expect(word, WHAT)?;
        }
        let at = reader.clone();
        let name = reader.expect_word(name, WHAT)?;
        if !name.eq_ignore_ascii_case(self.domain.name) {
            return Err(at.error("the problem belongs to another domain"));
        }
        reader.expect(")", WHAT)
    }

    fn read_objects(&mut self, reader: &mut Reader<'t>) -> Result<(), Error> {
        while let Some(entry) = reader.typed(name, "expected the name of an object or `)`")? {
            let object = Object {
                name: entry.name,
                type_id: self.domain.type_of(&entry)?,
            };
            self.push_object(&entry.at, object)?;
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

    fn read_initial(
        &self,
        reader: &mut Reader<'t>,
        initial: &mut Table<'t, GroundAtom>,
    ) -> Result<(), Error> {
        if !reader.section(":init") {
            return Err(reader.unexpected("expected `(:objects`, then `(:init`"));
        }
        while !reader.accept(")") {
            reader.expect("(", "expected `(` and a predicate, or `)`")?;
            let at = reader.clone();
            let atom = self.read_atom(reader)?;
            if let Err(place) = initial.as_slice().binary_search(&atom) {
                initial.push(atom).map_err(|_| {
                    at.error("no room left: lend more memory for what holds initially")
                })?;
                move_last(initial.as_mut_slice(), place);
            }
        }
        Ok(())
    }

    fn read_goal(&mut self, reader: &mut Reader<'t>) -> Result<(), Error> {
        if !reader.section(":goal") {
            return Err(reader.unexpected("expected `(:goal`"));
        }
        reader.conjunction(|reader| {
            let at = reader.clone();
            let atom = self.read_atom(reader)?;
            if self.goal.contains(&atom) {
                return Ok(());
            }
            self.goal
                .push(atom)
                .map_err(|_| at.error("no room left: too many atoms in the goal"))
        })?;
        reader.expect(
            ")",
            "expected `)`: a goal is one atom or an `and` of several",
        )
    }

    fn read_atom(&self, reader: &mut Reader<'t>) -> Result<GroundAtom, Error> {
        let (predicate, objects) = self.domain.read_application(reader, |reader| {
            let at = reader.clone();
            let name = reader.expect_word(name, "expected the name of an object")?;
            let id = self.find_object(name);
            let found = id.and_then(|id| Some((id, self.objects.get(usize::from(id.0))?)));
            let (id, object) = found.ok_or_else(|| at.error("unknown object"))?;
            Ok((id, object.type_id))
        })?;
        Ok(GroundAtom {
            predicate,
            objects: Arguments::new(objects.iter().copied())?,
        })
    }
}
