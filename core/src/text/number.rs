//! Numbers as text, exactly: reading what was written gives the same bits.
//!
//! Reading is not `str::parse`, which is exact too but brings 10 kB of tables and
//! panics that no compiler can rule out. Short numbers are one operation on two exact
//! ones (Clinger 1990), all others a division of whole numbers.

use super::big::Big;
use super::shortest::Shortest;
use core::fmt;

/// How many digits can decide which `f64` is nearest. Of later digits it matters only
/// whether all are zero.
const DIGITS: i32 = 768;

/// The significant digits of a decimal number, as `digits * 10^exponent`.
struct Decimal<'t> {
    negative: bool,
    whole: &'t [u8],
    fraction: &'t [u8],
    exponent: i32,
}

/// Writes the shortest text that reads back as `value`: with a decimal point from 0.00001
/// on and below 1e16, otherwise as `1.5e-7`. `value` must be finite.
///
/// # Errors
/// Those of `out`.
pub fn write_number(out: &mut dyn fmt::Write, value: f64) -> fmt::Result {
    if value.is_sign_negative() {
        out.write_char('-')?;
    }
    let shortest = Shortest::of(value.abs());
    if (-5..16).contains(&shortest.place) {
        return write_digits(out, &shortest.digits, shortest.place);
    }
    write_digits(out, &shortest.digits, 0)?;
    out.write_str(if shortest.place < 0 { "e-" } else { "e" })?;
    let place = shortest.place.unsigned_abs();
    for unit in [100, 10, 1] {
        if place >= unit {
            write_digit(out, (place / unit % 10) as u8)?;
        }
    }
    Ok(())
}

/// Writes digits of which the first one has a power of ten, and zeros up to the decimal
/// point.
fn write_digits(out: &mut dyn fmt::Write, digits: &[u8], first: i32) -> fmt::Result {
    let last = first + 1 - digits.len() as i32;
    for place in (last.min(0)..=first.max(0)).rev() {
        if place == -1 {
            out.write_char('.')?;
        }
        let index = usize::try_from(first - place).ok();
        let digit = index.and_then(|index| digits.get(index));
        write_digit(out, digit.copied().unwrap_or(0))?;
    }
    Ok(())
}

fn write_digit(out: &mut dyn fmt::Write, digit: u8) -> fmt::Result {
    out.write_char(char::from(b'0' + digit))
}

/// Reads a decimal number as the nearest `f64` (ties to even); `None` if the text is no
/// number, or that is not finite.
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
    fn last_place(&self) -> i32 {
        let behind = i32::try_from(self.fraction.len()).unwrap_or(i32::MAX);
        self.exponent.saturating_sub(behind)
    }

    /// The value, if its digits and its power of ten are exact as `f64`: then so is
    /// their product or quotient but for one rounding.
    fn short(&self) -> Option<f64> {
        let mut whole = 0;
        for digit in self.digits() {
            whole = 10 * whole + u64::from(digit);
            if whole >= 1 << f64::MANTISSA_DIGITS {
                return None;
            }
        }
        let place = self.last_place();
        if place.unsigned_abs() > 22 {
            return None;
        }
        let power = (0..place.unsigned_abs()).fold(1.0, |power, _| power * 10.0);
        let whole = whole as f64;
        Some(if place < 0 {
            whole / power
        } else {
            whole * power
        })
    }

    /// The value by arithmetic on whole numbers of any length that matters.
    #[inline(never)]
    fn long(&self) -> Option<f64> {
        let mut whole = Big::from(0);
        let (mut count, mut ignored, mut more) = (0, 0, false);
        for digit in self.digits() {
            if count == DIGITS {
                ignored += 1;
                more |= digit != 0;
            } else if count > 0 || digit > 0 {
                whole.multiply_add(10, u32::from(digit));
                count += 1;
            }
        }
        let mut power = self.last_place().saturating_add(ignored);
        // Behind the decimal point of 0.d1 d2 d3 ..., beyond what an f64 can be.
        match power.saturating_add(count) {
            _ if count == 0 => return Some(0.0),
            ..-330 => return Some(0.0),
            400.. => return None,
            _ => {}
        }
        if more {
            // One more digit, which stands for all that follow.
            whole.multiply_add(10, 1);
            power -= 1;
        }
        let mut divisor = Big::from(1);
        let scaled = if power < 0 { &mut divisor } else { &mut whole };
        scaled.multiply_power(5, power.unsigned_abs());
        let (quotient, exponent, exact) = whole.divide(&mut divisor);
        assemble(quotient, power + exponent, exact)
    }
}

/// Reads `e` or `E`, a sign and digits; an empty text means zero. Exponents that are too
/// large stay so.
fn read_exponent(text: &[u8]) -> Option<i32> {
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
    let exponent = digits.iter().fold(0i32, |exponent, c| {
        let digit = i32::from(c.wrapping_sub(b'0'));
        exponent.saturating_mul(10).saturating_add(digit)
    });
    Some(if negative { -exponent } else { exponent })
}

/// The `f64` nearest to `whole * 2^exponent`, or a little more if that is not exact.
/// `whole` has at least 63 bits.
fn assemble(whole: u64, exponent: i32, exact: bool) -> Option<f64> {
    const KEPT: i32 = f64::MANTISSA_DIGITS as i32;
    // The exponent of the last bit; below the normal numbers it stays.
    let last = (exponent + 64 - whole.leading_zeros() as i32 - KEPT).max(-1074);
    // The number in halves of the last bit, and whether anything follows.
    let dropped = (last - exponent).unsigned_abs() - 1;
    let halves = whole.checked_shr(dropped).unwrap_or(0);
    let more = !exact || halves.checked_shl(dropped) != Some(whole);
    let kept = halves >> 1;
    let up = halves & 1 == 1 && (more || kept & 1 == 1);
    // A carry moves on into the exponent, as it should.
    let biased = (last + 1074).unsigned_abs();
    let bits = (u64::from(biased) << (KEPT - 1)) + kept + u64::from(up);
    let value = f64::from_bits(bits);
    (biased < 2046 && value.is_finite()).then_some(value)
}
