//! Whole numbers that are long enough to read and write every `f64` exactly.

use core::cmp::Ordering;
use heapless::Vec;

/// 768 digits and one more are 2555 bits, 5^1099 is 2552 bits; and one bit for the
/// division.
const WORDS: usize = 81;

/// A whole number below 2^2592, the lowest word first and without zeros at the end, so
/// that small ones are fast.
#[derive(Clone)]
pub(super) struct Big(Vec<u32, WORDS>);

impl From<u64> for Big {
    fn from(value: u64) -> Big {
        let mut big = Big(Vec::new());
        big.push(value as u32);
        big.push((value >> u32::BITS) as u32);
        big.trim();
        big
    }
}

impl Big {
    /// There is room for every number that occurs.
    fn push(&mut self, word: u32) {
        let _ = self.0.push(word);
    }

    fn trim(&mut self) {
        while self.0.last() == Some(&0) {
            self.0.pop();
        }
    }

    /// `self * factor + term`.
    pub(super) fn multiply_add(&mut self, factor: u32, term: u32) {
        let mut carry = u64::from(term);
        for word in &mut self.0 {
            carry += u64::from(*word) * u64::from(factor);
            *word = carry as u32;
            carry >>= u32::BITS;
        }
        if carry > 0 {
            self.push(carry as u32);
        }
    }

    /// `self * base^exponent`, by so many factors at once that they fit into a word.
    pub(super) fn multiply_power(&mut self, base: u32, mut exponent: u32) {
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
    fn bits(&self) -> i32 {
        let zeros = self.0.last().map_or(0, |word| word.leading_zeros());
        (32 * self.0.len()) as i32 - zeros as i32
    }

    pub(super) fn compare(&self, other: &Big) -> Ordering {
        let lengths = self.0.len().cmp(&other.0.len());
        lengths.then_with(|| self.0.iter().rev().cmp(other.0.iter().rev()))
    }

    pub(super) fn add(&mut self, other: &Big) {
        while self.0.len() < other.0.len() {
            self.push(0);
        }
        // A word for the carry of the highest one.
        self.push(0);
        self.combine(other, u32::overflowing_add);
    }

    /// Takes away a number that is not larger.
    pub(super) fn subtract(&mut self, other: &Big) {
        self.combine(other, u32::overflowing_sub);
    }

    /// Adds or subtracts word by word, with a carry or a borrow.
    fn combine(&mut self, other: &Big, operation: fn(u32, u32) -> (u32, bool)) {
        let mut carry = false;
        let mut others = other.0.iter();
        for word in &mut self.0 {
            let other = others.next().copied().unwrap_or(0);
            let (first, once) = operation(*word, other);
            let (second, twice) = operation(first, u32::from(carry));
            (*word, carry) = (second, once | twice);
        }
        self.trim();
    }

    /// The quotient of two numbers that are not zero: a whole number of 63 or 64 bits, the
    /// exponent of two to multiply it with, and whether that is exact or a little too
    /// small.
    pub(super) fn divide(&mut self, divisor: &mut Big) -> (u64, i32, bool) {
        let difference = self.bits() - divisor.bits();
        let shorter = if difference < 0 {
            &mut *self
        } else {
            &mut *divisor
        };
        shorter.multiply_power(2, difference.unsigned_abs());
        let mut quotient = 0;
        for _ in 0..u64::BITS {
            quotient <<= 1;
            if self.compare(divisor) != Ordering::Less {
                self.subtract(divisor);
                quotient |= 1;
            }
            self.multiply_add(2, 0);
        }
        (quotient, difference - 63, self.0.is_empty())
    }
}
