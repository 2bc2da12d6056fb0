// SPDX-License-Identifier: MIT
//! Programs: closures that read and write columns of fragments and vertices.
use std::any::Any;
use std::ffi::c_void;
use std::panic::{self, AssertUnwindSafe};
use std::slice;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use crate::error::Panic;
use crate::sys;

/// Values of a draw for the programs of its material; see [`crate::Draw::uniforms`].
pub(crate) type Uniforms<'a> = &'a (dyn Any + Sync);
pub(crate) type FragmentFn<'a> = dyn Fn(&Fragments<'_>, &mut Radiance<'_>) + Send + Sync + 'a;
pub(crate) type VertexFn<'a> = dyn Fn(&Vertices<'_>, &mut VertexOutputs<'_>) + Send + Sync + 'a;
pub(crate) type ProcedureFn<'a> = dyn Fn(&Fragments<'_>, &mut SlotValues<'_>) + Send + Sync + 'a;

/// Panics of programs, on their way from workers to the call that runs the frame.
#[derive(Default)]
pub(crate) struct Call {
    panicked: AtomicBool,
    panics: Mutex<Vec<Panic>>,
}

impl Call {
    /// Runs a closure of the host. Its panic stays here, and later closures of the call are skipped.
    pub(crate) fn run(&self, body: impl FnOnce()) {
        if self.has_panicked() {
            return;
        }
        if let Err(panic) = panic::catch_unwind(AssertUnwindSafe(body)) {
            // All are kept, because the value of a panic may panic when it is dropped.
            self.panics.lock().unwrap_or_else(PoisonError::into_inner).push(panic);
            self.panicked.store(true, Ordering::Release);
        }
    }

    pub(crate) fn has_panicked(&self) -> bool {
        self.panicked.load(Ordering::Acquire)
    }

    /// Continues the first panic after the call of the library has returned.
    pub(crate) fn finish(self) {
        let mut panics = self.panics.into_inner().unwrap_or_else(PoisonError::into_inner);
        panics.truncate(1);
        if let Some(panic) = panics.pop() {
            panic::resume_unwind(panic);
        }
    }
}

/// The `uniforms` pointer of every draw that this crate passes to the library.
pub(crate) struct DrawCall<'c> {
    pub(crate) call: &'c Call,
    pub(crate) uniforms: Option<Uniforms<'c>>,
}

/// The draw of a program. Draws that this crate did not make have no place for a panic, which then ends the process.
unsafe fn run_in(uniforms: *const c_void, body: impl FnOnce(Option<Uniforms<'_>>)) {
    match unsafe { (uniforms as *const DrawCall<'_>).as_ref() } {
        Some(draw) => draw.call.run(|| body(draw.uniforms)),
        None => {
            if panic::catch_unwind(AssertUnwindSafe(|| body(None))).is_err() {
                std::process::abort();
            }
        }
    }
}

/// A column that the library lends; empty if it is absent.
unsafe fn column<'a, T>(data: *const T, count: usize) -> &'a [T] {
    if data.is_null() {
        return &[];
    }
    unsafe { slice::from_raw_parts(data, count) }
}

unsafe fn column_mut<'a, T>(data: *mut T, count: usize) -> &'a mut [T] {
    if data.is_null() {
        return &mut [];
    }
    unsafe { slice::from_raw_parts_mut(data, count) }
}

macro_rules! inputs {
    ($(#[$doc:meta])* $name:ident from $raw:ident { $($(#[$field_doc:meta])* $field:ident: $type:ty,)* }) => {
        $(#[$doc])*
        #[non_exhaustive]
        pub struct $name<'a> {
            /// Number of rows.
            pub count: usize,
            /// Index of the draw in its frame.
            pub draw: usize,
            /// Index of the instance in its draw.
            pub instance: usize,
            $($(#[$field_doc])* pub $field: &'a [$type],)*
            raw: &'a sys::$raw,
            uniforms: Option<Uniforms<'a>>,
        }

        impl<'a> $name<'a> {
            unsafe fn new(raw: &'a sys::$raw, uniforms: Option<Uniforms<'a>>) -> Self {
                let count = raw.count;
                Self {
                    count,
                    draw: raw.draw as usize,
                    instance: raw.instance as usize,
                    $($field: unsafe { column(raw.$field, count) },)*
                    raw,
                    uniforms,
                }
            }

            /// A column of [`crate::MeshDesc::attributes`]; empty if the mesh has none.
            pub fn attribute(&self, index: usize) -> &'a [f32] {
                let data = unsafe { column(self.raw.attribute, self.raw.attribute_count) };
                data.get(index).map_or(&[], |&data| unsafe { column(data, self.count) })
            }

            /// The value of [`crate::Draw::uniforms`], if it has this type.
            pub fn uniforms<T: Any + Sync>(&self) -> Option<&'a T> {
                let uniforms: &'a dyn Any = self.uniforms?;
                uniforms.downcast_ref()
            }
        }
    };
}

inputs! {
    /// Points to shade, one row each, in columns of `count` elements.
    Fragments from shd_fragments {
        /// Raster position, pixels from the left edge.
        x: f32,
        /// Raster position, pixels from the top edge.
        y: f32,
        /// Depth, 0 near .. 1 far.
        depth: f32,
        /// Index of the triangle in its mesh.
        triangle: u32,
        /// Position x, world space.
        px: f32,
        /// Position y, world space.
        py: f32,
        /// Position z, world space.
        pz: f32,
        /// Shading normal x, world space, unit.
        nx: f32,
        /// Shading normal y, world space, unit.
        ny: f32,
        /// Shading normal z, world space, unit.
        nz: f32,
        /// wo x: towards the eye, world space, unit.
        ox: f32,
        /// wo y: towards the eye, world space, unit.
        oy: f32,
        /// wo z: towards the eye, world space, unit.
        oz: f32,
        /// Tangent x, world space.
        tx: f32,
        /// Tangent y, world space.
        ty: f32,
        /// Tangent z, world space.
        tz: f32,
        /// Handedness of the tangent.
        tw: f32,
        /// Texture coordinate u.
        u: f32,
        /// Texture coordinate v.
        v: f32,
        /// u of the second set.
        u1: f32,
        /// v of the second set.
        v1: f32,
        /// du/dx per pixel.
        dudx: f32,
        /// dv/dx per pixel.
        dvdx: f32,
        /// du/dy per pixel.
        dudy: f32,
        /// dv/dy per pixel.
        dvdy: f32,
    }
}

impl<'a> Fragments<'a> {
    /// A varying of the vertex program, interpolated; empty if there is none with this index.
    pub fn varying(&self, index: usize) -> &'a [f32] {
        let data = unsafe { column(self.raw.varying, self.raw.varying_count) };
        data.get(index).map_or(&[], |&data| unsafe { column(data, self.count) })
    }
}

inputs! {
    /// Vertices of one draw, one row each, in columns of `count` elements. Columns that the mesh lacks are empty.
    Vertices from shd_vertices {
        /// Position x, object space.
        px: f32,
        /// Position y, object space.
        py: f32,
        /// Position z, object space.
        pz: f32,
        /// Normal x, object space, unit.
        nx: f32,
        /// Normal y, object space, unit.
        ny: f32,
        /// Normal z, object space, unit.
        nz: f32,
        /// Tangent x, object space.
        tx: f32,
        /// Tangent y, object space.
        ty: f32,
        /// Tangent z, object space.
        tz: f32,
        /// Handedness of the tangent.
        tw: f32,
        /// Texture coordinate u.
        u: f32,
        /// Texture coordinate v.
        v: f32,
        /// u of the second set.
        u1: f32,
        /// v of the second set.
        v1: f32,
    }
}

impl<'a> Vertices<'a> {
    /// Row i is vertex `first() + i` of the mesh.
    pub fn first(&self) -> usize {
        self.raw.first as usize
    }

    /// Column-major matrix of the instance.
    pub fn object_to_world(&self) -> &'a [f32] {
        unsafe { column(self.raw.object_to_world, 16) }
    }

    /// Column-major matrix of the view.
    pub fn world_to_view(&self) -> &'a [f32] {
        unsafe { column(self.raw.world_to_view, 16) }
    }

    /// Column-major projection.
    pub fn view_to_clip(&self) -> &'a [f32] {
        unsafe { column(self.raw.view_to_clip, 16) }
    }

    /// The eye in world space.
    pub fn eye(&self) -> &'a [f32] {
        unsafe { column(self.raw.eye, 3) }
    }
}

/// Output of a fragment program: scene-linear, premultiplied by `a`. r, g, b start as 0 and `a` as 1.
#[non_exhaustive]
pub struct Radiance<'a> {
    pub r: &'a mut [f32],
    pub g: &'a mut [f32],
    pub b: &'a mut [f32],
    pub a: &'a mut [f32],
    /// Starts as 0; any other value drops the row. Empty without `MaterialFlag::DISCARDS`.
    pub discard: &'a mut [u32],
    /// r, g, b, a of the targets 1, 2 and 3, which start as 0. Empty for targets that the framebuffer lacks.
    pub target: [[&'a mut [f32]; 4]; 3],
}

/// Output of a procedure of a slot.
#[non_exhaustive]
pub struct SlotValues<'a> {
    /// Columns that start as 1: three for colours, four for the diffuse slot and for normals, one for scalars. The
    /// other columns are empty.
    pub channel: [&'a mut [f32]; 4],
}

/// Values that a vertex program may change. Each column starts with the values that the draw has without a program.
#[non_exhaustive]
pub struct VertexOutputs<'a> {
    /// Clip space x.
    pub x: &'a mut [f32],
    /// Clip space y.
    pub y: &'a mut [f32],
    /// Clip space z.
    pub z: &'a mut [f32],
    /// Clip space w.
    pub w: &'a mut [f32],
    /// Position x, world space.
    pub px: &'a mut [f32],
    /// Position y, world space.
    pub py: &'a mut [f32],
    /// Position z, world space.
    pub pz: &'a mut [f32],
    /// Normal x, world space.
    pub nx: &'a mut [f32],
    /// Normal y, world space.
    pub ny: &'a mut [f32],
    /// Normal z, world space.
    pub nz: &'a mut [f32],
    /// Texture coordinate u.
    pub u: &'a mut [f32],
    /// Texture coordinate v.
    pub v: &'a mut [f32],
    /// Columns that start as 0, one for each varying of the material.
    pub varying: Vec<&'a mut [f32]>,
}

/// The closures of a material. The library has a pointer to them until the material is released.
#[derive(Default)]
pub(crate) struct Programs<'a> {
    pub(crate) fragment: Option<Box<FragmentFn<'a>>>,
    pub(crate) vertex: Option<Box<VertexFn<'a>>>,
    /// Each is behind a pointer of its own, which is the user_data of a slot.
    pub(crate) procedures: Vec<Arc<Box<ProcedureFn<'a>>>>,
}

pub(crate) unsafe extern "C" fn fragment(
    fragments: *const sys::shd_fragments,
    out: *mut sys::shd_radiance,
    user_data: *mut c_void,
) {
    // The library passes the user_data of the material, and columns of `count` elements that do not overlap.
    let (raw, out, programs) = unsafe { (&*fragments, &*out, &*(user_data as *const Programs<'_>)) };
    let count = raw.count;
    let run = |uniforms: Option<Uniforms<'_>>| {
        if let Some(program) = &programs.fragment {
            let targets = unsafe { column(out.target, out.target_count) };
            let plane = |target: usize, channel: usize| match targets.get(target) {
                Some(planes) => unsafe { column_mut(planes[channel], count) },
                None => &mut [],
            };
            let mut radiance = unsafe {
                Radiance {
                    r: column_mut(out.r, count),
                    g: column_mut(out.g, count),
                    b: column_mut(out.b, count),
                    a: column_mut(out.a, count),
                    discard: column_mut(out.discard, count),
                    target: std::array::from_fn(|target| std::array::from_fn(|channel| plane(target, channel))),
                }
            };
            program(&unsafe { Fragments::new(raw, uniforms) }, &mut radiance);
        }
    };
    unsafe { run_in(raw.uniforms, run) }
}

pub(crate) unsafe extern "C" fn vertex(
    vertices: *const sys::shd_vertices,
    out: *mut sys::shd_vertex_outputs,
    user_data: *mut c_void,
) {
    // As in fragment().
    let (raw, out, programs) = unsafe { (&*vertices, &*out, &*(user_data as *const Programs<'_>)) };
    let count = raw.count;
    let run = |uniforms: Option<Uniforms<'_>>| {
        if let Some(program) = &programs.vertex {
            let lend = |data: *mut f32| unsafe { column_mut(data, count) };
            let varyings = unsafe { column(out.varying, out.varying_count) };
            let mut outputs = VertexOutputs {
                x: lend(out.x),
                y: lend(out.y),
                z: lend(out.z),
                w: lend(out.w),
                px: lend(out.px),
                py: lend(out.py),
                pz: lend(out.pz),
                nx: lend(out.nx),
                ny: lend(out.ny),
                nz: lend(out.nz),
                u: lend(out.u),
                v: lend(out.v),
                varying: varyings.iter().map(|&data| lend(data)).collect(),
            };
            program(&unsafe { Vertices::new(raw, uniforms) }, &mut outputs);
        }
    };
    unsafe { run_in(raw.uniforms, run) }
}

pub(crate) unsafe extern "C" fn procedure(
    fragments: *const sys::shd_fragments,
    out: *const *mut f32,
    user_data: *mut c_void,
) {
    // As in fragment(); the user_data is that of the slot.
    let (raw, program) = unsafe { (&*fragments, &*(user_data as *const Box<ProcedureFn<'_>>)) };
    let run = |uniforms: Option<Uniforms<'_>>| {
        let channel = std::array::from_fn(|c| unsafe { column_mut(*out.add(c), raw.count) });
        program(&unsafe { Fragments::new(raw, uniforms) }, &mut SlotValues { channel });
    };
    unsafe { run_in(raw.uniforms, run) }
}
