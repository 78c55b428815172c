//! Adding skills: controllers, and what can be said of them.

use crate::boundary::limits::CRITREG_DOMAIN_TEXT_MAX;
use crate::boundary::pointer;
use crate::boundary::status::{Failure, Fallible, critreg_status};
use crate::planner::config::CRITREG_PDDL_TEXT_MAX;
use crate::skill::handle::{Inner, critreg_skills, with_skills};
use crate::skill::layout::MAX_NARROWING;
use core::ffi::c_char;
use critreg_core::Error;
use critreg_core::domain::Domain;
use critreg_core::skill::{Description, Later, Skill, write_pair};
use critreg_core::task::{ControllerId, PredicateId};
use critreg_core::text::TextBuffer;
use heapless::Vec;

/// Adds a skill: a controller, or two that run one after the other, and what can be said of
/// them.
///
/// @param skills The skills.
/// @param controller The name of the controller, ended by NUL.
/// @param later NULL; or the name of a controller that runs later, ended by NUL: learned is
/// then with which parameters of the first the later one works, too.
/// @param members NULL; or names of predicates of one object, separated by blanks, ended by
/// NUL. An object is a member of a group of the text only if all of them that are about its
/// type hold of it.
/// @param text The domain text, ended by NUL; its objects are roles, see SKILLS above. Its
/// parameters are the controller's first ones. Copied. NULL for a pair: it follows from the
/// texts of the two, in which roles of the same name are the same object; a later one that
/// has no text is described by its objects. NULL for a single controller: it is described by
/// its objects.
/// @return CRITREG_INVALID_ARGUMENT if there is no such controller or predicate;
/// CRITREG_SYNTAX_ERROR (ask critreg_check_domain() where); CRITREG_MISMATCH if an object of
/// the text is no role, the text has more parameters than the controller, or a pair without
/// text has a first one without; CRITREG_CAPACITY_EXCEEDED if it finds no room;
/// CRITREG_OUT_OF_SEQUENCE after critreg_skills_learn() or critreg_skills_resume();
/// CRITREG_BUSY, CRITREG_NULL_POINTER, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_skills_add(
    skills: *mut critreg_skills,
    controller: *const c_char,
    later: *const c_char,
    members: *const c_char,
    text: *const c_char,
) -> critreg_status {
    /// # Safety
    /// If not NULL, the text can be read up to its NUL.
    unsafe fn optional<'a>(
        text: *const c_char,
        longest: usize,
        name: &'static str,
    ) -> Fallible<Option<&'a str>> {
        match text.is_null() {
            true => Ok(None),
            // SAFETY: by this function's contract.
            false => unsafe { pointer::text(text, longest, name) }.map(Some),
        }
    }
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_skills(skills, |inner| {
            let controller = pointer::text(controller, CRITREG_PDDL_TEXT_MAX, "controller")?;
            let later = optional(later, CRITREG_PDDL_TEXT_MAX, "later")?;
            let members = optional(members, CRITREG_PDDL_TEXT_MAX, "members")?;
            let text = optional(text, CRITREG_DOMAIN_TEXT_MAX, "text")?;
            inner.add_skill(controller, later, members.unwrap_or(""), text)
        })
    }
}

impl Inner {
    fn add_skill(
        &mut self,
        controller: &str,
        later: Option<&str>,
        members: &str,
        text: Option<&str>,
    ) -> Fallible {
        self.expect_open()?;
        const FULL: Error = Error::CapacityExceeded("skills: set config.skills");
        if self.skill_count >= self.skills.len() {
            return Err(FULL.into());
        }
        let controller_id = self.find_or_add(controller)?;
        let later_id = later.map(|later| self.find_or_add(later)).transpose()?;
        let mut room = [0; CRITREG_DOMAIN_TEXT_MAX];
        let derived = text.is_none();
        let text = match text {
            Some(text) => text,
            None => self.derive(controller_id, later_id, &mut room)?,
        };
        // What is wrong with it is found before it is copied.
        Domain::parse(text)?;
        let description = Description {
            controller: controller_id,
            later: later_id,
            members: self.narrowing(members)?,
            text: self.texts.copy(text)?,
        };
        let types = self.facts.types;
        let controller_like = self.facts.signature(controller_id)?;
        let later_like = later_id.map(|id| self.facts.signature(id)).transpose()?;
        let skill = match derived {
            true => Skill::of_same_objects(&description, types, controller_like, later_like),
            false => Skill::new(&description, types, controller_like, later_like),
        };
        if skill.is_err() {
            // SAFETY: only the skill that was refused refers to the copy.
            unsafe { self.texts.forget_last(text) };
        }
        *self.skills.get_mut(self.skill_count).ok_or(FULL)? = Some(skill?);
        self.skill_count += 1;
        for own in [controller, later.unwrap_or(""), members, text] {
            self.fingerprint.text(own);
        }
        Ok(())
    }

    /// The text of a pair, of the texts of its members; or of a controller, of its objects.
    fn derive<'r>(
        &self,
        controller: ControllerId,
        later: Option<ControllerId>,
        room: &'r mut [u8],
    ) -> Fallible<&'r str> {
        const LONG: Error = Error::CapacityExceeded("the text of a pair of controllers");
        let alone = |id: ControllerId| {
            let mut skills = self.skills.iter().flatten();
            skills.find(|own| {
                let about = own.description();
                about.controller == id && about.later.is_none()
            })
        };
        let objects = |id: ControllerId| {
            let entry = self.facts.entry(id);
            Later::Objects(self.facts.types, entry.map_or(&[], |own| &own.arguments))
        };
        let mut out = TextBuffer::new(room);
        match later {
            None => write_pair(&Domain::empty(), objects(controller), &mut out)?,
            Some(later) => {
                let first = alone(controller).ok_or(Error::Mismatch(
                    "a pair without text needs a skill of its first controller alone, with one",
                ))?;
                let second = match alone(later) {
                    Some(second) => Later::Text(second.domain()),
                    None => objects(later),
                };
                write_pair(first.domain(), second, &mut out)?;
            }
        }
        let length = out.needed();
        let written = room.get(..length).ok_or(LONG)?;
        core::str::from_utf8(written).map_err(|_| Failure::invalid("the text is not UTF-8"))
    }

    /// The predicates with these names.
    fn narrowing(&mut self, members: &str) -> Fallible<&'static [PredicateId]> {
        let mut all = Vec::<u8, MAX_NARROWING>::new();
        for name in members.split_ascii_whitespace() {
            let found = self.facts.pddl.find_predicate(name);
            let PredicateId(id) = found.ok_or(Failure::invalid(
                "members: there is no predicate of this name",
            ))?;
            let pushed = all.push(id);
            pushed.map_err(|_| Error::CapacityExceeded("predicates that narrow groups"))?;
        }
        if all.len() > self.narrowing.len() {
            return Err(Error::CapacityExceeded("predicates that narrow groups").into());
        }
        let (own, rest) = core::mem::take(&mut self.narrowing).split_at_mut(all.len());
        self.narrowing = rest;
        for (slot, id) in own.iter_mut().zip(&all) {
            *slot = PredicateId(*id);
        }
        Ok(own)
    }
}
