// SPDX-License-Identifier: MIT
//! Finished tiles of a frame.
use std::ffi::c_void;
use std::slice;

use crate::program::Call;
use crate::{sys, ResultCode};

pub(crate) type TileFn<'a> = dyn Fn(&Tile<'_>) + Send + Sync + 'a;

/// Colour of a rectangle of a framebuffer: scene-linear, premultiplied by alpha, the average of the samples of each
/// pixel.
pub struct Tile<'a> {
    raw: &'a sys::shd_present_tile,
}

impl<'a> Tile<'a> {
    /// First column, pixels of the framebuffer from the left.
    pub fn x(&self) -> u32 {
        self.raw.x
    }

    /// First row, pixels of the framebuffer from the top.
    pub fn y(&self) -> u32 {
        self.raw.y
    }

    /// Number of columns.
    pub fn width(&self) -> u32 {
        self.raw.width
    }

    /// Number of rows.
    pub fn height(&self) -> u32 {
        self.raw.height
    }

    /// A row of a channel: 0 = r, 1 = g, 2 = b, 3 = a.
    ///
    /// # Panics
    /// If `channel` is not in 0..4, or `y` is not below the height.
    pub fn row(&self, channel: usize, y: u32) -> &'a [f32] {
        assert!(y < self.raw.height, "tile.row: {y} is not in 0..{}", self.raw.height);
        let first = self.raw.channel[channel].cast::<u8>();
        // The library lends `height` rows that are `row_stride` bytes apart.
        let row = unsafe { first.add(y as usize * self.raw.row_stride) }.cast::<f32>();
        unsafe { slice::from_raw_parts(row, self.raw.width as usize) }
    }
}

/// The user_data of the library's callback.
pub(crate) struct TileCall<'c> {
    pub(crate) call: &'c Call,
    pub(crate) show: Option<&'c TileFn<'c>>,
}

pub(crate) unsafe extern "C" fn tile(user_data: *mut c_void, tile: *const sys::shd_present_tile) -> ResultCode {
    // The library passes the user_data of the frame, and a tile for this call alone.
    let (tiles, raw) = unsafe { (&*(user_data as *const TileCall<'_>), &*tile) };
    if let Some(show) = tiles.show {
        tiles.call.run(|| show(&Tile { raw }));
    }
    if tiles.call.has_panicked() {
        return ResultCode::ERROR_CALLBACK;
    }
    ResultCode::OK
}
