// SPDX-License-Identifier: MIT
//! Frames.
use std::any::Any;
use std::ffi::c_void;
use std::fmt;
use std::ops::ControlFlow;
use std::ptr;

use crate::error::check;
use crate::program::{Call, DrawCall};
use crate::tile::{self, TileCall, TileFn};
use crate::{
    sys, Camera, Context, DrawDesc, Environment, Error, Framebuffer, Light, Material, Mesh, Region, RenderDesc,
    RenderStats, Result, ResultCode, Shadow, Tile,
};

/// One mesh in a frame.
#[derive(Clone, Copy)]
pub struct Draw<'a> {
    /// Matrix, culling, depth test and so on.
    pub desc: DrawDesc,
    mesh: &'a Mesh,
    material: Option<&'a Material<'a>>,
    instances: &'a [[f32; 16]],
    uniforms: Option<&'a (dyn Any + Sync)>,
}

impl fmt::Debug for Draw<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Draw({:?}, {:?}, {} instances)", self.mesh, self.material, self.instances.len())
    }
}

impl<'a> Draw<'a> {
    /// A mesh with a material, and the defaults of [`DrawDesc`].
    pub fn new(mesh: &'a Mesh, material: &'a Material<'a>) -> Self {
        Self { material: Some(material), ..Self::depth_only(mesh) }
    }

    /// A mesh that writes depth alone.
    pub fn depth_only(mesh: &'a Mesh) -> Self {
        Self { desc: DrawDesc::default(), mesh, material: None, instances: &[], uniforms: None }
    }

    /// Replaces the options.
    pub fn desc(mut self, desc: DrawDesc) -> Self {
        self.desc = desc;
        self
    }

    /// Places the mesh by a column-major matrix.
    pub fn at(mut self, object_to_world: [f32; 16]) -> Self {
        self.desc.object_to_world = object_to_world;
        self
    }

    /// Draws the mesh once for each of these column-major matrices. No matrices mean one draw by its own matrix.
    pub fn instances(mut self, object_to_world: &'a [[f32; 16]]) -> Self {
        self.instances = object_to_world;
        self
    }

    /// A value for the programs of the material, which read it by [`crate::Fragments::uniforms`].
    pub fn uniforms(mut self, uniforms: &'a (dyn Any + Sync)) -> Self {
        self.uniforms = Some(uniforms);
        self
    }

    fn to_raw(self, call: &DrawCall<'_>) -> sys::shd_draw {
        let mut raw = self.desc.to_raw();
        raw.mesh = self.mesh.as_raw();
        raw.material = self.material.map_or(ptr::null(), |material| material.as_raw());
        raw.uniforms = (call as *const DrawCall<'_>).cast();
        raw.instances = self.instances.as_ptr().cast();
        raw.instance_count = self.instances.len();
        raw
    }
}

/// The draws of a call in the form of C. The second vector points into the first one.
pub(crate) fn raw_draws<'c>(draws: &[Draw<'c>], call: &'c Call) -> (Vec<DrawCall<'c>>, Vec<sys::shd_draw>) {
    let calls: Vec<_> = draws.iter().map(|draw| DrawCall { call, uniforms: draw.uniforms }).collect();
    let raw = draws.iter().zip(&calls).map(|(draw, call)| draw.to_raw(call)).collect();
    (calls, raw)
}

type Progress<'a> = dyn Fn(f32) -> ControlFlow<()> + Send + Sync + 'a;

/// Everything that a picture shows. It borrows its objects and can be rendered several times.
#[derive(Default)]
pub struct Frame<'a> {
    /// Background, size of the picture, supersampling and so on.
    pub desc: RenderDesc,
    draws: Vec<Draw<'a>>,
    lights: Vec<(&'a Light<'a>, Option<&'a Shadow>)>,
    environment: Option<&'a Environment>,
    camera: Option<Camera>,
    viewport: Option<Region>,
    scissor: Option<Region>,
    progress: Option<Box<Progress<'a>>>,
    tiles: Option<Box<TileFn<'a>>>,
}

impl<'a> Frame<'a> {
    /// An empty picture.
    pub fn new() -> Self {
        Self::default()
    }

    /// Replaces the options.
    pub fn desc(mut self, desc: RenderDesc) -> Self {
        self.desc = desc;
        self
    }

    /// Looks through a camera instead of [`RenderDesc::view`].
    pub fn camera(mut self, camera: Camera) -> Self {
        self.camera = Some(camera);
        self
    }

    /// Adds a draw. Draws take effect in their order.
    pub fn draw(mut self, draw: Draw<'a>) -> Self {
        self.draws.push(draw);
        self
    }

    /// Adds a light.
    pub fn light(mut self, light: &'a Light<'a>) -> Self {
        self.lights.push((light, None));
        self
    }

    /// Adds a light with the shadows that were rendered for it.
    pub fn light_with_shadow(mut self, light: &'a Light<'a>, shadow: &'a Shadow) -> Self {
        self.lights.push((light, Some(shadow)));
        self
    }

    /// Adds light from all directions.
    pub fn environment(mut self, environment: &'a Environment) -> Self {
        self.environment = Some(environment);
        self
    }

    /// The part of the picture that NDC -1..1 fills.
    pub fn viewport(mut self, viewport: Region) -> Self {
        self.viewport = Some(viewport);
        self
    }

    /// The pixels of the picture that may change.
    pub fn scissor(mut self, scissor: Region) -> Self {
        self.scissor = Some(scissor);
        self
    }

    /// Calls a closure with the finished part of the frame, (0, 1], on any worker, never concurrently. `Break` cancels
    /// the frame, which then fails with `ERROR_CANCELLED`. If it panics, [`Frame::render`] panics.
    pub fn progress(mut self, progress: impl Fn(f32) -> ControlFlow<()> + Send + Sync + 'a) -> Self {
        self.progress = Some(Box::new(progress));
        self
    }

    /// Calls a closure with each tile of the framebuffer as soon as it is finished. The closure runs on any worker, also
    /// concurrently for different tiles. If it panics, [`Frame::render`] panics.
    pub fn tiles(mut self, tiles: impl Fn(&Tile<'_>) + Send + Sync + 'a) -> Self {
        self.tiles = Some(Box::new(tiles));
        self
    }

    /// Renders the frame and returns its statistics. The context's executor does the work.
    ///
    /// A panic of a program, the progress closure or an executor continues here, after the library has returned. The
    /// framebuffer then holds a part of the frame.
    pub fn render(&self, context: &Context, framebuffer: &mut Framebuffer) -> Result<RenderStats> {
        let call = Call::default();
        let (calls, draws) = raw_draws(&self.draws, &call);
        let lights: Vec<*const sys::shd_light> =
            self.lights.iter().map(|(light, _)| light.as_raw() as *const _).collect();
        let shadow = |shadow: &Option<&Shadow>| shadow.map_or(ptr::null(), |shadow| shadow.as_raw() as *const _);
        let shadows: Vec<*const sys::shd_shadow> = self.lights.iter().map(|(_, it)| shadow(it)).collect();
        let camera = self.camera.map(|camera| camera.to_raw());
        let (viewport, scissor) = (self.viewport.map(Region::to_raw), self.scissor.map(Region::to_raw));
        let mut stats = sys::shd_render_stats::default();
        let progress = ProgressCall { call: &call, report: self.progress.as_deref() };
        let tiles = TileCall { call: &call, show: self.tiles.as_deref() };

        let mut raw = self.desc.to_raw();
        raw.framebuffer = framebuffer.as_raw();
        (raw.draws, raw.draw_count) = (draws.as_ptr(), draws.len());
        (raw.lights, raw.light_count) = (lights.as_ptr(), lights.len());
        raw.shadows = shadows.as_ptr();
        raw.environment = self.environment.map_or(ptr::null(), |environment| environment.as_raw());
        raw.camera = camera.as_ref().map_or(ptr::null(), |camera| camera);
        raw.viewport = viewport.as_ref().map_or(ptr::null(), |region| region);
        raw.scissor = scissor.as_ref().map_or(ptr::null(), |region| region);
        raw.stats = &mut stats;
        if self.progress.is_some() {
            let user_data = &progress as *const ProgressCall<'_> as *mut c_void;
            raw.progress = sys::shd_progress { report: Some(report), user_data };
        }
        if self.tiles.is_some() {
            let user_data = &tiles as *const TileCall<'_> as *mut c_void;
            raw.present = sys::shd_present { tile: Some(tile::tile), user_data };
        }
        // All objects are borrowed for the call, and the framebuffer exclusively.
        let result = unsafe { sys::shd_render(context.as_raw(), &raw) };
        let outcome = check(result);
        drop((calls, draws));
        call.finish();
        if result == ResultCode::ERROR_CALLBACK {
            self.draws.iter().filter_map(|draw| draw.material).for_each(Material::resume_panic);
        }
        outcome.map(|()| RenderStats::from_raw(&stats))
    }
}

impl fmt::Debug for Frame<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Frame({:?}, {} lights)", self.draws, self.lights.len())
    }
}

struct ProgressCall<'c> {
    call: &'c Call,
    report: Option<&'c Progress<'c>>,
}

unsafe extern "C" fn report(fraction: f32, user_data: *mut c_void) -> ResultCode {
    // The library passes the user_data of the frame during the call alone.
    let progress = unsafe { &*(user_data as *const ProgressCall<'_>) };
    let mut flow = ControlFlow::Continue(());
    if let Some(report) = progress.report {
        progress.call.run(|| flow = report(fraction));
    }
    match flow {
        _ if progress.call.has_panicked() => ResultCode::ERROR_CALLBACK,
        ControlFlow::Break(()) => ResultCode::ERROR_CANCELLED,
        ControlFlow::Continue(()) => ResultCode::OK,
    }
}

/// A camera's matrices, for an aspect of 1 if the camera has none.
impl TryFrom<&Camera> for crate::View {
    type Error = Error;

    fn try_from(camera: &Camera) -> Result<Self> {
        let mut view = sys::shd_view::default();
        check(unsafe { sys::shd_view_from_camera(&camera.to_raw(), &mut view) })?;
        Ok(Self::from_raw(&view))
    }
}
