//! The constraints of a region, one by one.

use crate::boundary::handle;
use crate::boundary::pointer::Output;
use crate::boundary::status::{Failure, Fallible, critreg_status, status_of};
use crate::boundary::structs::{self, Versioned};
use crate::boundary::text;
use crate::region::handle::critreg_region;
use core::ffi::c_char;
use core::fmt;
use critreg_core::grammar::Constraint;

/// What supports a constraint of a region: what any other bound would have to
/// agree with.
///
/// A bound of the constraint's left side fits the observations if it is not inside
/// of feasible, S, and stays inside of infeasible, G: an upper bound from S to
/// below G, a lower bound from above G to S. The gap between them is what is not
/// known.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct critreg_constraint {
    /// Size of this struct in bytes, from critreg_constraint_init().
    pub struct_size: u32,
    /// 1 if CRITREG_VERSION_SPACE learned it and the region still belongs to the
    /// learner; 0 for other regions, of which no more is known. Then the numbers
    /// below are 0, and NAN for S and G.
    pub has_evidence: i32,
    /// The step of the sequence of actions that needs it, from 1.
    pub step: u32,
    /// How many infeasible samples it excludes.
    pub support: u32,
    /// S: the extreme value at the feasible samples, apart from those it ignores.
    pub feasible: f64,
    /// G: the value at the first infeasible sample that it alone excludes, or, if
    /// there is none, at the first one that it excludes.
    pub infeasible: f64,
}

// SAFETY: it is repr(C) and starts with struct_size.
unsafe impl Versioned for critreg_constraint {
    const FIRST: usize = size_of::<critreg_constraint>();
}

const UNKNOWN: critreg_constraint = critreg_constraint {
    struct_size: size_of::<critreg_constraint>() as u32,
    has_evidence: 0,
    step: 0,
    support: 0,
    feasible: f64::NAN,
    infeasible: f64::NAN,
};

/// What is written about one constraint.
#[derive(Clone, Copy)]
enum Part {
    Everything,
    Name,
}

/// A constraint of a region, to be written.
struct Shown<'r> {
    region: &'r critreg_region,
    constraint: &'r Constraint,
    part: Part,
}

impl fmt::Display for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (domain, formula) = (self.region.domain, self.region.region.formula());
        match (self.part, self.constraint.name) {
            (Part::Everything, _) => formula.write_constraint(domain, f, self.constraint),
            (Part::Name, Some(name)) => domain.write_expression(f, formula.nodes(), name),
            (Part::Name, None) => Ok(()),
        }
    }
}

fn constraint(region: &critreg_region, index: usize) -> Fallible<&Constraint> {
    let known = region.region.formula().constraints().get(index);
    known.ok_or(Failure::invalid("there is no constraint with this index"))
}

/// How many constraints a region has: those of its text from left to right,
/// whatever connects them.
///
/// ```c
/// size_t count, i;
/// CHECK(critreg_region_constraint_count(region, &count));
/// for (i = 0; i < count; i++) {
///     critreg_constraint constraint;
///     char text[256];
///     CHECK(critreg_constraint_init(&constraint, sizeof constraint));
///     CHECK(critreg_region_constraint(region, i, &constraint));
///     CHECK(critreg_region_constraint_format(region, i, text, sizeof text, NULL));
///     printf("%s excludes %u failures\n", text, (unsigned)constraint.support);
/// }
/// ```
///
/// @param region The region.
/// @param count Receives the number, at most CRITREG_MAX_CONSTRAINTS.
/// @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_region_constraint_count(
    region: *const critreg_region,
    count: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for both.
    unsafe {
        handle::read(region, |handle| {
            let constraints = handle.region.formula().constraints();
            Output::new(count, "count")?.write(constraints.len());
            Ok(())
        })
    }
}

/// Prepares a struct for critreg_region_constraint().
///
/// @param constraint The struct.
/// @param size sizeof *constraint; see critreg_config_init().
/// @return As critreg_config_init().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_constraint_init(
    constraint: *mut critreg_constraint,
    size: usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise.
    status_of(unsafe { structs::init(constraint, size, UNKNOWN) })
}

/// What supports a constraint of a region.
///
/// @param region The region.
/// @param index Index of the constraint, from 0.
/// @param constraint A struct from critreg_constraint_init(), to be filled.
/// @return CRITREG_INVALID_ARGUMENT if there is no constraint with this index or
/// the struct was not initialised; CRITREG_NULL_POINTER, CRITREG_MISALIGNED,
/// CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_region_constraint(
    region: *const critreg_region,
    index: usize,
    constraint: *mut critreg_constraint,
) -> critreg_status {
    let fill = |handle: &critreg_region| {
        self::constraint(handle, index)?;
        let known = handle.evidence(index).map(|evidence| critreg_constraint {
            has_evidence: 1,
            step: evidence.step,
            support: evidence.support,
            feasible: evidence.feasible,
            infeasible: evidence.infeasible,
            ..UNKNOWN
        });
        // SAFETY: the header makes it the caller's promise.
        unsafe { structs::write(known.unwrap_or(UNKNOWN), constraint, "constraint") }
    };
    // SAFETY: as above.
    unsafe { handle::read(region, fill) }
}

/// Writes a constraint of a region as text, with the name of its bound in brackets
/// if it has one, as in critreg_region_format(). It is itself the text of a region.
///
/// @param region The region.
/// @param index Index of the constraint, from 0.
/// @param text Receives the text, ended by NUL.
/// @param len Length of text in bytes; 0 to ask for the length only.
/// @param needed NULL, or receives the length of the text with its NUL, also if
/// the buffer is too small.
/// @return CRITREG_TOO_SMALL (nothing but needed is written);
/// CRITREG_INVALID_ARGUMENT if there is no constraint with this index;
/// CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_region_constraint_format(
    region: *const critreg_region,
    index: usize,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise.
    unsafe { write(region, index, Part::Everything, text, len, needed) }
}

/// Writes the name of a constraint's bound as text: what it is in terms of the
/// domain's constants, such as "zone.top - robot.radius".
///
/// @param region The region.
/// @param index Index of the constraint, from 0.
/// @param text Receives the text, ended by NUL; an empty text if the bound has no
/// name.
/// @param len Length of text in bytes; 0 to ask for the length only.
/// @param needed NULL, or receives the length of the text with its NUL, also if
/// the buffer is too small.
/// @return As critreg_region_constraint_format().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_region_constraint_name(
    region: *const critreg_region,
    index: usize,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise.
    unsafe { write(region, index, Part::Name, text, len, needed) }
}

/// # Safety
/// The contract of [`critreg_region_constraint_format`].
unsafe fn write(
    region: *const critreg_region,
    index: usize,
    part: Part,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    let shown = |handle: &critreg_region| {
        let shown = Shown {
            region: handle,
            constraint: constraint(handle, index)?,
            part,
        };
        // SAFETY: by this function's contract.
        unsafe { text::write(&shown, text, len, needed) }
    };
    // SAFETY: as above.
    unsafe { handle::read(region, shown) }
}
