# SPDX-License-Identifier: MIT
"""Textures in tile caches."""
import gc
import pathlib
import unittest
import weakref

import numpy as np

import shd
from shd import _api, io
from support import Case, require_component

WIDTH, HEIGHT = 100, 70
REGION = {"level": 1, "area": {"width": 50, "height": 35}}


class Source:
    """Levels of a texture in memory as tiles. `problem` is raised in place of the next tiles."""

    def __init__(self, memory):
        self.levels = [memory.read_level(level) for level in range(memory.info["level_count"])]
        self.calls, self.tiles, self.problem, self.kept = 0, 0, None, None

    def __call__(self, tiles):
        self.calls, self.tiles = self.calls + 1, self.tiles + len(tiles)
        if self.problem:
            problem, self.problem = self.problem, None
            raise problem
        for tile in tiles:
            a = tile.area
            tile.texels[...] = self.levels[tile.level][a.y:a.y + a.height, a.x:a.x + a.width]
        self.kept = tiles


class Tiles(Case):
    def setUp(self):
        random = np.random.default_rng(1)
        self.memory = shd.Texture(self.context, random.integers(0, 256, (HEIGHT, WIDTH, 4)).astype(np.uint8),
                                  tables="mipmap")
        self.u, self.v, self.lod = (random.uniform(0, top, 500).astype(np.float32) for top in (1, 1, 6))
        self.source = Source(self.memory)
        self.cache = shd.TileCache(self.context, tile_bytes=1024, budget_bytes=1 << 20)
        self.texture = self.make()

    def make(self, **values):
        return shd.Texture.from_tiles(self.context, self.cache, self.source, **{
            "format": "rgba8", "width": WIDTH, "height": HEIGHT, "tables": "mipmap", **values})

    def sample(self, texture, **values):
        return texture.sample(shd.Sampler(self.context, filter="trilinear", **values), self.u, self.v, lod=self.lod)

    def test_bits(self):
        """The bits are those of the texture in memory, and the calls are those that the cache counts."""
        np.testing.assert_array_equal(self.sample(self.texture), self.sample(self.memory))
        stats = self.cache.stats
        self.assertEqual((stats["load_count"], stats["loaded_tile_count"], stats["failed_tile_count"]),
                         (self.source.calls, self.source.tiles, 0))
        self.assertEqual(stats["resident_tile_count"], self.source.tiles)
        self.sample(self.texture)
        self.assertEqual(self.cache.stats["load_count"], stats["load_count"])
        self.source.kept[0].texels[...] = 99  # the array belongs to the function, not to the cache
        np.testing.assert_array_equal(self.sample(self.texture), self.sample(self.memory))

    def test_exception(self):
        """The call that needed the tiles raises, and the next one loads them."""
        for call in (self.sample, lambda t: t.load_tiles(**REGION), lambda t: t.pin_tiles(**REGION)):
            texture = self.make()
            self.source.problem = ZeroDivisionError("no tile")
            self.check_refused(ZeroDivisionError, "no tile", call, texture)
            np.testing.assert_array_equal(self.sample(texture), self.sample(self.memory))
        self.assertGreater(self.cache.stats["failed_tile_count"], 2)

    def test_requested(self):
        """Lookups that do not wait call nothing; the function runs in load_requested(), which raises its exception."""
        self.assertFalse(self.sample(self.texture, missing_tiles="coarser").any())
        self.assertEqual(self.source.calls, 0)
        self.source.problem = KeyError("no tile")
        self.check_refused(KeyError, "no tile", self.cache.load_requested)
        loaded = 0
        while self.sample(self.texture, missing_tiles="coarser") is not None and (more := self.cache.load_requested(8)):
            loaded += more
        self.assertEqual((loaded, self.cache.stats["requested_tile_count"]), (self.cache.stats["loaded_tile_count"], 0))
        np.testing.assert_array_equal(self.sample(self.texture, missing_tiles="coarser"), self.sample(self.memory))

    def test_regions(self):
        self.texture.pin_tiles(**REGION)
        self.assertEqual(self.cache.stats["pinned_tile_count"], 4 * 3)
        self.texture.unpin_tiles(**REGION)
        self.assertEqual(self.cache.stats["pinned_tile_count"], 0)
        self.check_refused(shd.InvalidArgument, "pinned", self.texture.unpin_tiles, **REGION)
        calls = self.source.calls
        self.texture.load_tiles(**REGION)
        self.assertEqual(self.source.calls, calls)
        self.source.levels[1] = 255 - self.source.levels[1]
        self.texture.drop_tiles(**REGION)
        changed = self.texture.sample(shd.Sampler(self.context, filter="nearest_mip"), np.float32([0.01]),
                                      np.float32([0.01]), lod=np.float32([1]))
        np.testing.assert_array_equal(np.rint(changed * 255)[0], self.source.levels[1][0, 0])

    def test_lifetime(self):
        """A closure lives as long as the texture has an owner."""
        material = shd.Material(self.context, model="unlit", slots=[shd.slot("diffuse", self.texture)])
        alive, self.source = weakref.ref(self.source), None
        self.texture = None
        self.cache.close()
        gc.collect()
        self.assertIsNotNone(alive())
        del material
        gc.collect()
        self.assertIsNone(alive())

    def test_refused(self):
        for kind, message, values in (
                (shd.Error, "texture.format", {"format": "rgb8"}), (shd.Error, "layer_count", {"layer_count": 0}),
                (TypeError, "no field size", {"size": 3})):
            self.check_refused(kind, message, self.make, **values)
        self.check_refused(TypeError, "cache: Sampler, not TileCache", shd.Texture.from_tiles, self.context,
                           shd.Sampler(self.context), self.source, format="r8", width=1, height=1)
        self.check_refused(TypeError, "load: NoneType is not callable", shd.Texture.from_tiles, self.context, self.cache,
                           None, format="r8", width=1, height=1)
        self.check_refused(shd.Error, "budget_bytes: 1 is not", shd.TileCache, self.context, budget_bytes=1)
        self.check_refused(shd.Error, "in tiles|tiles", self.memory.load_tiles, **REGION)
        self.check_refused(TypeError, "no field left", self.texture.load_tiles, left=1)

    def test_file(self):
        require_component("shd_io")
        path = pathlib.Path(__file__).resolve().parents[2] / "tiled.tif"
        if not path.exists():
            self.skipTest(f"{path} is absent: the tests of a wheel, which reads no TIFF")
        texture, info = io.open_texture(self.context, path, self.cache, encoding="linear")
        self.assertEqual(info, {"column_count": 1, "row_count": 1, "file_count": 1, "tile_width": 16,
                                "tile_height": 16})
        memory = shd.Texture(self.context, np.arange(256, dtype=np.uint8).reshape(16, 16))
        sampler = shd.Sampler(self.context)
        np.testing.assert_array_equal(texture.sample(sampler, self.u, self.v), memory.sample(sampler, self.u, self.v))
        self.check_refused(shd.Error, "nothing.tif", io.open_texture, self.context, "nothing.tif", self.cache)
        self.check_refused(TypeError, "tile_file.cache: int, not TileCache|cache", io.open_texture, self.context, path, 3)


class Descs(unittest.TestCase):
    def test_kinds(self):
        """Every sized struct that is not the library's has a kind, and defaults with its size."""
        for name, struct in _api.structs.items():
            fields = struct["fields"]
            if fields[0]["name"] == "struct_size" and "size of the library's" not in fields[0].get("doc", ""):
                self.assertEqual(_api.new(name).struct_size, struct["size"], name)
