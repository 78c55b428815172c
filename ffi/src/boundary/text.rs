//! Text and bytes that go into a buffer of the caller.

use crate::boundary::pointer::{self, Output};
use crate::boundary::status::{Failure, Fallible};
use core::ffi::c_char;
use core::fmt;
use critreg_core::text::TextBuffer;

/// A buffer of the caller, which need not be initialised: bytes are only ever
/// written to it.
struct Buffer {
    next: *mut u8,
    left: usize,
}

impl fmt::Write for Buffer {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        let length = text.len().min(self.left);
        // SAFETY: `left` bytes from `next` on are writable, by the contract of
        // `write` and `write_cut_off`, and the text does not lie in the buffer.
        unsafe {
            core::ptr::copy_nonoverlapping(text.as_ptr(), self.next, length);
            self.next = self.next.add(length);
        }
        self.left -= length;
        Ok(())
    }
}

fn length_of(text: &dyn fmt::Display) -> usize {
    let mut counter = TextBuffer::new(&mut []);
    // Counting cannot fail; a text that cannot be written has no length.
    let written = fmt::write(&mut counter, format_args!("{text}"));
    written.map_or(0, |()| counter.needed())
}

/// Checks a buffer, which may be NULL if its length is 0, and tells how much is needed.
///
/// # Safety
/// If not NULL and aligned, `needed` is writable.
unsafe fn tell_needed<T>(
    buffer: *mut T,
    len: usize,
    name: &'static str,
    needed: *mut usize,
    value: usize,
) -> Fallible {
    if len > 0 {
        pointer::check(buffer, name)?;
    }
    // SAFETY: by this function's contract.
    if let Some(needed) = unsafe { Output::optional(needed, "needed")? } {
        needed.write(value);
    }
    Ok(())
}

/// Writes a text with its NUL, or nothing if it does not fit.
///
/// # Safety
/// If not NULL and aligned, `buffer` is writable for `len` bytes and `needed` for
/// one value.
pub(crate) unsafe fn write(
    text: &dyn fmt::Display,
    buffer: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> Fallible {
    let length = length_of(text).saturating_add(1);
    // SAFETY: by this function's contract.
    unsafe { tell_needed(buffer, len, "text", needed, length)? };
    if length > len {
        return Err(Failure::TooSmall("the buffer for the text"));
    }
    // SAFETY: just checked; writable by this function's contract.
    unsafe { fill(text, buffer, len) };
    Ok(())
}

/// Writes a text with its NUL, cut off where the buffer ends.
///
/// # Safety
/// As for [`write`].
pub(crate) unsafe fn write_cut_off(
    text: &dyn fmt::Display,
    buffer: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> Fallible {
    let length = length_of(text).saturating_add(1);
    // SAFETY: by this function's contract; the buffer is checked before it is filled.
    unsafe {
        tell_needed(buffer, len, "text", needed, length)?;
        fill(text, buffer, len);
    }
    Ok(())
}

/// # Safety
/// `buffer` is writable for `len` bytes.
unsafe fn fill(text: &dyn fmt::Display, buffer: *mut c_char, len: usize) {
    let Some(left) = len.checked_sub(1) else {
        return;
    };
    let mut out = Buffer {
        next: buffer.cast(),
        left,
    };
    // The buffer takes what fits and never fails.
    let _ = fmt::write(&mut out, format_args!("{text}"));
    // SAFETY: one byte was kept back for the NUL.
    unsafe { out.next.write(0) };
}

/// Fills a byte buffer by `save`, or writes nothing if it is shorter than
/// `length`.
///
/// # Safety
/// As for [`write`].
pub(crate) unsafe fn write_bytes(
    length: usize,
    bytes: *mut u8,
    len: usize,
    needed: *mut usize,
    save: impl FnOnce(&mut [u8]) -> Fallible<usize>,
) -> Fallible {
    // SAFETY: by this function's contract.
    unsafe { tell_needed(bytes, len, "bytes", needed, length)? };
    if length > len {
        return Err(Failure::TooSmall("the buffer for the saved bytes"));
    }
    // SAFETY: `length <= len` bytes are writable by this function's contract; they
    // are initialised before a reference to them is made.
    let room = unsafe {
        core::ptr::write_bytes(bytes, 0, length);
        core::slice::from_raw_parts_mut(bytes, length)
    };
    save(room).map(|_| ())
}

/// Takes any text.
pub(crate) struct Nowhere;

impl fmt::Write for Nowhere {
    fn write_str(&mut self, _: &str) -> fmt::Result {
        Ok(())
    }
}
