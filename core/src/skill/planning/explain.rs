//! Why an operator cannot work, in words.

use super::guide::RegionGuide;
use super::here::Here;
use super::joint_region::JointRegion;
use super::knowledge::GroundController;
use crate::plan::{ReasonId, Skeleton};
use crate::skill::context::Context;
use crate::skill::setting::Setting;
use crate::skill::skills::Skill;
use crate::task::GroundOperator;
use core::fmt::{self, Write};

impl<E: Setting> RegionGuide<'_, E> {
    /// Writes what stands in the way of an operator's controller: every constraint without
    /// which it would work in the initial state, alone or after another one, with the
    /// names of objects for the roles, and what it comes to in numbers. For example
    /// `RobotPressButton(robby, button0, stick) needs button0.y <= 2.9, and it is 4.1`.
    ///
    /// `operators` are those of the task, `reason` is what planning gives, such as
    /// [`Metrics::main_reason`](crate::plan::Metrics::main_reason). If there is no such
    /// constraint, because only several steps together are too much or the state was
    /// another one, it is all that is known of the operator.
    ///
    /// # Errors
    /// Those of `out`, and if the reason is not of this task.
    pub fn explain<const N: usize>(
        &self,
        operators: &[GroundOperator<N>],
        ReasonId(place): ReasonId,
        out: &mut dyn Write,
    ) -> fmt::Result {
        let blocked = operators.get(usize::from(place)).ok_or(fmt::Error)?;
        let (after, joint) = self.cause(operators, place);
        let controller =
            |ground: &GroundOperator<N>| self.knowledge.controller(ground).ok_or(fmt::Error);
        let (own, later) = (controller(after.unwrap_or(blocked))?, controller(blocked)?);
        self.write_controller(&later, out)?;
        if after.is_some() {
            out.write_str(" after ")?;
            self.write_controller(&own, out)?;
        }
        let mut out = Named {
            skill: None,
            context: Context {
                environment: self.knowledge.environment,
                state: self.initial,
                objects: own.objects.as_slice(),
                later_objects: later.objects.as_slice(),
                members: &[],
            },
            out,
        };
        match write_constraints(&joint, true, &mut out)? {
            0 => write_constraints(&joint, false, &mut out).map(|_| ()),
            1 => Ok(()),
            2 => out.write_str("; they cannot both hold"),
            _ => out.write_str("; they cannot all hold"),
        }
    }

    /// What keeps an operator from working: its own region, or else the first step after
    /// which it cannot work, or about which something is known at least.
    fn cause<'o, const N: usize>(
        &self,
        operators: &'o [GroundOperator<N>],
        place: u16,
    ) -> (Option<&'o GroundOperator<N>>, JointRegion<'_>) {
        let known = |places: &[u16]| {
            let skeleton = Skeleton::new(operators, places);
            self.knowledge
                .joint_region(skeleton, self.initial, |_, _| true)
        };
        let is_empty = |joint: &JointRegion<'_>| joint.is_proven_empty().unwrap_or(false);
        let alone = known(&[place]);
        if is_empty(&alone) {
            return (None, alone);
        }
        let pairs = || {
            let pairs = (0..).zip(operators);
            let pairs = pairs.map(|(own, ground)| (Some(ground), known(&[own, place])));
            pairs.filter(|(_, joint)| joint.regions().iter().any(|region| region.step > 0))
        };
        let empty = pairs().find(|(_, joint)| is_empty(joint));
        empty.or_else(|| pairs().next()).unwrap_or((None, alone))
    }

    /// Writes a controller with its objects.
    fn write_controller(&self, own: &GroundController, out: &mut dyn Write) -> fmt::Result {
        out.write_str(own.controller.name)?;
        let mut before = "(";
        for object in own.objects.as_slice() {
            out.write_str(before)?;
            let environment = self.knowledge.environment;
            environment.write_name(self.initial, *object, out)?;
            before = ", ";
        }
        out.write_str(if before == "(" { "()" } else { ")" })
    }
}

/// Writes constraints of the regions; only those that alone keep the regions from meeting,
/// or all. Returns how many.
fn write_constraints<'t, E: Setting>(
    joint: &JointRegion<'t>,
    deciding: bool,
    out: &mut Named<'t, '_, E>,
) -> Result<u32, fmt::Error> {
    let (mut count, mut word) = (0, " needs ");
    let skills = joint.regions().iter().map(|region| region.skill);
    for (place, skill) in skills.enumerate() {
        let Some(region) = skill.region() else {
            continue;
        };
        for index in 0..region.formula().conjunct_count() {
            if deciding && !joint.meet_without(place, index).unwrap_or(false) {
                continue;
            }
            out.skill = None;
            out.write_str(word)?;
            out.skill = Some(skill);
            let conjunct = region.formula().select(|own| own.index == index);
            let conjunct = conjunct.map_err(|_| fmt::Error)?;
            conjunct.write(skill.domain(), out)?;
            count += 1;
            let instance = joint.parts().nth(place).map(|part| part.instance);
            let here = instance.filter(|_| deciding);
            let here = here.and_then(|own| Here::new(skill.domain(), own, &conjunct));
            word = " and ";
            if let Some(here) = here {
                here.write(skill.domain(), out)?;
                word = ", and ";
            }
        }
    }
    Ok(count)
}

/// Puts the names of objects where a skill's domain has the names of roles.
struct Named<'t, 'o, E> {
    skill: Option<&'t Skill>,
    context: Context<'o, E>,
    out: &'o mut dyn Write,
}

impl<E: Setting> Write for Named<'_, '_, E> {
    /// Expressions are written name by name.
    fn write_str(&mut self, word: &str) -> fmt::Result {
        let named = self.skill.and_then(|skill| {
            let mut roles = skill.domain().objects().iter();
            let role = roles.find(|o| o.name == word && o.member.is_none())?;
            let slot = usize::from(role.first_slot);
            let source = skill.binding().source(slot, &self.context);
            source.map(|(object, _)| object)
        });
        let Context {
            environment, state, ..
        } = self.context;
        match named {
            Some(object) => environment.write_name(state, object, self.out),
            None => self.out.write_str(word),
        }
    }
}
