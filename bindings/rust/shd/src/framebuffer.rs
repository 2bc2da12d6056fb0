// SPDX-License-Identifier: MIT
//! Framebuffers and their planes.
use std::marker::PhantomData;
use std::slice;

use crate::error::check;
use crate::object::Object;
use crate::pixels::image_over;
use crate::{sys, ColumnMut, Context, Error, Format, FramebufferDesc, FramebufferInfo, Plain, Plane, Result, Scalar};

/// Linear colour, depth and auxiliary planes of a frame.
///
/// A framebuffer has one owner: renders take it exclusively, and reads may run concurrently.
///
/// A view borrows the framebuffer, so no render can change the pixels under it:
/// ```compile_fail,E0502
/// # use shd::*;
/// # let context = Context::new().unwrap();
/// # let desc = FramebufferDesc { width: 8, height: 8, ..Default::default() };
/// let mut framebuffer = Framebuffer::new(&context, &desc).unwrap();
/// let depth = framebuffer.plane(Plane::DEPTH).unwrap();
/// Frame::new().render(&context, &mut framebuffer).unwrap(); // also borrowed as immutable
/// println!("{}", depth.row(0)[0]);
/// ```
///
/// Two threads cannot render into one framebuffer:
/// ```compile_fail,E0499
/// # use shd::*;
/// # let context = Context::new().unwrap();
/// # let desc = FramebufferDesc { width: 8, height: 8, ..Default::default() };
/// let mut framebuffer = Framebuffer::new(&context, &desc).unwrap();
/// std::thread::scope(|scope| {
///     scope.spawn(|| Frame::new().render(&context, &mut framebuffer));
///     scope.spawn(|| Frame::new().render(&context, &mut framebuffer)); // borrowed a second time
/// });
/// ```
#[derive(Debug)]
pub struct Framebuffer {
    object: Object<sys::shd_framebuffer>,
    width: u32,
    height: u32,
}

impl Framebuffer {
    /// Makes a framebuffer: colour 0, depth 1.
    pub fn new(context: &Context, desc: &FramebufferDesc) -> Result<Self> {
        let raw = desc.to_raw();
        let create = |out| unsafe { sys::shd_framebuffer_create(context.as_raw(), &raw, out) };
        let object = Object::create(context, sys::shd_framebuffer_release, create)?;
        Ok(Self { object, width: desc.width, height: desc.height })
    }

    /// The handle of C, borrowed from this owner.
    #[inline]
    pub fn as_raw(&self) -> *mut sys::shd_framebuffer {
        self.object.raw()
    }

    /// Columns of pixels.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Rows of pixels.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// The context that the framebuffer was made with.
    pub fn context(&self) -> &Context {
        self.object.context()
    }

    /// Size, planes and memory.
    pub fn info(&self) -> Result<FramebufferInfo> {
        let mut raw = sys::shd_framebuffer_info::default();
        check(unsafe { sys::shd_framebuffer_get_info(self.as_raw(), &mut raw) })?;
        Ok(FramebufferInfo::from_raw(&raw))
    }

    /// A plane of floats in place.
    pub fn plane(&self, plane: Plane) -> Result<PlaneView<'_, f32>> {
        let view = self.raw_view(plane)?;
        self.view(plane, view.f32, view.row_stride, "floats; take plane_u32()")
    }

    /// A plane of integers in place.
    pub fn plane_u32(&self, plane: Plane) -> Result<PlaneView<'_, u32>> {
        let view = self.raw_view(plane)?;
        self.view(plane, view.u32, view.row_stride, "integers; take plane()")
    }

    fn raw_view(&self, plane: Plane) -> Result<sys::shd_plane_view> {
        let mut view = sys::shd_plane_view::default();
        check(unsafe { sys::shd_framebuffer_view_plane(self.as_raw(), plane, &mut view) })?;
        Ok(view)
    }

    fn view<T>(&self, plane: Plane, data: *const T, stride: usize, kind: &str) -> Result<PlaneView<'_, T>> {
        if data.is_null() {
            return Err(Error::argument(format!("plane: {plane:?} has no {kind}")));
        }
        let (width, height) = (self.width as usize, self.height as usize);
        Ok(PlaneView { data, width, height, stride: stride / std::mem::size_of::<T>(), borrowed: PhantomData })
    }

    /// Copies a plane of floats into a column of width * height elements.
    pub fn read_plane<'a>(&self, plane: Plane, out: impl Into<ColumnMut<'a>>) -> Result<()> {
        let out = out.into();
        self.check_count(&out)?;
        let column = sys::shd_f32_out { data: out.data, stride: out.stride };
        check(unsafe { sys::shd_framebuffer_read_plane(self.as_raw(), plane, &column) })
    }

    /// Copies a plane of integers into a column of width * height elements.
    pub fn read_plane_u32<'a>(&self, plane: Plane, out: impl Into<ColumnMut<'a, u32>>) -> Result<()> {
        let out = out.into();
        self.check_count(&out)?;
        let column = sys::shd_u32_out { data: out.data, stride: out.stride };
        check(unsafe { sys::shd_framebuffer_read_u32_plane(self.as_raw(), plane, &column) })
    }

    fn check_count<T: Scalar>(&self, out: &ColumnMut<'_, T>) -> Result<()> {
        let pixels = self.width as usize * self.height as usize;
        if out.len() == pixels {
            return Ok(());
        }
        Err(Error::argument(format!("out: {} elements, not the {pixels} pixels of the framebuffer", out.len())))
    }

    /// Copies colour as interleaved RGBA of a format, packed rows from top to bottom.
    pub fn read_color<T: Plain>(&self, format: Format, out: &mut [T]) -> Result<()> {
        let image = image_over("out", format, self.width, self.height, out)?;
        check(unsafe { sys::shd_framebuffer_read_color(self.as_raw(), &image) })
    }

    /// The bytes of interleaved colour in place, row by row.
    pub fn view_color(&self) -> Result<PlaneView<'_, u8>> {
        let mut image = sys::shd_image::default();
        check(unsafe { sys::shd_framebuffer_view_color(self.as_raw(), &mut image) })?;
        let width = image.width as usize * unsafe { sys::shd_format_size(image.format) };
        let data = image.pixels as *const u8;
        Ok(PlaneView { data, width, height: image.height as usize, stride: image.row_stride, borrowed: PhantomData })
    }
}

/// Rows of a framebuffer in place. The framebuffer cannot be rendered into or dropped while the view is in use.
#[derive(Clone, Copy, Debug)]
pub struct PlaneView<'a, T> {
    data: *const T,
    width: usize,
    height: usize,
    /// Elements between rows.
    stride: usize,
    borrowed: PhantomData<&'a [T]>,
}

// A view is a shared borrow of numbers.
unsafe impl<T: Sync> Send for PlaneView<'_, T> {}
unsafe impl<T: Sync> Sync for PlaneView<'_, T> {}

impl<'a, T> PlaneView<'a, T> {
    /// Elements of a row.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Number of rows.
    pub fn height(&self) -> usize {
        self.height
    }

    /// A row from the top.
    ///
    /// # Panics
    /// If `y` is not below the height.
    pub fn row(&self, y: usize) -> &'a [T] {
        assert!(y < self.height, "plane.row: {y} is not in 0..{}", self.height);
        // The framebuffer is borrowed for 'a, and its memory has `height` rows of `stride` elements.
        unsafe { slice::from_raw_parts(self.data.add(y * self.stride), self.width) }
    }

    /// All rows from the top.
    pub fn rows(&self) -> impl Iterator<Item = &'a [T]> + '_ {
        (0..self.height).map(|y| self.row(y))
    }
}
