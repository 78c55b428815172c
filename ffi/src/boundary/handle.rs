//! Handles: what a C program gets a pointer to, in memory that it lends.

use crate::boundary::pointer;
use crate::boundary::status::{
    CRITREG_BUSY, CRITREG_OK, Failure, Fallible, Message, critreg_status, status_of,
};
use core::cell::{Cell, UnsafeCell};

/// A handle carries a seal that depends on its kind and address, so that memory
/// that is no handle, was retired or was moved is refused.
///
/// # Safety
/// `seal` points to a word inside of the handle that nothing else writes to.
pub(crate) unsafe trait Handle: Sized {
    /// Tells kinds of handles apart.
    const KIND: u64;
    /// The name of arguments of this kind.
    const NAME: &'static str;

    /// Where the seal lies, in a handle that need not be one.
    fn seal(handle: *const Self) -> *const usize;
}

/// What a handle of this kind carries at an address.
fn seal_at<H: Handle>(address: usize) -> usize {
    address ^ (H::KIND as usize)
}

/// Writes a handle and seals it; what lay there before is lost.
///
/// # Safety
/// The place is aligned and writable, and nothing else refers to it.
pub(crate) unsafe fn put<H: Handle>(place: *mut H, handle: H) {
    // SAFETY: by this function's contract; handles need no drop.
    unsafe {
        place.write(handle);
        seal(place);
    }
}

/// Seals a handle that was written but for its seal.
///
/// # Safety
/// As for [`put`].
pub(crate) unsafe fn seal<H: Handle>(place: *mut H) {
    // SAFETY: by this function's contract.
    unsafe { H::seal(place).cast_mut().write(seal_at::<H>(place.addr())) }
}

/// Breaks the seal of whatever lies in the memory of a handle.
///
/// # Safety
/// As for [`put`].
pub(crate) unsafe fn retire<H: Handle>(place: *mut H) {
    // SAFETY: by this function's contract; a word may have any value.
    unsafe { H::seal(place).cast_mut().write(0) }
}

/// The handle at a pointer.
///
/// # Safety
/// If not NULL and aligned, the pointer is readable for as long as a handle is.
pub(crate) unsafe fn open<'a, H: Handle>(handle: *const H) -> Fallible<&'a H> {
    pointer::check(handle, H::NAME)?;
    // SAFETY: readable by this function's contract; a word may have any value.
    let seal = unsafe { H::seal(handle).read() };
    if seal != seal_at::<H>(handle.addr()) {
        return Err(Failure::NotAHandle);
    }
    // SAFETY: the seal shows that `put` wrote a handle there.
    Ok(unsafe { &*handle })
}

/// Runs a call that only reads a handle.
///
/// # Safety
/// As for [`open`].
pub(crate) unsafe fn read<H: Handle>(
    handle: *const H,
    body: impl FnOnce(&H) -> Fallible,
) -> critreg_status {
    // SAFETY: by this function's contract.
    status_of(unsafe { open(handle) }.and_then(body))
}

/// What the calls that change a handle borrow, one at a time, and the words about the last
/// one that failed.
///
/// That it is borrowed is a flag and nothing on the stack, so that a call which a `longjmp`
/// out of a callback cut off leaves nothing to be cleaned up but that.
pub(crate) struct Exclusive<T> {
    inner: UnsafeCell<T>,
    busy: Cell<bool>,
    message: Cell<Option<Failure>>,
}

impl<T> Exclusive<T> {
    pub(crate) fn new(inner: T) -> Exclusive<T> {
        Exclusive {
            inner: UnsafeCell::new(inner),
            busy: Cell::new(false),
            message: Cell::new(None),
        }
    }

    /// Runs a call, unless another one runs already, from which a callback calls back.
    pub(crate) fn call(&self, body: impl FnOnce(&mut T) -> Fallible) -> critreg_status {
        if self.busy.replace(true) {
            return CRITREG_BUSY;
        }
        // SAFETY: no other call runs, which the flag tells, so nothing else refers to it.
        let ended = body(unsafe { &mut *self.inner.get() });
        self.busy.set(false);
        match ended {
            Ok(()) => CRITREG_OK,
            Err(failure) => {
                self.message.set(Some(failure));
                failure.status()
            }
        }
    }

    /// Lends what calls borrow, unless one runs already.
    pub(crate) fn borrow<R>(&self, body: impl FnOnce(&mut T) -> R) -> Option<R> {
        if self.busy.replace(true) {
            return None;
        }
        // SAFETY: as for `call`.
        let given = body(unsafe { &mut *self.inner.get() });
        self.busy.set(false);
        Some(given)
    }

    /// Takes back what a call borrowed that was cut off.
    ///
    /// # Safety
    /// No call runs.
    pub(crate) unsafe fn recover(&self) {
        self.busy.set(false);
    }

    /// The words about the last call that failed.
    pub(crate) fn message(&self) -> Message {
        Message(self.message.get())
    }
}
