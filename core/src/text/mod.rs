//! Reading and writing the library's one text form: domains, expressions, regions.

mod big;
mod lexer;
mod number;
mod shortest;

pub use lexer::{Failed, Lexer, Place, Token};
pub use number::{read_number, write_number};

use core::fmt;

/// Splits a name at its first dot. A search for a `char` by the standard library could
/// panic, for all that a compiler knows.
pub(crate) fn split_at_dot(name: &str) -> Option<(&str, &str)> {
    split_around(name, name.bytes().position(|byte| byte == b'.')?)
}

/// Splits a name at its last dot.
pub(crate) fn split_at_last_dot(name: &str) -> Option<(&str, &str)> {
    split_around(name, name.bytes().rposition(|byte| byte == b'.')?)
}

fn split_around(name: &str, place: usize) -> Option<(&str, &str)> {
    Some((name.get(..place)?, name.get(place.checked_add(1)?..)?))
}

/// A text of bounded length in borrowed bytes, for `core::fmt::Write`.
///
/// It keeps counting when it is full, so that one pass tells how much room a
/// text needs.
#[derive(Debug)]
pub struct TextBuffer<'b> {
    bytes: &'b mut [u8],
    needed: usize,
}

impl<'b> TextBuffer<'b> {
    /// An empty text with room for `bytes.len()` bytes.
    pub fn new(bytes: &'b mut [u8]) -> Self {
        TextBuffer { bytes, needed: 0 }
    }

    /// How many bytes the whole text takes, also those that found no room.
    pub fn needed(&self) -> usize {
        self.needed
    }

    /// The text, or `None` if it did not fit.
    pub fn as_str(&self) -> Option<&str> {
        core::str::from_utf8(self.bytes.get(..self.needed)?).ok()
    }
}

impl fmt::Write for TextBuffer<'_> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        let room = self.bytes.iter_mut().skip(self.needed);
        for (slot, byte) in room.zip(text.bytes()) {
            *slot = byte;
        }
        self.needed = self.needed.saturating_add(text.len());
        Ok(())
    }
}
