//! Roles: from a state and ground operators to an instance of a domain text.

use super::context::Context;
use super::setting::Setting;
use crate::domain::Domain;
use crate::error::Error;
use crate::task::{MAX_ARGUMENTS, MAX_STATE_VALUES, ObjectId, ObjectType, TypeId};
use heapless::Vec;

/// Who fills a role.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Filler {
    /// An object of the controller.
    Own(usize),
    /// An object of the later controller.
    Later(usize),
    /// The only object of a type.
    Only(TypeId),
    /// The only object of a type that is none of the controllers'.
    Other(TypeId),
    /// One of the members of a group, from zero; nobody if they are fewer.
    Member(TypeId, usize),
    /// Likewise of those that are none of the controllers'.
    OtherMember(TypeId, usize),
}

/// Where a number of an instance comes from.
#[derive(Clone, Copy, Debug)]
struct Source {
    filler: Filler,
    attribute: usize,
}

/// How a state, and the objects of one or two controllers, make an instance of a domain
/// text. The objects of the text are roles, filled by their names:
///
/// | name | object |
/// |---|---|
/// | `button` | the controller's object of the type `button`; if it has none, that of the later one; else the only object of that type in the state |
/// | `button2` | likewise the second object of the type |
/// | `later_button` | the later controller's object, even if the controller has one, too |
/// | `other_button` | the only object of the type that is none of the controllers' |
/// | `button[4]` | a group: all objects of the type |
/// | `other_button[4]` | a group: those that are none of the controllers' |
///
/// The attributes of a role are among those of the type, by their names. Which objects
/// are members of groups can be narrowed by predicates:
/// [`Description::members`](super::Description::members).
#[derive(Clone, Debug)]
pub struct RoleBinding {
    sources: Vec<Source, MAX_STATE_VALUES>,
}

const NO_ROLE: Error =
    Error::Mismatch("an object of the text is no role: no type has its name and its attributes");

impl RoleBinding {
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
                filler: kind.filler(object.member.map(|m| m.index.into()), own, later),
                attribute: attributes.position(|a| a == attribute).ok_or(NO_ROLE)?,
            };
            let pushed = sources.push(source);
            pushed.map_err(|_| Error::CapacityExceeded("numbers of an instance"))?;
        }
        Ok(RoleBinding { sources })
    }

    /// The places of two controllers' objects that fill one role: of the first, and of the
    /// later one.
    pub(super) fn shared(
        domain: &Domain<'_>,
        types: &[ObjectType],
        own: &[TypeId],
        later: &[TypeId],
    ) -> Vec<(usize, usize), MAX_ARGUMENTS> {
        let mut shared = Vec::new();
        for object in domain.objects().iter().filter(|own| own.member.is_none()) {
            let role = Role::read(object.name, types).map(|(role, _)| role);
            let role = role.filter(|role| role.which == Which::Any);
            let places = role.and_then(|role| Some((role.place(own)?, role.place(later)?)));
            if let Some(places) = places {
                // A controller has no more objects than there is room for.
                let _ = shared.push(places);
            }
        }
        shared
    }

    /// How many numbers an instance has.
    pub fn len(&self) -> usize {
        self.sources.len()
    }

    /// Whether an instance has no numbers.
    pub fn is_empty(&self) -> bool {
        self.sources.is_empty()
    }

    /// Writes the instance of a context to `out`, which has a place for each number.
    ///
    /// # Errors
    /// [`Error::Mismatch`] if nobody, or not one object alone, fills a role.
    pub fn instance<S: Setting>(
        &self,
        context: &Context<'_, S>,
        out: &mut [f64],
    ) -> Result<(), Error> {
        const NOBODY: Error = Error::Mismatch("a role is not filled by one object");
        for (source, number) in self.sources.iter().zip(out) {
            let object = source.object(context);
            *number = match object.and_then(|o| context.state.attributes(o)) {
                Some(attributes) => *attributes.get(source.attribute).ok_or(NOBODY)?,
                None if source.filler.kind_of_members().is_some() => f64::NAN,
                None => return Err(NOBODY),
            };
        }
        Ok(())
    }

    /// The object and attribute that a number of an instance is read from.
    pub(super) fn source<S: Setting>(
        &self,
        slot: usize,
        context: &Context<'_, S>,
    ) -> Option<(ObjectId, usize)> {
        let source = self.sources.get(slot)?;
        Some((source.object(context)?, source.attribute))
    }

    /// The type of whose objects a number of an instance is one of several.
    pub(super) fn kind_of_members(&self, slot: usize) -> Option<TypeId> {
        self.sources.get(slot)?.filler.kind_of_members()
    }
}

impl Filler {
    fn kind_of_members(self) -> Option<TypeId> {
        match self {
            Filler::Member(kind, _) | Filler::OtherMember(kind, _) => Some(kind),
            _ => None,
        }
    }
}

impl Source {
    fn object<S: Setting>(&self, context: &Context<'_, S>) -> Option<ObjectId> {
        let is_other = |object: &ObjectId| context.is_other(*object);
        match self.filler {
            Filler::Own(place) => context.objects.get(place).copied(),
            Filler::Later(place) => context.later_objects.get(place).copied(),
            Filler::Member(kind, index) => context.members(kind).nth(index),
            Filler::OtherMember(kind, index) => context.members(kind).filter(is_other).nth(index),
            Filler::Only(kind) => single(context.state.of_type(kind)),
            Filler::Other(kind) => single(context.state.of_type(kind).filter(is_other)),
        }
    }
}

fn single(mut all: impl Iterator<Item = ObjectId>) -> Option<ObjectId> {
    all.next().filter(|_| all.next().is_none())
}

/// What the name of a role says.
struct Role {
    type_id: TypeId,
    /// Which object of its type, from zero.
    number: usize,
    which: Which,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Which {
    Any,
    Later,
    Other,
}

impl Role {
    fn read<'t>(name: &str, types: &'t [ObjectType]) -> Option<(Role, &'t ObjectType)> {
        let prefixes = [("later_", Which::Later), ("other_", Which::Other)];
        let prefixed = prefixes.into_iter();
        let mut prefixed = prefixed.filter_map(|(p, which)| Some((which, name.strip_prefix(p)?)));
        let (which, plain) = prefixed.next().unwrap_or((Which::Any, name));
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
                which,
            };
            Some((role, named))
        })
    }

    /// The place of the object among those of a controller.
    fn place(&self, types: &[TypeId]) -> Option<usize> {
        let all = types.iter().enumerate();
        let mut same = all.filter(|(_, kind)| **kind == self.type_id);
        same.nth(self.number).map(|(place, _)| place)
    }

    fn filler(&self, member: Option<usize>, own: &[TypeId], later: &[TypeId]) -> Filler {
        match (self.which, member) {
            (Which::Other, Some(index)) => return Filler::OtherMember(self.type_id, index),
            (Which::Other, None) => return Filler::Other(self.type_id),
            (_, Some(index)) => return Filler::Member(self.type_id, index),
            (_, None) => {}
        }
        let own = self.place(own).filter(|_| self.which == Which::Any);
        match (own, self.place(later)) {
            (Some(place), _) => Filler::Own(place),
            (None, Some(place)) => Filler::Later(place),
            (None, None) => Filler::Only(self.type_id),
        }
    }
}
