//! Everything that the library can do, in a program without std. `link.sh` links it
//! with nothing but a start-up file: what needs an operating system, a heap, or a panic
//! is an undefined symbol.
#![no_std]

mod learning;
mod planning;

// The functions of the C interface, which `link.sh` takes from the header.
use critreg_ffi as _;

unsafe extern "C" {
    /// Defined nowhere: the program links only if the panic handler is not needed.
    safe fn a_panic_is_reachable() -> !;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    a_panic_is_reachable()
}

/// What `link.sh` sees to it that it cannot be linked.
#[unsafe(no_mangle)]
pub extern "C" fn no_std_panic(index: usize) -> u8 {
    [1, 2, 3][index]
}
