//! The built-in stick-button environment, to plan in.

use crate::boundary::pointer::{self, Output, OutputArray};
use crate::boundary::status::{Failure, Fallible, critreg_status, status_of};
use crate::planner::callbacks::critreg_ground;
use crate::stick_button::environment::{all_finite, environment_of};
use core::ffi::c_void;
use core::fmt::Write as _;
use critreg_core::env::stick_button::{StickButton, World};
use critreg_core::task::{Arguments, Environment, MAX_ARGUMENTS, ObjectId, State, TypeId, rollout};
use heapless::{String, Vec};

/// Runs an operator of the environment: a critreg_execute for critreg_callbacks.
///
/// The operators are RobotPressButtonFromNothing (robot button stick),
/// RobotPressButtonFromButton (robot button from stick), PickStickFromNothing (robot
/// stick), PickStickFromButton (robot stick from), StickPressButtonFromNothing (robot
/// stick button), StickPressButtonFromButton (robot stick button from),
/// PlaceStickFromNothing (robot stick) and PlaceStickFromButton (robot stick).
/// Picking has the parameter mu from 0 to 1, placing one from -1 to 1. The objects
/// are robby, stick, holder, button0, button1 and so on, in the order of the state.
///
/// @param user_data NULL, or a pointer to a uint32_t with options, as for
/// critreg_stick_button_pick().
/// @param ground The operator; its name and those of its objects count, its indices
/// do not.
/// @param parameters Its parameters.
/// @param before The state before.
/// @param after Receives the state afterwards; the same one if it failed.
/// @param len Numbers of a state: critreg_stick_button_state_len().
/// @param actions Receives how many steps of the environment it took; 0 if it
/// failed.
/// @return CRITREG_INVALID_ARGUMENT for an unknown operator, object or option, or a
/// wrong number of objects or of numbers; CRITREG_NOT_FINITE, CRITREG_NULL_POINTER,
/// CRITREG_MISALIGNED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_stick_button_execute(
    user_data: *mut c_void,
    ground: *const critreg_ground,
    parameters: *const f64,
    before: *const f64,
    after: *mut f64,
    len: usize,
    actions: *mut u32,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    status_of(unsafe {
        Scene::read(user_data.cast(), ground, before, len)
            .and_then(|scene| scene.execute(parameters, after, actions))
    })
}

/// Tells whether an atom of the environment holds: a critreg_holds for
/// critreg_callbacks.
///
/// The predicates are AboveNoButton (), Grasped (robot stick), HandEmpty (robot),
/// Pressed (button), RobotAboveButton (robot button) and StickAboveButton (stick
/// button).
///
/// @param user_data As for critreg_stick_button_execute().
/// @param ground The atom; its name and those of its objects count.
/// @param state The state.
/// @param len Numbers of a state: critreg_stick_button_state_len().
/// @param holds Receives 1 or 0.
/// @return CRITREG_INVALID_ARGUMENT for an unknown predicate, object or option, or a
/// wrong number of objects or of numbers; CRITREG_NOT_FINITE, CRITREG_NULL_POINTER,
/// CRITREG_MISALIGNED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_stick_button_holds(
    user_data: *mut c_void,
    ground: *const critreg_ground,
    state: *const f64,
    len: usize,
    holds: *mut i32,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    status_of(unsafe {
        Scene::read(user_data.cast(), ground, state, len).and_then(|scene| scene.holds(holds))
    })
}

/// A state, and what of the environment is asked about in it.
struct Scene<'a> {
    environment: StickButton,
    name: &'a str,
    objects: Arguments,
    state: State,
}

impl<'a> Scene<'a> {
    /// # Safety
    /// If not NULL and aligned, the pointers are readable: `state` for `len`
    /// numbers, the names of `ground` up to their NUL.
    unsafe fn read(
        options: *const u32,
        ground: *const critreg_ground,
        state: *const f64,
        len: usize,
    ) -> Fallible<Scene<'a>> {
        pointer::check(ground, "ground")?;
        // SAFETY: checked, and by this function's contract, for all.
        let (environment, ground, numbers) = unsafe {
            (
                environment_of(options)?,
                ground.read(),
                pointer::slice(state, len, "state")?,
            )
        };
        all_finite(numbers, "a number of the state")?;
        let world = World::read(numbers).ok_or(Failure::invalid("this is no state"))?;
        let state = world.to_state()?;
        let names = ground.object_names.get(..ground.object_count as usize);
        let names = names.ok_or(Failure::invalid("there are too many objects"))?;
        let mut objects = Vec::<ObjectId, MAX_ARGUMENTS>::new();
        for name in names {
            // SAFETY: by this function's contract.
            let name = unsafe { pointer::text(*name, LONGEST_NAME, "object_names")? };
            let object = object(&state, name);
            let object = object.ok_or(Failure::invalid("there is no such object"))?;
            // There is room: names are as many at most.
            let _ = objects.push(object);
        }
        Ok(Scene {
            environment,
            // SAFETY: by this function's contract.
            name: unsafe { pointer::text(ground.name, LONGEST_NAME, "name")? },
            objects: Arguments::new(objects)?,
            state,
        })
    }

    /// # Safety
    /// If not NULL and aligned, `parameters` is readable for those of the operator,
    /// and `after`, for a state, and `actions` are writable.
    unsafe fn execute(
        &self,
        parameters: *const f64,
        after: *mut f64,
        actions: *mut u32,
    ) -> Fallible {
        const UNKNOWN: Failure = Failure::invalid("there is no such operator");
        let (environment, objects) = (&self.environment, self.objects.as_slice());
        let mut operators = StickButton::OPERATORS.iter();
        let operator = operators.find(|o| o.name.eq_ignore_ascii_case(self.name));
        let operator = operator.ok_or(UNKNOWN)?;
        self.expect_types(operator.parameters)?;
        let controllers = StickButton::CONTROLLERS;
        let controller = controllers.get(usize::from(operator.controller.0));
        let controller = controller.ok_or(UNKNOWN)?;
        // SAFETY: by this function's contract.
        let (theta, output, actions) = unsafe {
            (
                pointer::slice(parameters, controller.parameters.len(), "parameters")?,
                OutputArray::new(after, self.state.values().len(), "after")?,
                Output::new(actions, "actions")?,
            )
        };
        all_finite(theta, "a parameter")?;
        let objects = operator.controller_objects(objects)?;
        let run = rollout(
            environment,
            controller,
            objects.as_slice(),
            theta,
            &self.state,
        );
        output.write(run.state.values());
        actions.write(run.actions);
        Ok(())
    }

    /// # Safety
    /// If not NULL and aligned, `holds` is writable.
    unsafe fn holds(&self, holds: *mut i32) -> Fallible {
        // SAFETY: by this function's contract.
        let output = unsafe { Output::new(holds, "holds")? };
        let mut predicates = StickButton::PREDICATES.iter();
        let predicate = predicates.find(|p| p.name.eq_ignore_ascii_case(self.name));
        let predicate = predicate.ok_or(Failure::invalid("there is no such predicate"))?;
        self.expect_types(predicate.arguments)?;
        let objects = self.objects.as_slice();
        let holds = (predicate.classifier)(&self.environment, &self.state, objects);
        output.write(i32::from(holds));
        Ok(())
    }

    fn expect_types(&self, types: &[TypeId]) -> Fallible {
        let objects = self.objects.as_slice().iter();
        let own = objects.filter_map(|object| self.state.type_of(*object));
        if own.eq(types.iter().copied()) {
            Ok(())
        } else {
            Err(Failure::invalid("the objects are not of the right types"))
        }
    }
}

/// Longest name of the environment in bytes, with its NUL.
const LONGEST_NAME: usize = 32;

/// The object with this name.
fn object(state: &State, name: &str) -> Option<ObjectId> {
    let types = StickButton::TYPES;
    let mut objects = state.objects().map(|(object, _)| object);
    objects.find(|object| {
        let mut text = String::<LONGEST_NAME>::new();
        let own = state.name(types, *object);
        own.is_some_and(|own| write!(text, "{own}").is_ok() && text.eq_ignore_ascii_case(name))
    })
}
