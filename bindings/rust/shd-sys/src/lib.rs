// SPDX-License-Identifier: MIT
//! The C API of shd, as in its headers: structs, constants, callbacks and functions.
//!
//! Enums are structs around an integer, so that a value of a newer library is no undefined behaviour. Each constant
//! has two names: `shd_filter::EWA` and `SHD_FILTER_EWA`. Sized structs implement `Default`, which calls
//! `shd_desc_init()`. The inline functions of the headers are therefore left out.
//!
//! The crate `shd` is the safe form of this API.
#![allow(non_camel_case_types)]
#![allow(clippy::missing_safety_doc, clippy::doc_lazy_continuation)]

#[macro_use]
mod macros;
#[rustfmt::skip]
mod api;

pub use api::*;

/// Marks an object of the library: it is behind a pointer, never moves, and has its own rules for threads.
type Opaque = core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>;
