//! The parts of a handle in the caller's memory: a layout puts them one behind the other,
//! tells how long they are together, and cuts the memory up.

use crate::boundary::status::{Failure, Fallible};
use core::marker::PhantomData;

/// Alignment of all handles: memory made of `uint64_t` always fits.
pub(crate) const ALIGNMENT: usize = align_of::<u64>();

/// Some values of one type at their place in a layout.
pub(crate) struct Part<T> {
    offset: usize,
    count: usize,
    kind: PhantomData<T>,
}

impl<T> Part<T> {
    /// Where the first value lies.
    ///
    /// # Safety
    /// `memory` is aligned to [`ALIGNMENT`] and as long as the layout that the part
    /// belongs to.
    pub(crate) unsafe fn place(&self, memory: *mut u8) -> *mut T {
        // SAFETY: the layout put the part inside of the memory.
        unsafe { memory.add(self.offset).cast() }
    }

    /// Fills the part and lends it.
    ///
    /// # Safety
    /// As for [`Part::place`]; and nothing else refers to the part while what is
    /// returned is used.
    #[inline(never)]
    pub(crate) unsafe fn fill(&self, memory: *mut u8, value: T) -> &'static mut [T]
    where
        T: Clone,
    {
        // SAFETY: by this function's contract.
        unsafe { self.fill_with(memory, || value.clone()) }
    }

    /// Puts the only value of the part there, and lends it.
    ///
    /// # Safety
    /// As for [`Part::fill`].
    pub(crate) unsafe fn put(&self, memory: *mut u8, value: T) -> &'static mut T {
        // SAFETY: by this function's contract; the place is aligned for the value.
        unsafe {
            let place = self.place(memory);
            place.write(value);
            &mut *place
        }
    }

    /// As [`Part::fill`], each value made by a call.
    ///
    /// # Safety
    /// As for [`Part::fill`].
    pub(crate) unsafe fn fill_with(
        &self,
        memory: *mut u8,
        mut value: impl FnMut() -> T,
    ) -> &'static mut [T] {
        // SAFETY: `count` values fit at the place, which is aligned for them.
        unsafe {
            let first = self.place(memory);
            for index in 0..self.count {
                first.add(index).write(value());
            }
            core::slice::from_raw_parts_mut(first, self.count)
        }
    }
}

/// Counts bytes while parts are put one behind the other.
#[derive(Clone, Copy)]
pub(crate) struct Packer {
    pub(crate) size: usize,
}

impl Packer {
    /// Appends values; `None` if memory cannot be that long.
    pub(crate) const fn append<T>(&mut self, count: usize) -> Option<Part<T>> {
        const { assert!(align_of::<T>() <= ALIGNMENT) };
        let Some(offset) = self.size.checked_next_multiple_of(align_of::<T>()) else {
            return None;
        };
        let Some(bytes) = size_of::<T>().checked_mul(count) else {
            return None;
        };
        match offset.checked_add(bytes) {
            Some(end) if end <= isize::MAX as usize => self.size = end,
            _ => return None,
        }
        Some(Part {
            offset,
            count,
            kind: PhantomData,
        })
    }
}

/// Appends a part or leaves the function with `None` (`?` is not const).
macro_rules! append {
    ($packer:ident, $count:expr) => {
        match $packer.append($count) {
            Some(part) => part,
            None => return None,
        }
    };
}
pub(crate) use append;

/// Declares a struct of parts, and the function that appends them in this order: of each
/// what is in it, and how many. Generic over a type of numbers, or over words of a set in
/// square brackets.
macro_rules! parts {
    (
        $(#[$doc:meta])*
        $name:ident $(<$real:ident>)? $([$words:ident])? with $capacity:ident: $capacities:ty;
        $($part:ident: $entry:ty, $count:expr;)*
    ) => {
        $(#[$doc])*
        pub(crate) struct $name $(<$real: 'static>)? $(<const $words: usize>)? {
            $(pub(crate) $part: Part<$entry>,)*
        }

        impl $(<$real: 'static>)? $(<const $words: usize>)?
            $name $(<$real>)? $(<$words>)?
        {
            /// `None` if memory cannot be that long.
            pub(crate) const fn new(packer: &mut Packer, $capacity: $capacities) -> Option<Self> {
                Some($name {
                    $($part: append!(packer, $count),)*
                })
            }
        }
    };
}
pub(crate) use parts;

/// Copies a text to the beginning of a room that is at least as long.
pub(crate) fn copy_text(text: &str, room: &'static mut [u8]) -> Fallible<&'static str> {
    for (slot, byte) in room.iter_mut().zip(text.bytes()) {
        *slot = byte;
    }
    let copied = room.get(..text.len()).unwrap_or(&[]);
    let copied = core::str::from_utf8(copied);
    copied.map_err(|_| Failure::invalid("the text is not UTF-8"))
}
