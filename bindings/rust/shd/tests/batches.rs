// SPDX-License-Identifier: MIT
//! Columns, lookups and textures: results, and refused arguments.
mod common;

use common::{checker, message};
use shd::*;

#[test]
fn columns_of_records_are_read_and_written() {
    #[derive(Clone, Default)]
    struct Point {
        name: u32,
        u: f32,
        v: f32,
        red: f32,
    }
    let context = Context::new().unwrap();
    let sampler = Sampler::new(&context, &SamplerDesc { filter: Filter::NEAREST, ..Default::default() }).unwrap();
    let place = |u, v| Point { u, v, name: 7, ..Default::default() };
    let points = [place(0.2, 0.2), place(0.7, 0.2), place(0.7, 0.7)];
    let u = Column::strided(&points, |point| &point.u).unwrap();
    let v = Column::strided(&points, |point| &point.v).unwrap();
    let mut found = points.to_vec();
    let [red] = ColumnMut::strided(&mut found, |point| [&mut point.red]).unwrap();
    checker(&context).sample(&sampler, &Lookups::new(u, v), &mut Texels::new().channel(0, red)).unwrap();
    assert_eq!(found.iter().map(|point| point.red).collect::<Vec<_>>(), [0.0, 1.0, 0.0]);
    assert!(found.iter().all(|point| point.name == 7));
}

#[test]
fn a_field_must_have_one_place() {
    enum Either {
        Left(f32),
        Right(u32, f32),
    }
    static VALUES: [Either; 2] = [Either::Left(1.0), Either::Right(2, 3.0)];
    let values = &VALUES[..];
    let field = |value: &'static Either| match value {
        Either::Left(x) | Either::Right(_, x) => x,
    };
    assert!(message(Column::strided(values, field)).starts_with("column: the field of record 1"));
    static ELSEWHERE: f32 = 1.0;
    assert!(message(Column::strided(values, |_| &ELSEWHERE)).starts_with("column: the field of record 0"));
    assert!(matches!(&values[1], Either::Right(2, _)));
}

#[test]
fn steps_of_a_slice() {
    let values = [0.0f32, 1.0, 2.0, 3.0, 4.0];
    assert_eq!(Column::every(2, &values).unwrap().len(), 3);
    assert_eq!(Column::every(5, &values[1..]).unwrap().len(), 1);
    assert_eq!(Column::every(usize::MAX, &values).unwrap().len(), 1);
    assert_eq!(message(Column::every(0, &values)), "column.step: 0, not 1 or more");
    let empty: [[f32; 3]; 0] = [];
    assert!(Column::split(&empty)[2].is_empty());
}

#[test]
fn lengths_are_compared() {
    let context = Context::new().unwrap();
    let sampler = Sampler::new(&context, &SamplerDesc::default()).unwrap();
    let texture = checker(&context);
    let (three, two) = ([0.0f32; 3], [0.0f32; 2]);
    let mut out = [0.0; 3];
    let mut texels = Texels::new().channel(0, &mut out);
    let short = Lookups::new(&three, &two);
    assert_eq!(
        message(texture.sample(&sampler, &short, &mut texels)),
        "lookups.v: 2 elements, not 3 as in the columns before"
    );
    let short = Lookups::new(&three, &three).lod(&two);
    assert_eq!(
        message(texture.sample(&sampler, &short, &mut texels)),
        "lookups.lod: 2 elements, not 3 as in the columns before"
    );
    let lookups = Lookups::new(&two, &two);
    assert_eq!(
        message(texture.sample(&sampler, &lookups, &mut texels)),
        "texels: 3 elements, not 2 as in the columns before"
    );
    assert_eq!(message(texture.sample(&sampler, &lookups, &mut Texels::new())), "texels: it has no column");
    let (mut long, mut short) = ([0.0; 3], [0.0; 2]);
    let mut texels = Texels::new().channel(0, &mut long).channel(1, &mut short);
    let three = Lookups::new(&three, &three);
    assert_eq!(
        message(texture.sample(&sampler, &three, &mut texels)),
        "texels.channel: 2 elements, not 3 as in the columns before"
    );
}

#[test]
fn errors_have_the_text_of_the_library() {
    let context = Context::new().unwrap();
    let error = Sampler::new(&context, &SamplerDesc { max_anisotropy: 65.0, ..Default::default() }).unwrap_err();
    assert_eq!(error.code(), ResultCode::ERROR_INVALID_ARGUMENT);
    assert!(error.message().contains("sampler.max_anisotropy: 65"), "{error}");
    let error = Sampler::new(&context, &SamplerDesc { filter: sys::shd_filter(99), ..Default::default() }).unwrap_err();
    assert!(error.message().contains("sampler.filter: 99"), "{error}");
}

#[test]
fn texels_must_fill_the_desc() {
    let context = Context::new().unwrap();
    let desc = TextureDesc { format: Format::RGBA8, width: 4, height: 4, ..Default::default() };
    assert_eq!(message(Texture::new(&context, &desc, &[0u8; 63])), "texture.texels: 63 bytes, not 64 or more");
    let rows = TextureDesc { row_stride: 20, ..desc };
    assert_eq!(message(Texture::new(&context, &rows, &[0u8; 75])), "texture.texels: 75 bytes, not 76 or more");
    assert!(Texture::new(&context, &rows, &[0u8; 76]).is_ok());
    assert_eq!(message(Texture::borrowed(&context, &desc, &[0u8; 191])), "texture.texels: 191 bytes, not 192 or more");
    let huge = TextureDesc { layer_stride: usize::MAX, layer_count: 9, ..desc };
    assert_eq!(
        message(Texture::new(&context, &huge, &[0u8; 9])),
        "texture.texels: the image exceeds the address space"
    );
    let none = TextureDesc::default();
    assert_eq!(message(Texture::new(&context, &none, &[0u8; 9])), "texture.format: NONE is not a format");
    let floats = TextureDesc { format: Format::R32F, width: 1, height: 1, ..Default::default() };
    let bytes = [0u8; 12];
    let odd = (0..4).find(|&i| bytes[i..].as_ptr() as usize % 4 == 1).unwrap();
    assert!(message(Texture::new(&context, &floats, &bytes[odd..])).contains("is not aligned to the 4 bytes"));
}

#[test]
fn the_kind_decides_what_texels_are() {
    let context = Context::new().unwrap();
    let plane = TextureDesc { format: Format::R8, width: 2, height: 2, ..Default::default() };
    let kind_of = |desc: &TextureDesc, texels: &[u8]| {
        let info = Texture::new(&context, desc, texels).unwrap().info().unwrap();
        (info.kind, info.depth, info.layer_count)
    };
    let refused = |desc: &TextureDesc, texels: &[u8]| message(Texture::new(&context, desc, texels));
    let volume = TextureDesc { kind: TextureKind::D3, depth: 3, ..plane };
    let cube = TextureDesc { kind: TextureKind::DIRECTIONS, projection: Projection::CUBE, ..plane };
    let disc = TextureDesc { projection: Projection::ANGULAR, ..cube };
    assert_eq!(kind_of(&volume, &[0; 12]), (TextureKind::D3, 3, 1));
    assert_eq!(refused(&volume, &[0; 11]), "texture.texels: 11 bytes, not 12 or more");
    assert_eq!(kind_of(&cube, &[0; 24]), (TextureKind::DIRECTIONS, 0, 6));
    assert_eq!(refused(&cube, &[0; 23]), "texture.texels: 23 bytes, not 24 or more");
    assert_eq!(kind_of(&disc, &[0; 4]), (TextureKind::DIRECTIONS, 0, 1));
    assert_eq!(kind_of(&TextureDesc { layer_count: 3, ..disc }, &[0; 12]), (TextureKind::DIRECTIONS, 0, 3));
    assert!(refused(&TextureDesc { depth: 3, ..plane }, &[0; 12]).starts_with("texture.depth: 3, but texture.kind"));
    assert!(refused(&TextureDesc { layer_count: 9, ..volume }, &[0; 12]).starts_with("texture.layer_count: 9"));
    assert!(refused(&TextureDesc { depth: 0, ..volume }, &[0; 12]).starts_with("texture.depth: 0"));
    assert!(refused(&TextureDesc { projection: Projection::NONE, ..cube }, &[0; 24]).starts_with("texture.projection"));
    assert!(refused(&TextureDesc { kind: sys::shd_texture_kind(3), ..plane }, &[0; 4]).starts_with("texture.kind: 3"));
}

#[test]
fn a_cube_is_looked_up_by_directions() {
    let context = Context::new().unwrap();
    let (kind, projection) = (TextureKind::DIRECTIONS, Projection::CUBE);
    let desc = TextureDesc { kind, projection, format: Format::R8, width: 1, height: 1, ..Default::default() };
    let texture = Texture::new(&context, &desc, &[0u8, 51, 102, 153, 204, 255]).unwrap();
    let sampler = Sampler::new(&context, &SamplerDesc { filter: Filter::NEAREST, ..Default::default() }).unwrap();
    let directions =
        [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 5.0, 0.0], [0.0, -5.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
    let [u, v, w] = Column::split(&directions);
    let mut red = [0.0; 6];
    texture.sample(&sampler, &Lookups::new(u, v).w(w), &mut Texels::new().channel(0, &mut red)).unwrap();
    assert_eq!(red.map(|value| (value * 5.0).round()), [0.0, 1.0, 2.0, 3.0, 4.0, 5.0]);
}

#[test]
fn borrowed_texels_give_the_bits_of_copied_ones() {
    let context = Context::new().unwrap();
    let texels: Vec<u8> = (0..64 + TEXTURE_PADDING).map(|i| (i * 37) as u8).collect();
    let desc = TextureDesc { format: Format::RGBA8, width: 4, height: 4, ..Default::default() };
    let sampler = Sampler::new(&context, &SamplerDesc::default()).unwrap();
    let u: Vec<f32> = (0..100).map(|i| i as f32 / 64.0).collect();
    let look_up = |texture: Texture<'_>| {
        let mut pixels = [[0.0; 4]; 100];
        texture.sample(&sampler, &Lookups::new(&u, &u), &mut Texels::interleaved(&mut pixels)).unwrap();
        pixels
    };
    let borrowed = look_up(Texture::borrowed(&context, &desc, &texels).unwrap());
    assert_eq!(borrowed, look_up(Texture::new(&context, &desc, &texels).unwrap()));
}

#[test]
fn updates_need_the_only_owner() {
    let context = Context::new().unwrap();
    let mut texture = checker(&context);
    texture.update(0, 0, 0, 2, &[255u8, 255]).unwrap();
    let mut level = [0u8; 4];
    texture.read_level(0, 0, &mut level).unwrap();
    assert_eq!(level, [255, 255, 255, 0]);
    assert_eq!(message(texture.update(0, 0, 0, 2, &[1u8; 3])), "texels: 3 bytes are not rows of 2 bytes");
    assert_eq!(message(texture.read_level(0, 0, &mut [0u8; 3])), "out: 3 bytes, not 4 or more");
    let slot = Slot::texture(SlotTarget::DIFFUSE, &texture, None);
    let material = Material::builder(MaterialDesc::default()).slot(slot).build(&context).unwrap();
    assert!(message(texture.update(0, 0, 0, 2, &[1u8; 2])).starts_with("texture: it has other owners"));
    drop(material);
    texture.update(0, 0, 0, 2, &[1u8; 2]).unwrap();
}

#[test]
fn threads_share_a_texture() {
    let context = Context::new().unwrap();
    let (texture, sampler) = (checker(&context), Sampler::new(&context, &SamplerDesc::default()).unwrap());
    let u: Vec<f32> = (0..40_000).map(|i| i as f32 / 1024.0).collect();
    let look_up = || {
        let mut red = vec![0.0; u.len()];
        let mut texels = Texels::new().channel(0, &mut red);
        texture.sample(&sampler, &Lookups::new(&u, &u), &mut texels).unwrap();
        red
    };
    let expected = look_up();
    std::thread::scope(|scope| {
        let threads: Vec<_> = (0..4).map(|_| scope.spawn(look_up)).collect();
        threads.into_iter().for_each(|thread| assert_eq!(thread.join().unwrap(), expected));
    });
}

#[test]
fn every_type_is_send_and_sync() {
    fn check<T: Send + Sync>() {}
    check::<Context>();
    check::<Texture<'_>>();
    check::<Sampler>();
    check::<Mesh>();
    check::<Material<'_>>();
    check::<Light<'_>>();
    check::<Framebuffer>();
    check::<Lookups<'_>>();
    check::<Texels<'_>>();
    check::<Frame<'_>>();
    check::<PlaneView<'_, f32>>();
    check::<Error>();
}

#[test]
fn compressed_blocks_are_looked_up() {
    // The first row of BC1 is red, blue and colours between them; BC7 is one colour, in mode 6.
    const BC1: [u8; 8] = [0x00, 0xf8, 0x1f, 0x00, 0xe4, 0, 0, 0];
    const BC7: [u8; 16] = [192, 255, 159, 66, 1, 0, 254, 255, 1, 0, 0, 0, 0, 0, 0, 0];
    let context = Context::new().unwrap();
    let sampler = Sampler::new(&context, &SamplerDesc { filter: Filter::NEAREST_MIP, ..Default::default() }).unwrap();
    let desc =
        |format, width, height, layer_count| TextureDesc { format, width, height, layer_count, ..Default::default() };
    let green = |texture: &Texture, lod: f32, layer: u32| {
        let (mut found, lods, layers) = ([0.0f32], [lod], [layer]);
        let lookups = Lookups::new(&[0.375], &[0.125]).lod(&lods).layer(&layers);
        texture.sample(&sampler, &lookups, &mut Texels::new().channel(1, &mut found)).unwrap();
        found[0] * 255.0
    };
    let blue = Texture::from_blocks(&context, &desc(Format::BC1_RGB, 4, 4, 1), &[&BC1]).unwrap();
    assert_eq!(green(&blue, 0.0, 0), 0.0);
    assert_eq!(green(&Texture::from_blocks(&context, &desc(Format::BC7, 3, 1, 1), &[&BC7]).unwrap(), 0.0, 0), 41.0);
    let levels = [[BC7, BC7, [0; 16], [0; 16]].concat(), [[0; 16], BC7].concat()];
    let both: Vec<&[u8]> = levels.iter().map(|level| &level[..]).collect();
    let layered = Texture::from_blocks(&context, &desc(Format::BC7, 8, 4, 2), &both).unwrap();
    let found = [(0.0, 0), (0.0, 1), (1.0, 0), (1.0, 1)].map(|(lod, layer)| green(&layered, lod, layer));
    assert_eq!(found, [41.0, 0.0, 0.0, 41.0]);
    let refused = |desc: &TextureDesc, levels: &[&[u8]]| message(Texture::from_blocks(&context, desc, levels));
    assert_eq!(refused(&desc(Format::BC7, 5, 4, 1), &[&BC7]), "levels[0]: 16 bytes, not 32");
    assert_eq!(refused(&desc(Format::BC7, 4, 4, 1), &[&BC7, &BC1]), "levels[1]: 8 bytes, not 16");
    assert_eq!(refused(&desc(Format::BC7, 4, 4, 1), &[]), "levels: the list is empty");
    assert!(refused(&desc(Format::RGBA8, 4, 4, 1), &[&BC7]).contains("has no compressed blocks"));
}
