# SPDX-License-Identifier: MIT
"""Textures of compressed blocks."""
import numpy as np

import shd
from support import Case

BC1 = bytes([0x00, 0xf8, 0x1f, 0x00, 0xe4, 0, 0, 0])  # the first row is red, blue, and two colours between them
BC7 = bytes([192, 255, 159, 66, 1, 0, 254, 255, 1, 0, 0, 0, 0, 0, 0, 0])  # mode 6, one colour


class Blocks(Case):
    def sample(self, texture, u, v, **values):
        return texture.sample(shd.Sampler(self.context, filter="nearest", **values), np.float32(u), np.float32(v)) * 255

    def test_values(self):
        texture = shd.Texture.from_blocks(self.context, [BC1], format="bc1_rgb", width=4, height=4)
        row = self.sample(texture, [0.125, 0.375, 0.625, 0.875], [0.125] * 4)
        np.testing.assert_allclose(row, [[255, 0, 0, 255], [0, 0, 255, 255], [170, 0, 85, 255], [85, 0, 170, 255]],
                                   rtol=1e-6)
        texture = shd.Texture.from_blocks(self.context, [BC7], format="bc7", width=3, height=1)
        np.testing.assert_allclose(self.sample(texture, [0.5], [0.5]), [[255, 41, 1, 255]], rtol=1e-6)

    def test_levels_and_layers(self):
        blank = bytes(16)  # reserved: transparent black
        texture = shd.Texture.from_blocks(self.context, [blank * 2 + BC7 * 2, bytearray(blank + BC7)], format="bc7",
                                          width=8, height=4, layer_count=2)
        self.assertEqual(texture.info["level_count"], 2)
        sampler = shd.Sampler(self.context, filter="nearest_mip")
        out = texture.sample(sampler, np.float32([0.5] * 4), np.float32([0.5] * 4), lod=np.float32([0, 1, 0, 1]),
                             layer=np.uint32([0, 0, 1, 1]))
        np.testing.assert_allclose(out[:, 1] * 255, [0, 0, 41, 41], rtol=1e-6)

    def test_refused(self):
        make = lambda levels, **values: shd.Texture.from_blocks(
            self.context, levels, **{"format": "bc7", "width": 8, "height": 4, **values})
        for kind, message, levels, values in (
                (ValueError, r"levels\[0\]: 31 bytes, not 32", [(BC7 * 2)[:31]], {}),
                (ValueError, r"levels\[1\]: 32 bytes, not 16", [BC7 * 2, BC7 * 2], {}),
                (ValueError, r"levels\[0\]: 32 bytes, not 64", [BC7 * 2], {"layer_count": 2}),
                (ValueError, "texture.format: RGBA8 has no compressed blocks", [BC7], {"format": "rgba8"}),
                (TypeError, "levels: a list of bytes", BC7, {})):
            self.check_refused(kind, message, make, levels, **values)
