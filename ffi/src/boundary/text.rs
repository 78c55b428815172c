//! Text and bytes that go into a buffer of the caller.

use crate::boundary::pointer::{self, Output};
use crate::boundary::status::{Failure, Fallible, critreg_status, status_of};
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
    // SAFETY: by this function's contract.
    unsafe { write_by(|out| shown(text, out), buffer, len, needed) }
}

/// Buffers take what fits and never fail; nor does what writes a text that can be shown.
fn shown(text: &dyn fmt::Display, out: &mut dyn fmt::Write) -> Fallible {
    let _ = fmt::write(out, format_args!("{text}"));
    Ok(())
}

/// As [`write`], a text that is written by what may fail: then nothing is.
///
/// # Safety
/// As for [`write`].
pub(crate) unsafe fn write_by(
    text: impl Fn(&mut dyn fmt::Write) -> Fallible,
    buffer: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> Fallible {
    let mut counter = TextBuffer::new(&mut []);
    text(&mut counter)?;
    let length = counter.needed().saturating_add(1);
    // SAFETY: by this function's contract.
    unsafe { tell_needed(buffer, len, "text", needed, length)? };
    if length > len {
        return Err(Failure::TooSmall("the buffer for the text"));
    }
    // SAFETY: just checked; writable by this function's contract.
    unsafe { fill(|out| text(out), buffer, len) }
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
        fill(|out| shown(text, out), buffer, len)
    }
}

/// # Safety
/// `buffer` is writable for `len` bytes.
unsafe fn fill(
    text: impl FnOnce(&mut dyn fmt::Write) -> Fallible,
    buffer: *mut c_char,
    len: usize,
) -> Fallible {
    let Some(left) = len.checked_sub(1) else {
        return Ok(());
    };
    let mut out = Buffer {
        next: buffer.cast(),
        left,
    };
    let written = text(&mut out);
    // SAFETY: one byte was kept back for the NUL.
    unsafe { out.next.write(0) };
    written
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

/// Writes what is wrong with something, cut off where the buffer ends, and tells the status.
///
/// # Safety
/// As for [`write`].
pub(crate) unsafe fn explain(
    words: &dyn fmt::Display,
    checked: Fallible,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: by this function's contract.
    let written = unsafe { write_cut_off(words, text, len, needed) };
    // A wrong buffer is the first thing to put right.
    status_of(written.and(checked))
}
