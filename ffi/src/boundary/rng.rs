//! Random numbers by value.

use crate::boundary::pointer;
use crate::boundary::status::{Fallible, critreg_status, status_of};
use critreg_core::random::{Generator, generator, uniform};

/// A generator of random numbers (PCG XSH-RR 64/32): the same stream on every
/// machine. Copy it freely: a copy goes on with the same numbers. Do not store it
/// across versions of the library; store the seed. One that is all zero is that
/// of seed 0.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct critreg_rng {
    /// Opaque.
    pub state: [u64; 2],
}

// The generator is two 64-bit words.
const _: () = assert!(size_of::<Generator>() == size_of::<critreg_rng>());
const _: () = assert!(align_of::<Generator>() == align_of::<critreg_rng>());

impl critreg_rng {
    fn from_generator(rng: Generator) -> Self {
        // SAFETY: both are two words without padding (asserted above).
        unsafe { core::mem::transmute::<Generator, critreg_rng>(rng) }
    }

    fn to_generator(self) -> Generator {
        if self.state == [0, 0] {
            return generator(0);
        }
        // SAFETY: as above; every value of the two words is a state.
        unsafe { core::mem::transmute::<critreg_rng, Generator>(self) }
    }
}

/// Draws from the caller's generator and puts it back, also if drawing fails.
///
/// # Safety
/// If not NULL and aligned, the generator is readable and writable.
pub(crate) unsafe fn with_rng<T>(
    rng: *mut critreg_rng,
    draw: impl FnOnce(&mut Generator) -> T,
) -> Fallible<T> {
    pointer::check(rng, "rng")?;
    // SAFETY: checked; readable by this function's contract.
    let mut own = unsafe { rng.read() }.to_generator();
    let drawn = draw(&mut own);
    // SAFETY: as above, writable.
    unsafe { rng.write(critreg_rng::from_generator(own)) };
    Ok(drawn)
}

/// A generator with this seed.
#[unsafe(no_mangle)]
pub extern "C" fn critreg_rng_seed(seed: u64) -> critreg_rng {
    critreg_rng::from_generator(generator(seed))
}

/// Draws a number uniform in [0, 1).
///
/// @param rng The generator, which moves on.
/// @param number Receives the number.
/// @return CRITREG_NULL_POINTER, CRITREG_MISALIGNED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_rng_uniform(
    rng: *mut critreg_rng,
    number: *mut f64,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise.
    let drawn = unsafe { pointer::Output::new(number, "number") }.and_then(|output| {
        // SAFETY: as above.
        output.write(unsafe { with_rng(rng, uniform)? });
        Ok(())
    });
    status_of(drawn)
}
