// SPDX-License-Identifier: MIT
//! Materials and their slots.
use std::fmt;
use std::ptr;
use std::sync::Arc;

use crate::object::Object;
use crate::program::{self, ProcedureFn, Programs};
use crate::{
    sys, Context, Fragments, Interpolation, MaterialDesc, Model, Radiance, Result, Sampler, SlotDesc, SlotSource,
    SlotTarget, SlotValues, SolidDesc, Texture, VertexOutputs, Vertices,
};

enum Source<'a> {
    Constant,
    Texture(Texture<'a>, Option<Sampler>),
    Vertex(u32),
    Procedure(Box<ProcedureFn<'a>>),
    Solid(Box<SolidDesc>),
}

/// A source for a coefficient of a material.
pub struct Slot<'a> {
    target: SlotTarget,
    desc: SlotDesc,
    source: Source<'a>,
}

impl<'a> Slot<'a> {
    fn new(target: SlotTarget, source: Source<'a>) -> Self {
        Self { target, desc: SlotDesc::default(), source }
    }

    /// A constant: 1, or the normal of the surface.
    pub fn constant(target: SlotTarget) -> Self {
        Self::new(target, Source::Constant)
    }

    /// Values of a texture.
    pub fn texture(target: SlotTarget, texture: &Texture<'a>, sampler: Option<&Sampler>) -> Self {
        Self::new(target, Source::Texture(texture.clone(), sampler.cloned()))
    }

    /// Columns of the mesh, from [`crate::MeshDesc::attributes`] `attribute` on.
    pub fn vertex(target: SlotTarget, attribute: u32) -> Self {
        Self::new(target, Source::Vertex(attribute))
    }

    /// Values of a closure. It runs on the library's workers, also concurrently, and may look textures up.
    pub fn procedure(
        target: SlotTarget,
        procedure: impl Fn(&Fragments<'_>, &mut SlotValues<'_>) + Send + Sync + 'a,
    ) -> Self {
        Self::new(target, Source::Procedure(Box::new(procedure)))
    }

    /// A solid texture.
    pub fn solid(target: SlotTarget, solid: &SolidDesc) -> Self {
        Self::new(target, Source::Solid(Box::new(*solid)))
    }

    /// Channel, set of texture coordinates and transforms.
    pub fn desc(mut self, desc: SlotDesc) -> Self {
        self.desc = desc;
        self
    }
}

struct Inner<'a> {
    object: Object<sys::shd_material>,
    // Dropped after the material, which has pointers to them.
    _programs: Arc<Programs<'a>>,
    textures: Vec<(Texture<'a>, Option<Sampler>)>,
}

/// Reflectance of a surface. A material never changes; a clone is another owner of the same material.
///
/// The lifetime is that of borrowed texels of its textures, and of what its programs borrow:
/// ```compile_fail,E0597
/// # use shd::*;
/// # let context = Context::new().unwrap();
/// let material = {
///     let blue = 0.25;
///     Material::builder(MaterialDesc::default()).fragment(|_, out| out.b.fill(blue)).build(&context).unwrap()
/// }; // `blue` does not live long enough
/// drop(material);
/// ```
///
/// A program runs on several threads, so it cannot use what belongs to one thread:
/// ```compile_fail,E0277
/// # use shd::*;
/// let count = std::cell::Cell::new(0);
/// Material::builder(MaterialDesc::default()).fragment(|_, _| count.set(count.get() + 1)); // `Cell` is not Sync
/// ```
#[derive(Clone)]
pub struct Material<'a>(Arc<Inner<'a>>);

impl fmt::Debug for Material<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Material({:?})", self.as_raw())
    }
}

impl Material<'static> {
    /// Makes a material without slots and programs.
    pub fn new(context: &Context, desc: &MaterialDesc) -> Result<Self> {
        Self::builder(*desc).build(context)
    }

    /// A material without programs, which keeps its textures itself.
    #[cfg(feature = "scene")]
    pub(crate) fn of(object: Object<sys::shd_material>) -> Self {
        Self(Arc::new(Inner { object, _programs: Arc::default(), textures: Vec::new() }))
    }
}

impl<'a> Material<'a> {
    /// Begins a material with slots or programs.
    pub fn builder(desc: MaterialDesc) -> MaterialBuilder<'a> {
        let (slots, programs) = (Vec::new(), Programs::default());
        MaterialBuilder { desc, slots, programs, interpolation: Vec::new() }
    }

    /// The handle of C, borrowed from this owner.
    #[inline]
    pub fn as_raw(&self) -> *mut sys::shd_material {
        self.0.object.raw()
    }

    /// Continues the panic of a closure that loaded tiles of its textures.
    pub(crate) fn resume_panic(&self) {
        self.0.textures.iter().for_each(|(texture, _)| texture.resume_panic());
    }
}

/// A material to be made; see [`Material::builder`].
pub struct MaterialBuilder<'a> {
    desc: MaterialDesc,
    slots: Vec<Slot<'a>>,
    programs: Programs<'a>,
    interpolation: Vec<Interpolation>,
}

impl<'a> MaterialBuilder<'a> {
    /// Adds the source of a coefficient.
    pub fn slot(mut self, slot: Slot<'a>) -> Self {
        self.slots.push(slot);
        self
    }

    /// Shades by a closure instead of a reflectance model. It runs on the library's workers, also concurrently, and may
    /// look textures up. If it panics, the call that draws the frame panics.
    pub fn fragment(
        mut self,
        fragment: impl Fn(&Fragments<'_>, &mut Radiance<'_>) + Send + Sync + 'a,
    ) -> MaterialBuilder<'a> {
        self.desc.model = Model::PROGRAM;
        self.programs.fragment = Some(Box::new(fragment));
        self
    }

    /// Changes vertices by a closure, which runs as a fragment program does. Each row must depend on its own inputs
    /// alone.
    pub fn vertex(mut self, vertex: impl Fn(&Vertices<'_>, &mut VertexOutputs<'_>) + Send + Sync + 'a) -> Self {
        self.programs.vertex = Some(Box::new(vertex));
        self
    }

    /// The interpolation of each varying of the vertex program.
    pub fn varyings(mut self, interpolation: &[Interpolation]) -> Self {
        self.interpolation = interpolation.to_vec();
        self
    }

    /// Makes the material.
    pub fn build(mut self, context: &Context) -> Result<Material<'a>> {
        let mut textures = Vec::new();
        let mut solids = Vec::new();
        let mut slots = Vec::with_capacity(self.slots.len());
        for slot in std::mem::take(&mut self.slots) {
            let mut raw = slot.desc.to_raw();
            raw.target = slot.target;
            match slot.source {
                Source::Constant => {}
                Source::Texture(texture, sampler) => {
                    raw.source = SlotSource::TEXTURE;
                    raw.texture = texture.as_raw();
                    raw.sampler = sampler.as_ref().map_or(ptr::null_mut(), Sampler::as_raw);
                    textures.push((texture, sampler));
                }
                Source::Vertex(attribute) => {
                    raw.source = SlotSource::VERTEX;
                    raw.attribute = attribute;
                }
                Source::Procedure(procedure) => {
                    raw.source = SlotSource::PROCEDURE;
                    raw.procedure = Some(program::procedure);
                    self.programs.procedures.push(Arc::new(procedure));
                    raw.user_data = self.programs.procedures.last().map_or(ptr::null(), Arc::as_ptr) as *mut _;
                }
                Source::Solid(solid) => {
                    raw.source = SlotSource::SOLID;
                    solids.push(Arc::new(solid.to_raw()));
                    raw.solid = solids.last().map_or(ptr::null(), Arc::as_ptr);
                }
            }
            slots.push(raw);
        }
        self.create(context, &slots, textures)
    }

    /// The texture's and the solid textures' pointers in `slots` are valid during this call.
    fn create(
        self,
        context: &Context,
        slots: &[sys::shd_slot],
        textures: Vec<(Texture<'a>, Option<Sampler>)>,
    ) -> Result<Material<'a>> {
        let mut raw = self.desc.to_raw();
        raw.slots = slots.as_ptr();
        raw.slot_count = slots.len();
        raw.interpolation = self.interpolation.as_ptr();
        raw.varying_count = self.interpolation.len();
        let programs = Arc::new(self.programs);
        if programs.fragment.is_some() {
            raw.program.fragment = Some(program::fragment);
        }
        if programs.vertex.is_some() {
            raw.program.vertex = Some(program::vertex);
        }
        raw.program.user_data = Arc::as_ptr(&programs) as *mut _;
        let create = |out| unsafe { sys::shd_material_create(context.as_raw(), &raw, out) };
        let object = Object::create(context, sys::shd_material_release, create)?;
        Ok(Material(Arc::new(Inner { object, _programs: programs, textures })))
    }
}
