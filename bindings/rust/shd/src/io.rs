// SPDX-License-Identifier: MIT
//! Files: feature `io`.
use std::ffi::CString;
use std::path::Path;

use crate::error::check;
use crate::{
    sys, Context, Error, Framebuffer, LoadDesc, LoadFlag, Result, SaveDesc, Texture, TileCache, TileFileDesc,
    TileFileInfo,
};

/// A path as a string of C.
fn path_of(path: &Path) -> Result<CString> {
    #[cfg(unix)]
    let bytes = std::os::unix::ffi::OsStrExt::as_bytes(path.as_os_str()).to_vec();
    #[cfg(not(unix))]
    let bytes = path.to_string_lossy().into_owned().into_bytes();
    CString::new(bytes).map_err(|_| Error::argument(format!("path: {path:?} has a zero byte")))
}

impl Texture<'static> {
    /// Makes a texture from an image file. A child process decodes the file.
    ///
    /// `LoadFlag::IN_PROCESS` is refused, because a hostile file could then break the safety of the program.
    pub fn load(context: &Context, path: impl AsRef<Path>, desc: &LoadDesc) -> Result<Self> {
        if desc.flags.contains(LoadFlag::IN_PROCESS) {
            return Err(Error::argument(
                "load.flags: IN_PROCESS, which needs sys::shd_texture_load() and trusted files",
            ));
        }
        let (path, raw) = (path_of(path.as_ref())?, desc.to_raw());
        Self::of(context, |out| unsafe { sys::shd_texture_load(context.as_raw(), path.as_ptr(), &raw, out) })
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

impl Framebuffer {
    /// Writes a file, whose extension decides the format: `.exr`, `.hdr`, `.png` or `.tif`.
    pub fn save(&self, path: impl AsRef<Path>, desc: &SaveDesc) -> Result<()> {
        let (path, raw) = (path_of(path.as_ref())?, desc.to_raw());
        check(unsafe { sys::shd_framebuffer_save(self.as_raw(), path.as_ptr(), &raw) })
    }
}
