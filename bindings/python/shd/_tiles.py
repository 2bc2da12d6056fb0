# SPDX-License-Identifier: MIT
"""Tile caches, and the tiles that callbacks fill."""
import ctypes
import weakref

import numpy as np

from . import _api
from ._callback import raise_failures
from ._image import array_type
from ._objects import _Simple, document


class Tile:
    """A tile to fill: layer, level, and area with x, y, width and height as in shd_tile, and `texels`, a writable array
    [height][width][channels]. The cache takes the texels when the callback returns."""

    def __init__(self, tile, dtype, channels):
        self.layer, self.level = tile.layer, tile.level
        self.area = area = type(tile.area).from_buffer_copy(tile.area)  # the tile is the library's
        size = tile.row_stride * (area.height - 1) + area.width * channels * dtype.itemsize
        self._memory = np.ndarray((area.height, area.width, channels), dtype,
                                  (ctypes.c_char * size).from_address(tile.texels), 0,
                                  (tile.row_stride, channels * dtype.itemsize, dtype.itemsize))
        self.texels = np.zeros(self._memory.shape, dtype)


def loader(load, texel_format):
    """The callback of C for load(tiles), where `tiles` is a list of Tile."""
    if not callable(load):
        raise TypeError(f"load: {type(load).__name__} is not callable")
    kind = _api.struct_type("shd_tile")

    def run(tiles, count):
        made = [Tile(tile, *array_type(texel_format)) for tile in (kind * count).from_address(tiles)]
        try:
            load(list(made))
            for tile in made:
                tile._memory[...] = tile.texels
        finally:
            for tile in made:
                del tile._memory

    return run


@document
class TileCache(_Simple):
    """TileCache(context, budget_bytes=1 << 28, tile_bytes=65536). See Texture.from_tiles() and io.open_texture()."""

    _kind = "shd_tile_cache"

    def __init__(self, *arguments, **values):
        super().__init__(*arguments, **values)
        self._loads = weakref.WeakSet()  # callbacks of the textures of this object

    @property
    def stats(self):
        """Counters since the creation, as a dict."""
        return self._info("shd_tile_cache_stats", "shd_tile_cache_get_stats")

    def load_requested(self, max_tiles=0):
        """Loads tiles that lookups with missing_tiles="coarser" did not find, and returns their number."""
        keep, loaded = list(self._loads), ctypes.c_size_t()
        result = _api.lib.shd_tile_cache_load_requested(self.handle(self._kind, keep), max_tiles,
                                                        ctypes.addressof(loaded))
        if result:
            raise_failures(keep)
            _api.check(result)
        return loaded.value
