//! Adding controllers: what actions run.

use crate::boundary::pointer;
use crate::boundary::status::{Failure, Fallible, critreg_status};
use crate::planner::config::CRITREG_PDDL_TEXT_MAX;
use crate::planner::tables::{NO_ACTION, Ranges};
use crate::skill::facts::{ActionCall, ControllerEntry};
use crate::skill::handle::{Inner, critreg_skills, with_skills};
use core::ffi::c_char;
use critreg_core::Error;
use critreg_core::pddl::Action;
use critreg_core::task::{ControllerId, OperatorId};
use heapless::Vec;

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

impl Inner {
    /// Makes controllers of the actions that belong to none.
    pub(super) fn add_other_actions(&mut self) -> Fallible {
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

    /// The controller with a name; that of an action of this name if there is none.
    pub(super) fn find_or_add(&mut self, name: &str) -> Fallible<ControllerId> {
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
}
