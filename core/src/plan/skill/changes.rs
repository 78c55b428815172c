//! What controllers change.

use crate::domain::{MAX_ARGUMENTS, MAX_TYPES, ObjectId, State};

/// The attributes that a controller changes, as far as was seen: of its own objects by
/// their places, and of others by their types. One that was never seen may change
/// anything.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Changes {
    seen: bool,
    /// A bit for each attribute; the last also for those beyond.
    own: [u32; MAX_ARGUMENTS],
    others: [u32; MAX_TYPES],
}

impl Changes {
    /// Takes in a run of the controller with these objects.
    pub fn observe(&mut self, objects: &[ObjectId], before: &State, after: &State) {
        self.seen = true;
        for (object, _) in before.objects() {
            let (Some(old), Some(new)) = (before.attributes(object), after.attributes(object))
            else {
                continue;
            };
            let changed = (0..).zip(old.iter().zip(new)).filter(|(_, (a, b))| a != b);
            let bits = changed.fold(0, |bits, (attribute, _)| bits | bit(attribute));
            if let Some(own) = self.of(objects, before, object) {
                *own |= bits;
            }
        }
    }

    /// Whether a run of the controller with these objects may change an attribute.
    pub fn affect(
        &self,
        objects: &[ObjectId],
        state: &State,
        object: ObjectId,
        attribute: usize,
    ) -> bool {
        let changed = self.clone().of(objects, state, object).copied();
        !self.seen || changed.is_none_or(|bits| bits & bit(attribute) != 0)
    }

    /// The bits of an object's attributes.
    fn of(&mut self, objects: &[ObjectId], state: &State, object: ObjectId) -> Option<&mut u32> {
        match objects.iter().position(|own| *own == object) {
            Some(place) => self.own.get_mut(place),
            None => self.others.get_mut(usize::from(state.type_of(object)?.0)),
        }
    }
}

fn bit(attribute: usize) -> u32 {
    1 << attribute.min(31)
}
