# SPDX-License-Identifier: MIT
"""Images, textures and volumes from files, and pictures to files. Needs the component libshd_io."""
import ctypes

import numpy as np

from . import _api
from ._convert import is_bytes, text_bytes
from ._desc import read_struct
from ._frame import Framebuffer
from ._image import array_type, image, split
from ._objects import Object, make_desc
from ._texture import Texture


class Bitmap(Object):
    """The pixels of an image file, without conversion: load(context, "picture.png")."""

    _kind = "shd_bitmap"

    def _parts(self):
        height, width, channels = self.pixels.shape
        return [f"{width}x{height}", f"{channels} channels of {self.pixels.dtype}", self.color_space]

    def __array__(self, dtype=None, copy=None):
        """The pixels, which are read-only unless they are converted."""
        made = self.pixels
        made = made if dtype is None else made.astype(dtype, copy=False)
        return made.copy() if copy else made

    @property
    def info(self):
        """File format, channels in the file and flags, as a dict."""
        return self._info("shd_bitmap_info")

    @property
    def color_space(self) -> str:
        """The colour space of the pixels, such as "sRGB"."""
        keep = []
        return _api.lib.shd_bitmap_get_color_space(self.handle(self._kind, keep)).decode("utf-8", "replace")

    @property
    def pixels(self) -> np.ndarray:
        """The pixels in place, as a read-only array [height][width][4], which keeps their memory."""
        out = _api.new("shd_image")
        keep = []
        _api.check(_api.lib.shd_bitmap_get_image(self.handle(self._kind, keep), ctypes.addressof(out)))
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
    keep, made = [], Bitmap.__new__(Bitmap)
    built = make_desc("shd_load_desc", desc, values).build(keep)
    handle, address = context.handle("shd_context", keep), ctypes.addressof(built)
    if is_bytes(source):
        raw = np.frombuffer(source, np.uint8)
        made._adopt(keep, _api.lib.shd_bitmap_load_memory, handle, raw.ctypes.data, raw.size, address)
    else:
        made._adopt(keep, _api.lib.shd_bitmap_load, handle, text_bytes(source, "path"), address, path=source)
    return made


def load_texture(context, source=None, desc=None, **values) -> Texture:
    """A texture from a file, or from the bytes of one: images, KTX2, DDS and OpenVDB by their content.

    Options are the fields of LoadDesc. Voxels have a layout: load_texture(context, "head.raw",
    raw={"width": 256, "height": 256, "depth": 113}); slices have files and no source: load_texture(context,
    stack={"paths": ["a.png", "b.png"]}), or {"pattern": "slice%03d.png", "first": 0, "last": 80}. `vdb` chooses a grid.
    `texture.file` is a dict of the contents of a KTX2 or DDS file, or of a grid with object_to_world as [4][4]; else
    None.
    """
    made, keep = Texture.__new__(Texture), []
    infos = {name: _api.new(struct) for name, struct in _INFOS.items()}
    built = make_desc("shd_load_desc", desc, values).build(keep)
    for name, info in infos.items():
        setattr(built, name, ctypes.addressof(info))
    handle, address = context.handle("shd_context", keep), ctypes.addressof(built)
    if is_bytes(source):
        raw = np.frombuffer(source, np.uint8)
        made._adopt(keep, _api.lib.shd_texture_load_memory, handle, raw.ctypes.data, raw.size, address)
    else:
        path = None if source is None else text_bytes(source, "path")
        made._adopt(keep, _api.lib.shd_texture_load, handle, path, address, path="" if source is None else source)
    made.file = None
    if infos["info"].kind:
        made.file = read_struct("shd_texture_file_info", infos["info"])
    elif infos["vdb_info"].object_to_world[15]:
        read = read_struct("shd_vdb_info", infos["vdb_info"])
        matrix = np.array(read["object_to_world"], np.float32).reshape(4, 4).T.copy()
        made.file = {**read, "grid": bytes(infos["vdb_info"].grid).split(b"\0")[0].decode("utf-8", "replace"),
                     "object_to_world": matrix}
    return made


_INFOS = {"info": "shd_texture_file_info", "vdb_info": "shd_vdb_info"}


def _built(struct, desc, values, keep):
    return ctypes.addressof(make_desc(struct, desc, values).build(keep))


def open_texture(context, path, cache, desc=None, **values) -> "tuple[Texture, dict]":
    """A texture whose tiles stay in a tiled TIFF or OpenEXR file, or a set such as "earth.<UDIM>.tx", until lookups need
    them, and a dict of its files. `cache` is a TileCache; options are the fields of TileFileDesc.
    """
    keep, info = [], _api.new("shd_tile_file_info")
    texture = Texture.__new__(Texture)
    built = _built("shd_tile_file_desc", desc, {**values, "cache": cache}, keep)
    texture._adopt(keep, lambda out: _api.lib.shd_texture_open(context.handle("shd_context", keep),
                                                               text_bytes(path, "path"), built, out,
                                                               ctypes.addressof(info)), path=path)
    return texture, read_struct("shd_tile_file_info", info)


def _with_opacity(picture):
    """An image as files have it: grey with opacity, grey floats and r, g, b become r, g, b, a."""
    array = split(picture, 2, "picture")
    if array.shape[2] == 1 and array.dtype.kind == "f":
        array = array.repeat(3, axis=2)
    if array.shape[2] == 2:
        return array[..., (0, 0, 0, 1)]
    if array.shape[2] == 3:
        full = np.iinfo(array.dtype).max if array.dtype.kind in "iu" else 1
        return np.append(array, np.full_like(array[..., :1], full), axis=2)
    return array


def save(picture, path, desc=None, srgb=False, **values) -> None:
    """Writes a framebuffer, or an image [height][width][channels], to the format of the extension.

    Options are the fields of SaveDesc: save(framebuffer, "frame.png", dither="ordered"). `srgb` marks arrays of uint8
    as encoded. A Texture becomes a KTX2 file with all its levels, with the options of Ktx2Desc.
    """
    keep = []
    if isinstance(picture, Texture):
        built = _built("shd_ktx2_desc", desc, values, keep)
        _api.check(_api.lib.shd_texture_save_ktx2(picture.handle("shd_texture", keep), text_bytes(path, "path"), built))
        return
    built = _built("shd_save_desc", desc, values, keep)
    if isinstance(picture, Framebuffer):
        call = _api.lib.shd_framebuffer_save, picture.handle("shd_framebuffer", keep, "picture")
    else:
        call = _api.lib.shd_image_save, ctypes.addressof(image(_with_opacity(picture), keep, "picture", srgb=srgb))
    _api.check(call[0](call[1], text_bytes(path, "path"), built))
