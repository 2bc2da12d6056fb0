// SPDX-License-Identifier: MIT
//! Batches of lookups.
use std::marker::PhantomData;

use crate::{sys, Column, ColumnMut, Error, Result};

/// Length of a batch whose columns differ in length.
const MISMATCH: usize = usize::MAX;

/// A column with another length than the ones before it.
#[derive(Clone, Copy, Debug)]
struct Mismatch {
    name: &'static str,
    count: usize,
    expected: usize,
}

impl Mismatch {
    fn error(self) -> Error {
        let Self { name, count, expected } = self;
        Error::argument(format!("{name}: {count} elements, not {expected} as in the columns before"))
    }
}

/// Points to look up. The columns are borrowed and have one length; a column of another length is an error of the call
/// that takes the batch.
#[derive(Clone, Debug)]
pub struct Lookups<'a> {
    pub(crate) raw: sys::shd_lookups,
    mismatch: Option<Mismatch>,
    columns: PhantomData<&'a [f32]>,
}

// The pointers are shared borrows of numbers.
unsafe impl Send for Lookups<'_> {}
unsafe impl Sync for Lookups<'_> {}

macro_rules! lookup_columns {
    ($($name:ident: $column:ty, $raw:ident, $doc:literal;)*) => {$(
        #[doc = $doc]
        pub fn $name(mut self, column: impl Into<$column>) -> Self {
            let column = column.into();
            self.raw.$name = sys::$raw { data: column.data, stride: column.stride };
            self.count(concat!("lookups.", stringify!($name)), column.count)
        }
    )*};
}

impl<'a> Lookups<'a> {
    /// Points (u, v), in images of the texture from its top left corner.
    pub fn new(u: impl Into<Column<'a>>, v: impl Into<Column<'a>>) -> Self {
        let (u, v) = (u.into(), v.into());
        let raw = sys::shd_lookups {
            count: u.count,
            u: sys::shd_f32_in { data: u.data, stride: u.stride },
            v: sys::shd_f32_in { data: v.data, stride: v.stride },
            ..Default::default()
        };
        Self { raw, mismatch: None, columns: PhantomData }.count("lookups.v", v.count)
    }

    lookup_columns! {
        dudx: Column<'a>, shd_f32_in, "du/dx per pixel step.";
        dvdx: Column<'a>, shd_f32_in, "dv/dx per pixel step.";
        dudy: Column<'a>, shd_f32_in, "du/dy per pixel step.";
        dvdy: Column<'a>, shd_f32_in, "dv/dy per pixel step.";
        lod: Column<'a>, shd_f32_in, "log2 of the footprint in base texels; replaces the derivatives.";
        layer: Column<'a, u32>, shd_u32_in, "Layers of an array.";
        random: Column<'a, u32>, shd_u32_in, "Random bits of the filter `STOCHASTIC`.";
        w: Column<'a>, shd_f32_in, "Third coordinate of a 3D texture or a direction.";
        dwdx: Column<'a>, shd_f32_in, "dw/dx per pixel step.";
        dwdy: Column<'a>, shd_f32_in, "dw/dy per pixel step.";
        reference: Column<'a>, shd_f32_in, "Compared with texels by samplers with `compares`.";
    }

    /// Number of points.
    pub fn len(&self) -> usize {
        self.mismatch.map_or(self.raw.count, |mismatch| mismatch.expected)
    }

    /// Whether the batch has no points.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    fn count(mut self, name: &'static str, count: usize) -> Self {
        if self.mismatch.is_none() && count != self.raw.count {
            self.mismatch = Some(Mismatch { name, count, expected: self.raw.count });
            self.raw.count = MISMATCH;
        }
        self
    }

    #[inline]
    pub(crate) fn check_count(&self, texels: &Texels<'_>) -> Result<()> {
        if self.raw.count == texels.count {
            return Ok(());
        }
        Err(self.explain(texels))
    }

    #[cold]
    fn explain(&self, texels: &Texels<'_>) -> Error {
        match self.mismatch.or(texels.mismatch) {
            Some(mismatch) => mismatch.error(),
            None if texels.count == EMPTY => Error::argument("texels: it has no column"),
            None => Mismatch { name: "texels", count: texels.count, expected: self.raw.count }.error(),
        }
    }
}

/// Length of an output without columns. No slice of numbers is as long as this or MISMATCH.
const EMPTY: usize = usize::MAX - 1;
/// Length of an output whose columns differ in length. It equals no length of lookups.
const UNEQUAL: usize = usize::MAX - 2;

/// Columns for filtered values. They are borrowed exclusively and have one length.
///
/// ```
/// # use shd::Texels;
/// let mut pixels = [[0.0; 4]; 16];
/// let texels = Texels::interleaved(&mut pixels);
/// ```
#[derive(Debug)]
pub struct Texels<'a> {
    pub(crate) raw: sys::shd_texels,
    count: usize,
    mismatch: Option<Mismatch>,
    columns: PhantomData<&'a mut [f32]>,
}

// The pointers are exclusive borrows of numbers.
unsafe impl Send for Texels<'_> {}
unsafe impl Sync for Texels<'_> {}

macro_rules! texel_columns {
    ($($name:ident: $field:ident, $doc:literal;)*) => {$(
        #[doc = $doc]
        ///
        /// # Panics
        /// If `channel` is not in 0..4.
        pub fn $name(mut self, channel: usize, column: impl Into<ColumnMut<'a>>) -> Self {
            let column = column.into();
            self.raw.$field[channel] = sys::shd_f32_out { data: column.data, stride: column.stride };
            self.count(concat!("texels.", stringify!($field)), column.count)
        }
    )*};
}

impl<'a> Texels<'a> {
    /// No columns yet.
    pub fn new() -> Self {
        Self { raw: sys::shd_texels::default(), count: EMPTY, mismatch: None, columns: PhantomData }
    }

    /// Columns of r, g, b and a, such as `[Vec<f32>; 4]`.
    pub fn rgba<C>(columns: &'a mut [C; 4]) -> Self
    where
        &'a mut C: Into<ColumnMut<'a>>,
    {
        let columns = columns.iter_mut().enumerate();
        columns.fold(Self::new(), |texels, (channel, column)| texels.channel(channel, column))
    }

    /// Pixels of r, g, b and a.
    pub fn interleaved(pixels: &'a mut [[f32; 4]]) -> Self {
        let columns = ColumnMut::split(pixels).into_iter().enumerate();
        columns.fold(Self::new(), |texels, (channel, column)| texels.channel(channel, column))
    }

    texel_columns! {
        channel: channel, "A channel after the texture's swizzle: 0 = r .. 3 = a.";
        du: du, "d/du of a channel.";
        dv: dv, "d/dv of a channel.";
        dw: dw, "d/dw of a channel of a 3D texture.";
    }

    /// Lookups of the latest batch whose coordinates, derivatives or lod were not finite.
    pub fn nonfinite_count(&self) -> usize {
        self.raw.nonfinite_count
    }

    fn count(mut self, name: &'static str, count: usize) -> Self {
        if self.count == EMPTY {
            self.count = count;
        } else if self.mismatch.is_none() && count != self.count {
            self.mismatch = Some(Mismatch { name, count, expected: self.count });
            self.count = UNEQUAL;
        }
        self
    }
}

impl Default for Texels<'_> {
    fn default() -> Self {
        Self::new()
    }
}
