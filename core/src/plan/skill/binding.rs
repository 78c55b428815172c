//! Roles: from a state and ground operators to an instance of a domain text.

use crate::domain::{Domain, MAX_STATE_VALUES, ObjectId, ObjectType, State, TypeId};
use crate::error::Error;
use heapless::Vec;

/// Who fills a role.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Holder {
    /// An object of the controller.
    Own(usize),
    /// An object of the later controller.
    Later(usize),
    /// The only object of a type.
    Only(TypeId),
    /// One of all objects of a type, from zero; nobody if they are fewer.
    Member(TypeId, usize),
}

/// Where a number of an instance comes from.
#[derive(Clone, Copy, Debug)]
struct Source {
    holder: Holder,
    attribute: usize,
}

/// How a state, and the objects of one or two controllers, make an instance of a domain
/// text. The objects of the text are roles, filled by their names:
///
/// | name | object |
/// |---|---|
/// | `button` | the controller's object of the type `button`; if it has none, that of the later one; else the only object of that type in the state |
/// | `button2` | likewise the second object of the type |
/// | `later_button` | the later controller's object, even if the own one has one, too |
/// | `button[4]` | a group: all objects of the type |
///
/// The attributes of a role are among those of the type, by their names.
#[derive(Clone, Debug)]
pub struct Binding {
    sources: Vec<Source, MAX_STATE_VALUES>,
}

const NO_ROLE: Error =
    Error::Mismatch("an object of the text is no role: no type has its name and its attributes");

impl Binding {
    /// The binding of a text's objects, for controllers with objects of these types.
    ///
    /// # Errors
    /// [`Error::Mismatch`] if an object of the text is no role,
    /// [`Error::CapacityExceeded`] beyond [`MAX_STATE_VALUES`] numbers.
    pub fn new(
        domain: &Domain<'_>,
        types: &[ObjectType],
        own: &[TypeId],
        later: &[TypeId],
    ) -> Result<Self, Error> {
        let mut sources = Vec::new();
        for (object, attribute) in domain.slots() {
            let (kind, named) = Role::read(object.name, types).ok_or(NO_ROLE)?;
            let mut attributes = named.attributes.iter();
            let source = Source {
                holder: match object.member {
                    Some(member) => Holder::Member(kind.type_id, usize::from(member.index)),
                    None => kind.holder(own, later),
                },
                attribute: attributes.position(|a| a == attribute).ok_or(NO_ROLE)?,
            };
            let pushed = sources.push(source);
            pushed.map_err(|_| Error::CapacityExceeded("numbers of an instance"))?;
        }
        Ok(Binding { sources })
    }

    /// How many numbers an instance has.
    pub fn len(&self) -> usize {
        self.sources.len()
    }

    /// Whether an instance has no numbers.
    pub fn is_empty(&self) -> bool {
        self.sources.is_empty()
    }

    /// Writes the instance of a state and the objects of the controllers to `out`, which
    /// has a place for each number.
    ///
    /// # Errors
    /// [`Error::Mismatch`] if nobody, or not one object alone, fills a role.
    pub fn instance(
        &self,
        state: &State,
        own: &[ObjectId],
        later: &[ObjectId],
        out: &mut [f64],
    ) -> Result<(), Error> {
        const NOBODY: Error = Error::Mismatch("a role is not filled by one object");
        for (source, number) in self.sources.iter().zip(out) {
            let object = source.object(state, own, later);
            let member = matches!(source.holder, Holder::Member(..));
            *number = match object.and_then(|o| state.attributes(o)) {
                Some(attributes) => *attributes.get(source.attribute).ok_or(NOBODY)?,
                None if member => f64::NAN,
                None => return Err(NOBODY),
            };
        }
        Ok(())
    }

    /// The object and attribute that a number of an instance is read from.
    pub(super) fn source(
        &self,
        slot: usize,
        state: &State,
        own: &[ObjectId],
        later: &[ObjectId],
    ) -> Option<(ObjectId, usize)> {
        let source = self.sources.get(slot)?;
        Some((source.object(state, own, later)?, source.attribute))
    }
}

impl Source {
    fn object(&self, state: &State, own: &[ObjectId], later: &[ObjectId]) -> Option<ObjectId> {
        match self.holder {
            Holder::Own(place) => own.get(place).copied(),
            Holder::Later(place) => later.get(place).copied(),
            Holder::Member(kind, index) => state.of_type(kind).nth(index),
            Holder::Only(kind) => {
                let mut all = state.of_type(kind);
                all.next().filter(|_| all.next().is_none())
            }
        }
    }
}

/// What the name of a role says.
struct Role {
    type_id: TypeId,
    /// Which object of its type, from zero.
    number: usize,
    later: bool,
}

impl Role {
    fn read<'t>(name: &str, types: &'t [ObjectType]) -> Option<(Role, &'t ObjectType)> {
        let (later, plain) = match name.strip_prefix("later_") {
            Some(rest) => (true, rest),
            None => (false, name),
        };
        // The whole name may be that of a type that ends with a digit.
        let word = plain.trim_end_matches(|c: char| c.is_ascii_digit());
        [plain, word].into_iter().find_map(|word| {
            let digits = plain.strip_prefix(word)?;
            let number = if digits.is_empty() {
                1
            } else {
                digits.parse().ok()?
            };
            let (type_id, named) = (0..).map(TypeId).zip(types).find(|(_, t)| t.name == word)?;
            let role = Role {
                type_id,
                number: usize::checked_sub(number, 1)?,
                later,
            };
            Some((role, named))
        })
    }

    fn holder(&self, own: &[TypeId], later: &[TypeId]) -> Holder {
        let place = |types: &[TypeId]| {
            let all = types.iter().enumerate();
            let mut same = all.filter(|(_, kind)| **kind == self.type_id);
            same.nth(self.number).map(|(place, _)| place)
        };
        match (place(own).filter(|_| !self.later), place(later)) {
            (Some(place), _) => Holder::Own(place),
            (None, Some(place)) => Holder::Later(place),
            (None, None) => Holder::Only(self.type_id),
        }
    }
}
