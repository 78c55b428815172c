//! Framing of saved bytes: a mark, a version, little-endian fields, a checksum.

use crate::error::Error;
use core::fmt;
use crc::{CRC_32_ISO_HDLC, Crc};

/// Checksum that tells domain texts, instances and saved bytes apart. Instances are
/// checked in every call from C, so it has a table: a kilobyte of flash for a seventh of
/// what an answer takes on a microcontroller.
pub(crate) const CHECKSUM: Crc<u32> = Crc::<u32>::new(&CRC_32_ISO_HDLC);

/// Bytes of the frame around the fields: mark, version, checksum.
pub(crate) const FRAME: usize = 4 + 2 + 4;

/// Writes fields until the room is used up, and counts on after that.
pub(crate) struct Writer<'b> {
    bytes: &'b mut [u8],
    length: usize,
}

impl<'b> Writer<'b> {
    pub(crate) fn new(bytes: &'b mut [u8], magic: &[u8; 4], version: u16) -> Self {
        let mut writer = Writer { bytes, length: 0 };
        writer.bytes(magic);
        writer.u16(version);
        writer
    }

    pub(crate) fn bytes(&mut self, bytes: &[u8]) {
        let room = self.bytes.iter_mut().skip(self.length);
        for (slot, byte) in room.zip(bytes) {
            *slot = *byte;
        }
        self.length = self.length.saturating_add(bytes.len());
    }

    pub(crate) fn u16(&mut self, value: u16) {
        self.bytes(&value.to_le_bytes());
    }

    pub(crate) fn u32(&mut self, value: u32) {
        self.bytes(&value.to_le_bytes());
    }

    pub(crate) fn i16(&mut self, value: i16) {
        self.bytes(&value.to_le_bytes());
    }

    pub(crate) fn u64(&mut self, value: u64) {
        self.bytes(&value.to_le_bytes());
    }

    pub(crate) fn f64(&mut self, value: f64) {
        self.u64(value.to_bits());
    }

    /// How many bytes were written, those that found no room included.
    pub(crate) fn length(&self) -> usize {
        self.length
    }

    /// Appends the checksum and returns the length of everything.
    pub(crate) fn finish(mut self, what: &'static str) -> Result<usize, Error> {
        let body = self.bytes.get(..self.length);
        let checksum = CHECKSUM.checksum(body.ok_or(Error::CapacityExceeded(what))?);
        self.u32(checksum);
        if self.length > self.bytes.len() {
            return Err(Error::CapacityExceeded(what));
        }
        Ok(self.length)
    }
}

impl fmt::Write for Writer<'_> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.bytes(text.as_bytes());
        Ok(())
    }
}

/// Reads fields; everything was checked against the checksum before.
pub(crate) struct Reader<'b> {
    rest: &'b [u8],
}

impl<'b> Reader<'b> {
    pub(crate) fn new(bytes: &'b [u8], magic: &[u8; 4], version: u16) -> Result<Self, Error> {
        let Some((found, _)) = bytes.split_first_chunk::<4>() else {
            return Err(Error::Corrupt("the saved bytes are too few"));
        };
        if found != magic {
            return Err(Error::Corrupt("these are not saved bytes of this kind"));
        }
        let Some((body, checksum)) = bytes.split_last_chunk::<4>() else {
            return Err(Error::Corrupt("the saved bytes are too few"));
        };
        if CHECKSUM.checksum(body) != u32::from_le_bytes(*checksum) {
            return Err(Error::Corrupt("the saved bytes are damaged or incomplete"));
        }
        let rest = body.get(magic.len()..).unwrap_or(&[]);
        let mut reader = Reader { rest };
        if reader.u16()? != version {
            return Err(Error::Corrupt("the saved bytes are of another version"));
        }
        Ok(reader)
    }

    fn array<const N: usize>(&mut self) -> Result<[u8; N], Error> {
        let (array, rest) = self
            .rest
            .split_first_chunk::<N>()
            .ok_or(Error::Corrupt("the saved bytes end too early"))?;
        self.rest = rest;
        Ok(*array)
    }

    pub(crate) fn u16(&mut self) -> Result<u16, Error> {
        self.array().map(u16::from_le_bytes)
    }

    pub(crate) fn u32(&mut self) -> Result<u32, Error> {
        self.array().map(u32::from_le_bytes)
    }

    pub(crate) fn i16(&mut self) -> Result<i16, Error> {
        self.array().map(i16::from_le_bytes)
    }

    pub(crate) fn u64(&mut self) -> Result<u64, Error> {
        self.array().map(u64::from_le_bytes)
    }

    pub(crate) fn f64(&mut self) -> Result<f64, Error> {
        self.u64().map(f64::from_bits)
    }

    pub(crate) fn text(&mut self, length: usize) -> Result<&'b str, Error> {
        let (text, rest) = self
            .rest
            .split_at_checked(length)
            .ok_or(Error::Corrupt("the saved bytes end too early"))?;
        self.rest = rest;
        core::str::from_utf8(text).map_err(|_| Error::Corrupt("a saved text is not UTF-8"))
    }

    pub(crate) fn finish(self) -> Result<(), Error> {
        if self.rest.is_empty() {
            Ok(())
        } else {
            Err(Error::Corrupt("the saved bytes are longer than they say"))
        }
    }
}
