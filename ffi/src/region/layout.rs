//! Where the parts of a region lie in its memory, and those of a domain.

use crate::boundary::limits::{
    CRITREG_DOMAIN_TEXT_MAX, CRITREG_HANDLE_POINTERS, CRITREG_REGION_FIXED_BYTES,
};
use crate::boundary::memory::{Packer, Part, append, copy_text};
use crate::boundary::status::Fallible;
use crate::region::handle::critreg_region;
use critreg_core::domain::Domain;

/// The parts of a region with memory of its own.
pub(crate) struct RegionLayout {
    pub(crate) handle: Part<critreg_region>,
    pub(crate) domain: DomainLayout,
    pub(crate) size: usize,
}

/// A domain and the text that it borrows its names from.
pub(crate) struct DomainLayout {
    domain: Part<Domain<'static>>,
    text: Part<u8>,
}

impl DomainLayout {
    pub(crate) const fn new(packer: &mut Packer) -> Option<DomainLayout> {
        Some(DomainLayout {
            domain: append!(packer, 1),
            text: append!(packer, CRITREG_DOMAIN_TEXT_MAX),
        })
    }

    /// Copies a text of less than [`CRITREG_DOMAIN_TEXT_MAX`] bytes and reads the
    /// domain from the copy.
    ///
    /// # Safety
    /// As for [`Part::fill`]; `text` does not lie in the memory.
    pub(crate) unsafe fn put(
        &self,
        memory: *mut u8,
        text: &str,
    ) -> Fallible<&'static Domain<'static>> {
        // SAFETY: by this function's contract; the two parts do not overlap, and
        // after this function both are only read.
        let (place, room) = unsafe { (self.domain.place(memory), self.text.fill(memory, 0)) };
        // SAFETY: as above; a domain needs no drop, so what was there may be lost.
        let domain = unsafe {
            place.write(Domain::empty());
            &mut *place
        };
        domain.read(copy_text(text, room)?)?;
        Ok(domain)
    }
}

impl RegionLayout {
    pub(crate) const fn new() -> Option<RegionLayout> {
        let mut packer = Packer { size: 0 };
        let handle = append!(packer, 1);
        let Some(domain) = DomainLayout::new(&mut packer) else {
            return None;
        };
        Some(RegionLayout {
            handle,
            domain,
            size: packer.size,
        })
    }
}

// The macro of the header promises enough memory; on every target that is built.
const _: () = {
    const POINTERS: usize = CRITREG_HANDLE_POINTERS * size_of::<*const u8>();
    let Some(region) = RegionLayout::new() else {
        panic!()
    };
    assert!(CRITREG_REGION_FIXED_BYTES + POINTERS >= region.size);
};
