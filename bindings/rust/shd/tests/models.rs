// SPDX-License-Identifier: MIT
//! Models and textures in memory.
#![cfg(feature = "scene")]
mod common;

use common::{message, panic_text};
use shd::*;

/// A triangle whose buffer is the file a.bin, with an animation to x = 4 in 2 s, and a texture that no file has.
const MODEL: &str = r#"{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
    "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
    "textures": [{"source": 0}], "images": [{"uri": "none.png"}], "buffers": [{"uri": "a.bin", "byteLength": 68}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 8},
        {"buffer": 0, "byteOffset": 44, "byteLength": 24}],
    "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
        {"bufferView": 1, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [2]},
        {"bufferView": 2, "componentType": 5126, "count": 2, "type": "VEC3"}],
    "animations": [{"name": "Move", "samplers": [{"input": 1, "output": 2}],
        "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}]}"#;

fn buffer() -> Vec<u8> {
    let numbers = [0.0f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 4.0, 0.0, 0.0];
    numbers.iter().flat_map(|number| number.to_le_bytes()).collect()
}

fn load<'a>(context: &Context, find: impl FnMut(&str) -> Found<'a> + 'a) -> Result<Scene> {
    SceneLoader::new(SceneDesc::default()).find(find).load_memory(context, MODEL.as_bytes(), "")
}

#[test]
fn a_closure_answers_the_names_of_a_model() {
    let context = Context::new().unwrap();
    let (borrowed, mut asked) = (buffer(), Vec::new());
    let find = |name: &str| {
        asked.push(name.to_string());
        Ok((name == "a.bin").then(|| borrowed[..].into()))
    };
    let scene = load(&context, find).unwrap();
    assert_eq!(asked, ["a.bin", "none.png"]);
    assert!(scene.warnings().iter().any(|text| text.contains("none.png")), "{:?}", scene.warnings());
    assert_eq!(scene.warnings().len(), scene.info().unwrap().warning_count);
    assert_eq!(scene.names(ScenePart::ANIMATION), ["Move"]);
    let (first, last) = scene.animation_times(0).unwrap();
    let pose = scene.pose(0, 0.5 * (first + last)).unwrap();
    assert_eq!(pose.instances().unwrap()[0].object_to_world[12], 2.0);
    assert_eq!(scene.instances().unwrap()[0].object_to_world[12], 0.0);
    assert!(message(scene.pose(1, 0.0)).starts_with("animation: 1"));
    let meshes = scene.meshes().unwrap();
    drop((scene, pose));
    assert_eq!(meshes[0].positions().unwrap()[1], [1.0, 0.0, 0.0]);

    assert_eq!(load(&context, |_| Ok(Some(buffer().into()))).unwrap().info().unwrap().triangle_count, 1);
    let error = load(&context, |_| Err("no archive".into())).unwrap_err();
    assert_eq!((error.code(), error.message()), (ResultCode::ERROR_CALLBACK, "no archive"));
    assert!(message(load(&context, |_| Ok(None))).contains("a.bin"));
    let panic = panic_text(|| {
        let context = Context::new().unwrap();
        drop(load(&context, |name| panic!("asked for {name}")));
    });
    assert_eq!(panic, "asked for a.bin");
    let trusting = SceneDesc { flags: SceneFlag::IN_PROCESS, ..Default::default() };
    let refused = SceneLoader::new(trusting).load(&context, "a.obj");
    assert!(message(refused).starts_with("scene.flags: IN_PROCESS"));
}

#[test]
fn a_texture_comes_from_the_bytes_of_a_file() {
    let context = Context::new().unwrap();
    let path = std::env::temp_dir().join(format!("shd-rust-{}.ktx2", std::process::id()));
    common::checker(&context).save_ktx2(&path, &Ktx2Desc::default()).unwrap();
    let bytes = std::fs::read(&path).unwrap();
    std::fs::remove_file(&path).unwrap();
    let (texture, file) = TextureLoader::default().load_memory(&context, &bytes).unwrap();
    match file {
        TextureFile::Texture(info) => assert_eq!((info.kind, info.level_count), (TextureFileKind::KTX2, 2)),
        other => panic!("{other:?}"),
    }
    let mut texels = [0u8; 4];
    texture.read_level(0, 0, &mut texels).unwrap();
    assert_eq!(texels, [0, 255, 255, 0]);
    assert_eq!(Texture::load_memory(&context, &bytes, &LoadDesc::default()).unwrap().info().unwrap().width, 2);
    let layout = RawDesc { width: 1, height: 1, depth: 4, ..Default::default() };
    let (volume, file) = TextureLoader::default().raw(layout).load_memory(&context, b"abcd").unwrap();
    assert_eq!((volume.info().unwrap().depth, file), (4, TextureFile::Image));
    let grid = TextureLoader::default().vdb(VdbDesc::default(), Some("density")).unwrap();
    assert!(grid.load_memory(&context, b"abcd").is_err());
    assert!(message(TextureLoader::default().load_stack(&context, &["none.png"])).contains("none.png"));
}
