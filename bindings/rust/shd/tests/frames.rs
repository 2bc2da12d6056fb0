// SPDX-License-Identifier: MIT
//! Frames, programs and the lifetimes of closures.
mod common;

use std::ops::ControlFlow;
use std::panic::AssertUnwindSafe;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

use common::{draw, framebuffer, message, panic_text, program, square};
use shd::*;

#[test]
fn a_program_reads_uniforms_and_draws() {
    let context = Context::new().unwrap();
    let mesh = square(&context);
    let material = program(&context, |fragments, out| {
        assert_eq!((fragments.draw, fragments.u.len(), out.discard.len()), (0, fragments.count, 0));
        assert!(fragments.uniforms::<u32>().is_none() && fragments.attribute(9).is_empty());
        out.r.fill(*fragments.uniforms::<f32>().unwrap());
    });
    let mut framebuffer = framebuffer(&context);
    let value = 0.75f32;
    let frame = Frame::new().camera(Camera::default()).draw(Draw::new(&mesh, &material).uniforms(&value));
    let stats = frame.render(&context, &mut framebuffer).unwrap();
    assert_eq!((stats.triangle_count, stats.rasterized_triangle_count), (2, 2));
    let red = framebuffer.plane(Plane::R).unwrap();
    assert!(red.rows().all(|row| row.iter().all(|&value| value == 0.75)));
    assert_eq!((red.width(), red.height()), (32, 32));
}

#[test]
fn a_vertex_program_gives_varyings() {
    let context = Context::new().unwrap();
    let builder = Material::builder(MaterialDesc::default())
        .vertex(|vertices, out| {
            assert_eq!(vertices.object_to_world().len(), 16);
            out.varying[0].fill(0.5);
        })
        .varyings(&[Interpolation::FLAT])
        .fragment(|fragments, out| {
            out.r.copy_from_slice(fragments.varying(0));
            assert!(fragments.varying(1).is_empty());
        });
    let [red, ..] = draw(&context, &builder.build(&context).unwrap()).unwrap();
    assert!(red.iter().all(|&value| value == 0.5));
}

#[test]
fn a_procedure_feeds_a_slot() {
    let context = Context::new().unwrap();
    let slot = Slot::procedure(SlotTarget::DIFFUSE, |fragments, out| {
        let [r, g, b, _] = &mut out.channel;
        r.copy_from_slice(fragments.u);
        g.fill(0.0);
        b.fill(0.5);
    });
    let desc = MaterialDesc { model: Model::UNLIT, diffuse: [1.0; 3], ..Default::default() };
    let [red, green, blue] = draw(&context, &Material::builder(desc).slot(slot).build(&context).unwrap()).unwrap();
    assert!(red[0] < red[31] && green.iter().all(|&g| g == 0.0) && blue.iter().all(|&b| b == 0.5));
}

#[test]
fn a_panic_continues_in_render() {
    let context = Context::new().unwrap();
    let calls = AtomicUsize::new(0);
    let material = program(&context, |fragments, out| {
        if calls.fetch_add(1, Ordering::Relaxed) == 0 {
            panic!("no light for {} fragments", fragments.count);
        }
        out.r.fill(1.0);
    });
    let text = panic_text(AssertUnwindSafe(|| drop(draw(&context, &material))));
    assert!(text.starts_with("no light for "), "{text}");
    let [red, ..] = draw(&context, &material).unwrap();
    assert!(red.iter().all(|&value| value == 1.0));
}

#[test]
fn panics_of_vertex_programs_procedures_and_progress_continue() {
    let context = Context::new().unwrap();
    let material = Material::builder(MaterialDesc::default()).vertex(|_, _| panic!("vertex")).build(&context).unwrap();
    assert_eq!(panic_text(AssertUnwindSafe(|| drop(draw(&context, &material)))), "vertex");
    let slot = Slot::procedure(SlotTarget::DIFFUSE, |_, _| panic!("slot"));
    let material = Material::builder(MaterialDesc::default()).slot(slot).build(&context).unwrap();
    assert_eq!(panic_text(AssertUnwindSafe(|| drop(draw(&context, &material)))), "slot");
    let frame = Frame::new().progress(|_| panic!("progress"));
    let mut framebuffer = framebuffer(&context);
    assert_eq!(panic_text(AssertUnwindSafe(|| drop(frame.render(&context, &mut framebuffer)))), "progress");
}

#[test]
fn progress_cancels() {
    let context = Context::new().unwrap();
    let fractions = Mutex::new(Vec::new());
    let frame = Frame::new().progress(|fraction| {
        fractions.lock().unwrap().push(fraction);
        ControlFlow::Break(())
    });
    let error = frame.render(&context, &mut framebuffer(&context)).unwrap_err();
    assert_eq!(error.code(), ResultCode::ERROR_CANCELLED);
    drop(frame);
    assert_eq!(fractions.into_inner().unwrap().len(), 1);
}

#[test]
fn finished_tiles_have_the_pixels() {
    let context = Context::new().unwrap();
    let mesh = square(&context);
    let material = program(&context, |fragments, out| out.g.copy_from_slice(fragments.v));
    let desc = FramebufferDesc { width: 100, height: 70, ..Default::default() };
    let mut framebuffer = Framebuffer::new(&context, &desc).unwrap();
    let rows = Mutex::new(vec![vec![0.0; 100]; 70]);
    let frame = Frame::new().camera(Camera::default()).draw(Draw::new(&mesh, &material)).tiles(|tile| {
        let mut rows = rows.lock().unwrap();
        let Region { x, y, width, height } = tile.area();
        for row in 0..height {
            let pixels = &mut rows[(y + row) as usize];
            pixels[x as usize..(x + width) as usize].copy_from_slice(tile.row(1, row));
        }
    });
    frame.render(&context, &mut framebuffer).unwrap();
    drop(frame);
    assert!(framebuffer.plane(Plane::G).unwrap().rows().eq(rows.into_inner().unwrap().iter()));
    let frame = Frame::new().tiles(|tile| {
        tile.row(0, tile.area().height);
    });
    let text = panic_text(AssertUnwindSafe(|| drop(frame.render(&context, &mut framebuffer))));
    assert!(text.starts_with("tile.row: ") && text.contains(" is not in 0.."), "{text}");
}

#[test]
fn closures_live_as_long_as_their_material() {
    let context = Context::new().unwrap();
    let captured = Arc::new(0.5f32);
    let inside = captured.clone();
    let material = program(&context, move |_, out| out.g.fill(*inside));
    let second = material.clone();
    drop(material);
    assert_eq!(Arc::strong_count(&captured), 2);
    let [_, green, _] = draw(&context, &second).unwrap();
    assert_eq!(green[5], 0.5);
    drop(second);
    assert_eq!(Arc::strong_count(&captured), 1);
    let inside = captured.clone();
    let refused = Material::builder(MaterialDesc { exponent: -1.0, ..Default::default() })
        .fragment(move |_, out| out.g.fill(*inside))
        .build(&context);
    assert!(message(refused).contains("material.exponent: -1"));
    assert_eq!(Arc::strong_count(&captured), 1);
}

#[test]
fn a_program_looks_textures_up() {
    let context = Context::new().unwrap();
    let (texture, sampler) = (common::checker(&context), Sampler::new(&context, &SamplerDesc::default()).unwrap());
    let material = program(&context, |fragments, out| {
        let mut texels = Texels::new().channel(0, &mut *out.r);
        texture.sample(&sampler, &Lookups::new(fragments.u, fragments.v), &mut texels).unwrap();
    });
    let [red, ..] = draw(&context, &material).unwrap();
    assert!(red.iter().any(|&value| value > 0.9) && red.iter().any(|&value| value < 0.1));
}

#[test]
fn a_program_may_render_another_frame() {
    let context = Context::new().unwrap();
    let inner = program(&context, |_, out| out.r.fill(0.25));
    let material = program(&context, |_, out| {
        let [red, ..] = draw(&context, &inner).unwrap();
        out.r.fill(red[0]);
    });
    let [red, ..] = draw(&context, &material).unwrap();
    assert!(red.iter().all(|&value| value == 0.25));
}

#[test]
fn targets_and_discards_are_columns() {
    let context = Context::new().unwrap();
    let mesh = square(&context);
    let desc = MaterialDesc { flags: MaterialFlag::DISCARDS, ..Default::default() };
    let material = Material::builder(desc)
        .fragment(|fragments, out| {
            assert_eq!((out.target.len(), out.target[0][0].len()), (3, 0));
            out.target[1][2].fill(3.0);
            for (discard, &u) in out.discard.iter_mut().zip(fragments.u) {
                *discard = u32::from(u < 0.5);
            }
        })
        .build(&context)
        .unwrap();
    let aovs = Aov::TARGET2 | Aov::DRAW;
    let desc = FramebufferDesc { width: 8, height: 8, aovs, ..Default::default() };
    let mut framebuffer = Framebuffer::new(&context, &desc).unwrap();
    let frame = Frame::new().camera(Camera::default()).draw(Draw::new(&mesh, &material));
    frame.render(&context, &mut framebuffer).unwrap();
    let blue = framebuffer.plane(Plane::TARGET2_B).unwrap();
    assert_eq!((blue.row(4)[0], blue.row(4)[7]), (0.0, 3.0));
    assert_eq!(framebuffer.plane_u32(Plane::DRAW).unwrap().row(4)[7], 0);
    assert!(message(framebuffer.plane(Plane::DRAW)).contains("plane: DRAW has no floats"));
    assert!(message(framebuffer.plane(Plane::U)).starts_with("plane: 5 is not among"));
    assert_eq!(
        message(framebuffer.read_plane(Plane::R, &mut [0.0; 63])),
        "out: 63 elements, not the 64 pixels of the framebuffer"
    );
    assert_eq!(message(framebuffer.read_color(Format::RGBA8, &mut [[0u8; 4]; 63])), "out: 252 bytes, not 256 or more");
}
