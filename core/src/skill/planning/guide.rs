//! The region guide.

use super::knowledge::{Knowledge, reason};
use crate::error::Error;
use crate::plan::{Advice, Guide, Skeleton};
use crate::skill::changes::Changes;
use crate::skill::context::Context;
use crate::skill::setting::Setting;
use crate::skill::skills::{Known, Skill, Skills};
use crate::task::{ObjectId, State};

/// A region guide: it keeps the search of a bilevel planner from sequences of operators
/// that cannot work, for all that was learned (sequential feasibility, thesis 7.2).
///
/// It judges a sequence whose last operator does not work, or with no parameters of some
/// step before, in the state that is expected there: the initial one, with what the steps
/// before are known to change. It does so only as far as regions read nothing that cannot
/// be told.
///
/// The reason that it gives is the place of the ground operator that cannot work;
/// [`RegionGuide::explain`] has the text.
#[derive(Debug)]
pub struct RegionGuide<'a, E> {
    pub(super) knowledge: Knowledge<'a, E>,
    changes: &'a [Changes],
    pub(super) initial: &'a State,
    /// Whether to prune what cannot work, and not only to postpone it.
    pub prune: bool,
}

impl<'a, E: Setting> RegionGuide<'a, E> {
    /// The guide by what is known of an environment, for a task with this initial state.
    pub fn new(environment: &'a E, skills: &'a Skills<'_>, initial: &'a State) -> Self {
        RegionGuide::from_known(environment, skills.known(), initial)
    }

    pub(in crate::skill) fn from_known(
        environment: &'a E,
        (library, changes): Known<'a>,
        initial: &'a State,
    ) -> Self {
        RegionGuide {
            knowledge: Knowledge {
                environment,
                library,
            },
            changes,
            initial,
            prune: false,
        }
    }

    /// The state that is expected after these steps, and a bit for each number of it that
    /// cannot be told.
    fn expected<const N: usize>(&self, before: Skeleton<'_, N>) -> (State, u64) {
        let (mut state, mut unknown) = (self.initial.clone(), 0);
        for ground in before.iter() {
            match self.knowledge.controller(ground) {
                Some(own) => {
                    let changes = Changes::of(self.changes, own.id);
                    changes.predict(own.objects.as_slice(), &mut state, &mut unknown);
                }
                None => unknown = u64::MAX,
            }
        }
        (state, unknown)
    }

    /// Whether the last operator of a sequence cannot work.
    fn is_blocked<const N: usize>(&self, prefix: Skeleton<'_, N>) -> Result<bool, Error> {
        for step in (0..prefix.len()).filter(|step| self.is_known(prefix, *step)) {
            let (state, unknown) = self.expected(prefix.until(step));
            let steps = prefix.from(step);
            let joint = self
                .knowledge
                .joint_region(steps, &state, |skill, context| {
                    is_told(skill, context, unknown)
                });
            if joint.is_proven_empty()? {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Whether something is known of a step and the last one of a sequence, or of that
    /// one alone.
    fn is_known<const N: usize>(&self, prefix: Skeleton<'_, N>, step: usize) -> bool {
        let controller = |ground| self.knowledge.controller(ground);
        let Some(own) = prefix.get(step).and_then(controller) else {
            return false;
        };
        let last = prefix.from(step + 1).iter().next_back();
        let last = last.and_then(controller).map(|last| last.id);
        self.knowledge.has_region(own.id, last)
    }
}

/// Whether all that the region of a skill reads can be told; `unknown` has a bit for each
/// number of the state that cannot.
fn is_told(skill: &Skill, context: &Context<'_, impl Setting>, unknown: u64) -> bool {
    let (state, binding) = (context.state, skill.binding());
    let is_unknown = |object: ObjectId, attribute: usize| {
        let number = state.place(object).map_or(63, |first| first + attribute);
        unknown >> number.min(63) & 1 == 1
    };
    let depends_on = |object: ObjectId| {
        let count = state.attributes(object).map_or(0, <[f64]>::len);
        (0..count).any(|attribute| is_unknown(object, attribute))
    };
    let is_told = |slot: usize| {
        let source = binding.source(slot, context);
        let own = source.is_none_or(|(object, attribute)| !is_unknown(object, attribute));
        // Who is a member at all may depend on anything.
        let kind = binding.kind_of_members(slot);
        let kind = kind.filter(|kind| context.is_narrowed(*kind));
        let mut members = kind.into_iter().flat_map(|kind| state.of_type(kind));
        own && !members.any(depends_on)
    };
    unknown == 0 || skill.reads().all(is_told)
}

impl<E: Setting, const N: usize> Guide<N> for RegionGuide<'_, E> {
    fn judge(&mut self, prefix: Skeleton<'_, N>) -> Advice {
        // What cannot be evaluated is no reason to drop anything.
        if !self.is_blocked(prefix).unwrap_or(false) {
            return Advice::Keep;
        }
        let reason = reason(prefix, prefix.len().saturating_sub(1));
        if self.prune {
            Advice::Prune(reason)
        } else {
            Advice::Postpone(reason)
        }
    }
}
