//! What controllers change.

use super::tuning::{AGREEING, CONSTANT_RUNS};
use crate::domain::MAX_TYPES;
use crate::error::Error;
use crate::task::{ControllerId, MAX_ARGUMENTS, ObjectId, PredicateId, State};
use crate::wire::{Reader, Writer};

/// Attributes of an object of which more is known than that they change.
const TRACKED: usize = 8;

/// The attributes that a controller changes, as far as was seen: of its own objects by
/// their places, and of others by their types. One that was never seen may change
/// anything; an attribute of an own object that always had one value afterwards is
/// expected to have it again.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Changes {
    runs: u32,
    own: [Effect; MAX_ARGUMENTS],
    /// A bit for each attribute; the last also for those beyond.
    others: [u32; MAX_TYPES],
    /// In how many runs any attribute of others of a type changed.
    touched: [u32; MAX_TYPES],
    /// A bit for each predicate of which an atom ended, without being said to, and of which
    /// one did not; the last also for those beyond.
    ended: u64,
    stayed: u64,
}

/// What happens to one object.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Effect {
    /// A bit for each attribute that changes.
    changed: u32,
    /// A bit for each attribute that had several values afterwards.
    varies: u32,
    /// The last values afterwards.
    values: [f64; TRACKED],
}

impl Changes {
    /// Those of a controller, of the changes of all; of one that is not among them nothing
    /// was seen.
    pub(super) fn of(all: &[Changes], ControllerId(id): ControllerId) -> Changes {
        all.get(usize::from(id)).copied().unwrap_or_default()
    }

    /// Takes in a run of the controller with these objects.
    pub fn observe(&mut self, objects: &[ObjectId], before: &State, after: &State) {
        let mut touched = [false; MAX_TYPES];
        for (object, kind) in before.objects() {
            let (Some(old), Some(new)) = (before.attributes(object), after.attributes(object))
            else {
                continue;
            };
            let pairs = (0..).zip(old.iter().zip(new));
            let bits = pairs.filter(|(_, (a, b))| a != b);
            let bits = bits.fold(0, |bits, (attribute, _)| bits | bit(attribute));
            let place = objects.iter().position(|own| *own == object);
            match place.map(|place| self.own.get_mut(place)) {
                Some(Some(own)) => own.observe(bits, new, self.runs == 0),
                Some(None) => {}
                None => {
                    if let Some(others) = self.others.get_mut(usize::from(kind.0)) {
                        *others |= bits;
                    }
                    if let Some(own) = touched.get_mut(usize::from(kind.0)) {
                        *own |= bits != 0;
                    }
                }
            }
        }
        for (count, own) in self.touched.iter_mut().zip(touched) {
            *count += u32::from(own);
        }
        self.runs = self.runs.saturating_add(1);
    }

    /// Takes in whether an atom still holds after a run, of which the operator says that it
    /// holds before and not that it ends.
    pub fn observe_atom(&mut self, predicate: PredicateId, holds: bool) {
        let seen = if holds {
            &mut self.stayed
        } else {
            &mut self.ended
        };
        *seen |= predicate_bit(predicate);
    }

    /// Whether atoms of a predicate, which hold before, end with every run, although
    /// operators do not say so: as far as was seen.
    pub fn ends(&self, predicate: PredicateId) -> bool {
        let seen = self.runs >= CONSTANT_RUNS;
        seen && self.ended & !self.stayed & predicate_bit(predicate) != 0
    }

    /// Whether a run of the controller with these objects may change an attribute.
    pub fn affect(
        &self,
        objects: &[ObjectId],
        state: &State,
        object: ObjectId,
        attribute: usize,
    ) -> bool {
        let kind = state.type_of(object);
        let changed = match objects.iter().position(|own| *own == object) {
            Some(place) => self.own.get(place).map(|own| own.changed),
            None => kind.and_then(|kind| self.others.get(usize::from(kind.0)).copied()),
        };
        self.runs == 0 || changed.is_none_or(|bits| bits & bit(attribute) != 0)
    }

    /// Whether nearly all runs leave objects of a type alone that are not the controller's: a
    /// hand that took two things at once did so by chance.
    fn leaves_alone(&self, objects: &[ObjectId], state: &State, object: ObjectId) -> bool {
        let kind = state.type_of(object).filter(|_| !objects.contains(&object));
        let touched = kind.and_then(|kind| self.touched.get(usize::from(kind.0)));
        let most = (1.0 - AGREEING) * f64::from(self.runs);
        self.runs > 0 && touched.is_some_and(|count| f64::from(*count) <= most)
    }

    /// The value that an attribute of an own object has after every run, as far as was
    /// seen, if the controller changes it.
    fn constant(&self, objects: &[ObjectId], object: ObjectId, attribute: usize) -> Option<f64> {
        let place = objects.iter().position(|own| *own == object)?;
        let own = self.own.get(place).filter(|_| self.runs >= CONSTANT_RUNS)?;
        let value = own.values.get(attribute)?;
        (own.varies & bit(attribute) == 0).then_some(*value)
    }

    /// Makes of a state what is expected of it after a run of the controller with these
    /// objects. What cannot be told is added to `unknown`, a bit per number of the state; if
    /// what happens `mostly` is wanted, others that are nearly always left alone are.
    pub(super) fn predict(
        &self,
        objects: &[ObjectId],
        state: &mut State,
        unknown: &mut u64,
        mostly: bool,
    ) {
        for index in 0..state.objects().count() {
            let object = ObjectId(index as u8);
            if mostly && self.leaves_alone(objects, state, object) {
                continue;
            }
            let first = state.place(object).unwrap_or(0);
            for attribute in 0..state.attributes(object).map_or(0, <[f64]>::len) {
                let bit = 1u64.wrapping_shl((first + attribute) as u32);
                if !self.affect(objects, state, object, attribute) {
                    continue;
                }
                let constant = self.constant(objects, object, attribute);
                let place = state.attributes_mut(object);
                match (constant, place.and_then(|all| all.get_mut(attribute))) {
                    (Some(value), Some(place)) => {
                        *place = value;
                        *unknown &= !bit;
                    }
                    _ => *unknown |= bit,
                }
            }
        }
    }
}

impl Changes {
    /// Writes what was seen.
    pub(super) fn write(&self, writer: &mut Writer<'_>) {
        writer.u32(self.runs);
        for own in &self.own {
            writer.u32(own.changed);
            writer.u32(own.varies);
            own.values.iter().for_each(|value| writer.f64(*value));
        }
        let others = self.others.iter().chain(&self.touched);
        others.for_each(|number| writer.u32(*number));
        writer.u64(self.ended);
        writer.u64(self.stayed);
    }

    /// Reads what [`Changes::write`] wrote.
    pub(super) fn read(reader: &mut Reader<'_>) -> Result<Changes, Error> {
        let mut changes = Changes {
            runs: reader.u32()?,
            ..Changes::default()
        };
        for own in &mut changes.own {
            (own.changed, own.varies) = (reader.u32()?, reader.u32()?);
            for value in &mut own.values {
                *value = reader.f64()?;
            }
        }
        for number in changes.others.iter_mut().chain(&mut changes.touched) {
            *number = reader.u32()?;
        }
        (changes.ended, changes.stayed) = (reader.u64()?, reader.u64()?);
        Ok(changes)
    }
}

impl Effect {
    fn observe(&mut self, changed: u32, after: &[f64], first: bool) {
        self.changed |= changed;
        for (attribute, (value, new)) in self.values.iter_mut().zip(after).enumerate() {
            if !first && *value != *new {
                self.varies |= bit(attribute);
            }
            *value = *new;
        }
    }
}

fn bit(attribute: usize) -> u32 {
    1 << attribute.min(31)
}

fn predicate_bit(PredicateId(predicate): PredicateId) -> u64 {
    1 << predicate.min(63)
}
