//! Which version of the library this is, and which of its parts were built.

use core::ffi::c_char;

/// The version of the binary interface, and the number in the name of the shared library,
/// libcritreg.so.0. It changes when a program has to be compiled again; compare it with
/// critreg_abi_version() when the library is loaded at run time.
pub const CRITREG_ABI_VERSION: u32 = 0;

/// The version of this header. The library that runs may be another one: see
/// critreg_version(). What may change when stands in ffi/README.md.
pub const CRITREG_VERSION_MAJOR: u32 = 0;
/// The second number of it.
pub const CRITREG_VERSION_MINOR: u32 = 1;
/// The third number of it.
pub const CRITREG_VERSION_PATCH: u32 = 0;

/// Of critreg_capabilities(): CRITREG_F64, learning and drawing with double.
pub const CRITREG_HAS_F64: u32 = 1 << 0;
/// CRITREG_F32, learning and drawing with float.
pub const CRITREG_HAS_F32: u32 = 1 << 1;
/// The roots and sines of CRITREG_F32 come from micromath: smaller, and good to three digits.
pub const CRITREG_HAS_MICROMATH: u32 = 1 << 2;
/// CRITREG_ALGORITHM1, the learner of the thesis.
pub const CRITREG_HAS_ALGORITHM1: u32 = 1 << 3;
/// Learners with up to 2048 observations; without it, 256.
pub const CRITREG_HAS_MANY_OBSERVATIONS: u32 = 1 << 4;
/// Bodies with sizes, and the relations between them; without it, a shape has key points only.
pub const CRITREG_HAS_BODIES: u32 = 1 << 5;
/// Learners; without them there are regions only, from text or bytes.
pub const CRITREG_HAS_LEARNER: u32 = 1 << 6;
/// The planner, skills and the built-in environment.
pub const CRITREG_HAS_PLANNER: u32 = 1 << 7;

/// Whether a number of the package's version, as text, is this one.
const fn is(text: &str, number: u32) -> bool {
    matches!(u32::from_str_radix(text, 10), Ok(told) if told == number)
}

const _: () = assert!(is(env!("CARGO_PKG_VERSION_MAJOR"), CRITREG_VERSION_MAJOR));
const _: () = assert!(is(env!("CARGO_PKG_VERSION_MINOR"), CRITREG_VERSION_MINOR));
const _: () = assert!(is(env!("CARGO_PKG_VERSION_PATCH"), CRITREG_VERSION_PATCH));

/// The CRITREG_ABI_VERSION of the library that runs.
#[unsafe(no_mangle)]
pub extern "C" fn critreg_abi_version() -> u32 {
    CRITREG_ABI_VERSION
}

/// The version of the library that runs, such as "0.1.0".
///
/// @return A static text, never NULL.
#[unsafe(no_mangle)]
pub extern "C" fn critreg_version() -> *const c_char {
    concat!(env!("CARGO_PKG_VERSION"), "\0").as_ptr().cast()
}

/// What the library that runs was built with; everything unless someone left it out. What
/// is not there is refused where it is asked for; functions that are not there are not linked. Bits that are not named here are 0.
///
/// @return CRITREG_HAS_F64 and its like, combined with or.
#[unsafe(no_mangle)]
pub extern "C" fn critreg_capabilities() -> u32 {
    const fn bit(built: bool, flag: u32) -> u32 {
        if built { flag } else { 0 }
    }
    bit(cfg!(feature = "f64"), CRITREG_HAS_F64)
        | bit(cfg!(feature = "f32"), CRITREG_HAS_F32)
        | bit(cfg!(feature = "micromath"), CRITREG_HAS_MICROMATH)
        | bit(cfg!(feature = "algorithm1"), CRITREG_HAS_ALGORITHM1)
        | bit(
            cfg!(feature = "many_observations"),
            CRITREG_HAS_MANY_OBSERVATIONS,
        )
        | bit(cfg!(feature = "bodies"), CRITREG_HAS_BODIES)
        | bit(cfg!(feature = "learner"), CRITREG_HAS_LEARNER)
        | bit(cfg!(feature = "planner"), CRITREG_HAS_PLANNER)
}
