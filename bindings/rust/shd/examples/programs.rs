// SPDX-License-Identifier: MIT
//! The three programs that every binding has (bindings/c/programs.c): a batch of lookups, a frame, and a fragment
//! program. Each prints a hash of its result.
//!
//! ```text
//! programs            prints the hashes
//! programs --speed    prints the time of a call of one lookup, and of a batch of 2^20
//! ```
use std::time::Instant;

use shd::*;

const SIZE: u32 = 64;
const LOOKUPS: usize = 16384;
const WIDTH: u32 = 320;
const HEIGHT: u32 = 200;
const BATCH: usize = 1 << 20;
const CALLS: usize = 200_000;

/// FNV-1a of 64 bits (Fowler, Noll and Vo, 1991), byte by byte.
fn hash(bytes: impl IntoIterator<Item = u8>) -> u64 {
    bytes.into_iter().fold(0xcbf29ce484222325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x100000001b3))
}

fn texture(context: &Context) -> Result<Texture<'static>> {
    let texel = |i: u32| [i % SIZE * 4, i / SIZE * 4, ((i % SIZE) ^ (i / SIZE)) * 4, 255].map(|channel| channel as u8);
    let texels: Vec<[u8; 4]> = (0..SIZE * SIZE).map(texel).collect();
    let (format, tables) = (Format::RGBA8_SRGB, Table::MIPMAP);
    Texture::new(context, &TextureDesc { format, width: SIZE, height: SIZE, tables, ..Default::default() }, &texels)
}

fn sampler(context: &Context, filter: Filter) -> Result<Sampler> {
    Sampler::new(context, &SamplerDesc { filter, max_anisotropy: 16.0, ..Default::default() })
}

fn column(count: usize, value: impl Fn(usize) -> f32) -> Vec<f32> {
    (0..count).map(value).collect()
}

/// 1. A batch of lookups: footprints of many sizes and directions, filtered with EWA.
fn look_up(context: &Context) -> Result<()> {
    let u = column(LOOKUPS, |i| (i % 128) as f32 / 64.0);
    let v = column(LOOKUPS, |i| (i / 128) as f32 / 128.0);
    let dudx = column(LOOKUPS, |i| (1 + i % 7) as f32 / 256.0);
    let dvdx = column(LOOKUPS, |i| (i % 5) as f32 / 512.0);
    let dudy = column(LOOKUPS, |i| (i % 3) as f32 / -512.0);
    let dvdy = column(LOOKUPS, |i| (1 + i % 11) as f32 / 1024.0);
    let lookups = Lookups::new(&u, &v).dudx(&dudx).dvdx(&dvdx).dudy(&dudy).dvdy(&dvdy);
    let mut out = [(); 4].map(|()| vec![0f32; LOOKUPS]);
    texture(context)?.sample(&sampler(context, Filter::EWA)?, &lookups, &mut Texels::rgba(&mut out))?;
    println!("lookup {:016x}", hash(out.iter().flatten().flat_map(|value| value.to_ne_bytes())));
    Ok(())
}

/// Renders a torus of one material in the light of the sun, with four samples a pixel, and prints the hash of its
/// pixels as RGBA8 in sRGB.
fn draw(context: &Context, name: &str, material: &Material) -> Result<()> {
    let mesh = Mesh::shape(context, &ShapeDesc { kind: Shape::TORUS, ..Default::default() }, MeshFlag::NONE)?;
    let (kind, direction) = (LightKind::DIRECTIONAL, [-0.5, -1.0, -0.25]);
    let sun = Light::new(context, &LightDesc { kind, direction, ..Default::default() })?;
    let size = FramebufferDesc { width: WIDTH, height: HEIGHT, sample_count: 4, ..Default::default() };
    let mut framebuffer = Framebuffer::new(context, &size)?;
    let camera = Camera { eye: [0.5, 1.5, 2.0], ..Default::default() };
    let frame = Frame::new().camera(camera).draw(Draw::new(&mesh, material)).light(&sun);
    frame.render(context, &mut framebuffer)?;
    let mut pixels = vec![0u8; (WIDTH * HEIGHT * 4) as usize];
    framebuffer.read_color(Format::RGBA8_SRGB, &mut pixels)?;
    println!("{name} {:016x}", hash(pixels));
    Ok(())
}

/// 2. A frame: the material has a texture.
fn draw_textured(context: &Context) -> Result<()> {
    let sampler = sampler(context, Filter::TRILINEAR)?;
    let slot = Slot::texture(SlotTarget::DIFFUSE, &texture(context)?, Some(&sampler));
    let desc = MaterialDesc { model: Model::BLINN_PHONG, ..Default::default() };
    draw(context, "frame", &Material::builder(desc).slot(slot).build(context)?)
}

/// 3. A fragment program: shows the texture coordinates.
fn draw_program(context: &Context) -> Result<()> {
    let blue = 0.25;
    let uv_as_colour = |fragments: &Fragments, out: &mut Radiance| {
        out.r.copy_from_slice(fragments.u);
        out.g.copy_from_slice(fragments.v);
        out.b.fill(blue);
    };
    let material = Material::builder(MaterialDesc::default()).fragment(uv_as_colour).build(context)?;
    draw(context, "program", &material)
}

/// Seconds of one call, the best of seven rounds.
fn measure(calls: usize, mut call: impl FnMut() -> Result<()>) -> Result<f64> {
    let mut best = f64::INFINITY;
    for _ in 0..7 {
        let start = Instant::now();
        for _ in 0..calls {
            call()?;
        }
        best = best.min(start.elapsed().as_secs_f64());
    }
    Ok(best / calls as f64)
}

fn print_speed() -> Result<()> {
    let context = Context::builder(ContextDesc { worker_count: 1, ..Default::default() }).build()?;
    let (texture, sampler) = (texture(&context)?, sampler(&context, Filter::TRILINEAR)?);
    let u = column(BATCH, |i| (i % 1024) as f32 / 1024.0);
    let v = column(BATCH, |i| (i / 1024) as f32 / 1024.0);
    let lod = column(BATCH, |i| (i % 16) as f32 / 8.0);
    let mut out = [[0f32]; 4];
    let one = Lookups::new(&u[..1], &v[..1]).lod(&lod[..1]);
    let mut texels = Texels::rgba(&mut out);
    let seconds = measure(CALLS, || texture.sample(&sampler, &one, &mut texels))?;
    println!("call {:.2} ns", 1e9 * seconds);
    let all = Lookups::new(&u, &v).lod(&lod);
    let mut out = [(); 4].map(|()| vec![0f32; BATCH]);
    let mut texels = Texels::rgba(&mut out);
    let seconds = measure(3, || texture.sample(&sampler, &all, &mut texels))?;
    println!("batch {:.4} ms", 1e3 * seconds);
    Ok(())
}

fn main() -> Result<()> {
    if std::env::args().nth(1).as_deref() == Some("--speed") {
        return print_speed();
    }
    let context = Context::new()?;
    look_up(&context)?;
    draw_textured(&context)?;
    draw_program(&context)
}
