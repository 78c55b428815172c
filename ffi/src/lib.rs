//! The C interface of critreg.
//!
//! `include/critreg.h` is generated from this crate and is its manual: the
//! conventions stand at the head of it, the contract of each function above its
//! declaration. This crate is the only place of the library with unsafe code. It
//! does three things: it checks what comes from C, it lays the parts of a handle
//! into the caller's memory, and it calls the safe core.
//!
//! | room | content | knows only |
//! |---|---|---|
//! | [`boundary`] | what comes from C and what goes back: pointers, statuses, structs, text, memory | the core |
//! | [`region`] | regions: as text and as bytes, their constraints, samples | `boundary` |
//! | [`learner`] | learners: configuration, asking and telling, the report, saving | `boundary`, `region` |
//! | [`planner`] | the planner: configuration, callbacks, plans, what they cost | `boundary` |
//! | [`skill`] | skills: what is learned of a program's controllers, and planning with it | `boundary`, `learner`, `planner` |
//! | [`stick_button`] | the built-in environment, to learn and to plan in | `boundary`, `learner`, `planner` |
//!
//! # Why it is sound
//! - The parts of a handle are cut out of the caller's memory without overlap (the
//!   `layout` of a room computes their places with [`boundary::memory`], and nothing else
//!   does), so no reference to one covers another. `'static` in their types means: as long
//!   as the caller lends the memory, which the header makes the caller's promise.
//! - All that a learner or planner changes is behind a `RefCell`. A callback that calls back
//!   finds it borrowed and gets [`boundary::status::CRITREG_BUSY`].
//! - A handle is used only if it carries its seal, which depends on its address:
//!   memory that is no handle, was retired or was moved is refused.
//! - Nothing here panics. If something did, `extern "C"` would abort instead of
//!   unwinding into C.

#![no_std]
#![deny(unsafe_op_in_unsafe_fn)]
#![deny(
    clippy::undocumented_unsafe_blocks,
    clippy::indexing_slicing,
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic
)]
#![allow(
    clippy::missing_safety_doc,
    reason = "one contract for all functions stands at the head of the header"
)]
#![allow(non_camel_case_types, reason = "these are the names of the C types")]

#[cfg_attr(
    not(feature = "planner"),
    allow(
        dead_code,
        unused_imports,
        unused_macros,
        reason = "others need less of it"
    )
)]
pub mod boundary;
#[cfg(feature = "learner")]
pub mod learner;
#[cfg(feature = "planner")]
pub mod planner;
pub mod region;
#[cfg(feature = "planner")]
pub mod skill;
#[cfg(feature = "planner")]
pub mod stick_button;

#[cfg(all(feature = "halt", panic = "abort"))]
#[panic_handler]
fn halt(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {
        core::hint::spin_loop();
    }
}
