// SPDX-License-Identifier: MIT
//! Lights.
use std::ptr;
use std::sync::Arc;

use crate::object::Object;
use crate::{sys, Context, LightDesc, Result, Sampler, Texture};

#[derive(Debug)]
struct Inner<'a> {
    object: Object<sys::shd_light>,
    // Dropped after the light, which has them.
    _cookie: Option<(Texture<'a>, Option<Sampler>)>,
}

/// A source of light in world space. A light never changes; a clone is another owner of the same light.
#[derive(Clone, Debug)]
pub struct Light<'a>(Arc<Inner<'a>>);

impl Light<'static> {
    /// Makes a light.
    pub fn new(context: &Context, desc: &LightDesc) -> Result<Self> {
        Light::create(context, desc, None)
    }

    /// A light that keeps its cookie itself.
    #[cfg(feature = "scene")]
    pub(crate) fn of(object: Object<sys::shd_light>) -> Self {
        Self(Arc::new(Inner { object, _cookie: None }))
    }
}

impl<'a> Light<'a> {
    /// Makes a spot or a directional light that projects a texture onto the scene. Without a sampler, the texture is
    /// filtered bilinearly and black outside.
    pub fn with_cookie(
        context: &Context,
        desc: &LightDesc,
        texture: &Texture<'a>,
        sampler: Option<&Sampler>,
    ) -> Result<Self> {
        Self::create(context, desc, Some((texture.clone(), sampler.cloned())))
    }

    fn create(context: &Context, desc: &LightDesc, cookie: Option<(Texture<'a>, Option<Sampler>)>) -> Result<Self> {
        let mut raw = desc.to_raw();
        if let Some((texture, sampler)) = &cookie {
            raw.texture = texture.as_raw();
            raw.sampler = sampler.as_ref().map_or(ptr::null_mut(), Sampler::as_raw);
        }
        let create = |out| unsafe { sys::shd_light_create(context.as_raw(), &raw, out) };
        let object = Object::create(context, sys::shd_light_release, create)?;
        Ok(Self(Arc::new(Inner { object, _cookie: cookie })))
    }

    /// The handle of C, borrowed from this owner.
    #[inline]
    pub fn as_raw(&self) -> *mut sys::shd_light {
        self.0.object.raw()
    }
}
