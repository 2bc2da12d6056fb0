// SPDX-License-Identifier: MIT
//! Small scenes of the tests.
#![allow(dead_code)]
use shd::*;

pub const SIDE: u32 = 32;

/// A square that covers the picture of a camera at the origin's +Z side.
pub fn square(context: &Context) -> Mesh {
    let positions = [[-2.0, -2.0, 0.0], [2.0, -2.0, 0.0], [2.0, 2.0, 0.0], [-2.0, 2.0, 0.0]];
    let uv = [[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]];
    let indices = [0u16, 1, 2, 0, 2, 3];
    let desc = MeshDesc {
        uv: Some(Column::split(&uv)),
        indices: Indices::U16((&indices).into()),
        ..MeshDesc::new(Column::split(&positions))
    };
    Mesh::new(context, &desc).unwrap()
}

pub fn framebuffer(context: &Context) -> Framebuffer {
    let desc = FramebufferDesc { width: SIDE, height: SIDE, ..Default::default() };
    Framebuffer::new(context, &desc).unwrap()
}

pub fn program<'a>(
    context: &Context,
    fragment: impl Fn(&Fragments<'_>, &mut Radiance<'_>) + Send + Sync + 'a,
) -> Material<'a> {
    Material::builder(MaterialDesc::default()).fragment(fragment).build(context).unwrap()
}

/// Renders the square with one material and returns the planes r, g and b.
pub fn draw(context: &Context, material: &Material<'_>) -> Result<[Vec<f32>; 3]> {
    let mesh = square(context);
    let mut framebuffer = framebuffer(context);
    Frame::new().camera(Camera::default()).draw(Draw::new(&mesh, material)).render(context, &mut framebuffer)?;
    let plane = |plane| {
        let mut values = vec![0.0; (SIDE * SIDE) as usize];
        framebuffer.read_plane(plane, &mut values).map(|()| values)
    };
    Ok([plane(Plane::R)?, plane(Plane::G)?, plane(Plane::B)?])
}

/// A checker of four texels.
pub fn checker(context: &Context) -> Texture<'static> {
    let desc = TextureDesc { format: Format::R8, width: 2, height: 2, tables: Table::MIPMAP, ..Default::default() };
    Texture::new(context, &desc, &[0u8, 255, 255, 0]).unwrap()
}

/// The text of the failure that a call must return.
pub fn message<T>(result: Result<T>) -> String {
    result.err().expect("the call must fail").message().to_string()
}

/// The text of the panic that a closure must raise.
pub fn panic_text(body: impl FnOnce() + std::panic::UnwindSafe) -> String {
    let panic = std::panic::catch_unwind(body).expect_err("the closure must panic");
    match panic.downcast::<String>() {
        Ok(text) => *text,
        Err(panic) => panic.downcast::<&'static str>().expect("a panic with a text").to_string(),
    }
}
