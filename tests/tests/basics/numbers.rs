//! Numbers are read exactly: compared with the standard library, which is exact, too.

use critreg::random::generator;
use critreg::text::{read_number, write_number};
use rand_core::Rng;
use std::fmt::Write;

/// The library reads what the standard library reads, to the last bit, but nothing that
/// is not finite.
fn agree(text: &str) {
    let expected = text.parse::<f64>().ok().filter(|value| value.is_finite());
    let read = read_number(text);
    assert_eq!(read.map(f64::to_bits), expected.map(f64::to_bits), "{text}");
}

/// The library writes what another one writes, but for `.0` at the end, and reads it
/// again. (The standard library decides otherwise between two that are equally near.)
fn written(value: f64) {
    let mut expected = ryu::Buffer::new();
    let expected = expected.format_finite(value);
    let mut text = String::new();
    write_number(&mut text, value).unwrap();
    assert_eq!(text, expected.strip_suffix(".0").unwrap_or(expected));
    agree(&text);
}

#[test]
fn every_number_is_written_and_read_as_it_was() {
    let mut rng = generator(1);
    for _ in 0..10_000 {
        let value = f64::from_bits(rng.next_u64());
        if value.is_finite() {
            written(value);
            // Of the sizes that occur, with many digits and with few.
            let usual = value.signum() * f64::from(rng.next_u32());
            for power in [0, 5, 9, 12, 17, 40] {
                written(usual / 10f64.powi(power));
                written((usual / 2f64.powi(power)).round());
            }
            written(f64::from(usual as f32 / 1e7));
        }
    }
}

/// The neighbours of a power of two are not equally far. Of a power of ten the digits
/// change their number.
#[test]
fn powers_and_their_neighbours_are_written() {
    let twos = (0..2046u64).map(|exponent| f64::from_bits(exponent << 52));
    let smallest = (0..52).map(|bit| f64::from_bits(1 << bit));
    let tens = (-323..=308).map(|power| format!("1e{power}").parse().unwrap());
    for power in twos.chain(smallest).chain(tens) {
        for value in [power.next_down(), power, -power, power.next_up()] {
            written(value);
        }
    }
    written(f64::MAX);
}

#[test]
fn any_digits_with_any_exponent() {
    let mut rng = generator(2);
    let mut text = String::new();
    for case in 0..200_000 {
        text.clear();
        let longest = if case % 100 == 0 { 900 } else { 40 };
        let (whole, fraction) = (rng.next_u32() % longest, rng.next_u32() % longest);
        let zeros = if rng.next_u32().is_multiple_of(4) {
            longest
        } else {
            0
        };
        text.extend(rng.next_u32().is_multiple_of(3).then_some('-'));
        text.extend((0..rng.next_u32() % (zeros + 1)).map(|_| '0'));
        text.extend((0..whole).map(|_| digit(&mut rng)));
        text.push('.');
        text.extend((0..rng.next_u32() % (zeros + 1)).map(|_| '0'));
        text.extend((0..fraction).map(|_| digit(&mut rng)));
        if !rng.next_u32().is_multiple_of(3) {
            let range = if rng.next_u32().is_multiple_of(2) {
                700
            } else {
                40
            };
            let exponent = i64::from(rng.next_u32() % range) - i64::from(range / 2);
            write!(text, "e{exponent}").unwrap();
        }
        agree(&text);
    }
}

fn digit(rng: &mut impl Rng) -> char {
    char::from(b'0' + (rng.next_u32() % 10) as u8)
}

/// In the middle between two numbers the even one is nearest; a little beside it, it is
/// the one on that side.
#[test]
fn ties_and_what_is_beside_them() {
    let mut rng = generator(3);
    for case in 0..2000 {
        // An odd multiple of half of the last bit of a number: a power of two times one
        // of 54 bits, or fewer where the numbers are the smallest.
        let odd = rng.next_u64() >> (10 + case % 50) | 1;
        let exponent = match case % 3 {
            0 => -1075,
            1 => -((rng.next_u32() % 1075) as i32),
            _ => (rng.next_u32() % 900) as i32,
        };
        let digits = multiple(
            odd,
            if exponent < 0 { 5 } else { 2 },
            exponent.unsigned_abs(),
        );
        let place = exponent.min(0);
        for tail in ["", "0000000000", "0000000001"] {
            agree(&format!("{digits}{tail}e{}", place - tail.len() as i32));
        }
        // The last digit is not 0, so this is a little less.
        let (rest, last) = digits.split_at(digits.len() - 1);
        let less = last.parse::<u8>().unwrap().saturating_sub(1);
        agree(&format!("{rest}{less}{}e{}", "9".repeat(50), place - 50));
    }
}

/// The decimal digits of `value * base^power`.
fn multiple(value: u64, base: u32, power: u32) -> String {
    let mut digits: Vec<u32> = value
        .to_string()
        .bytes()
        .rev()
        .map(|c| u32::from(c - b'0'))
        .collect();
    for _ in 0..power {
        let mut carry = 0;
        for digit in &mut digits {
            carry += *digit * base;
            *digit = carry % 10;
            carry /= 10;
        }
        while carry > 0 {
            digits.push(carry % 10);
            carry /= 10;
        }
    }
    digits
        .iter()
        .rev()
        .map(|digit| char::from(b'0' + *digit as u8))
        .collect()
}

#[test]
fn the_ends_of_the_range_and_what_is_no_number() {
    for text in [
        "",
        ".",
        "-",
        "+",
        "e5",
        "1e",
        "1e+",
        "1e-",
        "1_0",
        "1 ",
        " 1",
        "1.2.3",
        "0x1",
        "--1",
        "1e5.",
        "1.5e",
        "1.",
        ".5",
        "-.5e-3",
        "+7",
        "0",
        "-0",
        "0e999999999999999999999999",
        "1e999999999999999999999999",
        "1e-999999999999999999999999",
        "1.7976931348623157e308",
        "1.7976931348623158e308",
        "1.7976931348623159e308",
        "2.2250738585072011e-308",
        "4.9406564584124654e-324",
        "2.4703282292062327e-324",
        "2.4703282292062328e-324",
        "9007199254740993",
        "9007199254740992.5",
        "123456789012345678901234567890",
        "1e22",
        "1e23",
        "8.5e-22",
        "1e-23",
    ] {
        agree(text);
    }
    // Names of what is not finite are names.
    for text in ["inf", "nan", "infinity", "-inf"] {
        assert_eq!(read_number(text), None);
    }
}
