// SPDX-License-Identifier: MIT
//! Colour transforms of OpenColorIO: feature `color`.
use std::ffi::{CStr, CString};
use std::os::raw::c_char;
use std::ptr;
use std::sync::Arc;

use crate::error::check;
use crate::object::Object;
use crate::pixels::image_over;
use crate::{sys, ColorDesc, Context, Error, Format, Framebuffer, Plain, Result};

/// An OpenColorIO config. A clone is another owner of the same config.
#[derive(Clone, Debug)]
pub struct Color(Arc<Object<sys::shd_color>>);

fn optional(name: &str, text: Option<&str>) -> Result<Option<CString>> {
    let convert = |text: &str| CString::new(text).map_err(|_| Error::argument(format!("{name}: it has a zero byte")));
    text.map(convert).transpose()
}

fn pointer(text: &Option<CString>) -> *const c_char {
    text.as_ref().map_or(ptr::null(), |text| text.as_ptr())
}

impl Color {
    /// Reads a config: its text (YAML), or without it the file named by the environment variable OCIO, else the
    /// built-in config.
    pub fn new(context: &Context, desc: &ColorDesc, config: Option<&str>) -> Result<Self> {
        let config = optional("config", config)?;
        let mut raw = desc.to_raw();
        raw.config_text = pointer(&config);
        let create = |out| unsafe { sys::shd_color_create(context.as_raw(), &raw, out) };
        Ok(Self(Arc::new(Object::create(context, sys::shd_color_release, create)?)))
    }

    /// The handle of C, borrowed from this owner.
    #[inline]
    pub fn as_raw(&self) -> *mut sys::shd_color {
        self.0.raw()
    }

    /// Names of the displays.
    pub fn displays(&self) -> Vec<String> {
        let count = unsafe { sys::shd_color_get_display_count(self.as_raw()) };
        // Names live as long as the config.
        (0..count).map(|i| unsafe { text_of(sys::shd_color_get_display_name(self.as_raw(), i)) }).collect()
    }

    /// Names of the views of a display; `None` is the default display.
    pub fn views(&self, display: Option<&str>) -> Result<Vec<String>> {
        let display = optional("display", display)?;
        let count = unsafe { sys::shd_color_get_view_count(self.as_raw(), pointer(&display)) };
        let name = |i| unsafe { text_of(sys::shd_color_get_view_name(self.as_raw(), pointer(&display), i)) };
        Ok((0..count).map(name).collect())
    }

    /// Transforms a framebuffer of the same context for a display and a view, into packed rows of a format. `None` is
    /// the default display or view.
    pub fn apply_display<T: Plain>(
        &self,
        framebuffer: &Framebuffer,
        display: Option<&str>,
        view: Option<&str>,
        format: Format,
        out: &mut [T],
    ) -> Result<()> {
        let (display, view) = (optional("display", display)?, optional("view", view)?);
        let image = image_over("out", format, framebuffer.width(), framebuffer.height(), out)?;
        let (display, view) = (pointer(&display), pointer(&view));
        check(unsafe { sys::shd_color_apply_display(self.as_raw(), framebuffer.as_raw(), display, view, &image) })
    }
}

unsafe fn text_of(text: *const c_char) -> String {
    if text.is_null() {
        return String::new();
    }
    unsafe { CStr::from_ptr(text) }.to_string_lossy().into_owned()
}
