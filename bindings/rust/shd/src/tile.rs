// SPDX-License-Identifier: MIT
//! Finished tiles of a frame.
use std::ffi::c_void;
use std::slice;

use crate::program::Call;
use crate::{sys, Region, ResultCode};

pub(crate) type TileFn<'a> = dyn Fn(&Tile<'_>) + Send + Sync + 'a;

/// Colour of a rectangle of a framebuffer: scene-linear, premultiplied by alpha, the average of the samples of each
/// pixel.
pub struct Tile<'a> {
    raw: &'a sys::shd_present_tile,
}

impl<'a> Tile<'a> {
    /// Pixels of the framebuffer.
    pub fn area(&self) -> Region {
        Region::from_raw(&self.raw.area)
    }

    /// A row of a channel: 0 = r, 1 = g, 2 = b, 3 = a.
    ///
    /// # Panics
    /// If `channel` is not in 0..4, or `y` is not below the height.
    pub fn row(&self, channel: usize, y: u32) -> &'a [f32] {
        let area = self.raw.area;
        assert!(y < area.height, "tile.row: {y} is not in 0..{}", area.height);
        let first = self.raw.channel[channel].cast::<u8>();
        // The library lends `area.height` rows that are `row_stride` bytes apart.
        let row = unsafe { first.add(y as usize * self.raw.row_stride) }.cast::<f32>();
        unsafe { slice::from_raw_parts(row, area.width as usize) }
    }
}

/// The user_data of the library's callback.
pub(crate) struct TileCall<'c> {
    pub(crate) call: &'c Call,
    pub(crate) show: Option<&'c TileFn<'c>>,
}

pub(crate) unsafe extern "C" fn tile(tile: *const sys::shd_present_tile, user_data: *mut c_void) -> ResultCode {
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
