//! What is expected of a state after some steps.

use super::knowledge::{GroundController, Knowledge};
use crate::skill::changes::Changes;
use crate::skill::context::Context;
use crate::skill::effects::{Terms, singles, terms};
use crate::skill::setting::Setting;
use crate::skill::skills::Skill;
use crate::task::{MAX_STATE_VALUES, ObjectId, State};
use heapless::Vec;

/// A state as far as it can be told.
#[derive(Clone, Debug)]
pub(super) struct Expectation {
    /// The state; what cannot be told is as it was.
    pub(super) state: State,
    /// A bit for each number of it that cannot be told.
    unknown: u64,
}

impl Expectation {
    /// A state that is known.
    pub(super) fn of(state: &State) -> Self {
        let (state, unknown) = (state.clone(), 0);
        Expectation { state, unknown }
    }

    /// After a controller that nothing is known of.
    pub(super) fn forget(&mut self) {
        self.unknown = u64::MAX;
    }

    /// After what a controller is known to change; or what it mostly does.
    pub(super) fn change(&mut self, changes: &[Changes], own: &GroundController, mostly: bool) {
        let (changes, objects) = (Changes::of(changes, own.id), own.objects.as_slice());
        changes.predict(objects, &mut self.state, &mut self.unknown, mostly);
    }

    /// After a controller, with these parameters, if they are known: after what it changes,
    /// and where it is known to leave its objects.
    pub(super) fn advance<E: Setting>(
        &mut self,
        knowledge: &Knowledge<'_, E>,
        changes: &[Changes],
        own: &GroundController,
        theta: Option<&[f64]>,
    ) {
        let objects = own.objects.as_slice();
        let mut known: Vec<(ObjectId, usize, f64), MAX_STATE_VALUES> = Vec::new();
        for skill in knowledge.about(own) {
            let context = Context {
                environment: knowledge.environment,
                state: &self.state,
                objects,
                later_objects: &[],
                members: skill.description().members,
            };
            let Some(terms) = self.terms(skill, &context, theta) else {
                continue;
            };
            for (slot, value) in skill.effects().after(&terms) {
                if let Some((object, attribute)) = skill.binding().source(slot, &context) {
                    // There is a place for each number.
                    let _ = known.push((object, attribute, value));
                }
            }
        }
        let before = self.state.clone();
        self.change(changes, own, true);
        let changes = Changes::of(changes, own.id);
        for (object, attribute, value) in known {
            let first = before.place(object).unwrap_or(0);
            let numbers = self.state.attributes_mut(object);
            let number = numbers.and_then(|all| all.get_mut(attribute));
            if changes.affect(objects, &before, object, attribute)
                && let Some(number) = number
            {
                *number = value;
                self.unknown &= !bit(first + attribute);
            }
        }
    }

    /// The terms of a skill's text, if all of its single objects can be told.
    fn terms(
        &self,
        skill: &Skill,
        context: &Context<'_, impl Setting>,
        theta: Option<&[f64]>,
    ) -> Option<Terms> {
        if skill.effects().is_empty() {
            return None;
        }
        let mut slots = singles(skill.domain()).enumerate();
        if !slots.all(|(slot, single)| !single || self.tells(skill, context, slot)) {
            return None;
        }
        let mut numbers = [0.0; MAX_STATE_VALUES];
        let instance = numbers.get_mut(..skill.binding().len())?;
        skill.binding().instance(context, instance).ok()?;
        terms(skill.domain(), instance, theta.unwrap_or_default()).ok()
    }

    /// Whether all that the region of a skill reads can be told.
    pub(super) fn tells_region(&self, skill: &Skill, context: &Context<'_, impl Setting>) -> bool {
        self.unknown == 0 || skill.reads().all(|slot| self.tells(skill, context, slot))
    }

    /// Whether a number of a skill's instance can be told.
    fn tells(&self, skill: &Skill, context: &Context<'_, impl Setting>, slot: usize) -> bool {
        let (state, binding) = (context.state, skill.binding());
        let is_unknown = |object: ObjectId, attribute: usize| {
            let number = state.place(object).map_or(63, |first| first + attribute);
            self.unknown & bit(number) != 0
        };
        let depends_on = |object: ObjectId| {
            let count = state.attributes(object).map_or(0, <[f64]>::len);
            (0..count).any(|attribute| is_unknown(object, attribute))
        };
        let source = binding.source(slot, context);
        let own = source.is_none_or(|(object, attribute)| !is_unknown(object, attribute));
        // Who is a member at all may depend on anything.
        let kind = binding.kind_of_members(slot);
        let kind = kind.filter(|kind| context.is_narrowed(*kind));
        let mut members = kind.into_iter().flat_map(|kind| state.of_type(kind));
        own && !members.any(depends_on)
    }
}

fn bit(number: usize) -> u64 {
    1 << number.min(63)
}
