// SPDX-License-Identifier: MIT
//! Files and colour transforms.
#![cfg(all(feature = "io", feature = "color"))]
mod common;

use common::{framebuffer, message};
use shd::*;

#[test]
fn a_framebuffer_goes_through_a_file() {
    let context = Context::new().unwrap();
    let mut framebuffer = framebuffer(&context);
    let desc = RenderDesc { clear_color: [1.0, 0.0, 0.0, 1.0], ..Default::default() };
    Frame::new().desc(desc).render(&context, &mut framebuffer).unwrap();
    let path = std::env::temp_dir().join(format!("shd-rust-{}.png", std::process::id()));
    framebuffer.save(&path, &SaveDesc::default()).unwrap();
    let texture = Texture::load(&context, &path, &LoadDesc::default());
    std::fs::remove_file(&path).unwrap();
    let texture = texture.unwrap();
    assert_eq!((texture.info().unwrap().width, texture.info().unwrap().format), (common::SIDE, Format::RGBA8_SRGB));
    let mut pixels = vec![[0u8; 4]; 32 * 32];
    texture.read_level(0, 0, &mut pixels).unwrap();
    assert!(pixels.iter().all(|&pixel| pixel == [255, 0, 0, 255]));
    let error = Texture::load(&context, &path, &LoadDesc::default()).unwrap_err();
    assert_eq!(error.code(), ResultCode::ERROR_NOT_FOUND);
    let trusting = LoadDesc { flags: LoadFlag::IN_PROCESS, ..Default::default() };
    assert!(message(Texture::load(&context, &path, &trusting)).starts_with("load.flags: IN_PROCESS"));
    assert!(message(framebuffer.save("a\0.png", &SaveDesc::default())).ends_with("has a zero byte"));
}

#[test]
fn a_display_encodes_colours() {
    let context = Context::new().unwrap();
    let color = Color::new(&context, &ColorDesc::default(), None).unwrap();
    assert!(!color.displays().is_empty() && !color.views(None).unwrap().is_empty());
    let mut framebuffer = framebuffer(&context);
    let desc = RenderDesc { clear_color: [1.0, 1.0, 1.0, 1.0], ..Default::default() };
    Frame::new().desc(desc).render(&context, &mut framebuffer).unwrap();
    let mut pixels = vec![0u8; 32 * 32 * 4];
    color.apply_display(&framebuffer, None, None, Format::RGBA8, &mut pixels).unwrap();
    assert!(pixels.iter().all(|&value| value > 100), "{pixels:?}");
    let missing = color.apply_display(&framebuffer, Some("cinema"), None, Format::RGBA8, &mut pixels);
    assert_eq!(missing.unwrap_err().code(), ResultCode::ERROR_NOT_FOUND);
    assert_eq!(Color::new(&context, &ColorDesc::default(), Some("?")).unwrap_err().code(), ResultCode::ERROR_CORRUPT);
}
