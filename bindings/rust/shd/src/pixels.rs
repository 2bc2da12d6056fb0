// SPDX-License-Identifier: MIT
//! Memory of pixels and texels.
use std::mem::{align_of, size_of_val};

use crate::{sys, Error, Format, Result};

mod sealed {
    /// # Safety
    /// Every byte of the type is initialised, and every value of its bytes is valid.
    pub unsafe trait Sealed: Copy + Send + Sync + 'static {}
}

/// A type that pixels and texels may have in memory: `u8`, `u16`, `f32`, `u32`, and arrays of these, such as `[u8; 4]`.
pub trait Plain: sealed::Sealed {}

macro_rules! plain {
    ($($type:ty),*) => {$(
        unsafe impl sealed::Sealed for $type {}
        impl Plain for $type {}
    )*};
}
plain!(u8, u16, u32, f32);
unsafe impl<T: Plain, const N: usize> sealed::Sealed for [T; N] {}
impl<T: Plain, const N: usize> Plain for [T; N] {}

/// Bytes of one pixel.
pub(crate) fn pixel_size(name: &str, format: Format) -> Result<usize> {
    match unsafe { sys::shd_format_size(format) } {
        0 => Err(Error::argument(format!("{name}.format: {format:?} is not a format"))),
        size => Ok(size),
    }
}

/// Checks that memory has `needed` bytes. A type without the alignment of the format's channels is refused by the
/// library if its address is odd.
pub(crate) fn check_size<T>(name: &str, memory: &[T], needed: Option<usize>) -> Result<()> {
    match needed {
        Some(needed) if size_of_val(memory) >= needed => Ok(()),
        Some(needed) => Err(Error::argument(format!("{name}: {} bytes, not {needed} or more", size_of_val(memory)))),
        None => Err(Error::argument(format!("{name}: the image exceeds the address space"))),
    }
}

/// Bytes from the first pixel to the end of the last one.
pub(crate) fn span(layers: usize, layer_stride: usize, height: usize, row_stride: usize, row: usize) -> Option<usize> {
    if layers == 0 || height == 0 {
        return Some(0);
    }
    let rows = (height - 1).checked_mul(row_stride)?.checked_add(row)?;
    (layers - 1).checked_mul(layer_stride)?.checked_add(rows)
}

/// An image over memory that the library writes. The memory must have the size of the image.
pub(crate) fn image_over<T: Plain>(
    name: &str,
    format: Format,
    width: u32,
    height: u32,
    memory: &mut [T],
) -> Result<sys::shd_image> {
    let row = pixel_size(name, format)?.checked_mul(width as usize);
    check_size(name, memory, row.and_then(|row| row.checked_mul(height as usize)))?;
    check_alignment(name, format, memory)?;
    let mut image = sys::shd_image::default();
    (image.format, image.width, image.height) = (format, width, height);
    image.pixels = memory.as_mut_ptr().cast();
    Ok(image)
}

/// Checks that memory is aligned to a channel of the format.
pub(crate) fn check_alignment<T>(name: &str, format: Format, memory: &[T]) -> Result<()> {
    let channel = match format {
        Format::RGBA32F | Format::R32F | Format::RG32F | Format::RGB32F => 4,
        Format::RGBA16F | Format::R16F | Format::RG16F | Format::RGB16F => 2,
        Format::RGBA16 | Format::R16 | Format::RG16 | Format::RGB16 => 2,
        _ => 1,
    };
    if align_of::<T>() >= channel || memory.as_ptr() as usize % channel == 0 {
        return Ok(());
    }
    Err(Error::argument(format!("{name}: the memory is not aligned to the {channel} bytes of a channel")))
}
