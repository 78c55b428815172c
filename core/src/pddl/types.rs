//! The types of a domain.

use super::reader::{Reader, Typed, name, variable};
use super::schema::{DECLARED_TWICE, MAX_TYPES, Span, Variable, index_of};
use crate::error::Error;
use crate::task::{MAX_ARGUMENTS, TypeId};
use heapless::{Vec, VecView};

/// The type that everything has.
pub(super) const OBJECT: TypeId = TypeId(0);

/// A type of objects.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Type<'t> {
    /// Its name; or the words of an `(either ...)` that stands for a type.
    pub name: &'t str,
    /// Its supertype, the first if it has several; that of `object` is `object`.
    pub parent: TypeId,
    /// A bit for each type that it is a subtype of, itself among them.
    pub(super) above: u64,
}

impl Type<'_> {
    /// Whether it is an `(either ...)`.
    pub(super) fn is_either(&self) -> bool {
        self.name.as_bytes().first() == Some(&b'(')
    }
}

/// Types, `object` first.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Types<'t> {
    all: Vec<Type<'t>, MAX_TYPES>,
}

/// The bit of a type.
fn bit(TypeId(place): TypeId) -> u64 {
    1u64.checked_shl(place.into()).unwrap_or(0)
}

impl<'t> Types<'t> {
    /// None but `object`.
    pub(super) fn new(at: &Reader<'t>) -> Result<Self, Error> {
        let mut types = Types { all: Vec::new() };
        types.push(at, "object", bit(OBJECT))?;
        Ok(types)
    }

    pub(super) fn as_slice(&self) -> &[Type<'t>] {
        &self.all
    }

    /// The type with this name.
    pub(super) fn find(&self, name: &str) -> Option<TypeId> {
        index_of(self.all.iter().map(|t| t.name), name).map(TypeId)
    }

    /// Whether what is of the first type is of the second as well.
    pub(super) fn is_subtype(&self, type_id: TypeId, of: TypeId) -> bool {
        let own = self.all.get(usize::from(type_id.0));
        own.is_some_and(|own| own.above & bit(of) != 0)
    }

    /// Types may stand before their supertypes, so the section is read twice:
    /// first all names, then what each is a subtype of.
    pub(super) fn read(&mut self, reader: &mut Reader<'t>) -> Result<(), Error> {
        const WHAT: &str = "expected the name of a type or `)`";
        let mut again = reader.clone();
        while let Some(entry) = reader.typed(name, WHAT)? {
            if self.find(entry.name).is_none() {
                self.push(&entry.at, entry.name, bit(OBJECT))?;
            }
        }
        while let Some(entry) = again.typed(name, WHAT)? {
            let own = self.find(entry.name).unwrap_or(OBJECT);
            if let Some(mut type_at) = entry.type_at
                && own != OBJECT
            {
                let at = type_at.clone();
                if !type_at.accept("(") {
                    let parent = self.named_type(&mut type_at)?;
                    self.add_parent(&at, own, parent)?;
                    continue;
                }
                type_at.expect("either", "expected `either`")?;
                while !type_at.accept(")") {
                    let parent = self.named_type(&mut type_at)?;
                    self.add_parent(&at, own, parent)?;
                }
            }
        }
        Ok(())
    }

    fn push(&mut self, at: &Reader<'t>, name: &'t str, above: u64) -> Result<TypeId, Error> {
        let id = TypeId(self.all.len() as u8);
        let own = Type {
            name,
            parent: OBJECT,
            above: above | bit(id),
        };
        self.all
            .push(own)
            .map_err(|_| at.error("no room left: too many types"))?;
        Ok(id)
    }

    /// Makes a type a subtype of another, and so all that are subtypes of it.
    fn add_parent(&mut self, at: &Reader<'t>, own: TypeId, parent: TypeId) -> Result<(), Error> {
        if self.is_subtype(parent, own) {
            return Err(at.error("a type cannot be a subtype of itself"));
        }
        let above = self.all.get(usize::from(parent.0)).map_or(0, |t| t.above);
        if let Some(own) = self.all.get_mut(usize::from(own.0))
            && own.parent == OBJECT
        {
            own.parent = parent;
        }
        for below in self.all.iter_mut().filter(|t| t.above & bit(own) != 0) {
            below.above |= above;
        }
        Ok(())
    }

    fn named_type(&self, reader: &mut Reader<'t>) -> Result<TypeId, Error> {
        let at = reader.clone();
        let name = reader.expect_word(name, "expected the name of a type")?;
        self.find(name).ok_or_else(|| at.error("unknown type"))
    }

    /// The type of an entry of a typed list. An `(either ...)` becomes a type of its own.
    pub(super) fn of(&mut self, entry: &Typed<'t>) -> Result<TypeId, Error> {
        let Some(type_at) = &entry.type_at else {
            return Ok(OBJECT);
        };
        let mut reader = type_at.clone();
        if !reader.accept("(") {
            return self.named_type(&mut reader);
        }
        reader.expect("either", "expected `either`")?;
        let (mut members, mut above) = (0, 0);
        while !reader.accept(")") {
            let TypeId(member) = self.named_type(&mut reader)?;
            members |= bit(TypeId(member));
            above |= self.all.get(usize::from(member)).map_or(0, |t| t.above);
        }
        let words = type_at.text_to_close();
        if let Some(known) = self.find(words) {
            return Ok(known);
        }
        let either = self.push(type_at, words, above)?;
        for own in self.all.iter_mut().filter(|t| t.above & members != 0) {
            own.above |= bit(either);
        }
        Ok(either)
    }

    /// A typed list of variables, each of another name, and the bracket behind it.
    pub(super) fn read_variables(
        &mut self,
        reader: &mut Reader<'t>,
        table: &mut VecView<Variable<'t>>,
    ) -> Result<Span, Error> {
        let first = table.len();
        while let Some(entry) = reader.typed(variable, "expected a variable, as `?x`, or `)`")? {
            let own = Span::since(first, table).of(table);
            if index_of(own.iter().map(|v| v.name), entry.name).is_some() {
                return Err(entry.at.error(DECLARED_TWICE));
            }
            let variable = Variable {
                name: entry.name,
                type_id: self.of(&entry)?,
            };
            push_variable(&entry, first, variable, table)?;
        }
        Ok(Span::since(first, table))
    }
}

/// Appends a variable to a list that begins at `first`.
pub(super) fn push_variable<'t>(
    entry: &Typed<'t>,
    first: usize,
    variable: Variable<'t>,
    table: &mut VecView<Variable<'t>>,
) -> Result<(), Error> {
    if table.len().saturating_sub(first) >= MAX_ARGUMENTS {
        let what = "no room left: too many arguments of one predicate or action";
        return Err(entry.at.error(what));
    }
    table.push(variable).map_err(|_| {
        let what = "no room left: too many arguments of all predicates and actions";
        entry.at.error(what)
    })
}
