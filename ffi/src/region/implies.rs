//! Whether a region satisfies a specification, in all instances at once.

use crate::boundary::handle;
use crate::boundary::pointer::{self, Output, OutputArray};
use crate::boundary::status::{Failure, Fallible, critreg_status, status_of};
use crate::boundary::structs::{self, Versioned};
use crate::boundary::text;
use crate::region::handle::critreg_region;
use core::ffi::c_char;
use core::fmt;
use core::mem::offset_of;
use critreg_core::domain::Domain;
use critreg_core::region::{Limit, ProofConfig, Region, Verdict};

/// In a critreg_proof: neither a proof nor a counterexample was found.
pub const CRITREG_UNDECIDED: u32 = 0;
/// In a critreg_proof: the region satisfies the specification, in all instances in the
/// ranges and with all parameters.
pub const CRITREG_PROVEN: u32 = 1;
/// In a critreg_proof: there is a counterexample.
pub const CRITREG_REFUTED: u32 = 2;

/// What critreg_region_implies() may cost, and what it found.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct critreg_proof {
    /// Size of this struct in bytes, from critreg_proof_init().
    pub struct_size: u32,
    /// How many boxes of instances and parameters are examined at most for each statement of
    /// the specification, and for each member of a group that it is about. A box takes ten
    /// to a hundred microseconds. Default: 20000.
    pub max_boxes: u32,
    /// By how much a constraint of the specification may be missed, in its own unit: above
    /// zero. Default: 1e-6.
    pub tolerance: f64,
    /// CRITREG_PROVEN, CRITREG_REFUTED or CRITREG_UNDECIDED.
    pub verdict: u32,
    /// If it is undecided: 1 if a box was halved as often as there is room for, so that more
    /// boxes do not help; else 0, and they may.
    pub too_fine: u32,
    /// If it is not proven: which of the statements that the specification joins by "and" is
    /// refuted, or has most that is open; from 0.
    pub statement: u32,
    /// How many boxes were examined.
    pub boxes: u32,
    /// If it is undecided: the share of the cases of that statement that is open.
    pub open: f64,
}

// SAFETY: it is repr(C) and starts with struct_size.
unsafe impl Versioned for critreg_proof {
    const FIRST: usize = offset_of!(critreg_proof, open) + size_of::<f64>();
}

impl critreg_proof {
    fn new(config: ProofConfig) -> Self {
        critreg_proof {
            struct_size: size_of::<critreg_proof>() as u32,
            max_boxes: config.boxes,
            tolerance: config.tolerance,
            verdict: CRITREG_UNDECIDED,
            too_fine: 0,
            statement: 0,
            boxes: 0,
            open: 0.0,
        }
    }

    fn config(&self) -> ProofConfig {
        ProofConfig {
            boxes: self.max_boxes,
            tolerance: self.tolerance,
        }
    }
}

/// Prepares a proof for critreg_region_implies(), with defaults.
///
/// @param proof The proof.
/// @param size sizeof *proof; see critreg_config_init().
/// @return As critreg_config_init().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_proof_init(
    proof: *mut critreg_proof,
    size: usize,
) -> critreg_status {
    let defaults = critreg_proof::new(ProofConfig::default());
    // SAFETY: the header makes it the caller's promise.
    status_of(unsafe { structs::init(proof, size, defaults) })
}

/// Whether all that a region admits satisfies a specification, in every instance whose
/// numbers are in ranges.
///
/// A specification is a region of the same domain text that says what must hold, as "the
/// hand stays in its zone and clear of every obstacle":
///
/// ```c
/// critreg_region_parse(memory, sizeof memory, domain_text,
///     "hand.y + radius <= zone.top and min(clear(hand, obstacle)) >= 0", &specification);
/// critreg_proof_init(&proof, sizeof proof);
/// critreg_region_implies(region, specification, ranges, &proof, instance, theta);
/// if (proof.verdict == CRITREG_REFUTED)
///     try_it(instance, theta);
/// ```
///
/// A proof is one in real arithmetic (rounding is outward), up to proof.tolerance. A
/// counterexample is in the region and not in the specification, as
/// critreg_region_contains() tells of double precision. Statements are proven one by one,
/// those about all members of a group for one member at a time, so their number costs
/// little. Members of groups may be there or not; one whose ranges are NaN never is. What
/// touches what is specified without a gap, or hangs together by many numbers, may stay
/// undecided.
///
/// Some things cannot be proven: angles with a symmetry, lines of sight, and how clear two
/// bodies are of each other that both have sides. A specification about them is refused;
/// in a region they count as if they were not said.
///
/// @param region The region.
/// @param specification What it has to satisfy.
/// @param ranges A lower and an upper end for each number of an instance.
/// @param proof From critreg_proof_init(); what it may cost is read, what was found is
/// written.
/// @param instance Receives the instance of a counterexample, one number per attribute: NaN
/// for those of members that it is not about. What it holds is undefined unless there is one.
/// @param theta Receives its parameters, if there is one; NULL if the action has none.
/// @return CRITREG_MISMATCH for regions of two domain texts; CRITREG_INVALID_ARGUMENT for a
/// specification that cannot be proven, and for a range or a tolerance that is none;
/// CRITREG_NOT_FINITE for a range; CRITREG_CAPACITY_EXCEEDED for more terms than there is
/// room for; CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_region_implies(
    region: *const critreg_region,
    specification: *const critreg_region,
    ranges: *const f64,
    proof: *mut critreg_proof,
    instance: *mut f64,
    theta: *mut f64,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        handle::read(region, |handle| {
            let claim = Claim {
                region: &handle.region,
                specification: handle::open(specification)?,
                domain: handle.domain,
            };
            claim.prove(ranges, proof, instance, theta)
        })
    }
}

/// That a region satisfies a specification.
pub(crate) struct Claim<'r> {
    pub(crate) region: &'r Region,
    pub(crate) specification: &'r critreg_region,
    pub(crate) domain: &'r Domain<'r>,
}

impl Claim<'_> {
    /// Proves or refutes it.
    ///
    /// # Safety
    /// As for [`critreg_region_implies`].
    pub(crate) unsafe fn prove(
        &self,
        ranges: *const f64,
        proof: *mut critreg_proof,
        instance: *mut f64,
        theta: *mut f64,
    ) -> Fallible {
        let defaults = critreg_proof::new(ProofConfig::default());
        let (instances, parameters) = (self.domain.instance_len(), self.domain.parameters().len());
        // SAFETY: by this function's contract, for all.
        let (mut answer, ranges, theta, instance) = unsafe {
            (
                structs::read(proof, defaults, "proof")?,
                pointer::slice(ranges, 2 * instances, "ranges")?,
                OutputArray::new(theta, parameters, "theta")?,
                pointer::zeros(instance, instances, "instance")?,
            )
        };
        let found = self.region.implies(
            &self.specification.region,
            self.domain,
            ranges.as_chunks().0,
            answer.config(),
            instance,
        )?;
        let too_many = Failure::invalid("a specification has more statements than are counted");
        answer.statement = u32::try_from(found.statement).map_err(|_| too_many)?;
        answer.boxes = found.boxes;
        (answer.open, answer.too_fine) = (0.0, 0);
        answer.verdict = match found.verdict {
            Verdict::Proven => CRITREG_PROVEN,
            Verdict::Refuted { theta: found } => {
                theta.write(&found);
                CRITREG_REFUTED
            }
            Verdict::Undecided { open, limit } => {
                answer.open = open;
                answer.too_fine = u32::from(limit == Limit::Halvings);
                CRITREG_UNDECIDED
            }
        };
        // SAFETY: by this function's contract.
        unsafe { structs::write(answer, proof, "proof") }
    }
}

/// How many questions for another prover a specification is, see critreg_region_to_smt2():
/// one for each statement that it joins by "and", and for each member of a group that this
/// is about.
///
/// @param specification The specification.
/// @param count Receives how many there are; 0 for "true".
/// @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_region_question_count(
    specification: *const critreg_region,
    count: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        handle::read(specification, |handle| {
            let output = Output::new(count, "count")?;
            output.write(handle.region.question_count(handle.domain)?);
            Ok(())
        })
    }
}

/// Writes one of the questions of critreg_region_implies() as SMT-LIB 2, for another prover:
/// z3 and its like answer "unsat" if the region satisfies this part of the specification in
/// all instances in the ranges, up to the tolerance. "sat" is a counterexample, if the
/// angles that the model stands for are in their ranges.
///
/// Numbers are reals, written as the shortest decimals; an angle is a point of the unit
/// circle, a distance a number with a square. Angles between what moves are not said. A
/// prover may take for ever where something turns; critreg_region_implies() mostly does not.
///
/// @param region The region.
/// @param specification What it has to satisfy.
/// @param ranges A lower and an upper end for each number of an instance.
/// @param proof NULL for defaults, or a struct from critreg_proof_init() with the tolerance.
/// @param number Which question, from 0; see critreg_region_question_count().
/// @param text Receives the script, ended by NUL.
/// @param len Length of text in bytes; 0 to ask for the length only.
/// @param needed NULL, or receives the length of the text with its NUL, also if the buffer
/// is too small.
/// @return CRITREG_TOO_SMALL (nothing but needed is written); CRITREG_INVALID_ARGUMENT for a
/// number that no question has; all others as critreg_region_implies().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_region_to_smt2(
    region: *const critreg_region,
    specification: *const critreg_region,
    ranges: *const f64,
    proof: *const critreg_proof,
    number: usize,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        handle::read(region, |region| {
            let specification = handle::open(specification)?;
            let defaults = critreg_proof::new(ProofConfig::default());
            let config = match proof.is_null() {
                true => defaults,
                false => structs::read(proof, defaults, "proof")?,
            };
            let ranges = pointer::slice(ranges, 2 * region.domain.instance_len(), "ranges")?;
            let (own, specification) = (&region.region, &specification.region);
            let (ranges, which) = (ranges.as_chunks().0, (config.config(), number));
            let write = |out: &mut dyn fmt::Write| {
                Ok(own.write_smt2(specification, region.domain, ranges, which, out)?)
            };
            text::write_by(write, text, len, needed)
        })
    }
}
