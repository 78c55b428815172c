//! Whole numbers that are long enough to decide which `f64` a text means.

use core::cmp::Ordering;

/// 768 digits and one more are 2555 bits, 5^1099 is 2552 bits; and one bit for the
/// division.
const WORDS: usize = 81;

/// A whole number below 2^2592, the lowest word first.
#[derive(Clone)]
pub(super) struct Big([u32; WORDS]);

impl Big {
    pub(super) const ZERO: Big = Big([0; WORDS]);

    /// `self * factor + term`.
    pub(super) fn multiply_add(&mut self, factor: u32, term: u32) {
        let mut carry = u64::from(term);
        for word in &mut self.0 {
            carry += u64::from(*word) * u64::from(factor);
            *word = carry as u32;
            carry >>= u32::BITS;
        }
    }

    /// `self * base^exponent`, by so many factors at once that they fit into a word.
    pub(super) fn multiply_power(&mut self, base: u32, mut exponent: u64) {
        while exponent > 0 {
            let mut factor = 1u32;
            while exponent > 0
                && let Some(larger) = factor.checked_mul(base)
            {
                factor = larger;
                exponent -= 1;
            }
            self.multiply_add(factor, 0);
        }
    }

    /// How many bits it has without leading zeros.
    fn bits(&self) -> i64 {
        let mut words = self.0.iter().enumerate().rev();
        let highest = words.find(|(_, word)| **word != 0);
        highest.map_or(0, |(index, word)| {
            32 * (index as i64 + 1) - i64::from(word.leading_zeros())
        })
    }

    fn compare(&self, other: &Big) -> Ordering {
        self.0.iter().rev().cmp(other.0.iter().rev())
    }

    /// Takes away a number that is not larger.
    fn subtract(&mut self, other: &Big) {
        let mut borrow = false;
        for (word, other) in self.0.iter_mut().zip(&other.0) {
            let (less, first) = word.overflowing_sub(*other);
            let (less, second) = less.overflowing_sub(u32::from(borrow));
            (*word, borrow) = (less, first | second);
        }
    }

    /// The quotient of two numbers that are not zero, as `whole * 2^exponent` with a
    /// whole number of 63 or 64 bits, and whether that is exact or a little too small.
    pub(super) fn divide(mut self, mut divisor: Big) -> (u64, i64, bool) {
        let difference = self.bits() - divisor.bits();
        let shorter = if difference < 0 {
            &mut self
        } else {
            &mut divisor
        };
        shorter.multiply_power(2, difference.unsigned_abs());
        let mut quotient = 0;
        for _ in 0..u64::BITS {
            quotient <<= 1;
            if self.compare(&divisor) != Ordering::Less {
                self.subtract(&divisor);
                quotient |= 1;
            }
            self.multiply_add(2, 0);
        }
        let exact = self.0.iter().all(|word| *word == 0);
        (quotient, difference - 63, exact)
    }
}
