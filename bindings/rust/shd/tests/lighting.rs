// SPDX-License-Identifier: MIT
//! Shadows and environments.
mod common;

use std::panic::AssertUnwindSafe;

use common::{framebuffer, message, panic_text, program, square};
use shd::*;

/// A floor of the square, and a smaller square above it.
fn draws<'a>(mesh: &'a Mesh, material: &'a Material<'a>) -> [Draw<'a>; 2] {
    let mut above = [0.0; 16];
    (above[0], above[5], above[10], above[14], above[15]) = (0.25, 0.25, 1.0, 1.0, 1.0);
    [Draw::new(mesh, material), Draw::new(mesh, material).at(above)]
}

#[test]
fn a_shadow_darkens_a_frame() {
    let context = Context::new().unwrap();
    let (mesh, material) = (square(&context), Material::new(&context, &MaterialDesc::default()).unwrap());
    let (kind, direction) = (LightKind::DIRECTIONAL, [1.0, 0.0, -1.0]);
    let sun = Light::new(&context, &LightDesc { kind, direction, ..Default::default() }).unwrap();
    let draws = draws(&mesh, &material);
    let mut shadow = Shadow::new(&context, &ShadowDesc { size: 64, ..Default::default() }).unwrap();
    let sum = |frame: Frame<'_>| -> Result<f32> {
        let mut framebuffer = framebuffer(&context);
        frame.camera(Camera { eye: [0.0, 0.0, 6.0], ..Default::default() }).render(&context, &mut framebuffer)?;
        let plane = framebuffer.plane(Plane::R)?;
        let rows = plane.rows().map(|row| row.iter().sum::<f32>());
        Ok(rows.sum())
    };
    let frame = || Frame::new().draw(draws[0]).draw(draws[1]);
    assert!(message(sum(frame().light_with_shadow(&sun, &shadow))).contains("shadow: it was not rendered yet"));
    shadow.render(&context, &sun, &draws, &ShadowRenderDesc::default()).unwrap();
    let (lit, dark) = (sum(frame().light(&sun)).unwrap(), sum(frame().light_with_shadow(&sun, &shadow)).unwrap());
    assert!(dark < lit && dark > lit / 2.0, "{dark} {lit}");
}

#[test]
fn a_panic_continues_in_a_shadow() {
    let context = Context::new().unwrap();
    let mesh = square(&context);
    let broken = Material::builder(MaterialDesc::default()).vertex(|_, _| panic!("no vertex")).build(&context).unwrap();
    let sun = Light::new(&context, &LightDesc { kind: LightKind::DIRECTIONAL, ..Default::default() }).unwrap();
    let mut shadow = Shadow::new(&context, &ShadowDesc::default()).unwrap();
    let draws = [Draw::new(&mesh, &broken)];
    let render = AssertUnwindSafe(|| drop(shadow.render(&context, &sun, &draws, &ShadowRenderDesc::default())));
    assert_eq!(panic_text(render), "no vertex");
}

#[test]
fn an_environment_lights_a_frame() {
    let context = Context::new().unwrap();
    let desc = EnvironmentDesc { tables: EnvironmentTable::RADIANCE, ..Default::default() };
    let pixels = [[1.0f32, 0.5, 0.25]; 32];
    let environment = Environment::new(&context, &desc, Format::RGB32F, 8, 4, &pixels).unwrap();
    assert!((environment.info().unwrap().mean[1] - 0.5).abs() < 1e-3);
    assert_eq!(
        message(Environment::new(&context, &desc, Format::RGB32F, 8, 5, &pixels)),
        "environment.image: 384 bytes, not 480 or more"
    );
    let mesh = square(&context);
    let material = program(&context, |_, out| out.a.fill(1.0));
    let desc = RenderDesc { background: Background::ENVIRONMENT, ..Default::default() };
    let mut far = DrawDesc::default();
    far.object_to_world[12] = 100.0;
    let frame = Frame::new().desc(desc).environment(&environment).draw(Draw::new(&mesh, &material).desc(far));
    let mut framebuffer = framebuffer(&context);
    frame.camera(Camera::default()).render(&context, &mut framebuffer).unwrap();
    let blue = framebuffer.plane(Plane::B).unwrap();
    assert!(blue.rows().all(|row| row.iter().all(|value| (value - 0.25).abs() < 1e-3)));
}
