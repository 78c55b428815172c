//! Checks of what comes from C, and writing what goes back.

use crate::boundary::status::{Failure, Fallible};
use core::ffi::{CStr, c_char};
use critreg_core::Error;

/// Checks a pointer for NULL and alignment; `name` is that of the argument.
pub(crate) fn check<T>(pointer: *const T, name: &'static str) -> Fallible {
    if pointer.is_null() {
        Err(Failure::Null(name))
    } else if !pointer.is_aligned() {
        Err(Failure::Misaligned(name))
    } else {
        Ok(())
    }
}

/// The `count` values at a pointer, which may be NULL if there are none.
///
/// # Safety
/// If it is not NULL and aligned, `count` values can be read there for `'a`.
pub(crate) unsafe fn slice<'a, T>(
    pointer: *const T,
    count: usize,
    name: &'static str,
) -> Fallible<&'a [T]> {
    if count == 0 {
        return Ok(&[]);
    }
    check(pointer, name)?;
    let bytes = count.checked_mul(size_of::<T>());
    if bytes.is_none_or(|bytes| bytes > isize::MAX as usize) {
        return Err(Failure::invalid("an array is longer than memory can be"));
    }
    // SAFETY: checked for NULL, alignment and length; readable by this function's
    // contract.
    Ok(unsafe { core::slice::from_raw_parts(pointer, count) })
}

/// The `count` values at a pointer, which may be NULL if there are none, set to zero.
///
/// # Safety
/// If it is not NULL and aligned, `count` values can be written there for `'a`, and nothing
/// else refers to them.
pub(crate) unsafe fn zeros<'a, T: Default>(
    pointer: *mut T,
    count: usize,
    name: &'static str,
) -> Fallible<&'a mut [T]> {
    if count == 0 {
        return Ok(&mut []);
    }
    check(pointer, name)?;
    let bytes = count.checked_mul(size_of::<T>());
    if bytes.is_none_or(|bytes| bytes > isize::MAX as usize) {
        return Err(Failure::invalid("an array is longer than memory can be"));
    }
    // SAFETY: checked; writable by this function's contract, and initialised before a
    // reference to them is made.
    unsafe {
        for place in 0..count {
            pointer.add(place).write(T::default());
        }
        Ok(core::slice::from_raw_parts_mut(pointer, count))
    }
}

/// A pointer to these numbers for a callback; to some number if there are none, because
/// an empty slice lies nowhere.
pub(crate) fn to_numbers(numbers: &[f64]) -> *const f64 {
    static SOME: f64 = 0.0;
    match numbers {
        [] => &raw const SOME,
        _ => numbers.as_ptr(),
    }
}

/// The text at a pointer, of at most `longest` bytes with its NUL.
///
/// # Safety
/// If it is not NULL, it can be read up to its NUL for `'a`.
pub(crate) unsafe fn text<'a>(
    pointer: *const c_char,
    longest: usize,
    name: &'static str,
) -> Fallible<&'a str> {
    check(pointer, name)?;
    let mut length = 0;
    // SAFETY: no byte behind the NUL is read, which this function's contract
    // makes readable.
    while unsafe { pointer.add(length).read() } != 0 {
        length += 1;
        if length >= longest {
            return Err(Error::CapacityExceeded("the text is too long").into());
        }
    }
    // SAFETY: these bytes were just read.
    let text = unsafe { CStr::from_ptr(pointer) };
    text.to_str()
        .map_err(|_| Failure::invalid("the text is not UTF-8"))
}

/// A place for a result, checked before any work is done.
pub(crate) struct Output<T>(*mut T);

impl<T> Output<T> {
    /// # Safety
    /// If the pointer is not NULL and aligned, a value can be written there until
    /// the function that was called from C returns.
    pub(crate) unsafe fn new(pointer: *mut T, name: &'static str) -> Fallible<Self> {
        check(pointer, name)?;
        Ok(Output(pointer))
    }

    /// The same for a result that is not wanted if the pointer is NULL.
    ///
    /// # Safety
    /// As for [`Output::new`].
    pub(crate) unsafe fn optional(pointer: *mut T, name: &'static str) -> Fallible<Option<Self>> {
        if pointer.is_null() {
            return Ok(None);
        }
        // SAFETY: by this function's contract.
        unsafe { Output::new(pointer, name) }.map(Some)
    }

    pub(crate) fn write(self, value: T) {
        // SAFETY: checked, and writable by the contract of `new`.
        unsafe { self.0.write(value) }
    }
}

/// A place for several results, which may be NULL if there are none.
pub(crate) struct OutputArray<T> {
    first: *mut T,
    count: usize,
}

impl<T: Copy> OutputArray<T> {
    /// # Safety
    /// If the pointer is not NULL and aligned, `count` values can be written there
    /// until the function that was called from C returns.
    pub(crate) unsafe fn new(first: *mut T, count: usize, name: &'static str) -> Fallible<Self> {
        if count > 0 {
            check(first, name)?;
        }
        Ok(OutputArray { first, count })
    }

    /// Writes the first of these values, as many as there are places.
    pub(crate) fn write(self, values: &[T]) {
        self.write_each(values.iter().copied());
    }

    /// As [`OutputArray::write`].
    pub(crate) fn write_each(self, values: impl Iterator<Item = T>) {
        for (index, value) in values.take(self.count).enumerate() {
            // SAFETY: checked, and writable by the contract of `new`.
            unsafe { self.first.add(index).write(value) }
        }
    }
}
