//! What region sampler and region guide share: which regions bear on the steps of a plan
//! skeleton.

use super::joint_region::JointRegion;
use crate::plan::{ReasonId, Skeleton};
use crate::skill::context::Context;
use crate::skill::setting::{Setting, Signature};
use crate::skill::skills::{Library, Skill};
use crate::task::{Arguments, ControllerId, GroundOperator, State};

/// What skills are used in, and those that are known.
#[derive(Debug)]
pub(super) struct Knowledge<'a, E> {
    pub(super) environment: &'a E,
    pub(super) library: Library<'a>,
}

/// A controller with its objects.
pub(super) struct GroundController {
    pub(super) id: ControllerId,
    pub(super) controller: Signature,
    pub(super) objects: Arguments,
}

impl GroundController {
    /// Whether its parameters count from now on, instead of those of an earlier one.
    fn decides_anew(&self, earlier: &GroundController) -> bool {
        let mut objects = self.objects.as_slice().iter();
        self.controller.parameters > 0
            && objects.any(|object| earlier.objects.as_slice().contains(object))
    }
}

impl<'a, E: Setting> Knowledge<'a, E> {
    /// The controller of a ground operator and its objects.
    pub(super) fn controller<const N: usize>(
        &self,
        ground: &GroundOperator<N>,
    ) -> Option<GroundController> {
        let objects = ground.objects.as_slice();
        let (id, objects) = self.environment.call(ground.operator, objects).ok()?;
        let controller = self.environment.signature(id).ok()?;
        Some(GroundController {
            id,
            controller,
            objects,
        })
    }

    /// What is known of a controller alone, with its objects.
    pub(super) fn about(&self, own: &GroundController) -> impl Iterator<Item = &'a Skill> {
        let known = self.library.about(own.id, None);
        known.filter(|skill| skill.is_about(own.objects.as_slice(), &[]))
    }

    /// Whether there is a region of a controller, or of it and a later one.
    pub(super) fn has_region(&self, id: ControllerId, later: Option<ControllerId>) -> bool {
        let mut known = self.library.about(id, later);
        known.any(|skill| skill.region().is_some())
    }

    /// The regions of a step, and those of later steps, in a state before the first; only
    /// those of which `counts` is true.
    pub(super) fn joint_region<const N: usize>(
        &self,
        skeleton: Skeleton<'_, N>,
        state: &State,
        counts: impl Fn(&Skill, &Context<'_, E>) -> bool,
    ) -> JointRegion<'a> {
        let mut joint = JointRegion::default();
        let mut controllers = skeleton.iter().map_while(|ground| self.controller(ground));
        let Some(first) = controllers.next() else {
            return joint;
        };
        self.add(&mut joint, (&first, None, 0), state, &counts);
        if first.controller.parameters == 0 {
            return joint;
        }
        for (step, later) in (1..).zip(controllers) {
            self.add(&mut joint, (&first, Some(&later), step), state, &counts);
            if later.decides_anew(&first) {
                break;
            }
        }
        joint
    }

    /// Adds what is known of a controller, or of it and a later one.
    fn add(
        &self,
        joint: &mut JointRegion<'a>,
        (first, later, step): (&GroundController, Option<&GroundController>, usize),
        state: &State,
        counts: impl Fn(&Skill, &Context<'_, E>) -> bool,
    ) {
        let known = self.library.about(first.id, later.map(|later| later.id));
        for skill in known.filter(|skill| skill.region().is_some()) {
            let context = Context {
                environment: self.environment,
                state,
                objects: first.objects.as_slice(),
                later_objects: later.map_or(&[], |later| later.objects.as_slice()),
                members: skill.description().members,
            };
            let is_about = skill.is_about(context.objects, context.later_objects);
            if is_about && counts(skill, &context) {
                joint.add(skill, step, |out| skill.binding().instance(&context, out));
            }
        }
    }
}

/// The step of a sequence as the reason why something cannot work.
pub(super) fn reason<const N: usize>(sequence: Skeleton<'_, N>, step: usize) -> ReasonId {
    let place = sequence.places().get(step);
    ReasonId(place.copied().unwrap_or(u16::MAX))
}
