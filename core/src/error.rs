//! What can go wrong, in words a user can act on.

use core::fmt;

/// Every failure of the library. Nothing panics: full tables, bad numbers and
/// impossible inputs come back as one of these, and the object that was called
/// stays usable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Error {
    /// A text could not be read; where, and what was expected.
    Syntax(SyntaxError),
    /// A fixed-capacity table is full; which one.
    CapacityExceeded(&'static str),
    /// An argument is outside of what the call accepts; what to do about it.
    InvalidArgument(&'static str),
    /// A number is NaN or infinite; which one.
    NotFinite(&'static str),
    /// The region admits no parameters in this instance (proven).
    EmptyRegion,
    /// No parameters were found within the budget; the region may be empty.
    NoSample,
    /// Nothing could be learned from the observations.
    NoRegion,
    /// The call does not fit the state of the learner; what to call instead.
    OutOfSequence(&'static str),
    /// Bytes or instances do not belong to this domain or configuration.
    Mismatch(&'static str),
    /// Saved bytes are damaged or of an unknown version.
    Corrupt(&'static str),
}

/// Where and why a text could not be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SyntaxError {
    /// Line, from one.
    pub line: u32,
    /// Column in characters, from one.
    pub column: u32,
    /// What was wrong and what was expected.
    pub what: &'static str,
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::Syntax(error) => error.fmt(f),
            Error::CapacityExceeded(what) => write!(f, "no room left: {what}"),
            Error::InvalidArgument(what) | Error::OutOfSequence(what) => f.write_str(what),
            Error::NotFinite(what) => write!(f, "{what} is NaN or infinite"),
            Error::EmptyRegion => f.write_str("the region is empty in this instance"),
            Error::NoSample => f.write_str("no parameters found; the region may be empty"),
            Error::NoRegion => f.write_str("the observations explain no region"),
            Error::Mismatch(what) | Error::Corrupt(what) => f.write_str(what),
        }
    }
}

impl fmt::Display for SyntaxError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "line {}, column {}: {}",
            self.line, self.column, self.what
        )
    }
}

impl core::error::Error for Error {}
