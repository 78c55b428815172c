//! A picture of what is learned.

use crate::boundary::precision::in_precision;
use crate::boundary::status::{Failure, critreg_status};
use crate::boundary::text;
use crate::learner::handle::{critreg_learner, problem, with_learner};
use core::ffi::c_char;
use core::fmt;
use critreg_core::learn::Outcome;
use critreg_core::picture::Picture;

/// Draws what is learned so far in an instance, as critreg_region_to_svg(), with what was
/// told about that instance: what worked in blue, what failed as red crosses. While there
/// is no region, only that and what the parameters can choose.
///
/// @param learner The learner.
/// @param instances The instances of the problem, one behind the other.
/// @param count How many there are.
/// @param index Which of them is drawn, from 0.
/// @param text Receives the SVG, ended by NUL.
/// @param len Length of text in bytes; 0 to ask for the length only.
/// @param needed NULL, or receives the length of the text with its NUL, also if the
/// buffer is too small.
/// @return CRITREG_TOO_SMALL (nothing but needed is written); CRITREG_INVALID_ARGUMENT for
/// an index that is not below count; and as critreg_region_to_svg() and critreg_ask().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_learner_to_svg(
    learner: *mut critreg_learner,
    instances: *const f64,
    count: usize,
    index: usize,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_learner(learner, |handle, inner| {
            if index >= count {
                return Err(Failure::invalid("there is no instance with this index"));
            }
            let problem = problem(handle, instances, count)?;
            let observations = inner.learner.observations();
            let tried = |mark: &mut dyn FnMut(&[f64], bool)| {
                let here = observations
                    .iter()
                    .filter(|own| own.query().instance == index && own.outcome != Outcome::Unknown);
                for own in here {
                    mark(&own.theta, own.outcome.is_feasible());
                }
            };
            let picture = Picture {
                domain: handle.domain,
                instance: problem.instance(index)?,
                region: inner.learner.best_region().ok(),
                tried: &tried,
            };
            let write = |out: &mut dyn fmt::Write| in_precision!(inner.precision, R => Ok(picture.write_svg::<R>(out)?));
            text::write_by(write, text, len, needed)
        })
    }
}
