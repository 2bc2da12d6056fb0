# SPDX-License-Identifier: MIT
"""Textures and lookups."""
import ctypes

import numpy as np

from . import _api
from ._array import array_of
from ._callback import Callback, raise_failures
from ._convert import COLUMNS, address, column, columns, enum_value
from ._desc import desc_type, read_struct
from ._image import FACES, array_type, format_of, image, split
from ._objects import Object, counted, document, make_desc, read_columns, size_text

FLOAT = np.dtype("f4")


def end_of(array):
    """Address behind the last element of an array with positive strides."""
    return address(array) + sum((n - 1) * s for n, s in zip(array.shape, array.strides)) + array.itemsize


def check_padding(texels):
    """Lookups read whole vectors: borrowed texels lie inside a larger array."""
    whole = texels
    while isinstance(whole.base, np.ndarray):
        whole = whole.base
    padding = end_of(whole) - end_of(texels)
    if padding < _api.constants["SHD_TEXTURE_PADDING"]:
        raise ValueError(f"texture.texels: {padding} bytes behind the borrowed texels in their array, not "
                         f"{_api.constants['SHD_TEXTURE_PADDING']}")


def is_borrowed(built):
    """Whether a texture uses the texels of the caller in place."""
    return bool(built.flags & (_api.constant("SHD_TEXTURE_BORROW") | _api.constant("SHD_TEXTURE_BORROW_LEVELS")))


def texture_desc(desc, values):
    """The desc of a texture. A depth or a projection that is given without a kind decides the kind."""
    made = make_desc("shd_texture_desc", desc, values)
    given = [kind for name, kind in (("depth", "3d"), ("projection", "directions"))
             if made._values.get(name) is not None]
    if len(given) > 1 and "kind" not in made._values:
        raise ValueError("texture.kind: depth is of 3D textures and projection of directions; give the kind, too")
    made = made.replace(**{"kind": kind for kind in given} | made._values)
    return made.replace(layer_count=FACES) if is_cube(made) and made.layer_count == 1 else made


def is_kind(made, kind):
    return enum_value("shd_texture_kind", made.kind, "texture.kind") == _api.constant(f"SHD_TEXTURE_KIND_{kind}")


def is_cube(made):
    return is_kind(made, "DIRECTIONS") and enum_value(
        "shd_projection", made.projection, "texture.projection") == _api.constant("SHD_PROJECTION_CUBE")


def image_count(made):
    """The number of images of the base level: slices, faces or layers."""
    return made.depth if is_kind(made, "3D") else made.layer_count


def is_stack(made):
    """Whether the texels have an axis of images in front."""
    return is_cube(made) or is_kind(made, "3D") or "layer_count" in made._values


@document
class Texture(Object):
    """Texture(context, texels, srgb=False, tables="mipmap", ...).

    `texels` is an array [height][width] or [height][width][channels] of uint8, uint16, float16 or float32; float64
    becomes float32. It may be an image of Pillow or any object that NumPy reads. With `layer_count`, `depth` or
    projection="cube" it has one more axis in front, for layers, slices or faces. `depth` alone makes a texture of the
    kind "3d", and `projection` alone one of the kind "directions".
    """

    _kind = "shd_texture"

    def __init__(self, context, texels, desc=None, srgb=False, **values):
        keep = []
        made = texture_desc(desc, values)
        stacked = is_stack(made)
        built = made.build(keep)
        borrowed = is_borrowed(built)
        texels = split(texels, 3 if stacked else 2, "texture.texels", in_place=borrowed)
        if "format" not in made._values:
            built.format = format_of(texels, srgb, "texture.texels")
        if stacked and image_count(built) != texels.shape[0]:
            raise ValueError(f"texture.texels: {texels.shape[0]} images, not {image_count(built)}")
        built.height, built.width = texels.shape[-3:-1]
        built.row_stride = texels.strides[-3] if texels.shape[-3] > 1 else 0
        built.layer_stride = texels.strides[0] if stacked and texels.shape[0] > 1 else 0
        built.texels = address(texels)
        if borrowed:
            check_padding(texels)
        self._adopt(keep, _api.lib.shd_texture_create, context.handle("shd_context", keep), ctypes.addressof(built))
        if borrowed:  # the texels live as long as the texture
            self._reference.keep.append(texels)

    @classmethod
    def from_blocks(cls, context, levels, desc=None, **values):
        """A texture of compressed blocks of 4 x 4 texels: format, width and height are options.

        `levels` is a list of bytes, or of arrays of uint8: the base, and any number of mip levels below it. Each has
        the blocks of all layers, packed. The blocks are copied.
        """
        keep = []
        built = texture_desc(desc, values).build(keep)
        block = _api.lib.shd_format_block_size(built.format)
        if not block:
            name = _api.enum_type("shd_format")(built.format).name
            raise ValueError(f"texture.format: {name} has no compressed blocks")
        if not isinstance(levels, (list, tuple)) or not levels:
            raise TypeError("levels: a list of bytes, the base first")
        layers, stacks = image_count(built), []
        for level, blocks in enumerate(levels):
            bytes_of = np.frombuffer(blocks, np.uint8)
            width, height = max(1, built.width >> level), max(1, built.height >> level)
            size = -(-width // 4) * -(-height // 4) * block
            if bytes_of.size != layers * size:
                raise ValueError(f"levels[{level}]: {bytes_of.size} bytes, not {layers * size}")
            stacks.append((bytes_of, width, height, size))
        images = (type(_api.new("shd_image")) * max(1, layers * (len(stacks) - 1)))()
        for i in range(layers * (len(stacks) - 1)):
            layer, level = divmod(i, len(stacks) - 1)
            bytes_of, width, height, size = stacks[level + 1]
            made = _api.new("shd_image")
            made.format, made.width, made.height = built.format, width, height
            made.pixels = address(bytes_of) + layer * size
            images[i] = made
        built.texels, built.row_stride, built.layer_stride, built.flags = address(stacks[0][0]), 0, 0, 0
        built.tables = int(_api.enum_type("shd_table").MIPMAP) if len(stacks) > 1 else 0
        built.level_images, built.level_count = ctypes.addressof(images), len(stacks) - 1
        self = cls.__new__(cls)
        self._adopt(keep, _api.lib.shd_texture_create, context.handle("shd_context", keep), ctypes.addressof(built))
        return self

    @classmethod
    def from_tiles(cls, context, cache, load, desc=None, **values):
        """A texture whose tiles are written by load(tiles) when a lookup first needs them: format, width and height are
        options.

        `tiles` is a list of tiles with layer, level, area with x, y, width, height, and `texels`, an array
        [height][width][channels] to fill. `load` runs on any thread. The call that needed the tiles raises the
        exception of `load`, and the next one calls `load` again.
        """
        from ._tiles import loader
        keep = []
        made = texture_desc(desc, values)
        texel_format = made.build([]).format
        made = made.replace(tiles={"cache": cache, "load": loader(load, texel_format)})
        built = made.build(keep)
        self = cls.__new__(cls)
        self._adopt(keep, _api.lib.shd_texture_create, context.handle("shd_context", keep), ctypes.addressof(built))
        cache._loads.update(k for k in keep if isinstance(k, Callback))
        return self

    def _region(self, function, region):
        keep = []
        built = desc_type("shd_tile_region")(**region).build(keep)
        result = function(self.handle("shd_texture", keep), ctypes.addressof(built))
        if result:
            raise_failures(keep)
            _api.check(result)

    def load_tiles(self, **region):
        """Loads the tiles of a region: level, layer, and area={"x": 0, "y": 0, "width": 64, "height": 64}, as in
        TileRegion."""
        self._region(_api.lib.shd_texture_load_tiles, region)

    def pin_tiles(self, **region):
        """Loads the tiles of a region and keeps them until unpin_tiles()."""
        self._region(_api.lib.shd_texture_pin_tiles, region)

    def unpin_tiles(self, **region):
        """Undoes one pin_tiles() of the same region."""
        self._region(_api.lib.shd_texture_unpin_tiles, region)

    def drop_tiles(self, **region):
        """Drops the tiles of a region and the coarser tiles above it, because their source has changed."""
        self._region(_api.lib.shd_texture_drop_tiles, region)

    def _parts(self):
        info = self.info
        stack = [f"{info[name]} {noun}" for name, noun in (("depth", "slices"), ("layer_count", "layers"))
                 if info[name] > 1]
        return [*size_text(info, info["format"]), *stack, counted(info["level_count"], "level")]

    def __array__(self, dtype=None, copy=None):
        """The texels of the base level as a new array, with an axis for layers or slices if there are several."""
        if copy is False:
            raise ValueError("texture: its array is a copy")
        info = self.info
        count = max(info["depth"], info["layer_count"])
        made = self.read_level() if count == 1 else np.stack([self.read_level(0, i) for i in range(count)])
        return made if dtype is None else made.astype(dtype, copy=False)

    @property
    def info(self):
        """Size, format and memory, as a dict."""
        return self._info("shd_texture_info")

    def lookup(self, sampler, u, v, out, **more):
        """A batch of lookups that can run many times: see Lookup."""
        return Lookup(self, sampler, u, v, out, **more)

    def sample(self, sampler, u, v, channels=4, out=None, **more):
        """Filtered values at (u, v), as an array [..., channels] of float32.

        Other columns are those of shd_lookups: dudx, dvdx, dudy, dvdy, lod, layer, random, w, dwdx, dwdy, reference.
        `out` is an array of that shape to write to, or a list of columns with None for unwanted ones.
        """
        made = Lookup.__new__(Lookup)
        if out is not None:
            made._prepare(self, sampler, u, v, out, more)
            made()
            return out
        u = array_of(u, "u")
        planes = np.empty((channels, *u.shape), np.float32)  # packed columns are the fastest
        made._prepare(self, sampler, u, v, planes.reshape(channels, -1).T, more)
        made()
        return np.moveaxis(planes, 0, -1)

    def levels(self, sampler, u, v, **more):
        """Levels of detail of trilinear filtering at (u, v)."""
        keep, out = [], _api.new("shd_levels")
        lookups = _lookups(u, v, more, keep)
        lod = np.empty(lookups.count, np.float32)
        out.lod.data = address(lod)
        _api.check(_api.lib.shd_texture_query_levels(self.handle("shd_texture", keep),
                                                     sampler.handle("shd_sampler", keep, "sampler"),
                                                     ctypes.addressof(lookups), ctypes.addressof(out)))
        return lod.reshape(np.shape(u))

    def read_level(self, level=0, layer=0):
        """A copy of one mip level of a layer or slice, as stored."""
        info, keep = self.info, []
        dtype, channels = array_type(info["format"])
        texels = np.empty((max(1, info["height"] >> level), max(1, info["width"] >> level), channels), dtype)
        made = image(texels, keep, texel_format=int(info["format"]))
        _api.check(_api.lib.shd_texture_read_level(self.handle("shd_texture", keep), layer, level,
                                                   ctypes.addressof(made)))
        return texels

    def _table(self, table, values, keep):
        return (self.handle("shd_texture", keep),
                ctypes.addressof(desc_type("shd_table_desc")(table=table, **values).build(keep)))

    def table_info(self, table, **values):
        """Size and levels of what read_table() returns, as a dict. Options are those of TableDesc."""
        keep, out = [], _api.new("shd_table_info")
        _api.check(_api.lib.shd_texture_get_table_info(*self._table(table, values, keep), ctypes.addressof(out)))
        return read_struct("shd_table_info", out)

    def read_table(self, table, **values):
        """A level, the sums or the picture of a table as linear r, g, b, a: an array [height][width][4] of float32.

        texture.read_table("ripmap", view="picture"). Options are those of TableDesc: view, layer, level_u, level_v.
        """
        keep, info = [], self.table_info(table, **values)
        out = np.empty((info["height"], info["width"], 4), np.float32)
        return read_columns(_api.lib.shd_texture_read_table, self._table(table, values, keep), out)

    def update(self, texels, x=0, y=0, layer=0):
        """Writes a rectangle of the base level, and rebuilds the tables that depend on it. No other call may use the
        texture concurrently."""
        keep = []
        srgb = self.info["format"].name.endswith("_SRGB")
        made = image(texels, keep, "texels", srgb=srgb)
        _api.check(_api.lib.shd_texture_update(self.handle("shd_texture", keep), layer, x, y, ctypes.addressof(made)))


_LOOKUP_COLUMNS = {f["name"]: f["type"] for f in _api.structs["shd_lookups"]["fields"] if f["type"] in COLUMNS}


def _lookups(u, v, more, keep, in_place=False):
    """A shd_lookups over columns of one length."""
    lookups, sizes = _api.new("shd_lookups"), {}
    for name, value in (("u", u), ("v", v), *more.items()):
        if name not in _LOOKUP_COLUMNS:
            raise TypeError(f"lookups have no column {name}; there are {', '.join(_LOOKUP_COLUMNS)}")
        if value is not None:
            target = getattr(lookups, name)
            target.data, target.stride, sizes[name] = column(value, *COLUMNS[_LOOKUP_COLUMNS[name]], name, keep,
                                                               in_place)
    lookups.count = sizes["u"]
    if any(size != lookups.count for size in sizes.values()):
        raise ValueError("lookups: the columns have different lengths: " +
                         ", ".join(f"{k} {n}" for k, n in sizes.items()))
    return lookups


class Lookup:
    """A batch of lookups, prepared once. Calling it reads the arrays in place and writes `out` anew, so arrays of other
    types are refused.

    `out` is an array [count][channels] of float32, or a list of columns for r, g, b, a. The arrays, texture and sampler
    stay in use as long as the Lookup lives. `nonfinite_count` belongs to the latest call.
    """

    def __init__(self, texture, sampler, u, v, out, **more):
        self._prepare(texture, sampler, u, v, out, more, in_place=True)

    def _prepare(self, texture, sampler, u, v, out, more, in_place=False):
        keep = self._keep = []
        self._lookups = _lookups(u, v, more, keep, in_place)
        self._texels = _api.new("shd_texels")
        if isinstance(out, np.ndarray):
            out = [out] if out.ndim == 1 else columns(out, out.shape[-1], "out", True)
        if len(out) > len(self._texels.channel):
            raise ValueError(f"out: {len(out)} columns, not 1 to 4")
        for target, item in zip(self._texels.channel, out):
            if item is not None:
                target.data, target.stride, size = column(item, FLOAT, True, "out", keep)
                if size != self._lookups.count:
                    raise ValueError(f"out: {size} rows for {self._lookups.count} lookups")
        self._function = _api.lib.shd_texture_sample
        self._arguments = (texture.handle("shd_texture", keep, "texture"),
                           sampler.handle("shd_sampler", keep, "sampler"),
                           ctypes.addressof(self._lookups), ctypes.addressof(self._texels))

    def __call__(self):
        result = self._function(*self._arguments)
        if result:
            raise_failures(self._keep)
            _api.check(result)

    @property
    def nonfinite_count(self):
        return self._texels.nonfinite_count
