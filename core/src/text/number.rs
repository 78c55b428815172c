//! Numbers as text, exactly: reading what was written gives the same bits.

use core::fmt;

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

/// Reads a decimal number; `None` if it is none or not finite.
pub fn read_number(text: &str) -> Option<f64> {
    text.parse().ok().filter(|value: &f64| value.is_finite())
}
