// SPDX-License-Identifier: MIT
//! Textures.
use std::marker::PhantomData;
use std::sync::Arc;

use crate::error::check;
use crate::object::Object;
use crate::pixels::{check_alignment, check_size, image_over, pixel_size, span};
use crate::tile_cache::{Loaded, Loader};
use crate::{
    sys, Context, Error, Lookups, Plain, Projection, Result, ResultCode, Sampler, Table, Texels, TextureDesc,
    TextureFlag, TextureInfo, TextureKind, TextureTile, TileCache, TileRegion,
};

/// An image prepared for filtering. A clone is another owner of the same texture.
///
/// The lifetime is that of borrowed texels; a texture with copied texels is a `Texture<'static>`. Lookups take `&self`
/// and may run concurrently.
///
/// ```
/// # use shd::{Context, Format, Lookups, Sampler, SamplerDesc, Table, Texels, Texture, TextureDesc};
/// let context = Context::new()?;
/// let desc = TextureDesc { format: Format::R8, width: 2, height: 2, tables: Table::MIPMAP, ..Default::default() };
/// let texture = Texture::new(&context, &desc, &[0u8, 255, 255, 0])?;
/// let sampler = Sampler::new(&context, &SamplerDesc::default())?;
/// let mut red = [0.0; 2];
/// let mut texels = Texels::new().channel(0, &mut red);
/// texture.sample(&sampler, &Lookups::new(&[0.25, 0.75], &[0.25, 0.25]), &mut texels)?;
/// assert_eq!(red, [0.0, 1.0]);
/// # Ok::<(), shd::Error>(())
/// ```
///
/// Borrowed texels outlive the texture, and everything that has the texture:
/// ```compile_fail,E0597
/// # use shd::*;
/// # let context = Context::new().unwrap();
/// # let desc = TextureDesc { format: Format::R8, width: 2, height: 2, ..Default::default() };
/// let material = {
///     let texels = vec![0u8; 4 + TEXTURE_PADDING];
///     let texture = Texture::borrowed(&context, &desc, &texels).unwrap();
///     let slot = Slot::texture(SlotTarget::DIFFUSE, &texture, None);
///     Material::builder(MaterialDesc::default()).slot(slot).build(&context).unwrap()
/// }; // `texels` does not live long enough
/// drop(material);
/// ```
///
/// ```compile_fail,E0505
/// # use shd::*;
/// # let context = Context::new().unwrap();
/// # let desc = TextureDesc { format: Format::R8, width: 2, height: 2, ..Default::default() };
/// let texels = vec![0u8; 4 + TEXTURE_PADDING];
/// let texture = Texture::borrowed(&context, &desc, &texels).unwrap();
/// drop(texels); // `texels` is borrowed
/// texture.info().unwrap();
/// ```
///
/// A texture that was dropped cannot be used:
/// ```compile_fail,E0382
/// # use shd::*;
/// # let context = Context::new().unwrap();
/// # let desc = TextureDesc { format: Format::R8, width: 1, height: 1, ..Default::default() };
/// let texture = Texture::new(&context, &desc, &[0u8]).unwrap();
/// drop(texture);
/// texture.info().unwrap(); // borrow of moved value
/// ```
#[derive(Clone, Debug)]
pub struct Texture<'a> {
    object: Arc<Object<sys::shd_texture>>,
    // Dropped after the texture, which may call its closure until then.
    tiles: Option<Arc<Loader<'a>>>,
    texels: PhantomData<&'a [u8]>,
}

/// Bytes behind the last borrowed texel that lookups may read.
pub const TEXTURE_PADDING: usize = sys::SHD_TEXTURE_PADDING;

/// Number of images in the memory of texels: layers, slices or faces.
fn image_count(raw: &sys::shd_texture_desc) -> usize {
    match (raw.kind, raw.projection) {
        (TextureKind::D3, _) => raw.depth as usize,
        (TextureKind::DIRECTIONS, Projection::CUBE) => 6,
        _ => raw.layer_count,
    }
}

/// Checks the memory of texels and returns the desc that points at it.
fn describe<T: Plain>(desc: &TextureDesc, texels: &[T], padding: usize) -> Result<sys::shd_texture_desc> {
    let mut raw = desc.to_raw();
    let size = pixel_size("texture", raw.format)?;
    let row = size.checked_mul(raw.width as usize);
    let row_stride = if raw.row_stride != 0 { Some(raw.row_stride) } else { row };
    let needed = row.zip(row_stride).and_then(|(row, row_stride)| {
        let packed = row_stride.checked_mul(raw.height as usize)?;
        let layer_stride = if raw.layer_stride != 0 { raw.layer_stride } else { packed };
        span(image_count(&raw), layer_stride, raw.height as usize, row_stride, row)?.checked_add(padding)
    });
    check_size("texture.texels", texels, needed)?;
    check_alignment("texture.texels", raw.format, texels)?;
    raw.texels = texels.as_ptr().cast();
    Ok(raw)
}

impl Texture<'static> {
    /// Makes a texture of copied texels, rows from top to bottom.
    pub fn new<T: Plain>(context: &Context, desc: &TextureDesc, texels: &[T]) -> Result<Self> {
        Self::create(context, &describe(desc, texels, 0)?)
    }

    /// Makes a texture of compressed blocks of 4 x 4 texels, which are copied. `levels` are the base and any number of
    /// mip levels below it; each has the blocks of all layers, packed. Strides and tables of `desc` have no effect.
    ///
    /// ```
    /// # use shd::{Context, Format, Lookups, Sampler, SamplerDesc, Texels, Texture, TextureDesc};
    /// # let context = Context::new()?;
    /// let desc = TextureDesc { format: Format::BC1_RGB, width: 4, height: 4, ..Default::default() };
    /// let block = [0x00, 0xf8, 0x1f, 0x00, 0x00, 0x55, 0x00, 0x00]; // a row of blue among rows of red
    /// let texture = Texture::from_blocks(&context, &desc, &[&block])?;
    /// let mut blue = [0.0; 2];
    /// let mut texels = Texels::new().channel(2, &mut blue);
    /// let sampler = Sampler::new(&context, &SamplerDesc::default())?;
    /// texture.sample(&sampler, &Lookups::new(&[0.125, 0.125], &[0.125, 0.375]), &mut texels)?;
    /// assert_eq!(blue, [0.0, 1.0]);
    /// # Ok::<(), shd::Error>(())
    /// ```
    pub fn from_blocks(context: &Context, desc: &TextureDesc, levels: &[&[u8]]) -> Result<Self> {
        let mut raw = desc.to_raw();
        let block = unsafe { sys::shd_format_block_size(raw.format) };
        if block == 0 {
            return Err(Error::argument(format!("texture.format: {:?} has no compressed blocks", raw.format)));
        }
        let layers = image_count(&raw).max(1);
        let mut sizes = Vec::with_capacity(levels.len());
        for (level, blocks) in levels.iter().enumerate() {
            let side = |size: u32| (size.checked_shr(level as u32).unwrap_or(0).max(1) as usize + 3) / 4;
            let size = side(raw.width).checked_mul(side(raw.height)).and_then(|count| count.checked_mul(block));
            let (size, needed) = size.and_then(|size| Some((size, size.checked_mul(layers)?))).unwrap_or_default();
            if blocks.len() != needed || needed == 0 {
                return Err(Error::argument(format!("levels[{level}]: {} bytes, not {needed}", blocks.len())));
            }
            sizes.push(size);
        }
        if levels.is_empty() {
            return Err(Error::argument("levels: the list is empty"));
        }
        let mut images = Vec::with_capacity(layers * (levels.len() - 1));
        for layer in 0..layers {
            for (level, blocks) in levels.iter().enumerate().skip(1) {
                let side = |size: u32| size.checked_shr(level as u32).unwrap_or(0).max(1);
                images.push(sys::shd_image {
                    format: raw.format,
                    width: side(raw.width),
                    height: side(raw.height),
                    pixels: blocks[layer * sizes[level]..].as_ptr() as *mut _,
                    ..Default::default()
                });
            }
        }
        (raw.row_stride, raw.layer_stride, raw.texels) = (0, 0, levels[0].as_ptr().cast());
        raw.tables = if levels.len() > 1 { Table::MIPMAP.0 } else { 0 };
        (raw.level_images, raw.level_count) = (images.as_ptr(), levels.len() - 1);
        Self::create(context, &raw)
    }
}

impl<'a> Texture<'a> {
    /// Makes a texture that borrows its texels. [`TEXTURE_PADDING`] bytes must follow the last texel in `texels`.
    ///
    /// The library refuses layers, row strides and formats of three channels here.
    pub fn borrowed<T: Plain>(context: &Context, desc: &TextureDesc, texels: &'a [T]) -> Result<Self> {
        let mut raw = describe(desc, texels, TEXTURE_PADDING)?;
        raw.flags = TextureFlag::BORROW.0;
        Self::create(context, &raw)
    }

    fn create(context: &Context, raw: &sys::shd_texture_desc) -> Result<Self> {
        Self::of(context, |out| unsafe { sys::shd_texture_create(context.as_raw(), raw, out) })
    }

    /// The texture that a function of C makes.
    pub(crate) fn of(context: &Context, create: impl FnOnce(*mut *mut sys::shd_texture) -> ResultCode) -> Result<Self> {
        Ok(Self::owned(Object::create(context, sys::shd_texture_release, create)?))
    }

    pub(crate) fn owned(object: Object<sys::shd_texture>) -> Self {
        Self { object: Arc::new(object), tiles: None, texels: PhantomData }
    }

    /// Makes a texture whose tiles are written by `load` when a lookup first needs them. `load` runs on any thread, also
    /// concurrently. An error of `load` is the error of the call that needed the tiles, a panic continues in this call,
    /// and the next call runs `load` again. Strides of `desc` must be 0.
    ///
    /// ```
    /// # use shd::*;
    /// # let context = Context::new()?;
    /// let cache = TileCache::new(&context, &TileCacheDesc { budget_bytes: 1 << 20, ..Default::default() })?;
    /// let desc = TextureDesc { format: Format::R8, width: 65536, height: 65536, ..Default::default() };
    /// let texture = Texture::from_tiles(&context, &cache, &desc, |tiles| {
    ///     for tile in tiles {
    ///         let Region { x, width, height, .. } = tile.area;
    ///         let row: Vec<u8> = (x..x + width).map(|x| x as u8).collect();
    ///         (0..height).for_each(|y| tile.write_row(y, &row));
    ///     }
    ///     Ok(())
    /// })?;
    /// let mut red = [0.0];
    /// let mut texels = Texels::new().channel(0, &mut red);
    /// let sampler = Sampler::new(&context, &SamplerDesc { filter: Filter::NEAREST, ..Default::default() })?;
    /// texture.sample(&sampler, &Lookups::new(&[0.5], &[0.5]), &mut texels)?;
    /// assert_eq!(red, [0.0]);
    /// assert_eq!(cache.stats()?.loaded_tile_count, 1);
    /// # Ok::<(), shd::Error>(())
    /// ```
    pub fn from_tiles(
        context: &Context,
        cache: &TileCache,
        desc: &TextureDesc,
        load: impl Fn(&mut [TextureTile<'_>]) -> Loaded + Send + Sync + 'a,
    ) -> Result<Self> {
        let mut raw = desc.to_raw();
        let loader = Loader::new(cache, pixel_size("texture", raw.format)?, Box::new(load));
        raw.tiles = loader.source();
        let mut texture = Self::create(context, &raw).map_err(|error| {
            Loader::forget(&raw.tiles);
            error
        })?;
        texture.tiles = Some(loader);
        Ok(texture)
    }

    /// Loads the tiles of a region that are not in memory.
    pub fn load_tiles(&self, region: &TileRegion) -> Result<()> {
        self.check(unsafe { sys::shd_texture_load_tiles(self.as_raw(), &region.to_raw()) })
    }

    /// Loads the tiles of a region, and keeps them until [`Texture::unpin_tiles`].
    pub fn pin_tiles(&self, region: &TileRegion) -> Result<()> {
        self.check(unsafe { sys::shd_texture_pin_tiles(self.as_raw(), &region.to_raw()) })
    }

    /// Undoes one [`Texture::pin_tiles`] of the same region.
    pub fn unpin_tiles(&self, region: &TileRegion) -> Result<()> {
        self.check(unsafe { sys::shd_texture_unpin_tiles(self.as_raw(), &region.to_raw()) })
    }

    /// Drops the tiles of a region and the coarser tiles that cover it, because their source has changed.
    pub fn drop_tiles(&self, region: &TileRegion) -> Result<()> {
        self.check(unsafe { sys::shd_texture_drop_tiles(self.as_raw(), &region.to_raw()) })
    }

    /// The result of a call that may have loaded tiles.
    #[inline]
    fn check(&self, code: ResultCode) -> Result<()> {
        if code == ResultCode::ERROR_CALLBACK {
            self.resume_panic();
        }
        check(code)
    }

    /// Continues the panic of a closure that loaded tiles.
    pub(crate) fn resume_panic(&self) {
        if let Some(loader) = &self.tiles {
            loader.cache.resume_panic();
        }
    }

    /// The handle of C, borrowed from this owner.
    #[inline]
    pub fn as_raw(&self) -> *mut sys::shd_texture {
        self.object.raw()
    }

    /// Size, format and memory.
    pub fn info(&self) -> Result<TextureInfo> {
        let mut raw = sys::shd_texture_info::default();
        check(unsafe { sys::shd_texture_get_info(self.as_raw(), &mut raw) })?;
        Ok(TextureInfo::from_raw(&raw))
    }

    /// Filters a batch of points. A prepared batch costs no more than the call of C, so loops prepare `lookups` and
    /// `texels` once.
    #[inline]
    pub fn sample(&self, sampler: &Sampler, lookups: &Lookups<'_>, texels: &mut Texels<'_>) -> Result<()> {
        lookups.check_count(texels)?;
        // All columns have the length of the batch. They are borrowed by `lookups` and `texels`.
        self.check(unsafe { sys::shd_texture_sample(self.as_raw(), sampler.as_raw(), &lookups.raw, &mut texels.raw) })
    }

    /// Copies a mip level of a layer, or of a slice in 3D, as it is stored. `out` has the size of the level.
    pub fn read_level<T: Plain>(&self, layer: u32, level: u32, out: &mut [T]) -> Result<()> {
        let info = self.info()?;
        let side = |size: u32| size.checked_shr(level).unwrap_or(0).max(1);
        let image = image_over("out", info.format, side(info.width), side(info.height), out)?;
        check(unsafe { sys::shd_texture_read_level(self.as_raw(), layer, level, &image) })
    }

    /// Writes a rectangle of `width` texels a row at column `x` and row `y`, and rebuilds the tables. `texels` has
    /// whole rows, in the format of the texture's info.
    ///
    /// The texture must have this owner alone: materials and lights that have the texture, and clones, are owners, too.
    pub fn update<T: Plain>(&mut self, layer: u32, x: u32, y: u32, width: u32, texels: &[T]) -> Result<()> {
        if Arc::get_mut(&mut self.object).is_none() {
            return Err(Error::argument("texture: it has other owners, which could use it during the update"));
        }
        // No other owner exists, and this one is borrowed exclusively.
        unsafe { self.update_shared(layer, x, y, width, texels) }
    }

    /// As [`Texture::update`], for a texture with other owners, such as the materials of an animated scene.
    ///
    /// # Safety
    /// No other call uses the texture concurrently. This includes renders that use it.
    pub unsafe fn update_shared<T: Plain>(&self, layer: u32, x: u32, y: u32, width: u32, texels: &[T]) -> Result<()> {
        let info = self.info()?;
        if info.flags.contains(TextureFlag::BORROW) {
            return Err(Error::argument("texture: its texels are borrowed, and nothing may change them"));
        }
        let row = pixel_size("texture", info.format)? * width as usize;
        let bytes = std::mem::size_of_val(texels);
        if row == 0 || bytes % row != 0 {
            return Err(Error::argument(format!("texels: {bytes} bytes are not rows of {row} bytes")));
        }
        check_alignment("texels", info.format, texels)?;
        let mut image = sys::shd_image::default();
        (image.format, image.width) = (info.format, width);
        image.height = u32::try_from(bytes / row).unwrap_or(u32::MAX);
        image.pixels = texels.as_ptr() as *mut _;
        check(unsafe { sys::shd_texture_update(self.as_raw(), layer, x, y, &image) })
    }
}
