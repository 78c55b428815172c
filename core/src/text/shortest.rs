//! The shortest digits that read back as the same number, and of these the nearest.

use super::big::Big;
use core::cmp::Ordering;
use heapless::Vec;

/// A positive number or zero in decimal digits.
pub(super) struct Shortest {
    /// The digits; none are needed for zero.
    pub(super) digits: Vec<u8, 17>,
    /// The power of ten of the first digit.
    pub(super) place: i32,
}

impl Shortest {
    /// Generates digits until what is left is less than half of the way to a neighbour
    /// (Steele and White 1990, Burger and Dybvig 1996). `value` must be finite.
    #[inline(never)]
    pub(super) fn of(value: f64) -> Shortest {
        const FRACTION: u32 = f64::MANTISSA_DIGITS - 1;
        let bits = value.to_bits();
        let fraction = bits & ((1 << FRACTION) - 1);
        let biased = (bits >> FRACTION) as i32;
        let (whole, exponent) = match biased {
            0 => (fraction, -1074),
            _ => (fraction | 1 << FRACTION, biased - 1075),
        };
        let mut shortest = Shortest {
            digits: Vec::new(),
            place: 0,
        };
        if whole == 0 {
            return shortest;
        }
        // In quarters of the last bit; below a power of two numbers are twice as dense.
        let narrow = fraction == 0 && biased > 1;
        let mut rest = Big::from(4 * whole);
        let mut above = Big::from(2);
        let mut unit = Big::from(4);
        if exponent < 0 {
            unit.multiply_power(2, exponent.unsigned_abs());
        } else {
            rest.multiply_power(2, exponent.unsigned_abs());
            above.multiply_power(2, exponent.unsigned_abs());
        }
        // The logarithm of a power of two, rounded down; exact for all exponents of `f64`.
        let highest = exponent + 63 - whole.leading_zeros() as i32;
        let place = ((highest * 315_653) >> 20) + 1;
        if place < 0 {
            rest.multiply_power(10, place.unsigned_abs());
            above.multiply_power(10, place.unsigned_abs());
        } else {
            unit.multiply_power(10, place.unsigned_abs());
        }
        shortest.place = place;
        // A text that lies half of the way is read as the even number.
        let reaches = |a: &Big, b: &Big| match a.compare(b) {
            Ordering::Less => false,
            Ordering::Equal => whole % 2 == 0,
            Ordering::Greater => true,
        };
        rest.add(&above);
        let mut first = reaches(&rest, &unit);
        rest.subtract(&above);
        if !first {
            shortest.place -= 1;
        }
        loop {
            if !first {
                rest.multiply_add(10, 0);
                above.multiply_add(10, 0);
            }
            first = false;
            let mut digit = 0;
            while rest.compare(&unit) != Ordering::Less {
                rest.subtract(&unit);
                digit += 1;
            }
            let mut twice = rest.clone();
            twice.add(&rest);
            let low = reaches(&above, if narrow { &twice } else { &rest });
            rest.add(&above);
            let high = reaches(&rest, &unit);
            rest.subtract(&above);
            let nearer = match twice.compare(&unit) {
                Ordering::Less => false,
                Ordering::Equal => digit % 2 == 1,
                Ordering::Greater => true,
            };
            if high && (nearer || !low) {
                digit += 1;
            }
            if shortest.digits.push(digit).is_err() || low || high {
                return shortest;
            }
        }
    }
}
