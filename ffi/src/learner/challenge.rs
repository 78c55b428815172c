//! What is learned, held against what is specified.

use crate::boundary::handle;
use crate::boundary::status::critreg_status;
use crate::learner::handle::{critreg_learner, with_learner};
use crate::region::handle::critreg_region;
use crate::region::implies::{Claim, critreg_proof};

/// Whether the region that a learner has satisfies a specification, as
/// critreg_region_implies(): if not, the counterexample is what to try next.
///
/// So learning goes on until the region is proven, or the proof says what is open: append
/// the instance to those of the learner, try the parameters there, and tell what came of it.
///
/// ```c
/// critreg_learn_region(learner, instances, count, try, user_data, &region);
/// while (critreg_learner_challenge(learner, specification, ranges, &proof, next, theta)
///        == CRITREG_OK && proof.verdict == CRITREG_REFUTED && count < room) {
///     memcpy(&instances[count * len], next, len * sizeof *next);
///     outcome = try_it(next, theta);
///     critreg_observe(learner, instances, count + 1, count, theta, outcome);
///     critreg_conclude(learner, instances, ++count);
/// }
/// ```
///
/// If the action works there after all, the specification asks for too much. The learner
/// needs room for the instances and observations that come to it.
///
/// @param learner The learner.
/// @param specification What the region has to satisfy: a region of the same domain text.
/// @param ranges A lower and an upper end for each number of an instance.
/// @param proof From critreg_proof_init(); what it may cost is read, what was found is
/// written.
/// @param instance Receives the instance of a counterexample.
/// @param theta Receives its parameters; NULL if the action has none.
/// @return CRITREG_NO_REGION if nothing is learned; CRITREG_BUSY; all others as
/// critreg_region_implies().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_learner_challenge(
    learner: *mut critreg_learner,
    specification: *const critreg_region,
    ranges: *const f64,
    proof: *mut critreg_proof,
    instance: *mut f64,
    theta: *mut f64,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_learner(learner, |handle, inner| {
            let claim = Claim {
                region: inner.learner.best_region()?,
                specification: handle::open(specification)?,
                domain: handle.domain,
            };
            claim.prove(ranges, proof, instance, theta)
        })
    }
}
