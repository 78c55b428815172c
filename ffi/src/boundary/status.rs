//! Status codes, and the words for them.

use core::ffi::{CStr, c_char};
use core::fmt;
use critreg_core::Error;
use critreg_core::domain::Domain;
use critreg_core::text::write_number;

/// What became of a call: CRITREG_OK, one of the codes below, or the status of
/// the program's own callback.
pub type critreg_status = i32;

/// The call did what it promises.
pub const CRITREG_OK: critreg_status = 0;
/// A pointer is NULL that must not be.
pub const CRITREG_NULL_POINTER: critreg_status = 1;
/// A pointer is not aligned for what it points to.
pub const CRITREG_MISALIGNED: critreg_status = 2;
/// Memory, a buffer or an array is too small.
pub const CRITREG_TOO_SMALL: critreg_status = 3;
/// An argument is outside of what the function accepts.
pub const CRITREG_INVALID_ARGUMENT: critreg_status = 4;
/// A number is NaN or infinite.
pub const CRITREG_NOT_FINITE: critreg_status = 5;
/// A text could not be read; critreg_check_domain() and critreg_check_region()
/// tell the line, the column and what was expected.
pub const CRITREG_SYNTAX_ERROR: critreg_status = 6;
/// A table of the library is full: too many objects, constraints, observations.
pub const CRITREG_CAPACITY_EXCEEDED: critreg_status = 7;
/// Proven: no parameters are in the region in this instance. Where the region is right
/// nothing works here, so postpone the plan skeleton, or drop it; a learned region may
/// be wrong.
pub const CRITREG_EMPTY_REGION: critreg_status = 8;
/// No parameters were found within the budget; the region may be empty.
pub const CRITREG_NO_SAMPLE: critreg_status = 9;
/// The observations explain no region: nothing was learned.
pub const CRITREG_NO_REGION: critreg_status = 10;
/// The call does not fit the state of the learner: telling before asking, asking
/// after the end.
pub const CRITREG_OUT_OF_SEQUENCE: critreg_status = 11;
/// Instances or saved bytes do not belong to this domain or configuration.
pub const CRITREG_MISMATCH: critreg_status = 12;
/// Saved bytes are damaged, incomplete or of another version.
pub const CRITREG_CORRUPT: critreg_status = 13;
/// A callback called back into the learner or planner that is calling it.
pub const CRITREG_BUSY: critreg_status = 14;
/// For callbacks: the program wants to stop. The library itself never returns it.
pub const CRITREG_CANCELLED: critreg_status = 15;
/// The pointer is no handle, or no longer: the memory was overwritten, moved or
/// copied, or the learner of a region went on.
pub const CRITREG_NOT_A_HANDLE: critreg_status = 16;
/// No plan was found: critreg_planner_metrics() tells how planning ended and what
/// stood in the way.
pub const CRITREG_NO_PLAN: critreg_status = 17;
/// From here on the codes belong to the program: a callback may return any of
/// them and finds it again as the status of the call.
pub const CRITREG_USER_STATUS: critreg_status = 1000;

/// How much of a name stands in a message, which has room for 128 bytes.
const LONGEST_NAME: usize = 30;

/// Why a call failed.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Failure {
    /// A NULL pointer; the name of the argument.
    Null(&'static str),
    /// A misaligned pointer; the name of the argument.
    Misaligned(&'static str),
    /// Too little room; what for.
    TooSmall(&'static str),
    /// A callback stopped it; its status and its name.
    Stopped(critreg_status, &'static str),
    /// The pointer is no handle.
    NotAHandle,
    /// A handle is in use; its name.
    Busy(&'static str),
    /// No plan was found; how planning ended.
    NoPlan(&'static str),
    /// A number is none of those that are expected; what is expected, and the number.
    Number(&'static str, i32),
    /// A share of a configuration is out of its range: what is expected, and the share, as
    /// bytes, because a number of that size would make every failure larger.
    Share(&'static str, [u8; 8]),
    /// There are more things than fit: how many, and what.
    TooMany(u32, &'static str),
    /// A number of an instance is NaN or infinite: which one of which instance, in a domain
    /// that lives as long as the handle.
    NotFinite(&'static Domain<'static>, u32, u8),
    /// The core refused.
    Core(Error),
}

/// What most functions of this crate return inside.
pub(crate) type Fallible<T = ()> = Result<T, Failure>;

impl From<Error> for Failure {
    fn from(error: Error) -> Failure {
        Failure::Core(error)
    }
}

impl Failure {
    pub(crate) const fn invalid(what: &'static str) -> Failure {
        Failure::Core(Error::InvalidArgument(what))
    }

    pub(crate) fn status(self) -> critreg_status {
        match self {
            Failure::Null(_) => CRITREG_NULL_POINTER,
            Failure::Misaligned(_) => CRITREG_MISALIGNED,
            Failure::TooSmall(_) => CRITREG_TOO_SMALL,
            Failure::Stopped(status, _) => status,
            Failure::NotAHandle => CRITREG_NOT_A_HANDLE,
            Failure::Busy(_) => CRITREG_BUSY,
            Failure::NoPlan(_) => CRITREG_NO_PLAN,
            Failure::Number(..) => CRITREG_INVALID_ARGUMENT,
            Failure::Share(_, share) if !f64::from_ne_bytes(share).is_finite() => {
                CRITREG_NOT_FINITE
            }
            Failure::Share(..) => CRITREG_INVALID_ARGUMENT,
            Failure::TooMany(..) => CRITREG_CAPACITY_EXCEEDED,
            Failure::NotFinite(..) => CRITREG_NOT_FINITE,
            Failure::Core(error) => match error {
                Error::Syntax(_) => CRITREG_SYNTAX_ERROR,
                Error::CapacityExceeded(_) => CRITREG_CAPACITY_EXCEEDED,
                Error::InvalidArgument(_) => CRITREG_INVALID_ARGUMENT,
                Error::NotFinite(_) => CRITREG_NOT_FINITE,
                Error::EmptyRegion => CRITREG_EMPTY_REGION,
                Error::NoSample => CRITREG_NO_SAMPLE,
                Error::NoRegion => CRITREG_NO_REGION,
                Error::OutOfSequence(_) => CRITREG_OUT_OF_SEQUENCE,
                Error::Mismatch(_) => CRITREG_MISMATCH,
                Error::Corrupt(_) => CRITREG_CORRUPT,
            },
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Failure::Null(name) => write!(f, "{name} is NULL"),
            Failure::Misaligned(name) => write!(f, "{name} is not aligned"),
            Failure::TooSmall(what) => write!(f, "too small: {what}"),
            Failure::Stopped(status, name) => write!(f, "{name} returned status {status}"),
            Failure::NotAHandle => f.write_str("this is no handle"),
            Failure::Busy(name) => write!(f, "{name} are in use"),
            Failure::NoPlan(how) => write!(f, "no plan: {how}"),
            Failure::Number(expected, number) => write!(f, "{expected}, not {number}"),
            Failure::Share(expected, share) => {
                let share = f64::from_ne_bytes(*share);
                if !share.is_finite() {
                    return write!(f, "{expected}, and not NaN or infinite");
                }
                write!(f, "{expected}, not ")?;
                write_number(f, share)
            }
            Failure::TooMany(count, what) => write!(f, "{count} {what}"),
            Failure::NotFinite(domain, instance, slot) => {
                write!(f, "instance {instance}: ")?;
                if let Some((object, attribute)) = domain.slots().nth(usize::from(*slot)) {
                    let short = |name: &'static str| name.get(..LONGEST_NAME).unwrap_or(name);
                    write!(f, "{}.{}", short(object.name), short(attribute.name))?;
                }
                write!(f, ", its number {slot}, is NaN or infinite")
            }
            Failure::Core(error) => error.fmt(f),
        }
    }
}

/// The words about a failure; none if there was none.
pub(crate) struct Message(pub(crate) Option<Failure>);

impl fmt::Display for Message {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.map_or(Ok(()), |failure| failure.fmt(f))
    }
}

pub(crate) fn status_of(result: Fallible) -> critreg_status {
    match result {
        Ok(()) => CRITREG_OK,
        Err(failure) => failure.status(),
    }
}

/// Passes on what a callback returned, unless it is CRITREG_OK.
pub(crate) fn stop_unless_ok(status: critreg_status, callback: &'static str) -> Fallible {
    if status == CRITREG_OK {
        Ok(())
    } else {
        Err(Failure::Stopped(status, callback))
    }
}

/// Name and meaning of every code, in order of the codes.
const CODES: [(&CStr, &CStr); 18] = [
    (c"CRITREG_OK", c"success"),
    (c"CRITREG_NULL_POINTER", c"a pointer is NULL"),
    (c"CRITREG_MISALIGNED", c"a pointer is not aligned"),
    (
        c"CRITREG_TOO_SMALL",
        c"memory, a buffer or an array is too small",
    ),
    (
        c"CRITREG_INVALID_ARGUMENT",
        c"an argument is outside of what the function accepts",
    ),
    (c"CRITREG_NOT_FINITE", c"a number is NaN or infinite"),
    (c"CRITREG_SYNTAX_ERROR", c"a text could not be read"),
    (
        c"CRITREG_CAPACITY_EXCEEDED",
        c"a table of the library is full",
    ),
    (
        c"CRITREG_EMPTY_REGION",
        c"no parameters are in the region in this instance",
    ),
    (
        c"CRITREG_NO_SAMPLE",
        c"no parameters found; the region may be empty",
    ),
    (
        c"CRITREG_NO_REGION",
        c"nothing could be learned from the observations",
    ),
    (
        c"CRITREG_OUT_OF_SEQUENCE",
        c"the call does not fit the state of the learner",
    ),
    (
        c"CRITREG_MISMATCH",
        c"instances or bytes belong to another domain or configuration",
    ),
    (
        c"CRITREG_CORRUPT",
        c"saved bytes are damaged or of another version",
    ),
    (
        c"CRITREG_BUSY",
        c"a callback called back into its own learner or planner",
    ),
    (c"CRITREG_CANCELLED", c"a callback cancelled the call"),
    (c"CRITREG_NOT_A_HANDLE", c"the pointer is no handle"),
    (c"CRITREG_NO_PLAN", c"no plan was found"),
];

fn code(status: critreg_status) -> Option<&'static (&'static CStr, &'static CStr)> {
    CODES.get(usize::try_from(status).ok()?)
}

/// What a status means, in a few words of English.
///
/// @return A static text, never NULL, also for codes the library does not know.
#[unsafe(no_mangle)]
pub extern "C" fn critreg_strerror(status: critreg_status) -> *const c_char {
    let words = match code(status) {
        Some((_, words)) => words,
        None if status >= CRITREG_USER_STATUS => c"a status of the program's callback",
        None => c"unknown status",
    };
    words.as_ptr()
}

/// The name of a status as it stands in the header, such as "CRITREG_BUSY".
///
/// @return A static text, never NULL: "CRITREG_USER_STATUS" for all codes of the
/// program, "unknown" for what is no code.
#[unsafe(no_mangle)]
pub extern "C" fn critreg_status_name(status: critreg_status) -> *const c_char {
    let name = match code(status) {
        Some((name, _)) => name,
        None if status >= CRITREG_USER_STATUS => c"CRITREG_USER_STATUS",
        None => c"unknown",
    };
    name.as_ptr()
}
