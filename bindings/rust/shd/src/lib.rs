// SPDX-License-Identifier: MIT
//! Texture filtering, shading and software rasterisation on the CPU, by libshd.
//!
//! ```
//! use shd::*;
//!
//! let context = Context::new()?;
//! let mesh = Mesh::shape(&context, &ShapeDesc { kind: Shape::TORUS, ..Default::default() }, MeshFlag::NONE)?;
//! let material = Material::builder(MaterialDesc::default())
//!     .fragment(|fragments, out| {
//!         out.r.copy_from_slice(fragments.u);
//!         out.g.copy_from_slice(fragments.v);
//!     })
//!     .build(&context)?;
//! let size = FramebufferDesc { width: 64, height: 64, ..Default::default() };
//! let mut framebuffer = Framebuffer::new(&context, &size)?;
//! let camera = Camera { eye: [0.0, 2.0, 2.0], ..Default::default() };
//! let frame = Frame::new().camera(camera).draw(Draw::new(&mesh, &material));
//! frame.render(&context, &mut framebuffer)?;
//! let mut pixels = vec![[0u8; 4]; 64 * 64];
//! framebuffer.read_color(Format::RGBA8_SRGB, &mut pixels)?;
//! # assert!(pixels.iter().any(|pixel| pixel[0] > 0));
//! # Ok::<(), Error>(())
//! ```
//!
//! - **Descs** are structs with the fields of C and its defaults: `SamplerDesc { filter: Filter::EWA,
//!   ..Default::default() }`.
//! - **Owners.** A clone of an object is another owner of the same object. The last owner frees it. An object keeps
//!   what it needs: a material its textures, and every object its context.
//! - **Borrows.** Columns, borrowed texels, views of planes and what programs borrow have lifetimes.
//! - **Threads.** Every type is `Send` and `Sync`. What changes an object takes `&mut self`: [`Frame::render`] its
//!   framebuffer, [`Texture::update`] its texture. All else may run concurrently.
//! - **Errors** have the result code and the text of the library. [`Result`] takes another type of errors, too. A panic
//!   of a closure continues in the call that ran the closure.
//!
//! The features `io`, `scene` and `color` add files, models and colour transforms, of installed component libraries.
//!
//! [`sys`] has the C API for what this crate lacks; `as_raw()` gives the handle of an object.
#![deny(unsafe_op_in_unsafe_fn)]

#[cfg(feature = "color")]
mod color;
mod column;
mod context;
#[rustfmt::skip]
#[allow(clippy::doc_lazy_continuation, clippy::field_reassign_with_default)]
mod descs;
mod environment;
mod error;
mod framebuffer;
#[cfg(feature = "io")]
mod io;
mod light;
mod lookup;
mod material;
mod mesh;
mod object;
mod pixels;
mod program;
mod render;
mod sampler;
#[cfg(feature = "scene")]
mod scene;
mod shadow;
mod texture;
mod tile;
mod tile_cache;

pub use shd_sys as sys;

#[cfg(feature = "color")]
pub use color::Color;
pub use column::{Column, ColumnMut, Scalar};
pub use context::{Context, ContextBuilder, Executor, Tasks};
pub use descs::*;
pub use environment::Environment;
pub use error::{Error, Result};
pub use framebuffer::{Framebuffer, PlaneView};
#[cfg(feature = "io")]
pub use io::{TextureFile, TextureLoader};
pub use light::Light;
pub use lookup::{Lookups, Texels};
pub use material::{Material, MaterialBuilder, Slot};
pub use mesh::{Indices, Mesh, MeshDesc};
pub use pixels::Plain;
pub use program::{Fragments, Radiance, SlotValues, VertexOutputs, Vertices};
pub use render::{Draw, Frame};
pub use sampler::Sampler;
#[cfg(feature = "scene")]
pub use scene::{Found, Scene, SceneLoader};
pub use shadow::Shadow;
pub use texture::{Texture, TEXTURE_PADDING};
pub use tile::Tile;
pub use tile_cache::{Loaded, TextureTile, TileCache};

/// Version of the library that is running: major, minor and patch.
pub fn version() -> (u32, u32, u32) {
    let version = unsafe { sys::shd_version() };
    (version >> 16, version >> 8 & 0xff, version & 0xff)
}
