# SPDX-License-Identifier: MIT
"""Images, textures and volumes from files, and pictures to files. Needs the component libshd_io."""
import ctypes

import numpy as np

from . import _api
from ._convert import text_bytes
from ._desc import read_struct
from ._frame import Framebuffer
from ._image import array_type, image
from ._objects import Object, make_desc
from ._texture import Texture


def _load(kind, context, source, desc, values, load):
    """An object from a path, or from the bytes of a file."""
    keep, made = [], kind.__new__(kind)
    built = make_desc("shd_load_desc", desc, values).build(keep)
    from_path, from_memory = load
    handle = context.handle("shd_context", keep)
    if isinstance(source, (bytes, bytearray, memoryview, np.ndarray)):
        raw = np.frombuffer(source, np.uint8)
        made._adopt(keep, from_memory, handle, raw.ctypes.data, raw.size, ctypes.addressof(built))
    else:
        made._adopt(keep, from_path, handle, text_bytes(source, "path"), ctypes.addressof(built))
    return made


class Bitmap(Object):
    """The pixels of an image file, without conversion: load(context, "picture.png")."""

    _kind = "shd_bitmap"

    @property
    def info(self):
        """File format, channels in the file and flags, as a dict."""
        return self._info("shd_bitmap_info")

    @property
    def color_space(self) -> str:
        """The colour space of the pixels, such as "sRGB"."""
        keep = []
        return _api.lib.shd_bitmap_color_space(self.handle(self._kind, keep)).decode("utf-8", "replace")

    @property
    def pixels(self) -> np.ndarray:
        """The pixels in place, as a read-only array [height][width][4], which keeps their memory."""
        out = _api.new("shd_image")
        keep = []
        _api.check(_api.lib.shd_bitmap_image(self.handle(self._kind, keep), ctypes.addressof(out)))
        dtype, channels = array_type(out.format)
        stride = out.row_stride or out.width * channels * dtype.itemsize
        memory = (ctypes.c_char * (stride * (out.height - 1) + out.width * channels * dtype.itemsize)).from_address(
            out.pixels)
        memory.reference = keep[0]
        array = np.ndarray((out.height, out.width, channels), dtype, memory, 0,
                           (stride, channels * dtype.itemsize, dtype.itemsize))
        array.flags.writeable = False
        return array


def load(context, source, desc=None, **values) -> Bitmap:
    """The image in a file, or in the bytes of a file, as a Bitmap. Options are the fields of LoadDesc."""
    return _load(Bitmap, context, source, desc, values,
                 (_api.lib.shd_bitmap_load, _api.lib.shd_bitmap_load_memory))


def load_texture(context, source, desc=None, **values) -> Texture:
    """A texture from an image file, or from the bytes of one. Options are the fields of LoadDesc."""
    return _load(Texture, context, source, desc, values,
                 (_api.lib.shd_texture_load, _api.lib.shd_texture_load_memory))


def _volume(context, function, arguments, keep, more=()):
    made = Texture.__new__(Texture)
    made._adopt(keep, function, context.handle("shd_context", keep), *arguments, *more)
    return made


def _built(struct, desc, values, keep):
    return ctypes.addressof(make_desc(struct, desc, values).build(keep))


def load_raw(context, path, desc=None, load=None, **values) -> Texture:
    """A 3D texture from a file of voxels: load_raw(context, "head.raw", width=256, height=256, depth=113).

    Options are the fields of RawDesc; `load` is a LoadDesc with budgets.
    """
    keep = []
    return _volume(context, _api.lib.shd_texture_load_raw,
                   (text_bytes(path, "path"), _built("shd_raw_desc", desc, values, keep),
                    _built("shd_load_desc", load, {}, keep)), keep)


def load_stack(context, paths=None, desc=None, load=None, **values) -> Texture:
    """A 3D texture from images: a list of paths, or pattern="slice%03d.png", first=0, last=80.

    Options are the fields of StackDesc; `load` is a LoadDesc.
    """
    keep = []
    if paths is not None:
        values["paths"] = list(paths)
    return _volume(context, _api.lib.shd_texture_load_stack,
                   (_built("shd_stack_desc", desc, values, keep), _built("shd_load_desc", load, {}, keep)), keep)


def load_vdb(context, path, desc=None, load=None, **values) -> "tuple[Texture, dict]":
    """A 3D texture from a grid of an OpenVDB file, and a dict of its properties with object_to_world as [4][4].

    Options are the fields of VdbDesc; `load` is a LoadDesc.
    """
    keep, info = [], _api.new("shd_vdb_info")
    texture = _volume(context, _api.lib.shd_texture_load_vdb,
                      (text_bytes(path, "path"), _built("shd_vdb_desc", desc, values, keep),
                       _built("shd_load_desc", load, {}, keep), ctypes.addressof(info)), keep)
    read = read_struct("shd_vdb_info", info)
    return texture, {**read, "grid": bytes(info.grid).split(b"\0")[0].decode("utf-8", "replace"),
                     "object_to_world": np.array(read["object_to_world"], np.float32).reshape(4, 4).T.copy()}


def open_texture(context, path, cache, desc=None, **values) -> "tuple[Texture, dict]":
    """A texture whose tiles stay in a tiled TIFF or OpenEXR file, or a set such as "earth.<UDIM>.tx", until lookups need
    them, and a dict of its files. `cache` is a TileCache; options are the fields of TileFileDesc.
    """
    keep, info = [], _api.new("shd_tile_file_info")
    texture = Texture.__new__(Texture)
    built = _built("shd_tile_file_desc", desc, {**values, "cache": cache}, keep)
    texture._adopt(keep, lambda out: _api.lib.shd_texture_open(context.handle("shd_context", keep),
                                                               text_bytes(path, "path"), built, out,
                                                               ctypes.addressof(info)))
    return texture, read_struct("shd_tile_file_info", info)


def save(picture, path, desc=None, srgb=False, **values) -> None:
    """Writes a framebuffer, or an image [height][width][channels], to the format of the extension.

    Options are the fields of SaveDesc: save(framebuffer, "frame.png", dither="ordered"). `srgb` marks arrays of uint8
    as encoded.
    """
    keep = []
    built = _built("shd_save_desc", desc, values, keep)
    if isinstance(picture, Framebuffer):
        call = _api.lib.shd_framebuffer_save, picture.handle("shd_framebuffer", keep, "picture")
    else:
        call = _api.lib.shd_image_save, ctypes.addressof(image(picture, keep, "picture", srgb=srgb))
    _api.check(call[0](call[1], text_bytes(path, "path"), built))
