//! A region as bytes: domain text and region text, versioned and checksummed.
//!
//! | bytes | content |
//! |---|---|
//! | 4 | `CRRG` |
//! | 2 | version, little endian |
//! | 2 | bits of the numbers that are computed with, little endian |
//! | 2 | length of the domain text, little endian |
//! | 2 | length of the region text, little endian |
//! | n | domain text, UTF-8 |
//! | m | region text, UTF-8 |
//! | 4 | CRC-32 of all before, little endian |
//!
//! Texts are exact (numbers are written so that they read back to the same bits)
//! and survive changes of the structures in memory.

use super::lifted::Region;
use crate::domain::Domain;
use crate::error::Error;
use crate::real::Real;
use crate::text::TextBuffer;
use crate::wire::{FRAME, Reader, Writer};

const MAGIC: &[u8; 4] = b"CRRG";
const VERSION: u16 = 2;

/// Saved bytes that were checked and cut into their texts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SavedRegion<'b> {
    /// What it computes with, see [`Real::BITS`].
    pub bits: u16,
    /// The domain the region belongs to.
    pub domain_text: &'b str,
    /// The region itself.
    pub region_text: &'b str,
}

impl<'b> SavedRegion<'b> {
    /// Checks bytes that [`Region::save`] made.
    ///
    /// # Errors
    /// [`Error::Corrupt`] if they are damaged, incomplete or of another version.
    pub fn read(bytes: &'b [u8]) -> Result<Self, Error> {
        let mut reader = Reader::new(bytes, MAGIC, VERSION)?;
        let bits = reader.u16()?;
        let domain_length = reader.u16()?;
        let region_length = reader.u16()?;
        let saved = SavedRegion {
            bits,
            domain_text: reader.text(usize::from(domain_length))?,
            region_text: reader.text(usize::from(region_length))?,
        };
        reader.finish()?;
        Ok(saved)
    }
}

impl Region {
    /// Writes the region, its domain and what it computes with into `bytes` and returns how
    /// many were used.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] if `bytes` is too short; it then holds a useless part.
    /// [`Region::saved_len`] tells the length needed.
    pub fn save<R: Real>(&self, domain: &Domain<'_>, bytes: &mut [u8]) -> Result<usize, Error> {
        const TOO_LONG: Error = Error::CapacityExceeded("a text of more than 65535 bytes");
        let region_length = self.text_len(domain);
        let mut writer = Writer::new(bytes, MAGIC, VERSION);
        writer.u16(R::BITS);
        writer.u16(u16::try_from(domain.text().len()).map_err(|_| TOO_LONG)?);
        writer.u16(u16::try_from(region_length).map_err(|_| TOO_LONG)?);
        writer.bytes(domain.text().as_bytes());
        self.write(domain, &mut writer)
            .map_err(|_| Error::CapacityExceeded("bytes for a saved region"))?;
        writer.finish("bytes for a saved region")
    }

    /// How many bytes [`Region::save`] needs.
    pub fn saved_len(&self, domain: &Domain<'_>) -> usize {
        FRAME + 6 + domain.text().len() + self.text_len(domain)
    }

    /// How many bytes its text takes.
    pub fn text_len(&self, domain: &Domain<'_>) -> usize {
        let mut counter = TextBuffer::new(&mut []);
        match self.write(domain, &mut counter) {
            Ok(()) => counter.needed(),
            Err(_) => 0,
        }
    }
}
