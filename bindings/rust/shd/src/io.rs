// SPDX-License-Identifier: MIT
//! Files: feature `io`.
use std::ffi::{CStr, CString};
use std::path::Path;
use std::ptr;

use crate::error::check;
use crate::{
    sys, Context, Error, Framebuffer, Ktx2Desc, LoadDesc, LoadFlag, RawDesc, Result, ResultCode, SaveDesc, Texture,
    TextureFileInfo, TextureFileKind, TileCache, TileFileDesc, TileFileInfo, VdbDesc, VdbInfo,
};

/// A path as a string of C.
pub(crate) fn path_of(path: &Path) -> Result<CString> {
    #[cfg(unix)]
    let bytes = std::os::unix::ffi::OsStrExt::as_bytes(path.as_os_str()).to_vec();
    #[cfg(not(unix))]
    let bytes = path.to_string_lossy().into_owned().into_bytes();
    CString::new(bytes).map_err(|_| Error::argument(format!("path: {path:?} has a zero byte")))
}

impl Texture<'static> {
    /// Makes a texture from a file: an image, KTX2, DDS or OpenVDB, by its content. A child process decodes the file.
    ///
    /// `LoadFlag::IN_PROCESS` is refused, because a hostile file could then break the safety of the program.
    pub fn load(context: &Context, path: impl AsRef<Path>, desc: &LoadDesc) -> Result<Self> {
        Ok(TextureLoader::new(*desc).load(context, path)?.0)
    }

    /// Makes a texture from the bytes of a file, as [`Texture::load`] does.
    pub fn load_memory(context: &Context, bytes: &[u8], desc: &LoadDesc) -> Result<Self> {
        Ok(TextureLoader::new(*desc).load_memory(context, bytes)?.0)
    }

    /// Opens a tiled TIFF or OpenEXR file, or a UDIM set, as a texture whose tiles stay in the file until lookups need
    /// them.
    ///
    /// # Safety
    /// The files are trusted: this process decodes them, and a hostile file could break the safety of the program.
    pub unsafe fn open(
        context: &Context,
        path: impl AsRef<Path>,
        cache: &TileCache,
        desc: &TileFileDesc,
    ) -> Result<(Self, TileFileInfo)> {
        let (path, mut raw) = (path_of(path.as_ref())?, desc.to_raw());
        raw.cache = cache.as_raw();
        let mut info = sys::shd_tile_file_info::default();
        let texture = Self::of(context, |out| unsafe {
            sys::shd_texture_open(context.as_raw(), path.as_ptr(), &raw, out, &mut info)
        })?;
        Ok((texture, TileFileInfo::from_raw(&info)))
    }
}

impl Texture<'_> {
    /// Writes all levels to a KTX2 file.
    pub fn save_ktx2(&self, path: impl AsRef<Path>, desc: &Ktx2Desc) -> Result<()> {
        let (path, raw) = (path_of(path.as_ref())?, desc.to_raw());
        check(unsafe { sys::shd_texture_save_ktx2(self.as_raw(), path.as_ptr(), &raw) })
    }
}

/// What the file of a texture was.
#[derive(Clone, Debug, PartialEq)]
pub enum TextureFile {
    /// An image, voxels or a stack.
    Image,
    /// KTX2 or DDS.
    Texture(TextureFileInfo),
    /// A grid of OpenVDB, with its name.
    Grid(VdbInfo, String),
}

/// Options of a texture from a file that has voxels, slices or grids; see [`Texture::load`] for the others.
///
/// ```no_run
/// # use shd::*;
/// # let context = Context::new()?;
/// let layout = RawDesc { width: 256, height: 256, depth: 113, ..Default::default() };
/// let (head, _) = TextureLoader::new(LoadDesc::default()).raw(layout).load(&context, "head.raw")?;
/// # Ok::<(), shd::Error>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct TextureLoader {
    desc: LoadDesc,
    raw: Option<RawDesc>,
    vdb: Option<(VdbDesc, Option<CString>)>,
}

impl TextureLoader {
    /// The options of every file.
    pub fn new(desc: LoadDesc) -> Self {
        Self { desc, raw: None, vdb: None }
    }

    /// The file is voxels of this layout.
    pub fn raw(mut self, layout: RawDesc) -> Self {
        self.raw = Some(layout);
        self
    }

    /// The box and the grid of an OpenVDB file; `None` is the first grid of floats.
    pub fn vdb(mut self, desc: VdbDesc, grid: Option<&str>) -> Result<Self> {
        let name = |grid| CString::new(grid).map_err(|_| Error::argument("vdb.grid: it has a zero byte"));
        self.vdb = Some((desc, grid.map(name).transpose()?));
        Ok(self)
    }

    /// Makes a texture from a file.
    pub fn load(&self, context: &Context, path: impl AsRef<Path>) -> Result<(Texture<'static>, TextureFile)> {
        let path = path_of(path.as_ref())?;
        self.run(context, self.desc.to_raw(), |desc, out| unsafe {
            sys::shd_texture_load(context.as_raw(), path.as_ptr(), desc, out)
        })
    }

    /// Makes a texture from the bytes of a file.
    pub fn load_memory(&self, context: &Context, bytes: &[u8]) -> Result<(Texture<'static>, TextureFile)> {
        self.run(context, self.desc.to_raw(), |desc, out| unsafe {
            sys::shd_texture_load_memory(context.as_raw(), bytes.as_ptr().cast(), bytes.len(), desc, out)
        })
    }

    /// Makes a 3D texture of images, slice 0 first. Of a single file all pages are slices.
    pub fn load_stack(&self, context: &Context, paths: &[impl AsRef<Path>]) -> Result<(Texture<'static>, TextureFile)> {
        let paths = paths.iter().map(|path| path_of(path.as_ref())).collect::<Result<Vec<_>>>()?;
        let pointers: Vec<_> = paths.iter().map(|path| path.as_ptr()).collect();
        let stack = sys::shd_stack_desc { path_count: pointers.len(), paths: pointers.as_ptr(), ..Default::default() };
        let mut raw = self.desc.to_raw();
        raw.stack = &stack;
        self.run(context, raw, |desc, out| unsafe { sys::shd_texture_load(context.as_raw(), ptr::null(), desc, out) })
    }

    /// The pointers of `desc` are valid during this call.
    fn run(
        &self,
        context: &Context,
        mut desc: sys::shd_load_desc,
        load: impl FnOnce(&sys::shd_load_desc, *mut *mut sys::shd_texture) -> ResultCode,
    ) -> Result<(Texture<'static>, TextureFile)> {
        check_flags(&self.desc)?;
        let raw = self.raw.map(RawDesc::to_raw);
        let vdb = self.vdb.as_ref().map(|(vdb, grid)| {
            let mut vdb = vdb.to_raw();
            vdb.grid = grid.as_ref().map_or(ptr::null(), |grid| grid.as_ptr());
            vdb
        });
        let (mut info, mut grid) = (sys::shd_texture_file_info::default(), sys::shd_vdb_info::default());
        desc.raw = raw.as_ref().map_or(ptr::null(), |raw| raw);
        desc.vdb = vdb.as_ref().map_or(ptr::null(), |vdb| vdb);
        (desc.info, desc.vdb_info) = (&mut info, &mut grid);
        let texture = Texture::of(context, |out| load(&desc, out))?;
        if info.kind != TextureFileKind::NONE {
            return Ok((texture, TextureFile::Texture(TextureFileInfo::from_raw(&info))));
        }
        if grid.object_to_world[15] == 0.0 {
            return Ok((texture, TextureFile::Image));
        }
        // The name ends inside the array.
        let name = unsafe { CStr::from_ptr(grid.grid.as_ptr()) }.to_string_lossy().into_owned();
        Ok((texture, TextureFile::Grid(VdbInfo::from_raw(&grid), name)))
    }
}

/// Refuses files that this process would decode.
pub(crate) fn check_flags(desc: &LoadDesc) -> Result<()> {
    if desc.flags.contains(LoadFlag::IN_PROCESS) {
        return Err(Error::argument("load.flags: IN_PROCESS, which needs sys::shd_texture_load() and trusted files"));
    }
    Ok(())
}

impl Framebuffer {
    /// Writes a file, whose extension decides the format: `.exr`, `.hdr`, `.png` or `.tif`.
    pub fn save(&self, path: impl AsRef<Path>, desc: &SaveDesc) -> Result<()> {
        let (path, raw) = (path_of(path.as_ref())?, desc.to_raw());
        check(unsafe { sys::shd_framebuffer_save(self.as_raw(), path.as_ptr(), &raw) })
    }
}
