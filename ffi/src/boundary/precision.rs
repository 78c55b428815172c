//! What numbers learners and regions compute with. C speaks double throughout.

use crate::boundary::status::{Failure, Fallible};

/// For critreg_config.precision: computing with double, the default. The same inputs
/// give the same bytes on every machine.
pub const CRITREG_F64: u32 = 64;

/// For critreg_config.precision: computing with float, in half the memory, and much
/// faster on a microcontroller whose floating-point unit has single precision only.
/// Thresholds are good to about six digits.
pub const CRITREG_F32: u32 = 32;

#[cfg(not(any(feature = "f64", feature = "f32")))]
compile_error!("a precision is needed: feature f64, f32 or both");

/// The type behind [`CRITREG_F32`].
#[cfg(all(feature = "f32", not(feature = "micromath")))]
pub(crate) type Single = f32;
/// The type behind [`CRITREG_F32`].
#[cfg(all(feature = "f32", feature = "micromath"))]
pub(crate) type Single = critreg_core::real::Fast32;

#[cfg(not(all(feature = "f64", feature = "f32")))]
const ABSENT: Failure = Failure::invalid("the library was built without this precision");

/// What numbers are computed with; only what the library was built with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Precision {
    #[cfg(feature = "f32")]
    Single,
    #[cfg(feature = "f64")]
    Double,
}

impl Precision {
    /// The finest there is.
    #[cfg(feature = "f64")]
    pub(crate) const DEFAULT: Precision = Precision::Double;
    /// The finest there is.
    #[cfg(not(feature = "f64"))]
    pub(crate) const DEFAULT: Precision = Precision::Single;

    /// The precision with a number of the header.
    pub(crate) fn new(number: u32) -> Fallible<Precision> {
        match number {
            #[cfg(feature = "f64")]
            CRITREG_F64 => Ok(Precision::Double),
            #[cfg(feature = "f32")]
            CRITREG_F32 => Ok(Precision::Single),
            #[cfg(not(feature = "f64"))]
            CRITREG_F64 => Err(ABSENT),
            #[cfg(not(feature = "f32"))]
            CRITREG_F32 => Err(ABSENT),
            _ => Err(Failure::invalid("there is no precision with this number")),
        }
    }

    /// Its number in the header.
    pub(crate) const fn number(self) -> u32 {
        match self {
            #[cfg(feature = "f32")]
            Precision::Single => CRITREG_F32,
            #[cfg(feature = "f64")]
            Precision::Double => CRITREG_F64,
        }
    }

    /// The finer of two.
    pub(crate) fn finer(self, other: Precision) -> Precision {
        if self.number() < other.number() {
            other
        } else {
            self
        }
    }
}

/// Computes something with the type of numbers of a precision.
macro_rules! in_precision {
    ($precision:expr, $real:ident => $body:expr) => {
        match $precision {
            #[cfg(feature = "f32")]
            $crate::boundary::precision::Precision::Single => {
                type $real = $crate::boundary::precision::Single;
                $body
            }
            #[cfg(feature = "f64")]
            $crate::boundary::precision::Precision::Double => {
                type $real = f64;
                $body
            }
        }
    };
}
pub(crate) use in_precision;
