# SPDX-License-Identifier: MIT
"""Framebuffers and frames."""
import ctypes
import threading

import numpy as np

from . import _api
from ._callback import raise_failures
from ._convert import enum_value
from ._desc import read_struct
from ._image import array_type, image
from ._objects import Object, counted, document, make_desc, size_text
from ._png import encode, straight


@document
class Framebuffer(Object):
    """Framebuffer(context, width, height, sample_count=4, aovs="uv|normal", ...)."""

    _kind = "shd_framebuffer"

    def __init__(self, context, width=None, height=None, desc=None, **values):
        keep = []
        values.update({k: v for k, v in (("width", width), ("height", height)) if v is not None})
        built = make_desc("shd_framebuffer_desc", desc, values).build(keep)
        self._adopt(keep, _api.lib.shd_framebuffer_create, context.handle("shd_context", keep), ctypes.addressof(built))
        self.lock = threading.Lock()

    def _parts(self):
        info = self.info
        return [*size_text(info, info["color_format"]), counted(info["sample_count"], "sample")]

    def __array__(self, dtype=None, copy=None):
        """The colours in the format of the framebuffer, as a new array [height][width][4]."""
        if copy is False:
            raise ValueError("framebuffer: its array is a copy; plane() and view_color() are views")
        made = self.read_color(self.info["color_format"])
        return made if dtype is None else made.astype(dtype, copy=False)

    def __dlpack__(self, *, stream=None, **_):
        """The colours as a capsule of DLPack in the memory of the CPU, like __array__()."""
        if stream is not None:
            raise ValueError(f"framebuffer: stream {stream}, but its colours are in the memory of the CPU")
        return self.__array__().__dlpack__()

    def __dlpack_device__(self):
        return 1, 0  # kDLCPU

    def _repr_png_(self):
        """The picture in a notebook."""
        return None if self._reference is None else encode(straight(self.read_color("rgba8_srgb")))

    @property
    def info(self):
        """Size and planes, as a dict."""
        return self._info("shd_framebuffer_info")

    def exclusive(self, call, *arguments):
        """Runs a call of the library that needs the framebuffer for itself."""
        if not self.lock.acquire(blocking=False):
            raise ValueError("framebuffer: another call renders to it")
        try:
            return call(*arguments)
        finally:
            self.lock.release()

    def _array(self, where, dtype, shape, row_stride):
        memory = (ctypes.c_char * (row_stride * shape[0])).from_address(where)
        memory.reference = self._reference  # the array keeps the planes, also after close()
        row = row_stride // dtype.itemsize
        inner = shape[2] if len(shape) > 2 else 1
        array = np.frombuffer(memory, dtype).reshape(shape[0], row)[:, :shape[1] * inner].reshape(shape)
        array.flags.writeable = False
        return array

    def plane(self, plane):
        """A plane in place, as a read-only array [height][width]: plane("depth"). The next render changes it."""
        keep, out, info = [], _api.new("shd_plane_view"), self.info
        _api.check(_api.lib.shd_framebuffer_view_plane(self.handle("shd_framebuffer", keep),
                                                       enum_value("shd_plane", plane, "plane"), ctypes.addressof(out)))
        dtype = np.dtype("f4" if out.f32 else "u4")
        return self._array(out.f32 or out.u32, dtype, (info["height"], info["width"]), out.row_stride)

    def view_color(self):
        """Interleaved colour in place, as a read-only array [height][width][4]."""
        keep, out = [], _api.new("shd_image")
        _api.check(_api.lib.shd_framebuffer_view_color(self.handle("shd_framebuffer", keep), ctypes.addressof(out)))
        dtype, channels = array_type(out.format)
        return self._array(out.pixels, dtype, (out.height, out.width, channels), out.row_stride)

    def read_color(self, format="rgba32f", out=None):
        """Colour as an array [height][width][4], in a format such as "rgba8_srgb", "rgba16f" or "rgba32f"."""
        keep, info = [], self.info
        texel_format = enum_value("shd_format", format, "format")
        dtype, channels = array_type(texel_format)
        if out is None:
            out = np.empty((info["height"], info["width"], channels), dtype)
        if not isinstance(out, np.ndarray) or out.dtype != dtype or out.shape[2:] != (channels,):
            raise TypeError(f"out: an array [height][width][{channels}] of {dtype}")
        if not out.flags.writeable:
            raise ValueError("out: the array is read-only")
        made = image(out, keep, "out", texel_format=texel_format, in_place=True)
        _api.check(_api.lib.shd_framebuffer_read_color(self.handle("shd_framebuffer", keep), ctypes.addressof(made)))
        return out


def render(context, framebuffer, draws=(), desc=None, **values):
    """Renders a frame and returns its statistics as a dict: render(context, framebuffer, [Draw(mesh=mesh, ...)],
    camera=Camera(...), lights=[light]). Raises what a program raised. `progress` is a function of the finished
    fraction, or True for a bar."""
    keep = []
    made = make_desc("shd_render_desc", desc, {**values, "draws": list(draws)}).replace(framebuffer=framebuffer)
    built, stats = made.build(keep), _api.new("shd_render_stats")
    built.stats = ctypes.addressof(stats)
    result = framebuffer.exclusive(_api.lib.shd_render, context.handle("shd_context", keep), ctypes.addressof(built))
    raise_failures(keep)
    _api.check(result)
    return read_struct("shd_render_stats", stats)
