// SPDX-License-Identifier: MIT
//! Environments.
use std::sync::Arc;

use crate::error::check;
use crate::object::Object;
use crate::pixels::{check_alignment, check_size, pixel_size};
use crate::{sys, Context, EnvironmentDesc, EnvironmentInfo, Format, Plain, Result};

/// Light from all directions. An environment never changes; a clone is another owner of the same environment.
#[derive(Clone, Debug)]
pub struct Environment(Arc<Object<sys::shd_environment>>);

impl Environment {
    /// Makes an environment of an image of linear radiance, packed rows from top to bottom.
    pub fn new<T: Plain>(
        context: &Context,
        desc: &EnvironmentDesc,
        format: Format,
        width: u32,
        height: u32,
        pixels: &[T],
    ) -> Result<Self> {
        let row = pixel_size("environment.image", format)?.checked_mul(width as usize);
        check_size("environment.image", pixels, row.and_then(|row| row.checked_mul(height as usize)))?;
        check_alignment("environment.image", format, pixels)?;
        let pixels = pixels.as_ptr() as *mut _;
        let image = sys::shd_image { format, width, height, pixels, ..Default::default() };
        let mut raw = desc.to_raw();
        raw.image = &image;
        let create = |out| unsafe { sys::shd_environment_create(context.as_raw(), &raw, out) };
        Ok(Self(Arc::new(Object::create(context, sys::shd_environment_release, create)?)))
    }

    /// The handle of C, borrowed from this owner.
    #[inline]
    pub fn as_raw(&self) -> *mut sys::shd_environment {
        self.0.raw()
    }

    /// Tables, mean radiance and memory.
    pub fn info(&self) -> Result<EnvironmentInfo> {
        let mut raw = sys::shd_environment_info::default();
        check(unsafe { sys::shd_environment_get_info(self.as_raw(), &mut raw) })?;
        Ok(EnvironmentInfo::from_raw(&raw))
    }
}
