# SPDX-License-Identifier: MIT
"""Displays and colour spaces by OpenColorIO. Needs the component libshd_color."""
import ctypes

import numpy as np

from . import _api
from ._callback import raise_failures
from ._convert import enum_value, text_bytes
from ._desc import read_struct
from ._frame import Framebuffer
from ._image import array_type, image
from ._objects import _Simple, document, make_desc


def default_config():
    """The text of the built-in config."""
    return _api.lib.shd_color_default_config().decode()


class View:
    """A display and a view: the `display` of a SaveDesc. Made by Color.view()."""

    _struct = "shd_display"

    def __init__(self, color, display=None, view=None):
        self._color, self._names = color, (text_bytes(display, "display"), text_bytes(view, "view"))

    def build(self, keep):
        names = [ctypes.c_char_p(n) for n in self._names]
        target = _api.struct_type("shd_color_view")(
            self._color.handle("shd_color", keep, "display"), *(ctypes.cast(n, ctypes.c_void_p) for n in names))
        made = _api.struct_type("shd_display")(ctypes.cast(_api.lib.shd_color_apply_view, ctypes.c_void_p),
                                               ctypes.addressof(target))
        keep += [*names, target, made]
        return made


@document
class Color(_Simple):
    """Color(context, config_path=None, ...): a config of OpenColorIO.

        pixels = shd.Color(context).apply(framebuffer, "sRGB", "ACES 1.0 SDR-video")     # [height][width][4] of uint8
    """

    _kind = "shd_color"

    @staticmethod
    def _path(made):
        return made._values.get("config_path")

    def _texts(self, name, *arguments):
        keep = []  # another thread may close the object
        handle = self.handle(self._kind, keep)
        count, get = getattr(_api.lib, f"shd_color_get_{name}_count"), getattr(_api.lib, f"shd_color_get_{name}_name")
        return [get(handle, *arguments, i).decode() for i in range(count(handle, *arguments))]

    def _text(self, name, *arguments):
        keep = []
        found = getattr(_api.lib, f"shd_color_get_{name}")(self.handle(self._kind, keep), *arguments)
        return found.decode() if found is not None else None

    @property
    def displays(self) -> list:
        """Names of the displays."""
        return self._texts("display")

    @property
    def default_display(self):
        return self._text("default_display")

    @property
    def spaces(self) -> list:
        """Names of the colour spaces."""
        return self._texts("space")

    @property
    def working_space(self):
        return self._text("working_space")

    def views(self, display=None) -> list:
        """Names of the views of a display."""
        return self._texts("view", text_bytes(display, "display"))

    def default_view(self, display=None):
        """The default view of a display, None for an unknown display."""
        return self._text("default_view", text_bytes(display, "display"))

    def view(self, display=None, view=None):
        """A display and a view for shd.io.save(framebuffer, "frame.png", display=color.view("sRGB"))."""
        return View(self, display, view)

    def _out(self, out, shape, format, keep):
        """The image that a call writes, and its array."""
        texel_format = enum_value("shd_format", format, "format")
        dtype, channels = array_type(texel_format)
        out = np.empty((*shape, channels), dtype) if out is None else out
        if not isinstance(out, np.ndarray) or out.dtype != dtype or out.shape != (*shape, channels):
            raise TypeError(f"out: an array [{shape[0]}][{shape[1]}][{channels}] of {dtype}")
        if not out.flags.writeable:
            raise ValueError("out: the array is read-only")
        return image(out, keep, "out", texel_format=texel_format, in_place=True), out

    @staticmethod
    def _shape(framebuffer):
        if not isinstance(framebuffer, Framebuffer):
            raise TypeError(f"framebuffer: {type(framebuffer).__name__}, not Framebuffer")
        info = framebuffer.info
        return info["height"], info["width"]

    def apply(self, framebuffer, display=None, view=None, out=None, format="rgba8") -> np.ndarray:
        """A framebuffer for a display, as an array [height][width][4] with straight alpha."""
        keep = []
        made, out = self._out(out, self._shape(framebuffer), format, keep)
        _api.check(_api.lib.shd_color_apply_display(
            self.handle(self._kind, keep), framebuffer.handle("shd_framebuffer", keep, "framebuffer"),
            text_bytes(display, "display"), text_bytes(view, "view"), ctypes.addressof(made)))
        return out

    def render(self, framebuffer, draws=(), display=None, view=None, out=None, format="rgba8", desc=None, **values):
        """Renders a frame and transforms it for a display: the array, and the statistics of the frame.

        The other options are those of shd.render().
        """
        keep, stats = [], _api.new("shd_render_stats")
        made, out = self._out(out, self._shape(framebuffer), format, keep)
        frame = make_desc("shd_render_desc", desc, {**values, "draws": list(draws)}).replace(framebuffer=framebuffer)
        built = frame.build(keep)
        built.stats = ctypes.addressof(stats)
        result = framebuffer.exclusive(
            _api.lib.shd_color_render, self.handle(self._kind, keep), ctypes.addressof(built),
            text_bytes(display, "display"), text_bytes(view, "view"), ctypes.addressof(made))
        raise_failures(keep)
        _api.check(result)
        return out, read_struct("shd_render_stats", stats)

    def apply_image(self, pixels, from_space=None, display=None, view=None, out=None,
                    format="rgba8") -> np.ndarray:
        """An image [height][width][4] of float16 or float32 for a display, from a colour space."""
        keep = []
        source = image(pixels, keep, "pixels")
        made, out = self._out(out, (source.height, source.width), format, keep)
        _api.check(_api.lib.shd_color_apply_display_image(
            self.handle(self._kind, keep), ctypes.addressof(source), text_bytes(from_space, "from_space"),
            text_bytes(display, "display"), text_bytes(view, "view"), ctypes.addressof(made)))
        return out

    def convert(self, pixels, from_space, to_space=None) -> np.ndarray:
        """Converts an image [height][width][4] of float16 or float32 to another colour space, in place."""
        keep = []
        made = image(pixels, keep, "pixels", in_place=True)
        if not pixels.flags.writeable:
            raise ValueError("pixels: the array is read-only")
        _api.check(_api.lib.shd_color_convert(self.handle(self._kind, keep), ctypes.addressof(made),
                                              text_bytes(from_space, "from_space"), text_bytes(to_space, "to_space")))
        return pixels
