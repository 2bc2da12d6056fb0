// SPDX-License-Identifier: MIT
//! Results of the library.
use std::any::Any;
use std::cell::RefCell;
use std::ffi::CStr;
use std::fmt;
use std::panic;

use crate::{sys, ResultCode};

/// A call that failed: its result code and the text of the library, which names the argument, its value and its range.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    code: ResultCode,
    message: String,
}

/// The result of a fallible function. With a second type it is the `Result` of the standard library, also after
/// `use shd::*`:
///
/// ```
/// use shd::*;
///
/// fn workers(count: &str) -> Result<Context, Box<dyn std::error::Error>> {
///     let desc = ContextDesc { worker_count: count.parse()?, ..Default::default() };
///     Ok(Context::builder(desc).build()?)
/// }
/// assert_eq!(workers("1")?.worker_count(), 1);
/// assert!(workers("one").is_err() && workers("1025").is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub type Result<T, E = Error> = std::result::Result<T, E>;

impl Error {
    pub(crate) fn new(code: ResultCode, message: impl Into<String>) -> Self {
        Self { code, message: message.into() }
    }

    /// An argument that this crate refuses.
    pub(crate) fn argument(message: impl Into<String>) -> Self {
        Self::new(ResultCode::ERROR_INVALID_ARGUMENT, message)
    }

    /// The result code, such as [`ResultCode::ERROR_INVALID_ARGUMENT`].
    pub fn code(&self) -> ResultCode {
        self.code
    }

    /// The text of the library.
    pub fn message(&self) -> &str {
        &self.message
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({:?})", self.message, self.code)
    }
}

impl std::error::Error for Error {}

pub(crate) type Panic = Box<dyn Any + Send>;

thread_local! {
    /// The panic of an executor. An executor runs on the thread that called the library.
    static PANIC: RefCell<Option<Panic>> = RefCell::new(None);
}

/// Keeps the panic of an executor until the call of the library returns.
pub(crate) fn keep_panic(panic: Panic) {
    // A thread that ends has no place for a panic.
    let _ = PANIC.try_with(|kept| *kept.borrow_mut() = Some(panic));
}

/// The result of a call on this thread. Its text is read at once, because the next call may replace it.
#[inline]
pub(crate) fn check(code: ResultCode) -> Result<()> {
    if code == ResultCode::OK {
        return Ok(());
    }
    Err(last_error(code))
}

#[cold]
fn last_error(code: ResultCode) -> Error {
    if let Ok(Some(panic)) = PANIC.try_with(|kept| kept.borrow_mut().take()) {
        panic::resume_unwind(panic);
    }
    // The text is UTF-8 with an end, valid until the next failure on this thread.
    let text = unsafe { CStr::from_ptr(sys::shd_last_error()) };
    Error::new(code, text.to_string_lossy())
}
