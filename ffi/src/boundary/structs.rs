//! Structs of the caller that start with their size, so that programs compiled
//! with an older header get as much of them as they know.

use crate::boundary::pointer;
use crate::boundary::status::{Failure, Fallible};
use core::mem::MaybeUninit;

/// Checks a `struct_size` against the first version of a struct and this one.
pub(crate) fn known_size(size: usize, first: usize, now: usize) -> Fallible<usize> {
    if (first..=now).contains(&size) {
        Ok(size)
    } else {
        Err(Failure::invalid(
            "struct_size is not one this library knows: call the init function of the struct",
        ))
    }
}

/// A struct of the caller that starts with its size.
///
/// # Safety
/// It is `repr(C)` and starts with a `u32`, its `struct_size`.
pub(crate) unsafe trait Versioned: Copy {
    /// Size of its first version: smaller ones never existed.
    const FIRST: usize;
}

/// Fills a struct of the caller, which may be an older one of `size` bytes only.
///
/// # Safety
/// If the pointer is not NULL and aligned, `size` bytes are writable.
pub(crate) unsafe fn init<T: Versioned>(target: *mut T, size: usize, value: T) -> Fallible {
    pointer::check(target, "the struct")?;
    let bytes = known_size(size, T::FIRST, size_of::<T>())?;
    let value = MaybeUninit::new(value);
    // SAFETY: `bytes` is at most the size of the value and of the caller's struct, which
    // starts with its size.
    unsafe {
        core::ptr::copy_nonoverlapping(value.as_ptr().cast::<u8>(), target.cast(), bytes);
        target.cast::<u32>().write(bytes as u32);
    }
    Ok(())
}

/// Fills a struct that its init function prepared and that may be an older,
/// shorter one.
///
/// # Safety
/// If the pointer is not NULL and aligned, its `struct_size` is readable and as
/// many bytes are writable.
pub(crate) unsafe fn write<T: Versioned>(value: T, target: *mut T, name: &'static str) -> Fallible {
    pointer::check(target, name)?;
    // SAFETY: checked; the struct starts with its size, which is readable, and as many
    // bytes are writable, by this function's contract.
    unsafe {
        let size = target.cast::<u32>().read();
        init(target, size as usize, value)
    }
}

/// Reads a struct that its init function prepared and that may be an older,
/// shorter one; the rest of it is as in `defaults`.
///
/// # Safety
/// If the pointer is not NULL and aligned, its `struct_size` is readable and as
/// many bytes are; every bit pattern that C can have written is valid.
pub(crate) unsafe fn read<T: Versioned>(
    source: *const T,
    defaults: T,
    name: &'static str,
) -> Fallible<T> {
    pointer::check(source, name)?;
    // SAFETY: checked; the struct starts with its size, which is readable by this
    // function's contract.
    let size = unsafe { source.cast::<u32>().read() };
    let bytes = known_size(size as usize, T::FIRST, size_of::<T>())?;
    let mut known = defaults;
    // SAFETY: `bytes` is at most the size of either struct.
    unsafe {
        core::ptr::copy_nonoverlapping(source.cast::<u8>(), (&raw mut known).cast(), bytes);
    }
    Ok(known)
}
