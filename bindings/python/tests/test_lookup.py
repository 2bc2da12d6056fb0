# SPDX-License-Identifier: MIT
"""Lookups: values, arrays in place, and arrays that do not fit."""
import numpy as np

import shd
from support import Case


class Lookups(Case):
    def setUp(self):
        self.texture = self.checker()
        self.sampler = shd.Sampler(self.context, filter="bilinear", wrap_u="clamp", wrap_v="clamp")

    def test_values(self):
        u, v = np.float32([0.25, 0.5, 0.75]), np.float32([0.25, 0.5, 0.25])
        out = self.texture.sample(self.sampler, u, v)
        self.assertEqual(out.shape, (3, 4))
        np.testing.assert_array_equal(out[:, 0], [0, 0.5, 1])
        np.testing.assert_array_equal(out[:, 3], 1)

    def test_shapes(self):
        v, u = np.mgrid[0:4, 0:6].astype(np.float32) / 6
        out = self.texture.sample(self.sampler, u, v, channels=2)
        self.assertEqual(out.shape, (4, 6, 2))
        flat = self.texture.sample(self.sampler, u.reshape(-1), v.reshape(-1), channels=2)
        np.testing.assert_array_equal(out.reshape(-1, 2), flat)
        self.assertEqual(self.texture.sample(self.sampler, [0.5], [0.5]).shape, (1, 4))

    def test_strides(self):
        records = np.zeros(5, [("u", "f4"), ("id", "u4"), ("v", "f4"), ("red", "f4")])
        records["u"], records["v"], records["id"] = np.linspace(0, 1, 5), 0.25, 7
        every = np.linspace(0, 1, 9, dtype=np.float32)[::2]
        expected = self.texture.sample(self.sampler, every.copy(), np.full(5, 0.25, np.float32), channels=1)
        self.texture.lookup(self.sampler, records["u"], records["v"], records["red"])()
        np.testing.assert_array_equal(records["red"], expected[:, 0])
        np.testing.assert_array_equal(records["id"], 7)
        out = np.full((5, 4), -1, np.float32)
        self.assertIs(self.texture.sample(self.sampler, every, records["v"], out=out[:, 1:3])[0].base, out)
        np.testing.assert_array_equal(out[:, 1], expected[:, 0])
        np.testing.assert_array_equal(out[:, [0, 3]], -1)

    def test_prepared(self):
        u, v, out = np.float32([0.25]), np.float32([0.25]), np.empty((1, 1), np.float32)
        lookup = self.texture.lookup(self.sampler, u, v, out)
        for value, expected in ((0.25, 0), (0.75, 1)):
            u[0] = value
            lookup()
            self.assertEqual(out[0, 0], expected)
        u[0] = np.nan
        lookup()
        self.assertEqual(lookup.nonfinite_count, 1)
        self.texture.close()
        self.sampler.close()
        lookup()  # keeps both

    def test_refused(self):
        u, v = np.zeros(4, np.float32), np.zeros(4, np.float32)
        look = lambda **values: self.texture.sample(self.sampler, **{"u": u, "v": v, **values})
        for kind, message, values in (
                (TypeError, "u: the array is of complex128, not of numbers|array of numbers", {"u": u.astype(complex)}),
                (TypeError, "u: the array is of bool, not of numbers", {"u": u > 0}),
                (TypeError, "u: an array of numbers, not str", {"u": "half"}),
                (TypeError, "u: an array of numbers, not list", {"u": [[0.5], [0.5, 1]]}),
                (TypeError, "layer: integers, not float64", {"layer": np.zeros(4)}),
                (ValueError, r"layer\[2\]: -1 is not in 0..4294967295", {"layer": [0, 0, -1, 0]}),
                (ValueError, "different lengths: u 4, v 3", {"v": v[:3]}),
                (ValueError, "lod 1", {"lod": [0.5]}),
                (TypeError, "no column dx; there are u, v, w, dudx", {"dx": u}),
                (ValueError, "out: 3 rows for 4 lookups", {"out": np.zeros((3, 4), np.float32)}),
                (ValueError, "out: 5 columns, not 1 to 4", {"out": np.zeros((4, 5), np.float32)}),
                (TypeError, "out: a NumPy array of float32, not list", {"out": [[0.0]]}),
                (TypeError, "out: the array is of float64", {"out": np.zeros((4, 4))}),
                (shd.InvalidArgument, "overlap", {"out": [u]})):
            with self.subTest(message):
                self.check_refused(kind, message, look, **values)
        out = np.zeros((4, 4), np.float32)
        out.flags.writeable = False
        self.check_refused(ValueError, "out: the array is read-only", look, out=out)
        misaligned = np.frombuffer(bytearray(65), np.uint8)[1:].view(np.float32).reshape(4, 4)
        self.check_refused(ValueError, "not aligned to 4 bytes", look, out=misaligned)
        self.check_refused(TypeError, "sampler: Texture, not Sampler", self.texture.sample, self.texture, u, v)

    def test_levels(self):
        texture = shd.Texture(self.context, np.zeros((8, 8), np.float32), tables="mipmap")
        half = np.float32([0.5])
        levels = texture.levels(shd.Sampler(self.context, profile="exact"), half, half, dudx=half, dvdy=half)
        self.assertAlmostEqual(float(levels[0]), 2.0, places=5)


class Textures(Case):
    def test_formats(self):
        for dtype, channels, srgb, name in (
                ("u1", 1, False, "R8"), ("u1", 4, True, "RGBA8_SRGB"), ("u2", 2, False, "RG16"),
                ("f2", 4, False, "RGBA16F"), ("f4", 1, False, "R32F")):
            scale = 255 / 32 if dtype == "u1" else 1 / 32
            texels = (np.arange(6 * channels).reshape(2, 3, channels) * scale).astype(dtype)
            texture = shd.Texture(self.context, texels, srgb=srgb)
            info = texture.info
            self.assertEqual((info["format"].name, info["width"], info["height"]), (name, 3, 2))
            np.testing.assert_array_equal(texture.read_level(), texels)

    def test_rows_apart(self):
        whole = np.arange(32, dtype=np.uint8).reshape(4, 8)
        texture = shd.Texture(self.context, whole[1:3, 2:6])
        np.testing.assert_array_equal(texture.read_level()[..., 0], whole[1:3, 2:6])
        flipped = shd.Texture(self.context, np.ascontiguousarray(whole[::-1]))
        np.testing.assert_array_equal(flipped.read_level()[..., 0], whole[::-1])

    def test_layers_and_slices(self):
        texels = np.arange(24, dtype=np.float32).reshape(2, 3, 4)
        layers = shd.Texture(self.context, texels, layer_count=2)
        np.testing.assert_array_equal(layers.read_level(layer=1)[..., 0], texels[1])
        slices = shd.Texture(self.context, texels, depth=2)
        sampler = shd.Sampler(self.context, filter="nearest")
        u = np.float32([0.1])
        out = slices.sample(sampler, u, u, w=np.float32([0.75]), channels=1)
        self.assertEqual(out[0, 0], texels[1, 0, 0])

    def test_kinds(self):
        """A depth or a projection without a kind decides the kind; of a cube each face has a texel of its own."""
        faces = np.arange(6, dtype=np.float32).reshape(6, 1, 1, 1)
        axes = np.float32([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]])
        sampler = shd.Sampler(self.context, filter="nearest")
        for values in ({}, {"kind": "directions"}, {"kind": shd.TextureKind.DIRECTIONS}):
            cube = shd.Texture(self.context, faces, projection="cube", **values)
            self.assertEqual((cube.info["kind"], cube.info["layer_count"]), (shd.TextureKind.DIRECTIONS, 6))
            found = cube.sample(sampler, axes[:, 0], axes[:, 1], w=axes[:, 2].copy(), channels=1)
            np.testing.assert_array_equal(found[:, 0], range(6))
        for texels, values, kind, info in (
                (faces, {"depth": 6}, "N3D", {"depth": 6, "layer_count": 1}),
                (faces, {"depth": 6, "kind": "3d"}, "N3D", {"depth": 6}),
                (faces[:1], {"depth": 1}, "N3D", {"depth": 1}),
                (faces, {"layer_count": 6}, "N2D", {"depth": 0, "layer_count": 6}),
                (faces[0], {}, "N2D", {"layer_count": 1}),
                (faces, {"projection": "lat_long", "layer_count": 6}, "DIRECTIONS", {"layer_count": 6})):
            with self.subTest(values):
                made = shd.Texture(self.context, texels, **values).info
                self.assertEqual((made["kind"].name, {k: made[k] for k in info}), (kind, info))
        levels = [np.full((1, 1), 10 + i, np.float32) for i in range(6)]
        cube = shd.Texture(self.context, np.zeros((6, 2, 2), np.float32), projection="cube", tables="mipmap",
                           level_images=levels)
        self.assertEqual([float(cube.read_level(1, i).item()) for i in range(6)], [10, 11, 12, 13, 14, 15])
        for kind, message, values in (
                (ValueError, "depth is of 3D textures and projection of directions; give the kind",
                 {"depth": 6, "projection": "cube"}),
                (ValueError, "6 images, not 5", {"depth": 5}),
                (ValueError, "4 axes, not 2 or 3", {"projection": "lat_long"}),
                (ValueError, "'4d' is none of 2d, 3d, directions", {"kind": "4d"}),
                (ValueError, "6 images, not 0", {"kind": "3d"})):
            with self.subTest(message):
                self.check_refused(kind, message, lambda: shd.Texture(self.context, faces, **values))
        self.check_refused(shd.InvalidArgument, "projection", shd.Texture, self.context, faces[0], projection="none")

    def test_tables(self):
        texels = np.float32([[1, 3, 5, 7], [2, 4, 6, 8]])
        texture = shd.Texture(self.context, texels, tables="mipmap|ripmap|summed_area")
        np.testing.assert_array_equal(texture.read_table("ripmap", level_u=1)[..., 0], [[2, 6], [3, 7]])
        np.testing.assert_array_equal(texture.read_table("summed_area")[..., 0],
                                      np.pad(texels.cumsum(0).cumsum(1), ((1, 0), (1, 0))))
        picture = texture.read_table(shd.Table.MIPMAP, view="picture")
        info = texture.table_info("mipmap", view="picture", level_u=2, level_v=2)
        self.assertEqual((picture.shape, info["level_count_u"], info["x"], info["y"]), ((2, 6, 4), 3, 4, 1))
        np.testing.assert_array_equal(picture[..., 0], [[1, 3, 5, 7, 2.5, 6.5], [2, 4, 6, 8, 4.5, 0]])
        self.check_refused(shd.InvalidArgument, "table.level_v: 1 is not in 0..0", texture.read_table, "summed_area",
                           level_v=1)

    def test_update(self):
        texture = shd.Texture(self.context, np.zeros((4, 4, 4), np.uint8), srgb=True)
        texture.update(np.full((2, 1, 4), 9, np.uint8), x=1, y=2)
        self.assertEqual(int(texture.read_level().sum()), 2 * 4 * 9)

    def test_borrowed(self):
        texels = np.zeros(4 * 4 + 32, np.float32)[:16].reshape(4, 4)
        texture = shd.Texture(self.context, texels, flags="borrow")
        del texels  # the texture keeps them
        self.assertEqual(texture.read_level().sum(), 0)
        self.check_refused(ValueError, "0 bytes behind the borrowed texels in their array, not 128", shd.Texture,
                           self.context, np.zeros((4, 4), np.float32), flags="borrow")

    def test_premultiplied(self):
        """Flags that borrow nothing leave all kinds of texels to be copied."""
        texels = np.full((4, 4, 4), 51, np.uint8)
        for made, kind in ((texels, "RGBA8"), (texels / 255, "RGBA32F"), (texels.tolist(), None),
                           (memoryview(texels), "RGBA8"), (texels[::-1], "RGBA8")):
            if kind is None:
                self.check_refused(TypeError, "of int64, not uint8", shd.Texture, self.context, made,
                                   flags="premultiplied")
                continue
            texture = shd.Texture(self.context, made, flags="premultiplied")
            self.assertEqual(texture.info["format"].name, kind)
            np.testing.assert_array_equal(texture.read_level(), np.asarray(made, texture.read_level().dtype))

    def test_levels(self):
        """The caller's levels of two layers: two images for each level."""
        base, levels = np.zeros((2, 4, 4), np.float32), [np.full((2, 2), i, np.float32) for i in (1, 2)]
        texture = shd.Texture(self.context, base, layer_count=2, tables="mipmap", level_images=levels)
        self.assertEqual(texture.info["level_count"], 2)
        np.testing.assert_array_equal(texture.read_level(1, 1)[..., 0], levels[1])
        self.check_refused(ValueError, "3 elements for 2 layer_count", shd.Texture, self.context, base, layer_count=2,
                           tables="mipmap", level_images=[*levels, levels[0]])

    def test_refused(self):
        make = lambda texels, **values: shd.Texture(self.context, texels, **values)
        for kind, message, texels, values in (
                (TypeError, "of int64, not uint8, uint16, float16, float32; .astype.numpy.uint8. converts", [[0]], {}),
                (TypeError, "of float64, not uint8, uint16, float16, float32; .astype.numpy.float32. converts it$",
                 np.zeros((2, 2)), {"flags": "borrow"}),
                (TypeError, "array of numbers, not str", "wood.png", {}),
                (TypeError, "of bool, not uint8, uint16, float16, float32$", np.zeros((2, 2), bool), {}),
                (ValueError, "16 channels, not 1 to 4; images are .height..width..channels.; numpy.moveaxis",
                 np.zeros((3, 16, 16), np.uint8), {}),
                (ValueError, "5 channels, not 1 to 4; images are .height..width..channels.",
                 np.zeros((2, 2, 5), np.uint8), {}),
                (ValueError, "1 axes, not 2 or 3", np.zeros(4, np.uint8), {}),
                (ValueError, "rows in order with packed", np.zeros((4, 4), np.uint8)[::-1], {"flags": "borrow"}),
                (TypeError, "a NumPy array, not list", [[0.5]], {"flags": "borrow"}),
                (ValueError, "is empty", np.zeros((0, 4), np.uint8), {}),
                (TypeError, "sRGB texels are of uint8", np.zeros((2, 2), np.float32), {"srgb": True}),
                (ValueError, "2 images, not 3", np.zeros((2, 2, 2), np.uint8), {"layer_count": 3}),
                (ValueError, "'mip' is none of none, mipmap", np.zeros((2, 2), np.uint8), {"tables": "mip"}),
                (TypeError, "no field table; did you mean tables", np.zeros((2, 2), np.uint8), {"table": "mipmap"})):
            with self.subTest(message):
                self.check_refused(kind, message, make, texels, **values)
        self.check_refused(TypeError, "the array is of int64", self.checker().update, [[1]])
        self.check_refused(shd.Error, "texels|format", self.checker().update, np.zeros((1, 1), np.uint8))
