// SPDX-License-Identifier: MIT
//! Samplers.
use std::sync::Arc;

use crate::object::Object;
use crate::{sys, Context, Result, SamplerDesc};

/// A filter with its settings, for any texture. It never changes; a clone is another owner of the same sampler.
#[derive(Clone, Debug)]
pub struct Sampler(Arc<Object<sys::shd_sampler>>);

impl Sampler {
    /// Makes a sampler.
    pub fn new(context: &Context, desc: &SamplerDesc) -> Result<Self> {
        let raw = desc.to_raw();
        let create = |out| unsafe { sys::shd_sampler_create(context.as_raw(), &raw, out) };
        Ok(Self(Arc::new(Object::create(context, sys::shd_sampler_release, create)?)))
    }

    /// The handle of C, borrowed from this owner.
    #[inline]
    pub fn as_raw(&self) -> *mut sys::shd_sampler {
        self.0.raw()
    }
}
