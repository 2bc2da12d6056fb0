// SPDX-License-Identifier: MIT
//! Tile caches, and the tiles that closures fill.
use std::any::Any;
use std::error::Error as StdError;
use std::ffi::{c_void, CString};
use std::fmt;
use std::marker::PhantomData;
use std::mem::size_of_val;
use std::panic::{self, AssertUnwindSafe};
use std::slice;
use std::sync::{Arc, Mutex, PoisonError};

use crate::error::{check, Panic};
use crate::object::Object;
use crate::{sys, Context, Plain, Region, Result, ResultCode, TileCacheDesc, TileCacheStats};

struct Inner {
    object: Object<sys::shd_tile_cache>,
    /// The panic of a closure, until the call that needed its tiles returns.
    panic: Mutex<Option<Panic>>,
}

/// Memory of a fixed size for the tiles of textures; see [`crate::Texture::from_tiles`]. A clone is another owner of the
/// same cache.
#[derive(Clone)]
pub struct TileCache(Arc<Inner>);

impl fmt::Debug for TileCache {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "TileCache({:?})", self.0.object)
    }
}

impl TileCache {
    /// Makes a cache.
    pub fn new(context: &Context, desc: &TileCacheDesc) -> Result<Self> {
        let raw = desc.to_raw();
        let create = |out| unsafe { sys::shd_tile_cache_create(context.as_raw(), &raw, out) };
        let object = Object::create(context, sys::shd_tile_cache_release, create)?;
        Ok(Self(Arc::new(Inner { object, panic: Mutex::new(None) })))
    }

    /// The handle of C, borrowed from this owner.
    #[inline]
    pub fn as_raw(&self) -> *mut sys::shd_tile_cache {
        self.0.object.raw()
    }

    /// Counters since the creation.
    pub fn stats(&self) -> Result<TileCacheStats> {
        let mut raw = sys::shd_tile_cache_stats::default();
        check(unsafe { sys::shd_tile_cache_get_stats(self.as_raw(), &mut raw) })?;
        Ok(TileCacheStats::from_raw(&raw))
    }

    /// Loads up to `max_tiles` tiles that lookups with `MissingTiles::COARSER` did not find, 0 = all of them. Returns
    /// their number.
    pub fn load_requested(&self, max_tiles: usize) -> Result<usize> {
        let mut loaded = 0;
        self.check(unsafe { sys::shd_tile_cache_load_requested(self.as_raw(), max_tiles, &mut loaded) })?;
        Ok(loaded)
    }

    /// The result of a call that may have run closures of this cache. Continues the panic of a closure.
    #[inline]
    pub(crate) fn check(&self, code: ResultCode) -> Result<()> {
        if code == ResultCode::ERROR_CALLBACK {
            self.resume_panic();
        }
        check(code)
    }

    #[cold]
    pub(crate) fn resume_panic(&self) {
        let kept = self.0.panic.lock().unwrap_or_else(PoisonError::into_inner).take();
        if let Some(panic) = kept {
            panic::resume_unwind(panic);
        }
    }

    fn keep_panic(&self, panic: Panic) {
        let other = self.0.panic.lock().unwrap_or_else(PoisonError::into_inner).replace(panic);
        // The value of a panic may panic when it is dropped.
        std::mem::forget(other);
    }
}

/// A rectangle of a level of a texture, which a closure writes.
pub struct TextureTile<'a> {
    /// Layer of the texture.
    pub layer: u32,
    /// 0 = the base level.
    pub level: u32,
    /// Texels of the level to write.
    pub area: Region,
    texels: *mut u8,
    row_stride: usize,
    row_bytes: usize,
    memory: PhantomData<&'a mut [u8]>,
}

// A tile is memory that no one else uses during the call of the closure.
unsafe impl Send for TextureTile<'_> {}
unsafe impl Sync for TextureTile<'_> {}

impl TextureTile<'_> {
    /// Writes row `y` of the tile. `texels` has the whole row, in the format of the texture.
    ///
    /// # Panics
    /// If `y` is not below the height, or `texels` has another size.
    pub fn write_row<T: Plain>(&mut self, y: u32, texels: &[T]) {
        assert!(y < self.area.height, "tile.write_row: {y} is not in 0..{}", self.area.height);
        let bytes = size_of_val(texels);
        assert!(bytes == self.row_bytes, "tile.write_row: {bytes} bytes, not {}", self.row_bytes);
        // The library lends `area.height` rows of `row_bytes` bytes that are `row_stride` bytes apart.
        unsafe {
            let row = self.texels.add(y as usize * self.row_stride);
            row.copy_from_nonoverlapping(texels.as_ptr().cast(), bytes);
        }
    }
}

/// What a closure that loads tiles returns; `?` makes it of any error.
pub type Loaded = std::result::Result<(), Box<dyn StdError + Send + Sync>>;
type LoadFn<'a> = dyn Fn(&mut [TextureTile<'_>]) -> Loaded + Send + Sync + 'a;

/// The source of the tiles of a texture. The texture of C owns one, until its `release`.
pub(crate) struct Loader<'a> {
    pub(crate) cache: TileCache,
    pixel_size: usize,
    load: Box<LoadFn<'a>>,
}

impl fmt::Debug for Loader<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Loader({:?})", self.cache)
    }
}

impl<'a> Loader<'a> {
    pub(crate) fn new(cache: &TileCache, pixel_size: usize, load: Box<LoadFn<'a>>) -> Arc<Self> {
        Arc::new(Self { cache: cache.clone(), pixel_size, load })
    }

    /// The source that shares this loader. Its `release`, or [`Loader::forget`], drops the share.
    pub(crate) fn source(self: &Arc<Self>) -> sys::shd_tile_source {
        let user_data = Arc::into_raw(Arc::clone(self)) as *mut c_void;
        sys::shd_tile_source { cache: self.cache.as_raw(), load: Some(load), release: Some(release), user_data }
    }

    /// Drops the share of a source that no texture has taken.
    pub(crate) fn forget(source: &sys::shd_tile_source) {
        unsafe { release(source.user_data) }
    }

    fn run(&self, tiles: &[sys::shd_tile]) -> Loaded {
        let mut tiles: Vec<_> = tiles
            .iter()
            .map(|tile| TextureTile {
                layer: tile.layer,
                level: tile.level,
                area: Region::from_raw(&tile.area),
                texels: tile.texels.cast(),
                row_stride: tile.row_stride,
                row_bytes: tile.area.width as usize * self.pixel_size,
                memory: PhantomData,
            })
            .collect();
        (self.load)(&mut tiles)
    }
}

/// The text of a panic, if it has one.
fn text_of(panic: &(dyn Any + Send)) -> &str {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    text.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("a panic")
}

unsafe extern "C" fn load(tiles: *const sys::shd_tile, count: usize, user_data: *mut c_void) -> ResultCode {
    // The library passes the user_data of source(), and tiles for this call alone.
    let (loader, tiles) = unsafe { (&*(user_data as *const Loader<'_>), slice::from_raw_parts(tiles, count)) };
    let message = match panic::catch_unwind(AssertUnwindSafe(|| loader.run(tiles))) {
        Ok(Ok(())) => return ResultCode::OK,
        Ok(Err(problem)) => problem.to_string(),
        Err(panic) => {
            let text = text_of(&*panic).to_string();
            loader.cache.keep_panic(panic);
            text
        }
    };
    let message = CString::new(message.replace('\0', " ")).unwrap_or_default();
    unsafe { sys::shd_report_error(ResultCode::ERROR_CALLBACK, message.as_ptr()) }
}

unsafe extern "C" fn release(user_data: *mut c_void) {
    let loader = unsafe { Arc::from_raw(user_data as *const Loader<'_>) };
    // A closure that panics when it is dropped must not unwind into C.
    if panic::catch_unwind(AssertUnwindSafe(|| drop(loader))).is_err() {
        std::process::abort();
    }
}
