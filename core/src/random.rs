//! Random numbers: one named algorithm, the same stream on every target.

use crate::real::Real;
use rand_core::Rng;

/// The generator of the library: PCG XSH-RR 64/32 (O'Neill 2014). Its state is
/// two words, and 64-bit arithmetic suits a microcontroller.
pub type Generator = rand_pcg::Pcg32;

/// The generator with this seed, on the library's stream.
pub fn generator(seed: u64) -> Generator {
    Generator::new(seed, 0xC217_4E60_0000_0001)
}

/// A number uniform in `[0, 1)`, with 53 random bits.
pub fn uniform(rng: &mut (impl Rng + ?Sized)) -> f64 {
    uniform_real(rng)
}

/// As [`uniform`], rounded to the nearest number of a type, which may be one.
pub(crate) fn uniform_real<R: Real>(rng: &mut (impl Rng + ?Sized)) -> R {
    R::from_share(rng.next_u64() >> 11)
}

/// A number uniform in `[low, high)`.
pub fn uniform_in(rng: &mut (impl Rng + ?Sized), low: f64, high: f64) -> f64 {
    low + (high - low) * uniform(rng)
}

/// A whole number uniform below `count`; zero if `count` is zero. The bias of
/// the multiplication is below `count / 2^32`.
pub fn below(rng: &mut (impl Rng + ?Sized), count: usize) -> usize {
    let wide = u64::from(rng.next_u32()) * (count as u64 & 0xFFFF_FFFF);
    (wide >> 32) as usize
}
