// SPDX-License-Identifier: MIT
//! The context, and the log and executor of the host.
use std::ffi::{c_void, CStr, CString};
use std::fmt;
use std::os::raw::c_char;
use std::panic::{self, AssertUnwindSafe};
use std::ptr::{self, NonNull};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::Arc;

use crate::error::{check, keep_panic};
use crate::{sys, ContextDesc, Error, LogLevel, Result, ResultCode};

type Log = dyn Fn(LogLevel, &str) + Send + Sync;

/// The host's functions. The library has a pointer to this struct until the context is released.
#[derive(Default)]
struct Callbacks {
    log: Option<Box<Log>>,
    executor: Option<Box<dyn Executor>>,
    worker_count: usize,
}

struct Inner {
    raw: NonNull<sys::shd_context>,
    _callbacks: Arc<Callbacks>,
}

// A context may be used by any thread, and its callbacks are Send and Sync.
unsafe impl Send for Inner {}
unsafe impl Sync for Inner {}

impl Drop for Inner {
    fn drop(&mut self) {
        // Every object holds a clone of its context, so no object is left that could call the callbacks.
        unsafe { sys::shd_context_release(self.raw.as_ptr()) }
    }
}

/// Memory, tasks, log and SIMD target of everything made from it. A clone is another owner of the same context.
///
/// Every object keeps its context alive, so objects and contexts may be dropped in any order, by any thread.
#[derive(Clone)]
pub struct Context(Arc<Inner>);

impl fmt::Debug for Context {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Context({:?}, {}, {} workers)", self.0.raw, self.simd_target(), self.worker_count())
    }
}

impl Context {
    /// Makes a context with all defaults: one worker per core, and no log.
    pub fn new() -> Result<Self> {
        Self::builder(ContextDesc::default()).build()
    }

    /// Begins a context with options, a log or an executor.
    pub fn builder(desc: ContextDesc) -> ContextBuilder {
        ContextBuilder { desc, callbacks: Callbacks::default() }
    }

    /// Returns the working memory that the context keeps between calls.
    pub fn trim(&self) {
        unsafe { sys::shd_context_trim(self.as_raw()) }
    }

    /// Writes a line to the log.
    pub fn log(&self, level: LogLevel, line: &str) {
        // A string of C ends at the first zero.
        let line = CString::new(line.split('\0').next().unwrap_or("")).unwrap_or_default();
        unsafe { sys::shd_context_log(self.as_raw(), level, line.as_ptr()) }
    }

    /// Name of the SIMD target of the kernels, such as "AVX2".
    pub fn simd_target(&self) -> &'static str {
        // The string is static ASCII.
        unsafe { CStr::from_ptr(sys::shd_context_get_simd_target(self.as_raw())) }.to_str().unwrap_or("")
    }

    /// Number of workers of the executor, at least 1.
    pub fn worker_count(&self) -> usize {
        unsafe { sys::shd_context_get_worker_count(self.as_raw()) }
    }

    /// The handle of C, borrowed from this owner.
    #[inline]
    pub fn as_raw(&self) -> *mut sys::shd_context {
        self.0.raw.as_ptr()
    }
}

/// A context to be made; see [`Context::builder`].
pub struct ContextBuilder {
    desc: ContextDesc,
    callbacks: Callbacks,
}

impl ContextBuilder {
    /// Lines of the log. They come from any thread, also concurrently. `write` must not call this crate: the library
    /// may hold locks. A panic of `write` ends the process.
    pub fn log(mut self, write: impl Fn(LogLevel, &str) + Send + Sync + 'static) -> Self {
        self.callbacks.log = Some(Box::new(write));
        self
    }

    /// Runs the library's tasks by the host's job system. [`ContextDesc::worker_count`] then has no effect.
    pub fn executor(mut self, executor: impl Executor + 'static) -> Self {
        self.callbacks.worker_count = executor.worker_count();
        self.callbacks.executor = Some(Box::new(executor));
        self
    }

    /// Makes the context.
    pub fn build(self) -> Result<Context> {
        check_version(unsafe { sys::shd_version() })?;
        let mut desc = self.desc.to_raw();
        let callbacks = Arc::new(self.callbacks);
        let user_data = Arc::as_ptr(&callbacks) as *mut c_void;
        if callbacks.log.is_some() {
            desc.log = sys::shd_log { write: Some(write_log), user_data };
        }
        if callbacks.executor.is_some() {
            let worker_count = callbacks.worker_count;
            desc.executor = sys::shd_executor { parallel_for: Some(parallel_for), user_data, worker_count };
        }
        let mut raw = ptr::null_mut();
        check(unsafe { sys::shd_context_create(&desc, &mut raw) })?;
        let raw = NonNull::new(raw).ok_or_else(|| Error::new(ResultCode::ERROR_INTERNAL, "context: NULL"))?;
        Ok(Context(Arc::new(Inner { raw, _callbacks: callbacks })))
    }
}

/// Structs that the library lends to programs may grow with the minor version.
fn check_version(running: u32) -> Result<()> {
    let (major, minor) = (running >> 16, running >> 8 & 0xff);
    if (major, minor) == (sys::SHD_VERSION_MAJOR, sys::SHD_VERSION_MINOR) {
        return Ok(());
    }
    let own = format!("{}.{}", sys::SHD_VERSION_MAJOR, sys::SHD_VERSION_MINOR);
    Err(Error::new(ResultCode::ERROR_UNSUPPORTED, format!("libshd is {major}.{minor}, but this crate is for {own}")))
}

/// Ends the process when it is dropped, which happens if a panic passes: a panic must not reach C.
struct AbortOnPanic;

impl Drop for AbortOnPanic {
    fn drop(&mut self) {
        std::process::abort();
    }
}

unsafe extern "C" fn write_log(level: LogLevel, message: *const c_char, user_data: *mut c_void) {
    let guard = AbortOnPanic;
    // The library passes the user_data of build() and a string that lives during the call.
    let (callbacks, message) = unsafe { (&*(user_data as *const Callbacks), CStr::from_ptr(message)) };
    if let Some(write) = &callbacks.log {
        write(level, &message.to_string_lossy());
    }
    std::mem::forget(guard);
}

/// A job system of the host.
///
/// ```
/// struct Threads;
/// impl shd::Executor for Threads {
///     fn worker_count(&self) -> usize { 4 }
///     fn parallel_for(&self, tasks: &shd::Tasks) {
///         std::thread::scope(|scope| {
///             for worker in 0..self.worker_count() {
///                 scope.spawn(move || tasks.work(worker));
///             }
///         });
///     }
/// }
/// let context = shd::Context::builder(shd::ContextDesc::default()).executor(Threads).build()?;
/// assert_eq!(context.worker_count(), 4);
/// # Ok::<(), shd::Error>(())
/// ```
pub trait Executor: Send + Sync {
    /// Number of workers, 1..1024. It is read once, when the context is made.
    fn worker_count(&self) -> usize;

    /// Runs every task once, and returns when all are done. It runs on the thread that called the library. If it
    /// panics, the call that needed the tasks panics.
    fn parallel_for(&self, tasks: &Tasks<'_>);
}

/// The tasks of one [`Executor::parallel_for`]. Workers on different threads share them by reference.
pub struct Tasks<'a> {
    count: usize,
    task: unsafe extern "C" fn(usize, usize, *mut c_void),
    task_data: *mut c_void,
    next: AtomicUsize,
    busy: &'a [AtomicBool],
}

// The library lets any thread run a task, and `busy` keeps a worker from running two tasks concurrently.
unsafe impl Send for Tasks<'_> {}
unsafe impl Sync for Tasks<'_> {}

impl Tasks<'_> {
    /// Number of tasks.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Runs one task. Every index below [`Tasks::count`] must be run once.
    ///
    /// # Panics
    /// If the worker is not below the number of workers, or runs another task at present. The library fails with
    /// `ERROR_CALLBACK` if a task runs twice or not at all.
    pub fn run(&self, index: usize, worker: usize) {
        let busy = match self.busy.get(worker) {
            Some(busy) => busy,
            None => panic!("tasks.run: worker {worker} is not in 0..{}", self.busy.len()),
        };
        assert!(!busy.swap(true, Ordering::Acquire), "tasks.run: worker {worker} runs two tasks concurrently");
        // The tasks live until parallel_for returns, which the lifetime ensures. A task does not throw.
        unsafe { (self.task)(index, worker, self.task_data) };
        busy.store(false, Ordering::Release);
    }

    /// Runs tasks that no other worker has begun, until there are none left.
    pub fn work(&self, worker: usize) {
        loop {
            let index = self.next.fetch_add(1, Ordering::Relaxed);
            if index >= self.count {
                return;
            }
            self.run(index, worker);
        }
    }
}

unsafe extern "C" fn parallel_for(
    count: usize,
    task: sys::shd_task_fn,
    task_data: *mut c_void,
    user_data: *mut c_void,
) -> ResultCode {
    // The library passes the user_data of build().
    let callbacks = unsafe { &*(user_data as *const Callbacks) };
    let run = AssertUnwindSafe(|| {
        if let (Some(executor), Some(task)) = (&callbacks.executor, task) {
            let busy: Vec<AtomicBool> = (0..callbacks.worker_count).map(|_| AtomicBool::new(false)).collect();
            executor.parallel_for(&Tasks { count, task, task_data, next: AtomicUsize::new(0), busy: &busy });
        }
    });
    match panic::catch_unwind(run) {
        Ok(()) => ResultCode::OK,
        Err(panic) => {
            keep_panic(panic);
            ResultCode::ERROR_CALLBACK
        }
    }
}

#[cfg(test)]
mod tests {
    use super::check_version;

    #[test]
    fn another_minor_version_is_refused() {
        assert!(check_version(crate::sys::SHD_VERSION_MINOR << 8 | 9).is_ok());
        assert_eq!(check_version(7 << 8).unwrap_err().message(), "libshd is 0.7, but this crate is for 0.1");
    }
}
