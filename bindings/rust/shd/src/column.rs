// SPDX-License-Identifier: MIT
//! Columns: strided streams of numbers in slices.
use std::marker::PhantomData;
use std::mem::size_of;
use std::ptr::NonNull;

use crate::{Error, Result};

mod sealed {
    pub trait Sealed {}
}

/// A number of which columns exist: `f32`, `u32` or `u16`.
pub trait Scalar: Copy + Send + Sync + sealed::Sealed + 'static {}

macro_rules! scalar {
    ($($type:ty),*) => {$(
        impl sealed::Sealed for $type {}
        impl Scalar for $type {}
    )*};
}
scalar!(f32, u32, u16);

/// A column that the library reads. It borrows the slice that it lies in.
#[derive(Clone, Copy, Debug)]
pub struct Column<'a, T: Scalar = f32> {
    pub(crate) data: *const T,
    /// Bytes between elements.
    pub(crate) stride: usize,
    pub(crate) count: usize,
    borrowed: PhantomData<&'a [T]>,
}

// A column is a shared borrow of numbers.
unsafe impl<T: Scalar> Send for Column<'_, T> {}
unsafe impl<T: Scalar> Sync for Column<'_, T> {}

/// The offset of a field in its record, if the field lies inside it.
fn offset_in<R, T>(record: *const R, field: *const T) -> Option<usize> {
    let offset = (field as usize).checked_sub(record as usize)?;
    (offset + size_of::<T>() <= size_of::<R>()).then_some(offset)
}

fn elsewhere(index: usize) -> Error {
    Error::argument(format!("column: the field of record {index} does not lie at the place of the field of record 0"))
}

impl<'a, T: Scalar> Column<'a, T> {
    fn packed(slice: &'a [T]) -> Self {
        Self { data: slice.as_ptr(), stride: size_of::<T>(), count: slice.len(), borrowed: PhantomData }
    }

    /// The column of one field of records. `field` is called for every record and must return the same field of each.
    ///
    /// ```
    /// struct Vertex { position: [f32; 3], weight: f32 }
    /// let vertices = [Vertex { position: [0.0; 3], weight: 1.0 }, Vertex { position: [1.0; 3], weight: 2.0 }];
    /// let weights = shd::Column::strided(&vertices, |vertex| &vertex.weight)?;
    /// assert_eq!(weights.len(), 2);
    /// # Ok::<(), shd::Error>(())
    /// ```
    pub fn strided<R>(records: &'a [R], field: impl Fn(&'a R) -> &'a T) -> Result<Self> {
        let mut first = None;
        for (index, record) in records.iter().enumerate() {
            let offset = offset_in(record, field(record)).ok_or_else(|| elsewhere(index))?;
            if *first.get_or_insert(offset) != offset {
                return Err(elsewhere(index));
            }
        }
        // The pointer is made from the slice, because it reaches all records.
        let data = match first {
            Some(offset) => unsafe { records.as_ptr().cast::<u8>().add(offset).cast::<T>() },
            None => NonNull::dangling().as_ptr(),
        };
        Ok(Self { data, stride: size_of::<R>(), count: records.len(), borrowed: PhantomData })
    }

    /// Every `step`th element of a slice, from its first one on: `Column::every(3, &xyz[1..])` is the column of y.
    pub fn every(step: usize, slice: &'a [T]) -> Result<Self> {
        if step == 0 {
            return Err(Error::argument("column.step: 0, not 1 or more"));
        }
        let count = slice.len() / step + usize::from(slice.len() % step != 0);
        let stride = if count > 1 { step * size_of::<T>() } else { size_of::<T>() };
        Ok(Self { data: slice.as_ptr(), stride, count, borrowed: PhantomData })
    }

    /// The columns of rows of N numbers, such as x, y and z of positions.
    pub fn split<const N: usize>(rows: &'a [[T; N]]) -> [Self; N] {
        let first = rows.as_ptr().cast::<T>();
        std::array::from_fn(|axis| Self {
            data: if rows.is_empty() { first } else { unsafe { first.add(axis) } },
            stride: size_of::<[T; N]>(),
            count: rows.len(),
            borrowed: PhantomData,
        })
    }

    /// Number of elements.
    pub fn len(&self) -> usize {
        self.count
    }

    /// Whether the column has no elements.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }
}

impl<'a, T: Scalar> From<&'a [T]> for Column<'a, T> {
    fn from(slice: &'a [T]) -> Self {
        Self::packed(slice)
    }
}

impl<'a, T: Scalar> From<&'a Vec<T>> for Column<'a, T> {
    fn from(vector: &'a Vec<T>) -> Self {
        Self::packed(vector)
    }
}

impl<'a, T: Scalar, const N: usize> From<&'a [T; N]> for Column<'a, T> {
    fn from(array: &'a [T; N]) -> Self {
        Self::packed(array)
    }
}

/// A column that the library writes. It borrows the slice that it lies in exclusively.
#[derive(Debug)]
pub struct ColumnMut<'a, T: Scalar = f32> {
    pub(crate) data: *mut T,
    pub(crate) stride: usize,
    pub(crate) count: usize,
    borrowed: PhantomData<&'a mut [T]>,
}

// A column is an exclusive borrow of numbers.
unsafe impl<T: Scalar> Send for ColumnMut<'_, T> {}
unsafe impl<T: Scalar> Sync for ColumnMut<'_, T> {}

impl<'a, T: Scalar> ColumnMut<'a, T> {
    fn packed(slice: &'a mut [T]) -> Self {
        Self { data: slice.as_mut_ptr(), stride: size_of::<T>(), count: slice.len(), borrowed: PhantomData }
    }

    /// Columns of N fields of records. `fields` returns all of them together, so they cannot overlap.
    ///
    /// ```
    /// #[derive(Clone, Default)]
    /// struct Pixel { red: f32, green: f32, visits: u32 }
    /// let mut pixels = vec![Pixel::default(); 8];
    /// let [red, green] = shd::ColumnMut::strided(&mut pixels, |pixel| [&mut pixel.red, &mut pixel.green])?;
    /// # Ok::<(), shd::Error>(())
    /// ```
    pub fn strided<R, const N: usize>(
        records: &'a mut [R],
        fields: impl Fn(&mut R) -> [&mut T; N],
    ) -> Result<[Self; N]> {
        let mut first: Option<[usize; N]> = None;
        for (index, record) in records.iter_mut().enumerate() {
            let start: *const R = record;
            let mut offsets = [0; N];
            for (offset, field) in offsets.iter_mut().zip(fields(record)) {
                *offset = offset_in(start, field).ok_or_else(|| elsewhere(index))?;
            }
            if *first.get_or_insert(offsets) != offsets {
                return Err(elsewhere(index));
            }
        }
        let (base, count) = (records.as_mut_ptr().cast::<u8>(), records.len());
        Ok(std::array::from_fn(|column| Self {
            data: match first {
                Some(offsets) => unsafe { base.add(offsets[column]).cast::<T>() },
                None => NonNull::dangling().as_ptr(),
            },
            stride: size_of::<R>(),
            count,
            borrowed: PhantomData,
        }))
    }

    /// The columns of rows of N numbers, such as r, g, b and a of pixels.
    pub fn split<const N: usize>(rows: &'a mut [[T; N]]) -> [Self; N] {
        let (first, count) = (rows.as_mut_ptr().cast::<T>(), rows.len());
        std::array::from_fn(|axis| Self {
            data: if count == 0 { first } else { unsafe { first.add(axis) } },
            stride: size_of::<[T; N]>(),
            count,
            borrowed: PhantomData,
        })
    }

    /// Number of elements.
    pub fn len(&self) -> usize {
        self.count
    }

    /// Whether the column has no elements.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }
}

impl<'a, T: Scalar> From<&'a mut [T]> for ColumnMut<'a, T> {
    fn from(slice: &'a mut [T]) -> Self {
        Self::packed(slice)
    }
}

impl<'a, T: Scalar> From<&'a mut Vec<T>> for ColumnMut<'a, T> {
    fn from(vector: &'a mut Vec<T>) -> Self {
        Self::packed(vector)
    }
}

impl<'a, T: Scalar, const N: usize> From<&'a mut [T; N]> for ColumnMut<'a, T> {
    fn from(array: &'a mut [T; N]) -> Self {
        Self::packed(array)
    }
}
