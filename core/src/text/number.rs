//! Numbers as text, exactly: reading what was written gives the same bits.
//!
//! Reading is not `str::parse`, which is exact too but brings 10 kB of tables and
//! panics that no compiler can rule out. Short numbers are one operation on two exact
//! ones (Clinger 1990), all others a division of whole numbers.

use super::big::Big;
use core::fmt;

/// Digits that can decide which `f64` is nearest; of those behind it only matters
/// whether all are zero.
const DIGITS: usize = 768;

/// The significant digits of a decimal number, as `digits * 10^exponent`.
struct Decimal<'t> {
    negative: bool,
    whole: &'t [u8],
    fraction: &'t [u8],
    exponent: i64,
}

/// Writes the shortest text that reads back as `value`, without a trailing
/// `.0`. `value` must be finite.
///
/// # Errors
/// Those of `out`.
pub fn write_number(out: &mut dyn fmt::Write, value: f64) -> fmt::Result {
    let mut buffer = ryu::Buffer::new();
    let text = buffer.format_finite(value);
    out.write_str(text.strip_suffix(".0").unwrap_or(text))
}

/// Reads a decimal number as the nearest `f64` (ties to even); `None` if it is none or
/// not finite.
pub fn read_number(text: &str) -> Option<f64> {
    let decimal = Decimal::read(text.as_bytes())?;
    let magnitude = match decimal.short() {
        Some(value) => value,
        None => decimal.long()?,
    };
    Some(if decimal.negative {
        -magnitude
    } else {
        magnitude
    })
}

/// Splits off the digits at the start.
fn digits(text: &[u8]) -> (&[u8], &[u8]) {
    let length = text.iter().take_while(|c| c.is_ascii_digit()).count();
    text.split_at_checked(length).unwrap_or((text, &[]))
}

impl<'t> Decimal<'t> {
    fn read(text: &'t [u8]) -> Option<Self> {
        let (negative, text) = match text {
            [b'-', rest @ ..] => (true, rest),
            [b'+', rest @ ..] => (false, rest),
            _ => (false, text),
        };
        let (whole, text) = digits(text);
        let (fraction, text) = match text {
            [b'.', rest @ ..] => digits(rest),
            _ => (&[][..], text),
        };
        if whole.is_empty() && fraction.is_empty() {
            return None;
        }
        Some(Decimal {
            negative,
            whole,
            fraction,
            exponent: read_exponent(text)?,
        })
    }

    fn digits(&self) -> impl Iterator<Item = u8> {
        let all = self.whole.iter().chain(self.fraction);
        all.map(|c| c.wrapping_sub(b'0'))
    }

    /// The power of ten of the last digit.
    fn last_place(&self) -> i64 {
        self.exponent.saturating_sub(self.fraction.len() as i64)
    }

    /// The value, if its digits and its power of ten are exact as `f64`: then so is
    /// their product or quotient but for one rounding.
    fn short(&self) -> Option<f64> {
        const POWERS: i64 = 22;
        let whole = self.digits().try_fold(0u64, |whole, digit| {
            let longer = whole.checked_mul(10)?.checked_add(u64::from(digit))?;
            (longer < 1 << f64::MANTISSA_DIGITS).then_some(longer)
        })?;
        let place = self.last_place();
        let power = (0..place.unsigned_abs().min(23)).fold(1.0, |power, _| power * 10.0);
        match place {
            0..=POWERS => Some(whole as f64 * power),
            _ if (-POWERS..0).contains(&place) => Some(whole as f64 / power),
            _ => None,
        }
    }

    /// The value by arithmetic on whole numbers of any length that matters.
    #[inline(never)]
    fn long(&self) -> Option<f64> {
        let zeros = self.digits().take_while(|digit| *digit == 0).count();
        let count = self.digits().count() - zeros;
        let place = self.last_place().saturating_add(count as i64);
        // Behind the decimal point of 0.d1 d2 d3 ..., beyond what an f64 can be.
        match place {
            _ if count == 0 => return Some(0.0),
            ..-330 => return Some(0.0),
            400.. => return None,
            _ => {}
        }
        let mut digits = self.digits().skip(zeros);
        let mut whole = Big::ZERO;
        let mut deciding = digits.by_ref().take(DIGITS);
        loop {
            let group = deciding.by_ref().take(9);
            let (factor, term) = group.fold((1, 0), |(factor, term), digit| {
                (10 * factor, 10 * term + u32::from(digit))
            });
            if factor == 1 {
                break;
            }
            whole.multiply_add(factor, term);
        }
        let mut power = place - count.min(DIGITS) as i64;
        if count > DIGITS {
            // One more digit, which says whether anything is behind.
            whole.multiply_add(10, u32::from(digits.any(|digit| digit != 0)));
            power -= 1;
        }
        let mut divisor = Big::ZERO;
        divisor.multiply_add(1, 1);
        let scaled = if power < 0 { &mut divisor } else { &mut whole };
        scaled.multiply_power(5, power.unsigned_abs());
        let (quotient, exponent, exact) = whole.divide(divisor);
        assemble(quotient, power + exponent, exact)
    }
}

/// `e` or `E`, a sign and digits; nothing is zero. Too large ones stay too large.
fn read_exponent(text: &[u8]) -> Option<i64> {
    let (negative, text) = match text {
        [] => return Some(0),
        [b'e' | b'E', b'-', rest @ ..] => (true, rest),
        [b'e' | b'E', b'+', rest @ ..] | [b'e' | b'E', rest @ ..] => (false, rest),
        _ => return None,
    };
    let (digits, rest) = digits(text);
    if digits.is_empty() || !rest.is_empty() {
        return None;
    }
    let exponent = digits.iter().fold(0i64, |exponent, c| {
        let digit = i64::from(c.wrapping_sub(b'0'));
        exponent.saturating_mul(10).saturating_add(digit)
    });
    Some(if negative { -exponent } else { exponent })
}

/// The `f64` nearest to `whole * 2^exponent`, or a little more if that is not exact.
/// `whole` has at least 63 bits.
fn assemble(whole: u64, exponent: i64, exact: bool) -> Option<f64> {
    const KEPT: i64 = f64::MANTISSA_DIGITS as i64;
    // The exponent of the last bit; below the normal numbers it stays.
    let last = (exponent + 64 - i64::from(whole.leading_zeros()) - KEPT).max(-1074);
    let dropped = u32::try_from(last - exponent).unwrap_or(0).min(126);
    let wide = u128::from(whole) << 1 | u128::from(!exact);
    let kept = (u128::from(whole) >> dropped) as u64;
    // Everything behind the last bit, and half of it, one bit further to the left.
    let behind = wide & ((1u128 << dropped << 1) - 1);
    let half = 1u128 << dropped;
    let up = behind > half || (behind == half && kept & 1 == 1);
    let rounded = kept + u64::from(up);
    // A carry moves on into the exponent, which is what it should do.
    let biased = u64::try_from(last + 1074).unwrap_or(0);
    let bits = (biased << (KEPT - 1)) + rounded;
    let value = f64::from_bits(bits);
    (biased < 2046 && value.is_finite()).then_some(value)
}
