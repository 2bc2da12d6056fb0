// SPDX-License-Identifier: MIT
//! Shadows.
use crate::error::check;
use crate::object::Object;
use crate::program::Call;
use crate::render::raw_draws;
use crate::{sys, Context, Draw, Light, Result, ShadowDesc, ShadowRenderDesc};

/// Depths as seen from a light. A shadow has one owner: rendering its map takes it exclusively, and frames that use it
/// may run concurrently.
#[derive(Debug)]
pub struct Shadow(Object<sys::shd_shadow>);

impl Shadow {
    /// Makes a shadow without a map.
    pub fn new(context: &Context, desc: &ShadowDesc) -> Result<Self> {
        let raw = desc.to_raw();
        let create = |out| unsafe { sys::shd_shadow_create(context.as_raw(), &raw, out) };
        Ok(Self(Object::create(context, sys::shd_shadow_release, create)?))
    }

    /// The handle of C, borrowed from this owner.
    #[inline]
    pub fn as_raw(&self) -> *mut sys::shd_shadow {
        self.0.raw()
    }

    /// Renders the map of a light and replaces the previous one. A panic of a program continues here.
    pub fn render(
        &mut self,
        context: &Context,
        light: &Light<'_>,
        draws: &[Draw<'_>],
        desc: &ShadowRenderDesc,
    ) -> Result<()> {
        let call = Call::default();
        let (calls, raw_draws) = raw_draws(draws, &call);
        let mut raw = desc.to_raw();
        raw.light = light.as_raw();
        (raw.draws, raw.draw_count) = (raw_draws.as_ptr(), raw_draws.len());
        // All objects are borrowed for the call, and the shadow exclusively.
        let outcome = check(unsafe { sys::shd_shadow_render(context.as_raw(), self.as_raw(), &raw) });
        drop((calls, raw_draws));
        call.finish();
        outcome
    }
}
