// SPDX-License-Identifier: MIT
//! One reference to an object of the library.
use std::fmt;
use std::ptr::{self, NonNull};

use crate::error::check;
use crate::{Context, Result, ResultCode};

/// One reference to an object, released by drop. The context's callbacks live at least as long as the object.
pub(crate) struct Object<T> {
    raw: NonNull<T>,
    release: unsafe extern "C" fn(*mut T),
    context: Context,
}

// Objects may be retained and released by any thread, and functions that take them by a shared reference may run
// concurrently (@file comments of the headers). Types that are changed need `&mut self`.
unsafe impl<T> Send for Object<T> {}
unsafe impl<T> Sync for Object<T> {}

impl<T> Object<T> {
    /// Takes the reference that a create function returns.
    pub(crate) fn create(
        context: &Context,
        release: unsafe extern "C" fn(*mut T),
        create: impl FnOnce(*mut *mut T) -> ResultCode,
    ) -> Result<Self> {
        let mut raw = ptr::null_mut();
        check(create(&mut raw))?;
        let raw = NonNull::new(raw).expect("a function that succeeds returns an object");
        Ok(Self { raw, release, context: context.clone() })
    }

    /// Another reference to an object that is borrowed.
    #[cfg(feature = "scene")]
    pub(crate) fn share(
        context: &Context,
        raw: *mut T,
        retain: unsafe extern "C" fn(*mut T),
        release: unsafe extern "C" fn(*mut T),
    ) -> Self {
        unsafe { retain(raw) };
        let raw = NonNull::new(raw).expect("the object is there");
        Self { raw, release, context: context.clone() }
    }

    pub(crate) fn raw(&self) -> *mut T {
        self.raw.as_ptr()
    }

    pub(crate) fn context(&self) -> &Context {
        &self.context
    }
}

impl<T> fmt::Debug for Object<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Pointer::fmt(&self.raw, f)
    }
}

impl<T> Drop for Object<T> {
    fn drop(&mut self) {
        // The reference is this object's own.
        unsafe { (self.release)(self.raw.as_ptr()) }
    }
}
