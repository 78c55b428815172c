//! What is wrong with a configuration, in words.

use crate::boundary::status::{Failure, Fallible, Message, critreg_status};
use crate::boundary::text::explain;
use crate::learner::config::{
    self, CRITREG_DEFAULT_FORMS, CRITREG_MAX_OBSERVATIONS, CRITREG_MAX_STEPS,
    CRITREG_VERSION_SPACE, critreg_config,
};
use crate::learner::layout::LearnerLayout;
use core::ffi::c_char;

/// Looks at the configuration of a learner and says what is wrong with it, such as
/// "config.noise is from 0 to 0.2, not 0.5".
///
/// What depends on the domain text is not looked at: the manual samples of
/// CRITREG_ALGORITHM1.
///
/// @param config The configuration, from critreg_config_init() and changed since; NULL for
/// the defaults, with which nothing is wrong.
/// @param text Receives the words, as for critreg_check_domain().
/// @param len Length of text in bytes; 0 if the words are not wanted.
/// @param needed NULL, or receives the length of the words with their NUL.
/// @return CRITREG_OK if critreg_learner_init() would accept it, given memory enough;
/// CRITREG_INVALID_ARGUMENT; CRITREG_NOT_FINITE for a share that is NaN or infinite;
/// CRITREG_TOO_SMALL if no memory can be that large; CRITREG_NULL_POINTER,
/// CRITREG_MISALIGNED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_check_config(
    config: *const critreg_config,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for both.
    unsafe {
        let checked = config::read(config).and_then(|config| check_learner(&config));
        explain(&Message(checked.err()), checked, text, len, needed)
    }
}

/// What is wrong with the configuration of a learner.
fn check_learner(config: &critreg_config) -> Fallible {
    if !(1..=CRITREG_MAX_STEPS).contains(&config.steps) {
        return Err(out_of_range("config.steps is from 1 to 4", config.steps));
    }
    if config.observations > CRITREG_MAX_OBSERVATIONS {
        let what = "config.observations is up to 2048";
        return Err(out_of_range(what, config.observations));
    }
    if config.learner == CRITREG_VERSION_SPACE {
        for (expected, share, [low, high]) in config.shares().shares() {
            if !(low..=high).contains(&share) {
                return Err(Failure::Share(expected, share.to_ne_bytes()));
            }
        }
    }
    let mut capacity = config.capacity()?;
    if capacity.forms() == 0 {
        capacity = capacity.with_forms(CRITREG_DEFAULT_FORMS as usize);
    }
    let layout = LearnerLayout::new(capacity, config.precision()?);
    layout
        .map(|_| ())
        .ok_or(Failure::TooSmall("any memory, for these capacities"))
}

fn out_of_range(expected: &'static str, number: u32) -> Failure {
    Failure::Number(expected, i32::try_from(number).unwrap_or(i32::MAX))
}
