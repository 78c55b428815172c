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

/// One of many seeds that follow from one, by its number: the finaliser of SplitMix64
/// (Steele, Lea and Flood 2014).
pub(crate) fn mixed(seed: u64, number: u64) -> u64 {
    let mut x = seed ^ number.wrapping_add(1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    x = (x ^ (x >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    x ^ (x >> 31)
}

/// A number uniform in `[0, 1)`, with 53 random bits.
pub fn uniform(rng: &mut (impl Rng + ?Sized)) -> f64 {
    uniform_real(rng)
}

/// As [`uniform`], rounded to the nearest number of a type, which may be one.
pub(crate) fn uniform_real<R: Real>(rng: &mut (impl Rng + ?Sized)) -> R {
    R::from_share(rng.next_u64() >> 11)
}

/// A number uniform in `[low, high]`. It is `high` only by rounding, and never beyond.
pub fn uniform_in(rng: &mut (impl Rng + ?Sized), low: f64, high: f64) -> f64 {
    // The product is below the width, also where that is rounded up.
    low + (high - low) * uniform(rng)
}

/// A whole number uniform below `count`; zero if `count` is zero. The bias of
/// the multiplication is below `count / 2^32`.
pub fn below(rng: &mut (impl Rng + ?Sized), count: usize) -> usize {
    let wide = u64::from(rng.next_u32()) * (count as u64 & 0xFFFF_FFFF);
    (wide >> 32) as usize
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::convert::Infallible;
    use rand_core::TryRng;

    /// Draws nothing but the largest number.
    struct Largest;

    impl TryRng for Largest {
        type Error = Infallible;

        fn try_next_u32(&mut self) -> Result<u32, Infallible> {
            Ok(u32::MAX)
        }

        fn try_next_u64(&mut self) -> Result<u64, Infallible> {
            Ok(u64::MAX)
        }

        fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
            bytes.fill(u8::MAX);
            Ok(())
        }
    }

    #[test]
    fn rounding_never_leaves_a_range() {
        let (mut rng, mut ends) = (generator(1), 0);
        for _ in 0..1000 {
            let low = uniform_in(&mut rng, -1.0, 1.0);
            let high = low + 1e-15 * uniform(&mut rng);
            let drawn = uniform_in(&mut Largest, low, high);
            assert!((low..=high).contains(&drawn), "{low} {high} {drawn}");
            ends += u32::from(low < high && drawn == high);
        }
        assert!(ends > 0, "some are so narrow that the end is drawn");
    }
}
