//! Making skills: controllers, skills and training tasks are added one by one.

use crate::boundary::handle;
use crate::boundary::limits::CRITREG_DOMAIN_TEXT_MAX;
use crate::boundary::memory::ALIGNMENT;
use crate::boundary::pointer::{self, Output};
use crate::boundary::status::{Failure, Fallible, critreg_status, status_of};
use crate::boundary::text;
use crate::planner::config::CRITREG_PDDL_TEXT_MAX;
use crate::planner::tables::{NO_ACTION, Ranges};
use crate::skill::arrangement::arranged;
use crate::skill::config::{self, critreg_skills_config};
use crate::skill::facts::{ActionCall, ControllerEntry};
use crate::skill::handle::{Inner, critreg_skills, with_skills};
use crate::skill::layout::{MAX_NARROWING, SkillsLayout};
use crate::skill::practice::TaskEntry;
use core::ffi::{c_char, c_void};
use critreg_core::Error;
use critreg_core::domain::Domain;
use critreg_core::pddl::Action;
use critreg_core::skill::{Description, Later, Skill, write_pair};
use critreg_core::task::{ControllerId, OperatorId, PredicateId};
use critreg_core::text::TextBuffer;
use heapless::Vec;

/// How many bytes of memory skills take.
///
/// @param config How much is tried, with the capacities.
/// @return The number of bytes; 0 if the configuration is wrong or memory cannot be that
/// large.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_skills_size(config: *const critreg_skills_config) -> usize {
    // SAFETY: the header makes it the caller's promise.
    let settings = unsafe { config::read(config) };
    let layout = settings
        .ok()
        .and_then(|own| SkillsLayout::new(own.capacity));
    layout.map_or(0, |layout| layout.size)
}

/// The alignment in bytes that the memory of skills needs. An array of uint64_t and what
/// malloc() returns have it.
#[unsafe(no_mangle)]
pub extern "C" fn critreg_skills_align() -> usize {
    ALIGNMENT
}

/// Makes skills in memory of the program; nothing is known of them yet. Add controllers,
/// skills and training tasks, see SKILLS above.
///
/// @param memory Memory for the skills, aligned to critreg_skills_align(). From now on it
/// belongs to them: do not write to it, move it or copy it.
/// @param memory_len Its length in bytes, at least critreg_skills_size().
/// @param domain The PDDL domain, ended by NUL. Copied.
/// @param layout Which numbers of a state belong to which object, ended by NUL: a domain
/// text that declares objects, and groups of those whose names differ from problem to
/// problem. Copied.
/// @param config How much is tried, with the length of a state.
/// @param skills Receives the handle, which lies at the start of the memory.
/// @return CRITREG_TOO_SMALL if the memory is too short for the capacities;
/// CRITREG_SYNTAX_ERROR (ask critreg_check_pddl() or critreg_check_domain() where);
/// CRITREG_CAPACITY_EXCEEDED if the texts find no room; CRITREG_INVALID_ARGUMENT for a wrong
/// configuration or a text that is not UTF-8; CRITREG_NULL_POINTER, CRITREG_MISALIGNED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_skills_init(
    memory: *mut c_void,
    memory_len: usize,
    domain: *const c_char,
    layout: *const c_char,
    config: *const critreg_skills_config,
    skills: *mut *mut critreg_skills,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise.
    status_of(unsafe { init(memory.cast(), memory_len, [domain, layout], config, skills) })
}

/// # Safety
/// The contract of [`critreg_skills_init`].
unsafe fn init(
    memory: *mut u8,
    memory_len: usize,
    [domain, layout]: [*const c_char; 2],
    config: *const critreg_skills_config,
    skills: *mut *mut critreg_skills,
) -> Fallible {
    pointer::check(memory.cast::<u64>(), "memory")?;
    // SAFETY: by this function's contract, for all.
    let (texts, settings, output) = unsafe {
        (
            [
                pointer::text(domain, CRITREG_PDDL_TEXT_MAX, "domain")?,
                pointer::text(layout, CRITREG_DOMAIN_TEXT_MAX, "layout")?,
            ],
            config::read(config)?,
            Output::new(skills, "skills")?,
        )
    };
    let layout = SkillsLayout::new(settings.capacity)
        .filter(|layout| layout.size <= memory_len)
        .ok_or(Failure::TooSmall("the memory of the skills"))?;
    // SAFETY: the memory was checked for NULL, alignment and length; the caller lends it to
    // these skills alone, and the parts of a layout do not overlap.
    unsafe {
        let place = layout.parts.handle.place(memory);
        // If this fails, skills that were here before are none any more.
        handle::retire(place);
        critreg_skills::put(place, layout.make(memory, texts, settings)?);
        output.write(place);
    }
    Ok(())
}

/// Adds a controller: what several PDDL actions may run, with its continuous parameters.
/// Actions that no controller names are controllers of their own, without parameters.
///
/// ```c
/// static const double along[2] = {0.0, 1.0};
/// status = critreg_skills_add_controller(skills, "PickStick",
///     "PickStickFromNothing PickStickFromButton", "?robot ?stick", along, 1);
/// ```
///
/// @param skills The skills.
/// @param name A name for it, ended by NUL. Copied.
/// @param actions The names of its actions, separated by blanks, ended by NUL. NULL: the
/// action that is called as it is.
/// @param objects Which parameters of each of these actions are its objects: their variables,
/// separated by blanks, ended by NUL. NULL: all of the first action. Objects that it is about
/// belong to it also where its command does not need them.
/// @param ranges The least and the greatest value of each continuous parameter: 2 * count
/// numbers. NULL if count is 0. Copied. They are those of its actions when a planner uses the
/// skills.
/// @param count How many parameters there are, at most CRITREG_MAX_PARAMETERS.
/// @return CRITREG_INVALID_ARGUMENT if there is no such action or variable, an action has a
/// controller already, the name is taken, or a range is upside down;
/// CRITREG_CAPACITY_EXCEEDED if it finds no room; CRITREG_OUT_OF_SEQUENCE after
/// critreg_skills_learn() or critreg_skills_resume(); CRITREG_NOT_FINITE, CRITREG_BUSY,
/// CRITREG_NULL_POINTER, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_skills_add_controller(
    skills: *mut critreg_skills,
    name: *const c_char,
    actions: *const c_char,
    objects: *const c_char,
    ranges: *const f64,
    count: usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_skills(skills, |inner| {
            let name = pointer::text(name, CRITREG_PDDL_TEXT_MAX, "name")?;
            let actions = match actions.is_null() {
                true => name,
                false => pointer::text(actions, CRITREG_PDDL_TEXT_MAX, "actions")?,
            };
            let objects = match objects.is_null() {
                true => None,
                false => Some(pointer::text(objects, CRITREG_PDDL_TEXT_MAX, "objects")?),
            };
            let ranges = Ranges::read(ranges, count)?;
            inner.add_controller(name, actions, objects, ranges)
        })
    }
}

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

/// Adds a training task. Several dozens of them, with different numbers of objects, are a
/// good beginning: what is never tried is never learned.
///
/// @param skills The skills.
/// @param problem A problem of the PDDL domain, ended by NUL; its goal does not matter.
/// Copied.
/// @param initial The state that it begins in. Copied.
/// @param len How many numbers it has.
/// @return CRITREG_SYNTAX_ERROR (ask critreg_check_pddl() where); CRITREG_MISMATCH if the
/// state is shorter than the layout says; CRITREG_CAPACITY_EXCEEDED if there is no room for
/// another task, its objects or its numbers; CRITREG_OUT_OF_SEQUENCE after
/// critreg_skills_learn() or critreg_skills_resume(); CRITREG_NOT_FINITE, CRITREG_BUSY,
/// CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_skills_add_task(
    skills: *mut critreg_skills,
    problem: *const c_char,
    initial: *const f64,
    len: usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_skills(skills, |inner| {
            let problem = pointer::text(problem, CRITREG_PDDL_TEXT_MAX, "problem")?;
            let initial = pointer::slice(initial, len, "initial")?;
            inner.add_task(problem, initial)
        })
    }
}

/// Why the last call on these skills failed that did fail, in words, as
/// critreg_learner_message().
///
/// @param skills The skills; may be called from their callbacks.
/// @param text Receives the words, ended by NUL.
/// @param len Length of text in bytes; 0 to ask for the length only.
/// @param needed NULL, or receives the length of the words with their NUL, also if the buffer
/// is too small.
/// @return CRITREG_TOO_SMALL (nothing but needed is written); CRITREG_NULL_POINTER,
/// CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_skills_message(
    skills: *const critreg_skills,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for both.
    unsafe {
        handle::read(skills, |handle| {
            text::write(&handle.message(), text, len, needed)
        })
    }
}

impl Inner {
    fn expect_open(&self) -> Fallible {
        match self.begun {
            true => Err(Error::OutOfSequence("learning has begun: nothing can be added").into()),
            false => Ok(()),
        }
    }

    /// Begins learning: from here on everything is as it is.
    pub(crate) fn begin(&mut self) -> Fallible {
        if self.begun {
            return Ok(());
        }
        if self.task_count == 0 {
            return Err(Error::OutOfSequence("add training tasks before learning").into());
        }
        self.add_other_actions()?;
        let training = &self.settings.training;
        let learner = &training.learner;
        let counts = [
            training.chained,
            training.budget,
            training.tasks as u32,
            training.situations as u32,
            training.states as u32,
            training.way,
            learner.calls,
            learner.certifying,
            self.settings.capacity.learner.forms as u32,
        ];
        let shares = [
            learner.exploring,
            learner.noise,
            learner.slack,
            learner.precision_wanted,
            learner.confidence,
        ];
        self.fingerprint.bytes(&learner.seed.to_le_bytes());
        self.fingerprint
            .numbers(counts.map(f64::from).into_iter().chain(shares));
        self.begun = true;
        Ok(())
    }

    /// Makes controllers of the actions that belong to none.
    fn add_other_actions(&mut self) -> Fallible {
        for (action, cell) in self.facts.pddl.actions().iter().zip(self.facts.calls) {
            if cell.get().is_none() {
                self.add_controller(action.name, action.name, None, Ranges::default())?;
            }
        }
        Ok(())
    }

    fn add_controller(
        &mut self,
        name: &str,
        actions: &str,
        objects: Option<&str>,
        ranges: Ranges,
    ) -> Fallible {
        self.expect_open()?;
        if self.facts.find(name).is_some() {
            return Err(Failure::invalid(
                "a controller of this name was added already",
            ));
        }
        let facts = self.facts;
        const FULL: Error = Error::CapacityExceeded("controllers: set config.controllers");
        let cell = facts.controllers.get(self.controller_count).ok_or(FULL)?;
        let id = ControllerId(u8::try_from(self.controller_count).map_err(|_| FULL)?);
        let mut arguments = None;
        // All is looked at before anything is added.
        for action in actions.split_ascii_whitespace() {
            let (place, action) = self.action(action)?;
            if facts
                .calls
                .get(place)
                .is_some_and(|call| call.get().is_some())
            {
                return Err(Failure::invalid("an action has a controller already"));
            }
            let call = self.call(action, id, objects)?;
            let variables = facts.pddl.parameters(action);
            let kinds = call.places.iter();
            let kinds = kinds.filter_map(|place| variables.get(usize::from(*place)));
            let kinds = kinds.map(|variable| facts.type_of(variable.type_id));
            let kinds: Vec<_, _> = kinds.fold(Vec::new(), |mut all, kind| {
                // There are no more places than there is room for.
                let _ = all.push(kind);
                all
            });
            if *arguments.get_or_insert(kinds.clone()) != kinds {
                return Err(Failure::invalid(
                    "the objects of a controller have other types in another action",
                ));
            }
        }
        let entry = ControllerEntry {
            name: self.texts.copy(name)?,
            arguments: arguments.ok_or(NO_ACTION)?,
            ranges,
        };
        for action in actions.split_ascii_whitespace() {
            let (place, action) = self.action(action)?;
            let call = self.call(action, id, objects)?;
            if let Some(cell) = facts.calls.get(place) {
                let _ = cell.set(call);
            }
        }
        let _ = cell.set(entry);
        self.controller_count += 1;
        for text in [name, actions, objects.unwrap_or("")] {
            self.fingerprint.text(text);
        }
        let ends = ranges.as_slice().as_flattened().iter();
        self.fingerprint.numbers(ends.copied());
        Ok(())
    }

    /// The action with a name, and its place.
    fn action(&self, name: &str) -> Fallible<(usize, &'static Action<'static>)> {
        let pddl = self.facts.pddl;
        let OperatorId(place) = pddl.find_action(name).ok_or(NO_ACTION)?;
        let action = pddl.actions().get(usize::from(place)).ok_or(NO_ACTION)?;
        Ok((usize::from(place), action))
    }

    /// How an action runs a controller with these variables as its objects.
    fn call(
        &self,
        action: &Action<'_>,
        controller: ControllerId,
        objects: Option<&str>,
    ) -> Fallible<ActionCall> {
        let variables = self.facts.pddl.parameters(action);
        let plain = |name: &'_ str| name.len() - name.strip_prefix('?').unwrap_or(name).len();
        let same = |one: &str, other: &str| {
            let (one, other) = (one.get(plain(one)..), other.get(plain(other)..));
            one.unwrap_or("").eq_ignore_ascii_case(other.unwrap_or(""))
        };
        let mut places = Vec::new();
        let mut add = |place: usize| {
            let pushed = places.push(place as u8);
            pushed.map_err(|_| Error::CapacityExceeded("objects of a controller"))
        };
        match objects {
            None => (0..variables.len()).try_for_each(&mut add)?,
            Some(objects) => {
                for object in objects.split_ascii_whitespace() {
                    let mut all = variables.iter();
                    let place = all.position(|variable| same(variable.name, object));
                    add(place.ok_or(Failure::invalid("an action has no variable of this name"))?)?;
                }
            }
        }
        Ok(ActionCall { controller, places })
    }

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

    /// The controller with a name; that of an action of this name if there is none.
    fn find_or_add(&mut self, name: &str) -> Fallible<ControllerId> {
        const NONE: Failure = Failure::invalid("there is no controller and no action of this name");
        if let Some(found) = self.facts.find(name) {
            return Ok(found);
        }
        let free = |place: usize| {
            let call = self.facts.calls.get(place);
            call.is_some_and(|call| call.get().is_none())
        };
        match self.action(name) {
            Ok((place, _)) if free(place) => {}
            _ => return Err(NONE),
        }
        self.add_controller(name, name, None, Ranges::default())?;
        self.facts.find(name).ok_or(NONE)
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

    fn add_task(&mut self, problem: &str, initial: &[f64]) -> Fallible {
        self.expect_open()?;
        const FULL: Error = Error::CapacityExceeded("training tasks: set config.tasks");
        let cell = self.tasks.get(self.task_count).ok_or(FULL)?;
        let mark = u16::try_from(self.task_count).map_err(|_| FULL)?;
        if initial.len() > self.settings.capacity.state_len {
            return Err(Error::CapacityExceeded("numbers of a state: set config.state_len").into());
        }
        if !initial.iter().all(|number| number.is_finite()) {
            return Err(Error::NotFinite("a number of the state").into());
        }
        let text = self.texts.copy(problem)?;
        let facts = self.facts;
        let read = self.desk.read(text);
        let state = read.and_then(|problem| Ok(arranged(&facts, problem, mark, initial)?));
        if state.is_err() {
            // SAFETY: only what lies on the desk refers to the copy, and that is read anew
            // before it is looked at again.
            unsafe { self.texts.forget_last(text) };
        }
        let _ = cell.set(TaskEntry {
            problem: text,
            state: state?,
        });
        self.task_count += 1;
        self.fingerprint.text(text);
        self.fingerprint.numbers(initial.iter().copied());
        Ok(())
    }
}
