//! Objects and low-level states (thesis 4.1.1: the object set O and x in X).

use crate::domain::{Attribute, MAX_OBJECTS};
use crate::error::Error;
use core::fmt::{self, Write};
use heapless::Vec;

/// Most numbers in a state, over all its objects.
pub const MAX_STATE_VALUES: usize = 64;

/// Index of an [`ObjectType`] in the table of its environment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct TypeId(pub u8);

/// Index of an object in its [`State`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct ObjectId(pub u8);

/// How the objects of a type are named.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Naming {
    /// There is one object, of this name.
    Single(&'static str),
    /// There may be several: this word and a number from zero.
    Numbered(&'static str),
}

/// A type of objects (thesis 4.1.1: an element of Lambda).
#[derive(Clone, Copy, Debug)]
pub struct ObjectType {
    /// Its name.
    pub name: &'static str,
    /// What describes an object of the type, in the order of its numbers; their
    /// count is the type's dimensionality d.
    pub attributes: &'static [Attribute<'static>],
    /// How its objects are named.
    pub naming: Naming,
}

/// The name of an object; `Display` writes it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ObjectName {
    word: &'static str,
    number: Option<u8>,
}

impl ObjectName {
    /// Writes the name.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write(&self, out: &mut (impl Write + ?Sized)) -> fmt::Result {
        out.write_str(self.word)?;
        let Some(number) = self.number else {
            return Ok(());
        };
        if number >= 10 {
            // A state has fewer than a hundred objects.
            out.write_char(char::from(b'0' + number / 10 % 10))?;
        }
        out.write_char(char::from(b'0' + number % 10))
    }
}

impl fmt::Display for ObjectName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write(f)
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Entry {
    type_id: TypeId,
    number: u8,
    first: u8,
    count: u8,
}

/// A state x: objects, and the numbers that describe each.
///
/// The numbers of all objects lie one behind the other in the order in which the
/// objects were added, so an environment that fixes this order can read a state
/// as one flat record ([`Self::values`]).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    objects: Vec<Entry, MAX_OBJECTS>,
    values: Vec<f64, MAX_STATE_VALUES>,
    mark: u16,
}

impl State {
    /// A state without objects.
    pub const fn new() -> Self {
        State {
            objects: Vec::new(),
            values: Vec::new(),
            mark: 0,
        }
    }

    /// A state whose numbers are arranged in another way: of each object its type, where its
    /// numbers begin and how many they are. Objects may have none, and there may be numbers
    /// that belong to nobody. Names are the caller's business, who knows the task again by
    /// the mark.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] beyond [`MAX_OBJECTS`] objects or [`MAX_STATE_VALUES`]
    /// numbers; [`Error::InvalidArgument`] if an object has numbers that are not there.
    pub fn arranged(
        mark: u16,
        objects: impl IntoIterator<Item = (TypeId, usize, usize)>,
        values: &[f64],
    ) -> Result<State, Error> {
        let mut state = State {
            mark,
            ..State::new()
        };
        let all = state.values.extend_from_slice(values);
        all.map_err(|_| Error::CapacityExceeded("numbers of a state"))?;
        for (type_id, first, count) in objects {
            if first.saturating_add(count) > values.len() {
                return Err(Error::InvalidArgument("the state has too few numbers"));
            }
            let number = state.of_type(type_id).count() as u8;
            // There are at most 64 numbers.
            let (first, count) = (first as u8, count as u8);
            let entry = Entry {
                type_id,
                number,
                first,
                count,
            };
            let pushed = state.objects.push(entry);
            pushed.map_err(|_| Error::CapacityExceeded("objects of a state"))?;
        }
        Ok(state)
    }

    /// What [`State::arranged`] was given to know its task again; else zero.
    pub fn mark(&self) -> u16 {
        self.mark
    }

    /// Adds an object of the type `type_id` of `types`.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] if there is no such type, it has another number
    /// of attributes, or its single object is there already;
    /// [`Error::CapacityExceeded`] beyond [`MAX_OBJECTS`] objects or
    /// [`MAX_STATE_VALUES`] numbers. The state stays as it was.
    pub fn add(
        &mut self,
        types: &[ObjectType],
        type_id: TypeId,
        values: &[f64],
    ) -> Result<ObjectId, Error> {
        let object_type = types
            .get(usize::from(type_id.0))
            .filter(|t| t.attributes.len() == values.len())
            .ok_or(Error::InvalidArgument(
                "give each object a type of the environment and one number per attribute",
            ))?;
        let number = self.of_type(type_id).count();
        if matches!(object_type.naming, Naming::Single(_)) && number > 0 {
            return Err(Error::InvalidArgument(
                "an object of a type that has only one was added twice",
            ));
        }
        const FULL: Error = Error::CapacityExceeded("objects or numbers of a state");
        // Both capacities are below 256, so the conversions fail only when full.
        let small = |n: usize| u8::try_from(n).map_err(|_| FULL);
        let entry = Entry {
            type_id,
            number: small(number)?,
            first: small(self.values.len())?,
            count: small(values.len())?,
        };
        let id = ObjectId(small(self.objects.len())?);
        if self.objects.is_full() {
            return Err(FULL);
        }
        self.values.extend_from_slice(values).map_err(|_| FULL)?;
        self.objects.push(entry).map_err(|_| FULL)?;
        Ok(id)
    }

    /// All objects with their types, in the order they were added.
    pub fn objects(&self) -> impl Iterator<Item = (ObjectId, TypeId)> + '_ {
        (0..)
            .map(ObjectId)
            .zip(self.objects.iter().map(|o| o.type_id))
    }

    /// The objects of one type, by their number. Up to ten objects this is also
    /// the order of their names, in which the planner enumerates them.
    pub fn of_type(&self, type_id: TypeId) -> impl Iterator<Item = ObjectId> + '_ {
        self.objects()
            .filter(move |(_, t)| *t == type_id)
            .map(|(object, _)| object)
    }

    /// The type of an object; `None` if it is not in this state.
    pub fn type_of(&self, object: ObjectId) -> Option<TypeId> {
        self.entry(object).map(|o| o.type_id)
    }

    /// The name of an object; `None` if it is not in this state, or its type not
    /// in `types`.
    pub fn name(&self, types: &[ObjectType], object: ObjectId) -> Option<ObjectName> {
        let entry = self.entry(object)?;
        let (word, number) = match types.get(usize::from(entry.type_id.0))?.naming {
            Naming::Single(word) => (word, None),
            Naming::Numbered(word) => (word, Some(entry.number)),
        };
        Some(ObjectName { word, number })
    }

    /// The `N` attributes of an object; `None` if it is not in this state or has
    /// another number of attributes.
    pub fn get<const N: usize>(&self, object: ObjectId) -> Option<&[f64; N]> {
        self.attributes(object)?.try_into().ok()
    }

    /// The attributes of an object; `None` if it is not in this state.
    pub fn attributes(&self, object: ObjectId) -> Option<&[f64]> {
        let entry = self.entry(object)?;
        self.values
            .get(usize::from(entry.first)..)?
            .get(..usize::from(entry.count))
    }

    /// The attributes of an object, to change; `None` if it is not in this state.
    pub fn attributes_mut(&mut self, object: ObjectId) -> Option<&mut [f64]> {
        let entry = self.entry(object)?;
        self.values
            .get_mut(usize::from(entry.first)..)?
            .get_mut(..usize::from(entry.count))
    }

    /// The place of an object's first number among all; `None` if it is not in this
    /// state.
    pub fn place(&self, object: ObjectId) -> Option<usize> {
        self.entry(object).map(|entry| entry.first.into())
    }

    /// All numbers, object by object.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// All numbers, object by object, to change.
    pub fn values_mut(&mut self) -> &mut [f64] {
        &mut self.values
    }

    fn entry(&self, object: ObjectId) -> Option<Entry> {
        self.objects.get(usize::from(object.0)).copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Dimension;
    use std::string::ToString;

    const X: Attribute<'static> = Attribute::new("x", Dimension::Length);
    const TYPES: [ObjectType; 2] = [
        ObjectType {
            name: "robot",
            attributes: &[X],
            naming: Naming::Single("robby"),
        },
        ObjectType {
            name: "block",
            attributes: &[X, X, X],
            naming: Naming::Numbered("block"),
        },
    ];
    const ROBOT: TypeId = TypeId(0);
    const BLOCK: TypeId = TypeId(1);

    #[test]
    fn objects_keep_their_values_and_names() {
        let mut state = State::new();
        for i in 0..12 {
            let x = f64::from(i);
            state.add(&TYPES, BLOCK, &[x, x, -x]).unwrap();
        }
        let robot = state.add(&TYPES, ROBOT, &[7.0]).unwrap();
        assert_eq!(state.get(robot), Some(&[7.0]));
        assert_eq!(state.get::<3>(robot), None);
        assert_eq!(state.type_of(robot), Some(ROBOT));
        assert_eq!(state.name(&TYPES, robot).unwrap().to_string(), "robby");
        let last = state.of_type(BLOCK).last().unwrap();
        assert_eq!(state.name(&TYPES, last).unwrap().to_string(), "block11");
        assert_eq!(state.get(last), Some(&[11.0, 11.0, -11.0]));
        state.attributes_mut(last).unwrap().fill(1.0);
        assert_eq!(state.attributes(last), Some(&[1.0; 3][..]));
        assert_eq!(state.values().len(), 37);
        let nobody = ObjectId(99);
        assert!(state.attributes(nobody).is_none() && state.name(&TYPES, nobody).is_none());
    }

    #[test]
    fn what_does_not_fit_changes_nothing() {
        let mut state = State::new();
        state.add(&TYPES, ROBOT, &[0.0]).unwrap();
        for (type_id, values) in [(ROBOT, &[1.0][..]), (BLOCK, &[1.0]), (TypeId(2), &[])] {
            let result = state.add(&TYPES, type_id, values);
            assert!(matches!(result, Err(Error::InvalidArgument(_))));
        }
        while state.add(&TYPES, BLOCK, &[0.0; 3]).is_ok() {}
        let full = state.clone();
        let result = state.add(&TYPES, BLOCK, &[0.0; 3]);
        assert!(matches!(result, Err(Error::CapacityExceeded(_))));
        assert_eq!(state, full);
        assert_eq!(
            state.values().len(),
            1 + 3 * (MAX_STATE_VALUES - 1).div_euclid(3)
        );
    }
}
