// SPDX-License-Identifier: MIT
//! Textures in tile caches.
mod common;

use std::panic::AssertUnwindSafe;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::Arc;

use common::{message, panic_text};
use shd::*;

const WIDTH: u32 = 100;
const HEIGHT: u32 = 70;
const REGION: TileRegion = TileRegion { layer: 0, level: 1, area: Region { x: 0, y: 0, width: 50, height: 35 } };
const LOADS: u64 = 0;
const FAILS: u64 = 1;
const PANICS: u64 = 2;

/// A texture in memory, its levels, and what the closure that loads them as tiles does.
struct Source {
    memory: Texture<'static>,
    levels: Vec<Vec<[u8; 4]>>,
    mode: AtomicU64,
    calls: AtomicU64,
    tiles: AtomicU64,
}

impl Source {
    fn new(context: &Context) -> Self {
        let texels: Vec<u8> = (0..WIDTH * HEIGHT * 4).map(|i| (i.wrapping_mul(2654435761) >> 13) as u8).collect();
        let memory = Texture::new(context, &Self::desc(), &texels).unwrap();
        let read = |level: u32| {
            let side = |size: u32| (size >> level).max(1);
            let mut texels = vec![[0; 4]; (side(WIDTH) * side(HEIGHT)) as usize];
            memory.read_level(0, level, &mut texels).unwrap();
            texels
        };
        let levels = (0..memory.info().unwrap().level_count as u32).map(read).collect();
        Self { memory, levels, mode: LOADS.into(), calls: 0.into(), tiles: 0.into() }
    }

    fn desc() -> TextureDesc {
        TextureDesc { format: Format::RGBA8, width: WIDTH, height: HEIGHT, tables: Table::MIPMAP, ..Default::default() }
    }

    fn load(&self, tiles: &mut [TextureTile<'_>]) -> Loaded {
        self.calls.fetch_add(1, Ordering::Relaxed);
        self.tiles.fetch_add(tiles.len() as u64, Ordering::Relaxed);
        match self.mode.swap(LOADS, Ordering::Relaxed) {
            FAILS => return Err("no tile\0here".into()),
            PANICS => panic!("no tile"),
            _ => {}
        }
        for tile in tiles {
            let width = (WIDTH >> tile.level).max(1);
            let area = tile.area;
            for y in 0..area.height {
                let first = ((area.y + y) * width + area.x) as usize;
                tile.write_row(y, &self.levels[tile.level as usize][first..first + area.width as usize]);
            }
        }
        Ok(())
    }
}

fn cache(context: &Context) -> TileCache {
    let desc = TileCacheDesc { tile_bytes: 1024, budget_bytes: 1 << 20, ..Default::default() };
    TileCache::new(context, &desc).unwrap()
}

fn look_up(context: &Context, texture: &Texture<'_>, missing_tiles: MissingTiles) -> Result<Vec<[f32; 4]>> {
    let desc = SamplerDesc { filter: Filter::TRILINEAR, missing_tiles, ..Default::default() };
    let u: Vec<f32> = (0..500).map(|i| (i * 37 % 500) as f32 / 500.0).collect();
    let v: Vec<f32> = (0..500).map(|i| (i * 91 % 500) as f32 / 500.0).collect();
    let lod: Vec<f32> = (0..500).map(|i| i as f32 / 83.0).collect();
    let mut out = vec![[0.0; 4]; 500];
    let sampler = Sampler::new(context, &desc)?;
    texture.sample(&sampler, &Lookups::new(&u, &v).lod(&lod), &mut Texels::interleaved(&mut out))?;
    Ok(out)
}

#[test]
fn tiles_have_the_bits_of_memory() {
    let context = Context::new().unwrap();
    let (source, cache) = (Source::new(&context), cache(&context));
    let texture = Texture::from_tiles(&context, &cache, &Source::desc(), |tiles| source.load(tiles)).unwrap();
    let expected = look_up(&context, &source.memory, MissingTiles::WAIT).unwrap();
    assert_eq!(look_up(&context, &texture, MissingTiles::WAIT).unwrap(), expected);
    let stats = cache.stats().unwrap();
    let count = |counter: &AtomicU64| counter.load(Ordering::Relaxed);
    assert_eq!((stats.load_count, stats.loaded_tile_count), (count(&source.calls), count(&source.tiles)));
    assert_eq!(stats.resident_tile_count as u64, stats.loaded_tile_count);
    look_up(&context, &texture, MissingTiles::WAIT).unwrap();
    assert_eq!(cache.stats().unwrap().load_count, stats.load_count);
}

#[test]
fn errors_and_panics_reach_the_call() {
    let context = Context::new().unwrap();
    let (source, cache) = (Source::new(&context), cache(&context));
    let expected = look_up(&context, &source.memory, MissingTiles::WAIT).unwrap();
    for call in 0..3 {
        let texture = Texture::from_tiles(&context, &cache, &Source::desc(), |tiles| source.load(tiles)).unwrap();
        let run = || match call {
            0 => look_up(&context, &texture, MissingTiles::WAIT).map(drop),
            1 => texture.load_tiles(&REGION),
            _ => texture.pin_tiles(&REGION),
        };
        source.mode.store(FAILS, Ordering::Relaxed);
        let error = run().unwrap_err();
        assert_eq!(error.code(), ResultCode::ERROR_CALLBACK);
        assert!(error.message().contains("no tile here"), "{error}");
        source.mode.store(PANICS, Ordering::Relaxed);
        assert_eq!(panic_text(AssertUnwindSafe(|| run().unwrap())), "no tile");
        assert_eq!(look_up(&context, &texture, MissingTiles::WAIT).unwrap(), expected);
    }
    let texture = Texture::from_tiles(&context, &cache, &Source::desc(), |tiles| source.load(tiles)).unwrap();
    let slot = Slot::texture(SlotTarget::DIFFUSE, &texture, None);
    let unlit = MaterialDesc { model: Model::UNLIT, ..Default::default() };
    let material = Material::builder(unlit).slot(slot).build(&context).unwrap();
    source.mode.store(PANICS, Ordering::Relaxed);
    assert_eq!(panic_text(AssertUnwindSafe(|| drop(common::draw(&context, &material).unwrap()))), "no tile");
    common::draw(&context, &material).unwrap();
}

#[test]
fn requested_tiles_are_loaded() {
    let context = Context::new().unwrap();
    let (source, cache) = (Source::new(&context), cache(&context));
    let texture = Texture::from_tiles(&context, &cache, &Source::desc(), |tiles| source.load(tiles)).unwrap();
    let coarse = look_up(&context, &texture, MissingTiles::COARSER).unwrap();
    source.mode.store(PANICS, Ordering::Relaxed);
    assert_eq!(
        panic_text(AssertUnwindSafe(|| {
            cache.load_requested(0).unwrap();
        })),
        "no tile"
    );
    while look_up(&context, &texture, MissingTiles::COARSER).is_ok() && cache.load_requested(8).unwrap() > 0 {}
    let fine = look_up(&context, &texture, MissingTiles::COARSER).unwrap();
    assert_eq!(fine, look_up(&context, &source.memory, MissingTiles::WAIT).unwrap());
    assert_ne!(coarse, fine);
}

#[test]
fn regions_are_pinned_and_dropped() {
    let context = Context::new().unwrap();
    let (source, cache) = (Source::new(&context), cache(&context));
    let texture = Texture::from_tiles(&context, &cache, &Source::desc(), |tiles| source.load(tiles)).unwrap();
    texture.pin_tiles(&REGION).unwrap();
    assert_eq!(cache.stats().unwrap().pinned_tile_count, 12);
    texture.unpin_tiles(&REGION).unwrap();
    assert_eq!(cache.stats().unwrap().pinned_tile_count, 0);
    assert!(message(texture.unpin_tiles(&REGION)).contains("pinned"));
    let loaded = cache.stats().unwrap().loaded_tile_count;
    texture.load_tiles(&REGION).unwrap();
    assert_eq!(cache.stats().unwrap().loaded_tile_count, loaded);
    texture.drop_tiles(&REGION).unwrap();
    texture.load_tiles(&REGION).unwrap();
    assert_eq!(cache.stats().unwrap().loaded_tile_count, loaded + 12);
}

#[test]
fn a_closure_is_dropped_once_with_the_last_owner() {
    let context = Context::new().unwrap();
    let cache = cache(&context);
    let shared = Arc::new(());
    let make = |desc: &TextureDesc| {
        let kept = Arc::clone(&shared);
        Texture::from_tiles(&context, &cache, desc, move |_| {
            let _ = &kept;
            Ok(())
        })
    };
    let texture = make(&Source::desc()).unwrap();
    let slot = Slot::texture(SlotTarget::DIFFUSE, &texture, None);
    let material = Material::builder(MaterialDesc::default()).slot(slot).build(&context).unwrap();
    drop(texture);
    assert_eq!(Arc::strong_count(&shared), 2);
    drop(material);
    assert_eq!(Arc::strong_count(&shared), 1);
    assert!(message(make(&TextureDesc { layer_count: 0, ..Source::desc() })).contains("texture.layer_count: 0"));
    assert_eq!(Arc::strong_count(&shared), 1);
    let error = TileCache::new(&context, &TileCacheDesc { budget_bytes: 1, ..Default::default() });
    assert!(message(error).contains("budget_bytes: 1 is not"));
}

#[test]
fn rows_of_another_size_are_refused() {
    let context = Context::new().unwrap();
    let cache = cache(&context);
    for (y, width, expected) in [(0, 3, "tile.write_row: 3 bytes, not 1"), (1, 1, "tile.write_row: 1 is not in 0..1")] {
        let desc = TextureDesc { format: Format::R8, width: 1, height: 1, ..Default::default() };
        let write = |tiles: &mut [TextureTile<'_>]| {
            tiles[0].write_row(y, &vec![7u8; width]);
            Ok(())
        };
        let texture = Texture::from_tiles(&context, &cache, &desc, write).unwrap();
        let area = Region { x: 0, y: 0, width: 1, height: 1 };
        let region = TileRegion { area, ..Default::default() };
        assert_eq!(panic_text(AssertUnwindSafe(|| texture.load_tiles(&region).unwrap())), expected);
    }
}

#[cfg(feature = "io")]
#[test]
fn a_file_is_opened() {
    let context = Context::new().unwrap();
    let cache = cache(&context);
    let open = |name: &str| {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(name);
        // The file is part of the tree.
        let desc = TileFileDesc { encoding: ColorEncoding::LINEAR, ..Default::default() };
        unsafe { Texture::open(&context, path, &cache, &desc) }
    };
    let (texture, info) = open("tiled.tif").unwrap();
    assert_eq!(
        (info.file_count, info.column_count, info.row_count, info.tile_width, info.tile_height),
        (1, 1, 1, 16, 16)
    );
    let desc = TextureDesc { format: Format::R8, width: 16, height: 16, ..Default::default() };
    let texels: Vec<u8> = (0..=255).collect();
    let memory = Texture::new(&context, &desc, &texels).unwrap();
    let wait = MissingTiles::WAIT;
    assert_eq!(look_up(&context, &texture, wait).unwrap(), look_up(&context, &memory, wait).unwrap());
    assert_eq!(open("nothing.tif").unwrap_err().code(), ResultCode::ERROR_NOT_FOUND);
}
