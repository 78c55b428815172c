//! The built-in stick-button environment.

use crate::boundary::pointer::{self, Output, OutputArray};
use crate::boundary::status::{Failure, Fallible, critreg_status, status_of};
use crate::learner::outcome::{CRITREG_FEASIBLE, CRITREG_INFEASIBLE, critreg_outcome};
use core::ffi::{c_char, c_void};
use critreg_core::Error;
use critreg_core::env::stick_button::StickButton;
use critreg_core::random::generator;

/// Option of the stick-button environment: robot and stick can turn, and lie at
/// any angle in new tasks. Without it all angles are pi/2, as in the thesis.
pub const CRITREG_STICK_BUTTON_ANGLES: u32 = 1;

const TEXT: &str = StickButton::PICK_DOMAIN;

/// The domain text as C wants it.
static DOMAIN: [u8; TEXT.len() + 1] = ended_by_nul(TEXT.as_bytes());

#[expect(clippy::indexing_slicing, reason = "runs while compiling only")]
const fn ended_by_nul<const N: usize>(text: &[u8]) -> [u8; N] {
    let mut bytes = [0; N];
    let mut index = 0;
    while index < text.len() {
        assert!(text[index] != 0, "a text of C has no NUL inside");
        bytes[index] = text[index];
        index += 1;
    }
    bytes
}

fn environment(options: u32) -> Fallible<StickButton> {
    match options {
        0 => Ok(StickButton { angles: false }),
        CRITREG_STICK_BUTTON_ANGLES => Ok(StickButton { angles: true }),
        _ => Err(Failure::invalid("unknown option of the environment")),
    }
}

/// The environment with the options at a pointer, which may be NULL for none.
///
/// # Safety
/// If not NULL and aligned, the pointer is readable.
pub(crate) unsafe fn environment_of(options: *const u32) -> Fallible<StickButton> {
    if options.is_null() {
        return environment(0);
    }
    pointer::check(options, "user_data")?;
    // SAFETY: checked; readable by this function's contract.
    environment(unsafe { options.read() })
}

pub(crate) fn all_finite(numbers: &[f64], what: &'static str) -> Fallible {
    if numbers.iter().all(|number| number.is_finite()) {
        Ok(())
    } else {
        Err(Error::NotFinite(what).into())
    }
}

/// The domain text of picking the stick with one button on the table, the action
/// PickStickFromNothing of the thesis. Its one parameter is mu, the place of the
/// grasp along the stick, from 0 to 1.
///
/// @return A static text, never NULL.
#[unsafe(no_mangle)]
pub extern "C" fn critreg_stick_button_domain() -> *const c_char {
    DOMAIN.as_ptr().cast()
}

/// How many numbers a state has: robot x, y, theta; stick x, y, theta, held; holder
/// x, y, theta; and x, y, pressed of each button. Lengths are in units of the table
/// (10 by 6), angles in radians. An instance of critreg_stick_button_domain() is a
/// state with one button.
#[unsafe(no_mangle)]
pub extern "C" fn critreg_stick_button_state_len(buttons: u32) -> usize {
    StickButton::PICK_INSTANCE_LEN - 3 + 3 * buttons as usize
}

/// Draws a random task, to press all buttons, and writes its initial state. Nothing
/// is held in it, and the robot and the stick lie above no button.
///
/// @param seed Every seed gives one task, the same on every machine.
/// @param options 0 or CRITREG_STICK_BUTTON_ANGLES.
/// @param buttons How many buttons there are, from 1 to 10.
/// @param state Receives the state.
/// @param len Length of state in numbers, at least
/// critreg_stick_button_state_len().
/// @return CRITREG_TOO_SMALL; CRITREG_INVALID_ARGUMENT for unknown options or
/// another number of buttons; CRITREG_NULL_POINTER, CRITREG_MISALIGNED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_stick_button_task(
    seed: u64,
    options: u32,
    buttons: u32,
    state: *mut f64,
    len: usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise.
    status_of(unsafe { task(seed, options, buttons, state, len) })
}

/// # Safety
/// If not NULL and aligned, `state` is writable for `len` numbers.
unsafe fn task(seed: u64, options: u32, buttons: u32, state: *mut f64, len: usize) -> Fallible {
    pointer::check(state, "state")?;
    let count = buttons as usize;
    let arranged = environment(options)?.arrange(count..=count, &mut generator(seed))?;
    let needed = critreg_stick_button_state_len(buttons);
    if len < needed {
        return Err(Failure::TooSmall("the array for the state"));
    }
    // SAFETY: by this function's contract.
    let state = unsafe { OutputArray::new(state, needed, "state")? };
    state.write_each(arranged.world().values());
    Ok(())
}

/// Tries to pick the stick: a critreg_simulate to pass to critreg_learn_region().
/// It rolls the controller out, at most 50 steps of the environment.
///
/// @param user_data NULL, or a pointer to a uint32_t with options: 0 or
/// CRITREG_STICK_BUTTON_ANGLES. It is only read.
/// @param instance The instance: a state with one button.
/// @param theta The parameter mu.
/// @param outcome Receives CRITREG_FEASIBLE or CRITREG_INFEASIBLE.
/// @return CRITREG_NOT_FINITE for a number of the instance or for mu;
/// CRITREG_INVALID_ARGUMENT for unknown options; CRITREG_NULL_POINTER,
/// CRITREG_MISALIGNED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_stick_button_pick(
    user_data: *mut c_void,
    instance: *const f64,
    theta: *const f64,
    outcome: *mut critreg_outcome,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise.
    status_of(unsafe { pick(user_data.cast(), instance, theta, outcome) })
}

/// # Safety
/// The contract of [`critreg_stick_button_pick`].
unsafe fn pick(
    options: *const u32,
    instance: *const f64,
    theta: *const f64,
    outcome: *mut critreg_outcome,
) -> Fallible {
    // SAFETY: by this function's contract, for all.
    let (environment, output, instance, theta) = unsafe {
        (
            environment_of(options)?,
            Output::new(outcome, "outcome")?,
            pointer::slice(instance, StickButton::PICK_INSTANCE_LEN, "instance")?,
            pointer::slice(theta, 1, "theta")?,
        )
    };
    all_finite(instance, "a number of an instance")?;
    all_finite(theta, "the parameter")?;
    let answer = environment.try_pick(instance, theta)?;
    output.write(if answer.is_feasible() {
        CRITREG_FEASIBLE
    } else {
        CRITREG_INFEASIBLE
    });
    Ok(())
}
