# SPDX-License-Identifier: MIT
"""Textures and samplers of shd.pyrender."""
import numpy as np

from .._array import pixels_of
from ._checked import Checked, Shown, anything, codes, finite, instance_of, text
from .constants import GLTF

WRAPS = {GLTF.REPEAT: "repeat", GLTF.CLAMP_TO_EDGE: "clamp", GLTF.MIRRORED_REPEAT: "mirror"}
FILTERS = {None: "anisotropic", GLTF.NEAREST: "nearest", GLTF.LINEAR: "bilinear",
           GLTF.NEAREST_MIPMAP_NEAREST: "nearest_mip", GLTF.LINEAR_MIPMAP_NEAREST: "bilinear_mip",
           GLTF.NEAREST_MIPMAP_LINEAR: "nearest_mip_linear", GLTF.LINEAR_MIPMAP_LINEAR: "trilinear"}
MAGNIFICATIONS = {None: "default", GLTF.NEAREST: "nearest", GLTF.LINEAR: "bilinear"}
CHANNELS = {"D": 1, "R": 1, "RG": 2, "GB": 2, "RGB": 3, "RGBA": 4}


def one_of(table):
    """Keys of a table."""
    def check(_, value, name):
        if value not in table:
            raise ValueError(f"{name}: {value!r} is none of {', '.join(map(str, table))}")
        return value
    return check


class Sampler(Shown):
    """Filters and wraps by the constants of GLTF. Without a minFilter, textures are filtered anisotropically."""

    name = Checked(text)
    magFilter = Checked(one_of(MAGNIFICATIONS), "Filter of enlarged texels.")
    minFilter = Checked(one_of(FILTERS), "Filter of reduced texels.")
    wrapS = Checked(one_of(WRAPS), "Wrap of u.")
    wrapT = Checked(one_of(WRAPS), "Wrap of v.")

    def __init__(self, name=None, magFilter=None, minFilter=None, wrapS=GLTF.REPEAT, wrapT=GLTF.REPEAT):
        self.name, self.magFilter, self.minFilter, self.wrapS, self.wrapT = name, magFilter, minFilter, wrapS, wrapT

    def options(self):
        """Options of a sampler of shd."""
        return {"filter": FILTERS[self.minFilter], "magnification": MAGNIFICATIONS[self.magFilter], "max_anisotropy": 8,
                "wrap_u": WRAPS[self.wrapS], "wrap_v": WRAPS[self.wrapT]}


def with_channels(image, channels):
    """An image of uint8 [height][width][n] with the channels of a name: grey is repeated, an absent opacity is 1."""
    array = pixels_of(image, "source")
    if array.dtype.kind not in "fiu" or array.ndim not in (2, 3):
        raise TypeError(f"source: an image [height][width][channels], not {array.dtype} of shape {array.shape}")
    if array.dtype.kind == "f":
        array = np.rint(255 * np.clip(finite(array, "source"), 0, 1))
    array = (array / 257).astype(np.uint8) if array.dtype == np.uint16 else codes(array, "source")
    array = array[..., np.newaxis] if array.ndim == 2 else array
    have = array.shape[2]
    if channels in (None, "D"):
        return array
    count = CHANNELS[channels]
    if channels == "GB" and have > 2:
        return array[..., 1:3]
    if have == 1 and count > 1:
        array = array.repeat(min(count, 3), axis=2)
    elif have == 2 and count > 2:
        raise ValueError(f"source: 2 channels, not {channels}")
    if count == 4 and array.shape[2] == 3:
        array = np.concatenate([array, np.full_like(array[..., :1], 255)], axis=2)
    return array[..., :count]


class Texture(Shown):
    """An image and its sampler. `source_channels` are the channels that are taken from the source, such as "RGB"."""

    name = Checked(text)
    sampler = Checked(lambda self, value, name: instance_of(Sampler, "a Sampler")(self, value, name) or Sampler())
    source = Checked(lambda self, value, name: None if value is None else with_channels(value, self.source_channels),
                     "The image, [height][width][channels] of uint8.")
    source_channels = Checked(one_of({None: 0, **CHANNELS}), "Channels that are taken from a source.")
    width = Checked(anything, "Width of an empty texture.")
    height = Checked(anything, "Height of an empty texture.")

    def __init__(self, name=None, sampler=None, source=None, source_channels=None, width=None, height=None,
                 tex_type=None, data_format=None):
        self.name, self.sampler, self.source_channels, self.source = name, sampler, source_channels, source
        self.width, self.height = width, height
        self.tex_type, self.data_format = tex_type, data_format  # of OpenGL, kept for programs that read them

    def _texts(self):
        size = [] if self.source is None else ["x".join(map(str, (self.source.shape[1], self.source.shape[0])))]
        return [*size, *super()._texts()]

    def is_transparent(self, cutoff=1.0):
        """Whether the opacity of a texel is below a number."""
        has_opacity = self.source is not None and self.source.shape[2] == 4
        return has_opacity and bool((self.source[..., 3] < 255 * cutoff).any())

    def delete(self):
        """Has no effect: the renderer drops its textures with their materials."""
