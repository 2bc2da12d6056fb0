// SPDX-License-Identifier: MIT
//! Renders a teapot with a texture of tiles and writes it as a PPM file: `teapot picture.ppm`.
use std::error::Error;
use std::fs::File;
use std::io::{BufWriter, Write};

use shd::*;

const WIDTH: u32 = 640;
const HEIGHT: u32 = 480;
const SIDE: u32 = 128;

/// Two by two tiles with joints between them, in the colours of the sRGB curve.
fn tile(i: u32) -> [u8; 4] {
    let (x, y) = (i % SIDE, i / SIDE);
    let half = SIDE / 2;
    match (x % half < 4 || y % half < 4, x / half == y / half) {
        (true, _) => [235, 228, 210, 255],
        (false, true) => [178, 64, 48, 255],
        (false, false) => [58, 92, 140, 255],
    }
}

fn tiles(context: &Context) -> Result<Texture<'static>> {
    let texels: Vec<[u8; 4]> = (0..SIDE * SIDE).map(tile).collect();
    let desc = TextureDesc {
        format: Format::RGBA8_SRGB,
        width: SIDE,
        height: SIDE,
        tables: Table::MIPMAP,
        ..Default::default()
    };
    Texture::new(context, &desc, &texels)
}

/// The picture as rows of RGB in sRGB.
fn render(context: &Context) -> Result<Vec<u8>> {
    let texture = tiles(context)?;
    let filter = SamplerDesc { filter: Filter::ANISOTROPIC, max_anisotropy: 16.0, ..Default::default() };
    let sampler = Sampler::new(context, &filter)?;
    let shape = ShapeDesc { kind: Shape::TEAPOT, ..Default::default() };
    let teapot = Mesh::shape(context, &shape, MeshFlag::NONE)?;
    let glaze = MaterialDesc { model: Model::BLINN_PHONG, exponent: 80.0, ..Default::default() };
    // Each part of the teapot has three by three images of the texture.
    let slot = Slot::texture(SlotTarget::DIFFUSE, &texture, Some(&sampler))
        .desc(SlotDesc { uv_transform: [3.0, 0.0, 0.0, 0.0, 3.0, 0.0], ..Default::default() });
    let material = Material::builder(glaze).slot(slot).build(context)?;

    let sun = LightDesc { kind: LightKind::DIRECTIONAL, direction: [-1.0, -1.5, -1.0], ..Default::default() };
    let sky = LightDesc { kind: LightKind::AMBIENT, intensity: [1.5, 1.7, 2.0], ..Default::default() };
    let (sun, sky) = (Light::new(context, &sun)?, Light::new(context, &sky)?);
    let camera = Camera { eye: [3.0, 4.5, 8.0], target: [0.2, 1.4, 0.0], fov_y: 0.62, ..Default::default() };
    let frame = Frame::new()
        .desc(RenderDesc { clear_color: [0.05, 0.06, 0.08, 1.0], ..Default::default() })
        .camera(camera)
        .draw(Draw::new(&teapot, &material))
        .light(&sun)
        .light(&sky);
    let size = FramebufferDesc { width: WIDTH, height: HEIGHT, sample_count: 8, ..Default::default() };
    let mut framebuffer = Framebuffer::new(context, &size)?;
    let stats = frame.render(context, &mut framebuffer)?;
    println!("{} triangles, {} fragments", stats.triangle_count, stats.fragment_count);

    let mut pixels = vec![[0u8; 4]; (WIDTH * HEIGHT) as usize];
    framebuffer.read_color(Format::RGBA8_SRGB, &mut pixels)?;
    Ok(pixels.iter().flat_map(|&[r, g, b, _]| [r, g, b]).collect())
}

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).ok_or("usage: teapot picture.ppm")?;
    let pixels = render(&Context::new()?)?;
    let mut file = BufWriter::new(File::create(&path)?);
    write!(file, "P6\n{WIDTH} {HEIGHT}\n255\n")?;
    file.write_all(&pixels)?;
    file.flush()?;
    println!("{path}: {WIDTH} x {HEIGHT}");
    Ok(())
}
